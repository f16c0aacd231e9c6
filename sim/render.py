"""Who draws: a painter makes pictures of snapshots, in place (lockstep) or in a process of its own."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import tempfile
from collections import deque
from dataclasses import dataclass, replace
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path
from typing import TYPE_CHECKING, Final, Protocol

import cv2
import numpy as np

from tandem.sim.pixels import SensorNoise
from tandem.sim.render_world import RenderWorld, Snapshot, View
from tandem.sim.scenario import Noise
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import RgbdImage, encode

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

    from tandem.sim.scene import SceneBody

RESULT_BYTES: Final = 24 * 1024 * 1024
"""Shared with the process that draws: colour and depth of 1280 x 720 pixels take 6.5 MB, larger ones more."""
PHOTO_OVERSAMPLING: Final = 2
"""Pixels that are drawn along both axes for one of a photograph, whose edges are smooth then."""
NICENESS: Final = 10
"""Of the process that draws: software rendering takes every core there is, and the physics goes first."""
NO_NOISE: Final = Noise()


class RenderError(RuntimeError):
    """The process that draws has died."""


@dataclass(frozen=True)
class Scene:
    """The bodies there are; ``bodies`` is None where the painter has this revision already."""

    revision: int
    bodies: tuple[SceneBody, ...] | None


@dataclass(frozen=True)
class Job:
    """One picture to be made.

    With a header it is the robot's camera's, noisy, and its result an encoded RgbdImage; without, it is a
    photograph for people, and its result a PNG.
    """

    number: int
    scene: Scene
    snapshot: Snapshot
    view: View
    header: RgbdHeader | None = None
    noise: Noise = NO_NOISE
    noise_key: tuple[int, int] = (0, 0)
    """Seed and frame: which noise it gets."""


@dataclass(frozen=True)
class Done:
    """A finished job."""

    number: int
    payload: bytes


@dataclass(frozen=True)
class PainterSettings:
    """What a painter needs to know once; picklable."""

    urdfs: tuple[str, ...]
    """Of the robots, in the order in which snapshots tell of them."""
    hardware: bool = True


class Renderer(Protocol):
    """Takes jobs and gives pictures, in the order of the jobs."""

    def request(self, job: Job) -> None:
        """Have a picture made."""
        ...

    def poll(self) -> Done | None:
        """Return a finished picture, or None; RenderError when none will ever come."""
        ...

    def close(self) -> None:
        """End it. Closing twice is allowed."""
        ...


class Painter:
    """Draws jobs with a render world; textures live in a temporary folder as long as the painter."""

    def __init__(self, settings: PainterSettings) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="tandem-twin-")
        self._world = RenderWorld(settings.urdfs, Path(self._folder.name), hardware=settings.hardware)
        self._noise = SensorNoise()

    @property
    def renderer(self) -> str:
        """``egl`` or ``tiny``."""
        return self._world.renderer

    def paint(self, job: Job) -> bytes:
        """Return the encoded picture."""
        if job.scene.bodies is not None:
            self._world.set_scene(job.scene.bodies)
        self._world.follow(job.snapshot)
        if job.header is None:
            return self._photograph(job.view)
        picture = self._world.draw(job.view)
        rng = np.random.default_rng(job.noise_key)
        colour, depth = self._noise.apply(picture.colour, picture.depth, job.noise, rng)
        return encode(RgbdImage(header=job.header, colour=colour, depth=depth))

    def close(self) -> None:
        """End the render world and remove its files. Closing twice is allowed."""
        self._world.close()
        self._folder.cleanup()

    def _photograph(self, view: View) -> bytes:
        size = (view.width, view.height)
        large = replace(view, width=size[0] * PHOTO_OVERSAMPLING, height=size[1] * PHOTO_OVERSAMPLING)
        colour = cv2.resize(self._world.draw(large).colour, size, interpolation=cv2.INTER_AREA)
        written, png = cv2.imencode(".png", np.ascontiguousarray(colour[:, :, ::-1]))
        assert written
        return bytes(png.tobytes())


class InlineRenderer:
    """Draws at once, in the caller's thread: for lockstep and tests. The world is made with the first job."""

    def __init__(self, settings: PainterSettings) -> None:
        self._settings = settings
        self._painter: Painter | None = None
        self._done: deque[Done] = deque()

    def request(self, job: Job) -> None:
        """Draw the picture now."""
        if self._painter is None:
            self._painter = Painter(self._settings)
        self._done.append(Done(job.number, self._painter.paint(job)))

    def poll(self) -> Done | None:
        """Return the oldest picture that was not fetched."""
        return self._done.popleft() if self._done else None

    def close(self) -> None:
        """End the painter."""
        if self._painter is not None:
            self._painter.close()
            self._painter = None


class WorkerRenderer:
    """Draws in a process of its own, so that the physics never waits for a picture."""

    def __init__(self, settings: PainterSettings) -> None:
        context = multiprocessing.get_context("spawn")
        self._memory = SharedMemory(create=True, size=RESULT_BYTES)
        self._pipe, far_end = context.Pipe()
        self._process = context.Process(
            target=_work, args=(far_end, self._memory.name, settings), name="tandem-render", daemon=True
        )
        self._process.start()
        far_end.close()
        self._waiting: deque[Job] = deque()
        self._busy = False
        self._closed = False

    @property
    def pid(self) -> int | None:
        """The process's id."""
        return self._process.pid

    def request(self, job: Job) -> None:
        """Have a picture made once those asked for earlier are done."""
        self._waiting.append(job)
        self._send()

    def poll(self) -> Done | None:
        """Return a finished picture, or None.

        Raises:
            RenderError: when the process has died.
        """
        try:
            if not self._pipe.poll():
                return None
            number, size = self._pipe.recv()
        except (EOFError, OSError) as error:
            self._process.join(1.0)
            raise RenderError(f"the renderer ended with exit code {self._process.exitcode}") from error
        payload = bytes(_buffer(self._memory)[:size])
        self._busy = False
        self._send()
        return Done(number, payload)

    def close(self) -> None:
        """End the process and free the memory that is shared with it."""
        if self._closed:
            return
        self._closed = True
        self._pipe.close()
        self._process.join(1.0)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()
        self._memory.close()
        self._memory.unlink()

    def _send(self) -> None:
        if self._waiting and not self._busy:
            with contextlib.suppress(OSError):  # a dead process is told of by poll
                self._pipe.send(self._waiting.popleft())
            self._busy = True


def _buffer(memory: SharedMemory) -> memoryview:
    assert memory.buf is not None
    return memory.buf


def _work(pipe: Connection, memory_name: str, settings: PainterSettings) -> None:
    """Draw what comes through the pipe until its other end is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever started this ends it
    memory = SharedMemory(name=memory_name)
    painter = Painter(settings)
    os.nice(NICENESS)  # from now on: until then everybody waits for it
    try:
        while True:
            job: Job = pipe.recv()
            payload = painter.paint(job)
            _buffer(memory)[: len(payload)] = payload
            pipe.send((job.number, len(payload)))
    except (EOFError, OSError):
        pass
    finally:
        painter.close()
        memory.close()
