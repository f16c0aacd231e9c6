"""A tree as lines of text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tandem.executive.render.signs import (
    KIND_SIGNS,
    KIND_SIGNS_ASCII,
    STATUS_SIGNS,
    STATUS_SIGNS_ASCII,
    has_run,
)
from tandem.skills.ports.tasks import NodeStatus, TreeNode


@dataclass(frozen=True)
class Line:
    """One node: what stands before it, itself, and what it says; ``folded`` nodes below are not shown."""

    lead: str
    sign: str
    name: str
    message: str
    status: NodeStatus
    """How it stands, or ended last."""
    past: bool = False
    """Whether its parent has set it back since."""
    folded: int = 0

    def __str__(self) -> str:
        """Return it as text."""
        below = f" (+{self.folded})" if self.folded else ""
        said = f": {self.message}" if self.message else ""
        return f"{self.lead}{self.sign} {self.name}{below}{said}"


def unicode_text(root: TreeNode) -> str:
    """Return the tree drawn with lines and signs."""
    return "\n".join(str(line) for line in lines(root))


def ascii_text(root: TreeNode) -> str:
    """Return the tree in ASCII; a character of a name that is none becomes "?"."""
    text = "\n".join(str(line) for line in lines(root, ascii_only=True))
    return text.encode("ascii", "replace").decode("ascii")


def lines(root: TreeNode, *, ascii_only: bool = False, height: int | None = None) -> list[Line]:
    """Return the tree's lines, from the root down.

    Args:
        root: the tree.
        ascii_only: no other signs.
        height: lines there are; if the tree has more, subtrees without a running node are folded, the
            deepest first.
    """
    with_status = has_run(root)
    depth = _depth(root)
    while True:
        made = list(_walk(root, "", "", ascii_only=ascii_only, with_status=with_status, fold_below=depth))
        if height is None or len(made) <= height or depth <= 1:
            return made if height is None else made[:height]
        depth -= 1


def _walk(
    node: TreeNode, lead: str, below: str, *, ascii_only: bool, with_status: bool, fold_below: int
) -> Iterator[Line]:
    kinds = KIND_SIGNS_ASCII if ascii_only else KIND_SIGNS
    statuses = STATUS_SIGNS_ASCII if ascii_only else STATUS_SIGNS
    tee, corner, bar = ("|- ", "`- ", "|  ") if ascii_only else ("├─ ", "└─ ", "│  ")
    fold = fold_below <= 0 and bool(node.children) and not _runs(node)
    sign = f"{statuses[node.shown]} {kinds[node.kind]}" if with_status else kinds[node.kind]
    past = node.shown is not node.status
    yield Line(lead, sign, node.name, node.message, node.shown, past, _count(node) - 1 if fold else 0)
    if fold:
        return
    for index, child in enumerate(node.children):
        last = index == len(node.children) - 1
        yield from _walk(
            child,
            below + (corner if last else tee),
            below + ("   " if last else bar),
            ascii_only=ascii_only,
            with_status=with_status,
            fold_below=fold_below - 1,
        )


def _runs(node: TreeNode) -> bool:
    return node.status is NodeStatus.RUNNING


def _count(node: TreeNode) -> int:
    return 1 + sum(_count(child) for child in node.children)


def _depth(node: TreeNode) -> int:
    return 1 + max((_depth(child) for child in node.children), default=0)
