"""What an operator decides about tasks: how many wait, what a restart does, how long ended ones are kept."""

from __future__ import annotations

from dataclasses import dataclass, field

from tandem.executive.config.on_restart import OnRestart
from tandem.executive.service.intake.client_limits import Bounds
from tandem.executive.service.tasks.task_book import MAX_WAITING


@dataclass(frozen=True)
class Policy:
    """How the service treats tasks."""

    on_restart: OnRestart = "resume"
    """What becomes of a task that was under way, unless its request says so."""
    waiting: int = MAX_WAITING
    """Tasks that may wait."""
    bounds: Bounds = field(default_factory=Bounds)
    """What one client may ask for."""
    keep_tasks: int = 20_000
    """Ended tasks that a lasting ledger keeps ..."""
    keep_days: float = 180.0
    """... and for how long."""
