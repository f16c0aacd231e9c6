"""The observer: subscribes to everything and serves metrics and traces. No other process needs it."""

from __future__ import annotations

from typing import Final

from tandem.executive.system.roles.role import Role, Stage


def _play(stage: Stage) -> None:
    from tandem.executive.telemetry.process import observe  # noqa: PLC0415

    observe(stage.settings, stage.bus, stage.presence.watch(stage.stopped))


NAME: Final = "observer"
ROLES = (Role(name=NAME, starts=90, kind="observer", play=_play, on_request=True),)
