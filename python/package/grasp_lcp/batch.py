"""Many grasps at once, on all cores, without the interpreter's lock."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _grasp_lcp
from ._columns import columns, floats
from ._views import Array


class OnsetStatus(IntEnum):
    """How one row of :func:`onsets` ended."""

    LEAVES = 0
    """Contacts stop sticking at the factor."""
    NEVER = 1
    """However large the load grows, nothing leaves; the factor is ``inf``."""
    NOT_STICKING = 2
    """Something slides or is open at factor 0; ``complete=True`` says more."""
    GIVES_WAY = 3
    """The load works on a motion that no contact resists."""
    UNCLEAR = 4
    """Single passes of floating-point arithmetic do not tell; ``complete=True`` does."""
    ALREADY_SLIDING = 5
    """With ``complete``: something slides at factor 0."""
    NO_BASE = 6
    """With ``complete``: there is no equilibrium at factor 0."""
    NOT_A_NUMBER = 7
    """A number of the row is NaN."""
    MALFORMED = 8
    """A number of the row is out of range, or its direction zero; :class:`Grasp` says which."""


class SolveStatus(IntEnum):
    """How one row of :func:`solve_batch` ended."""

    EQUILIBRIUM = 0
    NO_EQUILIBRIUM = 1
    """None exists, and that is proved."""
    UNDECIDED = 2
    NOT_A_NUMBER = 3
    """A number of the row is NaN."""
    MALFORMED = 4
    """A number of the row is out of range; :class:`Grasp` says which."""


class ContactState(IntEnum):
    """What a contact does in :attr:`Equilibria.states`."""

    SEPARATED = 0
    STICKING = 1
    SLIDING = 2
    FRICTIONLESS = 3
    UNKNOWN = 255
    """There is no equilibrium."""


@dataclass(frozen=True, eq=False)
class Onsets:
    """Onsets of sliding of many grasps; all arrays have the shape of the batch."""

    factor: Array
    """Factors of the directions; ``inf`` where nothing ever leaves, NaN for every status but these two."""
    status: NDArray[np.uint8]
    """An :class:`OnsetStatus` for each."""
    leaving: NDArray[np.bool_]
    """Which contacts leave there, shape (..., n)."""

    @property
    def answered(self) -> NDArray[np.bool_]:
        """Where there is a factor, be it infinite."""
        return self.status <= OnsetStatus.NEVER

    def count(self) -> dict[OnsetStatus, int]:
        """How many rows ended in each way."""
        return _count(OnsetStatus, self.status)

    def __repr__(self) -> str:
        return f"<Onsets {self.status.shape}: {_shown(self.count())}>"


@dataclass(frozen=True, eq=False)
class Equilibria:
    """Equilibria of many grasps; all arrays begin with the shape of the batch, numbers are NaN where there is none."""

    status: NDArray[np.uint8]
    """A :class:`SolveStatus` for each."""
    twist: Array
    """Motion of the object, m and rad, shape (..., d)."""
    forces: Array
    """Forces on the object in the contact frames, N, shape (..., n, c)."""
    forces_world: Array
    """The same along the coordinate axes, N, shape (..., n, c)."""
    slips: Array
    """Slips of the fingers over the body in the contact frames, m, shape (..., n, c)."""
    gaps: Array
    """Gaps, m, shape (..., n)."""
    margins: Array
    """Friction in reserve, N, shape (..., n)."""
    states: NDArray[np.uint8]
    """A :class:`ContactState` for each contact, shape (..., n)."""
    residual: Array
    """The largest relative residual of each."""

    @property
    def answered(self) -> NDArray[np.bool_]:
        """Where there is an equilibrium."""
        return np.equal(self.status, SolveStatus.EQUILIBRIUM)

    def count(self) -> dict[SolveStatus, int]:
        """How many rows ended in each way."""
        return _count(SolveStatus, self.status)

    def __repr__(self) -> str:
        return f"<Equilibria {self.status.shape}: {_shown(self.count())}>"


def _count(kind: Any, status: NDArray[np.uint8]) -> dict[Any, int]:
    counts = np.bincount(status.ravel(), minlength=len(kind))
    return {each: int(counts[each]) for each in kind if counts[each]}


def _shown(count: dict[Any, int]) -> str:
    return ", ".join(f"{number} {each.name.lower()}" for each, number in count.items())


def _axes(points: ArrayLike) -> int:
    found = floats("points", points)
    if found.ndim < 2 or found.shape[-1] not in (2, 3):
        raise ValueError(f"points: shape {found.shape} given, must be (..., n, 2) or (..., n, 3)")
    return int(found.shape[-1])


def _loads(name: str, given: ArrayLike, axes: int) -> Array:
    found = floats(name, given)
    coordinates = 3 * (axes - 1)
    if found.ndim and found.shape[-1] == axes:
        return np.concatenate([found, np.zeros((*found.shape[:-1], coordinates - axes))], axis=-1)
    if found.ndim and found.shape[-1] == coordinates:
        return found
    raise ValueError(f"{name}: shape {found.shape} given, must end in {axes} of a force or {coordinates} of a force and a moment")


def _paired(grasps: tuple[int, ...], made: dict[str, Any], loads: Array) -> tuple[tuple[int, ...], dict[str, Any], Array, bool]:
    """How grasps and loads go together: all loads for each grasp where their axes stand apart, else each row its own."""
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
        if column is not None and name != "hold":
            behind = column.shape[1:]
            made[name] = np.broadcast_to(column.reshape(*own, *behind), (*shape, *behind)).reshape(rows, *behind)
    spread = np.broadcast_to(loads, (*shape, loads.shape[-1])).reshape(rows, -1)
    return shape, made, np.ascontiguousarray(spread), True


def asked(
    points: ArrayLike,
    normals: ArrayLike,
    direction: ArrayLike,
    base: ArrayLike | None,
    friction: ArrayLike,
    hold: str | Sequence[str],
    **others: ArrayLike | None,
) -> tuple[tuple[int, ...], dict[str, Any], Array, Array, bool]:
    """The shape of a batch of questions for onsets, its contacts, base loads and directions, and whether each grasp has its own."""
    axes = _axes(points)
    leading, made = columns(axes, points, normals, friction, hold, **others)
    along = _loads("direction", direction, axes)
    start = np.zeros_like(along) if base is None else _loads("base", base, axes)
    try:
        both = np.concatenate(np.broadcast_arrays(start, along), axis=-1)
    except ValueError:
        raise ValueError(f"base: shape {start.shape} given for direction of shape {along.shape}, must broadcast to it") from None
    shape, made, both, own = _paired(leading, made, both)
    first, second = np.split(both, 2, axis=-1)
    return shape, made, first, second, own


def onsets(
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
    complete: bool = False,
) -> Onsets:
    """At which factor of a direction the first contact of each of many grasps stops sticking; see :meth:`Grasp.onset`.

    The shape of the batch is that of ``points.shape[:-2]`` and ``direction.shape[:-1]`` broadcast together, as all other arguments are:
    points of shape (B, n, c) with a direction of shape (c,) are B questions, with directions of shape (B, c) one for each grasp;
    points of shape (B, 1, n, c) with directions of shape (S, c) are B S questions, all directions for each grasp, which is the fastest
    way to ask them.

    Grasps of two to five contacts are screened, several in each vector register; each answer has the bits of the crate's batch, whatever
    the number of threads. Rows that are malformed or have NaN say so in their status and stop nothing.

    :param points: m, shape (..., n, 2) or (..., n, 3).
    :param direction: N and N m, shape (..., c) or (..., d).
    :param base: the load at factor 0, of such a shape; none unless said otherwise.
    :param complete: let the method of :meth:`Grasp.onset` answer what screening leaves open, at some 10 µs for each such row.

    The other parameters are those of :meth:`Grasp.planar`, with axes of the batch in front.
    """
    shape, made, first, second, own = asked(
        points, normals, direction, base, friction, hold, series_stiffness=series_stiffness, body_stiffness=body_stiffness,
        finger_stiffness=finger_stiffness, command=command, command_world=command_world, pressed_with=pressed_with,
        clearance=clearance, tangents=tangents,
    )  # fmt: skip
    factor, status, leaving = _grasp_lcp.onsets_of_rows(made, first, second, own, complete)
    return Onsets(factor.reshape(shape), status.reshape(shape), leaving.reshape(*shape, made["points"].shape[1]))


def solve_batch(
    points: ArrayLike,
    normals: ArrayLike,
    load: ArrayLike,
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
    """The equilibria of many grasps under many loads; see :meth:`Grasp.solve`, whose bits each row has.

    The shapes are those of :func:`onsets`, with a load in place of a direction.
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
