"""For each clause a driver that breaks it, deliberately."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any, Final

from tandem.skills.ports import keys
from tandem.skills.ports.bus import Bus, Request, Sample
from tandem.skills.ports.picture_header import LENGTH, split
from tandem.skills.wire.memory import MemorySample
from tests.executive.conformance.stands import Driver

Document = dict[str, Any]
ACCEPTED: Final = b'{"accepted": true}'
GOAL: Final = "/goal"


def packed(document: Document) -> bytes:
    return json.dumps(document).encode()


class Telling(Driver):
    """Tells other documents on a key; None: nothing."""

    def __init__(self, key: str, change: Callable[[Document], Document | None]) -> None:
        self._key, self._change = key, change

    def tells(self, key: str, payload: bytes) -> list[bytes]:
        if not key.startswith(self._key):
            return [payload]
        told = self._change(json.loads(payload))
        return [] if told is None else [packed(told)]


class EveryOther(Driver):
    """Tells every other message of a key otherwise; None: not at all."""

    def __init__(self, key: str, change: Callable[[Document], Document | None]) -> None:
        self._key, self._change, self._count = key, change, 0

    def tells(self, key: str, payload: bytes) -> list[bytes]:
        self._count += key == self._key
        if key != self._key or self._count % 2:
            return [payload]
        told = self._change(json.loads(payload))
        return [] if told is None else [packed(told)]


class Answering(Driver):
    """Answers otherwise on keys that end so."""

    def __init__(self, end: str, change: Callable[[Document], Document]) -> None:
        self._end, self._change = end, change

    def answers(self, key: str, payload: bytes) -> bytes:
        return packed(self._change(json.loads(payload))) if key.endswith(self._end) else payload


class Taking(Driver):
    """Carries out another document on keys that end so."""

    def __init__(self, end: str, change: Callable[[Document], Document]) -> None:
        self._end, self._change = end, change

    def takes(self, request: Request) -> bytes | None:
        if not request.key.endswith(self._end) or not request.payload.endswith(b"}"):
            return request.payload
        return packed(self._change(json.loads(request.payload)))


class Ignoring(Driver):
    """Carries out nothing on a key, or only what can be read, and answers all the same, or does not."""

    def __init__(self, end: str, answer: bytes | None, *, unreadable: bool = False) -> None:
        self._end, self._answer, self._unreadable = end, answer, unreadable

    def takes(self, request: Request) -> bytes | None:
        if not request.key.endswith(self._end) or (self._unreadable and request.payload.endswith(b"}")):
            return request.payload
        if self._answer is None:
            request.end()
        else:
            request.reply(self._answer)
        return None


class Pretending(Ignoring):
    """Says that the stop is set, and stops nothing."""

    def __init__(self) -> None:
        super().__init__(keys.STOP.key, b'{"stopped": true}')

    def begin(self, bus: Bus) -> None:
        self._bus = bus

    def takes(self, request: Request) -> bytes | None:
        payload = super().takes(request)
        if payload is None:
            self._bus.publish(keys.STOP_STATE.key, b'{"stopped": true}')
        return payload


class Trusting(Driver):
    """Puts the lease that it granted last in place of one that it should refuse."""

    def __init__(self, refusable: Callable[[Document | None, Document], bool]) -> None:
        self._refusable, self._granted = refusable, {}

    _granted: Document

    def answers(self, key: str, payload: bytes) -> bytes:
        if key == keys.LEASE.key:
            self._granted = json.loads(payload)["lease"]
        return payload

    def takes(self, request: Request) -> bytes | None:
        if not request.key.endswith(GOAL):
            return request.payload
        document = json.loads(request.payload)
        if self._refusable(document["lease"], self._granted):
            document["lease"] = self._granted
        return packed(document)


class Greedy(Driver):
    """Serves groups that the robot does not have."""

    def begin(self, bus: Bus) -> None:
        self._desk = bus.serve(keys.group_goal("*").key)

    def tells(self, key: str, payload: bytes) -> list[bytes]:
        del key
        for request in self._desk.drain():
            request.reply(ACCEPTED)
        return [payload]


class Repeating(Driver):
    """Goes on with the last streamed command when no new one comes; what is asked for moves on with it."""

    def __init__(self, part: str) -> None:
        self._part, self._last = part, None

    _last: Document | None

    def hears(self, key: str, samples: list[Sample]) -> list[Sample]:
        if self._part not in key:
            return samples
        if samples:
            self._last = json.loads(samples[-1].payload)
        elif self._last is not None and "positions" in self._last:
            pairs = zip(self._last["positions"], self._last["velocities"], strict=True)
            self._last = self._last | {"positions": [at + 0.01 * speed for at, speed in pairs]}
        return [] if self._last is None else [MemorySample(key, packed(self._last))]


class Reversing(Driver):
    """Turns the other way."""

    def hears(self, key: str, samples: list[Sample]) -> list[Sample]:
        if key != keys.BASE_VELOCITY.key:
            return samples
        read = [json.loads(each.payload) for each in samples]
        return [MemorySample(key, packed(each | {"angular": -each["angular"]})) for each in read]


class Zooming(Driver):
    """Tells another focal length than its field of view has."""

    def tells(self, key: str, payload: bytes) -> list[bytes]:
        if not key.startswith("hw/camera/"):
            return [payload]
        header, start = split(payload)
        head = header.model_copy(update={"fx": 1.5 * header.fx}).model_dump_json().encode()
        return [LENGTH.pack(len(head)) + head + payload[start:]]


def later(stamp: Document) -> Document:
    return stamp | {"seconds": stamp["seconds"] + 1.0}


def without_last(states: Document) -> Document:
    return {name: value if name == "stamp" else value[:-1] for name, value in states.items()}


def beside(odometry: Document) -> Document:
    pose = odometry["base_in_odom"]
    return odometry | {"base_in_odom": pose | {"x": pose["x"] + 0.5}}


def beyond_limits(description: Document) -> Document:
    *others, last = description["postures"]
    return description | {"postures": [*others, last | {"positions": [99.0] * len(last["positions"])}]}


def blind(description: Document) -> Document:
    return description | {"cameras": [each | {"frame": "nowhere"} for each in description["cameras"]]}


def one_finger(description: Document) -> Document:
    (hand,) = description["end_effectors"]
    gripper = hand["gripper"] | {"joints": hand["gripper"]["joints"][:1]}
    return description | {"end_effectors": [hand | {"gripper": gripper}]}


def of_first_epoch(answer: Document) -> Document:
    return answer | {"lease": answer["lease"] | {"epoch": 1}}


def of_other_boot(answer: Document) -> Document:
    return answer | {"lease": answer["lease"] | {"boot": "other"}}


def half_way(goal: Document) -> Document:
    first, last = goal["points"][0]["positions"], goal["points"][-1]["positions"]
    points = [*goal["points"][:-1], goal["points"][-1] | {"positions": [first[0], *last[1:]]}]
    return goal | {"points": points}


def from_anywhere(goal: Document) -> Document:
    return goal | {"points": [each | {"time": each["time"] + 1.0} for each in goal["points"]]}


def clipped(goal: Document) -> Document:
    """Stop short of any limit: by more than a bad goal lies beyond it."""
    points = [
        each | {"positions": [at - 0.2 * (i > 0 and j == 0) for j, at in enumerate(each["positions"])]}
        for i, each in enumerate(goal["points"])
    ]
    return goal | {"points": points}


def narrow(command: Document) -> Document:
    return command | {"width": 0.5 * command["width"]}


def in_feet(cliffs: Document) -> Document:
    readings = [each | {"distance": each["distance"] / 0.3048} for each in cliffs["readings"]]
    return cliffs | {"readings": readings}


def always(document: Document) -> Document:
    return document | {"accepted": True}


def nothing(_: Document) -> None:
    return None


JOINTS: Final = keys.JOINT_STATES.key
DESCRIPTION: Final = keys.DESCRIPTION.key
DRIVES: Final = "NoArms"
"""The scenario of a robot that has a drive and a laser; the others are tried with the Panda's."""
FALLS: Final = "Locobot"
"""The scenario of a robot with cliff sensors."""
PANDA: Final = "Bench"

