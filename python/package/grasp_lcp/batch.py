"""Batches of grasps, solved on all cores without the interpreter's lock."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum, unique
from typing import Any, ClassVar, Generic, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _grasp_lcp
from ._columns import columns, floats
from ._views import Array, Load

Soft = Mapping[str, Any] | Sequence[Mapping[str, Any] | None] | None
"""Pads as in scenes: one for all contacts, or a list with one or None a contact."""
Loads = Load | Sequence[Load]
"""An array of loads, or a load or a list of loads of which some are mappings."""


@unique
class OnsetStatus(IntEnum):
    """Outcome of one row of :func:`onsets`."""

    LEAVES = 0
    """Contacts stop sticking at the factor of the row."""
    NEVER = 1
    """No contact stops sticking, however large the load grows; the factor is ``inf``."""
    NOT_STICKING = 2
    """A contact slides or is open at factor 0; ``complete=True`` gives the answer of :meth:`Grasp.onset`."""
    GIVES_WAY = 3
    """The load does work on a motion that no contact resists."""
    UNCLEAR = 4
    """Rounding errors keep the single pass of screening from a decision; ``complete=True`` decides."""
    ALREADY_SLIDING = 5
    """With ``complete``: a contact slides at factor 0."""
    NO_BASE = 6
    """With ``complete``: there is no equilibrium at factor 0."""
    NOT_A_NUMBER = 7
    """A number of the row is NaN."""
    MALFORMED = 8
    """A number of the row is out of range, or its direction is zero. The error of :class:`Grasp` for this row names the number."""


@unique
class SolveStatus(IntEnum):
    """Outcome of one row of :func:`solve_batch`."""

    EQUILIBRIUM = 0
    NO_EQUILIBRIUM = 1
    """No equilibrium exists; this is proved."""
    UNDECIDED = 2
    NOT_A_NUMBER = 3
    """A number of the row is NaN."""
    MALFORMED = 4
    """A number of the row is out of range. The error of :class:`Grasp` for this row names the number."""


@unique
class ContactState(IntEnum):
    """State of a contact in :attr:`Equilibria.states`."""

    SEPARATED = 0
    STICKING = 1
    SLIDING = 2
    FRICTIONLESS = 3
    UNKNOWN = 255
    """The row has no equilibrium."""


Status = TypeVar("Status", bound=IntEnum)


class Counted(Generic[Status]):
    """Answers to the rows of a batch, counted by their status."""

    status: NDArray[np.uint8]
    _statuses: ClassVar[type[Any]]

    def count(self) -> dict[Status, int]:
        """Number of rows with each status."""
        kinds: Any = self._statuses
        counts = np.bincount(self.status.ravel(), minlength=len(kinds))
        return {each: int(counts[each]) for each in kinds if counts[each]}

    def __repr__(self) -> str:
        shown = ", ".join(f"{number} {each.name.lower()}" for each, number in self.count().items())
        return f"<{type(self).__name__} {self.status.shape}: {shown}>"


@dataclass(frozen=True, eq=False, repr=False)
class Onsets(Counted[OnsetStatus]):
    """Onsets of sliding of many grasps; all arrays have the shape of the batch."""

    _statuses: ClassVar[type[Any]] = OnsetStatus

    factor: Array
    """Factors of the directions: finite for ``LEAVES``, ``inf`` for ``NEVER``, NaN for every other status."""
    status: NDArray[np.uint8]
    """The :class:`OnsetStatus` of each row."""
    leaving: NDArray[np.bool_]
    """Whether each contact stops sticking at the factor, shape (..., n)."""

    @property
    def answered(self) -> NDArray[np.bool_]:
        """Rows that have a factor, finite or infinite."""
        return self.status <= OnsetStatus.NEVER


@dataclass(frozen=True, eq=False, repr=False)
class Equilibria(Counted[SolveStatus]):
    """Equilibria of many grasps. All arrays begin with the shape of the batch; numbers are NaN in rows without an equilibrium."""

    _statuses: ClassVar[type[Any]] = SolveStatus

    status: NDArray[np.uint8]
    """The :class:`SolveStatus` of each row."""
    twist: Array
    """Motion of the object, m and rad, shape (..., d)."""
    forces: Array
    """Forces on the object in the contact frames, N, shape (..., n, c)."""
    forces_world: Array
    """Forces on the object along the coordinate axes, N, shape (..., n, c)."""
    slips: Array
    """Slips of the fingers over the body in the contact frames, m, shape (..., n, c)."""
    gaps: Array
    """Gaps between the surfaces, m, shape (..., n)."""
    margins: Array
    """Friction in reserve, N, shape (..., n), see :attr:`Contact.margin`."""
    states: NDArray[np.uint8]
    """The :class:`ContactState` of each contact, shape (..., n)."""
    residual: Array
    """The largest relative residual of each row."""

    @property
    def answered(self) -> NDArray[np.bool_]:
        """Rows that have an equilibrium."""
        return np.equal(self.status, SolveStatus.EQUILIBRIUM)


def _axes(points: ArrayLike) -> int:
    found = floats("points", points)
    if found.ndim < 2 or found.shape[-1] not in (2, 3):
        raise ValueError(f"points: shape {found.shape} given, must be (..., n, 2) or (..., n, 3)")
    return int(found.shape[-1])


def _loads(name: str, given: Loads, axes: int) -> Array:
    each: Any = given
    if isinstance(each, Mapping):
        each = _grasp_lcp.load_numbers(name, each, axes)
    elif isinstance(each, Sequence) and any(isinstance(load, Mapping) for load in each):
        each = [_grasp_lcp.load_numbers(f"{name}[{k}]", load, axes) for k, load in enumerate(each)]
    found = floats(name, each)
    coordinates = 3 * (axes - 1)
    if found.ndim and found.shape[-1] == axes:
        return np.concatenate([found, np.zeros((*found.shape[:-1], coordinates - axes))], axis=-1)
    if found.ndim and found.shape[-1] == coordinates:
        return found
    raise ValueError(f"{name}: shape {found.shape} given, must end in {axes} of a force or {coordinates} of a force and a moment")


def _paired(grasps: tuple[int, ...], made: dict[str, Any], loads: Array) -> tuple[tuple[int, ...], dict[str, Any], Array, bool]:
    """Broadcasts grasps against loads.

    Returns the batch shape, the contact data, the loads as rows, and whether each grasp has its own load. If no axis of the batch belongs to both
    grasps and loads, the data are not repeated and every grasp takes all loads, which is faster.
    """
    leading = loads.shape[:-1]
    try:
        shape = np.broadcast_shapes(grasps, leading)
    except ValueError:
        raise ValueError(f"direction or load: shape {leading} of loads given for grasps of shape {grasps}, must broadcast to it") from None
    own = (1,) * (len(shape) - len(grasps)) + grasps
    of_loads = (1,) * (len(shape) - len(leading)) + leading
    split = len(shape)
    while split and own[split - 1] == 1:
        split -= 1
    if all(size == 1 for size in of_loads[:split]):
        return shape, made, np.ascontiguousarray(loads.reshape(-1, loads.shape[-1])), False
    rows = int(np.prod(shape, dtype=np.int64))
    for name, column in made.items():
        if column is not None and name not in ("hold", "soft"):
            behind = column.shape[1:]
            made[name] = np.broadcast_to(column.reshape(*own, *behind), (*shape, *behind)).reshape(rows, *behind)
    spread = np.broadcast_to(loads, (*shape, loads.shape[-1])).reshape(rows, -1)
    return shape, made, np.ascontiguousarray(spread), True


def asked(
    points: ArrayLike,
    normals: ArrayLike,
    direction: Loads,
    base: Loads | None,
    friction: ArrayLike,
    hold: str | Sequence[str],
    soft: Soft = None,
    *,
    name: str = "direction",
    **others: ArrayLike | None,
) -> tuple[tuple[int, ...], dict[str, Any], Array, Array, bool]:
    """The shape of a batch, its contact data, base loads and directions, and whether each grasp has its own load."""
    axes = _axes(points)
    leading, made = columns(axes, points, normals, friction, hold, soft, **others)
    along = _loads(name, direction, axes)
    start = np.zeros_like(along) if base is None else _loads("base", base, axes)
    try:
        both = np.concatenate(np.broadcast_arrays(start, along), axis=-1)
    except ValueError:
        raise ValueError(f"base: shape {start.shape} given for {name} of shape {along.shape}, must broadcast to it") from None
    shape, made, both, own = _paired(leading, made, both)
    first, second = np.split(both, 2, axis=-1)
    return shape, made, first, second, own


def onsets(
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
    complete: bool = False,
) -> Onsets:
    """The factor of a direction at which the first contact of each of many grasps stops sticking; see :meth:`Grasp.onset`.

    The shape of the batch is ``points.shape[:-2]`` broadcast with ``direction.shape[:-1]``; all other arguments are broadcast in the same way.
    Points of shape (B, n, c) and a direction of shape (c,) make B questions; directions of shape (B, c) give each grasp its own. Points of
    shape (B, 1, n, c) and directions of shape (S, c) make B S questions, all directions for each grasp; this is the fastest layout.

    Grasps of two to 52 contacts, with at most 64 points of pads, are screened, several in each vector register; the method of
    :meth:`Grasp.onset` answers all others. Each answer has the same bits for any number of threads. A malformed row, or a row with NaN,
    reports this in its status and does not affect other rows.

    :param points: contact points, m, shape (..., n, 2) or (..., n, 3).
    :param direction: load per unit of the factor, N and N m, shape (..., c) or (..., d); or a mapping or a list of them, as for a single grasp.
    :param base: load at factor 0, shape (..., c) or (..., d); zero unless given.
    :param soft: pads in place of the points, as in :meth:`Grasp.spatial`, the same for all grasps. A pad stops sticking where its first point does.
    :param complete: let the method of :meth:`Grasp.onset` answer rows that screening does not decide, in some 10 to 200 µs each.

    All other parameters are as in :meth:`Grasp.planar`, with axes of the batch in front. A batch has no default stiffness.
    """
    shape, made, first, second, own = asked(
        points, normals, direction, base, friction, hold, soft, series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, tangents=tangents,
    )  # fmt: skip
    factor, status, leaving = _grasp_lcp.onsets_of_rows(made, first, second, own, complete)
    return Onsets(factor.reshape(shape), status.reshape(shape), leaving.reshape(*shape, made["points"].shape[1]))


def solve_batch(
    points: ArrayLike,
    normals: ArrayLike,
    load: Loads,
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
) -> Equilibria:
    """The equilibria of many grasps under many loads. Each row has the same bits as :meth:`Grasp.solve`.

    Shapes are as in :func:`onsets`, with ``load`` in place of ``direction``.
    """
    axes = _axes(points)
    leading, made = columns(
        axes, points, normals, friction, hold, series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, tangents=tangents,
    )  # fmt: skip
    shape, made, loads, own = _paired(leading, made, _loads("load", load, axes))
    found = _grasp_lcp.equilibria_of_rows(made, loads, own)
    contacts = made["points"].shape[1]
    behind: dict[str, tuple[int, ...]] = {"status": (), "residual": (), "twist": (3 * (axes - 1),)}
    behind |= dict.fromkeys(("gaps", "margins", "states"), (contacts,))
    behind |= dict.fromkeys(("forces", "forces_world", "slips"), (contacts, axes))
    return Equilibria(**{name: found[name].reshape(*shape, *sizes) for name, sizes in behind.items()})
