"""The view of a run whose camera sits on a head that the run turns."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.perception.eye import View
from tandem.skills.perception.head import Head


@dataclass
class HeadView(View):
    """A view, and the head."""

    head: Head

    def refresh(self) -> None:
        """Take in where joints, robot and head are."""
        super().refresh()
        self.head.refresh()

    def close(self) -> None:
        """End the subscriptions."""
        super().close()
        self.head.close()
