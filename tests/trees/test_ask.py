"""A question to an operator, from the tree to the verb and back."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import TASK_ANSWER, AnswerQuestion, TaskState
from tandem.skills.site import load
from tandem.trees.behaviours.ask import Ask
from tandem.trees.context import TreeContext
from tandem.trees.task import TaskType
from tests.executive.surroundings import Surroundings, WaitRequest, problems

REFUSAL = Failure(kind=FailureKind.HAND_FULL, message="the operator said no")


def ask(context: TreeContext) -> Ask:
    return Ask(
        "may I?", context, "May I go on?", ("yes", "no"), lambda said: REFUSAL if said == "no" else None
    )


def build(_: WaitRequest, context: TreeContext) -> Behaviour:
    return ask(context)


def asking() -> tuple[Surroundings, str]:
    kind = TaskType("wait", "Ask.", WaitRequest, problems, build)
    here = Surroundings(kinds={"wait": kind})
    return here, here.ask({"task": "wait", "item": 29}).task


def test_the_question_is_told_with_the_tasks_status() -> None:
    here, _ = asking()
    told = here.told()[-1]
    assert (told.question.text, told.question.choices, told.running) == (
        "May I go on?",
        ("yes", "no"),
        ("may I?",),
    )
    here.step(500)
    assert here.executive.running is not None, "it waits for as long as it takes"


def test_an_answer_goes_on() -> None:
    here, task = asking()
    assert here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="yes")).accepted
    here.step()
    last = here.told()[-1]
    assert (last.state, last.question) == (TaskState.SUCCEEDED, None)


def test_an_answer_may_mean_a_failure() -> None:
    here, task = asking()
    here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="no"))
    here.step()
    assert here.told()[-1].failure.message == "the operator said no"


def test_only_a_choice_is_an_answer_and_only_once() -> None:
    here, task = asking()
    refused = here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="perhaps"))
    assert refused.reason == "expected one of yes, no; found 'perhaps'"
    here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="yes"))
    assert not here.say(TASK_ANSWER, AnswerQuestion(task=task, answer="yes")).accepted


def test_a_tree_that_turns_to_something_else_asks_no_longer() -> None:
    context = TreeBench(load("lab"), items={}).context
    node = ask(context)
    node.tick_once()
    assert context.dialogue.question is not None
    node.stop(Status.INVALID)
    assert context.dialogue.question is None
