"""The process's nodes: look and track are served on the bus, and a worker can be handed its jobs."""

import pickle

import numpy as np
import pytest
from pydantic import JsonValue

from tandem.skills import site
from tandem.skills.perception.clutter import Known
from tandem.skills.perception.jobs import ClutterJob, Shot, TagJob, find_clutter, find_tags
from tandem.skills.perception.process import nodes
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service
from tandem.skills.ports.image import encode
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.wire.workers import InlineCompute
from tests.skills.perception.pictures import Face, picture, tag_at
from tests.skills.perception.stage import DESCRIPTION, Stage

ITEMS = tuple(each for each in site.load("lab").items if each.item == 29)


@pytest.mark.parametrize(
    ("action", "goal"), [("perception/look", {"tilts": [-0.4]}), ("perception/track", {"items": [29]})]
)
def test_look_and_track_are_served(action: str, goal: dict[str, JsonValue]) -> None:
    stage = Stage(lambda _pose, _now: picture((), np.random.default_rng(1)))
    made = nodes(stage.bus, stage.clocks, DESCRIPTION, site.load("lab"), InlineCompute(stage.clocks))
    pending = goal_service(action).query(stage.bus, SendGoal(goal_id="t/see/1", client="", goal=goal))
    for node in made:
        node.step()
    payload = pending.poll()
    assert payload is not None
    assert GoalStatus.model_validate_json(payload).state is GoalState.RUNNING


def test_jobs_and_their_results_survive_the_way_to_a_worker_and_back() -> None:
    image = picture((Face(29, tag_at(1.0, 0.2, 0.4), 0.048),), np.random.default_rng(1), samples=3)
    shot = Shot(encode(image), Pose(), FloorPose(x=0, y=0, yaw=0))
    tags = pickle.loads(pickle.dumps(TagJob(shot, ITEMS)))  # noqa: S301
    clutter = pickle.loads(pickle.dumps(ClutterJob(shot, Known((), ()), (), np.zeros((0, 3)))))  # noqa: S301
    found = find_tags(tags)
    assert [each.item for each in found.sightings] == [29]
    assert pickle.loads(pickle.dumps(found)) == found  # noqa: S301
    find_clutter(clutter)
