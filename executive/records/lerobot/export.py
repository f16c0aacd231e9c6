"""From records to a data set: which tasks become episodes, and what keeps them from being one data set."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.records.lerobot.dataset import DataSet
from tandem.executive.records.lerobot.episodes import Episode, episodes
from tandem.executive.records.lerobot.layout import Features
from tandem.executive.records.lerobot.spans import LeftOut
from tandem.executive.records.recording import RecordError, Recording, open_recording

KINDS: Final = (".mcap", ".jsonl.gz")


@dataclass(frozen=True)
class Wanted:
    """What a data set is to hold."""

    fps: int = 10
    cameras: tuple[str, ...] | None = None
    """Their names; None: all that the first episode has pictures of."""


@dataclass(frozen=True)
class Exported:
    """What became of the records."""

    episodes: int
    frames: int
    features: Features
    left_out: tuple[tuple[Path, LeftOut], ...]


def export(sources: Sequence[Path], target: Path, wanted: Wanted) -> Exported:
    """Write the tasks of records as a data set into a folder that is new or empty.

    A source is a record, or a folder of them. The folder is there whole or not at all.

    Raises:
        RecordError: for a record that can't be used, one that does not fit the others, or no task at all.
        OSError: when the folder can't be written.
    """
    files = list(_files(sources))
    with _made(target) as root:
        making = _Making(root, target, wanted)
        try:
            for file in files:
                making.take(file)
            return making.finish()
        finally:
            making.close()


class _Making:
    def __init__(self, root: Path, target: Path, wanted: Wanted) -> None:
        self._root, self._target, self._wanted = root, target, wanted
        self._set: DataSet | None = None
        self._features, self._first = Features((), ()), ""
        self._left_out: list[tuple[Path, LeftOut]] = []
        self._taken: dict[tuple[object, ...], Path] = {}
        """Files of the tasks that are in the set: a black box has what a recording of its time has."""

    def take(self, file: Path) -> None:
        record = open_recording(file)
        try:
            for each in episodes(record, self._wanted.fps, self._wanted.cameras):
                if isinstance(each, LeftOut):
                    self._left_out.append((file, each))
                elif (known := self._taken.setdefault(_identity(each), file)) is not file:
                    self._left_out.append((file, LeftOut(each.span.task, f"it is in {known.name}, too")))
                else:
                    self._add(record, each)
        finally:
            record.close()

    def finish(self) -> Exported:
        if self._set is None:
            why = "; ".join(f"{each.task}: {each.reason}" for _, each in self._left_out)
            found = f"none ({why})" if why else "none"
            advice = "`tandem replay FILE` lists what happened in a record"
            raise RecordError(self._target, "a task that began and ended in a record", found, advice)
        self._set.finish()
        return Exported(self._set.count, self._set.length, self._features, tuple(self._left_out))

    def close(self) -> None:
        if self._set is not None:
            self._set.close()

    def _add(self, record: Recording, episode: Episode) -> None:
        if self._set is None:
            cameras = self._wanted.cameras
            chosen = tuple(sorted(episode.films)) if cameras is None else cameras
            self._require_cameras(record, episode, chosen)
            self._features = episode.features(chosen)
            self._require_even(record)
            self._first = f"{record.path.name}, {episode.span.task}"
            self._set = DataSet(self._root, episode.robot, self._features, self._wanted.fps)
        chosen = tuple(name for name, _, _ in self._features.cameras)
        self._require_cameras(record, episode, chosen)
        self._require_same(record, episode.features(chosen))
        try:
            self._set.add(episode)
        except ValueError as error:
            expected = f"pictures of one size, as in {self._first}"
            raise RecordError(record.path, expected, str(error), "leave the camera out") from error

    def _require_cameras(self, record: Recording, episode: Episode, chosen: Sequence[str]) -> None:
        missing = [name for name in chosen if name not in episode.films]
        if missing:
            expected = f"pictures of {', '.join(missing)} while {episode.span.task} ran"
            found = f"those of {', '.join(episode.films)}" if episode.films else "no pictures"
            advice = (
                "name the cameras with --camera, leave them out with --no-pictures, or leave this file out"
            )
            raise RecordError(record.path, expected, found, advice)

    def _require_even(self, record: Recording) -> None:
        """Refuse what no video shows everywhere: a pixel's colour is that of two by two."""
        for name, height, width in self._features.cameras:
            if height % 2 or width % 2:
                expected, found = (
                    "pictures of even height and width",
                    f"{name} with {width} x {height} pixels",
                )
                raise RecordError(record.path, expected, found, "leave the camera out")

    def _require_same(self, record: Recording, features: Features) -> None:
        if features == self._features:
            return
        expected = f"the joints and cameras of the first episode ({self._first})"
        found = _difference(self._features, features)
        raise RecordError(record.path, expected, found, "export each robot into a folder of its own")


def _identity(episode: Episode) -> tuple[object, ...]:
    """Return what two records of one task have in common. Tasks of two starts may have one name."""
    facts, span = episode.record.facts, episode.span
    return facts.site, facts.robot, facts.began, facts.seed, span.task, round(span.begin, 3)


def _difference(one: Features, other: Features) -> str:
    if one.state != other.state:
        lacks, more = set(one.state) - set(other.state), set(other.state) - set(one.state)
        told = [
            f"{word} {', '.join(sorted(names))}" for word, names in (("no", lacks), ("also", more)) if names
        ]
        return "; ".join(told) or "the same ones in another order"
    sizes = ", ".join(f"{name} with {width} x {height}" for name, height, width in other.cameras)
    return sizes or "other actions"


def _files(sources: Sequence[Path]) -> Iterator[Path]:
    for source in sources:
        if not source.is_dir():
            yield source
            continue
        found = sorted(each for each in source.rglob("*") if each.name.endswith(KINDS))
        if not found:
            raise RecordError(source, "records (.mcap or .jsonl.gz) in the folder", "none", "name another")
        yield from found


@contextmanager
def _made(target: Path) -> Iterator[Path]:
    """Give a folder to write into; it takes its name when all has gone well."""
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        found = "one with something in it" if target.is_dir() else "a file"
        raise RecordError(target, "a folder that is new or empty", found, "name another, or remove it")
    unfinished = target.with_name(f".{target.name}.part")
    shutil.rmtree(unfinished, ignore_errors=True)
    unfinished.mkdir(parents=True)
    try:
        yield unfinished
        unfinished.replace(target)
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
