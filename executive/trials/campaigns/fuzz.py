"""The request interface, fuzzed: whatever is sent is taken or refused with a reason, and nobody falls over.

An executive over the bus in memory gets each input as a query, and must answer within one step. What it takes
is cancelled when the next is taken, so that the queue never fills up. Every answer to a request refuses it
with problems that name a place and what was expected, or takes it and its document is one that the JSON
Schemas take too.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from typing import Final

from jsonschema import Draft202012Validator
from pydantic import JsonValue

from tandem.executive.interface.entries import entries
from tandem.executive.interface.schemas import separate_schemas
from tandem.executive.records.recorder import Recorder
from tandem.executive.records.recording import Facts
from tandem.executive.service.executive import Executive
from tandem.executive.trials.campaigns.fuzz_all import AllCounts
from tandem.executive.trials.campaigns.fuzz_inputs import TASK_HERE, Input, feed_drawn, inputs
from tandem.skills.ports.endpoint import Refusal
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, CancelTask, ControlAnswer, TaskAnswer
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryHub
from tandem.trees.registry import discover

CHUNK: Final = 2000
"""Inputs for one executive, after which there is a new one; hypothesis keeps track of them all."""


class FuzzCounts(Message):
    """What became of the inputs. Also the campaign's report."""

    seed: int
    inputs: int
    accepted: int
    refused: int
    verbs_taken: int
    verbs_refused: int
    answered: int
    """Questions."""
    questions_refused: int
    reasons: dict[str, int]
    """Of refused requests: what was expected, how often; the commonest fifty."""
    everywhere: AllCounts | None = None
    """What became of the inputs at every served key, in a whole system."""
    broken: str = ""
    """The input that was neither taken nor refused, and what happened; empty when there was none."""


class _Deaf:
    """A recorder's ears that hear nothing: here it only answers."""

    def drain(self) -> tuple[()]:
        return ()

    def close(self) -> None: ...


class Target:
    """An executive that is fed one input after the other."""

    def __init__(self) -> None:
        self.kinds, hub = discover(), MemoryHub()
        self.counts: Counter[str] = Counter()
        self.reasons: Counter[str] = Counter()
        self._task = ""  # the last that was taken
        self._clocks, self._bus = SteppedClocks("fuzz"), hub.endpoint()
        self._executive = Executive(hub.endpoint(), self._clocks, load("lab"), self.kinds)
        # A robot that tells who and where it is and then does nothing, so that a task begins and goes on.
        robot = MockRobot(hub.endpoint(), self._clocks, load("lab"), items={}, localised=True)
        facts = Facts(site="lab", robot="tiago", scenario="fuzz", seed=0, release="", began=0.0)
        self._recorder = Recorder(hub.endpoint(), _Deaf(), self._clocks, facts=facts, boxes=None)
        for _ in range(3):
            self._clocks.advance(0.01)
            self._executive.step()
            robot.step()
        self._services = {entry.key: entry for entry in entries()["clients"] if isinstance(entry, Service)}
        self._schema = Draft202012Validator(separate_schemas(self.kinds)["Request"])

    def feed(self, each: Input) -> None:
        """Send it and look at the answer; AssertionError when it is none."""
        payload = each.payload.replace(TASK_HERE.encode(), self._task.encode())
        answer = self._query(each.key, payload)
        if answer is None:
            self.counts["questions_refused"] += 1
            return
        if each.key == REQUEST:
            self._judge_request(payload, TaskAnswer.model_validate_json(answer))
            return
        said = self._services[each.key].decode_answer(answer)
        if not isinstance(said, ControlAnswer):
            self.counts["answered"] += 1
            return
        assert said.accepted or said.reason, "refused without a reason"
        self.counts["verbs_taken" if said.accepted else "verbs_refused"] += 1

    def close(self) -> None:
        """End the executive."""
        self._recorder.close()
        self._executive.close()

    def _judge_request(self, payload: bytes, answer: TaskAnswer) -> None:
        if answer.accepted:
            self.counts["accepted"] += 1
            document: JsonValue = json.loads(payload)
            assert self._schema.is_valid(document), "taken, although the schemas don't take it"
            if answer.task != self._task:
                asked = CancelTask(task=self._task).model_dump_json().encode()
                self._query(TASK_CANCEL.key, asked)
                self._task = answer.task
            return
        self.counts["refused"] += 1
        assert answer.problems, "refused without a problem"
        for problem in answer.problems:
            assert problem.path, "a problem without a place"
            assert problem.expected, "a problem without what was expected"
            self.reasons[problem.expected[:60]] += 1

    def _query(self, key: str, payload: bytes) -> bytes | None:
        pending = self._bus.query(key, payload)
        self._clocks.advance(0.01)
        self._executive.step()
        self._recorder.step()
        refusal = pending.refusal()
        if refusal is not None:
            assert Refusal.model_validate_json(refusal).problems, "refused without a problem"
            return None
        answer = pending.poll()
        assert answer is not None, "no answer"
        return answer


def fuzz(count: int, start: int, say: Callable[[int], None] = lambda _: None) -> FuzzCounts:
    """Feed so many inputs; stop at the first that is neither taken nor refused.

    Args:
        count: how many.
        start: the seed. It draws the same inputs for the same code only: hypothesis also draws from the
            constants of the modules that are loaded.
        say: told how many there have been, now and then.
    """
    fed, counts, reasons = 0, Counter[str](), Counter[str]()
    broken = ""
    while fed < count and not broken:
        target = Target()
        here, broken = _chunk(target, min(CHUNK, count - fed), start + fed)
        fed += here
        counts += target.counts
        reasons += target.reasons
        target.close()
        say(fed)
    return FuzzCounts(
        seed=start,
        inputs=fed,
        accepted=counts["accepted"],
        refused=counts["refused"],
        verbs_taken=counts["verbs_taken"],
        verbs_refused=counts["verbs_refused"],
        answered=counts["answered"],
        questions_refused=counts["questions_refused"],
        reasons=dict(reasons.most_common(50)),
        broken=broken,
    )


def _chunk(target: Target, count: int, start: int) -> tuple[int, str]:
    """Feed one executive; return how many inputs it had, and what went wrong."""
    fed = 0

    def feed(each: Input) -> None:
        nonlocal fed
        fed += 1
        try:
            target.feed(each)
        except Exception as error:
            raise BrokenError(each, error) from error

    try:
        feed_drawn(inputs(target.kinds), count, start, feed)
    except BrokenError as broken:
        return fed, str(broken)
    return fed, ""


class BrokenError(Exception):
    """An input that was neither taken nor refused."""

    def __init__(self, each: Input, error: Exception) -> None:
        super().__init__(f"{each.key} {each.payload!r}: {type(error).__name__}: {error}")
