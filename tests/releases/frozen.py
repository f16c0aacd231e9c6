"""What is kept of a release: a data folder, what a client asked and was answered, and the schemas."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from pydantic import BaseModel, JsonValue, TypeAdapter

HERE: Final = Path(__file__).parent
SITE: Final = "frozen"
DATA: Final = "data"
SCHEMAS: Final = "schemas.json"
EXCHANGES: Final = "exchanges.json"
FACTS: Final = "release.json"
_SCHEMAS: Final[TypeAdapter[dict[str, dict[str, JsonValue]]]] = TypeAdapter(dict[str, dict[str, JsonValue]])


class Exchange(BaseModel):
    """One question of the client, as it was sent, and its answer, as it came."""

    key: str
    asked: str
    answer: str
    schema_name: str
    """Of the answer."""


class Facts(BaseModel):
    """What the data folder holds."""

    version: str
    frozen_at: float
    """UTC seconds."""
    ended: dict[str, str]
    """State by task."""
    running: str
    waiting: tuple[str, ...]
    later: str
    """A task whose earliest start is a day after the freeze."""
    by_client: dict[str, str]
    """Task by the id that its client gave."""


_EXCHANGES: Final = TypeAdapter(list[Exchange])


class Release:
    """A kept release.

    Args:
        folder: such as ``v0_1_0``.
    """

    def __init__(self, folder: Path) -> None:
        self.data = folder / DATA
        self.facts = Facts.model_validate_json((folder / FACTS).read_bytes())
        self.exchanges = _EXCHANGES.validate_json((folder / EXCHANGES).read_bytes())
        self.schemas = _SCHEMAS.validate_json((folder / SCHEMAS).read_bytes())


def write(
    folder: Path, facts: Facts, exchanges: list[Exchange], schemas: dict[str, dict[str, JsonValue]]
) -> None:
    """Write what ``Release`` reads, but the data."""
    (folder / FACTS).write_text(facts.model_dump_json(indent=2) + "\n", "utf-8")
    (folder / EXCHANGES).write_bytes(_EXCHANGES.dump_json(exchanges, indent=2) + b"\n")
    (folder / SCHEMAS).write_bytes(_SCHEMAS.dump_json(schemas, indent=1) + b"\n")


def releases() -> list[Path]:
    """Return the folders of all kept releases, oldest first."""
    found = [path for path in HERE.glob("v*_*_*") if path.is_dir()]
    return sorted(found, key=lambda path: [int(part) for part in path.name[1:].split("_")])
