"""The contacts of many scenes, one array for each quantity, and sums over contacts.

An array has one number for each scene. Contacts are a list of such arrays; a compiler fuses them into one pass with its numbers in registers. Or they
are a list of a single array with the contacts as first axis, which needs few operations for any number of contacts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any, NamedTuple

Row = Any
"""One number for each scene, or for each contact and scene."""
Vector = tuple[Row, ...]
Each = list[Row]
"""One entry for each contact, or a single entry with the contacts as first axis."""

OPENS_ONLY = -1.0
"""Code in place of a friction coefficient: the contact stops sticking only by opening."""
STAYS = 0.0
"""Code in place of a friction coefficient: the contact never stops sticking."""

FEW = 5
"""The largest number of contacts that are always added in the order of the crate. More along one axis are added in any order, at once."""


class Tolerances(NamedTuple):
    """The numbers of ``screening/tolerances.rs``, and their counterparts in single precision.

    Tolerances relative to the data grow with the rounding unit. In single precision a margin must close thirty times as fast as its rounding error,
    so that factors have at least two correct digits.
    """

    dependent: float
    on_the_edge: float
    slack: float
    solved: float
    improvable: float
    free_motion: float
    negligible: float
    sharp: float
    least_product: float
    most_product: float
    tiny: float
    largest: float
    """The largest number of any datum; its reciprocal is the least stiffness."""

    @classmethod
    def of(cls, epsilon: float) -> Tolerances:
        """The tolerances for floating-point numbers with this rounding unit."""
        if epsilon < 1e-10:
            return cls(1e-13, 1e-12, 5e-14, 1e-12, 1e-14, 1e-6, 1e-9, 1e6, 1e-140, 1e150, 2.2250738585072014e-308, 1e50)
        return cls(5e-6, 5e-5, 5e-6, 5e-5, 5e-6, 1e-3, 1e-4, 3e1, 1e-14, 1e18, 1.1754944e-38, 1e30)


@dataclass(frozen=True)
class Sites:
    """The contacts of each scene."""

    xp: Any
    tolerances: Tolerances
    count: int
    point: list[Vector]
    normal: list[Vector]
    """Unit normals into the object."""
    springs: list[tuple[Row, Row]]
    """Normal and tangential stiffness; the second is zero without friction."""
    pressed: Each
    """Commanded displacements along the normals."""
    sheared: list[Vector]
    """Commanded displacements perpendicular to the normals."""
    friction: Each
    """Friction coefficients, or one of the codes above."""
    number: Each
    """The index of the contact to which an entry belongs."""
    stacked: bool

    @property
    def axes(self) -> int:
        """Two in the plane and three in space."""
        return len(self.point[0])

    @property
    def coordinates(self) -> int:
        """The number of components of loads and of motions of the object."""
        return 3 * (self.axes - 1)

    def total(self, *terms: Each, start: Row = None) -> Row:
        """The sum over contacts of one or several terms for each contact, of :data:`FEW` contacts in the order in which the crate adds them."""
        if self.stacked and self.count <= FEW:
            terms = tuple([each[0][i] for i in range(self.count)] for each in terms)
        elif self.stacked:
            summed = kept(self.xp, self.xp.sum(sum_of(each[0] for each in terms), axis=0))
            return summed if start is None else start + summed
        rows = [term for contact in zip(*terms, strict=True) for term in contact]
        return sum_of(rows if start is None else [start, *rows])

    def most(self, of: Each) -> Row:
        """The largest entry over all contacts."""
        return self.xp.amax(of[0], axis=0) if self.stacked else reduce(self.larger, of)

    def least(self, of: Each) -> Row:
        """The smallest entry over all contacts."""
        return self.xp.amin(of[0], axis=0) if self.stacked else reduce(self.smaller, of)

    def second(self, of: Each) -> Row:
        """The second largest entry over all contacts; no entry may be negative."""
        if self.stacked:
            at = self.xp.argmax(of[0], axis=0)
            return self.most([self.xp.where(self.number[0] == at, 0.0, of[0])])
        most = second = self.xp.zeros_like(of[0])
        for each in of:
            second = self.larger(second, self.smaller(each, most))
            most = self.larger(most, each)
        return second

    def larger(self, a: Row, b: Row) -> Row:
        """The larger of two numbers; the second if one of them is NaN."""
        return self.xp.where(a > b, a, b)

    def smaller(self, a: Row, b: Row) -> Row:
        """The smaller of two numbers; the second if one of them is NaN."""
        return self.xp.where(a < b, a, b)

    def over(self, a: Row, b: Row) -> Row:
        """The quotient, and zero for a denominator of zero. All derivatives are finite."""
        is_zero = b == 0
        return self.xp.where(is_zero, 0.0, a / self.xp.where(is_zero, 1.0, b))

    def length(self, v: Sequence[Row]) -> Row:
        """The Euclidean length. Its derivatives are finite for a vector of zeros, too."""
        square = dot(v, v)
        some = square > 0
        return self.xp.where(some, self.xp.sqrt(self.xp.where(some, square, 1.0)), 0.0)

    def chosen(self, here: Each, of: Each) -> Row:
        """The entry of the contact for which ``here`` is true; zero if it is true for none."""
        return self.total([self.xp.where(at, each, 0.0) for at, each in zip(here, of, strict=True)])


def kept(xp: Any, rows: Any) -> Any:
    """The same rows, which the compiler then computes only once. Otherwise it may compute them again for each of their many uses.

    A namespace without a compiler has no function ``kept``.
    """
    return xp.kept(rows) if hasattr(xp, "kept") else rows


def sum_of(rows: Iterable[Row]) -> Row:
    """The sum of some rows, at least one."""
    return reduce(add, rows)


def dot(a: Sequence[Row], b: Sequence[Row]) -> Row:
    """The scalar product."""
    return sum_of(x * y for x, y in zip(a, b, strict=True))


def sum_of_sizes(of: Sequence[Row]) -> Row:
    """The sum of the absolute values."""
    return sum_of(abs(x) for x in of)


def cross(a: Sequence[Row], b: Sequence[Row]) -> Vector:
    """The vector product in space."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def moment(arm: Sequence[Row], force: Sequence[Row]) -> Vector:
    """The moment of a force; one component in the plane."""
    return cross(arm, force) if len(arm) == 3 else (arm[0] * force[1] - arm[1] * force[0],)


def turned(turn: Sequence[Row], arm: Sequence[Row]) -> Vector:
    """The displacement at the end of an arm by a small rotation, which has one component in the plane."""
    return cross(turn, arm) if len(arm) == 3 else (-turn[0] * arm[1], turn[0] * arm[0])


def across(normal: Sequence[Row], v: Sequence[Row]) -> Vector:
    """The tangential part of a vector: in space a vector, in the plane its component along (n_y, -n_x)."""
    if len(normal) == 2:
        return (normal[1] * v[0] - normal[0] * v[1],)
    along = dot(normal, v)
    return tuple(x - n * along for x, n in zip(v, normal, strict=True))


def world(normal: Sequence[Row], along: Row, aside: Sequence[Row]) -> Vector:
    """The vector along the coordinate axes with this normal component and this tangential part."""
    if len(normal) == 2:
        aside = (normal[1] * aside[0], -normal[0] * aside[0])
    return tuple(n * along + t for n, t in zip(normal, aside, strict=True))
