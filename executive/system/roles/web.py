"""The page: an ordinary client of the executive, in a process of its own. No other process needs it."""

from __future__ import annotations

from typing import Final

from tandem.executive.config.extras import WEB
from tandem.executive.system.roles.role import Role, Stage


def _play(stage: Stage) -> None:
    from tandem.executive.web.process import show_page  # noqa: PLC0415

    show_page(stage.settings, stage.bus, stage.presence.watch(stage.stopped))


NAME: Final = "web"
ROLES = (Role(name=NAME, starts=95, kind="observer", extra=WEB, play=_play, on_request=True),)
