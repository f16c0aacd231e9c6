"""Every command reaches a secured robot with the keys of those who may use it, and says no to the others.

From a terminal, a user could start a robot with TLS and then not stop it: ``cancel``, ``pause`` and seven
more had no ``--keys`` and ended with "no router answers"; no command reached the hardware's stop at all.
Shown a key that does not allow a question, the command said after 2.5 s that there was no executive.
"""

from __future__ import annotations

import json
import ssl
from collections.abc import Iterator
from pathlib import Path
from typing import Final
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest

from tests.outside._command import Done, Running, commands, free_port, running, tandem, users_folder

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("every_command")]

ROLES: Final = ("viewer", "requester", "operator", "robot")
ALL: Final = set(ROLES)
CLIENTS: Final = ALL - {"robot"}
NOT_IN_SITE: Final = "500"
ANY_KIND: Final = "request KIND"

EXPECTED: Final[dict[str, tuple[list[str], int, set[str]]]] = {
    # command: its arguments, what it ends with where it is allowed, who may. No task runs, so most verbs end
    # with 2: the executive has answered, and said that there is no such task.
    "tasks": ([], 0, ALL),
    "export": ([], 0, CLIENTS),
    "cancel": (["fetch-none"], 2, {"requester", "operator"}),
    "retry": (["fetch-none"], 2, CLIENTS),
    "pause": ([], 2, {"operator"}),
    "resume": (["fetch-none"], 2, {"operator"}),
    "step": (["fetch-none"], 2, {"operator"}),
    "abandon": (["fetch-none"], 2, {"operator"}),
    "reprioritise": (["fetch-none", "3"], 2, {"operator"}),
    "answer": (["yes", "--task", "fetch-none"], 2, {"operator"}),
    "force": (["fetch", "success", "--task", "fetch-none"], 2, {"operator"}),
    "break": (["fetch", "--task", "fetch-none"], 2, {"operator"}),
    "stop": (["--reason", "a test"], 0, {"operator"}),
    "release": ([], 0, {"operator"}),
    "reflex list": ([], 0, ALL),
    "reflex on": (["bumper"], 0, {"operator"}),
    "reflex off": (["base_guard", "--yes"], 0, {"operator"}),
    # The lab's site file switches no map on, so that nobody answers.
    "map show": ([], 3, CLIENTS),
    "map save": ([], 3, {"operator"}),
    "map clear": ([], 3, {"operator"}),
    "watch": (["--once"], 0, ALL),
    "logs": (["fetch-none"], 2, CLIENTS),
    "why": ([], 0, ALL),
    "doctor": ([], 0, ALL),
    "hardware check": (["--seconds", "1.1"], 0, ALL),
    "tree render": (["--live"], 0, ALL),
    "request json": (['{"task": "dance"}'], 2, {"requester", "operator"}),
    "request fetch": (["--item", NOT_IN_SITE], 2, {"requester", "operator"}),
    "request pick": (["--item", NOT_IN_SITE], 2, {"requester", "operator"}),
    "request pick_both_hands": (["--item", NOT_IN_SITE], 2, {"requester", "operator"}),
    "request pick_two": (["--left", NOT_IN_SITE, "--right", NOT_IN_SITE], 2, {"requester", "operator"}),
}
STARTS_A_SYSTEM: Final = {"ros", "up"}
"""They show the robot's keys themselves: ``up`` here by the fixture and by a test of its own."""
SERVES: Final = {"web"}
"""Runs until it is ended: a test of its own."""
CONNECTS_NOWHERE: Final = {
    "log info",
    "log cut",
    "log export",
    "log recover",
    "replay",
    "demo",
    "new",
    "plugins",
    "run KIND",
    "run json",
    "schema",
    "zones",
    "bench",
    "tree list",
    "tree coverage",
    "tree properties",
    "scenario list",
    "scenario check",
    "campaign fetch",
    "campaign recovery",
    "campaign crash",
    "campaign fuzz",
    "campaign restart",
    "campaign soak",
    "experiment uncoordinated",
    "experiment crossing",
    "experiment coordinated",
    "experiment rocs",
    "experiment crossings",
    "experiment picking",
    "keys init",
    "keys new",
    "keys list",
    "keys revoke",
    "keys link",
}
"""They read files, or run a system of their own."""


class Secured:
    """A robot behind TLS, and who has a key."""

    def __init__(self, folder: Path) -> None:
        self.keys = folder / "keys"
        self.env = {
            "TANDEM_CONNECT": f"tls/127.0.0.1:{free_port()}",
            "TANDEM_SITE": "tls-test",
            "TANDEM_ROBOT": "tiago",
            "TANDEM_KEYS": str(self.keys),
            "XDG_STATE_HOME": str(folder / "state"),
        }
        self._keys("init")
        self._keys("new", "--role", "robot", "tiago")
        for role in sorted(CLIENTS):
            self._keys("new", "--role", role, f"the-{role}")

    def _keys(self, *words: str) -> None:
        made = tandem("keys", *words, "--folder", str(self.keys))
        assert made.code == 0, made.said

    def tandem(self, *words: str, role: str) -> Done:
        """Run a command with the key of a role."""
        return tandem(*words, env=self.env | {"TANDEM_AS": "tiago" if role == "robot" else f"the-{role}"})


