"""An episode: a task of a record as frames at even steps of robot time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tandem.executive.records.lerobot.layout import ACTION, STATE, Features
from tandem.executive.records.lerobot.sampling import (
    BASE_ACTION,
    BASE_STATE,
    LONGEST,
    OFTEN,
    Numbers,
    Signals,
    description_of,
    moments_of,
    signals,
)
from tandem.executive.records.lerobot.spans import LeftOut, TaskSpan, spans
from tandem.executive.records.lerobot.videos import Film, films
from tandem.executive.records.recording import Recording


@dataclass(frozen=True)
class Episode:
    """A task that began and ended in a record."""

    record: Recording
    span: TaskSpan
    signals: Signals
    moments: Numbers
    """Robot seconds since the recorder began, of each frame."""
    films: Mapping[str, Film]
    """By camera."""
    base: bool
    """Whether the robot drives: its place is then part of the state."""
    robot: str
    """What the robot is called by its description, else by its keys."""

    def features(self, cameras: Sequence[str]) -> Features:
        """Return what a frame consists of, with the cameras that are wanted and there."""
        joints = tuple(f"{name}.pos" for name in self.signals.joints)
        sizes = tuple((name, *self.films[name].size) for name in cameras if name in self.films)
        if not self.base:
            return Features(joints, joints, sizes)
        return Features((*joints, *BASE_STATE), (*joints, *BASE_ACTION), sizes)

    def vectors(self, fps: int) -> dict[str, NDArray[np.generic]]:
        """Return state and action, a row for each frame."""
        state = self.signals.state(self.moments, base=self.base)
        action = self.signals.action(self.moments, 1.0 / fps, base=self.base)
        return {STATE: state.astype(np.float32), ACTION: action.astype(np.float32)}

    def leaves(self) -> tuple[str, ...]:
        """Return which leaves ran at each frame."""
        at = np.array([each for each, _ in self.span.leaves])
        places = np.searchsorted(at, self.moments + 1e-9, side="right") - 1
        return tuple(self.span.leaves[max(place, 0)][1] for place in places.tolist())


def episodes(
    record: Recording, fps: int, cameras: Sequence[str] | None = None
) -> Iterator[Episode | LeftOut]:
    """Yield the tasks of a record as episodes, in order, and those that can't be one.

    Args:
        record: to be sampled.
        fps: frames a second.
        cameras: those of which pictures are wanted; None: all.
    """
    robot = description_of(record)
    name = record.facts.robot if robot is None else robot.name
    found, left_out = spans(record)
    yield from left_out
    for span in found:
        heard = signals(record, span.begin, span.end)
        if heard is None:
            yield LeftOut(span.task, "the record has no joints of that time")
            continue
        moments = moments_of(span.begin, span.end, fps)
        shown = {each.camera: each for each in films(record, moments)}
        lacks = _lacks(
            span, heard, moments, [each for name, each in shown.items() if cameras is None or name in cameras]
        )
        if lacks:
            yield LeftOut(span.task, lacks)
            continue
        drives = heard.pose is not None if robot is None else robot.drive is not None
        yield Episode(record, span, heard, moments, shown, drives, name)


def _lacks(span: TaskSpan, heard: Signals, moments: Numbers, shown: Iterable[Film]) -> str:
    """Say what a task's record lacks for frames at even steps; empty: nothing."""
    if span.boots > 1:
        return "the hardware started anew while it ran"
    count = int(np.count_nonzero((heard.positions.at >= moments[0]) & (heard.positions.at <= moments[-1])))
    gaps = [("joints", heard.positions.gap(moments, LONGEST))]
    gaps += [(f"picture of {each.camera}", each.gap) for each in shown]
    for what, gap in gaps:
        if gap is not None:
            return f"no {what} came for {gap[0]:.1f} s, {gap[1] - span.begin:.1f} s after its start"
    if len(moments) > OFTEN * count + 1:
        return f"joints came {count} times while it ran, too seldom for {len(moments)} frames (--fps)"
    return ""
