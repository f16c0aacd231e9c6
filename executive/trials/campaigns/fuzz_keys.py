"""What every served key is fuzzed with: documents of its schema, whole and spoiled, none, too much.

The keys are those that the system serves, not a list: a new endpoint is fuzzed from the day that it is there.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Final

from hypothesis import strategies as st
from pydantic import JsonValue

from tandem.executive.interface.entries import all_actions, all_entries
from tandem.executive.trials.campaigns.from_schema import as_json
from tandem.executive.trials.campaigns.fuzz_inputs import ALMOST_JSON, ANY_JSON, Input, documents_of
from tandem.skills.ports.action import goal_service
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message

_ARGUMENT: Final = re.compile(r"<\w+>")
NAMES: Final = ("fuzz", "ann", "", "a.b-c_d", "ü", 'a"b', "a b", "x" * 100)
"""What stands in a key for a ``*``."""
IDS: Final = tuple(f"fuzz/node/{number}" for number in range(1, 6))
"""Ids of goals: a few, so that some are meant again."""
BEYOND: Final = (
    b"",
    b"{}",
    b"[]",
    b"null",
    b"\xff\xfe",
    b"[" * 60_000,
    b'{"a":' * 40 + b"1" + b"}" * 40,
    b'{"by": "' + b"x" * 70_000 + b'"}',
    b"x" * 2_000_000,
    b'{"before": 99999999999999999999, "tick": 1e999, "id": NaN}',
    b'{"by": "a", "by": "b"}',
    b'{"task": "\\ud800"}',
    b'{"task": "\\u0000"}',
)
COSTLY: Final = ("sim/reset", "sim/photograph", "skill/perception/picture")
"""Keys whose right documents take a second and more: they come less often."""


def services() -> tuple[Service[Message, Message], ...]:
    """Return every service of the tables of keys; names in angle brackets stand for any."""
    return tuple(entry for entry in all_entries() if isinstance(entry, Service))


def service_of(key: str, known: Iterable[Service[Message, Message]]) -> Service[Message, Message] | None:
    """Return what the tables of keys say of a key; None when it stands in none."""
    exact = [each for each in known if each.key == key]
    alike = (each for each in known if re.fullmatch(_ARGUMENT.sub("[^/]+", each.key), key))
    # An action's name has a slash.
    wide = (each for each in known if re.fullmatch(_ARGUMENT.sub(".+", each.key), key))
    return next((*exact, *alike, *wide).__iter__(), None)


def inputs_of(keys: Iterable[str]) -> st.SearchStrategy[Input]:
    """Return inputs for the keys, as they are served (``task/by/*/cancel``)."""
    known = services()
    often, seldom = list[st.SearchStrategy[Input]](), list[st.SearchStrategy[Input]]()
    for key in sorted(keys):
        made = st.builds(Input, _asked(key), _payloads(key, service_of(key, known)))
        (seldom if key in COSTLY else often).append(made)
    # Costly ones once in forty times as often as the others.
    choices = [*often * 40, *seldom]
    return st.sampled_from(range(len(choices))).flatmap(lambda index: choices[index])


def _asked(key: str) -> st.SearchStrategy[str]:
    """Return the key itself, mostly; or a selector that stands for it, too."""
    parts = key.split("/")
    selectors = ["**", f"{parts[0]}/**", *("/".join((*parts[:i], "**")) for i in range(1, len(parts)))]
    selectors += ["/".join((*parts[:i], "*", *parts[i + 1 :])) for i in range(len(parts))]
    names = [key.replace("*", name) for name in NAMES] if "*" in key else [key] * 8
    return st.sampled_from([*names, *names, *selectors])


def _payloads(key: str, service: Service[Message, Message] | None) -> st.SearchStrategy[bytes]:
    beyond = st.sampled_from(BEYOND) | ANY_JSON.map(_written) | st.binary(max_size=200) | ALMOST_JSON
    if service is None:
        return beyond
    goals = _goals(key)
    fitting = documents_of(service.asked) if goals is None else goals
    return st.sampled_from((fitting.map(_written), fitting.map(_written), beyond)).flatmap(lambda each: each)


def _goals(key: str) -> st.SearchStrategy[JsonValue] | None:
    """Return goals of the action whose key this is; None for other keys."""
    goals = {goal_service(each.name).key: each.goal for each in all_actions()}
    model = goals.get(key)
    if model is None:
        found = [each for name, each in goals.items() if re.fullmatch(_ARGUMENT.sub("[^/]+", name), key)]
        model = found[0] if found else None
    if model is None:
        return None
    fields: Mapping[str, st.SearchStrategy[JsonValue]] = {
        "goal_id": st.sampled_from(IDS).map(as_json),
        "client": st.just("").map(as_json),
        "goal": documents_of(model),
    }
    return st.fixed_dictionaries(dict(fields)).map(as_json)


def _written(document: object) -> bytes:
    return json.dumps(document).encode()
