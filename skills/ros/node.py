"""A ROS node of ours: it publishes and subscribes, and shows both to ROS's graph."""

from __future__ import annotations

import itertools
import logging
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Final, TypeVar

from pydantic import ValidationError

from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.ports.problems import in_words, problems_of
from tandem.skills.ros.cdr import CdrError, Codec
from tandem.skills.ros.link import Link, RosInbox
from tandem.skills.ros.naming import (
    QOS_BEST_EFFORT,
    QOS_RELIABLE,
    SPACE,
    EndKind,
    EndName,
    NodeName,
    RosEnd,
    attachment,
    data_key,
    gid_of,
    read_end,
)
from tandem.skills.ros.readings import UnfitError
from tandem.skills.ros.types import HASHES, IMAGE, UNHASHED, dds_name, hash_of

DEPTH: Final = 128
"""Messages of a topic that wait to be read: several sensors may share one, and fire together."""
PICTURES: Final = 2
"""Likewise pictures, which are large: only the newest is shown."""
REASONS: Final = 20
"""Different reasons for which messages of one topic are refused that the log gets."""
log = logging.getLogger(__name__)
T = TypeVar("T")


@dataclass(eq=False)
class RosPublisher:
    """Publishes messages of one type on one topic."""

    type_name: str
    codec: Codec
    put: Callable[[bytes, bytes], None]
    gid: bytes
    _sequence: itertools.count[int] = field(default_factory=lambda: itertools.count(1))

    def publish(self, message: object, nanoseconds: int) -> None:
        """Send a message; ``nanoseconds`` is when, in ROS time."""
        payload = self.codec.encode(self.type_name, message)
        self.put(payload, attachment(next(self._sequence), nanoseconds, self.gid))


@dataclass(eq=False)
class RosSubscription:
    """Receives messages of one type on one topic, of whoever has the same definition of the type."""

    topic: str
    type_name: str
    codec: Codec
    inbox: RosInbox
    ear: Ear
    """Counts, under the topic's name, which no key of ours is like: ours begin with no slash."""
    _said: set[str] = field(default_factory=set)

    def take(self) -> list[object]:
        """Return what has come since the last call, oldest first; what can't be read is refused."""
        taken: list[object] = []
        for sample in self.inbox.drain():
            told = sample.key.rpartition("/")[2]
            if told not in {HASHES[self.type_name], UNHASHED}:
                expected = f"expected the hash {HASHES[self.type_name]}, found {told}: another definition"
                self.refuse(expected, Reason.MISFIT)
                continue
            try:
                taken.append(self.codec.decode(self.type_name, sample.payload))
            except CdrError as error:
                self.refuse(str(error))
        return taken

    def each(self, use: Callable[[object], T | None]) -> list[T]:
        """Return what ``use`` makes of each message that has come; one that it can't use is refused."""
        made = (self.tried(partial(use, message)) for message in self.take())
        return [one for one in made if one is not None]

    def tried(self, make: Callable[[], T | None]) -> T | None:
        """Return what is made of a message, or None where that raises: it costs the message, no process."""
        try:
            return make()
        except UnfitError as error:
            self.refuse(str(error), Reason.MISFIT)
        except ValidationError as error:  # our own models look at each number that they get
            self.refuse(in_words(problems_of(error, most=1)))
        except Exception as error:  # noqa: BLE001 - whatever a stranger found
            self.refuse(f"it raised {type(error).__name__}: {error}")
        return None

    def refuse(self, why: str, reason: Reason = Reason.MALFORMED) -> None:
        """Count a message that is of no use, and say why, once for each reason."""
        self.ear.count(self.topic, reason)
        if why not in self._said and len(self._said) < REASONS:
            self._said.add(why)
            log.warning("topic %s (%s): %s", self.topic, self.type_name, why)


class RosNode:
    """A node in one domain.

    Args:
        link: the session.
        ear: of the process; counts what is refused.
        domain: ``ROS_DOMAIN_ID``.
        name: the node's.
        codec: of the release.
    """

    def __init__(self, link: Link, ear: Ear, domain: int, name: str, codec: Codec) -> None:
        self._link, self._codec, self._ear, self._distro = link, codec, ear, codec.distro
        self._numbers = itertools.count(1)
        self._node = NodeName(domain, link.zid, 0, name)
        link.show(self._node.token)
        self._others = link.watch(f"{SPACE}/{domain}/**")

    def publisher(self, topic: str, type_name: str) -> RosPublisher:
        """Return a publisher, and show it."""
        told = hash_of(type_name, self._distro)
        token = self._token("MP", topic, type_name, QOS_RELIABLE)
        put = self._link.putter(data_key(self._node.domain, topic, type_name, told))
        return RosPublisher(type_name, self._codec, put, gid_of(token))

    def subscription(self, topic: str, type_name: str) -> RosSubscription:
        """Return a subscription, and show it. Any hash is heard, so that a wrong one can be told."""
        self._token("MS", topic, type_name, QOS_BEST_EFFORT)
        depth = PICTURES if type_name == IMAGE else DEPTH
        inbox = self._link.hear(data_key(self._node.domain, topic, type_name, "*"), depth)
        return RosSubscription(topic, type_name, self._codec, inbox, self._ear)

    def others(self) -> tuple[RosEnd, ...]:
        """Return the publishers and subscriptions of other sessions that show themselves now."""
        own = f"{SPACE}/{self._node.domain}/{self._node.session}/"
        found = (read_end(token) for token in tuple(self._others) if not token.startswith(own))
        return tuple(each for each in found if each is not None)

    def lacks(self, topic: str, type_name: str) -> str:
        """Return what keeps a topic from being heard: nobody publishes it, or another type; else nothing."""
        types = {each.dds_type for each in self.others() if each.kind == "MP" and each.topic == topic}
        if not types:
            return "no node publishes it"
        if dds_name(type_name) not in types:
            return f"expected {dds_name(type_name)}; it is published as {', '.join(sorted(types))}"
        return ""

    def _token(self, kind: EndKind, topic: str, type_name: str, qos: str) -> str:
        told = hash_of(type_name, self._distro)
        shown = EndName(self._node, next(self._numbers), kind, topic, type_name, told, qos).token
        self._link.show(shown)
        return shown
