"""Pictures of a record as frames of an mp4."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Final

import av
import av.codec.codec
import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.executive.records.lerobot.layout import PIXELS, VIDEO, VIDEO_MB, Place, image_key
from tandem.executive.records.lerobot.sampling import BEFORE, LONGEST_PICTURE, Numbers, Track
from tandem.executive.records.recording import Recording

Picture = NDArray[np.uint8]
"""Height, width, and blue, green, red."""
ENCODER: Final = "libx264"
"""H.264: every browser plays it, and OpenCV, FFmpeg and LeRobot read it. OpenCV's wheels can't encode it.
LeRobot's own default, AV1, is smaller, but OpenCV's wheels don't read it and older Safaris don't play it."""
HOW: Final = {"crf": "23", "preset": "veryfast", "g": "2"}
"""x264's own quality; a key frame every second frame, as LeRobot has it: training reads single frames."""
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
    gap: tuple[float, float] | None = None
    """The longest time without one, and when it began, in robot seconds; None: none was too long."""

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
    return tuple(_film(camera, jpegs[camera], np.array(at[camera]), moments) for camera in sorted(at))


def picture_of(jpeg: bytes) -> Picture | None:
    """Return the pixels of a picture; None if it is none."""
    found = cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR)
    return None if found is None else np.asarray(found, np.uint8)


class _File:
    """An mp4 under way."""

    def __init__(self, path: Path, size: tuple[int, int], fps: int) -> None:
        try:
            self._container = av.open(str(path), "w")
            self._stream = self._container.add_stream(ENCODER, rate=fps, options=dict(HOW))
        except av.codec.codec.UnknownCodecError as error:
            raise OSError(f"{path}: this build of PyAV has no encoder {ENCODER}") from error
        self._stream.height, self._stream.width = size
        self._stream.pix_fmt = PIXELS
        self._stream.codec_context.time_base = Fraction(1, fps)
        self._frames = 0

    def write(self, picture: Picture) -> int:
        """Write a frame; return how many bytes have come of it and of those before."""
        frame = av.VideoFrame.from_ndarray(picture, format="bgr24")
        frame.pts = self._frames
        self._frames += 1
        return self._mux(frame)

    def close(self) -> None:
        """Write what the encoder still has, and end the file."""
        try:
            if self._frames:
                self._mux(None)
        finally:
            self._container.close()

    def _mux(self, frame: av.VideoFrame | None) -> int:
        packets = self._stream.encode(frame)
        self._container.mux(packets)
        return sum(packet.size for packet in packets)


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
        self._place, self._frames, self._written = Place(), 0, 0
        self._file: _File | None = None

    def add(self, film: Film) -> tuple[Place, float, float, Picture]:
        """Write an episode; return in which file it is, from which second to which, and some small pictures.

        Raises:
            ValueError: when a picture has another size.
            OSError: when the file can't be written.
        """
        file = self._open()
        begin, last, shown = self._frames, -1, np.zeros((*self._size, 3), np.uint8)
        wanted = set(
            np.linspace(0, len(film.places) - 1, min(SAMPLES, len(film.places))).astype(int).tolist()
        )
        thumbs = []
        for number, place in enumerate(film.places):
            if place != last:
                shown, last = self._decoded(film.jpegs[place]), place
            self._written += file.write(shown)
            self._frames += 1
            if number in wanted:
                thumbs.append(cv2.resize(shown, THUMB, interpolation=cv2.INTER_AREA))
        where, end = self._place, self._frames
        if self._written >= self._bytes:
            self.close()
            self._place, self._frames, self._written = Place(self._place.number + 1), 0, 0
        return where, begin / self._fps, end / self._fps, np.asarray(thumbs, np.uint8)

    def close(self) -> None:
        """End the file."""
        if self._file is not None:
            file, self._file = self._file, None
            file.close()

    def _path(self) -> Path:
        return self._place.path(self._root, VIDEO, self._key)

    def _open(self) -> _File:
        if self._file is None:
            self._file = _File(self._path(), self._size, self._fps)
        return self._file

    def _decoded(self, jpeg: bytes) -> Picture:
        found = picture_of(jpeg)
        size = (0, 0) if found is None else found.shape[:2]
        if found is None or tuple(size) != self._size:
            raise ValueError(f"a picture of {size[1]} x {size[0]} pixels")
        return found


def _film(camera: str, jpegs: Sequence[bytes], at: Numbers, moments: Numbers) -> Film:
    track = Track(at, at[:, None])
    places = tuple(np.maximum(track.places(moments), 0).tolist())
    return Film(camera, tuple(jpegs), places, track.gap(moments, LONGEST_PICTURE))
