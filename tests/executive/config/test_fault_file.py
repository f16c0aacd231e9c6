"""The file of --faults: read, checked, and taken to where it matters."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.cli.main import main
from tandem.executive.config.fault_file import check_faults, load_faults
from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.lockstep import Digest, Lockstep
from tandem.executive.system.process_system import ProcessSystem
from tandem.sim.faults import CameraDark, HandOpens, HardwareSilent, ItemLifted
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.keys import BUMPERS, Latest
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.tasks import REQUEST
from tandem.skills.site import load
from tandem.skills.testing.faulty_bus import BusFaults
from tests.fakes.ports import free_endpoint

ROBOTS = {"robot": "tiago_dual"}
EXAMPLES = sorted((Path(__file__).parents[3] / "examples" / "faults").glob("*.yaml"))
GOOD = "faults: [{kind: camera_dark, at: 1}]\nbus: {drop: 0.1}\n"


def written(folder: Path, text: str) -> Path:
    file = folder / "mine.yaml"
    file.write_text(text)
    return file


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_each_example_is_right(path: Path) -> None:
    assert check_faults(path, load("lab"), ROBOTS).faults


@pytest.mark.parametrize("said", ["item: 29", "item: tea", "tag: 29"])
def test_what_a_file_says_is_what_is_read(said: str, tmp_path: Path) -> None:
    text = f"faults: [{{kind: hand_opens, side: left, when: {{event: item_lifted, {said}, nth: 2}}}}]"
    file = load_faults(written(tmp_path, text), load("lab"))
    assert file.faults == (HandOpens(side="left", when=ItemLifted(item=29, nth=2)),)
    assert file.bus is None


@pytest.mark.parametrize(
    ("text", "path", "said"),
    [
        ("faults: [", "", "not YAML"),
        ("- 1", "", "a mapping with faults"),
        ("fault: []", "fault", "no such field"),
        ("faults: [{kind: camera_blue}]", "faults.0", "camera_dark"),
        ("faults: [{at: 1}]", "faults.0", "kind"),
        ("faults: [{kind: camera_dark, lasts: 0}]", "faults.0.camera_dark.lasts", "greater than 0"),
        ("faults: [{kind: item_gone, item: 3, lasts: 1}]", "faults.0.item_gone.lasts", "no such field"),
        ("faults: [{kind: stop, at: 1, when: {event: base_moving}}]", "faults.0.stop", "either at or when"),
        ("faults: [{kind: stop, when: {event: dawn}}]", "faults.0.stop.when", "base_moving"),
        ("faults: [{kind: item_moves, dx: 1}]", "faults.0.item_moves", "an item's name or number"),
        ("faults: [{kind: obstacle_appears}]", "faults.0.obstacle_appears", "either x and y, or ahead"),
        ("faults: [{kind: depot_taken, slot: 99}]", "faults.0.slot", "0 to 6"),
        ("faults: [{kind: depot_taken, item: 3, lasts: 1}]", "faults.0.depot_taken", "lasts is for a parcel"),
        ("faults: [{kind: item_gone, item: 500}]", "faults.0.item", "one of 3"),
        ("faults: [{kind: item_gone, item: cocoa}]", "faults.0.item_gone.item", "one of the site's items: 3"),
        ("faults: [{kind: item_gone, item: tea, tag: 29}]", "faults.0.item_gone.tag", "no such field"),
        ("faults: [{kind: joint_stall, group: leg}]", "faults.0.group", "one of arm_left"),
        ("faults: [{kind: bumper, bumper: front_left}]", "faults.0.bumper", "one of front, left"),
        ("faults: [{kind: range_stuck}]", "faults.0.kind", "a robot with range sensors or cliff sensors"),
        ("bus: {drop: 2}", "bus.drop", "less than or equal to 1"),
    ],
)
def test_a_mistake_is_told_with_file_and_path(tmp_path: Path, text: str, path: str, said: str) -> None:
    file = written(tmp_path, text)
    with pytest.raises(DocumentError) as caught:
        check_faults(file, load("lab"), ROBOTS)
    assert str(caught.value).startswith(f"{file}: {path}")
    assert said in str(caught.value)


def test_the_command_checks_a_file(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, GOOD)
    assert main(["scenario", "check", "Demo", "--faults", str(file)]) == 0
    assert "1 of robot and room, a faulty bus" in capfd.readouterr().out


@pytest.mark.parametrize("command", ["up", "demo"])
def test_a_wrong_file_starts_nothing(command: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, "faults: [{kind: camera_blue}]")
    assert main([command, "--faults", str(file)]) == 2
    assert f"{file}: faults.0" in capfd.readouterr().err


@pytest.mark.parametrize("command", ["up", "demo"])
def test_the_option_reaches_who_runs_it(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, asked = written(tmp_path, GOOD), list[RunOptions]()

    def run(options: RunOptions, *_: object) -> int:
        asked.append(options)
        return 0

    monkeypatch.setattr(f"tandem.executive.cli.running_system.run_{command}", run)
    assert main([command, "--faults", str(file)]) == 0
    assert [options.faults for options in asked] == [file]


def test_each_process_is_told_of_the_file(tmp_path: Path) -> None:
    file = written(tmp_path, GOOD)
    system = ProcessSystem(RunOptions(bus=BusOptions(), faults=file))
    (crew,) = system._crews
    assert [system._settings.of(crew, role).faults for role in ("hardware", "base")] == [str(file)] * 2
    system.close()


def test_faults_of_a_file_come_after_the_scenarios() -> None:
    scenario = load_scenario("Defaults").with_faults((HandOpens(),)).with_faults((CameraDark(),))
    assert scenario.faults == (HandOpens(), CameraDark())


def digest_of_a_start(faults: BusFaults | None) -> str:
    digest = Digest()
    lockstep = Lockstep(load_scenario("Defaults"), 1, bus_faults=faults)
    lockstep.hub.watch(digest)
    lockstep.bus.query(REQUEST, b'{"task": "fetch", "item": 29, "id": "x"}')
    lockstep.run_until(lambda: False, within=2.0)
    lockstep.close()
    return digest.hexdigest()


@pytest.mark.lockstep
def test_bus_faults_repeat_in_lockstep() -> None:
    faults = BusFaults(delay=0.2, drop=0.2, double=0.2, reorder=0.2)
    first = digest_of_a_start(faults)
    assert first == digest_of_a_start(faults)
    assert first != digest_of_a_start(None)


@pytest.mark.lockstep
def test_while_the_hardware_is_silent_its_clock_stands() -> None:
    scenario = load_scenario("Defaults").with_faults((HardwareSilent(at=0.2, lasts=0.3),))
    lockstep = Lockstep(scenario, 1)
    seen = []
    for _ in range(60):
        lockstep.step()
        now = lockstep.clocks.robot()
        assert now is not None
        seen.append(now.seconds)
    lockstep.close()
    assert seen[25] == seen[45] == pytest.approx(0.2, abs=0.02)
    assert seen[-1] == pytest.approx(0.6)


@pytest.mark.processes
def test_over_zenoh_the_file_reaches_the_hardware_and_it_speaks_again_after_a_silence(tmp_path: Path) -> None:
    text = "faults: [{kind: hardware_silent, lasts: 1.0}, {kind: bumper, at: 2.0}]\nbus: {double: 1.0}\n"
    options = RunOptions(bus=BusOptions(endpoint=free_endpoint()), speed=None, faults=written(tmp_path, text))
    with ProcessSystem(options, roles=("router", "hardware", "keeper")) as system:
        bumpers = Latest(system.bus, BUMPERS)
        deadline = system.clocks.monotonic() + 20.0
        while system.clocks.monotonic() < deadline:
            system.advance()
            told = bumpers.refresh()
            if told is not None and told.pressed:
                break
        assert told is not None
        assert told.pressed == ("front",)
        assert told.stamp.seconds >= 2.0
