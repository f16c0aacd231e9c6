"""The report of a run."""

from __future__ import annotations

import json
from pathlib import Path

from surroundings import Surroundings

from tandem.executive.trials.run_report import Recorder, Report, write_report
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import TaskState


def recorded(version: int) -> tuple[Surroundings, Recorder]:
    here = Surroundings()
    recorder = Recorder(here.hub.endpoint(), here.clocks)
    recorder.step()
    here.ask({"task": "wait", "item": 29})
    recorder.step()
    here.ask({"task": "wait"})
    here.world(version)
    here.step(3)
    recorder.step()
    return here, recorder


def made(version: int = 1) -> Report:
    _, recorder = recorded(version)
    poses = {29: Pose(position=(1.0, 0.5, 0.74))}
    return recorder.report(scenario="Demo", seed=1, lockstep=True, start=poses, end={})


def test_requests_states_and_transitions_are_kept_with_their_times() -> None:
    report = made()
    assert report.requests[0].request == {"task": "wait", "item": 29}
    assert report.rejections[0].problems[0].path == "item"
    states = list(dict.fromkeys(change.state for change in report.states))
    assert states == [TaskState.QUEUED, TaskState.RUNNING, TaskState.SUCCEEDED]
    changes = [(change.node, change.after.value) for change in report.transitions]
    assert changes == [
        ("wait", "RUNNING"),
        ("wait/wait for the world", "RUNNING"),
        ("wait", "SUCCESS"),
        ("wait/wait for the world", "SUCCESS"),
    ]
    times = [change.at for change in report.transitions]
    assert times == sorted(times)
    assert report.robot_seconds > 0.0


def test_a_failure_is_kept_with_its_chain() -> None:
    (failed,) = made(version=2).failures
    assert [failure.kind.value for failure in failed.chain] == ["GRASP_EMPTY"]


def test_true_poses_stand_at_start_and_end() -> None:
    (item,) = made().items
    assert (item.item, item.end) == (29, None)
    assert item.start is not None


def test_only_this_run_differs_between_two_runs() -> None:
    first, second = (json.loads(made().model_dump_json()) for _ in range(2))
    first.pop("this_run")
    second.pop("this_run")
    assert first == second


def test_it_is_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "new" / "report.json"
    write_report(path, made())
    assert Report.model_validate_json(path.read_bytes()).scenario == "Demo"
    assert [each.name for each in path.parent.iterdir()] == ["report.json"]
