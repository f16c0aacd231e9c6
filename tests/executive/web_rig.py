"""The page's server over the bus in memory: an executive, and hardware that knows the stop."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field

from starlette.testclient import TestClient
from surroundings import Surroundings

from tandem.executive.client.aio import AsyncClient
from tandem.executive.config.run_options import BusOptions
from tandem.executive.security.rights import rights_of
from tandem.executive.security.role import Role
from tandem.executive.web.app import application
from tandem.executive.web.robot import Ears, Who
from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.actions.perception import PICTURE, AskView
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.hardware import Stop, StopRelease, StopState
from tandem.skills.ports.keys import DESCRIPTION, STOP, STOP_RELEASE, STOP_STATE, Nothing, Service
from tandem.skills.ports.reflex import ReflexState, ReflexSwitch, reflex_switch
from tandem.skills.ports.serving import Endpoints
from tandem.skills.wire.memory import MemoryBus

CAMERA = Service(PICTURE, AskView, Nothing, reads=True, exact=True)
"""Answered with a JPEG."""
AT = "http://127.0.0.1:8447"


class Hardware:
    """What the page asks of the hardware."""

    def __init__(self, here: Surroundings) -> None:
        self.bus, self.state = here.hub.endpoint(), StopState(stopped=False)
        self.description = robot_model("tiago_dual").description
        self.pictures, self.asked_pictures = [b"a jpeg"], 0
        self.obeys = True
        self.endpoints = Endpoints(
            self.bus,
            here.clocks.monotonic,
            (
                answering(STOP, self.stop),
                answering(STOP_RELEASE, self.release),
                answering(DESCRIPTION, lambda _: self.description),
                answering(CAMERA, self.picture),
                answering(reflex_switch("back_off"), self.switch),
            ),
        )

    def stop(self, asked: Stop) -> StopState:
        return self.told(StopState(stopped=True, by=asked.by, reason=asked.reason))

    def release(self, asked: StopRelease) -> StopState:
        return self.told(StopState(stopped=False, by=asked.by, reason=asked.reason))

    def picture(self, asked: AskView) -> bytes:
        self.asked_pictures += 1
        return asked.camera.encode() or self.pictures[-1]

    def switch(self, asked: ReflexSwitch) -> ReflexState:
        return ReflexState(
            reflex="back_off", on=asked.on and self.obeys, by=asked.by, resources=("base",), rank=1,
            holds=False, fired=0, about="backs off",
        )  # fmt: skip

    def told(self, state: StopState) -> StopState:
        self.state = state
        STOP_STATE.publish(self.bus, state)
        return state


@dataclass
class Link:
    """Waiting lets executive and hardware make a step."""

    here: Surroundings
    hardware: Hardware
    served: bool = True

    def __post_init__(self) -> None:
        self.bus: MemoryBus = self.here.hub.endpoint()

    async def wait(self, seconds: float) -> None:
        if self.served:
            self.here.step()
            self.hardware.endpoints.step()
        else:
            self.here.clocks.advance(max(seconds, 1e-3))
        await asyncio.sleep(0)

    async def close(self) -> None:
        self.bus.close()


@dataclass
class Rig:
    """A robot in memory; implements ``Robot``."""

    who: Who = field(default_factory=lambda: Who("anna"))
    options: BusOptions = field(default_factory=BusOptions)

    def __post_init__(self) -> None:
        self.here = Surroundings()
        self.hardware = Hardware(self.here)
        self.link = Link(self.here, self.hardware)
        self.ears: list[MemoryBus] = []
        self.closed: list[MemoryBus] = []

    async def client(self) -> AsyncClient:
        return AsyncClient(link=self.link, monotonic=self.here.clocks.monotonic)

    async def listen(self) -> Ears:
        bus = self.here.hub.endpoint()
        self.ears.append(bus)
        return Ears(bus, lambda: self.closed.append(bus))

    async def close(self) -> None:
        pass

    def page(self) -> TestClient:
        return TestClient(application(self), base_url=AT, headers={"origin": AT})


def of_role(role: Role) -> Who:
    return Who("anna", role, rights_of(role).of("anna"))
