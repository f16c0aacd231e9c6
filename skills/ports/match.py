"""Key expressions: ``*`` is one part of a key, ``**`` any number of parts (as in zenoh)."""

from __future__ import annotations


def matches(expression: str, key: str) -> bool:
    """Say whether the key is one of those that the expression stands for."""
    if expression == key:
        return True
    return "*" in expression and _parts(expression.split("/"), key.split("/"))


def _parts(expression: list[str], key: list[str]) -> bool:
    if not expression:
        return not key
    head, rest = expression[0], expression[1:]
    if head == "**":
        return any(_parts(rest, key[i:]) for i in range(len(key) + 1))
    return bool(key) and head in {"*", key[0]} and _parts(rest, key[1:])


def intersects(one: str, other: str) -> bool:
    """Say whether there is a key that both expressions stand for."""
    return one == other or _meet(one.split("/"), other.split("/"))


def _meet(one: list[str], other: list[str]) -> bool:
    if not one or not other:
        return all(part == "**" for part in (*one, *other))
    if one[0] == "**":
        return any(_meet(one[1:], other[i:]) for i in range(len(other) + 1))
    if other[0] == "**":
        return _meet(other, one)
    return (one[0] == other[0] or "*" in {one[0], other[0]}) and _meet(one[1:], other[1:])
