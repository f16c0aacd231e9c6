"""zenoh's configurations: of a client, and of a router. Nothing is scouted; nobody listens but a router."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Final

import zenoh

from tandem.skills.ports.delivery import LARGE
from tandem.skills.wire.credentials import Credentials

QUEUE: Final = {"data": 16, "data_low": 16}
"""Batches of 64 KiB that may wait for a link, by priority; 16 is zenoh's most. With zenoh's own 2, and each
small message in a batch of its own, 13 of 3,715 messages to a healthy reader were dropped while
pictures passed (2 cores, 470 messages and 5 pictures a second); with 16, none."""
NEVER_WAITS: Final = (
    {"payload_size": f"..{LARGE}", "congestion_control": "drop"},
    {"payload_size": f"{LARGE + 1}..", "congestion_control": "block_first"},
)
"""What the router does with all that passes, whoever sent it: it drops what a reader has no room for. Of
large payloads one at a time may wait for room, beside the others' way."""

SHARED: Final = {"pool_size": 6 * 1024 * 1024, "message_size_threshold": LARGE}
"""Of the memory that processes of a host share: room for three pictures of 640 x 480 with their depth (1.5 MB
each; one for which there is none is copied), and for nothing smaller. zenoh's own is 16 MB for all above
3 KB, which hardware, router and perception each touch to the last byte: 48 MB."""
MOST_AT_ONCE: Final = 64 * 1024 * 1024
"""Bytes of one message that a router takes in; zenoh would keep up to 1 GB of one while its parts come."""

RETRY: Final = {"period_init_ms": 20, "period_max_ms": 4000, "period_increase_factor": 1.5}
"""When a router that does not answer is asked again. zenoh's second try would come after 1 s: who starts
beside its router would wait out its whole patience. Its longest period (4 s) stays."""


def client_config(
    endpoint: str, patience: float = 2.0, credentials: Credentials | None = None, *, pictures: bool = False
) -> zenoh.Config:
    """Return the configuration of a client of the router at ``endpoint``: no scouting, no listening.

    Args:
        endpoint: the router's.
        patience: seconds in which the router must answer.
        credentials: for an endpoint ``tls/...``.
        pictures: whether large payloads go through memory that the processes of a host share. That wakes a
            process 50 times a second for its upkeep, so that only those have it that tell or hear pictures.
    """
    connect = {
        "endpoints": [endpoint],
        "timeout_ms": round(patience * 1000),
        "exit_on_failure": True,
        "retry": RETRY,
    }
    entries = {"mode": "client", "connect": connect, **_shared_memory(pictures=pictures)}
    return _config(entries, credentials)


def router_config(
    *endpoints: str,
    credentials: Credentials | None = None,
    access: str | None = None,
    bounds: str | None = None,
) -> zenoh.Config:
    """Return the configuration of a router that listens at the endpoints and nowhere else.

    Args:
        endpoints: where it listens.
        credentials: for endpoints ``tls/...``; who comes there must show a certificate of the same authority.
        access: zenoh's ``access_control``, as JSON.
        bounds: zenoh's ``low_pass_filter``, as JSON.
    """
    entries: dict[str, object] = {
        "mode": "router",
        **_shared_memory(pictures=True),
        "transport/link/rx/max_message_size": MOST_AT_ONCE,
        "listen": {"endpoints": list(endpoints), "exit_on_failure": True},
    }
    entries["qos/network"] = [
        {
            "messages": ["put", "delete", "query"],
            "flows": ["ingress"],
            "key_exprs": ["**"],
            "payload_size": each["payload_size"],
            "overwrite": {"congestion_control": each["congestion_control"]},
        }
        for each in NEVER_WAITS
    ]
    if access is not None:
        entries["access_control"] = json.loads(access)
    if bounds is not None:
        entries["low_pass_filter"] = json.loads(bounds)
    return _config(entries, credentials)


def _shared_memory(*, pictures: bool) -> dict[str, object]:
    return {
        "transport/shared_memory/enabled": pictures,
        **{f"transport/shared_memory/transport_optimization/{name}": value for name, value in SHARED.items()},
    }


def _config(entries: Mapping[str, object], credentials: Credentials | None) -> zenoh.Config:
    config = zenoh.Config()
    scouting = {"multicast": {"enabled": False}, "gossip": {"enabled": False}}
    everything = {**entries, "scouting": scouting, "transport/link/tx/queue/size": QUEUE}
    if credentials is not None:
        everything["transport/link/tls"] = _tls(credentials)
    for key, value in everything.items():
        config.insert_json5(key, json.dumps(value))
    return config


def _tls(credentials: Credentials) -> dict[str, str | bool]:
    key, certificate = str(credentials.key), str(credentials.certificate)
    return {
        "root_ca_certificate": str(credentials.authority),
        "enable_mtls": True,
        "verify_name_on_connect": True,
        "close_link_on_expiration": True,
        "listen_private_key": key,
        "listen_certificate": certificate,
        "connect_private_key": key,
        "connect_certificate": certificate,
    }
