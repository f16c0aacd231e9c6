"""Which part of a tree is drawn, and in how much detail."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches

from tandem.executive.render.outline import HIDES, find, outline, to_depth, whole
from tandem.skills.ports.tasks import TreeNode


class NoSuchNodeError(ValueError):
    """The tree has no node of a name, or several; the message says which there are."""


@dataclass(frozen=True)
class View:
    """What is wanted of a tree.

    Args:
        everything: leave nothing out. Without it and without ``depth`` and ``hide``: as much as fits a page.
        depth: levels below the topmost node; 0 for all.
        hide: what is left out, names of ``tandem.executive.render.outline.HIDES``.
        focus: name or path of the topmost node; empty for the root.
    """

    everything: bool = False
    depth: int | None = None
    hide: Sequence[str] = ()
    focus: str = ""

    def of(self, root: TreeNode) -> TreeNode:
        """Return what is drawn of the tree.

        Raises:
            NoSuchNodeError: when ``focus`` is not the name or path of one node.
        """
        top = focused(root, self.focus) if self.focus else root
        if self.everything or (self.depth == 0 and not self.hide):
            return top
        small = whole(top)
        if self.depth is None and not self.hide:
            return outline(small)
        for name in self.hide:
            small = HIDES[name](small)
        return to_depth(small, self.depth) if self.depth else small


def focused(root: TreeNode, name: str) -> TreeNode:
    """Return the one node of a name or path. Raises NoSuchNodeError."""
    found = find(root, name)
    if len(found) == 1:
        return found[0]
    if found:
        paths = "".join(f"\n  {each.path}" for each in found)
        raise NoSuchNodeError(f"{name!r} is the name of {len(found)} nodes; give the path of one:{paths}")
    every = list(root.walk())
    near = get_close_matches(name, sorted({each.name for each in every}), n=3, cutoff=0.5)
    hint = f"; similar: {', '.join(repr(each) for each in near)}" if near else ""
    raise NoSuchNodeError(f"{root.name} has no node {name!r} among its {len(every)}{hint}")
