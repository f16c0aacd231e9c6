"""Who has logged in beyond this host: a word of ``tandem keys link`` becomes a cookie, which ends.

A session ends when its viewer leaves, after some hours, when nobody has used it for long, when its key is
revoked, and with the server: nothing of it is stored.
"""

from __future__ import annotations

import hashlib
import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.security.holders import Holder, KeysError
from tandem.executive.security.links import LASTS, SKEW, LinkError, check, utc, valid
from tandem.executive.security.rights import rights_of
from tandem.executive.web.robot import Who
from tandem.executive.web.throttle import Throttle

COOKIE: Final = "__Host-tandem"
"""Browsers take a cookie of this name from HTTPS only, for this host and no other."""
LONGEST: Final = 12 * 3600.0
"""Seconds of a session: a working day."""
IDLE: Final = 4 * 3600.0
"""Seconds without an order or a page opened after which it ends."""
LOOK_EVERY: Final = 5.0
"""Seconds after which it is looked again whether a key is revoked."""
MOST: Final = 256
"""Sessions at once."""


@dataclass
class _Session:
    holder: Holder
    who: Who
    began: float
    used: float
    looked: float


class Sessions:
    """The sessions of one page.

    Args:
        folder: of keys: the authority's certificate, and the list of holders.
        origin: of the page, such as ``https://robot.example:8447``.
        monotonic: seconds of the host.
        now: UTC seconds.
    """

    def __init__(
        self,
        folder: Path,
        origin: str,
        monotonic: Callable[[], float] = time.monotonic,
        now: Callable[[], float] = utc,
    ) -> None:
        self._folder, self.origin, self._monotonic, self._now = folder, origin, monotonic, now
        self._began = now()
        self._open: dict[str, _Session] = {}
        self._used: dict[str, float] = {}
        self._throttle = Throttle(monotonic)

    def log_in(self, word: str, address: str) -> tuple[str, Who]:
        """Return a session's secret for a word that has not been used; LinkError for any other.

        Args:
            word: as `tandem keys link` prints it.
            address: of the viewer's computer.
        """
        at = self._monotonic()
        closed = self._throttle.closed_to(address)
        if closed:
            raise LinkError(closed)
        try:
            holder, asked = check(word, self._folder, self.origin, self._now())
        except LinkError:
            self._throttle.note(address)
            raise
        if asked.nonce in self._used or asked.made < self._began:
            raise LinkError(
                "this log-in was used, or made before this page was started; "
                "make another one with `tandem keys link`"
            )
        self._used = {each: made for each, made in self._used.items() if self._now() - made < LASTS + SKEW}
        self._used[asked.nonce] = asked.made
        who = Who(holder.name, holder.role, rights_of(holder.role).of(holder.name), remote=True)
        secret = secrets.token_urlsafe(32)
        while len(self._open) >= MOST:
            del self._open[min(self._open, key=lambda each: self._open[each].used)]
        self._open[_hashed(secret)] = _Session(holder, who, at, at, at)
        return secret, who

    def who(self, secret: str, *, uses: bool = True) -> Who | None:
        """Return whose session it is; None: it has ended, or never was.

        Args:
            secret: the cookie's.
            uses: whether this keeps it from ending; what a page does by itself does not.
        """
        name, at = _hashed(secret), self._monotonic()
        session = self._open.get(name)
        if session is None:
            return None
        if at - session.began > LONGEST or at - session.used > IDLE or not self._holds(session, at):
            del self._open[name]
            return None
        if uses:
            session.used = at
        return session.who

    def log_out(self, secret: str) -> None:
        """End a session."""
        self._open.pop(_hashed(secret), None)

    def _holds(self, session: _Session, at: float) -> bool:
        if at - session.looked < LOOK_EVERY:
            return True
        session.looked = at
        try:
            return valid(session.holder, self._folder, self._now())
        except KeysError:
            return False


def _hashed(secret: str) -> str:
    return hashlib.sha256(secret.encode()).hexdigest()
