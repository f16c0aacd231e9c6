# mypy: disable-error-code="no-untyped-def"
# ruff: noqa: ANN001, ANN201, ANN202 - numba finds the types
"""The arithmetic of ``quick`` and ``spheres``, compiled by numba: some 2 us a state.

Imported only where numba is installed (extra ``fast``). The code is written out plainly because that is what
the compiler makes fast. ``judge`` is one function for the same reason: a call for each body, with its dozen
arrays, costs as much as what it does.
"""

from __future__ import annotations

import math

import numba
import numpy as np

FREE, DOUBT, CONTACT = 0, 1, 2


@numba.njit(cache=True, inline="always")
def _move(frames, joint, ball, out):
    for i in range(3):
        out[i] = (
            frames[joint, i, 0] * ball[0]
            + frames[joint, i, 1] * ball[1]
            + frames[joint, i, 2] * ball[2]
            + frames[joint, i, 3]
        )


@numba.njit(cache=True)
def _balls(frames, joint, balls, body, out):
    """Put a body's balls where they are: out (k, 3)."""
    for k in range(balls.shape[1]):
        _move(frames, joint, balls[body, k], out[k])


@numba.njit(cache=True)
def _apart(one, one_balls, a, two, two_balls, b, spare):  # noqa: PLR0917
    """Say whether no ball of a body touches one of another: centres (k, 3), radii in the last column."""
    for i in range(one_balls.shape[1]):
        for k in range(two_balls.shape[1]):
            x = one[i, 0] - two[k, 0]
            y = one[i, 1] - two[k, 1]
            z = one[i, 2] - two[k, 2]
            reach = one_balls[a, i, 3] + two_balls[b, k, 3] + spare
            if x * x + y * y + z * z <= reach * reach:
                return False
    return True


