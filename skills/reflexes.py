"""Reflexes: declared in a file each, run beside the owner of their resources (RoCS paper, 4.3 and 5.1).

A reflex looks in every step of its process, before any skill goes on: so it acts in the same step as the
message that makes it fire, whatever the tree does. It takes all of its resources or none, acts until what it
saw has passed, and gives them back.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Final, Generic, Protocol, TypeVar

from pydantic import JsonValue, ValidationError

from tandem.skills.pipeline import Override, Pipeline, take_all
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import in_words, problems_of
from tandem.skills.ports.reflex import (
    PipelineState,
    ReflexState,
    ReflexSwitch,
    pipeline_state,
    reflex_state,
    reflex_switch,
)
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.sources import DocumentError

log = logging.getLogger(__name__)

TOLD_EVERY: Final = 1.0
"""Robot seconds between two messages about a pipeline or a reflex without a change."""

Act = Generator[tuple[str, ...], None, None]
"""A reflex's action: yields what it does, outermost first, once a step, until it is done."""
P = TypeVar("P", bound=Message)
W = TypeVar("W")


class Reflex(Protocol):
    """A reflex at work, for one boot of the hardware."""

    def look(self, *, holds: bool) -> Failure | None:
        """Return what makes it fire now, as a failure with its evidence, or None.

        Args:
            holds: whether it has its resources already: what makes it go on may be less (hysteresis).
        """
        ...

    def act(self) -> Act:
        """Return its action. It is closed when a reflex of a higher rank takes over."""
        ...

    def close(self) -> None:
        """End the subscriptions."""
        ...


@dataclass(frozen=True)
class ReflexType(Generic[W, P]):
    """What a reflex's file declares.

    Args:
        name: of the reflex.
        about: one sentence: what it watches, and what it does.
        resources: what it takes, all of them or none.
        rank: among reflexes; the highest has its way.
        parameters: their model, with what holds where a robot or a site says nothing.
        needs: says what a robot must have for it, and lacks; "" when it has all.
        make: makes it, from its surroundings and its parameters.
        armed: whether it is on where nobody declares it.
        protects: whom or what from what; who switches it off is asked first. Empty: nobody.
    """

    name: str
    about: str
    resources: tuple[str, ...]
    rank: int
    parameters: type[P]
    needs: Callable[[RobotDescription], str]
    make: Callable[[W, P], Reflex]
    armed: bool = True
    protects: str = ""


@dataclass
class Fitted:
    """A reflex with its state in this process."""

    name: str
    about: str
    rank: int
    pipelines: tuple[Pipeline, ...]
    reflex: Reflex
    on: bool = True
    by: str = ""
    declared: bool = True
    protects: str = ""
    fired: int = 0
    act: Act | None = None

    @property
    def holds(self) -> bool:
        """Whether it has its resources."""
        return all(each.has(self.name) for each in self.pipelines)

    @property
    def lost(self) -> bool:
        """Whether a higher one has taken some of them, or all while it was acting."""
        some = any(each.has(self.name) for each in self.pipelines)
        return not self.holds and (some or self.act is not None)


@dataclass(frozen=True)
class Chosen(Generic[W]):
    """A reflex that a robot has, with its parameters."""

    type: ReflexType[W, Any]
    parameters: Message
    on: bool


def chosen(
    types: Sequence[ReflexType[W, Any]],
    robot: RobotDescription,
    resources: Collection[str],
    settings: Sequence[tuple[str, ReflexSetting]],
    *,
    elsewhere: Collection[str] = (),
) -> list[Chosen[W]]:
    """Return the reflexes that a robot has.

    A reflex that nobody declares has its own parameters, and is there where the robot has what it needs.

    Args:
        types: the reflexes there are.
        robot: the robot.
        resources: what may be taken.
        settings: what the robot's description and the site's file declare, each with what to call the place;
            later ones win.
        elsewhere: names that may be declared though no such reflex is among ``types``: other owners', and of
            plug-ins that are left out.

    Raises:
        DocumentError: an unknown reflex, parameters that contradict each other, a resource or a sensor that
            the robot lacks; it names the place and the reason.
    """
    known = [each.name for each in types]
    for where, told in settings:
        if told.reflex not in known and told.reflex not in elsewhere:
            expected = ", ".join([*known, *sorted({*elsewhere} - {*known})])
            raise DocumentError(f"{where}: no reflex {told.reflex!r}; expected one of {expected}")
    found = []
    for each in types:
        declared = [(where, told) for where, told in settings if told.reflex == each.name]
        where, told = declared[-1] if declared else ("", ReflexSetting(reflex=each.name, armed=each.armed))
        missing = each.needs(robot) or "".join(
            f"a resource {resource!r}" for resource in each.resources if resource not in resources
        )
        if missing and not declared:
            continue
        if missing:
            raise DocumentError(f"{where}: reflex {each.name!r} needs {missing}, which this robot lacks")
        found.append(
            Chosen(each, _parameters(each.parameters, where, told.parameters, each.name), told.armed)
        )
    return found


