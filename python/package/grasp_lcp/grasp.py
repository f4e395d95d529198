"""A grasp, with all questions that can be asked of it."""

from __future__ import annotations

import json
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import wraps
from typing import Any, ParamSpec, TypedDict, TypeVar, get_args

import numpy as np
from numpy.typing import ArrayLike

from . import _grasp_lcp, drake, mujoco
from ._bodies import bodies_in_scene
from ._columns import STIFFNESSES, as_written, columns, dumped, finite, floats, listed, one_each, one_of, plain, scene_text, wrench_json
from ._drawing import draw_into
from ._hands import scene_of_hand
from ._mesh import scene_of_mesh
from ._views import Array, Load, Quantity
from .answers import Answer, Comparison, Identified, Improved, Needed, Onset, Path, Shakedown, Shaken, Solution, TurnOnset, Verdict
from .equilibrium import Equilibrium
from .quality import Closure, LeastSqueeze, LoadLimit, Quality, WeakestDirection, WrenchBall
from .watch import Watch


class Settings(TypedDict, total=False):
    """Settings of all questions, as in scenes. In space ``cone`` is ``"round"``, or ``"polygon"`` for friction on the inscribed polygon."""

    cone: str
    polygon: Mapping[str, Any]
    max_pivots: int
    most_states: int
    step_error: float
    most_steps: int
    most_load: float
    most_cycles: int
    small_motions: Mapping[str, float]


class Leg(TypedDict, total=False):
    """One leg of a load program: the changes along it. Quantities without an entry stay constant.

    A load is an array of a force (N) or of a force and a moment (N m). Commands of contacts have one row a contact, in its frame (m). Commands
    of joints have one number a joint, then one a tendon (rad or m); torques that hold joints have one number a joint (N m or N). Loads of single
    bodies are mappings from names of bodies; they begin at zero, on top of the ``load`` and the weight of the body. A ``turn``
    must be the only entry; its keys are the arguments of :meth:`Grasp.turn`.
    """

    load_by: Load
    load_to: Load
    commands_by: ArrayLike
    commands_to: ArrayLike
    joints_by: ArrayLike
    joints_to: ArrayLike
    torques_by: ArrayLike
    torques_to: ArrayLike
    body_loads_by: Mapping[str, Load]
    body_loads_to: Mapping[str, Load]
    turn: Mapping[str, Any]


P = ParamSpec("P")
R = TypeVar("R")

# Arguments of `Grasp.planar` and `Grasp.spatial` by the words that scenes and textbooks have for them.
_MEANT = {"stiffness": "series_stiffness", "mu": "friction"}


def _hinting(ask: Callable[P, R]) -> Callable[P, R]:
    """Refuses a word of :data:`_MEANT`, and a turning load without a word, with the name of the argument that is meant."""

    @wraps(ask)
    def hinted(*unnamed: P.args, **given: P.kwargs) -> R:
        name = ask.__name__
        if name == "turn" and len(unnamed) > 1:
            raise TypeError("turn: a load given without a word, must be weight= or force=")
        for word in _MEANT.keys() & given.keys():
            raise TypeError(f"{name}: {word}= given, must be {_MEANT[word]}=")
        return ask(*unnamed, **given)

    return hinted


