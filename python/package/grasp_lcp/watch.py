"""Margins of measured contact forces in a control loop."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _grasp_lcp
from .batch import OnsetStatus


class Watched(NamedTuple):
    """Margins of measured contact forces against slip, now and under a load to come."""

    margin: float
    """The least margin of a contact, N: ``μ F_n - |F_t|`` where it may slide, ``F_n`` where it can only open. It is negative where a measured
    force lies outside of its cone, and infinite if no contact can leave."""
    tightest: int
    """The index of the contact with the least margin, from 0; the first if several have it."""
    first_slip: float | None
    """The multiple of the load to come at which the first contact stops sticking; above one the whole load to come is held. ``inf`` if no contact
    stops sticking; None without a factor, where ``status`` gives the reason."""
    leaving: tuple[int, ...]
    """The contacts that stop sticking at the first slip, from 0."""
    status: OnsetStatus
    """Outcome of the search for the first slip."""
    extra_squeeze: float | None
    """The least relative increase of all commands with which every contact keeps sticking, if it is applied together with the load to come. Zero if
    no increase is needed, None if no increase is known to suffice."""


class Watch:
    """Computes margins of measured contact forces; made by :meth:`Grasp.watch`. A call takes a few microseconds.

    The model predicts only changes of the measured forces, by the load to come and by more squeeze, as long as every contact sticks. Past slips
    and errors of the model up to now are contained in the measured forces.

        >>> from grasp_lcp import Grasp
        >>> jaws = Grasp.planar([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 8e2], friction=0.5, pressed_with=10.0)
        >>> seen = jaws.watch()([[10, 3], [-10, 3]], [0, -5])
        >>> round(seen.margin, 12), round(seen.first_slip, 12), round(seen.extra_squeeze, 12)
        (2.0, 0.8, 0.1)
    """

    def __init__(self, held: _grasp_lcp.Watch, axes: int) -> None:
        self._held = held
        self.axes = axes

    def __call__(self, forces: ArrayLike, to_come: ArrayLike) -> Watched:
        """The margins of measured forces, and the effect of a load that will be added to the present one.

        :param forces: measured forces on the object at the contacts, along the coordinate axes, N, shape (n, c).
        :param to_come: the load to come, N and N m, shape (c,) or (d,).
        :raises ValueError: if a force or a load is not finite or exceeds 1e50 in size.
        """
        margin, tightest, status, factor, leaving, enough = self._held.look(_measured(forces), to_come)
        ended = OnsetStatus(status)
        first_slip = factor if ended <= OnsetStatus.NEVER else None
        return Watched(margin, tightest, first_slip, tuple(leaving), ended, enough)


def _measured(forces: ArrayLike) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    given = np.asarray(forces, dtype=float)
    if given.ndim != 2:
        raise ValueError(f"forces: shape {given.shape} given, must be (n, c), one row a contact")
    return given
