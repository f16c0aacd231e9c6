"""``tandem doctor``: what is here and what is missing."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.start import unsupported
from tandem.executive.config.extras import DEV, EXTRAS, PACKAGE, SIM, Extra, absent, command, is_begun
from tandem.executive.config.run_options import BusOptions
from tandem.skills.ports.isolation import isolated, python

BARE: Final = (
    ("eclipse-zenoh", "zenoh", "the bus between processes"),
    ("pydantic", "pydantic", "messages"),
    ("py-trees", "py_trees", "behaviour trees"),
    ("pyyaml", "yaml", "site and scenario files"),
)
"""What every host has: distribution, module, purpose."""
ROBOT_FILE: Final = "package://example-robot-data/robots/tiago_description/robots/tiago_dual.urdf"

LOADED: Final = "eglRenderer loads"
_TRY_EGL: Final = f"""
import importlib.util, pybullet
client = pybullet.connect(pybullet.DIRECT)
spec = importlib.util.find_spec("eglRenderer")
if spec is not None and pybullet.loadPlugin(spec.origin, "_eglRendererPlugin", physicsClientId=client) >= 0:
    print("{LOADED}")
"""


@dataclass(frozen=True)
class Finding:
    """One thing that was looked at. A finding that is not ``good`` is ``vital`` or only worth knowing."""

    subject: str
    good: bool
    text: str
    vital: bool = True


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("doctor")(connects(doctor))


def doctor(
    *,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Check versions, renderer and robot. Exits 1 if something essential is missing."""
    looks: tuple[Callable[[], list[Finding]], ...] = (
        _machine, _packages, _files, _renderer, lambda: _robot(bus),
    )  # fmt: skip
    found: list[Finding] = []
    for look in looks:
        for finding in look():
            found.append(finding)
            sign = "ok     " if finding.good else "MISSING" if finding.vital else "note   "
            if not as_json:
                typer.echo(f"{sign} {finding.subject}: {finding.text}")
    missing = tuple(each.subject for each in found if each.vital and not each.good)
    if as_json:
        _print(found, missing)
    if missing:
        raise CommandError(f"missing: {', '.join(missing)}", ExitCode.TASK_FAILED)


def _print(found: Sequence[Finding], missing: tuple[str, ...]) -> None:
    from tandem.executive.cli.shapes import Findings, Found, print_json  # noqa: PLC0415

    each = tuple(Found(subject=f.subject, good=f.good, vital=f.vital, words=f.text) for f in found)
    print_json(Findings(findings=each, missing=missing))


def _machine() -> list[Finding]:
    python = sys.version.split()[0]
    system = f"{platform.system()} {platform.release()} {platform.machine()}, {os.cpu_count()} cores"
    reason = unsupported((sys.version_info[0], sys.version_info[1]))
    return [
        Finding("python", not reason, reason or python),
        Finding("machine", sys.platform == "linux", system, vital=False),
    ]


def _packages() -> list[Finding]:
    import importlib.util  # noqa: PLC0415

    from tandem.executive.trials.provenance import installed  # noqa: PLC0415

    found = [Finding("tandem", True, installed(PACKAGE) or "not installed, run from its folder")]
    for distribution, module, purpose in BARE:
        there = importlib.util.find_spec(module) is not None
        text = f"{installed(distribution) or 'version unknown'} ({purpose})"
        missing = f"not installed ({purpose}); pip install {PACKAGE}"
        found.append(Finding(distribution, there, text if there else missing))
    found.extend(_extra(extra) for extra in EXTRAS if extra is not DEV)
    if is_begun(SIM):
        found.append(_robot_files())
    return found


def _extra(extra: Extra) -> Finding:
    """Tell of an extra: a host may do without one, but not with half of it."""
    from tandem.executive.trials.provenance import installed  # noqa: PLC0415

    missing = absent(extra)
    if missing:
        which = f"without {', '.join(missing)}" if is_begun(extra) else "not installed"
        text = f"{which} (for {extra.purpose}): {command(extra.name)}"
        return Finding(f"extra {extra.name}", False, text, vital=is_begun(extra))
    versions = ", ".join(
        f"{distribution} {installed(distribution) or 'of an unknown version'}"
        for distribution, _, _ in extra.packages
    )
    return Finding(f"extra {extra.name}", True, versions)


def _robot_files() -> Finding:
    from tandem.executive.trials.provenance import installed  # noqa: PLC0415
    from tandem.skills.ports.packages import resolve  # noqa: PLC0415

    try:
        path = resolve(ROBOT_FILE)
    except FileNotFoundError as error:
        return Finding("example-robot-data", False, str(error))
    return Finding("example-robot-data", True, f"{installed('example-robot-data')} ({path.name})")


def _files() -> list[Finding]:
    from tandem.sim.scenario import scenario_names  # noqa: PLC0415
    from tandem.skills.site import names, plugged  # noqa: PLC0415
    from tandem.trees.registry import discover  # noqa: PLC0415

    parts = (
        ("sites", (*names(), *plugged().found)),
        ("scenarios", scenario_names()),
        ("tasks", tuple(discover())),
    )
    return [Finding(subject, bool(each), ", ".join(each) or "none are installed") for subject, each in parts]


def _renderer() -> list[Finding]:
    """Try the fast renderer where it may crash without harm: in a process of its own."""
    if not is_begun(SIM):
        return []
    import subprocess  # noqa: PLC0415

    try:
        done = subprocess.run(  # noqa: S603 - our own code
            python("-c", _TRY_EGL), env=isolated(), capture_output=True, text=True, timeout=30, check=False
        )
    except subprocess.TimeoutExpired:
        return [Finding("renderer", False, "EGL hangs; TinyRenderer is used, which is slower", vital=False)]
    loaded = done.returncode == 0 and LOADED in done.stdout
    text = "EGL" if loaded else "EGL does not load (Debian: libegl1 libgl1-mesa-dri); TinyRenderer is used"
    return [Finding("renderer", loaded, text, vital=False)]


def _robot(options: BusOptions) -> list[Finding]:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_INFO  # noqa: PLC0415

    found = []
    try:
        with Connection(options) as connection:
            found.append(Finding("router", True, options.endpoint))
            name = connection.robot_name()
            text = (
                f"{name} on {options.prefix}" if name else f"none on {options.prefix}; `tandem up` starts one"
            )
            found.append(Finding("robot", name is not None, text, vital=False))
            info = connection.ask(TASK_INFO, Nothing())
            doing = info.running or "nothing"
            told = (
                f"version {info.version}, running {doing}, {info.queued} queued, "
                f"accepts {', '.join(info.tasks)}"
            )
            found.append(Finding("executive", True, told))
    except CommandError as error:
        found.append(Finding("executive" if found else "router", False, str(error), vital=False))
    return found
