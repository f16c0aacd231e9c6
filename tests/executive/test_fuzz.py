"""Whatever is sent, it is either taken or refused with a reason, and the answer can be sent."""

from __future__ import annotations

import json

from hypothesis import given, settings
from hypothesis import strategies as st

from executive.requests import Asked, Refused, read_request
from skills.ports.tasks import TaskAnswer
from skills.site import load
from trees.registry import discover

SITE, KINDS = load("lab"), discover()
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)
FIELDS = st.sampled_from(["task", "item", "to", "arm", "id", "extra"])
NEAR = st.dictionaries(FIELDS, JSON | st.sampled_from(["fetch", 29, "depot", "left"]))


def answered(payload: bytes) -> None:
    result = read_request(payload, KINDS, SITE)
    if isinstance(result, Refused):
        assert result.problems
        problems = result.problems
        TaskAnswer(accepted=False, problems=problems, client_id=result.client_id).model_dump_json()
    else:
        assert isinstance(result, Asked)
        json.dumps(result.document, allow_nan=False).encode()


@given(st.binary(max_size=200))
@settings(max_examples=500, deadline=None)
def test_any_bytes(payload: bytes) -> None:
    answered(payload)


@given(NEAR)
@settings(max_examples=1000, deadline=None)
def test_documents_that_are_almost_requests(document: dict[str, object]) -> None:
    answered(json.dumps(document).encode())


@given(st.text(alphabet='{}[]",:\\u0d8 1e9-NaN', max_size=60))
@settings(max_examples=500, deadline=None)
def test_text_that_is_almost_json(text: str) -> None:
    answered(text.encode())
