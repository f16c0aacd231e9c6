"""The extras of the package: which modules each brings, and what to say where one is missing.

The bare package is a client, the ``tandem`` command and the executive. What else a host needs depends on what
runs there, so it is asked for by name: ``pip install 'tandem-executive[skills]'``.
"""

from __future__ import annotations

import importlib.util
import sys
from dataclasses import dataclass
from typing import Final

PACKAGE: Final = "tandem-executive"
PYBULLET: Final = "pybullet" if sys.version_info < (3, 12) else "pybullet-arm64"
"""Two builds of one library: docs/decisions/006-pybullet-for-newer-pythons.md."""
ALL: Final = "all"
"""The extra that brings all others which a user may need."""


@dataclass(frozen=True)
class Extra:
    """An extra of ``pyproject.toml``: its name, what it is for, and what it installs."""

    name: str
    purpose: str
    packages: tuple[tuple[str, str, str], ...]
    """Distribution, the module by which it is known, and what that is for."""


def command(extra: str) -> str:
    """Return the command that installs an extra."""
    return f"pip install '{PACKAGE}[{extra}]'"


SKILLS: Final = Extra(
    "skills",
    "the processes of skills: perception, base and arms",
    (
        ("numpy", "numpy", "arrays"),
        ("opencv-python-headless", "cv2", "tags in pictures"),
        ("ompl", "ompl", "planning of arm motions"),
        ("pin", "pinocchio", "kinematics"),
        ("coal", "coal", "collision checks"),
        ("daqp", "daqp", "inverse kinematics"),
        ("ruckig", "ruckig", "jerk-limited motion"),
    ),
)
FAST: Final = Extra(
    "fast",
    "quicker planning of arm motions in narrow places",
    (("numba", "numba", "compiles the checks of states"),),
)
SIM: Final = Extra(
    "sim",
    "the simulated robot",
    (
        ("numpy", "numpy", "arrays"),
        ("opencv-python-headless", "cv2", "pictures of the simulated camera"),
        (PYBULLET, "pybullet", "physics"),
    ),
)
OTEL: Final = Extra(
    "otel",
    "traces",
    (
        ("opentelemetry-sdk", "opentelemetry.sdk", "spans"),
        ("opentelemetry-exporter-otlp-proto-http", "opentelemetry.exporter", "the way to a collector"),
    ),
)
WEB: Final = Extra(
    "web",
    "the page",
    (
        ("starlette", "starlette", "its addresses"),
        ("uvicorn", "uvicorn", "its server"),
        ("websockets", "websockets", "what it tells while things happen"),
    ),
)
ROS: Final = Extra(
    "ros",
    "robots that speak ROS 2",
    (("rosbags", "rosbags", "messages of ROS 2"), ("numpy", "numpy", "arrays")),
)
RECORD: Final = Extra(
    "record",
    "recordings as MCAP",
    (
        ("mcap", "mcap", "the file"),
        ("foxglove-sdk", "foxglove", "what its viewer draws by itself"),
    ),
)
LEROBOT: Final = Extra(
    "lerobot",
    "records as data sets that LeRobot reads",
    (
        ("av", "av", "videos"),
        ("numpy", "numpy", "arrays"),
        ("opencv-python-headless", "cv2", "the recorded pictures"),
        ("pyarrow", "pyarrow", "its tables"),
    ),
)
DEV: Final = Extra(
    "dev",
    "Tandem's own tests",
    (("hypothesis", "hypothesis", "invented inputs"), ("jsonschema", "jsonschema", "checks of schemas")),
)
EXTRAS: Final = (SKILLS, FAST, SIM, OTEL, ROS, WEB, RECORD, LEROBOT, DEV)
"""In this order a missing module is looked for."""


def absent(extra: Extra) -> tuple[str, ...]:
    """Return the distributions of an extra that are not installed."""
    return tuple(
        distribution for distribution, module, _ in extra.packages if not _is_there(module.partition(".")[0])
    )


def is_begun(extra: Extra) -> bool:
    """Say whether something is installed that no other extra brings."""
    others = {module for other in EXTRAS if other is not extra for _, module, _ in other.packages}
    own = [module for _, module, _ in extra.packages if module not in others]
    return any(_is_there(module.partition(".")[0]) for module in own)


def _is_there(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def words_on(extra: Extra, wanted_by: str) -> str:
    """Return what to say where an extra is missing; nothing where all of it is there.

    Args:
        extra: what is needed.
        wanted_by: what needs it: ``the role hardware``, ``tandem zones``.
    """
    missing = absent(extra)
    if not missing:
        return ""
    return f"{wanted_by}: {', '.join(missing)} missing; install with {command(extra.name)}"


def words_on_module(error: ModuleNotFoundError, wanted_by: str) -> str:
    """Return what to say of a module that could not be imported; nothing if no extra brings it."""
    name = (error.name or "").partition(".")[0]
    bring = [
        extra for extra in EXTRAS if any(name == module.partition(".")[0] for _, module, _ in extra.packages)
    ]
    if not bring:
        return ""
    if len(bring) == 1:
        return words_on(bring[0], wanted_by)
    brought = " or ".join(extra.name for extra in bring)
    return f"{wanted_by}: {name} missing, of the extra {brought}; install with {command(ALL)}"