class Grasp:
    """Fingers that hold an object: point contacts with springs and Coulomb friction, or a hand with joints.

    A grasp is made by :meth:`planar`, :meth:`spatial`, :meth:`from_mesh`, :meth:`hand`, :meth:`from_mujoco`, :meth:`from_dict` or
    :meth:`from_json`; it never changes. It has n contacts of c axes and an object of d coordinates: c, d = 2, 3 in the plane and 3, 6 in space.
    Loads are arrays of shape (c,), a force through the origin in N, or (d,), a force and a moment about the origin in N m. They may also be mappings
    as in scenes: a force at a point, ``{"force": [0, -5], "at": [0.01, 0]}``, possibly with a ``"moment"``, or a body that hangs at a point,
    ``{"mass": 0.5, "at": [0.01, 0]}``. A mass may have ``"gravity"`` (9.81 m/s² down along the last axis by default), ``"accelerated"``,
    the acceleration in m/s², ``"inertia"`` and ``"turning"``. With ``gravity`` and ``shared_by_mass``, see :meth:`of_bodies`,
    ``{"accelerated": [-2, 0]}`` accelerates all bodies.

    Normals point **into the object**, the way the finger pushes. The contact frame is (n, t) in the plane with ``t = (n_y, -n_x)``, and
    (n, t1, t2) in space with ``t2 = n x t1``. Units in these docs are SI; any consistent units work.
    """

    __slots__ = ("_held",)
    _held: _grasp_lcp.Grasp

    def __init__(self) -> None:
        raise TypeError("Grasp: make one with Grasp.planar, Grasp.spatial, Grasp.from_dict or Grasp.from_json")

    @classmethod
    def _of(cls, held: _grasp_lcp.Grasp) -> Grasp:
        grasp = object.__new__(cls)
        grasp._held = held
        return grasp

    @classmethod
    @_hinting
    def planar(
        cls,
        points: ArrayLike,
        normals: ArrayLike,
        *,
        friction: ArrayLike = 0.0,
        series_stiffness: ArrayLike | None = None,
        body_stiffness: ArrayLike | None = None,
        finger_stiffness: ArrayLike | None = None,
        command: ArrayLike | None = None,
        command_world: ArrayLike | None = None,
        pressed_with: ArrayLike | None = None,
        clearance: ArrayLike | None = None,
        tangents: ArrayLike | None = None,
        force: float | Sequence[float | None] | None = None,
        soft: Mapping[str, Any] | Sequence[Mapping[str, Any] | None] | None = None,
        suction: ArrayLike | Mapping[str, Any] | Sequence[Mapping[str, Any] | float | None] | None = None,
        kinetic_friction: float | Sequence[float | None] | None = None,
        hold: str | Sequence[str] = "unilateral",
        names: Sequence[str | None] | None = None,
        outline: ArrayLike | None = None,
        settings: Settings | None = None,
    ) -> Grasp:
        """A grasp in the plane.

        :param points: contact points, m, shape (n, 2).
        :param normals: directions into the object, of any length, shape (n, 2).
        :param friction: coefficients μ >= 0, shape (n,) or one for all; a contact with ``inf`` never slides.
        :param series_stiffness: springs of body and finger in series, N/m: one number for all axes, or ``[normal, tangential]``, or one such
            row for each contact, shape (n, 2). Give either this argument, or ``body_stiffness`` and ``finger_stiffness``. Without any of them the
            default of scenes applies, and :meth:`warnings` reports questions whose answer depends on it.
        :param body_stiffness: springs of the object at the contacts, N/m, in the same formats; ``inf`` is rigid.
        :param finger_stiffness: springs of the fingers, N/m, in the same formats.
        :param command: displacements of the fingers' cores in the contact frames, m, shape (n, 2) or (2,); normal first, positive
            pushes into the object.
        :param command_world: the same displacements along the coordinate axes, in place of ``command``.
        :param pressed_with: squeeze forces in place of normal commands, N, shape (n,) or one for all. Fingers hold the positions that give these
            forces on a fixed object. If the forces do not balance, the object moves until they do.
        :param clearance: initial gaps, m, negative for an overlap, shape (n,) or one for all.
        :param tangents: directions of the first tangent, shape (n, 2).
        :param force: constant normal forces that do not depend on the motion of the object, in place of ``pressed_with``, N. One for all, or a
            list with one or None a contact.
        :param soft: patches of soft pads in place of the points, as in scenes: ``{"pad": {"width": 0.01, "strips": 1}}`` or ``{"pair":
            {"width": 0.01}}``. One for all, or a list with one or None a contact.
        :param suction: forces with which a vacuum pulls the object onto the contacts, N. One for all, or a list with one or None a contact.
        :param kinetic_friction: coefficients of friction while contacts slide, at most ``friction``. One for all, or a list with one for each
            contact, where None means the coefficient at rest.
        :param hold: ``"unilateral"``, ``"kept_closed"`` or ``"bonded"``, one word for all or one a contact.
        :param names: names of the contacts for messages and pictures.
        :param outline: corners of the object, m, shape (k, 2), for pictures only.
        :param settings: settings of all questions.
        :raises ValueError: names the argument, its index, the value and the allowed values.
        :raises TypeError: if an argument has the wrong type, such as text in place of numbers.
        """
        made = cls._made(
            2, points, normals, friction, hold, names, outline, settings, series_stiffness=series_stiffness,
            body_stiffness=body_stiffness, finger_stiffness=finger_stiffness, command=command,
            command_world=command_world, pressed_with=pressed_with, clearance=clearance, tangents=tangents,
        )  # fmt: skip
        return made._spread(force=force, soft=soft, suction=suction, kinetic_friction=kinetic_friction)

    @classmethod
    @_hinting
    def spatial(
        cls,
        points: ArrayLike,
        normals: ArrayLike,
        *,
        friction: ArrayLike = 0.0,
        series_stiffness: ArrayLike | None = None,
        body_stiffness: ArrayLike | None = None,
        finger_stiffness: ArrayLike | None = None,
        command: ArrayLike | None = None,
        command_world: ArrayLike | None = None,
        pressed_with: ArrayLike | None = None,
        clearance: ArrayLike | None = None,
        tangents: ArrayLike | None = None,
        force: float | Sequence[float | None] | None = None,
        soft: Mapping[str, Any] | Sequence[Mapping[str, Any] | None] | None = None,
        suction: ArrayLike | Mapping[str, Any] | Sequence[Mapping[str, Any] | float | None] | None = None,
        kinetic_friction: float | Sequence[float | None] | None = None,
        hold: str | Sequence[str] = "unilateral",
        names: Sequence[str | None] | None = None,
        outline: ArrayLike | None = None,
        settings: Settings | None = None,
    ) -> Grasp:
        """A grasp in space. The parameters are as in :meth:`planar`, with 3 axes in place of 2.

        Stiffnesses are one number, ``[normal, tangential]`` or ``[normal, first tangent, second tangent]``. Without ``tangents`` the first
        tangent is the projection of the coordinate axis that is farthest from the normal.

        Soft pads are ``{"ring": {"radius": 0.008, "points": 6}}``, ``{"disc": {"radius": 0.008, "annuli": 1, "points": 6}}`` or ``{"rectangle":
        {"sides": [0.02, 0.012]}}``, whose first side lies along the first tangent. Suction may also be a cup with its lip, ``{"radius": 0.02,
        "pressure": 60000}``, m and Pa.
        """
        made = cls._made(
            3, points, normals, friction, hold, names, outline, settings, series_stiffness=series_stiffness,
            body_stiffness=body_stiffness, finger_stiffness=finger_stiffness, command=command,
            command_world=command_world, pressed_with=pressed_with, clearance=clearance, tangents=tangents,
        )  # fmt: skip
        return made._spread(force=force, soft=soft, suction=suction, kinetic_friction=kinetic_friction)

    @classmethod
    def _made(
        cls,
        axes: int,
        points: ArrayLike,
        normals: ArrayLike,
        friction: ArrayLike,
        hold: str | Sequence[str],
        names: Sequence[str | None] | None,
        outline: ArrayLike | None,
        settings: Settings | None,
        **others: ArrayLike | None,
    ) -> Grasp:
        is_left_out = all(others[name] is None for name in STIFFNESSES)
        if is_left_out:
            others["series_stiffness"] = 1.0
        leading, made = columns(axes, points, normals, friction, hold, **others)
        if leading:
            raise ValueError(f"points: {leading} grasps given, must be one, shape (n, {axes}); for many there is grasp_lcp.onsets")
        contacts = made["points"].shape[1]
        told_names = [] if names is None else [names] if isinstance(names, str) else listed("names", names, "one name a contact")
        if names is not None and len(told_names) != contacts:
            raise ValueError(f"names: {len(told_names)} given, must be {contacts}, one a contact")
        for index, one in enumerate(told_names):
            if one is not None and not isinstance(one, str):
                raise TypeError(f"names[{index}]: {one!r} given, must be text or None")
        corners = None if outline is None else finite("outline", outline)
        if corners is not None and (corners.ndim != 2 or corners.shape[1] != axes):
            raise ValueError(f"outline: shape {corners.shape} given, must be (k, {axes})")
        told = None if settings is None else dumped(settings)
        grasp = cls._of(_grasp_lcp.Grasp.of_columns(made, told_names, corners, told))
        if not is_left_out:
            return grasp
        # Without the field the scene has the default stiffness, and its warnings report answers that depend on it.
        scene = grasp.to_dict()
        for contact in scene["planar" if axes == 2 else "spatial"]["contacts"]:
            contact.pop("series_stiffness")
        return cls.from_dict(scene)

    def _spread(self, **given: Any) -> Grasp:
        """This grasp with further contact data, which its scene has: constant forces, soft pads, suction, kinetic friction, surfaces."""
        told = {name: one_each(name, value, len(self)) for name, value in given.items() if value is not None}
        if not told:
            return self
        scene = self.to_dict()
        contacts = scene["planar" if self.axes == 2 else "spatial"]["contacts"]
        for name, each in told.items():
            for index, one in enumerate(each):
                if one is not None:
                    contacts[index][name] = as_written(f"{name}[{index}]", one)
        try:
            return Grasp.from_dict(scene)
        except ValueError as error:
            raise ValueError(f"{', '.join(told)}: {error}") from None

    def of_bodies(
        self,
        names: Sequence[str],
        on: Sequence[str | int | None] | ArrayLike,
        against: Sequence[str | int | None] | ArrayLike | None = None,
        *,
        mass: ArrayLike | None = None,
        centre_of_mass: ArrayLike | None = None,
        load: Sequence[Load] | None = None,
        gravity: ArrayLike | None = None,
        loaded: str | None = None,
        shared_by_mass: bool = False,
        links: Sequence[Mapping[str, Any]] | None = None,
    ) -> Grasp:
        """These contacts between several bodies, in place of one object: ``Grasp.planar(points, normals, ...).of_bodies(...)``.

        :param names: names of the b bodies.
        :param on: for each contact the body that its normal points into, by name or by number from 0.
        :param against: for each contact the body on its other side; None or -1, the default, for the ground or a finger.
        :param mass: masses, kg, shape (b,) or one for all. A mass has a weight only under ``gravity``; it also shares loads with ``shared_by_mass``.
        :param centre_of_mass: centres of mass, m, shape (b, c); the origin by default.
        :param load: constant loads, one a body, N and N m about the origin, each of shape (c,) or (d,).
        :param gravity: acceleration of constant weights, m/s², shape (c,).
        :param loaded: the body on which loads of questions act; the first by default.
        :param shared_by_mass: whether loads of questions act on all bodies, each body taking the share of its mass.
        :param links: hinges, slides, springs and cables, as in scenes: ``{"hinge": {"point": [0, 0]}, "between": ["left", "right"]}``.
        :raises ValueError: names the argument or the field, the value and the allowed values.
        """
        scene = self.to_dict()
        setup = scene["planar" if self.axes == 2 else "spatial"]
        joints = None if links is None else [dict(link) for link in listed("links", links, "a list of links")]
        bodies_in_scene(
            setup, self.axes, names, {"on": on, "against": against},
            {"mass": mass, "centre_of_mass": centre_of_mass, "load": load},
            {"gravity": gravity, "loaded": loaded, "shared_by_mass": shared_by_mass, "links": joints},
        )  # fmt: skip
        return Grasp.from_dict(scene)

    @classmethod
    def from_mesh(
        cls,
        mesh: Any,
        pads: Sequence[Mapping[str, Any]],
        *,
        unit: str = "m",
        mass: float | None = None,
        density: float | None = None,
        settings: Settings | None = None,
    ) -> Grasp:
        """The grasp of pads that close on a part. Each pad touches the part where it meets the mesh, with the local normal and clearance.

        :param mesh: a mesh with ``vertices`` and ``faces``, as those of trimesh; a pair of such arrays; or the path of an STL or OBJ.
        :param pads: one mapping a pad. A shape, ``"rectangle"`` (sides, m) or ``"disc"`` (radius, m); ``"from"``, its middle before it closes, m; and
            ``"closing"``, the direction. A rectangle may be ``"round"`` (radius, m) or have ``"v_deg"`` (opening angle). ``"layer"``, ``{"modulus":
            …, "thickness": …}`` in Pa and m, takes the place of a stiffness. All else is as for a contact of a scene: ``"name"``, ``"friction"``,
            ``"pressed_with"``, ``"tangent"`` (the direction of the first side), …
        :param unit: the unit of the mesh, ``"m"``, ``"cm"``, ``"mm"`` or ``"in"``.
        :param mass: the mass of the part, kg.
        :param density: its density, kg/m³, in place of the mass; :attr:`mass` and :attr:`centre_of_mass` are then computed from it.
        :param settings: settings of all questions.
        :raises ValueError: names the pad that misses the part, or the field, the value and the allowed values. :meth:`warnings` names pads that
            partly miss the part, or lie over an edge.
        """
        return cls.from_dict(scene_of_mesh(mesh, pads, unit, mass, density, settings))

    @classmethod
    def hand(
        cls,
        points: ArrayLike,
        normals: ArrayLike,
        jacobians: ArrayLike,
        stiffness: ArrayLike,
        *,
        joints: Sequence[str] | None = None,
        command: ArrayLike | None = None,
        joint_command: ArrayLike | None = None,
        torque: ArrayLike | None = None,
        limit: float | Mapping[str, float] | Sequence[Any] | None = None,
        tendons: Sequence[Mapping[str, Any]] | None = None,
        **contacts: Any,
    ) -> Grasp:
        """A hand with m joints, from arrays: contacts, and the Jacobians that map joint velocities to contact velocities.

        :param points: contact points, m, shape (n, 2) or (n, 3).
        :param normals: directions into the object, of the same shape.
        :param jacobians: velocities of the contact points along the coordinate axes per unit velocity of each joint, shape (n, c, m). A contact
            with zeros stands still.
        :param stiffness: stiffness of the joints, N m/rad or N/m: one number, shape (m,), or a symmetric matrix, shape (m, m).
        :param joints: names of the joints.
        :param command: commanded displacements of the contacts, as for :meth:`spatial`; ``pressed_with`` commands the joints, too.
        :param joint_command: commanded displacements of the joints from their present positions, rad or m.
        :param torque: constant torques on the joints in addition to their springs, N m or N.
        :param limit: torques at which the motors stall, N m or N, one for all or one a joint with None where there is none; or mappings as in
            scenes, ``{"slips": 2.0}`` for a clutch.
        :param tendons: drives over several joints, as in scenes: ``{"arms": [...], "stiffness": ..., "pull": ..., "limit": ..., "pushes": True}``.
        :param contacts: all other arguments of :meth:`planar` and :meth:`spatial`, such as ``friction`` and ``series_stiffness``.
        :raises ValueError: names the argument, the value and the allowed values.
        """
        placed = floats("points", points)
        axes = placed.shape[-1] if placed.ndim == 2 else 3
        alone = (cls.planar if axes == 2 else cls.spatial)(points, normals, command=command, **contacts)
        given = {"command": joint_command, "torque": torque, "limit": limit}
        return cls.from_dict(scene_of_hand(alone.to_dict(), alone.axes, jacobians, stiffness, joints, given, tendons))

    @classmethod
    def from_mujoco(cls, model: Any, data: Any, body: int | str) -> Grasp:
        """The grasp of a body in a MuJoCo simulation that is at rest: its contacts, and the joints and actuators behind them. Needs ``mujoco``.

        Coordinates are along the axes of the world, with the origin at the centre of mass of the body, so that its weight is a pure force. Contact
        forces are those of the simulation. If the weight acts in the simulation, pass it as the ``base`` of questions.

        Each contact becomes a spring. Its normal stiffness is force over depth. Tangentially it is a million times as stiff, since contacts of the
        simulation have no tangential spring. Joints have their springs, actuators the stiffness of their position gains and the limits of their
        forces. Active equality constraints become stiff rods. Torsional and rolling friction of contacts, friction and limits of joints, and
        contacts without force are ignored.

        :param model: an ``mjModel``.
        :param data: its ``mjData``, after a step or ``mj_forward``.
        :param body: the name or the number of the body that is held.
        :raises ValueError: if no contact presses on the body, if friction differs along the tangents, and if a free or ball joint moves a contact.
        """
        return cls.hand(**mujoco.hand_of_body(model, data, body))

    @classmethod
    def from_drake(cls, plant: Any, context: Any, body: str) -> Grasp:
        """The grasp of a body in a Drake simulation that is at rest, as :meth:`from_mujoco`. Needs ``drake``.

        Only point contacts are read. Joints have the springs of force elements, actuators the stiffness of their proportional gains and their
        effort limits. Hydroelastic contacts, constraints, and friction and limits of joints are ignored.

        :param plant: a finalized ``MultibodyPlant``.
        :param context: its context.
        :param body: the name of the body that is held.
        :raises ValueError: if no contact presses on the body, and if a joint with several degrees of freedom moves a contact.
        """
        return cls.hand(**drake.hand_of_body(plant, context, body))

    def draw(self, ax: Any, state: Equilibrium | None = None) -> None:
        """Draws the grasp into the axes of matplotlib: the object, its contacts, and the forces of an equilibrium.

        :param ax: axes of a plot; in space with ``projection="3d"``.
        :param state: an equilibrium of this grasp; without one only the contacts are drawn. The longest arrow has a third of the size of the grasp.
        """
        draw_into(ax, self._held.places(), self.to_dict()["planar" if self.axes == 2 else "spatial"], state)

    @property
    def mass(self) -> float | None:
        """Mass of the part, kg; None for a grasp without a mesh, and for a part without a mass or a density."""
        return self._held.part()[0]

    @property
    def centre_of_mass(self) -> Array | None:
        """Centre of mass of the part at constant density, m; None for a grasp without a mesh, and for a mesh that is not closed."""
        centre = self._held.part()[1]
        return None if centre is None else np.array(centre)

    @classmethod
    def from_json(cls, text: str) -> Grasp:
        """The grasp of a scene in JSON, possibly a hand with joints. Questions of the scene are ignored; :func:`grasp_lcp.answers` answers them."""
        return cls._of(_grasp_lcp.Grasp.of_json(text))

    @classmethod
    def from_dict(cls, scene: Mapping[str, Any]) -> Grasp:
        """The grasp of a scene given as a dictionary, see :meth:`from_json`.

        A gripper of two jaws with soft pads. One motor pulls their slides by a tendon: by 10 mm, with a stiffness of 1 kN/m, up to 12 N.

        >>> def jaw(x, way):
        ...     pad = {"point": [x, 0], "normal": [way, 0], "stiffness": [2e5, 7e4], "friction": 0.5, "soft": {"pair": {"width": 20}}}
        ...     return {"joints": [{"prismatic": [way, 0]}], "contacts": [pad]}
        >>> motor = {"name": "motor", "arms": [1, 1], "stiffness": 1000, "pull": 10, "limit": {"saturates": 12}}
        >>> hand = {"fingers": [jaw(-30, 1), jaw(30, -1)], "tendons": [motor]}
        >>> grasp = Grasp.from_dict({"format": "grasp-lcp/1", "unit": "mm", "planar": hand})
        >>> round(grasp.onset([0, -1]).factor, 2)
        9.9

        ``revolute`` joints have a ``point``, and in space an ``axis``; the arms of tendons at them are lengths. The ``pull`` of a tendon presses its
        fingers; a finger whose joints have a stiffness may have ``pressed_with`` at its contact instead. Pads in space are ``{"rectangle":
        {"sides": [a, b]}}``, with sides along the first and second tangent: y and z for a normal along x, unless ``tangent`` is given.
        """
        return cls._of(_grasp_lcp.Grasp.of_json(scene_text(scene), True))

    def to_json(self) -> str:
        """The scene of this grasp in JSON. Reading it back gives the same bits of every number."""
        return self._held.json()

    def to_dict(self) -> dict[str, Any]:
        """The scene of this grasp as a dictionary."""
        scene: dict[str, Any] = json.loads(self.to_json())
        return scene

    def __len__(self) -> int:
        """Number of contacts."""
        return self._held.contacts

    @property
    def axes(self) -> int:
        """Number of axes of a contact: 2 in the plane, 3 in space."""
        return self._held.axes

    def __repr__(self) -> str:
        setup = self.to_dict()["planar" if self.axes == 2 else "spatial"]
        contacts = [*setup.get("contacts", ()), *(c for finger in setup.get("fingers", ()) for c in finger["contacts"])]
        told = ", ".join(str(contact.get("name", index)) for index, contact in enumerate(contacts[:8]))
        more = ", ..." if len(contacts) > 8 else ""
        held = " by a hand" if "fingers" in setup else ""
        return f"<Grasp in {'the plane' if self.axes == 2 else 'space'}{held}, {len(contacts)} contacts: {told}{more}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Grasp) and other.to_json() == self.to_json()

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __reduce__(self) -> tuple[Any, ...]:
        return (Grasp.from_json, (self.to_json(),))

    def hold(
        self,
        load: Load,
        base: Load | None = None,
        *,
        together_with: Mapping[str, Load] | None = None,
    ) -> Verdict:
        """Does the grasp hold a load that grows from rest? The answer is a sentence, with first slip and gross slip as multiples of the load.

        :param load: the load that grows, N and N m, shape (c,) or (d,).
        :param base: the load at rest; zero unless given.
        :param together_with: loads on single bodies by name, in proportion to the load. The base must then be left out.
        """
        asked = {"load": wrench_json("load", load, self.axes)}
        if base is not None:
            asked["base"] = wrench_json("base", base, self.axes)
        asked.update(self._together(together_with))
        return Verdict(self._held.ask(dumped({"hold": asked})), self._held)

    def warnings(
        self,
        load: Load | None = None,
        base: Load | None = None,
    ) -> list[str]:
        """Probable mistakes in the data, one sentence each: friction in percent, lengths in mm, reversed normals, no contact that presses.

        :param load: the load that grows, as for :meth:`hold`; without a load, warnings about the contacts alone.
        :param base: the load at rest; zero unless given.
        """
        if load is None:
            if base is not None:
                raise TypeError("base: given, must be left out without a load")
            return list(self._held.warnings())
        asked = {"load": wrench_json("load", load, self.axes)}
        if base is not None:
            asked["base"] = wrench_json("base", base, self.axes)
        return list(self._held.warnings(dumped({"hold": asked})))

    def shake(
        self,
        loads: Sequence[Load],
        base: Load | None = None,
    ) -> Shaken:
        """Does the grasp survive repeated loads? Each load is applied and removed in turn, cycle after cycle. The answer holds for all cycles.

        :param loads: loads of one cycle in their order, N and N m, each of shape (c,) or (d,).
        :param base: the load at rest; zero unless given.
        """
        asked: dict[str, Any] = {"loads": [wrench_json("load", load, self.axes) for load in loads]}
        if base is not None:
            asked["base"] = wrench_json("base", base, self.axes)
        return Shaken(self._held.ask(dumped({"shake": asked})), self._held)

    def shakedown(self, loads: Sequence[Load], *, base: Load | None = None) -> Shakedown:
        """The largest multiple of repeated loads, applied in any order, at which slipping could cease after some cycles.

        :param loads: loads that are applied and removed, N and N m, each of shape (c,) or (d,).
        :param base: the load at rest; zero unless given.
        """
        asked: dict[str, Any] = {"loads": [wrench_json("load", load, self.axes) for load in loads]}
        if base is not None:
            asked["base"] = wrench_json("base", base, self.axes)
        return Shakedown(self._held.ask(dumped({"shakedown": asked})), self._held)

    def compare(self, load: Load, *, base: Load | None = None) -> Comparison:
        """Is the equilibrium the minimum of energy that the paper's quadratic program finds, and up to which fraction of the load?

        :param load: the load that grows, N and N m, of shape (c,) or (d,).
        :param base: the load at rest; zero unless given.
        """
        asked: dict[str, Any] = {"load": wrench_json("load", load, self.axes)}
        if base is not None:
            asked["base"] = wrench_json("base", base, self.axes)
        return Comparison(self._held.ask(dumped({"compare": asked})), self._held)

    def need(
        self,
        quantity: Quantity,
        load: Load | None = None,
        *,
        base: Load | None = None,
        loads: Sequence[Load] | None = None,
        any_force: float | None = None,
        at: ArrayLike | None = None,
        per_metre: Load | None = None,
        contact: int | str | None = None,
        turn: Mapping[str, Any] | None = None,
        together_with: Mapping[str, Load] | None = None,
        of: str | None = None,
        sticks: bool = False,
        may_slide: bool = False,
        repeats: bool = False,
        safety: float | None = None,
        friction_less: float | None = None,
        squeeze_less: float | None = None,
    ) -> Needed:
        """The amount that the grasp needs: least ``"squeeze"``, ``"friction"`` or ``"force"``, largest ``"load"``, ``"arm"`` or ``"angle"``.

        :param quantity: the quantity sought.
        :param load: the load. With ``any_force`` it acts in addition to that force.
        :param base: the load at rest, the same for every amount; zero unless given.
        :param loads: several loads that act one at a time, in place of ``load``.
        :param any_force: size of a force of any direction, N, that acts at ``at``.
        :param per_metre: for an arm, the change of the load per metre.
        :param contact: for friction, the contact whose coefficient is sought, by number from 0 or by name; all contacts by default.
        :param turn: for an angle, the load that turns, with the arguments of :meth:`turn`. For other quantities, the loads all along it.
        :param together_with: loads on single bodies by name, in proportion to the single load.
        :param of: for a force, the body whose load it is, or the contact, link or joint that presses; by default the load at rest.
        :param sticks: whether only the amount with which nothing slides is sought. By default the answer has it in addition to the amount that holds.
        :param may_slide: whether contacts may slide, as long as the object is held; the default unless loads repeat.
        :param repeats: whether loads are applied and removed in turn, again and again. Slipping must then cease; with ``may_slide`` it may go on, as
            long as the object does not walk.
        :param safety: factor on the loads for the safe amount.
        :param friction_less, squeeze_less: relative reductions of friction and squeeze for the safe amount; by default 0.1 and 0.05, and 0 with
            ``safety``.
        """
        asked: dict[str, Any] = {"quantity": one_of("quantity", quantity, get_args(Quantity))}
        for name, part in (("safety", safety), ("friction_less", friction_less), ("squeeze_less", squeeze_less), ("of", of)):
            if part is not None:
                asked[name] = part
        for name, wrench_given in (("base", base), ("load", load), ("per_metre", per_metre)):
            if wrench_given is not None:
                asked[name] = wrench_json(name, wrench_given, self.axes)
        if loads is not None:
            asked["loads"] = [
                wrench_json(f"loads[{k}]", each, self.axes) for k, each in enumerate(listed("loads", loads, "a list of loads"))
            ]
        for name, given in (("any_force", any_force), ("at", at)):
            if given is not None:
                asked[name] = plain(name, given)
        if contact is not None:
            asked["contact"] = self._numbered(contact)
        if turn is not None:
            if not isinstance(turn, Mapping):
                raise TypeError(f"turn: {type(turn).__name__} given, must be a mapping with the words of Grasp.turn, such as weight")
            asked["turn"] = self._turn_words(turn)
        asked["demand"] = ("stays" if may_slide else "rests") if repeats else "sticks" if sticks else "held"
        asked.update(self._together(together_with))
        return Needed(self._held.ask(dumped({"need": asked})), self._held)

    def identify(
        self,
        unknowns: str | Mapping[str, Any] | Sequence[str | Mapping[str, Any]],
        loads: ArrayLike | Sequence[Load] | Mapping[str, Any] | None = None,
        *,
        slip: str | Sequence[str] = "gross",
        base: Load | None = None,
        turns: Sequence[Mapping[str, Any]] | None = None,
        squeeze: ArrayLike = 1.0,
        scatter: ArrayLike | None = None,
        group: Sequence[Hashable] | None = None,
        layouts: Sequence[ArrayLike] | None = None,
        layout: Sequence[int] | None = None,
        known: Sequence[tuple[Sequence[int], float, float]] = (),
        outliers: float | None = None,
        iterations: int | None = None,
    ) -> Identified:
        """Estimates friction, loads of supports, squeeze or stiffness from observed slips, with standard errors.

        :param unknowns: one or several, each ``"friction"``, ``"carried"``, ``"squeeze"`` or ``"stiffness"``, or a mapping with that ``quantity``,
            the numbers or names of its ``contacts``, and optionally ``layout``, ``name`` and ``start``.
        :param loads: the load at each slip, shape (k, c) or (k, d), N and N m.
        :param slip: ``"gross"`` or ``"first"``, one for all slips or one each.
        :param base: a load that acted in addition.
        :param turns: in place of loads: turns up to the angle of each slip, with the arguments of :meth:`turn`.
        :param squeeze: multiple of the squeeze of the grasp at each slip, one for all or one each.
        :param scatter: relative standard deviation of loads, one for all or one each; estimated from the slips by default.
        :param group: a name or a number for each slip, equal for slips that may share errors, such as those of one specimen or one day. Standard
            errors then follow from the scatter between groups, and intervals from Student's distribution with their degrees of freedom.
        :param layouts: further arrangements of the contact points, each of shape (n, c).
        :param layout: the arrangement of each slip: 0 for the grasp itself, k for ``layouts[k - 1]``.
        :param known: indices of unknowns, their known sum, and its relative standard deviation.
        :param outliers: slips whose residual exceeds this number of standard deviations get less weight; 2 by default.
        :param iterations: the largest number of steps; 100 by default.
        """
        if isinstance(unknowns, (str, Mapping)):
            unknowns = [unknowns]
        slips = self._slips(loads, turns)
        words = [slip] * len(slips) if isinstance(slip, str) else listed("slip", slip, "a word, or one for each slip")
        columns: dict[str, list[Any]] = {"slip": words}
        for name, given in (("squeeze", squeeze), ("scatter", scatter)):
            if given is not None:
                columns[name] = (
                    (finite(name, given) * np.ones(len(slips))).tolist() if np.ndim(given) == 0 else finite(name, given).tolist()
                )
        if group is not None:
            numbers: dict[Hashable, int] = {}
            columns["group"] = [numbers.setdefault(name, len(numbers)) for name in listed("group", group, "a name for each slip")]
        if layout is not None:
            columns["layout"] = [int(number) for number in listed("layout", layout, "a number for each slip")]
        for name, column in columns.items():
            if len(column) != len(slips):
                raise ValueError(f"{name}: {len(column)} given, must be one for all or {len(slips)}, one a slip")
            for each, value in zip(slips, column, strict=True):
                each[name] = value
        if base is not None:
            written = wrench_json("base", base, self.axes)
            for each in slips:
                each["base"] = written
        asked: dict[str, Any] = {"unknowns": [self._unknown(k, each) for k, each in enumerate(listed("unknowns", unknowns, "a list"))]}
        asked["slips"] = slips
        if layouts is not None:
            asked["layouts"] = [finite(f"layouts[{k}]", points).tolist() for k, points in enumerate(layouts)]
        if known:
            asked["known"] = [{"unknowns": list(those), "value": value, "scatter": part} for those, value, part in known]
        for name, number in (("outliers", outliers), ("iterations", iterations)):
            if number is not None:
                asked[name] = number
        return Identified(self._held.ask(dumped({"identify": asked})), self._held)

    def _slips(
        self,
        loads: ArrayLike | Sequence[Load] | Mapping[str, Any] | None,
        turns: Sequence[Mapping[str, Any]] | None,
    ) -> list[dict[str, Any]]:
        """The load or turn of each slip, in the format of scenes."""
        if (loads is None) == (turns is None):
            raise TypeError("identify: give one of loads and turns")
        if turns is not None:
            return [{"turn": self._turn_words(turn)} for turn in listed("turns", turns, "a list of turns")]
        rows = finite("loads", self._rows(loads))
        return [{"load": wrench_json(f"loads[{k}]", row, self.axes)} for k, row in enumerate(rows)]

    def _rows(self, loads: Any) -> Array:
        """Loads as rows of an array, from an array or from a list that contains mappings."""
        each: Any = [loads] if isinstance(loads, Mapping) else loads
        if isinstance(each, Sequence) and any(isinstance(load, Mapping) for load in each):
            each = [_grasp_lcp.load_numbers(f"loads[{k}]", load, self.axes) for k, load in enumerate(each)]
        return np.atleast_2d(floats("loads", each if each is not None else ()))

    def _unknown(self, index: int, given: str | Mapping[str, Any]) -> dict[str, Any]:
        """Converts an unknown to the format of scenes, with its contacts as numbers."""
        kinds = ("friction", "carried", "squeeze", "stiffness")
        if not isinstance(given, (str, Mapping)):
            raise TypeError(f"unknowns[{index}]: {type(given).__name__} given, must be a text or a mapping with a quantity")
        written: dict[str, Any] = {"quantity": given} if isinstance(given, str) else dict(given)
        if written.get("quantity") not in kinds:
            raise ValueError(f"unknowns[{index}]: {written.get('quantity')!r} given, must be {', '.join(kinds[:-1])} or {kinds[-1]}")
        if "contacts" in written:
            contacts = written["contacts"]
            is_one = isinstance(contacts, (str, int, np.integer))
            each = [contacts] if is_one else listed(f"unknowns[{index}]['contacts']", contacts, "a list")
            written["contacts"] = [self._numbered(contact) for contact in each]
        return written

    def improve(
        self,
        load: Load | None = None,
        *,
        surfaces: Mapping[str, Any] | Sequence[Mapping[str, Any] | None] | None = None,
        at_most: float | None = None,
        base: Load | None = None,
        loads: Sequence[Load] | None = None,
        any_force: float | None = None,
        at: ArrayLike | None = None,
        goal: str | None = None,
        starts: int | None = None,
        steps: int | None = None,
        seed: int | None = None,
    ) -> Improved:
        """Searches for places and squeezes of the fingers that maximise the load at first slip, or the friction reserve under the full load.

        :param load: the load that grows; for a reserve, the load that acts in full. With ``any_force`` it acts in addition to that force.
        :param surfaces: surfaces along which contacts may move, as in scenes: in the plane ``{"segment": [[0, 0], [0, 1]]}``, ``polyline``,
            ``circle``, ``arc``, ``spline`` or ``closed_spline``, in space ``rectangle``, ``cylinder``, ``sphere`` or ``triangles``. One for all, or
            a list with one or None a contact; the surfaces of the scene by default.
        :param at_most: the largest force with which a contact may press, N. By default commands do not change.
        :param base: the load at rest, independent of the factor of the loads.
        :param loads: several loads that grow one at a time, in place of ``load``.
        :param any_force: a force of any direction that acts at ``at``. Its factor is relative to this size, N.
        :param goal: ``"first_slip"``, the default, or ``"reserve"``, the friction that is left while each load acts in full.
        :param starts: number of starts beside this grasp, 8 by default.
        :param steps: the largest number of steps from each start, 200 by default.
        :param seed: seed of the random starts.
        """
        if goal not in (None, "first_slip", "reserve"):
            raise ValueError(f"goal: {goal!r} given, must be first_slip or reserve")
        held = self if surfaces is None else self._spread(surface=surfaces)
        asked: dict[str, Any] = {}
        for name, wrench_given in (("base", base), ("load", load)):
            if wrench_given is not None:
                asked[name] = wrench_json(name, wrench_given, self.axes)
        if loads is not None:
            asked["loads"] = [
                wrench_json(f"loads[{k}]", each, self.axes) for k, each in enumerate(listed("loads", loads, "a list of loads"))
            ]
        numbers = (("any_force", any_force), ("at", at), ("at_most", at_most), ("starts", starts), ("steps", steps), ("seed", seed))
        for name, given in (*numbers, ("goal", goal)):
            if given is not None:
                asked[name] = as_written(name, given)
        return Improved(held._held.ask(dumped({"improve": asked})), held._held)

    def placed_as(self, improved: Improved) -> Grasp:
        """This grasp with the contact places and commands that :meth:`improve` has found.

        :raises ValueError: if the answer has another number of contacts, or soft fingertips.
        """
        scene = self.to_dict()
        contacts = scene["planar" if self.axes == 2 else "spatial"]["contacts"]
        if len(improved.points) != len(contacts):
            raise ValueError(f"improved: {len(improved.points)} contacts given, must be {len(contacts)}, all of them points")
        rows = zip(contacts, improved.points, improved.normals, improved.tangents, improved.commands, strict=True)
        for contact, point, normal, tangent, command in rows:
            for name in ("pressed_with", "command_world"):
                contact.pop(name, None)
            given = {"point": point, "normal": normal, "tangent": tangent, "command": command}
            contact.update({name: row.tolist() for name, row in given.items()})
        return Grasp.from_dict(scene)

    def watch(self) -> Watch:
        """Computes margins of measured contact forces in a control loop. The grasp must have two to five point contacts and no joints."""
        return Watch(self._held.watch(), self.axes)

    def solve(self, load: Load, *, together_with: Mapping[str, Load] | None = None) -> Solution:
        """The equilibrium under a load, or the proof that no equilibrium exists.

        :param load: N and N m, shape (c,) or (d,).
        :param together_with: further loads on single bodies, by name.
        """
        if together_with:
            asked = {"load": wrench_json("load", load, self.axes), **self._together(together_with)}
            return Solution(self._held.ask(dumped({"solve": asked})), self._held)
        return Solution(self._held.solve(load), self._held)

    def _together(self, loads: Mapping[str, Load] | None) -> dict[str, Any]:
        """Converts loads on single bodies, which act in proportion to the load of a question, to the format of scenes."""
        if not loads:
            return {}
        return {"together_with": {name: wrench_json(f"together_with[{name!r}]", load, self.axes) for name, load in loads.items()}}

    def onset(
        self,
        direction: Load,
        base: Load | None = None,
        *,
        command_change: ArrayLike | None = None,
        joint_change: ArrayLike | None = None,
    ) -> Onset:
        """The factor at which the first contact stops sticking under the load ``base + factor * direction``.

        :param direction: load per unit of the factor, N and N m, shape (c,) or (d,).
        :param base: load at factor 0; zero unless given.
        :param command_change: change of the commands per unit of the factor, contact frames, m, shape (n, c).
        :param joint_change: change of the commands of a hand per unit of the factor, one a joint and then one a tendon, rad or m.
        """
        if command_change is None and joint_change is None:
            return Onset(self._held.onset(direction, base), self._held)
        commands = None if command_change is None else floats("command_change", command_change)
        if commands is not None and commands.ndim != 2:
            raise ValueError(f"command_change: shape {commands.shape} given, must be (n, {self.axes})")
        joints = None if joint_change is None else finite("joint_change", joint_change).ravel().tolist()
        return Onset(self._held.onset(direction, base, commands, joints), self._held)

    @_hinting
    def turn(
        self,
        *,
        weight: ArrayLike | None = None,
        force: ArrayLike | None = None,
        at: ArrayLike | None = None,
        axis: ArrayLike | None = None,
        beside: Load | None = None,
        constant: Load | None = None,
        cosine: Load | None = None,
        sine: Load | None = None,
        angle: float | None = None,
        degrees: float | None = None,
        reversed: bool = False,
    ) -> TurnOnset:
        """The angle at which the first contact stops sticking while a load turns.

        Give a ``weight`` for an object that is tilted together with its grasp, or a ``force`` that turns, or ``cosine`` and ``sine``. Without any of
        these, the weights of the scene's bodies turn. The turn goes from x to y in the plane, and about ``axis`` by the right-hand rule in space.

        :param weight: the weight before the tilt, N, shape (c,).
        :param force: a force that turns, N, shape (c,), in place of the weight.
        :param at: the point on which weight or force acts, m, shape (c,); the origin by default.
        :param axis: in space the axis of the turn, shape (3,).
        :param beside: a constant load in addition to the turning one.
        :param constant, cosine, sine: loads of a general turn, in place of the arguments above: ``constant + cosine cos θ + sine sin θ``.
        :param angle: largest angle, rad; a full turn by default.
        :param degrees: largest angle, degrees, in place of ``angle``.
        :param reversed: whether the turn goes in the opposite direction.
        """
        return TurnOnset(self._held.turn(dumped(self._turn_words(locals()))), self._held)

    def _numbered(self, contact: int | str | None) -> int | None:
        """The number of a contact that is given by its number or its name."""
        if not isinstance(contact, str):
            return contact
        (space,) = (part for name, part in json.loads(self.to_json()).items() if name in ("planar", "spatial"))
        fingers = (finger["contacts"] for finger in space.get("fingers", ()))
        contacts = [*space.get("contacts", ()), *(contact for finger in fingers for contact in finger)]
        # Answers call a contact without a name by its number.
        names = [each.get("name") or f"contact {number}" for number, each in enumerate(contacts)]
        named = [number for number, name in enumerate(names) if name == contact]
        if len(named) != 1:
            how_many = "several are" if named else "none is"
            raise ValueError(f"contact: {how_many} called {contact!r}, must be the name of one of {names}, or a number from 0")
        return named[0]

    def _turn_words(self, words: Mapping[str, Any]) -> dict[str, Any]:
        """Converts the arguments of :meth:`turn` to the format of scenes."""
        loads = ("beside", "constant", "cosine", "sine")
        given = {name: value for name, value in words.items() if name != "self" and value is not None and value is not False}
        written = {name: wrench_json(name, value, self.axes) if name in loads else plain(name, value) for name, value in given.items()}
        if "degrees" in written:
            if "angle" in written:
                raise ValueError("degrees: given beside angle, must be alone")
            written["angle"] = np.radians(written.pop("degrees")).tolist()
        if "angle" in written:
            written["angle_rad"] = written.pop("angle")
        return written

    def follow(
        self,
        legs: Sequence[ArrayLike | Leg],
        start: Load | None = None,
        in_steps: float | None = None,
    ) -> Path:
        """Follows the path of a load program from event to event. Slips are kept from leg to leg.

        :param legs: each a :class:`Leg`, or the load at the end of the leg.
        :param start: the load at the start; zero unless given.
        :param in_steps: follows the path in steps, for hundreds of contacts and more. This is the error that a leg may add to forces, relative to
            the largest force.
        """
        asked: dict[str, Any] = {
            "legs": [self._leg(index, leg) for index, leg in enumerate(listed("legs", legs, "a list of loads or legs"))]
        }
        if start is not None:
            asked["start"] = wrench_json("start", start, self.axes)
        if in_steps is not None:
            asked["in_steps"] = float(in_steps)
        return Path(self._held.ask(dumped({"follow": asked})), self._held)

    def _leg(self, index: int, leg: ArrayLike | Leg) -> dict[str, Any]:
        name = f"legs[{index}]"
        if not isinstance(leg, Mapping) or not {"force", "moment", "mass"}.isdisjoint(leg):
            return {"load_to": wrench_json(name, leg, self.axes)}
        written = {}
        for key, value in leg.items():
            if key not in Leg.__annotations__:
                raise ValueError(f"{name}: {key!r} given, must be one of {', '.join(Leg.__annotations__)}")
            where = f"{name}[{key!r}]"
            if key.startswith("body_loads"):
                loads = dict(value) if isinstance(value, Mapping) else {}
                written[key] = {body: wrench_json(f"{where}[{body!r}]", load, self.axes) for body, load in loads.items()}
                continue
            written[key] = wrench_json(where, value, self.axes) if key in ("load_by", "load_to") else plain(where, value)
        return written

    def equilibria(self, load: Load) -> list[Equilibrium]:
        """All equilibria under a load, for a grasp with few contacts. On the round cone only those near an equilibrium on a polygon are found."""
        return [Equilibrium(tree) for tree in json.loads(self._held.equilibria(load))]

    def quality(self, budget: float = 1.0, *, each: bool = False) -> Quality:
        """Loads that contacts *could* balance with suitable normal forces: force closure, form closure, and the measure ε of Ferrari and Canny.

        ε takes moments about the centroid of the contacts. To compare it with :meth:`weakest_direction`, pass that centroid as ``at``.

        :param budget: bound of the sum of all normal forces, N, or of each one with ``each``.
        """
        ball = WrenchBall.from_json(self._held.ball(budget, each))
        return Quality(force_closure=self.force_closure(), form_closure=self.form_closure(), ball=ball, grasp=self)

    def force_closure(self) -> Closure:
        """Whether contact forces inside their cones could balance any load."""
        return Closure.from_json(self._held.closure(True))

    def form_closure(self) -> Closure:
        """Whether normal forces alone could balance any load."""
        return Closure.from_json(self._held.closure(False))

    def load_limit(
        self,
        direction: Load,
        base: Load | None = None,
        *,
        budget: float = 1.0,
        each: bool = True,
    ) -> LoadLimit:
        """The largest factor for which *some* contact forces within a budget of normal forces balance ``base + factor * direction``.

        :param budget: bound of each normal force, N, or of their sum without ``each``.
        """
        return LoadLimit.from_json(self._held.load_limit(direction, base, budget, each))

    def least_squeeze(
        self,
        loads: ArrayLike | Sequence[Load] | Mapping[str, Any] | None = None,
        *,
        any_force: float | None = None,
        base: Load | None = None,
        at: ArrayLike | None = None,
        turn: Mapping[str, Any] | None = None,
    ) -> LeastSqueeze:
        """The least common factor of all commands and vacuums with which every contact sticks under each of a set of loads.

        Give exactly one of ``loads``, ``any_force`` and ``turn``.

        :param loads: loads of shape (k, c) or (k, d), or a single load, N and N m.
        :param any_force: size of a force of any direction, N, through the point ``at`` (m), in addition to the load ``base``.
        :param turn: a load that turns, with the arguments of :meth:`turn`.
        """
        if (loads is None) + (any_force is None) + (turn is None) != 2:
            raise TypeError("least_squeeze: give one of loads, any_force and turn")
        if any_force is not None:
            return LeastSqueeze.from_json(self._held.least_squeeze_of_any_force(any_force, base, at))
        if base is not None or at is not None:
            raise TypeError("least_squeeze: base and at go with any_force alone")
        if turn is not None:
            return LeastSqueeze.from_json(self._held.least_squeeze_of_turn(dumped(self._turn_words(turn))))
        rows = self._rows(loads)
        if rows.ndim != 2:
            raise ValueError(f"loads: shape {rows.shape} given, must be (k, {self.axes}) or (k, {3 * (self.axes - 1)})")
        return LeastSqueeze.from_json(self._held.least_squeeze(rows))

    def weakest_direction(self, base: Load | None = None, at: ArrayLike | None = None) -> WeakestDirection:
        """The least force through a point that makes a contact stop sticking, and its direction, in addition to a base load.

        :param base: base load, N and N m, shape (c,) or (d,); zero unless given.
        :param at: the point, m, shape (c,); the origin by default.
        """
        return WeakestDirection.from_json(self._held.weakest_direction(base, at))

    def _resting(self) -> Solution:
        return self.solve(np.zeros(self.axes))

    def _repr_svg_(self) -> str | None:
        """Picture of the squeezed grasp without a load, for notebooks."""
        return self._resting()._repr_svg_()

    def _repr_html_(self) -> str | None:
        """A page with a spatial grasp that can be rotated, for notebooks."""
        return self._resting()._repr_html_()


