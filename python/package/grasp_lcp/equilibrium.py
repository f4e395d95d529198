"""An equilibrium as physics: what the object does, and what each contact carries."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ._grasp_lcp import words_of_number
from ._views import Array, View, array, label_of, load_of, motion_of, motions_of, number, optional_number, rows


class Contact(View):
    """One contact of an equilibrium. Of a soft fingertip it is one point."""

    @property
    def contact(self) -> int:
        """Its place among the contacts of the grasp, from 0."""
        return int(self._tree["contact"])

    @property
    def point(self) -> int | None:
        """Which point of a soft fingertip, from 0; None for a contact that is a point itself."""
        found = self._tree.get("point")
        return None if found is None else int(found)

    @property
    def name(self) -> str | None:
        """Its name, if it has one."""
        found = self._tree.get("name")
        return None if found is None else str(found)

    @property
    def label(self) -> str:
        """Its name, or what it is and its number."""
        label = label_of(self._tree, "contact")
        return label if self.point is None else f"{label}, point {self.point}"

    @property
    def state(self) -> str:
        """``"separated"``, ``"sticking"``, ``"sliding"`` or ``"frictionless"``."""
        return str(self._tree["state"])

    @cached_property
    def direction(self) -> Array | None:
        """Unit direction in which the finger slips over the body, coordinate axes, shape (c,); None unless it slides."""
        found = self._tree.get("direction")
        return None if found is None else array(found)

    @cached_property
    def force(self) -> Array:
        """Force on the object in the contact frame, N, shape (c,): normal (positive pushes), then tangential."""
        return array(self._tree["force"])

    @cached_property
    def force_world(self) -> Array:
        """The same force along the coordinate axes, N, shape (c,)."""
        return array(self._tree["force_world"])

    @property
    def gap(self) -> float:
        """Gap between the surfaces, m, never negative."""
        return number(self._tree["gap"])

    @cached_property
    def slip(self) -> Array:
        """Slip of the finger over the body in the contact frame, m, shape (c,); its normal component is zero."""
        return array(self._tree["slip"])

    @property
    def margin(self) -> float:
        """Friction in reserve, μ F_n - \\|F_t\\|, N; infinite with infinite friction."""
        return number(self._tree["margin"])

    @property
    def distinct(self) -> bool | None:
        """Whether working precision tells the state from its neighbours; None where that was not asked."""
        found = self._tree.get("distinct")
        return None if found is None else bool(found)

    def __repr__(self) -> str:
        return f"<Contact {self._words('contact', len(self._tree['force']))}>"


class Pad(View):
    """A soft fingertip of an equilibrium: what its points are and carry together."""

    @property
    def label(self) -> str:
        """Its name, or what it is and its number; its place among the contacts of the scene, where it counts as one."""
        return label_of(self._tree, "contact")

    @property
    def points(self) -> range:
        """Its points among the contacts of the answer."""
        first = int(self._tree["first"])
        return range(first, first + int(self._tree["points"]))

    @property
    def sliding(self) -> int:
        """How many of its points slide."""
        return int(self._tree["sliding"])

    @property
    def open(self) -> int:
        """How many of them are open."""
        return int(self._tree["open"])

    @cached_property
    def wrench(self) -> Array:
        """Force in the contact frame, N, and moment about its middle, N m: in space along the contact frame, torsion first."""
        return load_of(self._tree["wrench"])

    @property
    def margin(self) -> float:
        """Friction in reserve of all its points together, N: zero where it slides everywhere."""
        return number(self._tree["margin"])

    def __repr__(self) -> str:
        return f"<Pad {self.label}: {self.sliding} of {len(self.points)} points slide, {self.open} open, margin {words_of_number(self.margin)} N>"


class Drive(View):
    """A joint or a tendon of a hand in an equilibrium."""

    @property
    def label(self) -> str:
        """Its name, or what it is and its number."""
        kind = "joint" if "joint" in self._tree else "tendon"
        return label_of(self._tree, kind)

    @property
    def state(self) -> str:
        """What its drive does: ``"holds"``, ``"yields"`` and so on."""
        return str(self._tree["state"])

    @property
    def displacement(self) -> float | None:
        """From the posture in which the contacts were given, rad or m; None for a tendon."""
        return optional_number(self._tree.get("displacement"))

    @property
    def torque(self) -> float:
        """Torque of all drives on a joint, N m or N; of a tendon its tension, N."""
        return number(self._tree["torque"] if "torque" in self._tree else self._tree["tension"])

    @property
    def margin(self) -> float:
        """What is left of its limit, N m or N; infinite without one."""
        return number(self._tree["margin"])

    def __repr__(self) -> str:
        return f"<Drive {self._words('joint' if 'joint' in self._tree else 'tendon', 2)}>"


class Equilibrium(View):
    """An equilibrium under a load. n contacts of c axes, an object of d coordinates: c, d = 2, 3 in the plane and 3, 6 in space."""

    @cached_property
    def load(self) -> Array:
        """The load it balances: force (N) and moment about the origin (N m), shape (d,)."""
        return load_of(self._tree["load"])

    @cached_property
    def twist(self) -> Array:
        """Motion of the object: translation of the origin (m) and rotation (rad), shape (d,)."""
        return motion_of(self._tree["twist"])

    @cached_property
    def bodies(self) -> dict[str, Array]:
        """Of several bodies, by name, how each moves, m and rad, shape (d,). Empty where there is one."""
        return {str(tree["body"]): motion_of(tree["twist"]) for tree in self._tree.get("bodies", ())}

    @cached_property
    def body_loads(self) -> dict[str, Array]:
        """Of several bodies, by name, the loads of their own that a program has put on, N and N m, shape (d,)."""
        return {str(tree["body"]): load_of(tree["load"]) for tree in self._tree.get("body_loads", ())}

    @cached_property
    def contacts(self) -> tuple[Contact, ...]:
        """Contact by contact, in the order of the grasp; a soft fingertip point by point."""
        return tuple(Contact(tree) for tree in self._tree["contacts"])

    @cached_property
    def pads(self) -> tuple[Pad, ...]:
        """The soft fingertips, the points of each together."""
        return tuple(Pad(tree) for tree in self._tree.get("pads", ()))

    @cached_property
    def joints(self) -> tuple[Drive, ...]:
        """The joints of a hand, finger by finger; empty without one."""
        return tuple(Drive(tree) for tree in self._tree.get("joints", ()))

    @cached_property
    def tendons(self) -> tuple[Drive, ...]:
        """The tendons of a hand."""
        return tuple(Drive(tree) for tree in self._tree.get("tendons", ()))

    @property
    def _axes(self) -> int:
        return len(self._tree["load"]["force"])

    def _column(self, name: str) -> Array:
        return rows((tree[name] for tree in self._tree["contacts"]), self._axes)

    @cached_property
    def forces(self) -> Array:
        """Forces on the object in the contact frames, N, shape (n, c); column 0 is normal and pushes."""
        return self._column("force")

    @cached_property
    def forces_world(self) -> Array:
        """The same forces along the coordinate axes, N, shape (n, c)."""
        return self._column("force_world")

    @cached_property
    def slips(self) -> Array:
        """Slips of the fingers over the body in the contact frames, m, shape (n, c)."""
        return self._column("slip")

    @cached_property
    def gaps(self) -> Array:
        """Gaps, m, shape (n,)."""
        return array([tree["gap"] for tree in self._tree["contacts"]])

    @cached_property
    def margins(self) -> Array:
        """Friction in reserve, N, shape (n,)."""
        return array([tree["margin"] for tree in self._tree["contacts"]])

    @property
    def states(self) -> tuple[str, ...]:
        """What each contact does, see :attr:`Contact.state`."""
        return tuple(str(tree["state"]) for tree in self._tree["contacts"])

    @cached_property
    def residuals(self) -> dict[str, float]:
        """How far each condition is missed, relative: equilibrium, springs, cone, gap, complementarity. Recomputed from the question."""
        return {name: number(value) for name, value in self._tree["residuals"].items()}

    @property
    def residual(self) -> float:
        """The largest of :attr:`residuals`."""
        return float(np.max(list(self.residuals.values())))

    @cached_property
    def accuracy(self) -> dict[str, float] | None:
        """Estimated error of forces (N) and displacements (m), and the condition; None where that was not asked."""
        found = self._tree.get("accuracy")
        return None if found is None else {name: number(value) for name, value in found.items()}

    @property
    def rule(self) -> str:
        """By which rule it was found; with friction there may be others."""
        return str(self._tree["rule"])

    @property
    def stored_energy(self) -> float:
        """Energy stored in the springs, J."""
        return number(self._tree["stored_energy"])

    @cached_property
    def free_motions(self) -> Array:
        """Unit motions that no contact resists, shape (k, d); the twist is known up to them."""
        return motions_of(self._tree.get("free_motions", ()), len(self.load))

    @cached_property
    def neutral_motions(self) -> Array:
        """Unit motions along which the object stays in equilibrium while its forces change, shape (k, d)."""
        return motions_of(self._tree.get("neutral_motions", ()), len(self.load))

    @property
    def pivots(self) -> int:
        """Pivots of Lemke's method."""
        return int(self._tree["pivots"])

    @property
    def is_beyond_small_motions(self) -> bool:
        """Whether the object turns, or a contact slips or opens, farther than ``small_motions`` of the settings: by default 0.1 rad, or a tenth of the
        grasp's size.

        Contact points and normals stay where they are in all that is computed here: such an answer solves the question as it was put, and says
        little about the object.
        """
        return "too_far" in self._tree

    def __repr__(self) -> str:
        return f"<Equilibrium: {self._words('equilibrium', self._axes)}>"
