"""An arm whose joint states fall silent is brought to rest, whatever moves it."""

from __future__ import annotations

from tandem.skills.arm.silence import SILENT_AFTER
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.reflex import ReflexSwitch, reflex_state, reflex_switch
from tests.fakes.arm_rig import PANDA_HOME, ArmRig

FAR = tuple(q + d for q, d in zip(PANDA_HOME, (1.8, 0.4, 0, 0, 0, 0, 0), strict=True))
NAME = "arm_guard_right"


def moving(rig: ArmRig, *, then: int = 1) -> None:
    rig.send(MoveGoal(joints=FAR))
    while not rig.hardware.moves:
        rig.rounds(1)
    rig.rounds(then)


def test_a_move_ends_as_overridden_when_nobody_sees_the_arm_any_more(rig: ArmRig) -> None:
    moving(rig)
    rig.hardware.silent = True
    began = rig.clocks.seconds
    status = rig.until(GoalState.FAILED)
    assert not rig.hardware.moves, "the hardware was told to stop"
    assert SILENT_AFTER < rig.clocks.seconds - began < SILENT_AFTER + 0.2
    failure = status.failure
    assert failure is not None
    assert (failure.kind, failure.reason.kind) == (FailureKind.OVERRIDDEN, FailureKind.HARDWARE_LOST)
    assert failure.evidence["reflex"] == NAME
    assert failure.reason.message == "no joint states for 0.5 s while arm/move had arm"


def test_nothing_of_the_old_plan_is_sent_afterwards_and_a_new_goal_succeeds(rig: ArmRig) -> None:
    moving(rig)
    rig.hardware.silent = True
    rig.until(GoalState.FAILED)
    sent = len(rig.hardware.goals)
    rig.hardware.silent = False
    rig.rounds(100)
    assert len(rig.hardware.goals) == sent
    assert rig.run(MoveGoal(joints=PANDA_HOME), "t/move/2").state is GoalState.SUCCEEDED


def test_joints_that_are_silent_only_for_a_moment_stop_nothing(rig: ArmRig) -> None:
    moving(rig)
    rig.hardware.silent = True
    rig.rounds(round(0.8 * SILENT_AFTER / 0.01))
    rig.hardware.silent = False
    assert rig.until(GoalState.SUCCEEDED, GoalState.FAILED).state is GoalState.SUCCEEDED


def test_an_arm_that_no_goal_has_is_nobodys_matter(rig: ArmRig) -> None:
    told = Latest(rig.bus, reflex_state(NAME))
    rig.hardware.silent = True
    rig.rounds(200)
    state = told.refresh()
    assert state is not None
    assert (state.on, state.fired) == (True, 0)


def test_an_operator_may_switch_it_off(rig: ArmRig) -> None:
    reflex_switch(NAME).query(rig.bus, ReflexSwitch(on=False, by="Ada"))
    moving(rig)
    rig.hardware.silent = True
    assert rig.until(GoalState.SUCCEEDED, GoalState.FAILED).state is GoalState.FAILED
    told = Latest(rig.bus, reflex_state(NAME))
    rig.rounds(101)
    state = told.refresh()
    assert state is not None
    assert (state.on, state.by, state.fired) == (False, "Ada", 0)
