"""What a viewer may ask for, by name: each verb of the typed client, and what its key on the bus is."""

from __future__ import annotations

import json
import uuid
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Final, TypeVar

from pydantic import Field, JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import RefusedError
from tandem.executive.web.robot import Who
from tandem.skills.ports.keys import STOP, STOP_RELEASE
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import reflex_switch
from tandem.skills.ports.reflex_setting import ReflexName
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_STEP,
    AnswerQuestion,
    Breakpoint,
    CancelTask,
    ForceNode,
    NameTask,
    Reprioritise,
    StepTask,
    TaskStatus,
)

A = TypeVar("A", bound=Message)
REQUESTER: Final = "requester"
ASKED_BY: Final = "asked_by"
"""Label of a request that somebody sent who had logged in to the page."""
OF_THE_FIRST: Final = ("id", "by", "not_before", "expires", "retry_of")
"""Fields of a request that belong to that one request: who sent it, and the times that it was meant for."""


class Why(Message):
    """Why the stop is set or released."""

    reason: Annotated[str, Field(max_length=200)] = ""


class SwitchReflex(Message):
    """Which reflex is switched, on or off."""

    reflex: ReflexName
    on: bool


@dataclass(frozen=True)
class Verb:
    """A verb: where it is asked on the bus, and how it is asked, with its document."""

    key: str
    ask: Callable[[AsyncClient, Who, Mapping[str, JsonValue]], Awaitable[JsonValue]]


def _verb(key: str, model: type[A], ask: Callable[[AsyncClient, Who, A], Awaitable[JsonValue]]) -> Verb:
    async def asking(client: AsyncClient, who: Who, document: Mapping[str, JsonValue]) -> JsonValue:
        return await ask(client, who, model.model_validate_json(json.dumps(document)))

    return Verb(key, asking)


async def _stop(client: AsyncClient, who: Who, asked: Why) -> JsonValue:
    state = await client.stop(by=who.name, reason=asked.reason or "the stop on the page")
    return state.model_dump(mode="json")


async def _release(client: AsyncClient, who: Who, asked: Why) -> JsonValue:
    state = await client.release(by=who.name, reason=asked.reason or "released on the page")
    return state.model_dump(mode="json")


async def _retry(client: AsyncClient, who: Who, asked: NameTask) -> JsonValue:
    return await client.submit(in_the_name_of(who, document_of(await client.status(asked.task))))


def in_the_name_of(who: Who, document: dict[str, JsonValue]) -> dict[str, JsonValue]:
    """Return a request that says who asked, if that is not who shows the key to the router."""
    labels = document.get("labels") or {}
    if not who.remote or not isinstance(labels, dict):
        return document
    return {**document, "labels": {**labels, ASKED_BY: who.name}}


def document_of(status: TaskStatus) -> dict[str, JsonValue]:
    """Return the request that repeats that of an ended task.

    Raises:
        RefusedError: when the task has not ended.
    """
    if not status.state.terminal:
        raise RefusedError("retry", status.task, f"it is {status.state}; it has not ended")
    kept = {name: value for name, value in status.request.items() if name not in OF_THE_FIRST}
    return {**kept, "id": uuid.uuid4().hex, "retry_of": status.task}


async def _pause(client: AsyncClient, who: Who, asked: NameTask) -> JsonValue:
    del who
    return await client.pause(asked.task)


async def _resume(client: AsyncClient, who: Who, asked: NameTask) -> JsonValue:
    del who
    return await client.resume(asked.task)


async def _abandon(client: AsyncClient, who: Who, asked: NameTask) -> JsonValue:
    del who
    return await client.abandon(asked.task)


async def _cancel(client: AsyncClient, who: Who, asked: CancelTask) -> JsonValue:
    if who.remote and who.role == REQUESTER:
        labels = (await client.status(asked.task)).request.get("labels")
        if not isinstance(labels, dict) or labels.get(ASKED_BY) != who.name:
            raise RefusedError("cancel", asked.task, f"it is not {who.name}'s; an operator may cancel it")
    return await client.cancel(asked.task)


async def _step(client: AsyncClient, who: Who, asked: StepTask) -> JsonValue:
    del who
    return await client.step(asked.task, by=asked.by)


async def _reprioritise(client: AsyncClient, who: Who, asked: Reprioritise) -> JsonValue:
    del who
    return await client.reprioritise(asked.task, asked.priority)


async def _answer(client: AsyncClient, who: Who, asked: AnswerQuestion) -> JsonValue:
    del who
    return await client.answer(asked.task, asked.answer)


async def _breakpoint(client: AsyncClient, who: Who, asked: Breakpoint) -> JsonValue:
    del who
    return await client.set_breakpoint(asked.task, asked.node, when=asked.when, on=asked.on)


async def _force(client: AsyncClient, who: Who, asked: ForceNode) -> JsonValue:
    del who
    return await client.force(asked.task, asked.node, asked.status)


async def _reflex(client: AsyncClient, who: Who, asked: SwitchReflex) -> JsonValue:
    state = await client.switch_reflex(asked.reflex, on=asked.on, by=who.name)
    if state.on is not asked.on:
        wished, found = ("on", "off") if asked.on else ("off", "on")
        raise RefusedError(f"switch {wished}", asked.reflex, f"the reflex answered, and is still {found}")
    return state.model_dump(mode="json")


VERBS: Final[Mapping[str, Verb]] = MappingProxyType(
    {
        "stop": _verb(STOP.key, Why, _stop),
        "release": _verb(STOP_RELEASE.key, Why, _release),
        "cancel": _verb(TASK_CANCEL.key, CancelTask, _cancel),
        "pause": _verb(TASK_PAUSE.key, NameTask, _pause),
        "resume": _verb(TASK_RESUME.key, NameTask, _resume),
        "step": _verb(TASK_STEP.key, StepTask, _step),
        "abandon": _verb(TASK_ABANDON.key, NameTask, _abandon),
        "reprioritise": _verb(TASK_REPRIORITISE.key, Reprioritise, _reprioritise),
        "answer": _verb(TASK_ANSWER.key, AnswerQuestion, _answer),
        "breakpoint": _verb(TASK_BREAKPOINT.key, Breakpoint, _breakpoint),
        "force": _verb(TASK_FORCE.key, ForceNode, _force),
        "reflex": _verb(reflex_switch("*").key, SwitchReflex, _reflex),
        "retry": _verb(REQUEST, NameTask, _retry),
    }
)
REQUESTING: Final = "request"


def allowed(who: Who) -> tuple[str, ...]:
    """Return the verbs that may be asked in somebody's name; ``request`` among them."""
    requesting = (REQUESTING,) if who.may_ask(REQUEST) else ()
    return (*requesting, *(name for name, verb in VERBS.items() if who.may_ask(verb.key)))
