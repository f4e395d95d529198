"""How the onsets of many grasps change with their data, on all cores."""

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
    """Derivatives of the factors of :func:`onsets`; all arrays begin with the shape of the batch, numbers are NaN where there is no factor.

    Each is that by one datum where nothing else changes: exact, of the contact in :attr:`contact`. Where :attr:`one_sided` is true several events are
    active and the factor has a kink: this is the derivative to one side. Where a motion of the object is free, as of two hard fingers in
    space, those by points, normals and loads are NaN.
    """

    factor: Array
    """As in :class:`Onsets`."""
    status: NDArray[np.uint8]
    """An :class:`OnsetStatus` for each."""
    leaving: NDArray[np.bool_]
    """Which contacts leave there, shape (..., n)."""
    contact: NDArray[np.int64]
    """The contact whose margin vanishes, from 0; -1 without a factor."""
    one_sided: NDArray[np.bool_]
    """Whether the factor has a kink here."""
    points: Array
    """By positions along the coordinate axes, normals staying, 1/m, shape (..., n, c)."""
    normals: Array
    """By unit normals, across them, 1/rad, shape (..., n, c). Springs, commands and clearances tilt with the contact frame."""
    command_world: Array
    """By commands along the coordinate axes, 1/m, shape (..., n, c)."""
    series_stiffness: Array
    """By normal and tangential stiffness, m/N, shape (..., n, 2); both tangents together, commands in metres staying."""
    friction: Array
    """By coefficients of friction, shape (..., n)."""
    base: Array
    """By the base load, 1/N and 1/(N m), shape (..., d)."""

    @property
    def direction(self) -> Array:
        """By the direction of the load: the factor times those by the base load."""
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
    """How the factors of :func:`onsets` change with every number of the grasps and loads: all at the price of a few factors.

    Grasps have two to five contacts, with one stiffness along both tangents in space; what screening leaves open has no gradient.
    The parameters are those of :func:`onsets`. Memory is some 300 bytes for each grasp of three contacts in space.
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
