"""What a task's tree asks an operator, and what was answered."""

from __future__ import annotations

from dataclasses import dataclass, field

from tandem.skills.ports.tasks import Question


@dataclass(eq=False)
class Dialogue:
    """One question at a time. The node that asked takes its answer."""

    question: Question | None = None
    """What the tree asks an operator now."""
    answers: dict[str, str] = field(default_factory=dict)
    """What was answered, by the node that asked, until it takes the answer."""
    before: dict[str, str] = field(default_factory=dict)
    """What had been answered before a restart, and not been taken."""
