"""What every message is: frozen, strict about its fields, free of NaN and infinity."""

from __future__ import annotations

from typing import Final

from pydantic import BaseModel, ConfigDict

Vector3 = tuple[float, float, float]
"""x, y, z in metres (or N, rad/s, ... as the field says)."""

Quaternion = tuple[float, float, float, float]
"""x, y, z, w; of unit length."""

MAX_REQUEST_BYTES: Final = 64 * 1024
"""What a client's document may weigh at the most."""


PLAIN_TEXT: Final = r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029]*$"
"""Text without control characters and line breaks, as a pattern."""


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