def fitted(choice: Sequence[Chosen[W]], at: W, pipelines: Mapping[str, Pipeline]) -> list[Fitted]:
    """Make reflexes for one boot of the hardware: from what is ``at`` hand, on these pipelines by name."""
    return [
        Fitted(
            each.type.name,
            each.type.about,
            each.type.rank,
            tuple(pipelines[resource] for resource in each.type.resources),
            each.type.make(at, each.parameters),
            on=each.on,
            declared=each.on,
            protects=each.type.protects,
        )
        for each in choice
    ]


def _parameters(model: type[P], where: str, told: Mapping[str, JsonValue], name: str) -> P:
    try:
        return model.model_validate({**model().model_dump(), **told})
    except ValidationError as error:
        raise DocumentError(f"{where}: reflex {name!r}: {in_words(problems_of(error))}") from None


class Reflexes:
    """Runs the reflexes of a process; a ``Node``, stepped before its skills.

    Args:
        bus: where it tells of pipelines and reflexes, and where operators switch these.
        clocks: robot time.
        pipelines: the resources of this process.
        reflexes: in any order.
    """

    name = "reflexes"

    def __init__(
        self, bus: Bus, clocks: Clocks, pipelines: Sequence[Pipeline], reflexes: Sequence[Fitted]
    ) -> None:
        self._bus, self._clocks = bus, clocks
        self._pipelines = tuple(pipelines)
        self._reflexes = tuple(sorted(reflexes, key=lambda each: -each.rank))
        self._endpoints = Endpoints(
            bus,
            clocks.monotonic,
            tuple(
                answering(reflex_switch(each.name), partial(self._switch, each)) for each in self._reflexes
            ),
        )
        self._told_at = -TOLD_EVERY
        self._told: dict[str, object] = {}

    def step(self) -> bool:
        """Look, take what is to be taken, act, give back; highest rank first."""
        waiting = self._endpoints.step()
        for each in self._reflexes:
            try:
                self._go_on(each)
            except Exception:
                # A reflex that is broken must not take those that work with it, nor keep what it has.
                log.exception("reflex %s raised, and is switched off", each.name)
                self._end(each)
                each.on, each.by = False, "its own error"
        self._tell()
        return waiting

    def close(self) -> None:
        """End what acts, and the subscriptions."""
        for each in self._reflexes:
            self._end(each)
            each.reflex.close()
        self._endpoints.close()

    def _go_on(self, each: Fitted) -> None:
        holds = each.holds
        if each.lost:
            self._end(each)
        why = each.reflex.look(holds=holds) if each.on else None
        if why is not None and not holds:
            if not take_all(each.pipelines, Override(each.name, each.rank, why)):
                return
            each.fired += 1
            log.warning("reflex %s fires: %s: %s", each.name, why.kind, why.message)
            each.act, holds = each.reflex.act(), True
        if not holds:
            return
        if each.act is None and why is not None:
            each.act = each.reflex.act()  # it was not enough
        doing = self._acts(each)
        for pipeline in each.pipelines:
            pipeline.doing = doing or ()
        if doing is None and why is None:
            self._end(each)

    def _acts(self, each: Fitted) -> tuple[str, ...] | None:
        """Do a piece of the action; None when it is done."""
        if each.act is None:
            return None
        try:
            return next(each.act)
        except StopIteration:
            each.act = None
            return None

    def _end(self, each: Fitted) -> None:
        act, each.act = each.act, None
        if act is not None:
            act.close()
        if each.holds:
            log.info("reflex %s releases", each.name)
        for pipeline in each.pipelines:
            pipeline.let_go(each.name)

    def _switch(self, each: Fitted, asked: ReflexSwitch) -> ReflexState:
        log.warning("reflex %s is switched %s by %s", each.name, "on" if asked.on else "off", asked.by)
        each.on, each.by = asked.on, asked.by
        if not asked.on:
            self._end(each)
        return self._state(each)

    @staticmethod
    def _state(each: Fitted) -> ReflexState:
        return ReflexState(
            reflex=each.name,
            on=each.on,
            by=each.by,
            declared=each.declared,
            resources=tuple(pipeline.resource for pipeline in each.pipelines),
            rank=each.rank,
            holds=each.holds,
            fired=each.fired,
            about=each.about,
            protects=each.protects,
        )

    def _tell(self) -> None:
        stamp, now = self._clocks.robot(), robot_seconds(self._clocks)
        if stamp is None:
            return
        due = now - self._told_at >= TOLD_EVERY - 1e-6
        if due:
            self._told_at = now
        for pipeline in self._pipelines:
            has = pipeline.override
            has_it = (pipeline.holder, "" if has is None else has.reflex, pipeline.doing)
            if not (self._news(pipeline.resource, has_it) or due):
                continue
            state = PipelineState(
                stamp=stamp,
                resource=pipeline.resource,
                holder=pipeline.holder,
                reflex="" if has is None else has.reflex,
                why=None if has is None else has.why,
                doing=pipeline.doing,
                overridden=pipeline.overridden,
            )
            pipeline_state(pipeline.resource).publish(self._bus, state)
        for each in self._reflexes:
            if (
                self._news(f"reflex {each.name}", (each.on, each.by, each.holds, each.fired, each.about))
                or due
            ):
                reflex_state(each.name).publish(self._bus, self._state(each))

    def _news(self, what: str, state: object) -> bool:
        news = self._told.get(what) != state
        self._told[what] = state
        return news
