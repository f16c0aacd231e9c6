"""Pictures of a record as frames of an mp4."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.executive.records.lerobot.layout import VIDEO, VIDEO_MB, Place, image_key
from tandem.executive.records.lerobot.sampling import BEFORE, Numbers, Track
from tandem.executive.records.recording import Recording

Picture = NDArray[np.uint8]
"""Height, width, and blue, green, red."""
FOURCC: Final = "mp4v"
"""MPEG-4 part 2: OpenCV's wheels encode neither H.264 nor AV1, and VP9 at twenty times the cost."""
SAMPLES: Final = 16
"""Pictures of an episode of which statistics are made."""
THUMB: Final = (96, 54)
"""Pixels to which these are made smaller."""


@dataclass(frozen=True)
class Film:
    """The pictures of a camera in an episode: for each frame the last that had come."""

    camera: str
    jpegs: tuple[bytes, ...]
    places: tuple[int, ...]
    """Of each frame's picture among them."""

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the first picture; (0, 0): it is none."""
        first = picture_of(self.jpegs[self.places[0]])
        return (0, 0) if first is None else (int(first.shape[0]), int(first.shape[1]))


def films(record: Recording, moments: Numbers) -> tuple[Film, ...]:
    """Return the pictures that belong to the moments, by camera."""
    at: dict[str, list[float]] = {}
    jpegs: dict[str, list[bytes]] = {}
    for picture in record.pictures(float(moments[0]) - BEFORE, float(moments[-1])):
        camera = picture.key.split("/")[2]
        at.setdefault(camera, []).append(picture.at)
        jpegs.setdefault(camera, []).append(picture.payload)
    return tuple(
        Film(camera, tuple(jpegs[camera]), _places(np.array(at[camera]), moments)) for camera in sorted(at)
    )


def picture_of(jpeg: bytes) -> Picture | None:
    """Return the pixels of a picture; None if it is none."""
    found = cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR)
    return None if found is None else np.asarray(found, np.uint8)


class VideoFiles:
    """The mp4 files of one camera, one after the other, each with several episodes.

    Args:
        root: of the data set.
        camera: its name.
        size: height and width.
        fps: frames a second.
        file_mb: megabytes after which the next file begins.
    """

    def __init__(
        self, root: Path, camera: str, size: tuple[int, int], fps: int, *, file_mb: float = VIDEO_MB
    ) -> None:
        self._root, self._key, self._size, self._fps = root, image_key(camera), size, fps
        self._bytes = file_mb * 1e6
        self._place, self._frames = Place(), 0
        self._writer: cv2.VideoWriter | None = None

    def add(self, film: Film) -> tuple[Place, float, float, Picture]:
        """Write an episode; return in which file it is, from which second to which, and some small pictures.

        Raises:
            ValueError: when a picture has another size.
            OSError: when the file can't be written.
        """
        writer = self._open()
        begin, last, shown = self._frames, -1, np.zeros((*self._size, 3), np.uint8)
        wanted = set(
            np.linspace(0, len(film.places) - 1, min(SAMPLES, len(film.places))).astype(int).tolist()
        )
        thumbs = []
        for number, place in enumerate(film.places):
            if place != last:
                shown, last = self._decoded(film.jpegs[place]), place
            writer.write(shown)
            self._frames += 1
            if number in wanted:
                thumbs.append(cv2.resize(shown, THUMB, interpolation=cv2.INTER_AREA))
        where, end = self._place, self._frames
        if self._path().stat().st_size >= self._bytes:
            self.close()
            self._place, self._frames = Place(self._place.number + 1), 0
        return where, begin / self._fps, end / self._fps, np.asarray(thumbs, np.uint8)

    def close(self) -> None:
        """End the file."""
        if self._writer is not None:
            self._writer.release()
            self._writer = None

    def _path(self) -> Path:
        return self._place.path(self._root, VIDEO, self._key)

    def _open(self) -> cv2.VideoWriter:
        if self._writer is None:
            height, width = self._size
            code = cv2.VideoWriter.fourcc(*FOURCC)
            made = cv2.VideoWriter(str(self._path()), cv2.CAP_FFMPEG, code, self._fps, (width, height))
            if not made.isOpened():
                raise OSError(f"{self._path()}: OpenCV has no encoder {FOURCC}, or can't write there")
            self._writer = made
        return self._writer

    def _decoded(self, jpeg: bytes) -> Picture:
        found = picture_of(jpeg)
        size = (0, 0) if found is None else found.shape[:2]
        if found is None or tuple(size) != self._size:
            raise ValueError(f"a picture of {size[1]} x {size[0]} pixels")
        return found


def _places(at: Numbers, moments: Numbers) -> tuple[int, ...]:
    return tuple(np.maximum(Track(at, at[:, None]).places(moments), 0).tolist())