@pytest.fixture(scope="module")
def secured(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Secured]:
    made = Secured(tmp_path_factory.mktemp("secured"))
    # Neither TANDEM_AS of a client in the same terminal, nor folders of our names where the user is, keep the
    # robot from starting.
    env, cwd = made.env | {"TANDEM_AS": "the-operator"}, users_folder(tmp_path_factory.mktemp("user"))
    with running("up", "--speed", "0.2", env=env, cwd=cwd) as up:
        said = up.await_word("press Ctrl-C to stop")
        assert f"--connect {made.env['TANDEM_CONNECT']}" in said
        assert f"--keys {made.keys} --as the-operator --wait" in said
        yield made
        assert_alive(up)


def assert_alive(up: Running) -> None:
    assert up.process.poll() is None, up.said


def test_no_command_is_forgotten() -> None:
    """A new command stands in one of the tables above, or this fails."""
    known = {ANY_KIND if is_kind(each) else each for each in EXPECTED}
    assert sorted([*known, *STARTS_A_SYSTEM, *SERVES, *CONNECTS_NOWHERE]) == sorted(commands())


def is_kind(command: str) -> bool:
    """Say whether it is a command that only the robot knows."""
    return command.startswith("request ") and command != "request json"


@pytest.mark.parametrize("role", [*ROLES[:-1], pytest.param("robot", marks=pytest.mark.thorough)])
@pytest.mark.parametrize("command", EXPECTED)
def test_it_reaches_those_who_may_and_refuses_the_others(secured: Secured, command: str, role: str) -> None:
    arguments, code, allowed = EXPECTED[command]
    done = secured.tandem(*command.split(), *arguments, role=role)
    if role in allowed:
        assert done.code == code, done.said
        assert "does not allow" not in done.said
        assert "no router" not in done.said
        assert "no executive" not in done.said
    else:
        assert done.code == 4, done.said
        assert f"({role}) does not allow" in done.err


def test_the_page_has_the_rights_of_its_key_and_no_more(secured: Secured) -> None:
    env = secured.env | {"TANDEM_AS": "the-viewer"}
    with running("web", "--at", "127.0.0.1:0", env=env) as web:
        said = web.await_word("press Ctrl-C to stop")
        address = said.split(" is at ")[1].split()[0].rstrip("/")
        session = json.loads(urlopen(f"{address}/api/session").read())  # noqa: S310 - our own address
        assert (session["role"], session["may"]) == ("viewer", [])
        assert json.loads(urlopen(f"{address}/api/site").read())["name"]  # noqa: S310
        headers = {"Origin": address, "Content-Type": "application/json"}
        stop = Request(f"{address}/api/verb/stop", b"{}", headers)  # noqa: S310
        with pytest.raises(HTTPError, match="403"):
            urlopen(stop)  # noqa: S310


def test_beyond_its_host_the_page_speaks_tls_and_lets_in_who_has_a_key(secured: Secured) -> None:
    env = secured.env | {"TANDEM_AS": "the-operator"}
    page = f"https://localhost:{free_port()}"
    trust = ssl.create_default_context(cafile=secured.keys / "ca.pem")
    headers = {"Origin": page, "Content-Type": "application/json"}
    at = page.replace("https://localhost", "0.0.0.0")  # noqa: S104 - of a test
    with running("web", "--at", at, "--name", "localhost", env=env) as web:
        web.await_word("a log-in: tandem keys link")
        with pytest.raises(HTTPError, match="401"):
            urlopen(f"{page}/api/session", context=trust)  # noqa: S310 - our own address
        made = tandem("keys", "link", "the-viewer", "--page", page, "--word", "--folder", str(secured.keys))
        body = json.dumps({"word": made.out.strip()}).encode()
        entered = urlopen(Request(f"{page}/api/login", body, headers), context=trust)  # noqa: S310
        cookie = entered.headers["Set-Cookie"].partition(";")[0]
        asked = Request(f"{page}/api/session", headers={"Cookie": cookie})  # noqa: S310
        session = json.loads(urlopen(asked, context=trust).read())  # noqa: S310
        assert (session["who"], session["role"], session["may"]) == ("the-viewer", "viewer", [])
        asked = Request(f"{page}/api/site", headers={"Cookie": cookie})  # noqa: S310
        assert json.loads(urlopen(asked, context=trust).read())["name"], "asked of the robot behind TLS"  # noqa: S310


def test_a_stop_tells_who_set_it_until_it_is_released(secured: Secured) -> None:
    stopped = secured.tandem("stop", "--reason", "a cable lies there", role="operator")
    assert stopped.code == 0, stopped.said
    assert "by the-operator: a cable lies there" in stopped.out
    assert "tandem release" in stopped.out
    released = secured.tandem("release", role="operator")
    assert released.code == 0, released.said
    assert "the robot may move again" in released.out


def test_who_is_not_named_is_asked_for_when_there_are_several(secured: Secured) -> None:
    done = tandem("tasks", env=secured.env)
    assert done.code == 2
    assert "or --as with its name; found the-operator, the-requester, the-viewer" in done.err


def test_a_clients_key_starts_no_robot(secured: Secured) -> None:
    done = tandem("up", "--as", "the-operator", env=secured.env)
    assert done.code == 2
    assert "no keys of the robot 'the-operator'; found tiago" in done.err
