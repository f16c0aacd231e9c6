"""The formats in which a tree can be had, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Final

from tandem.executive.render.dot import dot
from tandem.executive.render.svg import svg
from tandem.executive.render.text import ascii_text, unicode_text
from tandem.skills.ports.tasks import TreeNode


def _png(root: TreeNode) -> bytes:
    from tandem.executive.render.png import png  # noqa: PLC0415 - OpenCV takes longer to load than all the rest

    return png(root)


FORMATS: Final[Mapping[str, Callable[[TreeNode], bytes]]] = MappingProxyType(
    {
        "unicode": lambda root: f"{unicode_text(root)}\n".encode(),
        "ascii": lambda root: f"{ascii_text(root)}\n".encode(),
        "dot": lambda root: f"{dot(root)}\n".encode(),
        "svg": lambda root: svg(root).encode(),
        "png": _png,
        "json": lambda root: f"{root.model_dump_json(indent=2)}\n".encode(),
    }
)
BINARY: Final = frozenset({"png"})
"""Formats that are no text."""
