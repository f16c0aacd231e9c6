"""Statistics of features, by which a learner scales them: of an episode, and of all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

QUANTILES: Final = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
"""Those that LeRobot's own statistics have, by their names there."""
Stats = dict[str, list[object]]
Columns = Mapping[str, NDArray[np.generic]]


def of_columns(columns: Columns) -> dict[str, Stats]:
    """Return the statistics of columns with a row for each frame."""
    return {
        name: _rows(np.asarray(rows, np.float64).reshape(len(rows), -1)) for name, rows in columns.items()
    }


def of_pictures(pictures: NDArray[np.uint8]) -> Stats:
    """Return those of pictures (blue, green, red), as shares of full brightness of red, green and blue."""
    pixels = pictures[..., ::-1].reshape(-1, 3).astype(np.float64) / 255.0
    shaped: Stats = {
        name: [[[value]] for value in values] for name, values in _rows(pixels).items() if name != "count"
    }
    return shaped | {"count": [len(pictures)]}


def together(parts: Sequence[Columns]) -> dict[str, NDArray[np.generic]]:
    """Return the columns of several episodes as one."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _rows(rows: NDArray[np.float64]) -> Stats:
    named = {"min": rows.min(0), "max": rows.max(0), "mean": rows.mean(0), "std": rows.std(0)}
    named |= {name: np.quantile(rows, share, axis=0) for name, share in QUANTILES.items()}
    told: Stats = {name: values.tolist() for name, values in named.items()}
    return told | {"count": [len(rows)]}
