"""Whether the key that is shown allows a question, told before it is asked.

The router enforces the rules: what it does not let through ends without an answer, which looks like an absent
robot. This look at the same table makes it a sentence.
"""

from __future__ import annotations

from typing import Final

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.security.identity import Identity
from tandem.executive.security.rights import Rights, rights_of
from tandem.executive.security.role import Role
from tandem.skills.ports.match import matches
from tandem.skills.ports.tasks import by_client

CLIENTS: Final[tuple[Role, ...]] = ("viewer", "requester", "operator")


def may_ask(rights: Rights, key: str) -> bool:
    """Say whether a question at the key is allowed."""
    return any(matches(expression, key) for expression in rights.asks)


def refuse_unless_allowed(identity: Identity, key: str) -> None:
    """Refuse a question that the router would not pass on.

    Args:
        identity: whose key is shown.
        key: where it would ask.

    Raises:
        CommandError: REFUSED, with the roles that may.
        KeysError: when its certificate can't be read.
    """
    if may_ask(identity.rights(), key):
        return
    name, role = identity.name, identity.role()
    plain = key.replace(by_client(name, "task/"), "task/", 1)
    can = [each for each in CLIENTS if _can(each, name, plain)]
    needed = f"the key of {' or '.join(can)} does" if can else "no client key does"
    raise CommandError(f"the key of {name} ({role}) does not allow {plain}; {needed}", ExitCode.REFUSED)


def _can(role: Role, name: str, plain: str) -> bool:
    rights = rights_of(role).of(name)
    return may_ask(rights, plain) or may_ask(rights, by_client(name, plain))
