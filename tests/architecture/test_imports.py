"""What each process loads, proven by starting it: import contracts can't see what comes in sideways."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

HEAVY = ("numpy", "cv2", "ompl", "pinocchio", "coal", "pybullet", "ruckig", "yaml")
ROOMS = {"executive", "skills", "sim", "trees"}
"""Folders of the repository: what is in them is imported as ``tandem.<room>``."""
CASES = {
    "trees load no vendor but py_trees": ("tandem.trees.registry", "discover()", (*HEAVY, "zenoh")),
    "the executive loads nothing heavy": (
        "tandem.executive.service.executive",
        "Executive",
        tuple(name for name in HEAVY if name != "yaml"),
    ),
    "the executive's loop loads nothing heavy": (
        "tandem.skills.wire.loop",
        "run",
        tuple(name for name in HEAVY if name != "yaml"),
    ),
    "the vocabulary loads pydantic alone": (
        "tandem.skills.ports.tasks",
        "TASK_STATUS",
        (*HEAVY, "zenoh", "py_trees"),
    ),
    "a process loads nothing that keeps records": (
        "tandem.executive.system.worker",
        "main",
        ("prometheus_client", "opentelemetry", *HEAVY[:-1]),
    ),
    "the client loads no tree and nothing heavy": (
        "tandem.executive.client.sync",
        "Client",
        (*HEAVY[:-1], "py_trees"),
    ),
    "the client of asyncio does neither": (
        "tandem.executive.client.aio",
        "AsyncClient",
        (*HEAVY[:-1], "py_trees"),
    ),
    "the base loads no camera and no arm": (
        "tandem.skills.base.process",
        "build",
        ("cv2", "ompl", "pinocchio", "pybullet"),
    ),
    "perception loads no arm": (
        "tandem.skills.perception.process",
        "nodes",
        ("ompl", "pinocchio", "pybullet"),
    ),
}


@pytest.mark.parametrize(("module", "use", "forbidden"), CASES.values(), ids=CASES.keys())
def test_a_process_loads_no_more_than_it_needs(module: str, use: str, forbidden: tuple[str, ...]) -> None:
    program = f"import sys, json, {module} as m; m.{use}; print(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    loaded = {name.split(".")[0] for name in json.loads(done.stdout.splitlines()[-1])}
    assert sorted(loaded & set(forbidden)) == []
    assert sorted(loaded & ROOMS) == [], "a module that is imported under two names exists twice"
