"""The keys, liveliness tokens and attachments of rmw_zenoh (its page design.md).

A topic's data is put on ``<domain>/<topic>/<type>/<hash>`` with an attachment. A node and each of its
publishers and subscriptions show a liveliness token below ``@ros2_lv``, from which ROS makes its graph.
"""

from __future__ import annotations

import hashlib
import struct
from dataclasses import dataclass
from typing import Final, Literal

from tandem.skills.ros.types import dds_name

SPACE: Final = "@ros2_lv"
ENCLAVE: Final = "%"
"""No enclave, as nodes without SROS have it."""
QOS_RELIABLE: Final = "::,10:,:,:,,"
"""Reliable, volatile, the last 10: all of it the default."""
QOS_BEST_EFFORT: Final = "2::,10:,:,:,,"
GID: Final = 16
"""Bytes of a publisher's global id."""
_ATTACHMENT: Final = struct.Struct(f"<qqB{GID}s")
_FIELDS: Final = 12
"""Parts of an endpoint's token that are read; later releases append more."""

EndKind = Literal["MP", "MS"]
"""A message publisher, or a message subscription."""


@dataclass(frozen=True)
class NodeName:
    """A node of one zenoh session."""

    domain: int
    session: str
    """The session's zenoh id, in hexadecimal."""
    number: int
    """Its id within the session."""
    name: str
    namespace: str = "/"

    @property
    def token(self) -> str:
        """Its liveliness token."""
        return "/".join(
            (
                *(SPACE, str(self.domain), self.session, str(self.number), str(self.number), "NN"),
                *(ENCLAVE, mangled(self.namespace), mangled(self.name)),
            )
        )


def mangled(name: str) -> str:
    """Return a name as one part of a token: a slash is ``%``, and so is nothing at all."""
    return name.replace("/", "%") or "%"


def data_key(domain: int, topic: str, type_name: str, type_hash: str) -> str:
    """Return the key of a topic's data; ``type_hash`` may be ``*``."""
    return f"{domain}/{topic.strip('/')}/{dds_name(type_name)}/{type_hash}"


@dataclass(frozen=True)
class EndName:
    """A publisher or a subscription of a node of ours."""

    node: NodeName
    number: int
    """Its id within the session."""
    kind: EndKind
    topic: str
    type_name: str
    type_hash: str
    qos: str

    @property
    def token(self) -> str:
        """Its liveliness token."""
        node = self.node
        return "/".join(
            (
                *(SPACE, str(node.domain), node.session, str(node.number), str(self.number), self.kind),
                *(ENCLAVE, mangled(node.namespace), mangled(node.name)),
                *(mangled(self.topic), dds_name(self.type_name), self.type_hash, self.qos),
            )
        )


@dataclass(frozen=True)
class RosEnd:
    """A publisher or subscription of anybody's, as its token tells it."""

    kind: str
    """``MP`` or ``MS``; services have others."""
    node: str
    topic: str
    dds_type: str
    type_hash: str


def read_end(token: str) -> RosEnd | None:
    """Return what an endpoint's token says; None for a node's, and for one that can't be read.

    It is read from the left, and what follows the known fields is passed over: later releases append some.
    """
    parts = token.split("/")
    if len(parts) < _FIELDS or parts[0] != SPACE:
        return None
    *_, kind, _enclave, namespace, name, topic, dds_type, type_hash = parts[:_FIELDS]
    here = "" if namespace == "%" else namespace.replace("%", "/")
    return RosEnd(kind, f"{here}/{name}", topic.replace("%", "/"), dds_type, type_hash)


def gid_of(token: str) -> bytes:
    """Return a global id for the publisher of this token: the same for the same token."""
    return hashlib.blake2b(token.encode(), digest_size=GID).digest()


def attachment(sequence: int, nanoseconds: int, gid: bytes) -> bytes:
    """Return the 33 bytes that go with each message; rmw_zenoh drops one without them.

    Args:
        sequence: counts the publisher's messages, from 1.
        nanoseconds: when it was sent, in ROS time.
        gid: of the publisher, ``GID`` bytes.
    """
    return _ATTACHMENT.pack(sequence, nanoseconds, GID, gid)
