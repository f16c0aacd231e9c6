"""The keeper: the one owner of ``world/state`` and ``world/scene``."""

from __future__ import annotations

import logging
from typing import Final

from tandem.skills.ports.actions.gripper import HandState, HandStatus, hand_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import CLUTTER, OCCUPANCY, SCENE, SIGHTINGS, WORLD
from tandem.skills.world.beliefs import Beliefs
from tandem.skills.world.journal import Journal

log = logging.getLogger(__name__)

SURE_AFTER: Final = 0.5
"""Robot seconds for which a hand must tell that it holds nothing: longer than the watch over it needs to
judge what it presses on (0.2 s) after the first message of a boot."""
REPEAT: Final = 1.0
"""Robot seconds between two publications when nothing changes."""
TRY_AGAIN: Final = 1.0
"""Host seconds after which beliefs that could not be written down are tried again: soon for a person who
frees space, and rare enough that a full disk keeps nobody busy."""


class Keeper:
    """A ``Node``: merges what perception tells, and publishes on each change and every second.

    It also publishes when somebody comes: an executive that is started again waits for the world.

    After another start of the hardware a hand that was full may be empty. Until each such hand has told,
    nothing is published: what is not known is not told.

    A hand that tells EMPTY has lost what it is believed to hold, if it was attached before: then nobody knows
    where that is.

    Args:
        bus: where perception, arms and trees are.
        clocks: robot time; UTC for the journal.
        site: furniture, items, depots.
        hands: the robot's.
        journal: keeps what no sensor can restore; None keeps nothing (lockstep).
    """

    name: Final = "world/keeper"

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        site: Site,
        hands: tuple[HandName, ...],
        journal: Journal | None = None,
    ) -> None:
        self._bus, self._clocks, self._journal = bus, clocks, journal
        self.beliefs = Beliefs(site, None if journal is None else journal.remembered)
        self._sightings = Latest(bus, SIGHTINGS)
        self._clutter = Latest(bus, CLUTTER)
        self._occupancy = Latest(bus, OCCUPANCY, depth=4)
        self._hands = {side: Latest(bus, hand_status(side)) for side in hands}
        self._attached: dict[HandName, RobotTime] = {}
        self._unsure: dict[HandName, RobotTime | None] = {}
        """Hands that were full before this boot, and when each first told that it holds nothing."""
        self._published, self._there = 0, frozenset[str]()
        self._published_at: RobotTime | None = None
        self._unkept_since: float | None = None
        """Host seconds of the last write that failed; None when the journal has all that is believed."""

    @property
    def hands(self) -> tuple[HandName, ...]:
        """The robot's hands."""
        return tuple(self._hands)

    @property
    def clocks(self) -> Clocks:
        """The clocks that facts are stamped by."""
        return self._clocks

    def step(self) -> bool:
        """Take in what was seen and what the hands tell; publish what changed."""
        now = self._clocks.robot()
        if now is not None:
            self._unsure.update(dict.fromkeys(self.beliefs.wake(now.boot)))
            for lost in sorted(self._unsure.keys() - self._hands.keys()):  # of another robot, before this one
                self._lose(lost, now)
        self._see()
        for side, hand in self._hands.items():
            for status in hand.take():
                self._watch(side, status)
        if self._unkept_since is not None and self._clocks.monotonic() - self._unkept_since > TRY_AGAIN:
            self._keep_if_possible()
        self.publish()
        return False

    def _see(self) -> None:
        version, firm = self.beliefs.version, self.beliefs.firm
        for message in self._sightings.take():
            for number in dict.fromkeys(each.item for each in message.sightings):
                self.beliefs.see_together([each for each in message.sightings if each.item == number])
            for number in message.absent:
                self.beliefs.miss(number, message.stamp)
        for look in self._clutter.take():
            self.beliefs.look(look)
        if self.beliefs.version != version:
            self._keep_if_possible(synced=self.beliefs.firm != firm)
        for told in self._occupancy.take()[-1:]:
            self.beliefs.occupy(told)  # perception keeps it, no journal

    def attached(self, side: HandName, now: RobotTime) -> None:
        """Note when the hand took what it holds: only later news of it count."""
        self._attached[side] = now

    def _watch(self, side: HandName, status: HandStatus) -> None:
        if side in self._unsure:
            self._make_sure(side, status)
            return
        held, since = self.beliefs.in_hand(side), self._attached.get(side)
        if held is None or status.state is not HandState.EMPTY:
            return
        if since is not None and status.stamp.is_after(since) is False:
            return
        log.warning("item %d fell out of the %s hand at %.2f s", held.item, side, status.stamp.seconds)
        self.beliefs.detach(held.item, None, None, status.stamp)
        self._keep_if_possible()

    def _make_sure(self, side: HandName, status: HandStatus) -> None:
        """Hear from a hand that was full before this boot; one that does not press for a while is empty."""
        now, held, first = self._clocks.robot(), self.beliefs.in_hand(side), self._unsure[side]
        if now is None or now.since(status.stamp) is None:
            return  # told before this boot
        if held is None or status.state is HandState.HOLDING:
            del self._unsure[side]
            return
        if first is None:
            self._unsure[side] = first = status.stamp
        passed = status.stamp.since(first)
        if passed is not None and passed >= SURE_AFTER:
            self._lose(side, status.stamp)

    def _lose(self, hand: HandName, now: RobotTime) -> None:
        del self._unsure[hand]
        held = self.beliefs.in_hand(hand)
        if held is not None:
            log.warning("item %d is lost: since a new boot the %s hand is empty", held.item, hand)
            self.beliefs.detach(held.item, None, None, now)
            self._keep_if_possible()

    def keep(self, *, synced: bool = True) -> None:
        """Write what is believed to the journal, before anybody hears of it.

        Raises:
            OSError: when it can't be written.
        """
        if self._journal is not None:
            self._journal.write(self.beliefs.remembered(self._clocks.utc()), synced=synced)
            self._unkept_since = None

    def _keep_if_possible(self, *, synced: bool = True) -> None:
        """Write what was sensed; a full disk does not undo it, and it is written once there is space."""
        try:
            self.keep(synced=synced)
        except OSError:
            if self._unkept_since is None:
                log.exception("beliefs can't be written down; they are kept in memory until there is space")
            self._unkept_since = self._clocks.monotonic()

    def publish(self) -> None:
        """Publish, if something changed, a second has passed, or somebody has come."""
        now, there = self._clocks.robot(), self._bus.alive()
        came, self._there = not there <= self._there, there
        news = self.beliefs.version != self._published or came
        if now is None or self._unsure or not (news or self._due(now)):
            return
        WORLD.publish(self._bus, self.beliefs.state(now))
        SCENE.publish(self._bus, self.beliefs.scene(now))
        self._published, self._published_at = self.beliefs.version, now

    def close(self) -> None:
        """End the subscriptions."""
        self._sightings.close()
        self._clutter.close()
        self._occupancy.close()
        for hand in self._hands.values():
            hand.close()

    def _due(self, now: RobotTime) -> bool:
        last = self._published_at
        passed = None if last is None else now.since(last)
        return passed is None or passed >= REPEAT
