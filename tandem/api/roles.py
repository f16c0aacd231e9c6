"""Roles: processes of your own, with several skills or with nodes that serve none."""

from __future__ import annotations

from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.server import ActionServer

__all__ = ["ActionServer", "Node", "Rights", "RobotDescription", "Role", "Surroundings", "skill_rights"]
