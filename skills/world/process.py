"""The nodes of the world's process."""

from __future__ import annotations

from pathlib import Path

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import HandName
from tandem.skills.ports.node import Node
from tandem.skills.ports.site import Site
from tandem.skills.server import ActionServer
from tandem.skills.world.edit import Edit
from tandem.skills.world.journal import Journal
from tandem.skills.world.keeper import Keeper


def nodes(
    bus: Bus,
    clocks: Clocks,
    site: Site,
    hands: tuple[HandName, ...],
    journal: Path | None = None,
    *,
    charge: bool = False,
) -> tuple[Node, ...]:
    """Return the keeper and the edits' server.

    Args:
        bus: where perception, arms and trees are.
        clocks: robot time and UTC.
        site: what is known beforehand.
        hands: the robot's.
        journal: the file that keeps what no sensor can restore; None in lockstep.
        charge: the server's, for lockstep.

    Raises:
        OSError: when the journal can't be read or written.
        DocumentError: when the journal is none.
    """
    keeper = Keeper(bus, clocks, site, hands, None if journal is None else Journal(journal))
    return (keeper, ActionServer(bus, clocks, Edit(keeper), charge=charge))
