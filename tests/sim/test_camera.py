"""The head's camera draws only for listeners, tells when, and the same seed gives the same picture."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from tandem.sim.camera import HeadCamera, Studio
from tandem.sim.render import InlineRenderer, Job, PainterSettings, Renderer, RenderError, WorkerRenderer
from tandem.skills.ports.image import RgbdImage, decode
from tandem.skills.ports.keys import rgbd
from tandem.skills.wire.memory import MemoryBus
from tests.sim.rooms import Room, at


class CountingRenderer(InlineRenderer):
    """Counts what is drawn."""

    drawn = 0

    def request(self, job: Job) -> None:
        self.drawn += 1
        super().request(job)


@pytest.fixture
def renderer(room: Room) -> Iterator[CountingRenderer]:
    made = CountingRenderer(PainterSettings((room.model.physics_urdf,)))
    yield made
    made.close()


def film(
    room: Room, renderer: Renderer, bus: MemoryBus, *, periods: int = 50, seed: int = 1
) -> list[tuple[int, RgbdImage]]:
    """Return the pictures of 10 ms periods, each with the period in which it came."""
    studio = Studio(room.world, (room.robot,), renderer, noise=room.scenario.noise, seed=seed)
    sensor = room.model.description.camera
    camera = HeadCamera(bus, studio, room.robot, sensor, rate=5.0, latency=0.06)
    inbox = bus.subscribe(rgbd("head"))
    pictures = []
    for period in range(periods):
        camera.step(at(period * 0.01))
        pictures += [(period, decode(sample.payload)) for sample in inbox.drain()]
    inbox.close()
    return pictures


def test_nobody_listens_nothing_is_drawn(room: Room, renderer: CountingRenderer) -> None:
    studio = Studio(room.world, (room.robot,), renderer, noise=room.scenario.noise, seed=1)
    camera = HeadCamera(MemoryBus(), studio, room.robot, room.model.description.camera, rate=5.0)
    for period in range(100):
        camera.step(at(period * 0.01))
    assert renderer.drawn == 0


def test_pictures_come_at_their_rate_and_after_their_latency(room: Room, renderer: CountingRenderer) -> None:
    pictures = film(room, renderer, MemoryBus())
    assert [period for period, _ in pictures] == [6, 26, 46]
    assert [image.header.stamp.seconds for _, image in pictures] == pytest.approx([0.0, 0.2, 0.4])


def test_the_same_seed_gives_the_same_picture(room: Room, renderer: CountingRenderer) -> None:
    first = film(room, renderer, MemoryBus(), periods=8)[0][1]
    same = film(room, renderer, MemoryBus(), periods=8)[0][1]
    other = film(room, renderer, MemoryBus(), periods=8, seed=2)[0][1]
    assert np.array_equal(first.colour, same.colour)
    assert np.array_equal(first.depth, same.depth)
    assert not np.array_equal(first.depth, other.depth)


def test_depth_noise_grows_with_the_range(room: Room, renderer: CountingRenderer) -> None:
    images = [image for _, image in film(room, renderer, MemoryBus())]
    difference = images[0].depth.astype(float) - images[1].depth.astype(float)
    near = (images[0].depth > 900) & (images[0].depth < 1300)
    far = images[0].depth > 1500
    assert near.sum() > 1000
    assert far.sum() > 1000
    assert 1.0 < np.median(np.abs(difference[near])) < np.median(np.abs(difference[far])) < 20.0


def test_a_worker_draws_the_same_and_its_death_is_told(room: Room, renderer: CountingRenderer) -> None:
    inline = film(room, renderer, MemoryBus(), periods=8)[0][1]
    worker = WorkerRenderer(PainterSettings((room.model.physics_urdf,)))
    try:
        studio = Studio(room.world, (room.robot,), worker, noise=room.scenario.noise, seed=1)
        bus = MemoryBus()
        inbox = bus.subscribe(rgbd("head"))
        camera = HeadCamera(bus, studio, room.robot, room.model.description.camera, rate=5.0)
        camera.step(at(0.0))
        assert worker._pipe.poll(120.0), "the worker drew nothing"
        camera.step(at(0.1))
        image = decode(inbox.drain()[0].payload)
        assert np.array_equal(image.colour, inline.colour)
        worker._process.kill()
        worker._process.join()
        with pytest.raises(RenderError, match="exit code -9"):
            camera.step(at(0.5))
    finally:
        worker.close()


def test_a_photograph_is_a_png(room: Room, renderer: CountingRenderer) -> None:
    studio = Studio(room.world, (room.robot,), renderer, noise=room.scenario.noise, seed=1)
    png = studio.fetch(studio.order_photograph((-2.8, -2.7, 2.3), (0.0, 0.4, 0.5), 320, 200))
    assert png is not None
    assert png.startswith(b"\x89PNG")
