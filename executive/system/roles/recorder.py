"""The recorder: keeps the last minute, for when something goes wrong. No other process needs it."""

from __future__ import annotations

from typing import Final

from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Stage, process_rights


def _play(stage: Stage) -> None:
    from tandem.executive.records.process import record  # noqa: PLC0415

    record(stage.settings, stage.bus, stage.presence.watch(stage.stopped))


NAME: Final = "recorder"
RIGHTS: Final = process_rights(
    Rights(
        tells=("task/recording", "beat/**", "refused"),
        hears=("hw/**", "world/**", "skill/**", "task/**", "tree/**", "beat/**", "refused"),
        asks=("hw/description", "task/site", "task/info", "task/kinds", "task/timeline"),
        serves=("task/records",),
        hears_site=("world/robots/*",),
    )
)
ROLES = (Role(name=NAME, starts=15, kind="recorder", play=_play, rights=RIGHTS, on_request=True),)
