"""Algorithm 1 of the two-arm thesis against a table worked out by hand."""

import pytest

from tandem.skills import site
from tandem.skills.world import object_recorder
from tandem.skills.world.beliefs import Beliefs
from tests.skills.world.facts import at, sighting, tag


@pytest.mark.parametrize(
    ("why", "recorded", "picked", "detected", "shown"),
    [
        ("what is new is shown", {}, set(), {1: "here"}, {1: "here"}),
        ("what is seen again is where it is now", {1: "here"}, set(), {1: "there"}, {1: "there"}),
        (
            "what is hidden stays where it was last seen",
            {1: "here", 2: "a"},
            set(),
            {2: "b"},
            {1: "here", 2: "b"},
        ),
        ("what is picked leaves", {1: "here", 2: "a"}, {1}, {2: "a"}, {2: "a"}),
        ("what is detected is shown, picked or not", {1: "here"}, {1}, {1: "hand"}, {1: "hand"}),
        ("all hidden, all stay", {2: "b", 1: "a"}, set(), {}, {1: "a", 2: "b"}),
    ],
)
def test_the_scene(
    why: str, recorded: dict[int, str], picked: set[int], detected: dict[int, str], shown: dict[int, str]
) -> None:
    found = object_recorder.scene(object_recorder.update(recorded, detected), picked, detected)
    assert found == shown, why
    assert list(found) == sorted(shown)


def test_beliefs_keep_what_an_arm_hides_and_let_go_of_what_is_picked() -> None:
    beliefs = Beliefs(site.load("bimanual"))
    for item, y in ((29, 0.2), (42, -0.2)):
        beliefs.see(sighting(item, tag(0.6, y), 1.0))

    def standing() -> list[int | None]:
        things = beliefs.scene(at(2.0)).objects
        return [each.item for each in things if each.kind == "item" and each.attached_to is None]

    beliefs.see(sighting(42, tag(0.6, -0.2), 2.0))  # an arm hides 29
    assert standing() == [29, 42]
    beliefs.attach(29, "left", tag(0.0, 0.0), at(3.0))
    assert standing() == [42]
