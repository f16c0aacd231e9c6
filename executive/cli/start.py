"""The entry point of ``tandem``: says at once when this Python is one that Tandem does not run on.

It imports nothing of ours before it knows: elsewhere a missing wheel or module would be told of instead.
"""

from __future__ import annotations

import sys

OLDEST = (3, 11)
"""The first with what the code uses: ``enum.StrEnum``, ``typing.Self``, ``asyncio.timeout``."""
NEWEST = (3, 13)
"""ompl 2.0.1 has no wheel for 3.14: docs/decisions/006-pybullet-for-newer-pythons.md."""
BAD_INPUT = 2
"""``tandem.executive.cli.exit_codes.ExitCode.BAD_INPUT``, which can't be imported yet."""


def unsupported(version: tuple[int, int]) -> str:
    """Return why Tandem does not run on a version of Python and what to do; nothing when it does."""
    if OLDEST <= version <= NEWEST:
        return ""
    oldest, newest, this = (f"{major}.{minor}" for major, minor in (OLDEST, NEWEST, version))
    return (
        f"tandem needs Python {oldest} to {newest}, and this is {this}; "
        f"install it with one of those, for example: make PYTHON=python{newest} setup"
    )


def run() -> None:
    """Run the command, or say why this Python can't."""
    reason = unsupported((sys.version_info[0], sys.version_info[1]))
    if reason:
        sys.stderr.write(f"error: {reason}\n")
        sys.exit(BAD_INPUT)
    from tandem.executive.cli.main import run as run_command  # noqa: PLC0415 - see above

    run_command()
