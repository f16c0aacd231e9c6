"""The router of a system: listens, lets through what the rules allow, and begins anew when the rules change.

zenoh reads its access rules once, when a session is opened. So a key that is revoked costs a new session, as
would a cable that is pulled and put back; meanwhile the robot stands. Whoever holds the key is out at once.
"""

from __future__ import annotations

import json
import logging
from pathlib import Path
from typing import Final

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.security.acl import access_control, low_pass_filter
from tandem.executive.security.holders import LIST, KeysError, read_holders
from tandem.executive.system.roles.registry import rights_of_parts
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.linger import close_at_once
from tandem.skills.wire.zenoh_bus import BusError, RouterSession

LINGER_EVERY: Final = 10
"""Steps between two looks at the connections; ten are a second in the router's process. A reader that stands
still is given up after ten seconds."""

_LOG = logging.getLogger(__name__)


class Router:
    """A session that routes. Call ``step`` now and then.

    Args:
        settings: where it listens, and the folder of keys.
        credentials: the router's own; None: no TLS, and everybody may do everything.

    Raises:
        RefusalError: when nothing can listen there, or the keys are not as they must be.
    """

    def __init__(self, settings: WorkerSettings, credentials: Credentials | None) -> None:
        self._settings, self._credentials = settings, credentials
        self._endpoints = tuple(dict.fromkeys((settings.endpoint, *settings.listen)))
        self._list = None if settings.keys is None else Path(settings.keys) / LIST
        self._prefixes = settings.prefixes or (settings.prefix,)
        self._known = self._version()
        self._session = self._open()
        self._steps = 0

    def step(self) -> None:
        """Begin anew when somebody has been given a key, or has lost one; keep connections from lingering."""
        self._steps += 1
        if self._steps % LINGER_EVERY == 0:
            close_at_once()
        version = self._version()
        if version == self._known:
            return
        try:
            access = self._access()
        except KeysError:
            _LOG.exception("cannot read the list of keys; the access rules stay as they are")
            self._known = version
            return
        self._known = version
        _LOG.warning("the list of keys has changed: restarting the router")
        self._session.close()
        self._session = self._open(access)

    def close(self) -> None:
        """End the session."""
        self._session.close()

    def _open(self, access: str | None = None) -> RouterSession:
        try:
            config = router_config(
                *self._endpoints,
                credentials=self._credentials,
                access=access or self._access(),
                bounds=json.dumps(low_pass_filter(self._prefixes)),
            )
            return RouterSession(config, self._endpoints)
        except KeysError as error:
            raise RefusalError(str(error)) from error
        except BusError as error:
            places = ", ".join(self._endpoints)
            raise RefusalError(f"cannot listen on {places}: is another router running?") from error

    def _access(self) -> str | None:
        if self._list is None:
            return None
        holders = read_holders(self._list.parent).holders
        parts = rights_of_parts(self._settings.left_out)
        return access_control(holders, self._prefixes, parts).model_dump_json()

    def _version(self) -> tuple[int, int]:
        """Return what changes with the list: who replaces a file gives it another inode."""
        if self._list is None:
            return (0, 0)
        try:
            found = self._list.stat()
        except OSError:
            return (0, 0)
        return (found.st_mtime_ns, found.st_ino)
