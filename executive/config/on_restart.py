"""What a restart of the executive means to the task that was under way."""

from __future__ import annotations

from typing import Literal

OnRestart = Literal["resume", "ask", "interrupt"]
"""It goes on, an operator is asked, or it ends as INTERRUPTED."""
