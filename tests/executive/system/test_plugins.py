"""What other packages add takes part: tasks, roles, skills, sites, nodes; and a broken one is left out."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tandem.executive.cli.main import main
from tandem.executive.system.lockstep import Lockstep
from tandem.executive.system.plugin_probe import broken, probe
from tandem.executive.system.roles.registry import names, plugged_roles, rights_of_parts, skill_roles
from tandem.sim.scenario import load_scenario, read_scenario
from tandem.skills.ports.keys import Nothing
from tandem.skills.ports.plugins import Group
from tandem.skills.ports.plugins import installed as declared
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.tasks import TASK_INFO, ExecutiveInfo
from tandem.skills.site import load, locate
from tandem.skills.site import names as site_names
from tandem.skills.testing.mock_description import mock_description
from tandem.trees.nodes import plugged as plugged_nodes
from tandem.trees.registry import discover
from tandem.trees.registry import plugged as plugged_tasks
from tests.fakes.packages import Installed

TASK = """
    from typing import Literal
    from py_trees.behaviours import Success
    from tandem.skills.ports.message import Message
    from tandem.trees.task import TaskType

    class Request(Message):
        task: Literal["{name}"] = "{name}"

    TASK = TaskType(name="{name}", summary="Do nothing.", request=Request,
        problems=lambda asked, site: (), build=lambda asked, context: Success("nothing"))
"""
SKILL = """
    from typing import ClassVar
    from tandem.executive.system.roles.skill_type import SkillType
    from tandem.skills.ports.message import Message
    from tandem.skills.ports.skill import ActionType, succeeded

    class Goal(Message):
        pass

    class Wave:
        action = ActionType("wave", Goal, Goal, Goal, timeout=5.0)
        period = 0.1

        def check(self, goal):
            return None

        def run(self, goal, goal_id):
            yield Goal()
            return succeeded(Goal())

    SKILL = SkillType("waving", lambda at: Wave(), tells=("hw/lamp",))
"""
ROLE = """
    from tandem.executive.security.rights import Rights
    from tandem.executive.system.roles.role import Role
    ROLE = Role("{name}", kind="{kind}", {how}=lambda at: (), rights=Rights(tells=("hw/horn",)))
