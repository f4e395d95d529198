"""What measured contact forces have left, asked in a control loop."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _grasp_lcp
from .batch import OnsetStatus


class Watched(NamedTuple):
    """What measured contact forces have left."""

    margin: float
    """The least margin of a contact, N: ``μ F_n - |F_t|`` where it may slide, ``F_n`` where it can only open. Negative where a force lies outside
    of its cone; infinite if no contact can leave."""
    tightest: int
    """The contact with that margin, from 0; the first of several."""
    first_slip: float | None
    """At which multiple of the load to come the first contact stops sticking: one is enough of it. ``inf`` if none does; None where ``status``
    says why."""
    leaving: tuple[int, ...]
    """The contacts that leave there, from 0."""
    status: OnsetStatus
    """How the first slip ended."""
    extra_squeeze: float | None
    """The least part of all commands to be put on top, at once with the load to come, with which every contact keeps sticking; zero where that needs
    no more, None where none is known to suffice."""


class Watch:
    """Fingers whose forces are measured; made by :meth:`Grasp.watch`, and asked in a few microseconds.

    Only changes from what is measured go by the springs of the fingers: by the load to come and by more squeeze, as long as every contact
    sticks. What has slipped already, or is off, shows in the forces.

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
        """What forces have left that were measured just now, while a load is to come on top of the present one.

        :param forces: on the object at the contacts along the coordinate axes, N, shape (n, c).
        :param to_come: the load to come, N and N m, shape (c,) or (d,).
        :raises ValueError: where a force or a load is no finite number of at most 1e50.
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
