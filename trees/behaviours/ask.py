"""Ask an operator, and wait for the answer, however long that takes."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.tasks import Question
from tandem.trees.context import TreeContext


class Ask(Behaviour):
    """RUNNING until ``task/answer`` brings one of the choices; then SUCCESS, or FAILURE as ``take`` says.

    A task that is taken up again after a restart asks again, unless the answer came before and was not taken.

    Args:
        name: unique in the tree.
        context: carries question and answer.
        text: the question, as people read it.
        choices: the answers that there are.
        take: given the answer; returns the failure that it means, if any.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        text: str,
        choices: tuple[str, ...],
        take: Callable[[str], Failure | None],
    ) -> None:
        super().__init__(name)
        self._context, self._take = context, take
        self._question = Question(node=name, text=text, choices=choices)

    def initialise(self) -> None:
        """Begin without an answer."""
        self._context.dialogue.answers.pop(self.name, None)

    def update(self) -> Status:
        """Ask when nobody else does; take the answer."""
        before = self._context.dialogue.before.pop(self.name, None)
        answer = self._context.dialogue.answers.pop(self.name, before)
        if answer not in self._question.choices:
            if self._context.dialogue.question is None:
                self._context.dialogue.question = self._question
            self.feedback_message = f"asks: {self._question.text}"
            return Status.RUNNING
        self._withdraw()
        self.feedback_message = f"answered: {answer}"
        failure = self._take(answer)
        if failure is None:
            return Status.SUCCESS
        self._context.failures.add(failure.model_copy(update={"where": self.name}))
        return Status.FAILURE

    def terminate(self, new_status: Status) -> None:
        """Ask no longer when the tree turns to something else."""
        if new_status is Status.INVALID:
            self._withdraw()

    def _withdraw(self) -> None:
        if self._context.dialogue.question is self._question:
            self._context.dialogue.question = None
