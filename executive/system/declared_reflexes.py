"""What a site declares of reflexes, checked before any process starts."""

from __future__ import annotations

from collections.abc import Mapping

from tandem.sim.scenario import Scenario
from tandem.skills.ports.site import Site


def check_reflexes(scenario: Scenario, site: Site, left_out: Mapping[str, str]) -> None:
    """Check a site's reflexes against each robot of a scenario that has an executive.

    Args:
        scenario: names the robots, and the site's file.
        site: what the file says.
        left_out: plug-ins that are known not to load.

    Raises:
        DocumentError: as ``tandem.skills.reflexes.chosen``.
    """
    if not site.reflexes:
        return
    from tandem.sim.robots.registry import robot_model  # noqa: PLC0415 - loads numpy: only where it is needed
    from tandem.skills.base.reflexes.registry import chosen_for, reflexes  # noqa: PLC0415 - likewise

    types = reflexes(left_out)
    for each in scenario.placed:
        if each.drives == "executive":
            chosen_for(types, robot_model(each.robot).description, site, scenario.site)
