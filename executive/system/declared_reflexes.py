"""What robots and a site declare of reflexes, checked before any process starts."""

from __future__ import annotations

from collections.abc import Mapping

from tandem.sim.scenario import Scenario
from tandem.skills.ports.robot_description import RobotDescription
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

    for each in scenario.placed:
        if each.drives == "executive":
            _check(robot_model(each.robot).description, site, scenario.site, left_out)


def _check(robot: RobotDescription, site: Site, site_called: str, left_out: Mapping[str, str]) -> None:
    """Choose the reflexes as each owner does."""
    from tandem.skills.arm.reflexes.registry import OWNER as ARMS  # noqa: PLC0415 - likewise
    from tandem.skills.base.reflexes.registry import OWNER as BASE  # noqa: PLC0415
    from tandem.skills.perception.head_reflexes import OWNER as HEAD  # noqa: PLC0415

    BASE.chosen_for(BASE.types(left_out), robot, site, site_called)
    HEAD.chosen_for(HEAD.types(left_out), robot, site, site_called)
    for side in robot.hands:
        ARMS.chosen_for(ARMS.types(left_out), robot, site, site_called, part=side)
