"""Take an ended tree apart, so that it is freed at once and the garbage collector finds nothing of it."""

from __future__ import annotations

from py_trees.behaviour import Behaviour


def dissolve(root: Behaviour) -> None:
    """Undo the links in which the nodes below ``root`` hold each other; nothing may tick or stop them again.

    A node holds its children, they hold it, and each holds a generator of itself: four thousand objects of a
    fetch, which a full collection would have to find some time, while somebody waits.
    """
    left = [root]
    while left:
        node = left.pop()
        left.extend(node.children)
        node.parent, node.iterator = None, iter(())
        node.children = []
