"""Force and form closure, load limits, least squeeze and weakest direction."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from ._views import Array, View, array, load_of, motion_of, number, optional_number, rows, short


class _Told(View):
    @property
    def outcome(self) -> str:
        """Outcome, in one word."""
        return str(self._tree["outcome"])

    @cached_property
    def motion(self) -> Array | None:
        """Unit motion that no contact resists, m and rad, shape (d,); None for outcomes without a motion.

        For a load limit it is the motion on which a larger load does more work than forces within the budget can absorb.
        """
        found = self._tree.get("motion")
        return None if found is None else motion_of(found)

    @cached_property
    def bodies(self) -> dict[str, Array]:
        """Motion of each of several bodies by name, m and rad, shape (d,). Empty for a single body."""
        return {str(tree["body"]): motion_of(tree["twist"]) for tree in self._tree.get("bodies", ())}

    @property
    def contact(self) -> int | None:
        """The index of the critical contact, from 0; None for outcomes without one."""
        found = self._tree.get("contact")
        return None if found is None else int(found)

    @cached_property
    def load(self) -> Array | None:
        """The critical load, N and N m, shape (d,); None for outcomes without one."""
        found = self._tree.get("load")
        return None if found is None else load_of(found)

    def __repr__(self) -> str:
        along = "" if self.motion is None else f", motion {short(self.motion)}"
        return f"<{type(self).__name__}: {self.outcome.replace('_', ' ')}{along}>"


class Closure(_Told):
    """Whether contact forces could balance any load: ``"closed"``, ``"open"`` (a motion that no force works against) or ``"boundary"``."""

    @property
    def closed(self) -> bool:
        """Whether contact forces could balance any load."""
        return self.outcome == "closed"

    @cached_property
    def internal(self) -> Array | None:
        """Forces that balance each other strictly inside their cones, in the contact frames, the largest 1 N, shape (n, c); None unless closed."""
        found = self._tree.get("internal")
        return None if found is None else rows(found, len(found[0]))


class WrenchBall(View):
    """The measure ε of Ferrari and Canny: contact forces within the budget can balance every load of size ε, whatever its direction.

    Moments are taken about the centroid of the contacts and divided by the largest distance of a contact from it.
    """

    @property
    def at_least(self) -> float:
        """Lower bound of ε, N."""
        return number(self._tree["at_least"])

    @property
    def at_most(self) -> float:
        """Upper bound of ε, N."""
        return number(self._tree["at_most"])

    @cached_property
    def weakest(self) -> Array:
        """The load of size 1 N in the weakest direction, with moments scaled as for ε; N and N m about the origin, shape (d,).

        More than ``at_most`` times this load cannot be balanced.
        """
        return load_of(self._tree["weakest"])

    def __repr__(self) -> str:
        return f"<WrenchBall of radius {self.at_least:.9g} to {self.at_most:.9g} N, weakest {short(self.weakest)}>"


@dataclass(frozen=True)
class Quality:
    """Loads that contacts could hold with suitable normal forces. :meth:`Grasp.onset` finds the load that the actual squeeze holds."""

    force_closure: Closure
    form_closure: Closure
    ball: WrenchBall
    grasp: Any = field(default=None, repr=False, compare=False)

    def _repr_svg_(self) -> str | None:
        """Picture of the squeezed grasp, for notebooks."""
        return None if self.grasp is None else self.grasp._held.drawn(None, f"ε = {self.epsilon:.4g} N", False)

    @property
    def epsilon(self) -> float:
        """Lower bound of the measure ε of Ferrari and Canny, N."""
        return self.ball.at_least


class LoadLimit(_Told):
    """The largest factor of a load that contact forces can balance: ``"factor"``, ``"no_base"`` or ``"undecided"``."""

    @property
    def at_least(self) -> float | None:
        """Lower bound of the factor; None without one."""
        return optional_number(self._tree.get("at_least"))

    @property
    def at_most(self) -> float | None:
        """Upper bound of the factor; None without one."""
        return optional_number(self._tree.get("at_most"))

    @cached_property
    def forces(self) -> Array | None:
        """Forces in the contact frames that balance the load at ``at_least``, N, shape (n, c)."""
        found = self._tree.get("forces")
        return None if found is None else rows(found, len(found[0]))

    def __repr__(self) -> str:
        if self.outcome == "factor":
            return f"<LoadLimit at factor {self.at_least:.9g} to {self.at_most:.9g}>"
        return super().__repr__()


class LeastSqueeze(_Told):
    """The least squeeze with which every contact sticks: ``"factor"``, ``"no_factor"``, ``"gives_way"`` or ``"undecided"``."""

    @property
    def factor(self) -> float | None:
        """Common factor of all commands, at least zero. If no factor suffices, the least factor that all other conditions need."""
        return optional_number(self._tree.get("factor"))

    def __repr__(self) -> str:
        if self.outcome == "factor":
            return f"<LeastSqueeze: {self.factor:.12g} times the commands>"
        return super().__repr__()


class WeakestDirection(_Told):
    """The least force that makes a contact slide: ``"force"``, ``"never"``, ``"gives_way"``, ``"not_sticking"`` or ``"undecided"``."""

    @property
    def size(self) -> float | None:
        """Size of the least force, N. No smaller force makes a contact slide, whatever its direction. None without a force."""
        return optional_number(self._tree.get("size"))

    @cached_property
    def direction(self) -> Array | None:
        """Unit direction of the least force, coordinate axes, shape (c,); None without a force."""
        found = self._tree.get("direction")
        return None if found is None else array(found)

    def __repr__(self) -> str:
        if self.outcome == "force" and self.direction is not None:
            return f"<WeakestDirection: {self.size:.12g} N along {short(self.direction)}>"
        return super().__repr__()
