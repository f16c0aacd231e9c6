"""Writes a data set: episodes in, files out."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.executive.records.lerobot import layout, statistics, tables
from tandem.executive.records.lerobot.episodes import Episode
from tandem.executive.records.lerobot.layout import Features, Place, image_key
from tandem.executive.records.lerobot.videos import Picture, VideoFiles
from tandem.skills.ports.tasks import TaskState

FIRST: Final = Place()


class DataSet:
    """A data set under way.

    Args:
        root: its folder.
        robot: the robot's name.
        features: what each frame consists of.
        fps: frames a second.
    """

    def __init__(self, root: Path, robot: str, features: Features, fps: int) -> None:
        self._root, self._robot, self._features, self._fps = root, robot, features, fps
        self._frames = tables.FrameFiles(root, features)
        self._videos = {
            name: VideoFiles(root, name, (height, width), fps) for name, height, width in features.cameras
        }
        self._tasks: dict[str, int] = {}
        self._subtasks: dict[str, int] = {}
        self._rows: list[dict[str, object]] = []
        self._sources: list[layout.Json] = []
        self._columns: list[dict[str, NDArray[np.generic]]] = []
        self._shown: dict[str, list[Picture]] = {name: [] for name in self._videos}
        self.length = 0
        """Frames so far."""

    @property
    def count(self) -> int:
        """Episodes so far."""
        return len(self._rows)

    def add(self, episode: Episode) -> None:
        """Write an episode.

        Raises:
            ValueError: when a picture of it has another size than the first of its camera.
            OSError: when the disk does not take it.
        """
        columns = self._columns_of(episode)
        length = len(episode.moments)
        place = self._frames.add(columns)
        row: dict[str, object] = {
            "episode_index": self.count,
            "tasks": [episode.span.text],
            "length": length,
            "data/chunk_index": place.chunk,
            "data/file_index": place.file,
            "dataset_from_index": self.length,
            "dataset_to_index": self.length + length,
            "meta/episodes/chunk_index": FIRST.chunk,
            "meta/episodes/file_index": FIRST.file,
        }
        stats = statistics.of_columns(columns)
        for name, files in self._videos.items():
            where, begin, end, shown = files.add(episode.films[name])
            row |= _video_row(image_key(name), where, begin, end)
            stats[image_key(name)] = statistics.of_pictures(shown)
            self._shown[name].append(shown)
        self._rows.append(row | _flat(stats))
        self._columns.append(columns)
        self._sources.append(_source(episode, self.count - 1))
        self.length += length

    def finish(self) -> None:
        """Write what is known at the end: the files of ``meta``."""
        self.close()
        tables.write_texts(self._root / layout.TASKS, "task", self._tasks)
        tables.write_texts(self._root / layout.SUBTASKS, "subtask", self._subtasks)
        tables.write_rows(FIRST.path(self._root, layout.EPISODES), self._rows)
        stats = statistics.of_columns(statistics.together(self._columns))
        for name, shown in self._shown.items():
            stats[image_key(name)] = statistics.of_pictures(np.concatenate(shown))
        self._write_json(layout.STATS, stats)
        self._write_json(layout.SOURCES, {"episodes": self._sources})
        self._write_json(layout.INFO, self._info())

    def close(self) -> None:
        """End the files of frames and pictures. Closing twice is allowed."""
        self._frames.close()
        for files in self._videos.values():
            files.close()

    def _columns_of(self, episode: Episode) -> dict[str, NDArray[np.generic]]:
        length = len(episode.moments)
        numbers = np.arange(length)
        last = numbers == length - 1
        task = self._tasks.setdefault(episode.span.text, len(self._tasks))
        subtasks = [self._subtasks.setdefault(leaf, len(self._subtasks)) for leaf in episode.leaves()]
        return {
            **episode.vectors(self._fps),
            "timestamp": (numbers / self._fps).astype(np.float32),
            "frame_index": numbers,
            "episode_index": np.full(length, self.count),
            "index": numbers + self.length,
            "task_index": np.full(length, task),
            "subtask_index": np.array(subtasks),
            layout.DONE: last,
            layout.SUCCESS: last & (episode.span.state is TaskState.SUCCEEDED),
        }

    def _info(self) -> layout.Json:
        return {
            "codebase_version": layout.VERSION,
            "robot_type": self._robot,
            "total_episodes": self.count,
            "total_frames": self.length,
            "total_tasks": len(self._tasks),
            "chunks_size": layout.CHUNK,
            "data_files_size_in_mb": layout.DATA_MB,
            "video_files_size_in_mb": layout.VIDEO_MB,
            "fps": self._fps,
            "splits": {"train": f"0:{self.count}"},
            "data_path": layout.DATA,
            "video_path": layout.VIDEO if self._videos else None,
            "features": self._features.told(self._fps),
        }

    def _write_json(self, name: str, document: Mapping[str, object]) -> None:
        path = self._root / name
        path.write_text(json.dumps(document, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


def _video_row(key: str, where: Place, begin: float, end: float) -> dict[str, object]:
    return {
        f"videos/{key}/chunk_index": where.chunk,
        f"videos/{key}/file_index": where.file,
        f"videos/{key}/from_timestamp": begin,
        f"videos/{key}/to_timestamp": end,
    }


def _flat(stats: Mapping[str, statistics.Stats]) -> dict[str, object]:
    return {f"stats/{name}/{kind}": value for name, told in stats.items() for kind, value in told.items()}


def _source(episode: Episode, number: int) -> layout.Json:
    facts, span, path = episode.record.facts, episode.span, episode.record.path.absolute()
    return {
        "episode_index": number,
        "file": f"{path.parent.name}/{path.name}",
        "task": span.task,
        "request": dict(span.request),
        "begin": span.begin,
        "end": span.end,
        "state": span.state.value,
        "failure": span.failure,
        "facts": facts.model_dump(mode="json"),
    }
