"""LeRobot's data set of version 3: which file stands where, and what its columns are.

As published: LeRobotDataset v3.0 (docs of huggingface/lerobot), and what LeRobot 0.4.4 reads.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

VERSION: Final = "v3.0"
CHUNK: Final = 1000
"""Files of a folder, as LeRobot has it by default."""
DATA_MB: Final = 100
VIDEO_MB: Final = 200
"""Megabytes after which the next file begins, of data and of videos: LeRobot's own, by default."""
DATA: Final = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
VIDEO: Final = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
EPISODES: Final = "meta/episodes/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
INFO: Final = "meta/info.json"
STATS: Final = "meta/stats.json"
TASKS: Final = "meta/tasks.parquet"
SUBTASKS: Final = "meta/subtasks.parquet"
SOURCES: Final = "meta/tandem.json"
"""Ours: of which record each episode is."""
STATE: Final = "observation.state"
ACTION: Final = "action"
DONE: Final = "next.done"
SUCCESS: Final = "next.success"
NUMBERS: Final = {
    "timestamp": "float32",
    "frame_index": "int64",
    "episode_index": "int64",
    "index": "int64",
    "task_index": "int64",
    "subtask_index": "int64",
    DONE: "bool",
    SUCCESS: "bool",
}
"""Columns with one number a frame."""
CODEC: Final = "h264"
"""FFmpeg's name for the codec of the videos."""
PIXELS: Final = "yuv420p"
"""FFmpeg's name for their pixels, the only ones that all browsers show."""

Json = dict[str, object]


def image_key(camera: str) -> str:
    """Return the feature of a camera's pictures."""
    return f"observation.images.{camera}"


@dataclass(frozen=True)
class Features:
    """What a frame consists of, the same throughout a data set."""

    state: tuple[str, ...]
    action: tuple[str, ...]
    cameras: tuple[tuple[str, int, int], ...] = ()
    """Name, height and width of each camera's pictures."""

    def told(self, fps: int) -> Json:
        """Return the features as ``info.json`` has them."""
        numbers: Json = {name: {"dtype": kind, "shape": [1], "names": None} for name, kind in NUMBERS.items()}
        return {
            STATE: {"dtype": "float32", "shape": [len(self.state)], "names": list(self.state)},
            ACTION: {"dtype": "float32", "shape": [len(self.action)], "names": list(self.action)},
            **{image_key(name): _video(height, width, fps) for name, height, width in self.cameras},
            **numbers,
        }


def _video(height: int, width: int, fps: int) -> Json:
    return {
        "dtype": "video",
        "shape": [height, width, 3],
        "names": ["height", "width", "channels"],
        "info": {
            "video.fps": fps,
            "video.height": height,
            "video.width": width,
            "video.channels": 3,
            "video.codec": CODEC,
            "video.pix_fmt": PIXELS,
            "video.is_depth_map": False,
            "has_audio": False,
        },
    }


@dataclass(frozen=True)
class Place:
    """Which of the files of one pattern."""

    number: int = 0

    @property
    def chunk(self) -> int:
        """The folder."""
        return self.number // CHUNK

    @property
    def file(self) -> int:
        """The file in its folder."""
        return self.number % CHUNK

    def path(self, root: Path, pattern: str, key: str = "") -> Path:
        """Return the file; its folder is made."""
        path = root / pattern.format(chunk_index=self.chunk, file_index=self.file, video_key=key)
        path.parent.mkdir(parents=True, exist_ok=True)
        return path
