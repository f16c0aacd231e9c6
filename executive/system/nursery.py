"""A process that has loaded what all processes of a system need, and has them born by a fork.

Each then shares those pages with the others and begins at once. A fork is sound here alone: this process has
one thread, no session, no lock that another thread could hold. Where that is not so it says 0, and the
supervisor starts a fresh interpreter, as it does when this process has died. On Linux only.

It is spoken to on a socket that is its standard input: a message is a process's settings, with the file that
its words go to; or, without a file, the name of a role that shall be loaded ahead.
"""

from __future__ import annotations

import gc
import os
import socket
from importlib import import_module
from pathlib import Path
from typing import Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system import playing, worker
from tandem.executive.system.command_line import show
from tandem.executive.system.roles.registry import role_named
from tandem.skills.ports.isolation import python

MOST: Final = 65536
"""Bytes of a message."""
ALL_NEED: Final = (
    "tandem.skills.wire.zenoh_bus",
    "tandem.skills.wire.presence",
    "tandem.executive.system.skill_process",
)
SKILLS_NEED: Final = (
    "tandem.skills.world.process",
    "tandem.skills.base.process",
    "tandem.skills.arm.process",
    "tandem.skills.arm.reflexes.registry",
    "tandem.skills.gripper.process",
    "tandem.skills.bimanual.process",
    "tandem.skills.kinematics.described",
    "tandem.skills.reflex.process",
)
"""Loaded before the first process of skills is born: the hardware's has begun to build its world by then."""


class Nursery:
    """Has processes born. ``attend`` comes back in each of them, and in the nursery itself at its end."""

    def __init__(self, line: socket.socket) -> None:
        self._line, self._ready = line, False
        _load(ALL_NEED)

    def attend(self) -> str:
        """Return the settings of the process that this one has become; nothing at the supervisor's end."""
        while True:
            message, files, _, _ = socket.recv_fds(self._line, MOST, 1)
            text = message.decode()
            if not text:
                return ""
            if not files:
                playing.load_ahead(text)
                gc.freeze()
                continue
            (log,) = files
            if self._bear(WorkerSettings.model_validate_json(text), log):
                return text
            os.close(log)

    def _bear(self, settings: WorkerSettings, log: int) -> bool:
        """Have a process born; return whether this is it."""
        role = role_named(settings.role)
        if role is not None and role.kind == "skills" and not settings.played_by and not self._ready:
            self._ready = True
            _load(SKILLS_NEED)
        if len(tuple(Path("/proc/self/task").iterdir())) > 1:
            self._line.send(b"0")
            return False
        told, tell = os.pipe()
        between = os.fork()
        if between == 0:
            between = os.getpid()
            if os.fork():
                os._exit(0)  # its child is the supervisor's from then on
            while os.getppid() == between:
                os.sched_yield()
            os.close(told)
            self._become(settings, log)
            try:
                # Where the supervisor hears nobody any more, nobody may be: it says itself that it is there.
                self._line.send(str(os.getpid()).encode())
            except OSError:
                os._exit(1)
            self._line.close()
            os.write(tell, b"1")
            os.close(tell)
            return True
        os.close(tell)
        os.waitpid(between, 0)
        if not os.read(told, 1):
            self._line.send(b"0")
        os.close(told)
        return False

    def _become(self, settings: WorkerSettings, log: int) -> None:
        os.setsid()
        nothing = os.open(os.devnull, os.O_RDONLY)
        for source, target in ((nothing, 0), (log, 1), (log, 2)):
            os.dup2(source, target)
        os.close(nothing)
        os.close(log)
        show(python("-m", "tandem.executive.system.worker", settings.model_dump_json()))


def _load(modules: tuple[str, ...]) -> None:
    for each in modules:
        try:
            import_module(each)
        except ImportError:
            continue  # of an extra that is not installed: who plays the role says so
    gc.collect()
    gc.freeze()  # a collection would write to all pages, and none would be shared any more


def run() -> None:
    """The entry point."""
    born = Nursery(socket.socket(fileno=os.dup(0))).attend()
    if born:
        worker.run([born])


if __name__ == "__main__":
    run()
