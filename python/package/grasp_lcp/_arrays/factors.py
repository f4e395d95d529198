"""Factors ``T = L D Lᵀ`` of the symmetric matrix of each scene."""

from __future__ import annotations

from .sites import Row, Sites


class Factors:
    """L below the diagonal, and ``1/d`` of each pivot; zero where the pivot is rounding."""

    def __init__(self, sites: Sites, t: list[list[Row]], last_is_free: bool = False) -> None:
        """Factorises the matrix given on and below its diagonal. The last pivot is rounding where that is known beforehand."""
        rows = range(len(t))
        self.below: list[list[Row]] = [[None] * len(t) for _ in rows]
        self.inverse: list[Row] = []
        self.free: Row = 0.0
        """The number of pivots that are rounding."""
        scaled: list[list[Row]] = [[None] * len(t) for _ in rows]
        for column in rows:
            whole = pivot = t[column][column]
            for k in range(column):
                pivot = pivot - self.below[column][k] * scaled[k][column]
            resists = pivot > sites.tolerances.dependent * whole
            if last_is_free and column == rows[-1]:
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
        """``T⁻¹ w``; rows whose pivot is rounding contribute zero."""
        q, rows = list(w), range(len(w))
        for row in rows:
            for column in range(row):
                q[row] = q[row] - self.below[row][column] * q[column]
        q = [each * inverse for each, inverse in zip(q, self.inverse, strict=True)]
        for row in reversed(rows):
            for lower in range(row + 1, len(rows)):
                q[row] = q[row] - self.below[lower][row] * q[lower]
        return q
