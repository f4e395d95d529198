"""Gradients of the onsets of many grasps, on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _grasp_lcp
from ._columns import HOLDS
from ._views import Array
from .batch import Loads, OnsetStatus, Soft, asked, onsets


@dataclass(frozen=True, eq=False)
class OnsetGradients:
    """Derivatives of the factors of :func:`onsets`. All arrays begin with the shape of the batch; numbers are NaN in rows without a factor.

    Each derivative is exact and partial: one quantity changes while all others are constant. It is that of the margin of the contact in
    :attr:`contact`. If :attr:`one_sided` is true, several contacts stop sticking at once and the factor has a kink: the derivative holds on one
    side of it. If a motion of the object is free, as for two hard fingers in space, derivatives with respect to points, normals and loads are NaN.
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
    """Derivatives with respect to contact points along the coordinate axes, with constant normals, 1/m, shape (..., n, c)."""
    normals: Array
    """Derivatives with respect to unit normals, tangential, 1/rad, shape (..., n, c). Springs, commands and clearances tilt with the frame."""
    command_world: Array
    """Derivatives with respect to commands along the coordinate axes, 1/m, shape (..., n, c)."""
    series_stiffness: Array
    """Derivatives with respect to normal and tangential stiffness, m/N, shape (..., n, 2). Both tangents change together; commands (m) do not."""
    friction: Array
    """Derivatives with respect to friction coefficients, shape (..., n)."""
    base: Array
    """Derivatives with respect to the base load, 1/N and 1/(N m), shape (..., d)."""

    @property
    def direction(self) -> Array:
        """Derivatives with respect to the direction of the load, shape (..., d): the factor times those with respect to the base load."""
        with np.errstate(invalid="ignore"):
            return self.factor[..., None] * self.base

    def __repr__(self) -> str:
        known = int(np.count_nonzero(self.contact >= 0))
        return f"<OnsetGradients {self.status.shape}: {known} with a factor, {int(self.one_sided.sum())} one-sided>"


def onset_gradients(
    points: ArrayLike,
    normals: ArrayLike,
    direction: Loads,
    base: Loads | None = None,
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
    soft: Soft = None,
) -> OnsetGradients:
    """The gradients of the factors of :func:`onsets` by all data of grasps and loads, in the time of a few factors.

    Grasps must have two to five contacts, or pads with any number of points; in space each has one stiffness along both tangents. A row that
    screening does not decide has no gradient. The parameters are as in :func:`onsets`. The answer for three contacts in space takes some 300 bytes.

    With ``soft`` the derivatives are with respect to the data of whole contacts, whose points move and share their springs with them. A grasp with
    pads takes some microseconds a point, in array operations.
    """
    shape, made, first, second, own = asked(
        points, normals, direction, base, friction, hold, soft, series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, tangents=tangents,
    )  # fmt: skip
    if soft is not None:
        return _with_pads(shape, made, first, second, own)
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


def _with_pads(shape: tuple[int, ...], made: dict[str, Any], base: Array, direction: Array, own: bool) -> OnsetGradients:
    """Gradients of grasps with pads: derivatives with respect to data of points are summed for each pad."""
    from ._arrays.first_exit import FirstExit
    from ._arrays.pads import Pads
    from ._arrays.program import Kind, gradients

    factor, status, leaving = _grasp_lcp.onsets_of_rows(made, base, direction, own, False)
    rows, contacts, axes = made["points"].shape
    if not own:
        loads = len(direction)
        made = {
            name: column if name in ("hold", "soft") or column is None else np.repeat(column, loads, axis=0)
            for name, column in made.items()
        }
        base, direction = np.tile(base, (rows, 1)), np.tile(direction, (rows, 1))
    pads = Pads(_grasp_lcp.points_of_pads(made["soft"], axes))
    codes = np.zeros(contacts, dtype=np.uint8) if made["hold"] is None else made["hold"]
    words = tuple(list(HOLDS)[codes[i]] for i in pads.owner)
    with np.errstate(all="ignore"):
        normals = _unit(made["normals"])
        stiffness, command = _springs(made), _commands(made, normals)
        data = [made["points"], normals, made["friction"], stiffness, command, base, direction]
        at_points = pads.spread(np, data, made["tangents"])
        points, n, mu, k, told, _, _ = at_points
        leaves = onsets(points, n, direction, base, friction=mu, series_stiffness=k, command_world=told, hold=words).leaving
        known = (status.ravel() == OnsetStatus.LEAVES) & leaves.any(axis=-1)
        found = FirstExit(factor.ravel(), status, np.where(known, leaves.argmax(axis=-1), -1))
        slopes = gradients(np, float(np.finfo(np.float64).eps), Kind(words, bool(base.any()), True), at_points, found)
        by = pads.gathered(slopes, normals, pads.arms(np, normals, made["tangents"]))
        # The array program keeps commands constant along the coordinate axes; in this answer they tilt with the contact frame.
        along, pressed = ((each * normals).sum(axis=-1, keepdims=True) for each in (command, by[4]))
        by[1] = by[1] + (by[4] * along - command * pressed)
    by = [np.where(known.reshape(-1, *(1,) * (each.ndim - 1)), each, np.nan).reshape(*shape, *each.shape[1:]) for each in by]
    return OnsetGradients(
        factor=factor.reshape(shape),
        status=status.reshape(shape),
        leaving=leaving.reshape(*shape, contacts),
        contact=np.where(known, np.array(pads.owner)[found.contact], -1).reshape(shape),
        one_sided=(known & (leaves.sum(axis=-1) > 1)).reshape(shape),
        points=by[0],
        normals=by[1],
        friction=by[2],
        series_stiffness=by[3],
        command_world=by[4],
        base=by[5],
    )


def _unit(given: Array) -> Array:
    scaled = given / np.abs(given).max(axis=-1, keepdims=True)
    return np.asarray(scaled / np.linalg.norm(scaled, axis=-1, keepdims=True))


def _springs(made: dict[str, Any]) -> Array:
    """Normal and tangential series stiffness."""
    sides = [made[name] for name in ("body_stiffness", "finger_stiffness") if made[name] is not None]
    series = made["series_stiffness"] if not sides else 1 / sum(1 / each for each in sides)
    return np.asarray(series[..., :2])


def _commands(made: dict[str, Any], normals: Array) -> Array:
    """Commands minus clearances, along the coordinate axes."""
    from ._arrays.pads import frames

    command = np.zeros_like(normals) if made["command_world"] is None else made["command_world"]
    if made["command"] is not None:
        axes = [normals, *frames(np, normals, made["tangents"])]
        command = sum(made["command"][..., k, None] * axis for k, axis in enumerate(axes))
    gap = 0.0 if made["clearance"] is None else made["clearance"][..., None]
    if made["pressed_with"] is not None:
        along = (command * normals).sum(axis=-1, keepdims=True)
        gap = along - (made["pressed_with"] / _springs(made)[..., 0])[..., None]
    return np.asarray(command - normals * gap)
