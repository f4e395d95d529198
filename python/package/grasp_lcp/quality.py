"""What contacts could hold, how much squeeze suffices, and which direction is weakest."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ._views import Array, View, array, load_of, motion_of, number, optional_number, rows, short


class _Told(View):
    @property
    def outcome(self) -> str:
        """How it ended."""
        return str(self._tree["outcome"])

    @cached_property
    def motion(self) -> Array | None:
        """A unit motion that nothing resists, or that the load makes, m and rad, shape (d,)."""
        found = self._tree.get("motion")
        return None if found is None else motion_of(found)

    @cached_property
    def bodies(self) -> dict[str, Array]:
        """Of several bodies, by name, how each moves then, m and rad, shape (d,). Empty where there is one."""
        return {str(tree["body"]): motion_of(tree["twist"]) for tree in self._tree.get("bodies", ())}

    @property
    def contact(self) -> int | None:
        """The contact that decides, from 0."""
        found = self._tree.get("contact")
        return None if found is None else int(found)

    @cached_property
    def load(self) -> Array | None:
        """The load that decides, N and N m, shape (d,)."""
        found = self._tree.get("load")
        return None if found is None else load_of(found)

    def __repr__(self) -> str:
        along = "" if self.motion is None else f", motion {short(self.motion)}"
        return f"<{type(self).__name__}: {self.outcome.replace('_', ' ')}{along}>"


class Closure(_Told):
    """Whether contact forces could balance any load: ``"closed"``, ``"open"`` (a motion that no force works against) or ``"boundary"``."""

    @property
    def closed(self) -> bool:
        """Whether they could."""
        return self.outcome == "closed"

    @cached_property
    def internal(self) -> Array | None:
        """Forces in the contact frames, the largest 1 N, strictly inside their cones, that balance each other, shape (n, c)."""
        found = self._tree.get("internal")
        return None if found is None else rows(found, len(found[0]))


class WrenchBall(View):
    """The measure ε of Ferrari and Canny: loads this large in every direction can be balanced.

    Moments are taken about the centroid of the contacts and divided by the largest distance of a contact from it.
    """

    @property
    def at_least(self) -> float:
        """ε is at least this, N."""
        return number(self._tree["at_least"])

    @property
    def at_most(self) -> float:
        """And at most this, N."""
        return number(self._tree["at_most"])

    @cached_property
    def weakest(self) -> Array:
        """The load of size 1 N in that scale in the weakest direction, N and N m about the origin, shape (d,)."""
        return load_of(self._tree["weakest"])

    def __repr__(self) -> str:
        return f"<WrenchBall of radius {self.at_least:.9g} to {self.at_most:.9g} N, weakest {short(self.weakest)}>"


@dataclass(frozen=True)
class Quality:
    """What contacts could hold if they pressed as needed. What these do, squeezed this much, is for :meth:`Grasp.onset` to say."""

    force_closure: Closure
    form_closure: Closure
    ball: WrenchBall

    @property
    def epsilon(self) -> float:
        """The measure ε of Ferrari and Canny, N; its lower bound."""
        return self.ball.at_least


class LoadLimit(_Told):
    """How far a load can grow: ``"factor"``, ``"no_base"`` or ``"undecided"``."""

    @property
    def at_least(self) -> float | None:
        """The factor is at least this."""
        return optional_number(self._tree.get("at_least"))

    @property
    def at_most(self) -> float | None:
        """And at most this."""
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
    """How much squeeze suffices: ``"factor"``, ``"no_factor"``, ``"gives_way"`` or ``"undecided"``."""

    @property
    def factor(self) -> float | None:
        """Of all commands, at least zero; where no factor suffices what other conditions need."""
        return optional_number(self._tree.get("factor"))

    def __repr__(self) -> str:
        if self.outcome == "factor":
            return f"<LeastSqueeze: {self.factor:.12g} times the commands>"
        return super().__repr__()


class WeakestDirection(_Told):
    """The least force that slides: ``"force"``, ``"never"``, ``"gives_way"``, ``"not_sticking"`` or ``"undecided"``."""

    @property
    def size(self) -> float | None:
        """Its size, N; no smaller force slides in any direction."""
        return optional_number(self._tree.get("size"))

    @cached_property
    def direction(self) -> Array | None:
        """Its unit direction, coordinate axes, shape (c,)."""
        found = self._tree.get("direction")
        return None if found is None else array(found)

    def __repr__(self) -> str:
        if self.outcome == "force" and self.direction is not None:
            return f"<WeakestDirection: {self.size:.12g} N along {short(self.direction)}>"
        return super().__repr__()
