"""JSON of files, records and other programs, read as Python reads it: it may be large, and has no schema.

It loads nothing else of ours: the command line reads with it before it knows what it is asked.
"""

from __future__ import annotations

import json
from typing import Any


def read_json(text: str | bytes) -> Any:  # noqa: ANN401 - as json.loads: who calls it looks what it is
    """Return what a text says.

    Raises:
        ValueError: whatever is wrong with it; a thousand brackets in one another are no RecursionError here.
    """
    try:
        return json.loads(text)
    except RecursionError as error:
        raise ValueError("more objects and arrays in one another than can be read") from error
