"""What a key may be made for: names only, so that a command's help is there at once."""

from __future__ import annotations

from typing import Final, Literal, get_args

Role = Literal["viewer", "requester", "operator", "robot"]
"""What a key is made for."""
ROLES: Final[tuple[Role, ...]] = get_args(Role)
Part = Literal["router", "hardware", "skills", "executive", "supervisor"]
"""A robot has a certificate for each part of it, so that the hardware's can't be used to ask for a task."""
PARTS: Final[tuple[Part, ...]] = get_args(Part)
