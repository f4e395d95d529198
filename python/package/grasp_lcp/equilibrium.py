"""An equilibrium in physical quantities: motion of the object, forces and states of the contacts."""

from __future__ import annotations

import json
from functools import cached_property
from typing import Literal

import numpy as np

from ._grasp_lcp import LazyAnswer, words_of_number
from ._views import Array, Tree, View, array, label_of, load_of, motion_of, motions_of, number, optional_number, rows


class Contact(View):
    """One contact of an equilibrium, or one point of a soft fingertip."""

    @property
    def contact(self) -> int:
        """Index among the contacts of the grasp, from 0."""
        return int(self._tree["contact"])

    @property
    def point(self) -> int | None:
        """Index of the point in its soft fingertip, from 0; None for a point contact."""
        found = self._tree.get("point")
        return None if found is None else int(found)

    @property
    def name(self) -> str | None:
        """Name of the contact; None without one."""
        found = self._tree.get("name")
        return None if found is None else str(found)

    @property
    def label(self) -> str:
        """Name of the contact, or "contact" and its index."""
        label = label_of(self._tree, "contact")
        return label if self.point is None else f"{label}, point {self.point}"

    @property
    def state(self) -> Literal["separated", "sticking", "sliding", "frictionless"]:
        """State of the contact: ``"separated"``, ``"sticking"``, ``"sliding"`` or ``"frictionless"``."""
        state: Literal["separated", "sticking", "sliding", "frictionless"] = self._tree["state"]
        return state

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
        """Force on the object along the coordinate axes, N, shape (c,)."""
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
        """Whether working precision distinguishes the state from neighbouring ones; None if accuracy was not requested."""
        found = self._tree.get("distinct")
        return None if found is None else bool(found)

    def __repr__(self) -> str:
        return f"<Contact {self._words('contact', len(self._tree['force']))}>"


class Pad(View):
    """A soft fingertip of an equilibrium: its points, and their resultant force and moment."""

    @property
    def label(self) -> str:
        """Name of the fingertip, or "contact" and its index in the scene, where a soft fingertip counts as one contact."""
        return label_of(self._tree, "contact")

    @property
    def points(self) -> range:
        """Indices of its points among the contacts of the answer."""
        first = int(self._tree["first"])
        return range(first, first + int(self._tree["points"]))

    @property
    def sliding(self) -> int:
        """Number of its points that slide."""
        return int(self._tree["sliding"])

    @property
    def open(self) -> int:
        """Number of its points that are open."""
        return int(self._tree["open"])

    @cached_property
    def wrench(self) -> Array:
        """Force in the contact frame, N, and moment about the middle of the pad, N m.

        In space the moment is in the contact frame, torsion first.
        """
        return load_of(self._tree["wrench"])

    @property
    def margin(self) -> float:
        """Friction in reserve of all its points together, N: zero if all of them slide."""
        return number(self._tree["margin"])

    def __repr__(self) -> str:
        return f"<Pad {self.label}: {self.sliding} of {len(self.points)} points slide, {self.open} open, margin {words_of_number(self.margin)} N>"


class Drive(View):
    """A joint or a tendon of a hand in an equilibrium."""

    @property
    def label(self) -> str:
        """Name of the joint or tendon, or its kind and its index."""
        kind = "joint" if "joint" in self._tree else "tendon"
        return label_of(self._tree, kind)

    @property
    def state(self) -> str:
        """State of its drive: ``"holds"``, ``"yields"`` and others."""
        return str(self._tree["state"])

    @property
    def displacement(self) -> float | None:
        """Displacement of the joint from the posture in which the contacts were given, rad or m; None for a tendon."""
        return optional_number(self._tree.get("displacement"))

    @property
    def torque(self) -> float:
        """Torque (N m) or force (N) of all drives on a joint, or the tension of a tendon (N)."""
        return number(self._tree["torque"] if "torque" in self._tree else self._tree["tension"])

    @property
    def margin(self) -> float:
        """Distance of the torque or tension from the limit of the drive, N m or N; infinite without a limit."""
        return number(self._tree["margin"])

    def __repr__(self) -> str:
        return f"<Drive {self._words('joint' if 'joint' in self._tree else 'tendon', 2)}>"


