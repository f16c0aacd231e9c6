"""``tandem up`` with somebody else's package: its task calls its skill, and what is broken is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fakes.packages import write_package
from tests.outside._command import free_port, running, tandem

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]

SKILL = """
    from tandem.executive.system.roles.skill_type import SkillType
    from tandem.skills.ports.message import Message
    from tandem.skills.ports.skill import ActionType, succeeded

    class Wave(Message):
        pass

    WAVE = ActionType("wave", Wave, Wave, Wave, timeout=5.0)

    class Waving:
        action = WAVE
        period = 0.1

        def check(self, goal):
            return None

        def run(self, goal, goal_id):
            yield Wave()
            return succeeded(Wave())

    SKILL = SkillType("waving", lambda at: Waving())
"""
TASK = """
    from typing import Literal
    from somebody_skill import WAVE, Wave
    from tandem.skills.ports.message import Message
    from tandem.trees.behaviours.act import Act
    from tandem.trees.task import TaskType

    class Greeting(Message):
        task: Literal["greet"] = "greet"

    TASK = TaskType(name="greet", summary="Wave.", request=Greeting, problems=lambda asked, site: (),
        build=lambda asked, context: Act("wave", context, WAVE, lambda: Wave(), resources=()))
"""
ROLE = """
    from tandem.executive.system.roles.role import Role

    def nodes(at):
        raise OSError("no such lamp")

    ROLE = Role("lamp", nodes=nodes)
"""
MODULES = {
    "somebody_skill": SKILL,
    "somebody_task": TASK,
    "somebody_role": ROLE,
    "somebody_raises": "raise OSError('no licence')",
    "somebody_hangs": "while True:\n    pass",
}
ENTRIES = {
    "tandem.skills": {"waving": "somebody_skill:SKILL"},
    "tandem.roles": {"lamp": "somebody_role:ROLE"},
    "tandem.tasks": {
        "greet": "somebody_task:TASK",
        "fetch": "somebody_task:TASK",
        "raises": "somebody_raises:TASK",
        "hangs": "somebody_hangs:TASK",
    },
}


def test_a_plugged_task_calls_a_plugged_skill_and_what_is_broken_is_named(tmp_path: Path) -> None:
    packages = write_package(tmp_path / "packages", "somebody", MODULES, ENTRIES)
    env = {
        "PYTHONPATH": str(packages),
        "TANDEM_CONNECT": f"tcp/127.0.0.1:{free_port()}",
        "TANDEM_SITE": "plugins",
        "XDG_STATE_HOME": str(tmp_path / "state"),
    }
    with running("up", env=env) as up:
        said = up.await_word("press Ctrl-C to stop")
        done = tandem("request", "json", '{"task": "greet"}', "--wait", env=env)
        assert done.code == 0, done.said
    for broken in (
        "plug-in tasks/fetch (somebody 1.0) is left out: the name 'fetch' is taken: Tandem's own",
        "plug-in tasks/raises (somebody 1.0) is left out: OSError: no licence",
        "plug-in tasks/hangs (somebody 1.0) is left out: its import took longer than 10 s",
        "OSError: no such lamp",
        "the plug-in role lamp is off from now on",
    ):
        assert broken in said
