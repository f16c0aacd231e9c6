"""What each role may do on the bus, as data: ``access.yaml`` read into frozen models.

The file ships with the program. ``tandem.executive.security.acl`` makes zenoh's access rules of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Final

from pydantic import TypeAdapter

from tandem.executive.security.role import Part, Role
from tandem.skills.ports.message import Message
from tandem.skills.yaml_file import parse_document

NAME_IN_KEY: Final = "{name}"
_FOR_ALL_CLIENTS: Final = "clients"


class Rights(Message):
    """Key expressions by what may be done there; relative to ``<site>/<robot>``, but for the last two.

    ``tells_site`` and ``hears_site`` are relative to ``<site>``, which all its robots share; ``{robot}`` in
    them is the robot's own name.
    """

    tells: tuple[str, ...] = ()
    hears: tuple[str, ...] = ()
    asks: tuple[str, ...] = ()
    serves: tuple[str, ...] = ()
    announces: tuple[str, ...] = ()
    sees: tuple[str, ...] = ()
    tells_site: tuple[str, ...] = ()
    hears_site: tuple[str, ...] = ()

    def of(self, name: str) -> Rights:
        """Return them with the client's own name where its keys have it."""
        filled = {
            verb: tuple(key.replace(NAME_IN_KEY, name) for key in keys)
            for verb, keys in self.model_dump().items()
        }
        return Rights.model_validate(filled)

    def also(self, more: Rights) -> Rights:
        """Return these and those."""
        mine, others = self.model_dump(), more.model_dump()
        both = {verb: dict.fromkeys((*mine[verb], *others[verb])) for verb in mine}
        return Rights.model_validate({verb: tuple(keys) for verb, keys in both.items()})


@cache
def _table() -> dict[str, Rights]:
    text = files("tandem.executive.security").joinpath("access.yaml").read_text("utf-8")
    return TypeAdapter(dict[str, Rights]).validate_python(parse_document(text, "access.yaml")[0])


def rights_of(role: Role, part: Part | None = None, parts: Mapping[Part, Rights] | None = None) -> Rights:
    """Return what a role may do; a robot's by its part.

    Args:
        role: what the key was made for.
        part: of the robot.
        parts: what the parts that are processes may do, besides what the file says of them.

    Raises:
        KeyError: when the file has no such entry.
    """
    if role == "robot":
        told = [parts[part]] if parts and part is not None and part in parts else []
        own = f"robot.{part}"
        told += [_table()[own]] if own in _table() or not told else []
        return told[0] if len(told) == 1 else told[0].also(told[1])
    return _table()[_FOR_ALL_CLIENTS].also(_table()[role])
