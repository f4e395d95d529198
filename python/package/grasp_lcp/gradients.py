"""Gradients of the onsets of many grasps, on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _grasp_lcp
from ._views import Array
from .batch import asked


@dataclass(frozen=True, eq=False)
class OnsetGradients:
    """Derivatives of the factors of :func:`onsets`. All arrays begin with the shape of the batch; numbers are NaN in rows without a factor.

    Each derivative is exact and partial: one datum changes, all others stay. It belongs to the margin of the contact in :attr:`contact`. Where
    :attr:`one_sided` is true, several events are active and the factor has a kink: the derivative holds to one side of it. Where a motion of the
    object is free, as for two hard fingers in space, the derivatives by points, normals and loads are NaN.
    """

    factor: Array
    """Factors, as in :class:`Onsets`."""
    status: NDArray[np.uint8]
    """The :class:`OnsetStatus` of each row."""
    leaving: NDArray[np.bool_]
    """Whether each contact stops sticking at the factor, shape (..., n)."""
    contact: NDArray[np.int64]
    """The contact whose margin vanishes at the factor, from 0; -1 without a factor."""
    one_sided: NDArray[np.bool_]
    """Whether the factor has a kink at these data."""
    points: Array
    """Derivatives by contact points along the coordinate axes, with constant normals, 1/m, shape (..., n, c)."""
    normals: Array
    """Derivatives by unit normals, perpendicular to them, 1/rad, shape (..., n, c). Springs, commands and clearances tilt with the contact frame."""
    command_world: Array
    """Derivatives by commands along the coordinate axes, 1/m, shape (..., n, c)."""
    series_stiffness: Array
    """Derivatives by normal and tangential stiffness, m/N, shape (..., n, 2): both tangents change together, commands in metres stay."""
    friction: Array
    """Derivatives by friction coefficients, shape (..., n)."""
    base: Array
    """Derivatives by the base load, 1/N and 1/(N m), shape (..., d)."""

    @property
    def direction(self) -> Array:
        """Derivatives by the direction of the load, shape (..., d): the factor times the derivatives by the base load."""
        with np.errstate(invalid="ignore"):
            return self.factor[..., None] * self.base

    def __repr__(self) -> str:
        known = int(np.count_nonzero(self.contact >= 0))
        return f"<OnsetGradients {self.status.shape}: {known} with a factor, {int(self.one_sided.sum())} one-sided>"


def onset_gradients(
    points: ArrayLike,
    normals: ArrayLike,
    direction: ArrayLike,
    base: ArrayLike | None = None,
    *,
    friction: ArrayLike = 0.0,
    series_stiffness: ArrayLike | None = None,
    body_stiffness: ArrayLike | None = None,
    finger_stiffness: ArrayLike | None = None,
    command: ArrayLike | None = None,
    command_world: ArrayLike | None = None,
    pressed_with: ArrayLike | None = None,
    clearance: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    hold: str | Sequence[str] = "unilateral",
) -> OnsetGradients:
    """The gradients of the factors of :func:`onsets` by all data of grasps and loads, at the cost of a few factors.

    Grasps must have two to five contacts; in space each has one stiffness along both tangents. A row that screening leaves open has no gradient.
    The parameters are those of :func:`onsets`. A grasp of three contacts in space takes some 300 bytes.
    """
    shape, made, first, second, own = asked(
        points, normals, direction, base, friction, hold, series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, tangents=tangents,
    )  # fmt: skip
    contacts, axes = made["points"].shape[1:]
    numbers, status = _grasp_lcp.onset_gradients_of_rows(made, first, second, own)
    width = 4 + (3 * axes + 3) * contacts + 3 * (axes - 1)
    rows = numbers.reshape(*shape, width)
    at = 4
    fields: dict[str, Array] = {}
    sizes = {"points": axes, "normals": axes, "command_world": axes, "series_stiffness": 2}
    for name, size in sizes.items():
        fields[name] = rows[..., at : at + contacts * size].reshape(*shape, contacts, size)
        at += contacts * size
    leaving = rows[..., 1].astype(np.int64)
    return OnsetGradients(
        factor=rows[..., 0],
        status=status.reshape(shape),
        leaving=(leaving[..., None] >> np.arange(contacts)) & 1 > 0,
        contact=rows[..., 2].astype(np.int64),
        one_sided=rows[..., 3] > 0,
        friction=rows[..., at : at + contacts],
        base=rows[..., at + contacts :],
        **fields,
    )