# Appends the page of all fields of a scene to `help(Grasp.from_dict)`.
Grasp.from_dict.__func__.__doc__ = f"{Grasp.from_dict.__doc__}\n\n{_grasp_lcp.FIELDS}"  # type: ignore[attr-defined]

_KINDS: dict[str, type[Answer]] = {
    "hold": Verdict,
    "shake": Shaken,
    "shakedown": Shakedown,
    "compare": Comparison,
    "identify": Identified,
    "need": Needed,
    "improve": Improved,
    "solve": Solution,
    "onset": Onset,
    "onset_of_turn": TurnOnset,
    "follow": Path,
}


def answers(scene: str | Mapping[str, Any]) -> list[Answer]:
    """The answers to the questions of a scene, in their order. The scene is JSON text or a dictionary; :func:`warnings` checks it."""
    is_text = isinstance(scene, str)
    text = scene if isinstance(scene, str) else scene_text(scene)
    told = (next(iter(tree.items())) for tree in json.loads(_grasp_lcp.answers_of_scene(text, not is_text)))
    return [_KINDS[kind](json.dumps(tree)) for kind, tree in told]


def warnings(scene: str | Mapping[str, Any]) -> list[str]:
    """Probable mistakes in a scene and in the loads of its questions, one sentence each; see :meth:`Grasp.warnings`."""
    is_text = isinstance(scene, str)
    text = scene if isinstance(scene, str) else scene_text(scene)
    return _grasp_lcp.warnings_of_scene(text, not is_text)


