"""Kill the executive at each point between a verb and its effect, and see whether the verb still holds.

Each case brings a task to where the verb is taken, asks for it, and says what must be so afterwards. A dry
run counts the points that the executive passes from the moment in which it reads the verb; then it is killed
at each of them, or at as many as asked for.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from tandem.executive.trials.campaigns.crash import TRIES, CrashRun, Reaper, never_reached
from tandem.executive.trials.campaigns.crash_rig import CrashRig, StuckError
from tandem.executive.trials.campaigns.crash_world import deeds, wrong_deeds
from tandem.executive.trials.campaigns.verb_cases import CASES, Case
from tandem.executive.trials.campaigns.verb_scene import ENDS, Scene
from tandem.skills.ports.tasks import TASK_CANCEL, CancelTask, TaskStatus

MOST: Final = 12
"""Places of a verb at which the executive is killed, unless told otherwise."""
BEYOND: Final = 6
"""Points after the answer that belong to a verb whose effect comes at once: one step of the executive."""
REACHED: Final = 0.8
"""Share of the points of a dry run at which others are killed."""
NEVER: Final = 1_000_000
"""Points: more than any run passes."""


def verb_runs(
    folder: Path, endpoint: str, most: int = MOST, verbs: tuple[str, ...] = ()
) -> Iterator[CrashRun]:
    """Yield, for each verb (or those named), a run without a kill and one for each place of a kill.

    Args:
        folder: of ledger, truth and deeds.
        endpoint: where the router listens.
        most: places of a verb at the most, spread over all that there are.
        verbs: their names.
    """
    number = 0
    with CrashRig(folder, endpoint) as rig:
        for case in CASES:
            if verbs and case.verb not in verbs:
                continue
            dry, count = _dry_run(rig, case, number)
            yield dry
            for place in spread(count, most):
                number += 1
                yield verb_run(rig, case, number, place)
            number += 1


def verb_run(rig: CrashRig, case: Case, run: int, place: int, *, tries: int = TRIES) -> CrashRun:
    """Return the first run in which the executive was killed at its place, or the last one of those tried.

    Args:
        rig: the processes.
        case: the verb.
        run: its number.
        place: points after the one at which the executive reads the verb.
        tries: runs at the most.
    """
    point = f"{case.at} +{place}"
    made = CrashRun(run=run, point=point)
    for number in range(tries):
        rig.kill("executive")
        rig.start("executive", crash_at=point)
        made = _one(rig, case, run, point=f"{point}, {case.verb}", name=f"{case.verb}-{run}-{number}")[0]
        if made.kills or made.wrong:
            return made
    return made.model_copy(update={"wrong": (never_reached(point),)})


def _dry_run(rig: CrashRig, case: Case, run: int) -> tuple[CrashRun, int]:
    log = rig.folder / f"{case.verb}.points"
    rig.kill("executive")
    rig.start("executive", crash_at=f"{case.at} +{NEVER}", crash_log=log)
    made, at_answer = _one(
        rig, case, run, point=f"{case.verb}: not killed", name=f"{case.verb}-{run}-dry", log=log
    )
    count = _lines(log) if case.whole else min(_lines(log), at_answer + BEYOND)
    return made, count


def _lines(log: Path) -> int:
    return len(log.read_text("utf-8").splitlines()) if log.exists() else 0


def spread(count: int, most: int) -> tuple[int, ...]:
    """Return places from 0 up to most of ``count``: the last ones depend on what is heard when."""
    last = max(1, round(REACHED * count))
    many = min(most, last)
    return tuple(dict.fromkeys(round(number * last / many) for number in range(many)))


def _one(
    rig: CrashRig, case: Case, run: int, *, point: str, name: str, log: Path | None = None
) -> tuple[CrashRun, int]:
    rig.reset()
    before, began = len(deeds(rig.folder)), rig.now()
    at = Scene(rig, Reaper(rig, [], began), name.replace(" ", "_"))
    at_answer = 0
    try:
        case.before(at)
        case.act(at)
        at_answer = 0 if log is None else _lines(log)
        case.after(at)
    except StuckError as stuck:
        at.wrong.append(str(stuck))
    found = _end_all(at)
    ends = {status.task: status.ended_at for status in found}
    made = CrashRun(
        run=run,
        point=point,
        kills=tuple(at.reaper.done),
        states=tuple(str(each.state) for each in found),
        begun=max((each.begun for each in found), default=0),
        seconds=round(rig.now() - began, 2),
        wrong=(*at.wrong, *wrong_deeds(deeds(rig.folder)[before:], ends.get), *at.reaper.wrong),
    )
    return made, at_answer


def _end_all(at: Scene) -> tuple[TaskStatus, ...]:
    """Leave nothing to the next run; return how all tasks ended."""
    found: list[TaskStatus] = []
    for task in at.tasks:
        try:
            if at.rig.exit_code("mock") is not None:
                at.rig.start("mock")
            if not at.status(task).state.terminal:
                at.say(TASK_CANCEL, CancelTask(task=task))
            found.append(at.until(task, *ENDS))
        except StuckError as stuck:
            at.wrong.append(str(stuck))
    return tuple(found)