class Equilibrium(View):
    """An equilibrium under a load. n contacts of c axes, an object of d coordinates: c, d = 2, 3 in the plane and 3, 6 in space."""

    def __init__(self, tree: Tree | LazyAnswer) -> None:
        # Either the answer of the crate, whose numbers are read without JSON, or its data as a dictionary.
        self._told = tree

    @cached_property
    def _tree(self) -> Tree:
        told = self._told
        if isinstance(told, dict):
            return told
        tree: Tree = json.loads(told.json())
        return tree

    def _array(self, name: str, field: str) -> Array:
        told = self._told
        found = None if isinstance(told, dict) else told.column(name)
        if found is None:
            return self._column(field)
        found.setflags(write=False)
        return found

    @cached_property
    def load(self) -> Array:
        """The load that is balanced: force (N) and moment about the origin (N m), shape (d,)."""
        return load_of(self._tree["load"])

    @cached_property
    def twist(self) -> Array:
        """Motion of the object: translation of the origin (m) and rotation (rad), shape (d,)."""
        told = self._told
        found = None if isinstance(told, dict) else told.column("twist")
        if found is None:
            return motion_of(self._tree["twist"])
        twist: Array = found[0]
        twist.setflags(write=False)
        return twist

    @cached_property
    def bodies(self) -> dict[str, Array]:
        """Motion of each of several bodies by name, m and rad, shape (d,). Empty for a single body."""
        return {str(tree["body"]): motion_of(tree["twist"]) for tree in self._tree.get("bodies", ())}

    @cached_property
    def body_loads(self) -> dict[str, Array]:
        """Loads that a load program applies to single bodies, by name of the body, N and N m, shape (d,)."""
        return {str(tree["body"]): load_of(tree["load"]) for tree in self._tree.get("body_loads", ())}

    @cached_property
    def contacts(self) -> tuple[Contact, ...]:
        """All contacts, in the order of the grasp; each point of a soft fingertip is one of them."""
        return tuple(Contact(tree) for tree in self._tree["contacts"])

    @cached_property
    def pads(self) -> tuple[Pad, ...]:
        """The soft fingertips."""
        return tuple(Pad(tree) for tree in self._tree.get("pads", ()))

    @cached_property
    def joints(self) -> tuple[Drive, ...]:
        """The joints of a hand, finger by finger; empty without a hand."""
        return tuple(Drive(tree) for tree in self._tree.get("joints", ()))

    @cached_property
    def tendons(self) -> tuple[Drive, ...]:
        """The tendons of a hand; empty without a hand."""
        return tuple(Drive(tree) for tree in self._tree.get("tendons", ()))

    @property
    def _axes(self) -> int:
        return len(self._tree["load"]["force"])

    def _column(self, name: str) -> Array:
        axes = 1 if name in ("gap", "margin") else self._axes
        return rows((tree[name] for tree in self._tree["contacts"]), axes)

    @cached_property
    def forces(self) -> Array:
        """Forces on the object in the contact frames, N, shape (n, c); column 0 is the normal force, positive if it pushes."""
        return self._array("forces", "force")

    @cached_property
    def forces_world(self) -> Array:
        """Forces on the object along the coordinate axes, N, shape (n, c)."""
        return self._array("forces_world", "force_world")

    @cached_property
    def slips(self) -> Array:
        """Slips of the fingers over the body in the contact frames, m, shape (n, c)."""
        return self._array("slips", "slip")

    @cached_property
    def gaps(self) -> Array:
        """Gaps between the surfaces, m, shape (n,)."""
        return self._array("gaps", "gap").reshape(-1)

    @cached_property
    def margins(self) -> Array:
        """Friction in reserve, N, shape (n,), see :attr:`Contact.margin`."""
        return self._array("margins", "margin").reshape(-1)

    @property
    def states(self) -> tuple[str, ...]:
        """State of each contact, see :attr:`Contact.state`."""
        return tuple(str(tree["state"]) for tree in self._tree["contacts"])

    @cached_property
    def residuals(self) -> dict[str, float]:
        """Relative residuals of equilibrium, springs, cone, gap and complementarity, recomputed from the question."""
        return {name: number(value) for name, value in self._tree["residuals"].items()}

    @property
    def residual(self) -> float:
        """The largest of :attr:`residuals`."""
        return float(np.max(list(self.residuals.values())))

    @cached_property
    def accuracy(self) -> dict[str, float] | None:
        """Estimated errors of forces (N) and displacements (m), and the condition of the forces; None if accuracy was not requested."""
        found = self._tree.get("accuracy")
        return None if found is None else {name: number(value) for name, value in found.items()}

    @property
    def rule(self) -> str:
        """The rule by which this equilibrium was selected; with friction there may be other equilibria."""
        return str(self._tree["rule"])

    @property
    def stored_energy(self) -> float:
        """Energy stored in the springs, J."""
        return number(self._tree["stored_energy"])

    @cached_property
    def free_motions(self) -> Array:
        """Unit motions that no contact resists, shape (k, d). The twist is determined up to these motions."""
        return motions_of(self._tree.get("free_motions", ()), len(self.load))

    @cached_property
    def neutral_motions(self) -> Array:
        """Unit motions along which the object stays in equilibrium while its forces change, shape (k, d)."""
        return motions_of(self._tree.get("neutral_motions", ()), len(self.load))

    @property
    def pivots(self) -> int:
        """Number of pivots of Lemke's method."""
        return int(self._tree["pivots"])

    @property
    def is_beyond_small_motions(self) -> bool:
        """Whether the object turns, or a contact slips or opens, farther than ``small_motions`` of the settings.

        The default limits are 0.1 rad and a tenth of the size of the grasp. The theory assumes fixed contact points and normals, so that an answer
        with larger motions is inaccurate for the real object.
        """
        return "too_far" in self._tree

    def __repr__(self) -> str:
        return f"<Equilibrium: {self._words('equilibrium', self._axes)}>"
