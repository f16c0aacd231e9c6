"""What ``tandem reflex list`` and ``tandem watch`` say of reflexes, and names that no reflex can have."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from tandem.executive.cli.commands.reflex_commands import has, line
from tandem.executive.cli.commands.watch_command import View, picture
from tandem.executive.cli.main import main
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.reflex import PipelineState, ReflexState

TOUCHED = Failure(kind=FailureKind.BASE_BLOCKED, message="the left bumper is pressed", where="reflex/bumper")
FREE = PipelineState(stamp=RobotTime(boot="b", seconds=1.0), resource="base")
HELD = FREE.model_copy(update={"reflex": "bumper", "why": TOUCHED, "doing": ("SetWheelSpeed",)})
BUMPER = ReflexState(
    reflex="bumper", on=True, resources=("base",), rank=90, holds=False, fired=1, about="brakes at a touch"
)


@pytest.mark.parametrize(
    ("state", "said"),
    [
        (FREE, "base: free"),
        (
            FREE.model_copy(update={"holder": "base/go", "doing": ("GoTo", "TurnTo")}),
            "base: base/go (GoTo, TurnTo)",
        ),
        (HELD, "base: reflex bumper (SetWheelSpeed): the left bumper is pressed"),
    ],
    ids=["nobody", "a goal", "a reflex"],
)
def test_who_has_a_resource(state: PipelineState, said: str) -> None:
    assert has(state) == said


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({}, "  bumper  on; rank 90; takes base; fired 1 time; brakes at a touch"),
        (
            {"on": False, "by": "ann", "fired": 2},
            "  bumper  off by ann; rank 90; takes base; fired 2 times; ",
        ),
    ],
)
def test_a_reflex_in_a_line(changes: dict[str, object], said: str) -> None:
    assert line(BUMPER.model_copy(update=changes)).startswith(said)


def test_watch_shows_what_a_reflex_has() -> None:
    console = Console(file=io.StringIO(), width=120, record=True)
    console.print(picture(View(held={"base": HELD}), height=20))
    assert "base: reflex bumper (SetWheelSpeed): the left bumper is pressed" in console.export_text()


def test_a_name_that_no_reflex_has_is_refused_before_anybody_is_asked(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["reflex", "off", "Bumper!", "--connect", "tcp/127.0.0.1:1"]) == 2
    assert "no reflex is called 'Bumper!'" in capfd.readouterr().err
