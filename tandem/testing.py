"""Test a task's tree without a robot: ``TreeBench`` ticks it against mocked skills, in milliseconds."""

from __future__ import annotations

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.site import load as load_site
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault

__all__ = ["Fault", "MockRobot", "TreeBench", "load_site"]
