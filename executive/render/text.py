"""A tree as lines of text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tandem.executive.render.folded import FoldedNode, note_of
from tandem.executive.render.outline import levels_of, to_depth, whole, without_guards, without_recoveries
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
    """One node: what stands before it, itself, and what it says; ``note`` says what is not shown of it."""

    lead: str
    sign: str
    name: str
    message: str
    status: NodeStatus
    """How it stands, or ended last."""
    past: bool = False
    """Whether its parent has set it back since."""
    note: str = ""

    def __str__(self) -> str:
        """Return it as text."""
        below = f" ({self.note})" if self.note else ""
        said = f": {self.message}" if self.message else ""
        return f"{self.lead}{self.sign} {self.name}{below}{said}"


def unicode_text(root: TreeNode) -> str:
    """Return the tree drawn with lines and signs."""
    return "\n".join(str(line) for line in lines(root))


def ascii_text(root: TreeNode) -> str:
    """Return the tree in ASCII; a character of a name that is none becomes "?"."""
    text = "\n".join(str(line) for line in lines(root, ascii_only=True))
    return text.encode("ascii", "replace").decode("ascii")


def lines(root: TreeNode, *, ascii_only: bool = False) -> list[Line]:
    """Return the tree's lines, from the root down; without statuses while none has been ticked."""
    return list(_walk(root, "", "", ascii_only=ascii_only, with_status=has_run(root)))


def lines_within(root: TreeNode, height: int) -> list[Line]:
    """Return at most ``height`` lines of the tree, with what runs innermost among them.

    What does not run is folded as far as needed: recoveries, then guards, then subtrees, the deepest first.
    What is still too high is cut to the lines around the innermost node that runs.
    """
    made: list[Line] = []
    for smaller in _smaller(whole(root)):
        made = lines(smaller)
        if len(made) <= height:
            return made
    runs = max((at for at, line in enumerate(made) if line.status is NodeStatus.RUNNING), default=0)
    first = min(max(0, runs - height // 2), len(made) - height)
    return made[first : first + height]


def _smaller(root: FoldedNode) -> Iterator[FoldedNode]:
    yield root
    yield (fewer := without_recoveries(root))
    yield (small := without_guards(fewer))
    yield from (to_depth(small, depth) for depth in range(levels_of(small), -1, -1))


def _walk(node: TreeNode, lead: str, below: str, *, ascii_only: bool, with_status: bool) -> Iterator[Line]:
    kinds = KIND_SIGNS_ASCII if ascii_only else KIND_SIGNS
    statuses = STATUS_SIGNS_ASCII if ascii_only else STATUS_SIGNS
    tee, corner, bar = ("|- ", "`- ", "|  ") if ascii_only else ("├─ ", "└─ ", "│  ")
    sign = f"{statuses[node.shown]} {kinds[node.kind]}" if with_status else kinds[node.kind]
    past = node.shown is not node.status
    yield Line(lead, sign, node.name, node.message, node.shown, past, note_of(node))
    for index, child in enumerate(node.children):
        last = index == len(node.children) - 1
        yield from _walk(
            child,
            below + (corner if last else tee),
            below + ("   " if last else bar),
            ascii_only=ascii_only,
            with_status=with_status,
        )
