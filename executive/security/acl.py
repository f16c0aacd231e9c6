"""zenoh's access rules, made from who has which key: https://zenoh.io/docs/manual/access-control.

zenoh checks a message where it comes into the router (ingress: the sender's rights) and where it leaves
(egress: the receiver's). It compares certificates' common names as they are, without wildcards; so the rules
are made from the list of those who have been given a key, and made anew when it changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
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


def access_control(
    holders: Iterable[Holder], prefixes: Sequence[str], parts: Mapping[Part, Rights]
) -> AccessControl:
    """Return the rules for all who have a key that holds.

    Clients have their rights at every robot. Of several robots each has the keys of its own name, and its
    parts have rights at that robot only.

    Args:
        holders: who has been given a key.
        prefixes: ``<site>/<robot>`` of each robot behind the router.
        parts: what each part of a robot may do that is a process.
    """
    valid = [holder for holder in holders if not holder.revoked]
    # That somebody listens or serves is told to all: without it a client's session drops what it puts.
    # The names of keys are no secret; what travels on them is.
    rules = [Rule(id="declarations", flows=("egress",), messages=_DECLARATIONS, key_exprs=("**",))]
    policies = []
    for holder in valid:
        own = _rules(holder, _prefixes_of(holder, prefixes), parts)
        rules += own
        policies.append(
            Policy(rules=("declarations", *(rule.id for rule in own)), subjects=(holder.common_name,))
        )
    subjects = tuple(Subject(id=each.common_name, cert_common_names=(each.common_name,)) for each in valid)
    return AccessControl(rules=tuple(rules), subjects=subjects, policies=tuple(policies))


def low_pass_filter(prefixes: Sequence[str]) -> tuple[dict[str, object], ...]:
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

    here = _whole(SMALL_QUERIES, prefixes)
    return (
        bound(["query"], ["**"], ROUTER_LETS_THROUGH_OF_ALL),
        bound(["query"], here, ROUTER_LETS_THROUGH),
        bound(["put"], _whole(PUT_BY_CLIENTS, prefixes), ROUTER_LETS_THROUGH),
        bound(["put"], ["**"], ROUTER_LETS_THROUGH_OF_STREAMS),
    )


def _prefixes_of(holder: Holder, prefixes: Sequence[str]) -> Sequence[str]:
    """Return the robots at which a key has rights: a client's at all, a robot's at its own."""
    if holder.role != "robot" or len(prefixes) == 1:
        return prefixes
    return tuple(each for each in prefixes if each.rpartition("/")[2] == holder.name)


def _rules(holder: Holder, prefixes: Sequence[str], parts: Mapping[Part, Rights]) -> list[Rule]:
    rights: Rights = rights_of(holder.role, holder.part, parts).of(holder.name)
    rules = []
    for verb, keys in rights.model_dump().items():
        whole = _whole_of_site(keys, prefixes) if verb in SITE_VERBS else _whole(keys, prefixes)
        for flow, kinds in MESSAGES[verb].items():
            if whole:
                rule = Rule(
                    id=f"{holder.common_name}/{verb}/{flow}", flows=(flow,), messages=kinds, key_exprs=whole
                )
                rules.append(rule)
    return [*rules, *_kept_rules(holder, rights, prefixes)]


def _whole(keys: Iterable[str], prefixes: Sequence[str]) -> tuple[str, ...]:
    """Return key expressions as they stand in the router, at each robot."""
    return tuple(f"{prefix}/{key}" for key in keys for prefix in prefixes)


def _whole_of_site(keys: Iterable[str], prefixes: Sequence[str]) -> tuple[str, ...]:
    """Return key expressions that all robots of a site share as they stand in the router."""
    found = []
    for key in keys:
        for site, _, robot in (prefix.partition("/") for prefix in prefixes):
            found.append(f"{site}/{key.replace(ROBOT_IN_KEY, robot)}")
    return tuple(dict.fromkeys(found))


def _kept_rules(holder: Holder, rights: Rights, prefixes: Sequence[str]) -> list[Rule]:
    """Return the rules for states that are asked for again: of what one may hear, from who may tell it."""
    every = _whole((f"{KEPT}**",), prefixes)
    tells, hears = (
        _whole((f"{KEPT}{key}" for key in keys), prefixes) for keys in (rights.tells, rights.hears)
    )
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