"""


def role(name: str, *, kind: str = "skills", how: str = "nodes") -> str:
    return ROLE.format(name=name, kind=kind, how=how)


@pytest.fixture
def somebody(installed: Installed) -> Installed:
    """A package with one of each, and others with what is broken."""
    site = (Path(__file__).parents[3] / "skills" / "sites" / "lab.yaml").read_text("utf-8")
    (installed.folder / "hall.yaml").write_text(site)
    installed.add(
        "somebody",
        {
            "somebody_tasks": TASK.format(name="nothing"),
            "somebody_skills": SKILL,
            "somebody_roles": role("horn"),
            "somebody_sites": "import pathlib\nHALL = pathlib.Path(__file__).with_name('hall.yaml')\n",
            "somebody_nodes": "def beep(name, context): ...\n",
        },
        {
            "tandem.tasks": {"nothing": "somebody_tasks:TASK"},
            "tandem.skills": {"waving": "somebody_skills:SKILL"},
            "tandem.roles": {"horn": "somebody_roles:ROLE"},
            "tandem.sites": {"hall": "somebody_sites:HALL"},
            "tandem.nodes": {"beep": "somebody_nodes:beep"},
        },
    )
    return installed


@pytest.mark.usefixtures("somebody")
def test_each_group_is_found() -> None:
    assert "nothing" in discover()
    assert {"waving", "horn"} <= set(names(mock_description(), {}))
    assert list(plugged_nodes().found) == ["beep"]
    assert Path(locate("hall")).name == "hall.yaml"
    assert load("hall").name == "lab"


@pytest.mark.usefixtures("somebody")
def test_the_router_grants_what_a_plugged_role_and_a_plugged_skill_declare() -> None:
    assert {"hw/horn", "hw/lamp"} <= set(rights_of_parts()["skills"].tells)
    (horn,) = declared(Group.ROLES)
    assert "hw/horn" not in rights_of_parts({horn.key: "it hung"})["skills"].tells


@pytest.mark.usefixtures("somebody")
@pytest.mark.lockstep
def test_a_skill_and_a_task_take_part_in_lockstep_when_they_are_asked_for() -> None:
    assert [each.name for each in skill_roles(mock_description(), {}) if each.name == "waving"] == ["waving"]
    for left_out, there in (({}, True), (None, False)):
        system = Lockstep(load_scenario("Demo"), 1, left_out=left_out)
        try:
            system.step()
            pending = TASK_INFO.query(system.bus, Nothing())
            assert system.run_until(pending.done, within=1.0)
            answer = pending.poll()
            assert answer is not None
            assert ("nothing" in ExecutiveInfo.model_validate_json(answer).tasks) is there
            assert ("skill/wave" in system.bus.alive()) is there
        finally:
            system.close()


@pytest.mark.parametrize(
    ("group", "source", "target", "error"),
    [
        ("tasks", TASK.format(name="other"), "TASK", "called 'mine' and its task 'other'; expected one name"),
        ("tasks", "TASK = 7", "TASK", "expected a TaskType; found int"),
        ("roles", role("other"), "ROLE", "called 'mine' and its role 'other'; expected one name"),
        ("roles", role("mine", kind="hardware"), "ROLE", "kind skills or observer; found hardware"),
        ("roles", role("mine", how="route"), "ROLE", "expected a role with either nodes or play"),
        ("skills", role("mine"), "ROLE", "expected a SkillType; found Role"),
        ("sites", "HALL = 'hall.yaml'", "HALL", "expected a file; there is none at hall.yaml"),
        ("sites", "HALL = 3", "HALL", "expected the pathlib.Path of a .yaml file; found 3"),
        ("nodes", "NODE = 3", "NODE", "expected a callable that makes a node; found int"),
    ],
)
def test_what_is_of_another_kind_is_left_out(
    installed: Installed, group: str, source: str, target: str, error: str
) -> None:
    installed.add("somebody", {"mine": source}, {f"tandem.{group}": {"mine": f"mine:{target}"}})
    (found,) = broken()
    assert error in found.error
    assert found.plugin.group == group


def test_one_that_raises_one_that_hangs_one_that_ends_its_process_and_one_that_claims_a_taken_name(
    installed: Installed, monkeypatch: pytest.MonkeyPatch
) -> None:
    entries = {
        "raises": "raises:TASK",
        "hangs": "hangs:TASK",
        "ends": "ends:TASK",
        "fetch": "fetches:TASK",
        "good": "good:TASK",
    }
    installed.add(
        "somebody",
        {
            "raises": "1 / 0",
            "hangs": "import threading\nthreading.Event().wait()",
            "ends": "import os\nos._exit(3)",
            "fetches": TASK.format(name="fetch"),
            "good": TASK.format(name="good"),
        },
        {"tandem.tasks": entries},
    )
    errors = {each.name: each.error for each in probe(within=3.0)}
    assert errors.pop("raises").startswith("ZeroDivisionError: division by zero (")
    assert errors == {
        "hangs": "its import took longer than 3 s",
        "ends": "its import ended its process (exit code 3)",
        "fetch": "the name 'fetch' is taken: Tandem's own; choose another one",
        "good": "",
    }
    left_out = {each.plugin().key: each.error for each in probe(within=3.0) if each.error}
    loaded = plugged_tasks(left_out)
    assert list(loaded.found) == ["good"]
    assert {each.error for each in loaded.broken} == set(left_out.values())
    monkeypatch.setattr("tandem.skills.ports.plugin_trials._tried", None)  # later commands try none again
    harm = {each.plugin.name: each.error.partition(";")[0] for each in plugged_tasks().broken}
    assert {name: harm[name] for name in ("hangs", "ends")} == {
        name: errors[name] for name in ("hangs", "ends")
    }


def test_where_only_our_own_are_installed_no_process_is_started(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tandem.executive.system.plugin_probe._run_child", None)
    assert broken() == ()


def test_a_command_names_one_that_ends_its_process_and_does_its_work(
    capsys: pytest.CaptureFixture[str], installed: Installed
) -> None:
    modules = {"ends": "import os\nos._exit(3)", "good": TASK.format(name="good")}
    installed.add("somebody", modules, {"tandem.tasks": {"a_bad": "ends:TASK", "good": "good:TASK"}})
    for _ in range(2):
        assert main(["tree", "list"]) == 0
        said = capsys.readouterr()
        assert "good" in said.out
        assert said.err == (
            "plug-in tasks/a_bad (somebody 1.0) is left out: its import ended its process (exit code 3); "
            "mend somebody or uninstall it, and try it with `tandem plugins`\n"
        )


@pytest.mark.usefixtures("somebody")
def test_the_command_lists_them(capsys: pytest.CaptureFixture[str], installed: Installed) -> None:
    assert main(["plugins"]) == 0
    assert "waving" in capsys.readouterr().out
    installed.add("another", {"bad": "raise OSError('no camera')"}, {"tandem.nodes": {"bad": "bad:NODE"}})
    assert main(["plugins", "--json"]) == 1
    listed = {each["name"]: each for each in json.loads(capsys.readouterr().out)}
    assert sorted(listed) == ["bad", "beep", "hall", "horn", "nothing", "waving"]
    assert listed["nothing"]["package"] == "somebody"
    assert listed["nothing"]["error"] == ""
    assert listed["bad"]["error"].startswith("OSError: no camera (")


def test_a_scenario_names_its_site_by_a_path_beside_it(tmp_path: Path) -> None:
    here = Path(__file__).parents[3]
    (tmp_path / "sites").mkdir()
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "sites" / "hall.yaml").write_text((here / "skills/sites/lab.yaml").read_text("utf-8"))
    text = (here / "sim/scenarios/Demo.yaml").read_text("utf-8")
    assert "site: lab" in text
    path = tmp_path / "scenarios" / "first.yaml"
    path.write_text(text.replace("site: lab", "site: ../sites/hall.yaml"))
    scenario, _ = read_scenario(path)
    assert Path(scenario.site).resolve() == tmp_path / "sites" / "hall.yaml"
    assert main(["scenario", "check", str(path)]) == 0
    assert main(["scenario", "check", "Demo", "--site", str(tmp_path / "sites" / "hall.yaml")]) == 0
    assert main(["scenario", "check", "Demo", "--site", "bimanual"]) == 2


def test_a_site_that_is_not_there_is_refused_with_those_that_are(
    installed: Installed,
) -> None:
    installed.add("somebody", {"bad": "1 / 0"}, {"tandem.sites": {"hall": "bad:HALL"}})
    known = ", ".join(site_names())
    with pytest.raises(DocumentError, match=f"no site 'hall'; expected {known}, or .*; plug-in sites/hall"):
        load("hall")


@pytest.mark.usefixtures("somebody")
def test_roles_say_where_they_come_from() -> None:
    assert plugged_roles().origins["horn"].package == "somebody"


def test_an_arms_name_is_taken(installed: Installed) -> None:
    installed.add("somebody", {"mine": role("arm_left")}, {"tandem.roles": {"arm_left": "mine:ROLE"}})
    assert [each.error[:27] for each in plugged_roles().broken] == ["the name 'arm_left' is take"]