WRONG: Final[Mapping[str, tuple[str, Callable[[], Driver]]]] = {
    "description_served": (PANDA, lambda: Ignoring(DESCRIPTION, None)),
    "description_consistent": (PANDA, lambda: Answering(DESCRIPTION, beyond_limits)),
    "urdf_parses": (PANDA, lambda: Answering(DESCRIPTION, lambda d: d | {"urdf": d["urdf"][:-20]})),
    "urdf_holds_parts": (PANDA, lambda: Answering(DESCRIPTION, blind)),
    "clock_ticks": (PANDA, lambda: EveryOther(keys.CLOCK.key, nothing)),
    "one_boot": (PANDA, lambda: Telling(JOINTS, lambda d: d | {"stamp": d["stamp"] | {"boot": "other"}})),
    "stamps_not_in_future": (PANDA, lambda: Telling(JOINTS, lambda d: d | {"stamp": later(d["stamp"])})),
    "messages_readable": (PANDA, lambda: Telling(keys.STOP_STATE.key, lambda d: d | {"stopped": "perhaps"})),
    "joint_states_complete": (PANDA, lambda: Telling(JOINTS, without_last)),
    "joint_positions_within_limits": (
        PANDA,
        lambda: Telling(JOINTS, lambda d: d | {"positions": [99.0, *d["positions"][1:]]}),
    ),
    "joint_states_period": (PANDA, lambda: EveryOther(JOINTS, nothing)),
    "laser_fits": (
        DRIVES,
        lambda: Telling(keys.laser("base").key, lambda d: d | {"ranges": d["ranges"][1:]}),
    ),
    "cliffs_fit": (FALLS, lambda: Telling(keys.CLIFFS.key, in_feet)),
    "camera_fits": (PANDA, Zooming),
    "odometry_continuous": (DRIVES, lambda: EveryOther(keys.ODOMETRY.key, beside)),
    "group_status_told": (PANDA, lambda: Telling("hw/group/", nothing)),
    "gripper_state_told": (PANDA, lambda: Telling("hw/gripper/", lambda d: d | {"width": 1.0})),
    "stop_state_told": (PANDA, lambda: Telling(keys.STOP_STATE.key, nothing)),
    "lease_granted": (PANDA, lambda: Answering(keys.LEASE.key, of_other_boot)),
    "lease_epoch_rises": (PANDA, lambda: Answering(keys.LEASE.key, of_first_epoch)),
    "leases_told": (PANDA, lambda: Telling(keys.LEASES.key, nothing)),
    "no_lease_refused": (PANDA, lambda: Trusting(lambda sent, _: sent is None)),
    "old_lease_refused": (
        PANDA,
        lambda: Trusting(lambda sent, granted: sent is not None and sent["epoch"] < granted["epoch"]),
    ),
    "other_boot_refused": (
        PANDA,
        lambda: Trusting(lambda sent, granted: sent is not None and sent["boot"] != granted["boot"]),
    ),
    "unreadable_answered": (PANDA, lambda: Ignoring(GOAL, None, unreadable=True)),
    "unknown_key_unanswered": (PANDA, Greedy),
    "stop_refuses": (PANDA, lambda: Answering(GOAL, always)),
    "unreadable_stop_stops": (
        PANDA,
        lambda: Ignoring(keys.STOP.key, b'{"stopped": false}', unreadable=True),
    ),
    "stop_released": (PANDA, lambda: Ignoring(keys.STOP_RELEASE.key, b'{"stopped": false}')),
    "trajectory_reaches": (PANDA, lambda: Taking(GOAL, half_way)),
    "cancel_rests": (PANDA, lambda: Ignoring("/cancel", ACCEPTED)),
    "bad_start_refused": (PANDA, lambda: Taking(GOAL, from_anywhere)),
    "beyond_limits_refused": (PANDA, lambda: Taking(GOAL, clipped)),
    "setpoints_hold": (PANDA, lambda: Repeating("/setpoint")),
    "velocity_obeyed": (DRIVES, Reversing),
    "velocity_dead_man": (DRIVES, lambda: Repeating("/velocity")),
    "gripper_moves": (PANDA, lambda: Taking("/command", narrow)),
    "stop_brakes": (PANDA, Pretending),
}
