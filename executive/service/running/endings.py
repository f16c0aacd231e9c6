"""How a task ends, and the words for ends that no tree can tell of."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from py_trees.behaviour import Behaviour

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.tasks import NodeStatus, Progress, TaskState, TreeNode
from tandem.trees.snapshot import snapshot


@dataclass(frozen=True)
class Ending:
    """How a task ends, once its goals have."""

    state: TaskState
    failure: Failure | None = None


def raised(root: Behaviour, error: Exception) -> Failure:
    """Return the failure of a tree that raised: a mistake in the program."""
    text = f"the tree raised {type(error).__name__}: {error}; see the executive's log for the traceback"
    return Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=root.name)


def unsaid(root: Behaviour) -> Failure:
    """Return the failure of a tree that failed without a reason, by the node where it did."""
    node = _deepest_failure(snapshot(root))
    said = f": {node.message}" if node.message else ""
    text = f"the tree failed at {node.path} without giving a reason{said}"
    return Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=node.path)


def not_at_rest(
    where: str, skills: Iterable[str], within: float, *, confirmed: bool, before: Failure | None
) -> Failure:
    """Return the failure of goals that did not come to rest. ``within``: robot seconds they had."""
    names = ", ".join(sorted(set(skills))) or "a skill"
    set_ = "was set" if confirmed else "was requested but not confirmed"
    return Failure(
        kind=FailureKind.HARDWARE_STOPPED,
        message=f"{names} did not come to rest within {within:.0f} s; the hardware's stop {set_}",
        where=where,
        evidence={"skill": names, "within_s": within, "stop_confirmed": confirmed},
        causes=() if before is None else (before,),
    )


def hardware_lost(where: str, silent: float, *, before: Failure | None) -> Failure:
    """Return the failure of hardware that has been silent for so many host seconds."""
    return Failure(
        kind=FailureKind.HARDWARE_LOST,
        message=f"the hardware has been silent for {silent:.0f} s; the positions of its parts are unknown",
        where=where,
        evidence={"silent_s": round(silent, 1)},
        causes=() if before is None else (before,),
    )


def abandoned(where: str, skills: Iterable[str], silent: float) -> Failure:
    """Return the failure of a task that was given up before all was at rest. ``silent``: host seconds."""
    names = ", ".join(sorted(set(skills))) or "none"
    return Failure(
        kind=FailureKind.HARDWARE_LOST,
        message=f"abandoned while the hardware did not answer; skills that may still be moving: {names}",
        where=where,
        evidence={"silent_s": round(silent, 1)},
    )


def not_taken_up(where: str, why: str) -> Failure:
    """Return the failure of a task that was under way when the executive ended, and does not go on."""
    text = f"the task was running when the executive ended, and {why}; its progress is unknown"
    return Failure(kind=FailureKind.INTERRUPTED, message=text, where=where)


def crashed_at(where: str, crashes: int, progress: Progress, died: str) -> Failure:
    """Return the failure of a task at which the executive crashed again and again.

    Args:
        where: the kind of task.
        crashes: how often, since the task last came further.
        progress: how far it had come.
        died: the last crash in words; empty when nobody knows.
    """
    last = died or "unknown: the restarted executive was not told how it ended"
    return Failure(
        kind=FailureKind.INTERRUPTED,
        message=f"the executive crashed {crashes} times during this task, without progress in between; "
        "the task is not resumed again",
        where=where,
        evidence={"crashes": crashes, "phase": progress.phase, "fraction": progress.fraction},
        causes=(Failure(kind=FailureKind.INTERRUPTED, message=f"last crash: {last}", where="executive"),),
    )


def no_longer_valid(where: str, problems: Iterable[Problem]) -> Failure:
    """Return the failure of a request that was accepted before a restart and is none any more."""
    words = "; ".join(f"{each.path}: expected {each.expected}" for each in problems)
    text = f"the request was accepted before a restart and is no longer valid: {words}"
    return Failure(kind=FailureKind.INVALID_GOAL, message=text, where=where)


def not_wound_down(where: str, seconds: float) -> Failure:
    """Return the failure of what is done after a cancel and took too long; ``seconds`` of robot time."""
    return Failure(
        kind=FailureKind.TIMED_OUT,
        message=f"the work after the cancel did not end within {seconds:.0f} s",
        where=where,
        evidence={"within_s": seconds},
    )


def kept_from_winding_down(where: str, by: str) -> Failure:
    """Return the failure of what is done after a cancel and could not be: the hardware's stop is set."""
    return Failure(
        kind=FailureKind.HARDWARE_STOPPED,
        message=f"the work after the cancel was skipped: the hardware's stop is set by {by or 'somebody'}",
        where=where,
    )


def _deepest_failure(node: TreeNode) -> TreeNode:
    failed = [child for child in node.children if child.status is NodeStatus.FAILURE]
    return _deepest_failure(failed[-1]) if failed else node
