"""Why a task failed, in words for an operator: what, where, what was tried, who can help and how."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Hashable, Iterable, Iterator
from types import MappingProxyType
from typing import Final, TypeVar

from tandem.skills.ports.failure import KINDS, Failure, FailureKind, Helper
from tandem.skills.ports.tasks import Attempt, TaskState, TaskStatus

Each = TypeVar("Each")
NEXT: Final = MappingProxyType(
    {
        Helper.CLIENT: "The client: the request can't be met. Correct it and send it again.",
        Helper.AGAIN: "Nothing needs to be done at the robot. Send the request again; if it fails again, "
        "look at the logs (`tandem --log FILE up`).",
        Helper.LOOK: "Things are not where the robot expected. Make sure that the item stands free and its "
        "tag, or what else it is known by, is visible, then send the request again: the robot looks again.",
        Helper.BASE: "The robot lacks room. Clear the floor around it and in front of the item, then "
        "send the request again.",
        Helper.LET_GO: "A hand is full. Take the item out of it, or have it put down, then "
        "send the request again.",
        Helper.OPERATOR: "Someone must go and look. Fix the problem above, then send the request again.",
    }
)
"""What to do, by who can help."""
OPERATORS: Final = MappingProxyType(
    {
        FailureKind.HARDWARE_LOST: (
            "Check the robot's power and its link, restart it, then send the request again."
        ),
        FailureKind.HARDWARE_STOPPED: (
            "Find out why the stop was set and keep everybody out of the robot's reach. "
            "Then run `tandem release` and send the request again."
        ),
        FailureKind.ITEM_NOT_FOUND: (
            "Put the item in view of a search spot, with its tag, or what else it is known by, uncovered. "
            "Then send the request again."
        ),
        FailureKind.ITEM_UNREACHABLE: (
            "Move the item towards the edge and turn a tagged side outwards. Then send the request again."
        ),
        FailureKind.DESTINATION_FULL: "Clear a slot of the depot. Then send the request again.",
        FailureKind.DESTINATION_UNREACHABLE: (
            "Take the item out of the hand and clear the way to the depot. Then send the request again."
        ),
        FailureKind.GRIPPER_STUCK: (
            "Check the gripper: something may be stuck in it, or it has no power. "
            "Then send the request again."
        ),
        FailureKind.INTERRUPTED: (
            "Check the hands and the item. Then send the request again: finished steps are not repeated."
        ),
    }
)
"""What an operator does, by kind, where more can be said."""
PLACES: Final = MappingProxyType({"item_is": "the item is", "robot_is": "the robot is"})
"""Evidence that tells where things are at the end."""
NUMBERS: Final = re.compile(r"-?\d+(\.\d+)?")
"""Two messages that differ in these alone say the same."""


def explain(status: TaskStatus) -> str:
    """Return it all, in lines."""
    lines = [*_head(status)]
    if status.failure is not None:
        lines += ["", "what failed", *_chain((status.failure,), status.tried)]
    lines += ["", "what was tried", *_tried(status.tried)]
    if status.result is not None:
        lines += ["", *result_lines(status)]
    if status.failure is not None:
        lines += ["", "where things are", *_places(status.failure)]
        lines += [
            "",
            f"who can help: {KINDS[status.failure.reason.kind].helper}",
            f"  {what_next(status.failure)}",
        ]
    return "\n".join(lines)


def result_lines(status: TaskStatus) -> tuple[str, ...]:
    """Return what the task found or did, a line for each field; a list has a line for each of its parts."""
    if status.result is None:
        return ()
    lines = ["what it found"]
    for name, value in status.result.items():
        if isinstance(value, list) and value and all(isinstance(each, dict) for each in value):
            lines += [f"  {name}:", *(f"    {json.dumps(each)}" for each in value)]
        else:
            lines.append(f"  {name}: {json.dumps(value)}")
    return tuple(lines)


def what_next(failure: Failure) -> str:
    """Return what to do next."""
    kind = failure.reason.kind
    helper = KINDS[kind].helper
    return OPERATORS.get(kind, NEXT[helper]) if helper is Helper.OPERATOR else NEXT[helper]


def last_picture(status: TaskStatus) -> str:
    """Return the number of the newest picture of what went wrong, or nothing."""
    return next((each.picture for each in reversed(status.tried) if each.picture), "")


def chosen(tasks: tuple[TaskStatus, ...], wanted: str) -> TaskStatus | None:
    """Return the task that is asked for: by its id, or the newest whose request has this ``id``.

    Without one it is the last that ended badly, or else the one that runs.
    """
    if wanted:
        named = [each for each in tasks if wanted in {each.task, each.client_id}]
        return next((each for each in named if each.task == wanted), next(reversed(named), None))
    bad = [each for each in tasks if each.state is TaskState.FAILED or _bad_end(each)]
    runs = [each for each in tasks if not each.state.terminal and each.state is not TaskState.QUEUED]
    return next(reversed(bad or runs), None)


def _bad_end(status: TaskStatus) -> bool:
    return status.state.terminal and status.failure is not None


def _head(status: TaskStatus) -> Iterator[str]:
    took = ""
    seconds = None if status.started is None or status.ended is None else status.ended.since(status.started)
    if seconds is not None:
        took = f" after {seconds:.1f} s of robot time"
    phase = f", in the phase {status.progress.phase!r}" if status.progress.phase else ""
    yield f"{status.task}: {status.state}{took}{phase}, {status.progress.fraction:.0%} done"
    yield f"  request: {json.dumps(status.request)}"
    if status.failure is None:
        yield "  it has not failed" if status.state.terminal else "  it is running and has not failed"


def _alike(failure: Failure) -> Hashable:
    """Return what two failures have in common that differ in numbers alone."""
    below = tuple(_alike(each) for each in failure.causes)
    return failure.kind, failure.where, NUMBERS.sub("#", failure.message), below


def _together(each: Iterable[Each], same: Callable[[Each], Hashable]) -> Iterator[tuple[Each, ...]]:
    """Yield those that are the same together, where the first of them stands."""
    found: dict[Hashable, list[Each]] = {}
    for one in each:
        found.setdefault(same(one), []).append(one)
    yield from (tuple(group) for group in found.values())


def _chain(repeated: tuple[Failure, ...], tried: tuple[Attempt, ...], indent: str = "  ") -> Iterator[str]:
    """Yield a failure and what is below it; one that came several times is said once."""
    failure, times = repeated[0], len(repeated)
    node, _, skill = failure.where.partition(": ")
    way = "".join(f"{part} -> " for part in (node, skill) if part)
    yield f"{indent}{way}{failure.kind}: {failure.message}"
    if times > 1:
        when = _span([each for each in tried if _alike(each.failure) == _alike(failure)])
        yield f"{indent}  {times} times{when and f', {when}'}"
    yield f"{indent}  that is: {KINDS[failure.kind].meaning}"
    if measured := _measured(repeated):
        yield f"{indent}  evidence: {measured}"
    causes = (cause for each in repeated for cause in each.causes)
    for group in _together(causes, _alike):
        yield f"{indent}  after"
        yield from _chain(group, tried, indent + "    ")


def _measured(repeated: tuple[Failure, ...]) -> str:
    """Return the evidence: of numbers that differ from one time to the next, the least and the greatest."""
    names = dict.fromkeys(name for each in repeated for name in each.evidence if name not in PLACES)
    return ", ".join(f"{name} {_values([each.evidence.get(name) for each in repeated])}" for name in names)


def _values(values: Iterable[str | float | bool | None]) -> str:
    known = list(dict.fromkeys(each for each in values if each is not None))
    numbers = [each for each in known if not isinstance(each, str | bool)]
    if len(numbers) == len(known) > 1:
        return f"{min(numbers)} to {max(numbers)}"
    return " | ".join(str(each) for each in known)


def _alike_attempts(attempt: Attempt) -> Hashable:
    """Return what attempts have in common that are said once; times of two boots are no span."""
    return _alike(attempt.failure), attempt.recovery, attempt.at and attempt.at.boot


def _span(attempts: Iterable[Attempt]) -> str:
    """Return the first and the last moment of several attempts."""
    known = [each.at for each in attempts if each.at is not None]
    if not known or known[0] == known[-1] or known[0].boot != known[-1].boot:
        return ""
    return f"the first at {known[0].seconds:.1f} s, the last at {known[-1].seconds:.1f} s"


def _tried(tried: tuple[Attempt, ...]) -> Iterator[str]:
    if not tried:
        yield "  nothing: no recovery applies"
        return
    for group in _together(tried, _alike_attempts):
        attempt, times = group[0], len(group)
        at = "" if attempt.at is None else f"{attempt.at.seconds:8.1f} s  "
        failure, pictures = attempt.failure, [each.picture for each in group if each.picture]
        seen = f"  (picture{'s' * (len(pictures) > 1)} {', '.join(pictures)})" if pictures else ""
        where = f" at {failure.where}" if failure.where else ""
        did = attempt.recovery or "nothing"
        if times > 1:
            when = _span(group)
            did += f", {times} times{when and f': {when}'}"
        elif attempt.recovery:
            did += f", {_nth(attempt.times)} attempt"
        yield f"  {at}{failure.kind}{where}: {failure.message}{seen}"
        yield f"  {' ' * len(at)}-> {did}"
    counts: dict[str, int] = {}
    for attempt in tried:
        if attempt.recovery:
            counts[attempt.recovery] = counts.get(attempt.recovery, 0) + 1
    if counts:
        yield "  in total: " + ", ".join(f"{name} {times} x" for name, times in counts.items())


def _nth(number: int) -> str:
    return {1: "1st", 2: "2nd", 3: "3rd"}.get(number, f"{number}th")


def _places(failure: Failure) -> Iterator[str]:
    known = {name: failure.evidence[name] for name in PLACES if name in failure.evidence}
    for name, value in known.items():
        yield f"  {PLACES[name]} {value}"
    if not known:
        yield "  not reported; see `tandem watch` and world/state for the current beliefs"
