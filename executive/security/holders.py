"""Who has been given a key: the list in a folder of keys, and how the folder is laid out.

``ca.pem`` and ``issued.json`` are public; ``*.key`` are not. A client needs ``ca.pem`` and its own two files.
The host of the router needs ``issued.json`` too: from it the access rules are made.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Final

from pydantic import ValidationError

from tandem.executive.security.role import ROLES, Part, Role
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import in_words, problems_of

NAME: Final = re.compile(r"[a-z0-9][a-z0-9_-]{0,31}")
"""A name is one part of a key and of a certificate's common name."""
AUTHORITY: Final = "ca"
LIST: Final = "issued.json"


class KeysError(ValueError):
    """A folder of keys is not as it must be; the message says which file, and what to do."""


class Holder(Message):
    """Somebody who has been given a key."""

    name: str
    role: Role
    part: Part | None = None
    serial: str
    """Of the certificate, in hexadecimal digits."""
    expires_at: float
    """UTC seconds."""
    revoked: bool = False

    @property
    def stem(self) -> str:
        """The name of its files, without their ends."""
        return self.name if self.part is None else f"{self.name}.{self.part}"

    @property
    def common_name(self) -> str:
        """The certificate's."""
        return common_name(self.role, self.name, self.part)


class Holders(Message):
    """All who have ever been given a key by this authority."""

    holders: tuple[Holder, ...] = ()

    def named(self, name: str) -> tuple[Holder, ...]:
        """Return the entries of a name: one, or one for each part of a robot."""
        return tuple(holder for holder in self.holders if holder.name == name)


def common_name(role: Role, name: str, part: Part | None = None) -> str:
    """Return a certificate's common name: tandem.<role>.<name>, for a robot with its part behind."""
    return f"tandem.{role}.{name}" if part is None else f"tandem.{role}.{name}.{part}"


def role_in(common: str) -> Role | None:
    """Return the role that a common name tells, or None when it is none of ours."""
    parts = common.split(".")
    if len(parts) < 3 or parts[0] != "tandem":  # noqa: PLR2004 - tandem, role, name
        return None
    return next((role for role in ROLES if role == parts[1]), None)


def read_holders(folder: Path) -> Holders:
    """Return who has been given a key.

    Raises:
        KeysError: when there is no such list, or it can't be read.
    """
    path = folder / LIST
    try:
        return Holders.model_validate_json(path.read_bytes())
    except FileNotFoundError:
        raise KeysError(
            f"{path}: no such file; make the folder with `tandem keys init --folder {folder}`"
        ) from None
    except ValidationError as error:
        raise KeysError(f"{path}: not a list of keys: {in_words(problems_of(error, most=1))}") from error


def write_holders(folder: Path, holders: Holders) -> None:
    """Replace the list, whole or not at all."""
    fresh = folder / f"{LIST}.new"
    with fresh.open("w", encoding="utf-8") as file:
        file.write(holders.model_dump_json(indent=1) + "\n")
        file.flush()
        os.fsync(file.fileno())
    fresh.replace(folder / LIST)
