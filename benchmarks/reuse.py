"""What EXP2 and EXP3 needed beyond EXP1 (RoCS paper, Q2 and Q3): files that they reach and EXP1 does not.

``python -m benchmarks.reuse`` prints the table of docs/papers/rocs-extending.md. A file counts for an
experiment if one of its roots imports it, directly or through others, anywhere in the file; lines are those
with code.
"""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Final

ROOT: Final = Path(__file__).parents[1]
COMMON: Final = (
    "skills/base/go.py",
    "skills/base/pose_filter.py",
    "skills/base/surround.py",
    "skills/base/reflexes/avoid_collision.py",
    "trees/tasks/go_to.py",
)
"""Of every experiment: how a base goes, where it is, what is near, the reflex, and the tree."""
ROOTS: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "EXP1": (*COMMON, "sim/robots/p3dx.py"),
        "EXP2": (*COMMON, "sim/robots/summit_xl.py"),
        "EXP3": (
            *COMMON,
            "sim/robots/p3dx.py",
            "sim/robots/summit_xl.py",
            "skills/base/follow_robot.py",
            "trees/tasks/patrol.py",
            "trees/tasks/follow.py",
        ),
    }
)
NOT_CODE: Final = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENCODING,
    tokenize.ENDMARKER,
}


def reached(roots: tuple[str, ...]) -> set[str]:
    """Return the files of ours that these import, and they themselves, relative to the checkout."""
    found, waiting = set[str](), list(roots)
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            waiting += _imports(path)
    return found


def lines(path: str) -> int:
    """Return how many lines of a file have code: neither blank, nor comments, nor text that stands alone."""
    text = (ROOT / path).read_text(encoding="utf-8")
    words = {
        line
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type not in NOT_CODE
        for line in range(token.start[0], token.end[0] + 1)
    }
    spoken = {
        line
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)
    }
    return len(words - spoken)


def table() -> str:
    """Return the table, as Markdown."""
    base = reached(ROOTS["EXP1"])
    head = "| experiment | question | files in common with EXP1 | new files | lines of code in them | which |"
    rows = [head, "| --- | --- | --- | --- | --- | --- |"]
    before = base
    for name, question in (("EXP2", "Q2: another robot"), ("EXP3", "Q3: another task")):
        here = reached(ROOTS[name])
        new = sorted(here - before)
        which = ", ".join(f"`{path}` {lines(path)}" for path in new)
        count = sum(lines(path) for path in new)
        rows.append(f"| {name} | {question} | {len(here & base)} | {len(new)} | {count} | {which} |")
        before = before | here
    return "\n".join(rows)


def _imports(path: str) -> Iterator[str]:
    for node in ast.walk(ast.parse((ROOT / path).read_text(encoding="utf-8"))):
        names: list[str] = []
        if isinstance(node, ast.ImportFrom) and node.module:
            names = [node.module, *(f"{node.module}.{each.name}" for each in node.names)]
        elif isinstance(node, ast.Import):
            names = [each.name for each in node.names]
        for name in names:
            file = name.removeprefix("tandem.").replace(".", "/") + ".py"
            if name.startswith("tandem.") and (ROOT / file).is_file():
                yield file


if __name__ == "__main__":
    print(table())
