"""What a clause works with: the bus, what was told so far, and waiting in robot time."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeVar

from pydantic import ValidationError

from tandem.executive.conformance.clause import Broken, Skip, Steps
from tandem.executive.conformance.recording import Recording
from tandem.skills.ports import keys
from tandem.skills.ports.lease import Claim, Lease, LeaseAnswer, LeaseRequest, present_claims
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import in_words, problems_of

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.keys import Service
    from tandem.skills.ports.robot_description import RobotDescription

A = TypeVar("A", bound=Message)
R = TypeVar("R", bound=Message)

ROLE: Final = "hardware_check"
"""The role in which the hardware is commanded here."""
ANSWER_WITHIN: Final = 2.0
"""Host seconds for an answer: a query's usual time-out. What is unanswered is asked three times."""
ASKED: Final = 3
"""Times that an unanswered query is sent: that one is lost is not the hardware's fault."""
HOLDER_GONE_WITHIN: Final = 3.0
"""Host seconds in which the hardware notices that the holder of a lease has gone."""
SILENT_AFTER: Final = 3.0
"""Host seconds without a clock after which nothing can be waited for."""


@dataclass(frozen=True)
class Reply:
    """What came back: an answer, an error, or neither."""

    answer: bytes | None = None
    error: bytes | None = None

    @property
    def nothing(self) -> bool:
        """Whether neither came."""
        return self.answer is None and self.error is None


class Bench:
    """The hardware under test. Whoever runs clauses calls ``step`` whenever time has passed.

    Args:
        bus: the hardware's keys.
        monotonic: host seconds.
        claim: of this process; its generation counts on with each lease.
        may_ask: says whether the key that is shown allows a question.
    """

    def __init__(
        self,
        bus: Bus,
        monotonic: Callable[[], float],
        claim: Claim,
        may_ask: Callable[[str], bool] = lambda _: True,
    ) -> None:
        self.bus, self.recording = bus, Recording(bus)
        self._monotonic, self._claim, self._may_ask = monotonic, claim, may_ask
        self._clock_at = monotonic()
        self._ids = 0
        self._robot: RobotDescription | None = None
        self.lease: Lease | None = None

    @property
    def robot(self) -> RobotDescription:
        """The description; Skip while none was served."""
        if self._robot is None:
            raise Skip("the description is not known")
        return self._robot

    def know(self, robot: RobotDescription) -> None:
        """Take a description for that of the robot."""
        self._robot = robot

    def step(self) -> None:
        """Take in what has come."""
        if self.recording.step():
            self._clock_at = self._monotonic()

    def new_id(self) -> str:
        """Return an id that no goal or command of this run has had."""
        self._ids += 1
        return f"{ROLE}-{self._claim.lineage}-{self._ids}"

    @property
    def host_seconds(self) -> float:
        """The host's monotonic clock."""
        return self._monotonic()

    def until(self, condition: Callable[[], bool], within: float) -> Generator[None, None, bool]:
        """Wait until something is so; False if it is not within so many robot seconds.

        Raises:
            Skip: when the clock is silent.
        """
        end = self.recording.passed + within
        self._clock_at = max(self._clock_at, self._monotonic() - SILENT_AFTER / 2.0)
        while not condition():
            if self.recording.clock is not None and self.recording.passed >= end:
                return False
            if self._monotonic() - self._clock_at > SILENT_AFTER:
                raise Skip(f"{keys.CLOCK.key} is silent: nothing can be waited for")
            yield
        return True

    def pause(self, seconds: float) -> Steps:
        """Let robot seconds pass."""
        yield from self.until(lambda: False, seconds)

    def reply(self, key: str, payload: bytes, *, times: int = ASKED) -> Generator[None, None, Reply]:
        """Ask with any document, readable or not.

        Raises:
            Skip: when the key that is shown does not allow it.
        """
        if not self._may_ask(key):
            raise Skip(f"this key may not ask {key}")
        reply = Reply()
        for _ in range(times):
            pending, end = (
                self.bus.query(key, payload, timeout=ANSWER_WITHIN),
                self._monotonic() + ANSWER_WITHIN,
            )
            while pending.poll() is None and not pending.done() and self._monotonic() < end:
                yield
            reply = Reply(pending.poll(), pending.refusal())
            if not reply.nothing:
                break
            yield
        return reply

    def ask(self, service: Service[A, R], message: A) -> Generator[None, None, R]:
        """Return the answer to a valid document; Broken without a readable one."""
        reply = yield from self.reply(service.key, message.model_dump_json().encode())
        if reply.answer is None:
            found = (
                "none" if reply.error is None else f"the error {reply.error[:200].decode(errors='replace')}"
            )
            raise Broken(f"an answer on {service.key}", found)
        try:
            return service.decode_answer(reply.answer)
        except ValidationError as error:
            wrong = in_words(problems_of(error, most=2))
            raise Broken(f"a valid {service.answered.__name__} on {service.key}", wrong) from error

    def request_lease(self) -> LeaseRequest:
        """Return the request for the present lease."""
        return LeaseRequest(role=ROLE, claim=self._claim.text)

    def leased(self, *, anew: bool = False) -> Generator[None, None, Lease]:
        """Return this process's lease; with ``anew`` the next, as a later process of its parent gets it."""
        if self.lease is not None and not anew:
            return self.lease
        if anew and self.lease is not None:
            before = self._claim
            self._claim = Claim(before.lineage, before.generation + 1, before.pid, before.host)
        began = self._monotonic()
        while True:
            granted: LeaseAnswer = yield from self.ask(keys.LEASE, self.request_lease())
            if granted.lease is not None:
                self.lease = granted.lease
                return granted.lease
            # The check before this one may have ended a moment ago.
            if not granted.holder or self._monotonic() - began > HOLDER_GONE_WITHIN:
                raise Broken(f"a lease of {ROLE}", f"a refusal: {granted.reason}")
            yield

    def others(self) -> tuple[str, ...]:
        """Return the roles of other processes that hold a lease and are there."""
        table, alive = self.recording.latest(keys.LEASES), self.bus.alive()
        held = () if table is None else table.held
        return tuple(each.role for each in held if each.claim in present_claims(alive, each.role))

    def close(self) -> None:
        """Stop listening."""
        self.recording.close()
