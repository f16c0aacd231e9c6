"""What to type once a system is up: a request that the scenario can serve, with the way to the robot."""

from __future__ import annotations

import shlex

from tandem.executive.config.run_options import (
    DEFAULT_ENDPOINT,
    DEFAULT_ROBOT,
    DEFAULT_SITE,
    BusOptions,
    RunOptions,
)
from tandem.executive.security.holders import KeysError, read_holders
from tandem.sim.scenario import Scenario
from tandem.skills.ports.site import Site

ASKERS = ("operator", "requester")
"""Roles that may ask for a task."""


def hint(options: RunOptions, scenario: Scenario, site: Site) -> str:
    """Return a command that works in another terminal, as one line of a shell."""
    whole = not options.only or {"hardware", "executive"} <= set(options.only)
    words = _request(scenario, site) if whole else []
    wait = ["--wait"] if words else []
    return shlex.join(["tandem", *(words or ["tasks"]), *way_to(options.bus), *wait])


def way_to(bus: BusOptions) -> list[str]:
    """Return the options by which a command finds the robot, without those that are the default."""
    plain = (
        ("--connect", bus.endpoint, DEFAULT_ENDPOINT),
        ("--site-key", bus.site, DEFAULT_SITE),
        ("--robot", bus.robot, DEFAULT_ROBOT),
    )
    words = [word for option, value, usual in plain if value != usual for word in (option, value)]
    return words if bus.keys is None else [*words, "--keys", str(bus.keys), "--as", _asker(bus)]


def _request(scenario: Scenario, site: Site) -> list[str]:
    """Return the words of a request; none when the scenario has no item that the site knows."""
    known = [item for each in scenario.items if (item := site.item(each.item)) is not None]
    for item in known:
        if not item.needs_two:
            depots = [depot.name for depot in site.depots]
            where = [] if "depot" in depots else ["--to", depots[0]]
            return ["request", "fetch", "--item", str(item.item), *where]
    return ["request", "pick_both_hands", "--item", str(known[0].item)] if known else []


def _asker(bus: BusOptions) -> str:
    """Return the name of somebody whose key may ask for a task; NAME when nobody has one here."""
    assert bus.keys is not None, "without keys nobody is asked who they are"
    try:
        holders = read_holders(bus.keys).holders
    except KeysError:
        return "NAME"
    may = [each.name for role in ASKERS for each in holders if each.role == role and not each.revoked]
    return may[0] if may else "NAME"