@numba.njit(cache=True)
def judge(  # noqa: C901, PLR0912, PLR0915, PLR0917
    states,
    chain,
    parents,
    columns,
    joints,
    strict,
    one,
    few,
    cover,
    inner,
    pairs,
    tables,
    ranges,
    answers,
    least,
    samples,
    numbers,
    stop,
    out,
):
    """Write what is proven of each state into ``out`` (m,); with ``stop`` the first that is not free ends it.

    Args:
        states: joint positions (m, n).
        chain: constant parts of each joint's frame (j, 4, 12): A, B, C, and 1 if it turns.
        parents: of each joint (j,).
        columns: of each joint in the states (j,).
        joints: of each body (b,); the first ``numbers[0]`` move.
        strict: whether a body's contact with the world is a proof (b,).
        one: a ball of each body (b, 1, 4): centre and radius, in cells for the radius.
        few: some balls (b, k, 4).
        cover: all (b, k, 4).
        inner: balls within (b, k, 4).
        pairs: bodies that may not touch (p, 2); the first of them moves.
        tables: columns of each table's joints (t, 2).
        ranges: low and cells a radian of both joints (t, 4).
        answers: of each table (t, side, side).
        least: of the field, flat.
        samples: of the field, flat.
        numbers: moving bodies, strides (2), metres to spare, slack in metres, cells to spare, a cell in
            metres, and the base's frame (12,) in cells.
        stop: end at the first state that is not free.
        out: the answers (m,).
    """
    moving = int(numbers[0])
    x_stride, y_stride = int(numbers[1]), int(numbers[2])
    safe, slack, spare = numbers[3], numbers[4], numbers[5]
    cell = numbers[6]
    count = len(joints)
    frames = np.empty((len(parents) + 1, 3, 4))
    at_one = np.empty((count, 1, 3))
    at_few = np.empty((count, few.shape[1], 3))
    mine = np.empty((cover.shape[1], 3))
    its = np.empty((cover.shape[1], 3))
    point = np.empty(3)
    for i in range(3):
        for k in range(4):
            frames[0, i, k] = numbers[7 + 4 * i + k]
    for body in range(moving, count):
        _balls(frames, 0, one, body, at_one[body])
        _balls(frames, 0, few, body, at_few[body])
    side = answers.shape[1]
    for s in range(len(states)):
        verdict = FREE
        # What tables of two joints' angles tell; outside of them they tell nothing.
        for t in range(len(tables)):
            a = math.floor((states[s, tables[t, 0]] - ranges[t, 0]) * ranges[t, 1])
            b = math.floor((states[s, tables[t, 1]] - ranges[t, 2]) * ranges[t, 3])
            if a < 0 or b < 0 or a >= side or b >= side:
                verdict = max(verdict, DOUBT)
            else:
                verdict = max(verdict, answers[t, a, b])
        if verdict != CONTACT:
            # Where the joints are.
            for j in range(len(parents)):
                q = states[s, columns[j]]
                first, second = q, 0.0
                if chain[j, 3, 0] > 0.0:
                    first, second = math.sin(q), 1.0 - math.cos(q)
                up = parents[j]
                for i in range(3):
                    for k in range(4):
                        value = 0.0
                        for m in range(3):
                            c = 4 * m + k
                            step = chain[j, 0, c] + first * chain[j, 1, c] + second * chain[j, 2, c]
                            value += frames[up, i, m] * step
                        if k == 3:  # noqa: PLR2004
                            value += frames[up, i, 3]
                        frames[j + 1, i, k] = value
            # Each moving body in the world: by some balls, by all, and by those inside it.
            for body in range(moving):
                joint = joints[body]
                _balls(frames, joint, few, body, at_few[body])
                _balls(frames, joint, one, body, at_one[body])
                near = False
                for k in range(few.shape[1]):
                    p = at_few[body, k]
                    where = int(p[0]) * x_stride + int(p[1]) * y_stride + int(p[2])
                    if where < 0 or where >= len(least) or least[where] <= few[body, k, 3] * cell + safe:
                        near = True
                        break
                if not near:
                    continue
                near = False
                for k in range(cover.shape[1]):
                    _move(frames, joint, cover[body, k], point)
                    where = int(point[0]) * x_stride + int(point[1]) * y_stride + int(point[2])
                    if where < 0 or where >= len(least) or least[where] <= cover[body, k, 3] * cell + safe:
                        near = True
                        break
                if not near:
                    continue
                verdict = DOUBT
                if strict[body]:
                    for k in range(inner.shape[1]):
                        _move(frames, joint, inner[body, k], point)
                        where = int(point[0]) * x_stride + int(point[1]) * y_stride + int(point[2])
                        if 0 <= where < len(samples) and samples[where] + slack < inner[body, k, 3] * cell:
                            verdict = CONTACT
                            break
                if verdict == CONTACT:
                    break
        if verdict == FREE:
            # Pairs of bodies: by one ball of each, by some, by all.
            for p in range(len(pairs)):
                a, b = pairs[p, 0], pairs[p, 1]
                if _apart(at_one[a], one, a, at_one[b], one, b, spare):
                    continue
                if _apart(at_few[a], few, a, at_few[b], few, b, spare):
                    continue
                _balls(frames, joints[a], cover, a, mine)
                _balls(frames, joints[b], cover, b, its)
                if not _apart(mine, cover, a, its, cover, b, spare):
                    verdict = DOUBT
                    break
        out[s] = verdict
        if stop and verdict != FREE:
            return s
    return len(states)


@numba.njit(cache=True)
def best_ball(corners, normals, offsets, rounds):  # noqa: C901, PLR0912
    """Return the ball about corners (n, 3) that reaches least out of a polytope: centre, radius, and how far.

    Args:
        corners: what it encloses.
        normals: the polytope's faces n.x <= d, (f, 3).
        offsets: of the faces (f,).
        rounds: how many steps are made.
    """
    low, high = corners[0].copy(), corners[0].copy()
    for corner in corners:
        for i in range(3):
            low[i] = min(low[i], corner[i])
            high[i] = max(high[i], corner[i])
    centre = 0.5 * (low + high)
    step = 0.5 * np.max(high - low)
    best, radius, least = centre.copy(), 0.0, np.inf
    slope = np.empty(3)
    for _ in range(rounds):
        far, farthest = -1.0, 0
        for k in range(len(corners)):
            square = 0.0
            for i in range(3):
                square += (centre[i] - corners[k, i]) ** 2
            if square > far:
                far, farthest = square, k
        far = math.sqrt(far)
        gap, nearest = -np.inf, 0
        for k in range(len(normals)):
            value = -offsets[k]
            for i in range(3):
                value += normals[k, i] * centre[i]
            if value > gap:
                gap, nearest = value, k
        if far + gap < least:
            best[:], radius, least = centre, far, far + gap
        else:
            step *= 0.85
        size = 0.0
        for i in range(3):
            slope[i] = (centre[i] - corners[farthest, i]) / max(far, 1e-9) + normals[nearest, i]
            size += slope[i] * slope[i]
        if size < 1e-12:  # noqa: PLR2004
            break
        for i in range(3):
            centre[i] -= step * slope[i] / math.sqrt(size)
    return best, radius, least
