"""What a run did to the room is seen although nothing of it is left at the end."""

from __future__ import annotations

from dataclasses import replace

import pybullet

from tandem.sim.disturbances import Disturbances
from tandem.skills.ports.pose import FloorPose
from tests.sim.rooms import MakeRoom, Room

PERIOD = 0.01


def watch(room: Room, seconds: float, seen: Disturbances, begin: float = 0.0) -> None:
    for tick in range(round(seconds / PERIOD)):
        room.physics.step(3)
        seen.step(begin + tick * PERIOD)


def push(room: Room, name: str, velocity: tuple[float, float, float]) -> None:
    pybullet.resetBaseVelocity(room.world.id_of(name), velocity, physicsClientId=room.physics.client)


def spin(room: Room, name: str) -> None:
    pybullet.resetBaseVelocity(
        room.world.id_of(name), (0.0, 0.0, 1.0), (0.0, 12.0, 0.0), physicsClientId=room.physics.client
    )


def watching(room: Room, item: int = 29) -> Disturbances:
    return Disturbances(room.world, room.robot, item)


def test_a_quiet_room_is_undisturbed(room: Room) -> None:
    seen = watching(room)
    watch(room, 1.0, seen)
    assert (seen.shifts(), seen.touches()) == ((), ())


def test_a_push_of_two_centimetres_is_seen_and_one_of_the_item_asked_for_is_not(room: Room) -> None:
    seen = watching(room)
    watch(room, 0.1, seen)
    for name in ("mug", "item_29"):
        push(room, name, (0.6, 0.0, 0.0))
    watch(room, 0.5, seen, 0.1)
    (shift,) = seen.shifts()
    assert shift.name == "mug"
    assert 0.01 < shift.metres < 0.1
    assert shift.at >= 0.1
    assert not shift.robots_doing


def test_a_thing_that_comes_back_has_been_moved(room: Room) -> None:
    """Both ways of a push: where it lies in the end says nothing."""
    seen = watching(room)
    watch(room, 0.1, seen)
    before = room.world.pose("mug").position[0]
    push(room, "mug", (0.7, 0.0, 0.0))
    watch(room, 0.5, seen, 0.1)
    push(room, "mug", (-0.7, 0.0, 0.0))
    watch(room, 0.5, seen, 0.6)
    assert abs(room.world.pose("mug").position[0] - before) < 0.01
    assert [shift.name for shift in seen.shifts()] == ["mug"]


def test_a_thing_that_falls_over_is_said_to_fall(room: Room) -> None:
    seen = watching(room)
    watch(room, 0.1, seen)
    spin(room, "file_box")
    watch(room, 1.0, seen, 0.1)
    assert any("file_box falls over" in str(shift) for shift in seen.shifts())


def test_what_a_person_puts_elsewhere_is_watched_from_there(room: Room) -> None:
    seen = watching(room)
    watch(room, 0.1, seen)
    body = room.world.bodies["mug"]
    room.world.put(replace(body, pose=body.pose.model_copy(update={"position": (0.7, 0.3, 0.7605)})))
    watch(room, 0.3, seen, 0.1)
    assert seen.shifts() == ()
    push(room, "mug", (0.6, 0.0, 0.0))
    watch(room, 0.5, seen, 0.4)
    assert [shift.name for shift in seen.shifts()] == ["mug"]


def test_a_robot_that_stands_in_furniture_is_named_with_its_link(make_room: MakeRoom) -> None:
    room = make_room(start=FloorPose(x=0.43, y=-0.15, yaw=0.0))
    seen = watching(room)
    watch(room, 0.2, seen)
    assert "table.1" in {touch.what for touch in seen.touches()}
    assert all(touch.force > 0.0 for touch in seen.touches())
    assert seen.touches()[0].link in room.robot.link_index


def test_what_the_robot_touches_for_one_physics_step_is_its_doing(room: Room) -> None:
    """The parcel is put into the base, which throws it out at once: no contact is left after a period."""
    seen = watching(room)
    watch(room, 0.1, seen)
    body = room.world.bodies["left_parcel"]
    x, y, _ = room.robot.base_pose()[0]
    within = body.pose.model_copy(update={"position": (x + 0.3, y, body.pose.position[2])})
    room.world.put(replace(body, pose=within))
    watch(room, 0.3, seen, 0.1)
    (shift,) = seen.shifts()
    assert (shift.name, shift.robots_doing) == ("left_parcel", True)
    assert "untouched" not in str(shift)
