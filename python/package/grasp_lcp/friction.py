"""Frictional contact problems (W, q, μ) that belong to no grasp: ``u = W r + q`` with Coulomb's law between u and r at each contact."""

from __future__ import annotations

import json

from numpy.typing import ArrayLike

from . import _grasp_lcp
from ._views import Array, array
from .lcp import Outcome, shaped


class FrictionOutcome(Outcome):
    """The outcome of a frictional contact problem."""

    @property
    def r(self) -> Array | None:
        """Contact forces, shape (c n,), contact by contact: the normal component, then the tangential components. None unless solved."""
        found = self._of("r")
        return None if found is None else array(found)

    @property
    def u(self) -> Array | None:
        """Velocities ``W r + q``, shape (c n,); None unless solved."""
        found = self._of("u")
        return None if found is None else array(found)

    @property
    def states(self) -> tuple[str, ...] | None:
        """State of each contact: ``"open"``, ``"sticking"`` or ``"sliding"``. None unless solved."""
        found = self._of("states")
        return None if found is None else tuple(found)


def solve(W: ArrayLike, q: ArrayLike, mu: ArrayLike) -> FrictionOutcome:
    """Solves for forces and velocities that obey Coulomb's law, on the round cone in space.

    :param W: Delassus matrix, shape (c n, c n) with c = 2 in the plane and 3 in space; any real matrix.
    :param q: velocities without contact forces, shape (c n,), contact by contact, normal component first; a positive one separates.
    :param mu: friction coefficient of each contact, finite, not negative, shape (n,).
    """
    text, line = _grasp_lcp.solve_friction(shaped("W", W, 2), shaped("q", q, 1), shaped("mu", mu, 1))
    tree = json.loads(text)
    return FrictionOutcome(tree if isinstance(tree, dict) else {tree: {}}, line)
