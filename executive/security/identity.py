"""Which files a process or a client shows, and what it is by them."""

from __future__ import annotations

import stat
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.security.holders import AUTHORITY, KeysError, role_in
from tandem.executive.security.rights import Rights, rights_of
from tandem.executive.security.role import PARTS, Part, Role
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.endpoints import host_of

LOOKS_ON: Final[Part] = "supervisor"
"""The part whose certificate a command shows in a robot's name: it may look, and change nothing."""


@dataclass(frozen=True)
class Identity:
    """A folder of keys, and the name in it that is meant."""

    folder: Path
    name: str

    def client(self) -> Credentials:
        """Return a client's files.

        Raises:
            KeysError: naming what is missing, or may be read by others.
        """
        return _files(self.folder, self.stem())

    def stem(self) -> str:
        """Return the name of the files that a client shows; of a robot those of the part that looks on."""
        part = f"{self.name}.{LOOKS_ON}"
        is_robot = not (self.folder / f"{self.name}.pem").exists() and (self.folder / f"{part}.pem").exists()
        return part if is_robot else self.name

    def rights(self) -> Rights:
        """Return what the key allows, by the table that ships with this program; errors as ``role``."""
        role = self.role()
        return rights_of(role, LOOKS_ON if role == "robot" else None).of(self.name)

    def part(self, part: Part) -> Credentials:
        """Return the files of a part of the robot, as ``client`` does."""
        return _files(self.folder, f"{self.name}.{part}")

    def role(self) -> Role:
        """Return the role that the client's certificate tells."""
        from tandem.executive.security.authority import common_name_of  # noqa: PLC0415 - loads a library

        path = self.folder / f"{self.stem()}.pem"
        common = common_name_of(path)
        role = role_in(common)
        if role is None:
            raise KeysError(f"{path}: expected a certificate for tandem.<role>.<name>; found {common!r}")
        return role


def robot_in(folder: Path, name: str = "") -> Identity:
    """Return the robot of a folder: the one named, or the only one.

    Raises:
        KeysError: when there is none, or more than one and none is named.
    """
    there = sorted({file.name.split(".")[0] for part in PARTS for file in folder.glob(f"*.{part}.pem")})
    if name in there:
        return Identity(folder, name)
    if name or len(there) != 1:
        found = ", ".join(there) or "none"
        wanted = f"the robot {name!r}" if name else "one robot, or its name with --as"
        hint = f"`tandem keys new --role robot --folder {folder} {name or 'NAME'}` makes them"
        raise KeysError(f"{folder}: no keys of {wanted}; found {found}; {hint}")
    return Identity(folder, there[0])


def client_in(folder: Path, name: str = "") -> Identity:
    """Return the client of a folder: the one named, or the only one.

    Raises:
        KeysError: when none is named, and there is none or more than one.
    """
    there = sorted(file.stem for file in folder.glob("*.key") if "." not in file.stem)
    clients = [stem for stem in there if stem != AUTHORITY]
    if not name and len(clients) != 1:
        found = ", ".join(clients) or "none"
        raise KeysError(f"{folder}: expected the key of one client, or --as with its name; found {found}")
    return Identity(folder, name or clients[0])


def refuse_other_hosts(identity: Identity, endpoints: Sequence[str]) -> None:
    """Refuse endpoints that the router's certificate is not for: no client would believe it there.

    Raises:
        KeysError: naming the host, and those that the certificate is for.
    """
    from tandem.executive.security.authority import hosts_of  # noqa: PLC0415 - loads a library

    certified = hosts_of(identity.part("router").certificate)
    for endpoint in endpoints:
        host = host_of(endpoint)
        if host not in certified and host not in {"0.0.0.0", "::"}:  # noqa: S104 - compared, not bound
            known = ", ".join(sorted(certified))
            raise KeysError(
                f"the router's certificate of {identity.name!r} is not for {host!r}, only for {known}; "
                f"make one with `tandem keys new --role robot NAME --host {host}`"
            )


def _files(folder: Path, stem: str) -> Credentials:
    authority, certificate, key = (
        folder / f"{AUTHORITY}.pem",
        folder / f"{stem}.pem",
        folder / f"{stem}.key",
    )
    for file in (authority, certificate, key):
        if not file.is_file():
            raise KeysError(f"{file}: no such file; `tandem keys new` makes it, and --keys names its folder")
    if stat.S_IMODE(key.stat().st_mode) & (stat.S_IRWXG | stat.S_IRWXO):
        raise KeysError(f"{key}: others may read it; close it with `chmod 600 {key}`")
    return Credentials(authority, certificate, key)
