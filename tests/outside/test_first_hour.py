"""The command line as a new user meets it: what a start, a request and a wait say, and what they end with.

A user saw ``request`` end with "error: no robot", exit 3, for a task that had been accepted and ran at the
next start; ``request --wait`` end with "no executive" after 0.2 s of silence; ``up`` end with 1 where the
table says 4; ``up --lockstep`` name an endpoint at which nobody listened; X11's words for ``--gui`` without a
display; and ids cut off in ``tasks``.
"""

from __future__ import annotations

import os
import shlex
import signal
import socket
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.outside._command import Done, Running, free_port, running, tandem, users_folder

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("first_hour")]


@dataclass(frozen=True)
class Here:
    """A router and an executive without a robot, started where the user has folders of our names."""

    up: Running
    folder: Path
    data: Path
    env: dict[str, str]

    def tandem(self, *words: str) -> Done:
        return tandem(*words, env=self.env, cwd=self.folder)

    def queue(self) -> str:
        """Ask for something, and return the task's id."""
        done = self.tandem("request", "fetch", "--item", "29")
        assert done.code == 0, done.said
        return done.out.split()[0]

    def executive(self) -> int:
        """Return the process id of the executive."""
        for entry in Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes()
                parent = (entry / "stat").read_text().rpartition(") ")[2].split()[1]
            except (OSError, IndexError):
                continue
            if parent == str(self.up.process.pid) and b'"role":"executive"' in words:
                return int(entry.name)
        raise AssertionError(f"no executive:\n{self.up.said}")


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Here]:
    folder = users_folder(tmp_path_factory.mktemp("user"))
    data = tmp_path_factory.mktemp("data")
    env = {"TANDEM_CONNECT": f"tcp/127.0.0.1:{free_port()}", "TANDEM_SITE": "first-hour"}
    with running("up", "--only", "router,executive", "--data", str(data), env=env, cwd=folder) as up:
        up.await_word("press Ctrl-C to stop")
        yield Here(up, folder, data, env)


def test_the_hint_works_in_another_terminal(here: Here) -> None:
    """It names the endpoint: TANDEM_CONNECT is not set there."""
    (line,) = (line for line in here.up.lines if line.startswith("in another terminal: "))
    words = shlex.split(line.removeprefix("in another terminal: "))
    done = tandem(*words[1:], cwd=here.folder)
    assert words[0] == "tandem"
    assert done.code == 0, done.said


def test_an_accepted_request_says_its_id_first_although_no_robot_is_there(here: Here) -> None:
    done = here.tandem("request", "fetch", "--item", "29")
    assert done.code == 0, done.said
    (task,) = done.out.split()
    assert f"{task} is queued" in done.err
    assert f"tandem cancel {task}" in done.err
    listed = here.tandem("tasks")
    assert task in listed.out
    assert "…" not in listed.out
    assert here.tandem("cancel", task).code == 0


def test_a_wait_outlives_silence_and_a_restart_of_the_executive(here: Here) -> None:
    words = ("request", "fetch", "--item", "29", "--wait")
    with running(*words, env=here.env, cwd=here.folder) as waiting:
        waiting.await_word("is queued")
        task = waiting.said.split()[0]
        here.up.process.send_signal(signal.SIGSTOP)  # nobody starts the executive again for a while
        try:
            os.kill(here.executive(), signal.SIGKILL)
            waiting.await_word("no news since")
        finally:
            here.up.process.send_signal(signal.SIGCONT)
        waiting.await_word("the executive is back")
        cancelled = here.tandem("cancel", task)
        assert cancelled.code == 0, cancelled.said
        assert waiting.process.wait(30.0) == 1
        assert f"{task}: CANCELED" in waiting.said
    assert "the executive process ended (signal 9); restarted" in here.up.said
    assert "of the user was imported" not in here.up.said


def up(here: Here, *words: str, env: dict[str, str] | None = None) -> Done:
    """Start a second system, which is to be refused."""
    return tandem("up", *words, env=here.env | (env or {}), cwd=here.folder)


def test_a_second_system_at_the_endpoint_is_refused(here: Here) -> None:
    done = up(here, "--data", str(here.data / "other"))
    assert done.code == 4, done.said
    assert "another system is running there" in done.said


def test_a_ledger_in_use_is_refused(here: Here) -> None:
    done = up(here, "--data", str(here.data), "--connect", f"tcp/127.0.0.1:{free_port()}")
    assert done.code == 4, done.said
    assert str(here.data) in done.said


def test_another_programs_port_is_refused(here: Here, tmp_path: Path) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        endpoint = f"tcp/127.0.0.1:{other.getsockname()[1]}"
        done = up(here, "--data", str(tmp_path), "--connect", endpoint)
    assert done.code == 4, done.said
    assert f"another program already listens on {endpoint}" in done.said


@pytest.mark.parametrize(
    ("words", "env", "said"),
    [
        (("--lockstep",), {}, "no client can reach"),
        (("--gui",), {"DISPLAY": ""}, "DISPLAY is not set"),
        (("--gui",), {"DISPLAY": ":987"}, "nothing answers at DISPLAY=:987"),
        (("--gui",), {"DISPLAY": "nonsense"}, "nothing answers at DISPLAY=nonsense"),
        (("--connect", "tcp/192.0.2.1:7447", "--insecure"), {}, "cannot listen on this address"),
    ],
)
def test_what_can_not_be_started_is_said_in_a_sentence(
    words: tuple[str, ...], env: dict[str, str], said: str, here: Here, tmp_path: Path
) -> None:
    done = up(here, *words, "--data", str(tmp_path), env=env)
    assert done.code == 2, done.said
    assert said in done.said
    assert len(done.said.splitlines()) == 1, done.said


def test_a_start_says_what_it_takes_up_and_an_end_leaves_it_readable(here: Here) -> None:
    """The last test here: it ends the system."""
    task = here.queue()
    assert here.up.end() == 130
    listed = here.tandem("tasks", "--data", str(here.data))
    assert listed.code == 0, listed.said
    assert task in listed.out
    why = here.tandem("why", task, "--data", str(here.data))
    assert why.code == 0, why.said
    words = ("up", "--only", "router,executive", "--data", str(here.data))
    with running(*words, env=here.env, cwd=here.folder) as again:
        said = again.await_word("press Ctrl-C to stop")
        first, moves, *_ = said.splitlines()
        assert first.startswith(f'{task} {{"item": 29')
        assert first.endswith(("is queued", "resumes"))
        assert moves == "the robot is about to move"
        assert here.tandem("cancel", task).code == 0
