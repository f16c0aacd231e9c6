"""What somebody does to the room on purpose: things are taken away, and made anew elsewhere.

Nothing is made inside something else, where the physics would throw both about.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tandem.sim.faults import DepotTaken, ItemGone, ItemMoves, ObstacleAppears
from tandem.sim.scene import GAP, SceneBody, item_body, item_name, obstacle_body, support_height
from tandem.sim.things import FLOOR, BoxShape, Obstacle, TrueItem
from tandem.skills.geometry.poses import about, yaw_of
from tandem.skills.ports.pose import Pose

if TYPE_CHECKING:
    from tandem.sim.body import RobotBody
    from tandem.sim.world import World
    from tandem.skills.ports.site import Site


RoomFault = ItemMoves | ItemGone | ObstacleAppears | DepotTaken


@dataclass(frozen=True)
class Done:
    """What was done to the room, in words, and the body that is to go again in the end."""

    words: str
    made: str = ""


class Room:
    """The bodies of a world, for whoever moves them by hand.

    Args:
        site: heights of furniture, depots, sizes of items.
        world: the bodies.
        robot: before which things are put; nothing is put into it or another robot.
    """

    def __init__(self, site: Site, world: World, robot: RobotBody) -> None:
        self._site, self.world, self.robot = site, world, robot

    def change(self, asked: RoomFault, number: int, item: int | None) -> Done:
        """Do what a fault asks; ``item`` is that of its event.

        Raises:
            KeyError: when there is no such item, slot or furniture.
            ValueError: when something is there already.
        """
        if isinstance(asked, ObstacleAppears):
            name = self._appear(asked)
            return Done(f"{name} is put in the room", made=name)
        if isinstance(asked, DepotTaken):
            name = self._occupy(asked, number)
            return Done(
                f"{name} is put on slot {asked.slot} of {asked.depot}",
                made="" if asked.item is not None else name,
            )
        item = item if asked.item is None else asked.item
        if item is None:
            raise KeyError("no item is meant")
        if isinstance(asked, ItemMoves):
            return Done(f"item {item} is put at {self._move(asked, item)}")
        self.world.remove(self._item(item))
        return Done(f"item {item} is taken away")

    def _move(self, asked: ItemMoves, item: int) -> str:
        name = self._item(item)
        body, pose = self.world.bodies[name], self.world.pose(name)
        x, y, z = pose.position
        if asked.to is None:
            x, y, yaw = x + asked.dx, y + asked.dy, yaw_of(pose.orientation) + asked.dyaw
        else:
            x, y, yaw = asked.to.x, asked.to.y, asked.to.yaw
            z = support_height(self._site, asked.to.support, x, y) + _height(body) / 2 + GAP
        self._put(replace(body, pose=Pose(position=(x, y, z), orientation=about((0, 0, 1), yaw))))
        return f"({x:.2f}, {y:.2f}, {z:.2f})"

    def _appear(self, asked: ObstacleAppears) -> str:
        x, y, yaw = asked.x or 0.0, asked.y or 0.0, asked.yaw
        if asked.ahead is not None:
            x, y, heading = self._ahead(asked.ahead)
            yaw += heading
        if asked.name in self.world.bodies:
            raise ValueError(f"something is called {asked.name} already")
        obstacle = Obstacle(
            name=asked.name,
            shape=asked.shape,
            support=asked.support,
            x=x,
            y=y,
            yaw=yaw,
            mass=asked.mass,
            friction=asked.friction,
            colour=asked.colour,
        )
        self._put(obstacle_body(self._site, obstacle))
        return asked.name

    def _occupy(self, asked: DepotTaken, number: int) -> str:
        depot = self._site.depot(asked.depot)
        if depot is None or asked.slot >= len(depot.slots):
            raise KeyError(f"site {self._site.name} has no slot {asked.slot} of a depot {asked.depot}")
        slot = depot.slots[asked.slot]
        x, y, z = slot.position
        body = self._parcel(asked, number)
        pose = Pose(position=(x, y, z + _height(body) / 2 + GAP), orientation=about((0, 0, 1), slot.facing))
        self._put(replace(body, pose=pose))
        return body.name

    def remove(self, name: str) -> None:
        """Take a body away, if it is still there."""
        if name in self.world.bodies:
            self.world.remove(name)

    def _parcel(self, asked: DepotTaken, number: int) -> SceneBody:
        if asked.item is not None:
            there = self.world.bodies.get(item_name(asked.item))
            return there or item_body(self._site, TrueItem(item=asked.item, support=FLOOR, x=0.0, y=0.0))
        parcel = Obstacle(name=f"parcel_{number}", shape=asked.shape, x=0.0, y=0.0)
        return obstacle_body(self._site, parcel)

    def _ahead(self, way: float) -> tuple[float, float, float]:
        """Return the place so many metres before the base, and the base's heading."""
        (x, y, _), orientation = self.robot.base_pose()
        heading = yaw_of(orientation)
        return x + way * math.cos(heading), y + way * math.sin(heading), heading

    def _item(self, item: int) -> str:
        name = item_name(item)
        if name not in self.world.bodies:
            raise KeyError(f"there is no item {item}")
        return name

    def _put(self, body: SceneBody) -> None:
        """Make the body, or leave all as it was and raise ValueError when something is in its place."""
        old = self.world.bodies.get(body.name)
        if old is not None:
            old = replace(old, pose=self.world.pose(body.name))
        made = self.world.put(body)
        others = {**self.world.names_with_robots(), self.robot.body: "the robot"}
        hit = [name for other, name in others.items() if other != made and self._overlap(made, other)]
        if not hit:
            return
        if old is None:
            self.world.remove(body.name)
        else:
            self.world.put(old)
        raise ValueError(f"no room for {body.name}: {', '.join(hit)} is there")

    def _overlap(self, one: int, other: int) -> bool:
        return self.world.physics.depth(one, other) > GAP


def _height(body: SceneBody) -> float:
    return body.shape.size[2] if isinstance(body.shape, BoxShape) else body.shape.height
