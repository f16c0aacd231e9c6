"""Robot and executive on two hosts with a router between, in network namespaces.

Run it as root: ``python -m tests.acceptance.two_hosts [SECONDS_CUT]``. It makes three namespaces with
addresses of their own, fetches item 29 over mutual TLS, cuts the robot's link while the task runs, heals it,
and ends with 0 when the task succeeds all the same. Without root or ``ip`` it says so and ends with 77.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tests.acceptance.live import COMMAND, ENVIRONMENT, ROOT

SKIPPED = 77
PORT = 7447
SKILLS = "keeper,perception,base,arm_left,arm_right,bimanual"


def say(text: str) -> None:
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


def run(*words: str) -> None:
    subprocess.run(words, check=True)


def inside(namespace: str, *words: str) -> list[str]:
    return ["ip", "netns", "exec", namespace, *words]


@contextmanager
def namespaces(mark: str) -> Iterator[dict[str, str]]:
    """Three namespaces: the router's has a link to each of the others'. Nothing leads out of them."""
    names = {who: f"tandem-{mark}-{who}" for who in ("router", "robot", "desk")}
    try:
        for name in names.values():
            run("ip", "netns", "add", name)
            run("ip", "-n", name, "link", "set", "lo", "up")
        for net, who in ((1, "robot"), (2, "desk")):
            here, there = f"to-{who}", "to-router"
            run(
                *("ip", "-n", names["router"], "link", "add", here, "type", "veth"),
                *("peer", "name", there, "netns", names[who]),
            )
            for name, link, host in ((names["router"], here, 1), (names[who], there, 2)):
                run("ip", "-n", name, "addr", "add", f"10.99.{net}.{host}/24", "dev", link)
                run("ip", "-n", name, "link", "set", link, "up")
        yield names
    finally:
        for name in names.values():
            subprocess.run(("ip", "netns", "del", name), check=False)  # noqa: S607 - wherever ip is


@contextmanager
def up(namespace: str, log: Path, *words: str) -> Iterator[None]:
    """Have ``tandem up`` run in a namespace; wait until it says that it is ready."""
    with log.open("wb") as stream:
        argv = inside(namespace, *COMMAND, "--log", f"{log}.all", "up", "--data", f"{log}.data", *words)
        process = subprocess.Popen(argv, cwd=ROOT, env=ENVIRONMENT, stdout=stream, stderr=stream)
    try:
        deadline = time.monotonic() + 120.0
        while "ready" not in log.read_text():
            if process.poll() is not None or time.monotonic() > deadline:
                raise SystemExit(f"tandem up {' '.join(words)} did not get ready:\n{log.read_text()}")
            time.sleep(0.1)
        yield
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(30.0)


def main(cut: float) -> int:
    if os.geteuid() != 0 or shutil.which("ip") is None:
        say("skipped: network namespaces need root and the command ip")
        return SKIPPED
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="tandem-hosts-")))
        keys = folder / "keys"
        for words in (
            ("init",),
            ("new", "tiago", "--role", "robot", "--host", "10.99.1.1", "--host", "10.99.2.1"),
            ("new", "rita", "--role", "requester"),
        ):
            run(*COMMAND, "keys", *words, "--folder", str(keys))
        at = stack.enter_context(namespaces(str(os.getpid())))
        with_keys = ("--keys", str(keys), "--as", "tiago")
        listens = [word for net in (1, 2) for word in ("--listen", f"tls/10.99.{net}.1:{PORT}")]
        start = stack.enter_context
        start(up(at["router"], folder / "router.log", "--only", "router", *with_keys, *listens))
        by_robot, by_desk = (f"tls/10.99.{net}.1:{PORT}" for net in (1, 2))
        robot = ("--only", f"hardware,{SKILLS}", "--connect", by_robot, *with_keys)
        start(up(at["robot"], folder / "robot.log", *robot))
        start(up(at["desk"], folder / "desk.log", "--only", "executive", "--connect", by_desk, *with_keys))
        say("three hosts are up")
        asked = ("request", "fetch", "--item", "29", "--wait", "--connect", by_desk)
        argv = inside(at["desk"], *COMMAND, *asked, "--keys", str(keys), "--as", "rita")
        began = time.monotonic()
        task = subprocess.Popen(argv, cwd=ROOT, env=ENVIRONMENT)
        time.sleep(12.0)
        run("ip", "-n", at["router"], "link", "set", "to-robot", "down")
        say(f"{time.monotonic() - began:.1f} s: the robot's link is cut")
        time.sleep(cut)
        run("ip", "-n", at["router"], "link", "set", "to-robot", "up")
        say(f"{time.monotonic() - began:.1f} s: the link is there again")
        try:
            code = task.wait(600.0)
        except subprocess.TimeoutExpired:
            task.kill()
            code = 1
        say(f"{time.monotonic() - began:.1f} s: the task has ended with {code}")
    return code


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1]) if len(sys.argv) > 1 else 3.0))
