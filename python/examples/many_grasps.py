"""Many grasps of three fingers, bad ones among them, and the one call that answers them: what the examples on clusters share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from grasp_lcp import OnsetStatus, hold_batch, onsets

Array = NDArray[np.float64]

FINGERS = 3
DOWN = [0.0, 0.0, -1.0]
"""One newton of load, so that factors are newtons."""

ANSWER = np.dtype([("id", "<i8"), ("factor", "<f8"), ("status", "u1"), ("leaving", "u1"), ("verdict", "u1")])
"""A row of the answers; bit i of ``leaving`` says that contact i leaves, ``verdict`` whether half a newton is held."""
Answers = NDArray[np.void]


@dataclass(frozen=True)
class ManyGrasps:
    """Columns of a table of grasps."""

    id: NDArray[np.int64]
    """In no order, shape (B,)."""
    points: Array
    """m, shape (B, 3, 3)."""
    normals: Array
    """Into the object, of any length, shape (B, 3, 3)."""
    friction: Array
    """Shape (B,)."""
    squeeze: Array
    """What each finger presses with, N, shape (B,)."""

    def answered(self) -> Answers:
        """The answers to all of them, by one call."""
        return answered(self.id, self.points, self.normals, self.friction, self.squeeze)


def answered(id: NDArray[np.int64], points: Array, normals: Array, friction: Array, squeeze: Array) -> Answers:
    """Which load straight down each grasp holds until its first contact slides, and whether it holds half a newton, row by row."""
    given = {
        "friction": friction[:, None], "pressed_with": squeeze[:, None], "body_stiffness": [5e4, 3e4], "finger_stiffness": [2e3, 1.5e3],
    }  # fmt: skip
    found = onsets(points, normals, DOWN, **given)
    verdicts = hold_batch(points, normals, np.multiply(0.5, DOWN), **given)
    answers = np.empty(len(id), dtype=ANSWER)
    answers["id"], answers["factor"], answers["status"] = id, found.factor, found.status
    answers["verdict"] = verdicts.status
    answers["leaving"] = np.packbits(found.leaving, axis=1, bitorder="little")[:, 0]
    return answers


def at_random(rows: int) -> ManyGrasps:
    """Three fingers around jars. One row in a thousand is bad: a point that is NaN, a negative friction or a normal of zeros."""
    rng = np.random.default_rng(24)
    angles = 2 * np.pi * np.arange(FINGERS) / FINGERS + rng.uniform(-0.3, 0.3, (rows, FINGERS))
    radius = rng.uniform(0.02, 0.05, (rows, 1))
    points = np.stack([radius * np.cos(angles), radius * np.sin(angles), rng.uniform(-0.01, 0.01, (rows, FINGERS))], axis=2)
    normals = points * [-1.0, -1.0, 0.0]
    friction, squeeze = rng.uniform(0.2, 0.9, rows), rng.uniform(2.0, 12.0, rows)
    bad = np.arange(500, rows, 1000)
    points[bad[0::3], 1, 2], friction[bad[1::3]], normals[bad[2::3], 2] = np.nan, -0.1, 0.0
    return ManyGrasps(rng.permutation(rows).astype(np.int64), points, normals, friction, squeeze)


@dataclass(frozen=True)
class Comparison:
    """Answers from elsewhere beside those of one process."""

    rows: int
    lost: int
    doubled: int
    invented: int
    different: int
    """Rows that differ in any bit."""
    statuses: dict[str, int]

    @property
    def same(self) -> bool:
        """Whether nothing is amiss."""
        return not (self.lost or self.doubled or self.invented or self.different)

    def __str__(self) -> str:
        amiss = f"{self.lost} lost, {self.doubled} doubled, {self.invented} invented, {self.different} different in any bit"
        return f"{self.rows} answers: {amiss}\n" + "\n".join(f"  {name:<14}{count:>9}" for name, count in self.statuses.items())


def compared(found: Answers, expected: Answers) -> Comparison:
    """What became of each row, by its id."""
    ids, first, times = np.unique(found["id"], return_index=True, return_counts=True)
    shared, ours, theirs = np.intersect1d(ids, expected["id"], assume_unique=True, return_indices=True)
    raw = np.dtype((np.void, ANSWER.itemsize))
    different = found[first[ours]].view(raw) != expected[theirs].view(raw)
    statuses = np.bincount(found["status"], minlength=len(OnsetStatus))
    return Comparison(
        rows=len(found),
        lost=len(expected) - len(shared),
        doubled=int((times - 1).sum()),
        invented=len(ids) - len(shared),
        different=int(np.count_nonzero(different)),
        statuses={status.name: int(statuses[status]) for status in OnsetStatus if statuses[status]},
    )


def paced(name: str, rows: int, seconds: float) -> str:
    """A line of throughput."""
    return f"{name:<44}{seconds:8.3f} s{rows / seconds * 1e-6:8.3f} million a second"
