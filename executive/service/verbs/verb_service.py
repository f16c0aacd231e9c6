"""What clients may ask of a task; each verb is answered at once: taken, or why not."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from tandem.executive.ledger.port import LedgerError
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import Endpoint, answering
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.tasks import ControlAnswer

M = TypeVar("M", bound=Message)


@dataclass(frozen=True)
class Verb(Generic[M]):
    """A verb's service, and who takes it."""

    service: Service[M, ControlAnswer]
    take: Callable[[M], ControlAnswer]


class Verbs:
    """Serves the verbs.

    Args:
        bus: where clients are.
        clocks: host time for rates.
        verbs: all of them.
        keep: has on disk what a verb has changed; called before it is answered.
        more: further endpoints, such as the verbs of named clients.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        verbs: Iterable[Verb[Message]],
        keep: Callable[[], None],
        more: Sequence[Endpoint] = (),
    ) -> None:
        served = [_kept(each.service, each.take, keep) for each in verbs]
        self._endpoints = Endpoints(bus, clocks.monotonic, (*served, *more), fatal=(LedgerError,))

    def step(self) -> bool:
        """Answer who asked; return whether more wait."""
        return self._endpoints.step()

    def close(self) -> None:
        """Stop serving."""
        self._endpoints.close()


def _kept(
    service: Service[Message, ControlAnswer],
    take: Callable[[Message], ControlAnswer],
    keep: Callable[[], None],
) -> Endpoint:
    def answer(asked: Message) -> ControlAnswer:
        taken = take(asked)
        keep()
        return taken

    return answering(service, answer)
