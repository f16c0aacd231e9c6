"""What ``tandem reflex`` and ``tandem watch`` say of reflexes, and what is asked before one goes off."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from types import SimpleNamespace
from typing import Self

import pytest
from rich.console import Console

from tandem.executive.cli.commands.reflex_commands import has, line
from tandem.executive.cli.commands.watch_command import View, picture
from tandem.executive.cli.main import main
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.reflex import PipelineState, ReflexState, ReflexSwitch, reflex_state
from tandem.skills.wire.memory import MemoryHub

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


class Robot:
    """Stands for a connection to a robot with one reflex, which tells how it is while somebody waits."""

    def __init__(self, state: ReflexState | None) -> None:
        hub, self.state, self.sent = MemoryHub(), state, list[ReflexSwitch]()
        self.own, self.options = hub.endpoint(), SimpleNamespace(holder="ann")
        self.bus = hub.endpoint()
        vars(self.bus)["waker"] = SimpleNamespace(wait=self.tell)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        pass

    def tell(self, seconds: float) -> None:
        del seconds
        if self.state is not None:
            reflex_state(self.state.reflex).publish(self.own, self.state)

    def require_right(self, key: str) -> None:
        pass

    def nobody(self, of: str) -> str:
        return f"no {of} answers"

    def ask(self, service: object, message: ReflexSwitch, *, of: str) -> ReflexState:
        del service, of
        self.sent.append(message)
        return BUMPER.model_copy(update={"on": message.on})


PROTECTS = BUMPER.model_copy(update={"protects": "people from a base that touches them"})
SwitchOff = Callable[..., tuple[int, list[bool], str]]


@pytest.fixture
def switch_off(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> SwitchOff:
    def switching(state: ReflexState | None, *options: str, typed: str = "") -> tuple[int, list[bool], str]:
        robot, keyboard = Robot(state), io.StringIO(typed)
        monkeypatch.setattr("tandem.executive.cli.connection.Connection", lambda _: robot)
        monkeypatch.setattr("tandem.executive.cli.commands.reflex_commands.SILENCE", 0.01)
        monkeypatch.setattr(keyboard, "isatty", lambda: bool(typed))
        monkeypatch.setattr(sys, "stdin", keyboard)
        code = main(["reflex", "off", "bumper", *options])
        return code, [each.on for each in robot.sent], capfd.readouterr().err

    return switching


@pytest.mark.parametrize(("typed", "code", "sent"), [("y\n", 0, [False]), ("n\n", 1, []), ("", 2, [])])
def test_what_protects_somebody_is_switched_off_after_a_yes_only(
    switch_off: SwitchOff, typed: str, code: int, sent: list[bool]
) -> None:
    ended, asked, said = switch_off(PROTECTS, typed=typed)
    assert (ended, asked) == (code, sent)
    assert "It protects people from a base that touches them. It stays off until" in said
    assert ("Confirm with --yes" in said) is (not typed), "nobody is at a terminal"


@pytest.mark.parametrize(
    ("state", "options"),
    [(PROTECTS, ["--yes"]), (None, ["--yes"]), (BUMPER, []), (PROTECTS.model_copy(update={"on": False}), [])],
    ids=["--yes", "unheard, --yes", "it protects nobody", "it is off"],
)
def test_nothing_is_asked_without_need(
    switch_off: SwitchOff, state: ReflexState | None, options: list[str]
) -> None:
    assert switch_off(state, *options)[:2] == (0, [False])


def test_a_reflex_that_is_not_heard_is_not_switched_off(switch_off: SwitchOff) -> None:
    code, sent, said = switch_off(None)
    assert (code, sent) == (3, [])
    assert "--yes switches it off unheard" in said
