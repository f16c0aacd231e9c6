"""What every message is: frozen, strict about its fields, free of NaN and infinity."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import BaseModel, ConfigDict, Field

LARGEST: Final = 1e6
"""No length, angle, speed or force of a robot is larger, in its SI unit. Beyond it sums and products of what
was heard lose their digits, and then become infinite."""

Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
"""A length, angle, speed, force, ... in SI units, as a robot or a sensor tells it."""

Vector3 = tuple[Number, Number, Number]
"""x, y, z in metres (or N, rad/s, ... as the field says)."""

Quaternion = tuple[float, float, float, float]
"""x, y, z, w; of unit length."""

MAX_REQUEST_BYTES: Final = 64 * 1024
"""What a client's document may weigh at the most."""


class Message(BaseModel):
    """Base of all that crosses the bus or stands in a file."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class RobotTime(Message):
    """A moment on the robot's clock.

    ``boot`` names the start of the hardware that counts the seconds: two times of different boots
    can't be compared.
    """

    boot: str
    seconds: float
