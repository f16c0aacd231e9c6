"""What ``tandem up`` opens to whom: endpoints, keys, and which processes run here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from tandem.executive.cli.arguments import TLS
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.addresses import is_endpoint
from tandem.executive.config.extras import Extra, words_on
from tandem.executive.config.run_options import BusOptions
from tandem.executive.security.holders import KeysError
from tandem.executive.security.identity import Identity, refuse_other_hosts, robot_in
from tandem.skills.ports.plugins import UNTRIED
from tandem.skills.wire.endpoints import is_loopback


def owner_of(bus: BusOptions, robots: Sequence[str] = (), *, by_environment: bool = False) -> BusOptions:
    """Return the options with the robot whose keys the processes show; of several, those of the first.

    Args:
        bus: names the robot, or nobody where the folder has keys of one robot only.
        robots: several robots of a scenario, each of which has the keys of its own name.
        by_environment: whether TANDEM_AS names the holder; the name of a client there is none of ours.

    Raises:
        CommandError: when the folder has no such robot.
    """
    if bus.keys is None:
        return bus
    others = by_environment and (bool(robots) or (bus.keys / f"{bus.holder}.pem").exists())
    named = "" if others else bus.holder
    if robots and named:
        each = ", ".join(robots)
        raise CommandError(
            f"--as {named}: the robots {each} show the keys of their own names; leave out --as"
        )
    try:
        found = [robot_in(bus.keys, name) for name in robots or (named,)]
    except KeysError as error:
        raise CommandError(str(error)) from error
    return replace(bus, holder=found[0].name)


def checked_endpoints(bus: BusOptions, listen: Sequence[str], *, insecure: bool) -> tuple[str, ...]:
    """Return where the router listens besides its own endpoint.

    Raises:
        CommandError: for what is no endpoint, for one beyond this host without TLS and keys, and for a host
            that the router's certificate is not for.
    """
    for endpoint in (bus.endpoint, *listen):
        if not is_endpoint(endpoint):
            raise CommandError(f"expected an endpoint tls/HOST:PORT; found {endpoint!r}")
        if endpoint.startswith(TLS) and bus.keys is None:
            raise CommandError(f"{endpoint}: TLS needs keys; give their folder with --keys")
        if not insecure and not endpoint.startswith(TLS) and not (is_loopback(endpoint) and bus.keys is None):
            raise CommandError(
                f"{endpoint}: anyone who can connect could move the robot; "
                "listen on tls/HOST:PORT with --keys, or pass --insecure"
            )
    try:
        if bus.keys is not None:
            encrypted = [each for each in (bus.endpoint, *listen) if each.startswith(TLS)]
            refuse_other_hosts(Identity(bus.keys, bus.holder), encrypted)
    except KeysError as error:
        raise CommandError(str(error)) from error
    return tuple(listen)


def checked_roles(only: str | None, left_out: Mapping[str, str] = UNTRIED) -> tuple[str, ...]:
    """Return the roles named, in the order in which they are started; none when none is named.

    Args:
        only: names, with commas between them.
        left_out: plug-ins that can't be loaded.

    Raises:
        CommandError: naming those that there are.
    """
    from tandem.executive.system.roles.registry import known_names, role_named  # noqa: PLC0415 - as `--help` is quick

    if only is None:
        return ()
    found = []
    for name in dict.fromkeys(each.strip() for each in only.split(",")):
        role = role_named(name, left_out)
        if role is None:
            raise CommandError(f"--only: expected some of {', '.join(known_names(left_out))}; found {name!r}")
        found.append(role)
    return tuple(role.name for role in sorted(found, key=lambda each: each.starts))


def refuse_without_extras(roles: Sequence[str]) -> None:
    """Say which extras the roles need that are not installed, before anything is started.

    Args:
        roles: their names; none: all that ship and are started without being asked for.

    Raises:
        CommandError: naming role, packages and the command that installs them.
    """
    from tandem.executive.system.roles.registry import role_named, shipped  # noqa: PLC0415 - as `--help` is quick

    wanted: dict[Extra, list[str]] = {}
    every = [name for name, role in shipped().items() if not role.on_request]
    for name in roles or every:
        role = role_named(name)
        if role is not None and role.extra is not None:
            wanted.setdefault(role.extra, []).append(name)
    lacks = [
        words_on(extra, f"the role {named[0]}" if len(named) == 1 else f"the roles {', '.join(named)}")
        for extra, named in wanted.items()
    ]
    if any(lacks):
        raise CommandError("\n".join(line for line in lacks if line))
