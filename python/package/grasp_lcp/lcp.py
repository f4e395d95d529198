"""Linear complementarity problems that belong to no grasp: ``0 <= z ⟂ M z + q >= 0``."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _grasp_lcp
from ._columns import floats
from ._views import Array, View, array


def shaped(name: str, given: ArrayLike, dimensions: int) -> Array:
    """Converts numbers to a contiguous array and checks its number of dimensions."""
    found = floats(name, given)
    if found.ndim != dimensions:
        raise ValueError(f"{name}: shape {found.shape} given, must have {dimensions} dimensions")
    return np.ascontiguousarray(found)


class Outcome(View):
    """The outcome of a solve, with its solution or its proof."""

    def __init__(self, tree: Any, line: str = "") -> None:
        super().__init__(tree)
        self._line = line

    @property
    def outcome(self) -> str:
        """``"solved"``, ``"infeasible"`` (proved without rounding), ``"nearly_infeasible"`` or ``"no_basis"``. Three outcomes leave the problem
        undecided: ``"ray"``, ``"pivot_limit"`` and ``"breakdown"``."""
        return str(next(iter(self._tree)))

    def _of(self, name: str) -> Any:
        return self._tree[self.outcome].get(name)

    @property
    def solved(self) -> bool:
        """Whether a solution was found."""
        return self.outcome == "solved"

    @property
    def certificate(self) -> Array | None:
        """The vector that proves a problem infeasible; None for other outcomes."""
        found = self._of("y")
        return None if found is None else array(found)

    @property
    def pivots(self) -> int | None:
        """Number of pivots of Lemke's method."""
        found = self._of("pivots")
        return None if found is None else int(found)

    @property
    def residuals(self) -> dict[str, Any] | None:
        """Residuals of the conditions, recomputed from the given data."""
        found = self._of("residuals")
        return None if found is None else dict(found)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._line or self.outcome.replace('_', ' ')}>"


class LcpOutcome(Outcome):
    """The outcome of a linear complementarity problem."""

    @property
    def z(self) -> Array | None:
        """The solution z >= 0, shape (n,); None unless solved."""
        found = self._of("z")
        return None if found is None else array(found)

    @property
    def w(self) -> Array | None:
        """The slack ``w = M z + q >= 0``, shape (n,); None unless solved."""
        found = self._of("w")
        return None if found is None else array(found)

    @property
    def basis(self) -> tuple[int, ...] | None:
        """Indices of the basic components of z; None unless solved."""
        found = self._of("basis")
        return None if found is None else tuple(found)


def solve(M: ArrayLike, q: ArrayLike) -> LcpOutcome:
    """Solves ``0 <= z ⟂ M z + q >= 0`` by Lemke's method, with proofs where there is no solution.

    :param M: shape (n, n), any real matrix.
    :param q: shape (n,).
    """
    text, line = _grasp_lcp.solve_lcp(shaped("M", M, 2), shaped("q", q, 1))
    tree = json.loads(text)
    return LcpOutcome(tree if isinstance(tree, dict) else {tree: {}}, line)
