"""Twenty tabs, and one that reads nothing: the others see all, and the frozen one costs one picture."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any

import pytest
from web_fake import FakeRobot, served
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from tandem.executive.web.viewers import MOST, Update, merge
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE
from tandem.skills.ports.tasks import TREE, TreeNode, TreeSnapshot

TABS = 20
TELLS = 60
WIDE = 200_000
"""Characters of a tree: sixty are more than the kernel takes in for a tab that does not read."""


@pytest.fixture
def robot() -> FakeRobot:
    return FakeRobot(seconds=100.0)


@pytest.fixture
def address(robot: FakeRobot) -> Iterator[str]:
    with served(robot) as found:
        yield found


def tab(address: str, sock: socket.socket | None = None, max_queue: int = 16) -> ClientConnection:
    where, origin = f"{address.replace('http', 'ws')}/live", Origin(address)
    return connect(where, origin=origin, sock=sock, max_queue=max_queue, max_size=None)


def hear(socket_: ClientConnection, until: Callable[[Update], bool]) -> Update:
    """Take in updates until what is known is so."""
    known: Update = {}
    while not until(known):
        merge(known, json.loads(socket_.recv(timeout=30.0)))
    return known


def here(known: Update) -> bool:
    """Say whether the page's server hears the robot."""
    return known.get("executive") is True


def stopped(known: Update) -> bool:
    state = known.get("stop")
    return isinstance(state, dict) and state["stopped"] is True


def tree(number: int) -> TreeSnapshot:
    """Return a tree of another shape each time, so that it is told whole."""
    root = TreeNode(path=f"t{number}", name="t", kind="action", type="A", message="x" * WIDE)
    return TreeSnapshot(task="t", kind="t", tick=number, root=root)


def shows(number: int) -> Callable[[Update], bool]:
    def shown(known: Update) -> bool:
        told: Any = known.get("tree")
        return told is not None and told["tick"] >= number

    return shown


def test_twenty_tabs_see_the_stop(robot: FakeRobot, address: str) -> None:
    with ExitStack() as open_:
        tabs = [open_.enter_context(tab(address)) for _ in range(TABS)]
        for each in tabs:
            hear(each, here)
        robot.tell((STOP_STATE, StopState(stopped=True, by="anna")))
        for each in tabs:
            assert stopped(hear(each, stopped))


def test_a_frozen_tab_disturbs_nobody_and_goes_on_with_the_newest(robot: FakeRobot, address: str) -> None:
    small = socket.socket()
    small.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    host, _, port = address.rpartition("/")[2].partition(":")
    small.connect((host, int(port)))
    with tab(address) as awake, tab(address, sock=small, max_queue=1) as frozen:
        hear(awake, here)
        for number in range(TELLS):
            robot.tell((TREE, tree(number)))
            hear(awake, shows(number))
        read = 0
        while True:
            update = json.loads(frozen.recv(timeout=30.0))
            read += "tree" in update
            if shows(TELLS - 1)(update):
                break
        assert read < TELLS, "what it had not read became one update"


def test_more_tabs_than_there_may_be_are_refused_in_words(address: str) -> None:
    with ExitStack() as open_:
        for _ in range(MOST):
            open_.enter_context(tab(address))
        with tab(address) as refused, pytest.raises(ConnectionClosed, match=f"{MOST} pages are open"):
            refused.recv(timeout=30.0)
