"""Factors and derivatives for :mod:`grasp_lcp.torch` and :mod:`grasp_lcp.jax`.

Commands are given along the coordinate axes and are constant when normals change.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ._views import Array
from .batch import Onsets, onsets
from .gradients import onset_gradients

SECOND = "onset_factor has no second derivatives from the crate: those of each smooth piece of its factor come with native=True"
"""Error message for a second derivative of the crate's answer."""

Hold = str | Sequence[str]
"""The argument ``hold`` of :func:`grasp_lcp.onsets`."""


def factors(data: Sequence[Array], hold: Hold) -> Array:
    """Factors of points, normals, friction, series stiffness, commands along the coordinate axes, base load and direction."""
    return np.broadcast_to(_asked(data, hold).factor, _leading(data))


def statuses(data: Sequence[Array], hold: Hold) -> Array:
    """The :class:`grasp_lcp.OnsetStatus` of each row."""
    return np.broadcast_to(_asked(data, hold).status, _leading(data))


def _asked(data: Sequence[Array], hold: Hold) -> Onsets:
    points, normals, friction, stiffness, command, base, direction = data
    direction, base = _shared(direction, base)
    return onsets(
        points, normals, direction, base, friction=friction, series_stiffness=stiffness, command_world=command, hold=hold
    )  # fmt: skip


def factors_and_gradients(data: Sequence[Array], hold: Hold) -> list[Array]:
    """Factors, and their derivatives with respect to each array of ``data``. They are zero in rows without a factor, so that sums stay finite."""
    points, normals, friction, stiffness, command, base, direction = data
    direction, base = _shared(direction, base)
    found = onset_gradients(
        points, normals, direction, base, friction=friction, series_stiffness=stiffness, command_world=command, hold=hold
    )  # fmt: skip
    # found.normals assumes that commands tilt with the contact frame. Here commands stay along the coordinate axes: subtract that part.
    by_command = found.command_world
    along = (command * normals).sum(axis=-1, keepdims=True)
    pressed = (by_command * normals).sum(axis=-1, keepdims=True)
    by_normals = found.normals - (by_command * along - command * pressed)
    by = [found.points, by_normals, found.friction, found.series_stiffness, by_command, found.base, found.direction]
    shape = _leading(data)
    answered = found.contact >= 0
    slopes = [found.factor]
    for slope in by:
        known = answered.reshape(*answered.shape, *(1,) * (slope.ndim - answered.ndim))
        slopes.append(np.where(known, slope, 0.0))
    return [np.broadcast_to(slope, (*shape, *slope.shape[answered.ndim :])) for slope in slopes]


def _leading(data: Sequence[Array]) -> tuple[int, ...]:
    """The shape of the batch."""
    return np.broadcast_shapes(data[0].shape[:-2], data[6].shape[:-1])


def _shared(direction: Array, base: Array) -> tuple[Array, Array]:
    """A single direction and base load if all rows have the same, since one load for all grasps is faster; otherwise the given arrays."""
    rows = [load.reshape(-1, load.shape[-1]) for load in (direction, base)]
    if len(rows[0]) and all((load == load[:1]).all() for load in rows):
        return rows[0][0], rows[1][0]
    return direction, base
