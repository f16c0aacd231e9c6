"""Which reflexes each owner makes, and which declarations it takes."""

from __future__ import annotations

from typing import Any

import pytest

from tandem.skills.arm.reflexes.registry import OWNER as ARMS
from tandem.skills.base.reflexes.registry import OWNER as BASES
from tandem.skills.limbs import LimbOwner, LimbSurroundings
from tandem.skills.perception.head_reflexes import OWNER as HEADS
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import ARM, HAND, OWNED
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.sources import DocumentError
from tandem.skills.reflex_owners import COME_ALONG
from tandem.skills.reflexes import Reflex, ReflexType
from tandem.skills.site import load
from tests.fakes.planar_robot import describe

OWNERS = (BASES, ARMS, HEADS)


class Force(Message):
    """Newtons."""

    most: float = 20.0


def _never(at: LimbSurroundings, parameters: Force) -> Reflex:
    raise AssertionError(f"nobody makes it: {at} {parameters}")


YIELDS = ReflexType[LimbSurroundings, Any](
    name="yields",
    about="a script",
    resources=(ARM,),
    rank=50,
    parameters=Force,
    needs=lambda _: "",
    make=_never,
)
OWNER = LimbOwner(resources=(ARM, HAND), shipped={"yields": YIELDS})


def test_every_owner_has_what_one_process_owns() -> None:
    assert tuple(each.resources for each in OWNERS) == OWNED


def test_each_knows_the_names_of_all_that_come_along() -> None:
    shipped = {name: each.resources for owner in OWNERS for name, each in owner.shipped.items()}
    assert dict(COME_ALONG) == shipped


@pytest.mark.parametrize(
    ("told", "most"),
    [
        ((), {"left": 20.0, "right": 20.0}),
        ((("yields", 30.0),), {"left": 30.0, "right": 30.0}),
        ((("yields_left", 10.0), ("yields", 30.0)), {"left": 10.0, "right": 30.0}),
    ],
)
def test_each_arm_has_a_reflex_of_its_own_and_one_declared_for_it_alone_counts_more(
    told: tuple[tuple[str, float], ...], most: dict[str, float]
) -> None:
    settings = tuple(ReflexSetting(reflex=name, parameters={"most": force}) for name, force in told)
    site = load("lab").model_copy(update={"reflexes": settings})
    for side in ("left", "right"):
        (made,) = OWNER.chosen_for((YIELDS,), describe(), site, "lab.yaml", part=side)
        assert made.type.name == f"yields_{side}"
        assert isinstance(made.parameters, Force)
        assert made.parameters.most == most[side]


@pytest.mark.parametrize(
    ("name", "said"),
    [("yeilds", "no reflex 'yeilds'; expected one of "), ("bumper_up", "no reflex 'bumper_up'")],
)
def test_a_name_that_nobody_has_is_refused_by_every_owner(name: str, said: str) -> None:
    site = load("lab").model_copy(update={"reflexes": (ReflexSetting(reflex=name),)})
    for owner, part in ((BASES, ""), (ARMS, "left"), (HEADS, "")):
        with pytest.raises(DocumentError, match=f"^lab.yaml: reflexes.0: {said}"):
            owner.chosen_for(owner.types(None), describe(), site, "lab.yaml", part)


def test_what_another_owner_runs_may_be_declared() -> None:
    site = load("lab").model_copy(update={"reflexes": (ReflexSetting(reflex="bumper"),)})
    assert ARMS.chosen_for(ARMS.types(None), describe(), site, "lab.yaml", part="left") is not None
