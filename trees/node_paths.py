"""What finds one node of a tree: its path, names from the root with ``/`` between them, is its alone.

Breakpoints, forced nodes, `--focus` and the history go by paths; goals are called ``task/node/attempt``.
"""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.behaviour import Behaviour

from tandem.trees.behaviours.act import Act

BETWEEN = "/"
"""What stands between the names of a path, and so in none of them."""


class AmbiguousNodesError(TypeError):
    """A tree has two nodes that nothing tells apart; the text says where both are, and what to do."""


def check_paths(root: Behaviour) -> None:
    """Refuse a tree whose nodes can't be told apart.

    Raises:
        AmbiguousNodesError: for a name that is empty or has a ``/``; for two children of one node that have
            the same name; for two nodes of one name that send goals; for a node that stands in two places.
    """
    at: dict[str, Behaviour] = {}
    places: dict[Behaviour, str] = {}
    acts: dict[str, str] = {}
    for path, node in paths(root):
        if not node.name or BETWEEN in node.name:
            raise AmbiguousNodesError(
                f"{_what(path, node)}: expected a name without {BETWEEN!r}, which stands between the names "
                f"of a path; found {node.name!r}"
            )
        if node in places:
            raise AmbiguousNodesError(
                f"one node stands in two places: {places[node]} and {path}; build a node for each"
            )
        if path in at:
            above, _, name = path.rpartition(BETWEEN)
            kinds = f"{type(at[path]).__name__} and {type(node).__name__}"
            where = f"{name!r} below {above}"
            raise AmbiguousNodesError(f"two nodes are called {where} ({kinds}); give each a name of its own")
        if isinstance(node, Act):
            if node.name in acts:
                raise AmbiguousNodesError(
                    f"two nodes that send goals are called {node.name!r}: {acts[node.name]} and {path}; "
                    f"their goals would have one name, TASK/{node.name}/ATTEMPT; give each a name of its own"
                )
            acts[node.name] = path
        at[path], places[node] = node, path


def paths(root: Behaviour, above: str = "") -> Iterator[tuple[str, Behaviour]]:
    """Give each node of a tree after its parent, with its path."""
    left = [(f"{above}{BETWEEN}{root.name}" if above else root.name, root)]
    while left:
        path, node = left.pop()
        yield path, node
        left.extend((f"{path}{BETWEEN}{child.name}", child) for child in reversed(node.children))


def _what(path: str, node: Behaviour) -> str:
    above = path.removesuffix(node.name).removesuffix(BETWEEN)
    return f"a {type(node).__name__} below {above}" if above else f"the root, a {type(node).__name__}"
