"""``python -m tandem``: the same as the command ``tandem``."""

from __future__ import annotations

from tandem.executive.cli.start import run

run()
