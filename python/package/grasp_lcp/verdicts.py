"""Verdicts on the loads of many grasps, and the amounts that they need, on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum, unique
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _grasp_lcp
from ._columns import dumped
from ._views import Array
from .batch import Counted, Loads, Soft, asked

if TYPE_CHECKING:
    from .grasp import Settings


@unique
class VerdictStatus(IntEnum):
    """Conclusion of one row of :func:`hold_batch`; see :attr:`Verdict.holding`."""

    STICKS = 0
    """The load is held, and everything sticks."""
    SLIDES = 1
    """The load is held, and contacts slide or have slid."""
    LOOSE = 2
    """No contact presses: the object lies loose."""
    LOST = 3
    """Equilibrium is lost before the whole load is on, or motions cease to be small."""
    NO_REST = 4
    """It is proved that the load at rest has no equilibrium."""
    LOST_AT_REST = 5
    """The load at rest is lost while it grows from zero."""
    UNDECIDED = 6
    """The load could not be followed; :attr:`Verdicts.doubt` says why."""
    NOT_A_NUMBER = 7
    """A number of the row is NaN."""
    MALFORMED = 8
    """A number of the row is out of range; :class:`Grasp` names the number."""
    TURNS_OVER = 9
    """Nothing resists a rotation along which the load drives the object on. Rows of wrenches have no point of action and are not checked."""


@unique
class LossMotion(IntEnum):
    """Motion by which an object is lost; the sentence of :meth:`Grasp.hold` begins with its words."""

    DROPS = 0
    LIFTS_OFF = 1
    SLIPS_OUT = 2
    TIPS_OVER = 3
    TURNS_OUT = 4
    LETS_GO = 5
    GIVES_WAY = 6
    GOES_TOO_FAR = 7
    BUCKLES = 8
    LEAKS = 9
    TURNS_OVER = 10
    NONE = 255
    """The load is not lost up to where it was followed."""


@unique
class Doubt(IntEnum):
    """Reason for a verdict that is undecided."""

    RAY_WITHOUT_PROOF = 0
    ON_THE_BOUNDARY = 1
    INACCURATE = 2
    OUT_OF_PIVOTS = 3
    OUT_OF_STEPS = 4
    NONE = 255
    """The row is decided."""


@unique
class AmountStatus(IntEnum):
    """Conclusion of one row of :func:`need_batch`."""

    BOUND = 0
    """The amount is the least squeeze, or the greatest load."""
    ANY = 1
    """All amounts that were tried suffice."""
    NONE = 2
    """No amount suffices."""
    UNDECIDED = 3
    """The trial of an amount is undecided."""
    NOT_A_NUMBER = 4
    """A number of the row is NaN."""
    MALFORMED = 5
    """A number of the row is out of range; :class:`Grasp` names the number."""


@dataclass(frozen=True, eq=False, repr=False)
class Amounts(Counted[AmountStatus]):
    """Amounts that many grasps need; all arrays have the shape of the batch."""

    _statuses: ClassVar[type[Any]] = AmountStatus

    amount: Array
    """Multiples of the squeeze or of the load; NaN for every status but ``BOUND``."""
    status: NDArray[np.uint8]
    """The :class:`AmountStatus` of each row."""


@dataclass(frozen=True, eq=False, repr=False)
class Verdicts(Counted[VerdictStatus]):
    """Verdicts on many grasps; all arrays have the shape of the batch."""

    _statuses: ClassVar[type[Any]] = VerdictStatus

    status: NDArray[np.uint8]
    """The :class:`VerdictStatus` of each row."""
    first_slip: Array
    """Multiple of the load at first slip; ``inf`` if no contact stops sticking up to where the load was followed, NaN if none of the load is held.

    It is ``inf`` also where contacts slide from the beginning; the status of such a row that holds is ``SLIDES``."""
    held_to: Array
    """Largest multiple of the load that is held; at most 1 unless loads are followed ``beyond`` their full size."""
    gross_slip: Array
    """Multiple of the load from which everything slides; NaN if something sticks up to where the load was followed."""
    motion: NDArray[np.uint8]
    """The :class:`LossMotion` of each row."""
    doubt: NDArray[np.uint8]
    """The :class:`Doubt` of each row."""

    @property
    def holds(self) -> NDArray[np.bool_]:
        """Rows whose whole load is held; rows without an answer are false."""
        return self.status <= VerdictStatus.SLIDES

    @property
    def answered(self) -> NDArray[np.bool_]:
        """Rows that are decided."""
        open_rows = [VerdictStatus.UNDECIDED, VerdictStatus.NOT_A_NUMBER, VerdictStatus.MALFORMED]
        return np.isin(self.status, open_rows, invert=True)


def hold_batch(
    points: ArrayLike,
    normals: ArrayLike,
    load: Loads,
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
    kinetic_friction: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    hold: str | Sequence[str] = "unilateral",
    soft: Soft = None,
    settings: Settings | None = None,
    beyond: bool = False,
) -> Verdicts:
    """Whether each of many grasps holds a load that is applied from rest; see :meth:`Grasp.hold`.

    Shapes are as in :func:`onsets`, with ``load`` in place of ``direction``. Rows in which everything sticks take a few microseconds,
    rows in which contacts slide and none opens ten to a hundred. The load of any other row is followed as by :meth:`Grasp.hold`, in some 50 µs to
    a few milliseconds. The verdict of each row is that of :meth:`Grasp.hold`; its factors may differ by the error of steps along arcs. The
    bits do not depend on the number of threads. A load without a moment acts at the origin, where buckling and turning over are asked for. Of any
    other load the point of action is not known, and buckling is asked for at rest alone.

    :param load: load that grows from 0 on top of the base, N and N m, shape (..., c) or (..., d).
    :param base: load at rest; zero unless given.
    :param kinetic_friction: coefficients of friction while contacts slide, at most ``friction``, which is the default.
    :param soft: pads in place of the points, as in :meth:`Grasp.spatial`, the same for all grasps.
    :param beyond: follow every load beyond the whole of it, up to ``most_load`` of the settings, for the loads at which it is lost and from which
        everything slides. No row is then as quick as where everything sticks.

    All other parameters are as in :meth:`Grasp.planar`, with axes of the batch in front.
    """
    shape, made, first, second, own = asked(
        points, normals, load, base, friction, hold, soft, name="load", series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, kinetic_friction=kinetic_friction, tangents=tangents,
    )  # fmt: skip
    told = None if settings is None else dumped(settings)
    found = _grasp_lcp.verdicts_of_rows(made, first, second, own, told, beyond)
    return Verdicts(**{name: column.reshape(shape) for name, column in found.items()})


def need_batch(
    points: ArrayLike,
    normals: ArrayLike,
    load: Loads,
    base: Loads | None = None,
    *,
    quantity: Literal["squeeze", "load"] = "squeeze",
    sticks: bool = False,
    friction: ArrayLike = 0.0,
    series_stiffness: ArrayLike | None = None,
    body_stiffness: ArrayLike | None = None,
    finger_stiffness: ArrayLike | None = None,
    command: ArrayLike | None = None,
    command_world: ArrayLike | None = None,
    pressed_with: ArrayLike | None = None,
    clearance: ArrayLike | None = None,
    kinetic_friction: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    hold: str | Sequence[str] = "unilateral",
    soft: Soft = None,
    settings: Settings | None = None,
) -> Amounts:
    """The least multiple of the squeeze with which each of many grasps holds its load, or the greatest multiple of the load; see :meth:`Grasp.need`.

    With ``sticks`` everything must stick, and a row takes a few microseconds. Otherwise contacts may slide, and each row needs one load path up to
    the loss. Rows whose amount depends on a base load, a clearance or the limits of small motions are searched as by :meth:`Grasp.need`. As in
    :func:`hold_batch`, buckling and turning over are asked for under loads without a moment.

    :param quantity: ``"squeeze"`` or ``"load"``.
    :param sticks: whether nothing may slide.

    All other parameters are as in :func:`hold_batch`.
    """
    shape, made, first, second, own = asked(
        points, normals, load, base, friction, hold, soft, name="load", series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, kinetic_friction=kinetic_friction, tangents=tangents,
    )  # fmt: skip
    told = None if settings is None else dumped(settings)
    amount, status = _grasp_lcp.amounts_of_rows(made, (first, second), own, quantity, sticks, told)
    return Amounts(amount.reshape(shape), status.reshape(shape))
