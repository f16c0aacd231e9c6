"""When a thing that is put down stands."""

from tandem.skills.bimanual.landing import LEFT, STANDS_FOR, Landing

WEIGHT = 5.0


def test_what_rebounds_does_not_stand() -> None:
    landing = Landing(WEIGHT)
    told = [landing.stands(load, 0.03 * k) for k, load in enumerate([5.0, -0.6, 0.5, 4.9, 0.0, 0.0, 4.9])]
    assert not any(told)


def test_what_stays_off_the_wrists_stands() -> None:
    landing = Landing(WEIGHT)
    assert not landing.stands(0.9 * LEFT * WEIGHT, 1.0)
    assert landing.stands(0.9 * LEFT * WEIGHT, 1.0 + STANDS_FOR)
