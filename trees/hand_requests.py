"""What can contradict the site in a request for hands: answered before anything moves."""

from __future__ import annotations

from tandem.skills.ports.message import HandName
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site


def item_problems(site: Site, path: str, number: int, *, two: bool = False) -> tuple[Problem, ...]:
    """Return what is wrong with an item: not known, or for two hands and asked of one, or the other way.

    Args:
        site: what is known beforehand.
        path: of the item in the request.
        number: the item's.
        two: whether it is asked to be picked with both hands.
    """
    item = site.item(number)
    if item is None:
        known = site.item_words()
        return (Problem(path=path, expected=f"one of the site's items: {known}", found=str(number)),)
    if item.needs_two and not two:
        expected = "an item for one hand; this one needs both hands (pick_both_hands)"
        return (Problem(path=path, expected=expected, found=str(number)),)
    if two and not item.needs_two:
        expected = "an item with two grasp points; this one is for one hand (pick, pick_two)"
        return (Problem(path=path, expected=expected, found=str(number)),)
    return ()


def hand_problems(site: Site, path: str, number: int, side: HandName) -> tuple[Problem, ...]:
    """Return what is wrong with an item for that hand; it names ``path`` (two-arm thesis, 4.1.1)."""
    item = site.item(number)
    if item is None or item.needs_two or item.is_for(side):
        return ()
    expected = f"an item for the {side} hand; item {item.words} is for: {', '.join(item.hands)}"
    return (Problem(path=path, expected=expected, found=str(number)),)
