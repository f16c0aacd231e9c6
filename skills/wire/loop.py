"""The one loop of a process: woken by messages, it steps the process's nodes.

Faster than real time, the hardware waits for its followers: each says ``sim/follow`` with the tick that it is
through with.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Sequence
from typing import Final

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.node import Node
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.zenoh_bus import ZenohBus

IDLE_WAIT: Final = 0.12
"""Host seconds after which nodes are stepped although nothing came: liveliness and time-outs of links. More
than the period of the clock of a robot that rests, or each of its ticks would cost two turns."""


CALM: Final = 0.045
"""Host seconds between two ticks that wake a process which moves nothing: every fifth tick of 10 ms does, as
often as a tree looks at its timers (``tick_timer.TICK_PERIOD``). Half a tick less than that, for ticks that
come early. What is asked of it, and news, wake it at once."""

FOLLOWS: Final = "follows/"
"""Before the name of a process that follows the hardware's ticks, among the names it announces. Recorders
and pages are processes that only listen: nothing waits for them."""


class Followed(Message):
    """A follower has finished the hardware's tick."""

    follower: str
    tick: Count


FOLLOW: Final = Topic("sim/follow", Followed)


def run(
    name: str,
    bus: ZenohBus,
    clocks: ProcessClocks,
    nodes: Sequence[Node],
    stopped: Callable[[], bool],
    *,
    calm: Callable[[], bool] = lambda: False,
) -> None:
    """Step the nodes until ``stopped`` says so, then close them.

    ``calm``: says whether no node moves anything, so that only some ticks of the clock need wake them. Asked
    after each turn. Hardware that waits for its followers is followed in each.
    """
    # What was made until now lives as long as the process. Unfrozen, the collector looks through all of it
    # now and then, for 20 ms and more, between a message and its answer.
    gc.collect()
    gc.freeze()
    bus.announce(f"{FOLLOWS}{name}")
    bus.announce(f"process/{name}")
    more = waits = False
    try:
        while not stopped():
            if not more:
                bus.waker.wait(IDLE_WAIT)
            bus.beat()
            tick = clocks.refresh()
            if tick is not None:
                waits = tick.waits
            more = False
            for node in nodes:
                more = node.step() or more
            bus.waker.calm = 0.0 if waits or not calm() else CALM
            if tick is not None and waits:
                FOLLOW.publish(bus, Followed(follower=name, tick=tick.tick))
    finally:
        for node in reversed(nodes):
            node.close()