def wrench(force: ArrayLike, moment: ArrayLike | None = None, *, at: ArrayLike | None = None) -> np.ndarray[Any, np.dtype[np.float64]]:
    """A load of a force (N) at a point and a moment (N m), reduced to the origin: shape (3,) in the plane and (6,) in space.

    The array has the line of action alone. Whether a grasp buckles or turns over depends on the point, too, which a mapping keeps:
    ``{"force": ..., "at": ...}``.

    :param force: the force, N, shape (2,) or (3,).
    :param moment: moment in addition to that of the force about the origin, N m: one number in the plane, shape (3,) in space.
    :param at: the point on which the force acts, m, of the shape of the force; the origin by default.
    """
    pull = finite("force", force)
    if pull.shape not in ((2,), (3,)):
        raise ValueError(f"force: shape {pull.shape} given, must be (2,) or (3,)")
    arm = np.zeros_like(pull) if at is None else finite("at", at)
    if arm.shape != pull.shape:
        raise ValueError(f"at: shape {arm.shape} given, must be {pull.shape}")
    size = 1 if len(pull) == 2 else 3
    turns = np.zeros(size) if moment is None else finite("moment", moment).reshape(-1)
    if turns.shape != (size,):
        hint = " (the point of the force is at=)" if turns.shape == (2,) else ""
        raise ValueError(f"moment: shape {turns.shape} given, must be ({size},){hint}")
    of_force = [arm[0] * pull[1] - arm[1] * pull[0]] if size == 1 else np.cross(arm, pull)
    return np.concatenate([pull, turns + of_force])
