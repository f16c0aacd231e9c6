"""What is heard of the robot, as updates for the page. Each ``poll`` tells what is new since the last."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final, TypeVar

from pydantic import JsonValue

from tandem.executive.web.occupied import OccupiedSpace
from tandem.executive.web.others import Others
from tandem.executive.web.trees import State, TreeEar, TreeNews
from tandem.executive.web.viewers import Update, merge
from tandem.skills.ports.action import GoalState, GoalStatus, status_topic
from tandem.skills.ports.actions.arm import move
from tandem.skills.ports.actions.base import DRIVE
from tandem.skills.ports.bus import Bus, Commons
from tandem.skills.ports.hardware import Clock, JointStates
from tandem.skills.ports.keys import CLOCK, JOINT_STATES, STOP_STATE, Latest, laser
from tandem.skills.ports.message import Message
from tandem.skills.ports.records import TASK_RECORDING
from tandem.skills.ports.reflex import before_off, pipeline_state, reflex_state
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import LaserScan
from tandem.skills.ports.tasks import (
    TASK_PULSE,
    TASK_STATUS,
    TaskState,
    TaskStatus,
    TreeSnapshot,
)
from tandem.skills.ports.world import PEOPLE, ROBOT_POSE, SCENE, SIGHTINGS, WORLD, People, Sightings

M = TypeVar("M", bound=Message)
EXECUTIVE: Final = "executive"
TICK: Final = 0.05
"""Host seconds between two polls."""
STILL: Final = 0.0005
"""Radians or metres by which a joint must have moved to be told."""
LASER_EVERY: Final = 5
"""Polls between two scans, and between two words on the people that they show."""
SECOND: Final = 20
"""Polls in a second."""
UNTOLD: Final = frozenset({"nodes", "tree", "joints", "lasers"})
"""Parts that are not kept as they were told."""
KEPT: Final = 200
"""Tasks that are told to who opens the page."""


class Feed:
    """Hears the bus for as long as somebody looks on.

    Args:
        bus: an end of its own, closed by its owner.
        monotonic: seconds of the host.
        commons: where the robots of the site tell where they are; None: there is no such place.
        own: the robot's own name among them.
        age: seconds by which what they told grows old; None: those of the host.
    """

    def __init__(
        self,
        bus: Bus,
        monotonic: Callable[[], float],
        commons: Commons | None = None,
        own: str = "",
        *,
        age: Callable[[], float] | None = None,
    ) -> None:
        self._bus, self._monotonic = bus, monotonic
        self._others = Others(commons, monotonic if age is None else age, own)
        self._space = OccupiedSpace(monotonic)
        self._clock = Latest(bus, CLOCK, depth=1)
        self._joints = Latest(bus, JOINT_STATES, depth=1)
        self._pose = Latest(bus, ROBOT_POSE, depth=1)
        self._stop = Latest(bus, STOP_STATE, depth=4)
        self._recording = Latest(bus, TASK_RECORDING, depth=1)
        self._people = Latest(bus, PEOPLE, depth=1)
        self._scene = Latest(bus, SCENE, depth=1)
        self._world = Latest(bus, WORLD, depth=1)
        self._pulse = Latest(bus, TASK_PULSE, depth=1)
        self._statuses = Latest(bus, TASK_STATUS, depth=1024)
        self._trees = TreeEar(bus)
        self._reflexes = Latest(bus, reflex_state("*"), depth=4)
        self._pipelines = Latest(bus, pipeline_state("*"), depth=4)
        self._sightings = Latest(bus, SIGHTINGS, depth=16)
        self._drive = Latest(bus, status_topic(DRIVE.name), depth=4)
        self._lasers: dict[str, Latest[LaserScan]] = {}
        self._arms: dict[str, Latest[GoalStatus]] = {}
        self._told: Update = {}
        self._asked: TreeSnapshot | None = None
        """As the executive answered, before one was heard."""
        self._shape: tuple[str, ...] = ()
        self._nodes: dict[str, State] = {}
        self._sent_joints: dict[str, float] = {}
        self._versions: dict[str, object] = {}
        self._polls = 0
        self._heard_at: float | None = None

    def describe(self, robot: RobotDescription) -> None:
        """Learn which sensors and hands the robot has."""
        for hand in robot.end_effectors:
            if hand.group not in self._arms:
                self._arms[hand.group] = Latest(self._bus, status_topic(move(hand.group).name), depth=4)
        for sensor in robot.lasers:
            if sensor.name not in self._lasers:
                self._lasers[sensor.name] = Latest(self._bus, laser(sensor.name), depth=1)

    def whole(self) -> Update:
        """Return all that is known, for who has just come."""
        last = self._trees.last() or self._asked
        tree = {} if last is None else {"tree": _plain(last)}
        return {**self._told, **tree, "joints": dict(self._sent_joints), "whole": True}

    @property
    def executive_there(self) -> bool:
        """Whether an executive is announced."""
        return EXECUTIVE in self._bus.alive()

    def know(self, tasks: Iterable[TaskStatus], tree: TreeSnapshot | None) -> Update:
        """Take in what was there before, as the executive says; return what is new of it."""
        update: Update = {"tasks": {each.task: _plain(each) for each in tasks}}
        if tree is not None:
            self._asked = tree
            tree = self._later(tree)
            self._trees.forget()  # what differs from the last one heard is not what differs from this
            self._tree(TreeNews(head=tree, whole=True), update)
        self._note(update)
        return update

    def poll(self) -> Update:
        """Return what is new."""
        update: Update = {}
        self._polls += 1
        self._time(update)
        self._motion(update)
        self._beliefs(update)
        self._plans_and_tags(update)
        for name, told in self._others.take().items():
            self._if_new_of("robots", name, told, update)
        if self._space.due():
            update["occupied"] = self._space.take()
        for status in self._statuses.take():
            merge(update, {"tasks": {status.task: _plain(status)}})
        tree = self._trees.take()  # a node's ``last`` says what happened since the one before
        if tree is not None:
            self._tree(tree, update)
        there = self.executive_there
        if self._versions.get("executive") is not there:
            self._versions["executive"] = there
            update["executive"] = there
        self._note(update)
        return update

    def close(self) -> None:
        """Stop hearing."""
        for heard in (
            self._clock, self._joints, self._pose, self._stop, self._people, self._scene, self._world,
            self._pulse, self._statuses, self._trees, self._reflexes, self._pipelines, self._sightings,
            self._drive, self._recording,
        ):  # fmt: skip
            heard.close()
        for scans in self._lasers.values():
            scans.close()
        for moves in self._arms.values():
            moves.close()
        self._others.close()

    def _time(self, update: Update) -> None:
        clock: Clock | None = self._fresh(self._clock)
        if clock is not None:
            self._heard_at = self._monotonic()
        if self._polls % SECOND == 1 or (clock is not None and self._polls % (SECOND // 4) == 0):
            value = self._clock.value
            silent = None if self._heard_at is None else round(self._monotonic() - self._heard_at, 1)
            stamp = {"boot": "", "seconds": None} if value is None else _plain(value.stamp)
            update["now"] = {**stamp, "silent": silent}

    def _motion(self, update: Update) -> None:
        joints: JointStates | None = self._fresh(self._joints)
        if joints is not None:
            moved = {
                name: round(position, 4)
                for name, position in zip(joints.names, joints.positions, strict=True)
                if abs(position - self._sent_joints.get(name, 1e9)) > STILL
            }
            if moved:
                self._sent_joints |= moved
                update["joints"] = dict(moved)
        pose = self._fresh(self._pose)
        if pose is not None:
            told = pose.model_dump(mode="json", include={"localised", "moving", "reason", "position_sigma"})
            at = pose.base_in_map
            told |= {"x": round(at.x, 3), "y": round(at.y, 3), "yaw": round(at.yaw, 4)}
            told["position_sigma"] = round(pose.position_sigma, 3)
            self._if_new("pose", told, update)
        if self._polls % LASER_EVERY == 0:
            for name, heard in self._lasers.items():
                scan = self._fresh(heard)
                if scan is not None:
                    merge(update, {"lasers": {name: [round(each, 2) for each in scan.ranges]}})
            people = self._fresh(self._people)
            if people is not None:
                self._if_new("people", _persons(people), update)

    def _beliefs(self, update: Update) -> None:
        scene = self._fresh(self._scene)
        if scene is not None:
            self._space.hear(scene.occupied)
            scene = scene.model_copy(update={"occupied": None})
        news: Mapping[str, Message | None] = {
            "stop": self._fresh(self._stop),
            "recording": self._fresh(self._recording),
            "pulse": self._fresh(self._pulse),
            "scene": scene,
            "world": self._fresh(self._world),
        }
        for part, message in news.items():
            if message is not None:
                plain = _plain(message)
                plain.pop("stamp", None)  # it is new each time
                plain.pop("version", None)
                self._if_new(part, plain, update)
        for reflex in self._reflexes.take():
            told = {**_plain(reflex), "asks": before_off(reflex)}
            self._if_new_of("reflexes", reflex.reflex, told, update)
        for pipeline in self._pipelines.take():
            plain = _plain(pipeline)
            plain.pop("stamp", None)
            self._if_new_of("pipelines", pipeline.resource, plain, update)

    def _plans_and_tags(self, update: Update) -> None:
        """Tell the ways that are planned while base and arms move, and the last tags that were seen."""
        drive = self._fresh(self._drive)
        if drive is not None:
            self._if_new("plan", _way(drive), update)
        for group, heard in self._arms.items():
            moves = self._fresh(heard)
            if moves is not None:
                self._if_new_of("hands", group, _way(moves), update)
        seen = [each for each in self._sightings.take() if each.sightings]
        if seen:
            update["tags"] = _tags(seen[-1])

    def _tree(self, news: TreeNews, update: Update) -> None:
        """Tell the nodes that have changed; of a tree with other nodes the whole."""
        tree = news.head
        self._if_new("board", dict(tree.board), update)
        self._if_new("gates", tree.model_dump(mode="json", include={"breakpoints", "forced"}), update)
        changed = news.changed
        if news.whole:
            nodes: dict[str, list[JsonValue]] = {
                node.path: [str(node.status), str(node.last), node.message] for node in tree.root.walk()
            }
            shape = (tree.task, *nodes)
            if shape != self._shape or "tree" in update:
                self._shape, self._nodes = shape, nodes
                update.pop("nodes", None)
                update["tree"] = _plain(tree)
                return
            changed = {path: state for path, state in nodes.items() if self._nodes.get(path) != state}
        if changed:
            self._nodes |= changed
            merge(update, {"nodes": dict(changed)})

    def _later(self, asked: TreeSnapshot) -> TreeSnapshot:
        """Return the tree that was asked for, or that of its task which was heard since it was answered."""
        heard = self._trees.last()
        if heard is None or heard.task != asked.task or heard.stamp is None or asked.stamp is None:
            return asked
        return heard if heard.stamp.is_after(asked.stamp) else asked

    def _fresh(self, heard: Latest[M]) -> M | None:
        """Return the newest message if one has come since the last poll."""
        before = heard.value
        now = heard.refresh()
        return None if now is before else now

    def _if_new(self, part: str, value: JsonValue, update: Update) -> None:
        if self._versions.get(part) != value:
            self._versions[part] = value
            update[part] = value

    def _if_new_of(self, part: str, name: str, value: JsonValue, update: Update) -> None:
        if self._versions.get(f"{part}/{name}") != value:
            self._versions[f"{part}/{name}"] = value
            merge(update, {part: {name: value}})

    def _note(self, update: Update) -> None:
        merge(self._told, {part: value for part, value in update.items() if part not in UNTOLD})
        tasks = self._told.get("tasks")
        if isinstance(tasks, dict) and len(tasks) > 2 * KEPT:
            newest = dict(list(tasks.items())[-KEPT:])
            open_ = {task: told for task, told in tasks.items() if _is_open(told)}  # however long it waits
            self._told["tasks"] = {**open_, **newest}


def _is_open(told: JsonValue) -> bool:
    return isinstance(told, dict) and not TaskState(str(told["state"])).terminal


def _plain(message: Message) -> dict[str, JsonValue]:
    plain: dict[str, JsonValue] = message.model_dump(mode="json")
    return plain


def _way(status: GoalStatus) -> JsonValue:
    """Return the way that an action's feedback has; none when it has ended."""
    moves = status.state in {GoalState.RUNNING, GoalState.PAUSED}
    return (status.feedback or {}).get("way", []) if moves else []


def _persons(people: People) -> dict[str, JsonValue]:
    """Return where each person is and goes, by number: x, y, vx, vy, radius."""
    return {
        str(each.id): [round(value, 2) for value in (each.x, each.y, each.vx, each.vy, each.radius)]
        for each in people.people
    }


def _tags(seen: Sightings) -> dict[str, JsonValue]:
    return {
        "stamp": _plain(seen.stamp),
        "seen": [
            {"item": each.item, "distance": round(each.distance, 2), "tag": _plain(each.tag_in_camera)}
            for each in seen.sightings
        ],
    }
