"""zenoh's access rules, made from who has which key: https://zenoh.io/docs/manual/access-control.

zenoh checks a message where it comes into the router (ingress: the sender's rights) and where it leaves
(egress: the receiver's). It compares certificates' common names as they are, without wildcards; so the rules
are made from the list of those who have been given a key, and made anew when it changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final, Literal

from tandem.executive.security.holders import Holder
from tandem.executive.security.rights import Rights, rights_of
from tandem.executive.security.role import Part
from tandem.skills.ports.delivery import KEPT
from tandem.skills.ports.keys import TRAJECTORY
from tandem.skills.ports.message import MAX_REQUEST_BYTES, Message

Flow = Literal["ingress", "egress"]
Kind = Literal[
    "put",
    "delete",
    "declare_subscriber",
    "query",
    "reply",
    "declare_queryable",
    "liveliness_token",
    "liveliness_query",
    "declare_liveliness_subscriber",
]


class Rule(Message):
    """Messages of these kinds on these keys may pass."""

    id: str
    permission: Literal["allow"] = "allow"
    flows: tuple[Flow, ...]
    messages: tuple[Kind, ...]
    key_exprs: tuple[str, ...]


class Subject(Message):
    """Who comes with a certificate of this name."""

    id: str
    cert_common_names: tuple[str, ...]


class Policy(Message):
    """Which rules hold for whom."""

    rules: tuple[str, ...]
    subjects: tuple[str, ...]


class AccessControl(Message):
    """zenoh's ``access_control``: what no rule allows is denied."""

    enabled: bool = True
    default_permission: Literal["deny"] = "deny"
    rules: tuple[Rule, ...]
    subjects: tuple[Subject, ...]
    policies: tuple[Policy, ...]


MESSAGES: Final[Mapping[str, Mapping[Flow, tuple[Kind, ...]]]] = {
    "tells": {"ingress": ("put", "delete")},
    "hears": {"ingress": ("declare_subscriber",), "egress": ("put", "delete")},
    "asks": {"ingress": ("query",), "egress": ("reply",)},
    "serves": {"ingress": ("declare_queryable", "reply"), "egress": ("query",)},
    "announces": {"ingress": ("liveliness_token",)},
    "tells_site": {"ingress": ("put",)},
    "hears_site": {"ingress": ("declare_subscriber",), "egress": ("put",)},
    "sees": {
        "ingress": ("declare_liveliness_subscriber", "liveliness_query"),
        "egress": ("liveliness_token", "reply"),
    },
}
"""What each right means in zenoh's messages, as the router sees them."""
ROUTER_LETS_THROUGH: Final = 4 * MAX_REQUEST_BYTES
"""Bytes of a client's document that reach anybody at the most."""
ROUTER_LETS_THROUGH_OF_ALL: Final = 4 * TRAJECTORY.bytes
"""Of any query: the largest documents are trajectories."""
ROUTER_LETS_THROUGH_OF_STREAMS: Final = 64 * 1024 * 1024
"""Of anything that is put: a picture of 3840 x 2160 with its depth has 42 MB."""
SMALL_QUERIES: Final = ("task/**", "tree/**", "world/**", "skill/**", "sim/**", "hw/stop/**", "hw/gripper/**")
"""Keys whose documents are small."""
PUT_BY_CLIENTS: Final = ("task/request", "task/by/**")
SITE_VERBS: Final = ("tells_site", "hears_site")
ROBOT_IN_KEY: Final = "{robot}"
_DECLARATIONS: Final[tuple[Kind, ...]] = ("declare_subscriber", "declare_queryable")


def access_control(holders: Iterable[Holder], prefix: str, parts: Mapping[Part, Rights]) -> AccessControl:
    """Return the rules for all who have a key that holds.

    Args:
        holders: who has been given a key.
        prefix: ``<site>/<robot>`` of the robot.
        parts: what each part of the robot may do that is a process.
    """
    valid = [holder for holder in holders if not holder.revoked]
    # That somebody listens or serves is told to all: without it a client's session drops what it puts.
    # The names of keys are no secret; what travels on them is.
    rules = [Rule(id="declarations", flows=("egress",), messages=_DECLARATIONS, key_exprs=("**",))]
    policies = []
    for holder in valid:
        own = _rules(holder, prefix, parts)
        rules += own
        policies.append(
            Policy(rules=("declarations", *(rule.id for rule in own)), subjects=(holder.common_name,))
        )
    subjects = tuple(Subject(id=each.common_name, cert_common_names=(each.common_name,)) for each in valid)
    return AccessControl(rules=tuple(rules), subjects=subjects, policies=tuple(policies))


def low_pass_filter(prefix: str) -> tuple[dict[str, object], ...]:
    """Return zenoh's bounds on what a message weighs: much heavier ones end at the router.

    Those that are a little too heavy get through, to be told what is wrong with them. Where
    several bounds name a key, the smallest holds. zenoh applies a bound to the messages whose own key
    expression lies within the bound's: a query of ``**`` has the bound of ``**`` alone.
    """

    def bound(messages: list[str], keys: Iterable[str], size: int) -> dict[str, object]:
        return {
            "messages": messages,
            "flows": ["ingress"],
            "key_exprs": [*keys],
            "size_limit": size,
        }

    here = [f"{prefix}/{area}" for area in SMALL_QUERIES]
    return (
        bound(["query"], ["**"], ROUTER_LETS_THROUGH_OF_ALL),
        bound(["query"], here, ROUTER_LETS_THROUGH),
        bound(["put"], [f"{prefix}/{key}" for key in PUT_BY_CLIENTS], ROUTER_LETS_THROUGH),
        bound(["put"], ["**"], ROUTER_LETS_THROUGH_OF_STREAMS),
    )


def _rules(holder: Holder, prefix: str, parts: Mapping[Part, Rights]) -> list[Rule]:
    rights: Rights = rights_of(holder.role, holder.part, parts).of(holder.name)
    rules = []
    for verb, keys in rights.model_dump().items():
        for flow, kinds in MESSAGES[verb].items():
            if keys:
                rule = Rule(
                    id=f"{holder.common_name}/{verb}/{flow}",
                    flows=(flow,),
                    messages=kinds,
                    key_exprs=tuple(_whole(verb, key, prefix) for key in keys),
                )
                rules.append(rule)
    return [*rules, *_kept_rules(holder, rights, prefix)]


def _whole(verb: str, key: str, prefix: str) -> str:
    """Return a right's key expression as it stands in the router."""
    if verb not in SITE_VERBS:
        return f"{prefix}/{key}"
    site, _, robot = prefix.partition("/")
    return f"{site}/{key.replace(ROBOT_IN_KEY, robot)}"


def _kept_rules(holder: Holder, rights: Rights, prefix: str) -> list[Rule]:
    """Return the rules for states that are asked for again: of what one may hear, from who may tell it."""
    every = (f"{prefix}/{KEPT}**",)
    tells, hears = (tuple(f"{prefix}/{KEPT}{key}" for key in keys) for keys in (rights.tells, rights.hears))
    asks: list[tuple[Flow, Kind, tuple[str, ...]]] = [("ingress", "query", hears), ("egress", "reply", hears)]
    serves: list[tuple[Flow, Kind, tuple[str, ...]]] = [
        ("ingress", "declare_queryable", every),
        ("egress", "query", every),
        ("ingress", "reply", tells),
    ]
    rules = (*asks, *serves) if holder.role == "robot" else asks
    return [
        Rule(id=f"{holder.common_name}/kept/{flow}/{kind}", flows=(flow,), messages=(kind,), key_exprs=keys)
        for flow, kind, keys in rules
        if keys
    ]
