"""Parquet files of a data set: frames, episodes, and the texts that frames name by number."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Final

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

from tandem.executive.records.lerobot.layout import ACTION, DATA, DATA_MB, NUMBERS, STATE, Features, Place

_TEXT: Final = {"pandas_type": "unicode", "numpy_type": "object", "metadata": None}
_NUMBER: Final = {"pandas_type": "int64", "numpy_type": "int64", "metadata": None}
"""What pandas writes of a column of text and one of whole numbers: with it pandas reads an index back as
one."""


def frames_schema(features: Features) -> pa.Schema:
    """Return the columns of the frames; pictures have none, they stand in the videos."""
    vectors = ((STATE, len(features.state)), (ACTION, len(features.action)))
    fields = [pa.field(name, pa.list_(pa.float32(), width)) for name, width in vectors]
    fields += [pa.field(name, _type(kind)) for name, kind in NUMBERS.items()]
    return pa.schema(fields)


def _type(kind: str) -> pa.DataType:
    return pa.bool_() if kind == "bool" else pa.type_for_alias(kind)


class FrameFiles:
    """The frames, in files one after the other; each episode is a row group.

    Args:
        root: of the data set.
        features: of its frames.
        file_mb: megabytes after which the next file begins.
    """

    def __init__(self, root: Path, features: Features, *, file_mb: float = DATA_MB) -> None:
        self._root, self._schema, self._bytes = root, frames_schema(features), file_mb * 1e6
        self._place = Place()
        self._writer: pq.ParquetWriter | None = None

    def add(self, columns: Mapping[str, NDArray[np.generic]]) -> Place:
        """Write an episode; return in which file it is."""
        where, path = self._place, self._place.path(self._root, DATA)
        if self._writer is None:
            self._writer = pq.ParquetWriter(path, self._schema, compression="snappy")
        arrays = [_array(columns[field.name], field.type) for field in self._schema]
        self._writer.write_table(pa.Table.from_arrays(arrays, schema=self._schema))
        if path.stat().st_size >= self._bytes:
            self.close()
            self._place = Place(self._place.number + 1)
        return where

    def close(self) -> None:
        """End the file."""
        if self._writer is not None:
            self._writer.close()
            self._writer = None


def _array(values: NDArray[np.generic], wanted: pa.DataType) -> pa.Array:
    if pa.types.is_fixed_size_list(wanted):
        flat = pa.array(np.ascontiguousarray(values, np.float32).reshape(-1))
        return pa.FixedSizeListArray.from_arrays(flat, wanted.list_size)
    return pa.array(values, wanted)


def write_texts(path: Path, name: str, texts: Iterable[str]) -> None:
    """Write texts with their numbers: ``task`` and ``task_index``.

    LeRobot reads them with pandas and looks texts up in the frame's index, so the file says which it is.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    kept, number = list(texts), f"{name}_index"
    table = pa.table({number: pa.array(range(len(kept)), pa.int64()), name: pa.array(kept, pa.string())})
    told = {
        "index_columns": [name],
        "column_indexes": [{"name": None, "field_name": None, **_TEXT}],
        "columns": [
            {"name": number, "field_name": number, **_NUMBER},
            {"name": name, "field_name": name, **_TEXT},
        ],
        "creator": {"library": "pyarrow", "version": pa.__version__},
        "pandas_version": "2.2.0",
    }
    pq.write_table(table.replace_schema_metadata({"pandas": json.dumps(told)}), path)


def write_rows(path: Path, rows: list[dict[str, object]]) -> None:
    """Write rows that all have the same columns."""
    pq.write_table(pa.Table.from_pylist(rows), path)
