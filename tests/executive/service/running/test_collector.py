"""What the garbage collector has to do with tasks: nothing, while somebody waits for one."""

from __future__ import annotations

import gc
import weakref
from dataclasses import replace

from py_trees.behaviour import Behaviour
from surroundings import WAIT, Surroundings, WaitRequest, build

from tandem.executive.service.running.uncollected import uncollected
from tandem.skills.ports.tasks import TASK_CANCEL, CancelTask
from tandem.trees.context import TreeContext


def test_nothing_is_collected_within_and_what_was_off_stays_off() -> None:
    with uncollected():
        assert not gc.isenabled()
        with uncollected():
            pass
        assert not gc.isenabled()
    assert gc.isenabled()


def test_nothing_is_collected_within_a_step() -> None:
    here = Surroundings()
    found: list[bool] = []

    def watched(request: WaitRequest, context: TreeContext) -> Behaviour:
        found.append(gc.isenabled())
        return build(request, context)

    here.executive._kinds["wait"] = replace(WAIT, build=watched)
    here.ask({"task": "wait", "item": 3})
    assert found == [False]
    assert gc.isenabled()


def test_the_tree_of_an_ended_task_is_freed_without_a_collection() -> None:
    here = Surroundings()
    task = here.ask({"task": "wait", "item": 3}).task
    here.step(3)
    run = here.executive.running
    assert run is not None
    root = weakref.ref(run._root)
    del run
    with uncollected():
        TASK_CANCEL.query(here.bus, CancelTask(task=task))
        here.step(5)
        assert here.executive.running is None
        assert root() is None
