"""From the nodes of a tree that worked to the phases of the order-picking paper."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.picking.settings import Phase, Point, Stretch
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import NodeStatus, Span

RECOVERING: Final = ("request: ", "get: ", "place: ", "leave: ", "deliver: ")
"""What the names of a recovery's steps begin with (``trees/subtrees``)."""
PARTS: Final = MappingProxyType(
    {
        "search": Phase.SEARCH,
        "get near item": Phase.APPROACH,
        "get near slot": Phase.CARRY,
        "pick": Phase.PICK,
        "place": Phase.PLACE,
        "home": Phase.HOME,
        "request": Phase.REQUEST,
    }
)
"""The phase of what is below a node, by its name; the first that a path has counts."""
STEPS: Final = MappingProxyType(
    {
        "pre-grasp": "III-D.1 a",
        "open": "III-D.1 b",
        "grasp": "III-D.1 c",
        "close": "III-D.1 d",
        "retract": "III-D.1 e",
        "place above": "III-D.2 a",
        "put down": "III-D.2 a",
        "let go": "III-D.2 b",
        "withdraw": "III-D.2 c",
        "close empty": "III-D.2 d",
    }
)
"""The leaves that are steps of the arm and hand in the paper, and where it tells them."""


def phase_of(path: str) -> Phase:
    """Return the phase of a node of the fetch's tree, by its path."""
    names = path.split("/")
    if any(name.startswith(RECOVERING) for name in names):
        return Phase.RECOVERY
    return next((phase for name, phase in PARTS.items() if name in names), Phase.REQUEST)


def stretches(spans: Iterable[Span], since: RobotTime) -> tuple[Stretch, ...]:
    """Return the work of a task's tree by its begin, in seconds after ``since``; of its boot only."""
    found = [
        Stretch(
            node=span.path.rpartition("/")[2],
            phase=phase_of(span.path),
            begin=round(begin, 3),
            end=round(end, 3),
            ended_well=span.status is NodeStatus.SUCCESS,
        )
        for span in spans
        if span.kind == "action"
        and span.end is not None
        and (begin := span.begin.since(since)) is not None
        and (end := span.end.since(since)) is not None
    ]
    return tuple(sorted(found, key=lambda each: (each.begin, each.end)))


def seconds(work: Sequence[Stretch], lasted: float) -> dict[Phase, float]:
    """Return the seconds of each phase: it lasts until work of another one begins.

    Args:
        work: by its begin.
        lasted: seconds from the request to its end.
    """
    told = dict.fromkeys(Phase, 0.0)
    marks = [(0.0, Phase.REQUEST), *((each.begin, each.phase) for each in work), (lasted, Phase.HOME)]
    for (begin, phase), (end, _) in pairwise(marks):
        told[phase] += max(0.0, min(end, lasted) - begin)
    return {phase: round(value, 2) for phase, value in told.items()}


def is_turn(work: Stretch) -> bool:
    """Say whether it is a turn of the search (``trees/subtrees/search.py``)."""
    return work.node.startswith("turn 30 degrees")


def point_at(path: Sequence[Point], at: float) -> Point:
    """Return where the robot was at a time, to the path's resolution."""
    return min(path, key=lambda point: abs(point.at - at))
