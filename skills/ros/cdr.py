"""ROS messages to bytes and back: CDR, by rosbags. The only module that knows it."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Final, Protocol, cast

from rosbags.typesys import Stores, get_typestore

from tandem.skills.ros.types import Distro

_STORES: Final[Mapping[Distro, Stores]] = {
    "humble": Stores.ROS2_HUMBLE,
    "jazzy": Stores.ROS2_JAZZY,
    "kilted": Stores.ROS2_KILTED,
    "lyrical": Stores.ROS2_LYRICAL,
    "rolling": Stores.ROS2_LYRICAL,
}
"""They differ: a ``Range`` of Humble has no variance."""


class CdrError(ValueError):
    """Bytes that are no message of the type."""


class _Store(Protocol):
    """What is used of a type store of rosbags."""

    types: Mapping[str, Callable[..., object]]

    def serialize_cdr(self, message: object, typename: str) -> bytes: ...

    def deserialize_cdr(self, rawdata: bytes, typename: str) -> object: ...

    def hash_rihs01(self, typename: str) -> str: ...


class Codec:
    """Encodes and decodes the messages of one release.

    A message is an object with the fields of its definition as attributes; arrays of numbers are numpy's.

    Args:
        distro: the release.
    """

    def __init__(self, distro: Distro) -> None:
        self.distro = distro
        self._store = cast("_Store", get_typestore(_STORES[distro]))

    def message(self, name: str, /, **fields: object) -> object:
        """Make a message. Fields that the release does not have are left out, as ``Range.variance``."""
        made = self._store.types[name]
        known = {each.name for each in dataclasses.fields(cast("type", made))}
        return made(**{field: value for field, value in fields.items() if field in known})

    def encode(self, name: str, message: object) -> bytes:
        """Return a message's bytes: little-endian, after the header 00 01 00 00."""
        return bytes(self._store.serialize_cdr(message, name))

    def decode(self, name: str, payload: bytes) -> object:
        """Return the message.

        Raises:
            CdrError: the bytes are no such message.
        """
        try:
            return self._store.deserialize_cdr(payload, name)
        except Exception as error:  # a wrong length ends in struct's, numpy's or rosbags' own errors
            raise CdrError(f"expected a {name}; its {len(payload)} bytes can't be read: {error}") from error

    def hash_of(self, name: str) -> str:
        """Return the hash of a type's definition."""
        return self._store.hash_rihs01(name)
