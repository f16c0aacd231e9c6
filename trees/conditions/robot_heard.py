"""What a task of the robot's hands or wheels has to wait for before it can begin."""

from __future__ import annotations

from tandem.trees.knowledge import Knowledge


def unheard(knowledge: Knowledge) -> str:
    """Return what has not been heard yet of the robot and no such task can do without; or nothing."""
    missing = knowledge.missing()
    return f"the robot to publish: {', '.join(missing)}" if missing else ""
