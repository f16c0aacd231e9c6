"""Writes the page's types from the messages' JSON Schemas: ``python page/types_of_schemas.py FILE``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, Final

from pydantic.json_schema import models_json_schema

from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.reflex import PipelineState, ReflexState
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    ExecutivePulse,
    TaskKinds,
    TaskStatus,
    Timeline,
    TreeSnapshot,
)
from tandem.skills.ports.world import PlanningScene, WorldState

MODELS: Final = (
    ExecutivePulse, PipelineState, PlanningScene, Problem, ReflexState, RobotDescription, Site, StopState,
    TaskKinds, TaskStatus, Timeline, TreeSnapshot, WorldState,
)  # fmt: skip
PLAIN: Final = {
    "string": "string", "integer": "number", "number": "number", "boolean": "boolean", "null": "null",
}  # fmt: skip


def types() -> str:
    """Return the file."""
    _, schema = models_json_schema([(model, "serialization") for model in MODELS])
    definitions = sorted(schema["$defs"].items())
    head = "// Made of the messages' JSON Schemas by page/types_of_schemas.py; change those instead.\n"
    return head + "\n".join(f"export type {name} = {_type(each)};" for name, each in definitions) + "\n"


def _type(schema: dict[str, Any]) -> str:
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    values = [schema["const"]] if "const" in schema else schema.get("enum")
    if values:
        return " | ".join(_literal(each) for each in values)
    if several := schema.get("anyOf") or schema.get("oneOf"):
        return " | ".join(_type(each) for each in several)
    kind = schema.get("type")
    if kind == "array":
        return _array(schema)
    if kind == "object":
        return _object(schema)
    return PLAIN.get(str(kind), "unknown")


def _array(schema: dict[str, Any]) -> str:
    if "prefixItems" in schema:
        return f"[{', '.join(_type(each) for each in schema['prefixItems'])}]"
    inner = _type(schema.get("items", {}))
    return f"({inner})[]" if " " in inner else f"{inner}[]"


def _object(schema: dict[str, Any]) -> str:
    fields = schema.get("properties")
    if not fields:
        more = schema.get("additionalProperties")
        return f"Record<string, {_type(more) if isinstance(more, dict) else 'unknown'}>"
    return "{ " + "; ".join(f"{name}: {_type(each)}" for name, each in fields.items()) + " }"


def _literal(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value).lower()


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(types(), "utf-8")
