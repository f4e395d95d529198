"""The onsets of many scenes, from arrays as :func:`grasp_lcp.onsets` takes them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .edges import Pair, Triangle
from .first_exit import MALFORMED, NOT_A_NUMBER, UNCLEAR, FirstExit, first_exit
from .forces import Body, Commands, Forces
from .sites import OPENS_ONLY, STAYS, Row, Sites, Tolerances, Vector, across, dot

REFINED = 3
"""Number of refinements of the thorough pass."""


class Scenes:
    """Scenes (grasps) with the same number of contacts, each with its data and loads.

    ``data`` holds points (B, n, c), unit normals (B, n, c), friction (B, n), normal and tangential stiffness (B, n, 2), commands along the
    coordinate axes (B, n, c), base loads (B, d) and directions (B, d). ``hold`` has one word for each contact.
    """

    def __init__(self, xp: Any, epsilon: float, data: Sequence[Any], hold: Sequence[str], *, loaded: bool, stacked: bool) -> None:
        points, normals, friction, stiffness, command, base, direction = data
        count = points.shape[-2]
        self.xp, self.loaded = xp, loaded
        self.base = tuple(base[..., k] for k in range(base.shape[-1]))
        self.direction = tuple(direction[..., k] for k in range(direction.shape[-1]))
        places: list[Any]
        if stacked:
            points, normals, stiffness, command = (xp.moveaxis(each, -2, 0) for each in (points, normals, stiffness, command))
            friction, places = xp.moveaxis(friction, -1, 0), [...]
        else:
            places = [(..., i) for i in range(count)]

        def vectors(of: Any) -> list[Vector]:
            size = range(of.shape[-1])
            return [tuple(of[..., k] if place is ... else of[(*place, k)] for k in size) for place in places]

        self.point, self.normal, self.command, self.stiffness = map(vectors, (points, normals, command, stiffness))
        self.mu = [friction[place] for place in places]
        number = [xp.cumsum(xp.ones_like(friction), axis=0) - 1.0] if stacked else list(range(count))
        springs, codes, pressed, sheared = [], [], [], []
        for mu, (k_n, k_t), n, a, at in zip(self.mu, self.stiffness, self.normal, self.command, number, strict=True):
            is_bonded, is_kept = (_is(xp, hold, word, xp.zeros_like(mu) + at) for word in ("bonded", "kept_closed"))
            slides = (mu > 0) & (mu < float("inf")) & ~is_bonded
            codes.append(xp.where(slides, mu, xp.where(is_bonded | is_kept, STAYS, OPENS_ONLY)))
            springs.append((k_n, xp.where((mu == 0) & ~is_bonded, 0.0, k_t)))
            pressed.append(dot(n, a))
            sheared.append(across(n, a))
        tolerances = Tolerances.of(epsilon)
        self.sites = Sites(xp, tolerances, count, self.point, self.normal, springs, pressed, sheared, codes, number, stacked)

    def fault(self) -> Any:
        """The status of scenes with a number that is NaN or out of range, as the first such number determines it; -1 for all others."""
        xp, fault = self.xp, None
        most = self.sites.tolerances.largest
        loads = [_outside(xp, x, most) for x in (*self.base, *self.direction)]
        is_zero = self.direction[0] == 0
        for each in self.direction[1:]:
            is_zero = is_zero & (each == 0)
        contacts: list[Any] = []
        for p, k, mu, a, (_, shear) in zip(self.point, self.stiffness, self.mu, self.command, self.sites.springs, strict=True):
            contacts += [_outside(xp, x, most) for x in p]
            contacts += [xp.where(x != x, NOT_A_NUMBER, xp.where(x > 0, -1, MALFORMED)) for x in k]
            usable = [(x >= 1.0 / most) & (x <= most) for x in k]
            contacts += [xp.where(usable[0] & (usable[1] | (shear == 0)), -1, MALFORMED)]
            allowed = (mu >= 0) & ((mu <= most) | (mu == float("inf")))
            contacts += [xp.where(mu != mu, NOT_A_NUMBER, xp.where(allowed, -1, MALFORMED))]
            contacts += [_outside(xp, x, most) for x in a]
        frames = [xp.where(sum(n) != sum(n), NOT_A_NUMBER, xp.where(dot(n, n) > 0.5, -1, MALFORMED)) for n in self.normal]
        if self.sites.stacked:
            contacts, frames = (_one_by_one(xp, each, self.sites.count) for each in (contacts, frames))
        # The crate checks the frames of contacts after all other numbers of contacts.
        kinds = [*loads, xp.where(is_zero, MALFORMED, -1), *contacts, *frames]
        for kind in reversed(kinds):
            fault = kind if fault is None else xp.where(kind >= 0, kind, fault)
        return fault

    def by_motions(self, refined: int) -> tuple[Forces, Forces]:
        """The forces at factor zero and their rates, by the displacement method."""
        sites, body = self.sites, Body(self.sites)
        nothing = tuple(0.0 * x for x in self.direction)
        base = body.sticking(Commands(sites.pressed, sites.sheared), nothing, refined)
        if self.loaded:
            base = base.plus(body.sticking(None, self.base, refined), sites.tolerances.on_the_edge / sites.tolerances.slack)
        return base, body.sticking(None, self.direction, refined)

    def along_edges(self, edges: Pair | Triangle) -> tuple[Forces, Forces]:
        """The forces at factor zero and their rates, by the force method."""
        base = edges.squeezed()
        if self.loaded:
            base = base.plus(edges.loaded(self.base), self.sites.tolerances.on_the_edge / self.sites.tolerances.slack)
        return base, edges.loaded(self.direction)

    def quickly(self) -> tuple[FirstExit, Any]:
        """The onsets by a single pass, and the scenes that need more: in these Rust would refine the forces or use another method."""
        sites = self.sites
        if (sites.axes, sites.count) == (2, 2):
            pair = Pair(sites)
            found = first_exit(sites, *self.along_edges(pair))
            return self._checked(found, pair.is_held), None
        if (sites.axes, sites.count) == (3, 3):
            triangle = Triangle(sites)
            return self._checked(first_exit(sites, *self.along_edges(triangle))), ~triangle.is_fit
        base, rates = self.by_motions(0)
        improvable = sites.tolerances.improvable
        # Forces at factor zero and rates are refined independently in Rust, so that either may need it.
        return self._checked(first_exit(sites, base, rates)), (base.unbalanced > improvable) | (rates.unbalanced > improvable)

    def thoroughly(self) -> FirstExit:
        """The onsets by the displacement method with refinement."""
        return self._checked(first_exit(self.sites, *self.by_motions(REFINED)))

    def _checked(self, found: FirstExit, is_held: Any = None) -> FirstExit:
        status = found.status if is_held is None else self.xp.where(is_held, found.status, UNCLEAR)
        fault = self.fault()
        status = self.xp.where(fault >= 0, fault, status)
        same = status == found.status
        return FirstExit(self.xp.where(same, found.factor, float("nan")), status, self.xp.where(same, found.contact, -1))


def _is(xp: Any, hold: Sequence[str], word: str, number: Row) -> Any:
    """Whether the contact with this number has ``word`` in ``hold``."""
    told = number < 0
    for i, each in enumerate(hold):
        if each == word:
            told = told | (number == i)
    return told


def _outside(xp: Any, x: Row, most: float) -> Any:
    return xp.where(x != x, NOT_A_NUMBER, xp.where(abs(x) <= most, -1, MALFORMED))


def _one_by_one(xp: Any, kinds: list[Any], count: int) -> list[Any]:
    """The first fault of each contact, as a list of rows."""
    first = kinds[-1]
    for kind in reversed(kinds[:-1]):
        first = xp.where(kind >= 0, kind, first)
    return [first[i] for i in range(count)]
