"""What earlier releases have written and sent is opened and served by this one."""

from __future__ import annotations

import json
import re
import shutil
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import pytest
import zenoh
from jsonschema import Draft202012Validator
from pydantic import JsonValue

from tandem.executive.interface.schemas import CLIENT_MESSAGES
from tandem.skills.ports.message import read_leniently
from tests.outside._mocked import Mocked
from tests.releases.frozen import SITE, Exchange, Release, releases

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]
LATER: Final = 60.0
"""Seconds after the freeze at which the folder is opened: its tasks have neither expired nor gone."""


@dataclass(frozen=True)
class Opened:
    """A release, and a system that was started on its data folder."""

    release: Release
    system: Mocked

    def ask(self, exchange: Exchange) -> dict[str, JsonValue]:
        """Ask with the bytes of the release."""
        with zenoh.open(self.system._config()) as session:
            (reply,) = session.get(f"{SITE}/mock/{exchange.key}", payload=exchange.asked.encode())
        assert reply.ok is not None, reply.err
        read: dict[str, JsonValue] = json.loads(reply.ok.payload.to_bytes())
        return read


@pytest.fixture(scope="module", params=releases(), ids=lambda path: path.name)
def opened(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Opened]:
    release, folder = Release(request.param), tmp_path_factory.mktemp("kept") / "data"
    shutil.copytree(release.data, folder)
    shift = release.facts.frozen_at + LATER - time.time()
    with Mocked(folder, SITE, shift=shift) as system:
        yield Opened(release, system)


def lenient(schema: JsonValue) -> JsonValue:
    """Return a schema as a reader takes it: fields that it does not know are ignored."""
    if isinstance(schema, list):
        return [lenient(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    return {
        name: lenient(each)
        for name, each in schema.items()
        if not (name == "additionalProperties" and each is False)
    }


def test_a_task_that_was_running_goes_on_and_those_that_waited_run(opened: Opened) -> None:
    facts = opened.release.facts
    assert opened.system.until_state(facts.running) == "SUCCEEDED"
    ends = {opened.system.until_state(task) for task in facts.waiting}
    assert ends <= {"SUCCEEDED", "FAILED"}, ends
    assert opened.system.until_state(facts.waiting[0]) == "SUCCEEDED"


def test_a_task_for_later_still_waits(opened: Opened) -> None:
    assert opened.system.state(opened.release.facts.later) == "QUEUED"


def test_the_history_has_what_had_ended(opened: Opened) -> None:
    told = {each.task: str(each.state) for each in opened.system.client.history().tasks}
    facts = opened.release.facts
    assert {task: told.get(task) for task in facts.ended} == facts.ended


def test_a_document_with_an_id_starts_nothing_new(opened: Opened) -> None:
    with_id = [
        each for each in opened.release.exchanges if '"id":' in each.asked and each.key == "task/request"
    ]
    tasks = [(opened.ask(each)["task"], json.loads(each.answer)["task"]) for each in with_id]
    assert [now for now, _ in tasks] == [before for _, before in tasks]
    assert {before for _, before in tasks} >= set(opened.release.facts.by_client.values())


def test_each_document_is_taken_as_it_was_and_answered_in_its_schema(opened: Opened) -> None:
    wrong: list[str] = []
    for exchange in opened.release.exchanges:
        answer, before = opened.ask(exchange), json.loads(exchange.answer)
        schema = lenient(opened.release.schemas[exchange.schema_name])
        assert isinstance(schema, Mapping)
        wrong += [
            f"{exchange.key}: {error.message}" for error in Draft202012Validator(schema).iter_errors(answer)
        ]
        if exchange.key == "task/request" and answer["accepted"] != before["accepted"]:
            wrong.append(f"{exchange.asked}: {answer}")
    assert wrong == []


def test_the_answers_of_then_are_read_now(opened: Opened) -> None:
    models = {model.__name__: model for model in CLIENT_MESSAGES}
    for exchange in opened.release.exchanges:
        read_leniently(models[exchange.schema_name], exchange.answer.encode())


def test_a_release_is_kept() -> None:
    assert next(path.name for path in releases()) == "v0_1_0"


ASKED: Final = frozenset(
    {"task/request", "tree/now"}
    | {f"task/{verb}" for verb in ("list", "info", "history", "cancel", "pause", "resume", "step", "abandon")}
    | {f"task/{verb}" for verb in ("reprioritise", "answer", "breakpoint", "force")}
)


def test_the_client_asked_everything_that_it_can_ask() -> None:
    assert {exchange.key for exchange in Release(releases()[-1]).exchanges} >= ASKED


def test_the_changelog_dates_the_version_that_is_kept_last() -> None:
    changelog = (Path(__file__).parents[2] / "CHANGELOG.md").read_text("utf-8")
    dated = re.findall(r"^## \[(\d+\.\d+\.\d+)\] - \d{4}-\d{2}-\d{2}$", changelog, re.MULTILINE)
    assert dated[0] == Release(releases()[-1]).facts.version


def test_folders_are_small() -> None:
    for folder in releases():
        assert sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) < 1_500_000
