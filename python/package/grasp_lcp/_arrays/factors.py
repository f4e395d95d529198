"""Factors ``T = L D Lᵀ`` of the symmetric matrix of each scene."""

from __future__ import annotations

from typing import Any

from .sites import Row, Sites, Vector


class AlongTheLine:
    """For two contacts in space, exchanges the rotation about the axis nearest to their line with the last coordinate; see ``screening/pinch.rs``."""

    def __init__(self, sites: Sites, point: list[Vector]) -> None:
        self.sites = sites
        x, y, z = (abs(p[1] - p[0]) for p in (point[0] if sites.stacked else zip(*point, strict=True)))
        is_x = ~(sites.larger(y, z) > x)
        self.is_axis: list[tuple[int, Any]] = [(3, is_x), (4, ~(z > y) & ~is_x)]

    def exchange(self, t: list[list[Row]]) -> None:
        """Exchanges both coordinates in a symmetric matrix, of which only the lower triangle is given."""
        for k, here in self.is_axis:
            for other in range(5):
                (r, c), (s, d) = ((k, k), (5, 5)) if other == k else ((max(k, other), min(k, other)), (5, other))
                t[r][c], t[s][d] = self._either(here, t[r][c], t[s][d])

    def exchanged(self, w: list[Row]) -> list[Row]:
        """A load or a motion with both coordinates exchanged."""
        w = list(w)
        for k, here in self.is_axis:
            w[k], w[5] = self._either(here, w[k], w[5])
        return w

    def _either(self, here: Any, a: Row, b: Row) -> tuple[Row, Row]:
        where = self.sites.xp.where
        return where(here, b, a), where(here, a, b)


class Factors:
    """L below the diagonal, and ``1/d`` of each pivot d; zero for a pivot that is a rounding error."""

    def __init__(self, sites: Sites, t: list[list[Row]], line: AlongTheLine | None = None) -> None:
        """Factorises the matrix given on and below its diagonal. Where the contacts lie on a line its last pivot is known to be rounding."""
        self.line = line
        if line is not None:
            line.exchange(t)
        rows = range(len(t))
        self.below: list[list[Row]] = [[None] * len(t) for _ in rows]
        self.inverse: list[Row] = []
        self.free: Row = 0.0
        """The number of pivots that are rounding errors: the number of free motions."""
        scaled: list[list[Row]] = [[None] * len(t) for _ in rows]
        for column in rows:
            whole = pivot = t[column][column]
            for k in range(column):
                pivot = pivot - self.below[column][k] * scaled[k][column]
            resists = pivot > sites.tolerances.dependent * whole
            if line is not None and column == rows[-1]:
                resists = resists & (pivot < 0)
            self.inverse.append(sites.xp.where(resists, 1.0 / sites.xp.where(resists, pivot, 1.0), 0.0))
            self.free = self.free + sites.xp.where(resists, 0.0, 1.0)
            for row in range(column + 1, len(t)):
                rest = t[row][column]
                for k in range(column):
                    rest = rest - self.below[row][k] * scaled[k][column]
                scaled[column][row] = rest
                self.below[row][column] = rest * self.inverse[column]

    def solve(self, w: list[Row]) -> list[Row]:
        """``T⁻¹ w``; components whose pivot is a rounding error are zero."""
        q, rows = list(w) if self.line is None else self.line.exchanged(w), range(len(w))
        for row in rows:
            for column in range(row):
                q[row] = q[row] - self.below[row][column] * q[column]
        q = [each * inverse for each, inverse in zip(q, self.inverse, strict=True)]
        for row in reversed(rows):
            for lower in range(row + 1, len(rows)):
                q[row] = q[row] - self.below[lower][row] * q[lower]
        return q if self.line is None else self.line.exchanged(q)
