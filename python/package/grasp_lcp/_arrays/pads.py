"""Pads: contacts spread over points of their tangent planes, which share their springs, as ``SoftFingertip::contacts`` spreads them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from .._columns import text_of_pads
from .._grasp_lcp import points_of_pads
from .sites import cross


class Pads:
    """The points of all contacts of a grasp, in order."""

    def __init__(self, points: Sequence[tuple[Sequence[Sequence[float]], Sequence[float]]]) -> None:
        """``points`` has, for each contact, the offsets of its points along the tangents, m, and their shares of its springs."""
        self.counts = [len(shares) for _, shares in points]
        self.owner = [i for i, count in enumerate(self.counts) for _ in range(count)]
        """The index of the contact to which each point belongs."""
        self.offset = np.array([offset for offsets, _ in points for offset in offsets])
        self.share = np.array([share for _, shares in points for share in shares])

    def first_points(self) -> Any:
        """The index of the first point of each contact."""
        return np.cumsum([0, *self.counts[:-1]])

    def spread(self, xp: Any, data: Sequence[Any], tangents: Any = None) -> list[Any]:
        """The data of :class:`.onset.Scenes`, with one entry for each point instead of each contact."""
        points, normals, friction, stiffness, command, base, direction = data
        arms = self.arms(xp, normals, tangents)
        share = points[..., :1, :1] * 0.0 + _like(xp, self.share[:, None], points)
        return [
            points[..., self.owner, :] + arms,
            normals[..., self.owner, :],
            friction[..., self.owner],
            stiffness[..., self.owner, :] * share,
            command[..., self.owner, :],
            base,
            direction,
        ]

    def arms(self, xp: Any, normals: Any, tangents: Any = None) -> Any:
        """The vectors from contacts to their points."""
        offset, arms = _like(xp, self.offset, normals), 0.0
        for k, tangent in enumerate(frames(xp, normals, tangents)):
            arms = arms + tangent[..., self.owner, :] * offset[:, k, None]
        return arms

    def gathered(self, slopes: Sequence[Any], normals: Any, arms: Any) -> list[Any]:
        """Derivatives with respect to data of contacts, from those of points, which move if contact frames tilt. For numpy arrays only."""
        points, tilts, friction, stiffness, command, *loads = slopes
        n = normals[..., self.owner, :]
        if n.shape[-1] == 2:
            moment = arms[..., 0] * points[..., 1] - arms[..., 1] * points[..., 0]
            tilts = tilts + moment[..., None] * np.stack([-n[..., 1], n[..., 0]], axis=-1)
        else:
            tilts = tilts + np.cross(np.cross(arms, points), n)
        first = self.first_points()
        whole = [np.add.reduceat(each, first, axis=-2) for each in (points, tilts, stiffness * self.share[:, None], command)]
        return [whole[0], whole[1], np.add.reduceat(friction, first, axis=-1), whole[2], whole[3], *loads]


def takes_array_program(native: bool | None, soft: Any, is_far: Callable[[], bool]) -> bool:
    """Whether the array program answers: if ``native`` is true, for pads, and by default on an accelerator."""
    if soft is not None and native is False:
        raise ValueError("native: False given beside soft, must be True or left out: pads are for the array program")
    return soft is not None or (is_far() if native is None else native)


def spread(xp: Any, soft: Any, data: Sequence[Any], words: tuple[str, ...]) -> tuple[list[Any], tuple[str, ...]]:
    """Data and words of ``hold`` with the points of pads in place of contacts. Its derivatives are with respect to data of whole contacts."""
    text = text_of_pads(soft, len(words))
    if text is None:
        return list(data), words
    pads = Pads(points_of_pads(text, data[0].shape[-1]))
    return pads.spread(xp, data), tuple(words[i] for i in pads.owner)


def frames(xp: Any, normals: Any, hints: Any = None) -> list[Any]:
    """Unit tangents of contacts with these unit normals. The first is the projection of the hint, or of the axis farthest from the normal."""
    n = [normals[..., k] for k in range(normals.shape[-1])]
    if len(n) == 2:
        tangent = xp.stack([n[1], -n[0]], axis=-1)
        if hints is None:
            return [tangent]
        return [tangent * xp.sign((hints * tangent).sum(axis=-1))[..., None]]
    if hints is None:
        x, y, z = map(abs, n)
        is_x = (x <= y) & (x <= z)
        is_y = ~is_x & (y <= z)
        hints = xp.stack([xp.where(here, xp.ones_like(x), xp.zeros_like(x)) for here in (is_x, is_y, ~is_x & ~is_y)], axis=-1)
    flat = hints
    for _ in range(2):
        flat = flat - normals * (normals * flat).sum(axis=-1)[..., None]
    first = flat / xp.sqrt((flat * flat).sum(axis=-1))[..., None]
    return [first, xp.stack(cross(n, [first[..., k] for k in range(3)]), axis=-1)]


def _like(xp: Any, numbers: Any, like: Any) -> Any:
    """Numbers as an array of the type and device of ``like``."""
    return like.new_tensor(numbers) if hasattr(like, "new_tensor") else xp.asarray(numbers, dtype=like.dtype)
