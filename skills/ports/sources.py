"""Files that people write: how a mistake in one is told. Reading YAML itself is ``skills.yaml_file``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


class DocumentError(ValueError):
    """A file that can't be used. The text names the file, the path in it, the line, and what was expected.

    It is the user's mistake wherever it is found: the command ends with 2 and this text, without a trace.
    """


@dataclass(frozen=True)
class Source:
    """A document's name for its reader, and where its parts are.

    ``lines`` holds the line (from 1) of each value by its dotted path (``items.0.tag``); it is empty for
    what came from no file.
    """

    name: str
    lines: Mapping[str, int] = field(default_factory=dict[str, int])

    def at(self, path: str) -> str:
        """Return "file: path (line N)"; the line is that of the nearest part that stands in the file."""
        if not path:
            return f"{self.name}: (the whole document)"
        line = self._line(path)
        return f"{self.name}: {path}" if line is None else f"{self.name}: {path} (line {line})"

    def _line(self, path: str) -> int | None:
        """Return the line of the deepest part; steps that the file lacks (a union's name) are passed over."""
        here, line = "", self.lines.get("")
        for step in path.split("."):
            deeper = f"{here}.{step}" if here else step
            if deeper in self.lines:
                here, line = deeper, self.lines[deeper]
        return line
