"""Two leaves never have the same arm."""

from __future__ import annotations

from tandem.trees.resources import Resources


def test_all_or_nothing_is_claimed() -> None:
    resources = Resources()
    assert resources.claim(["arm_left"], "a")
    assert not resources.claim(["base", "arm_left"], "b")
    assert resources.holder("base") is None


def test_a_holder_may_claim_again() -> None:
    resources = Resources()
    assert resources.claim(["base"], "a")
    assert resources.claim(["base", "head"], "a")


def test_release_frees_what_the_holder_has_and_no_more() -> None:
    resources = Resources()
    resources.claim(["base"], "a")
    resources.claim(["head"], "b")
    resources.release("a")
    assert resources.holder("base") is None
    assert resources.holder("head") == "b"
