"""Converts the contacts on a body in a simulation to a grasp by a hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ._views import Array

# Tangential stiffness over normal stiffness. Simulators model friction by dampers; here each is replaced by a stiff spring.
TANGENTIAL = 1e6
# Contacts whose force, relative to the largest one, is below this are left out.
TOUCHES = 1e-9


@dataclass(frozen=True)
class Touching:
    """A contact on a body, in world axes: its point from the centre of mass (m), normal and force (N) into the body, and depth (m)."""

    other: int
    """The number of the other body."""
    name: str
    """The name of the other body or of its shape."""
    point: Array
    normal: Array
    friction: float
    force: Array
    depth: float

    @property
    def press(self) -> float:
        """The normal force, N."""
        return float(self.normal @ self.force)


def pressing(found: Sequence[Touching]) -> list[Touching]:
    """Those contacts that carry a force."""
    most = max((touch.press for touch in found), default=0.0)
    return [touch for touch in found if touch.press > TOUCHES * most and touch.depth > 0]


def drive(name: str, arms: Array, stiffness: float, acts: float, limit: float | None) -> dict[str, Any]:
    """A motor as a tendon with these lever arms at the joints; ``acts`` is its force at rest, in the unit of the drive."""
    tendon: dict[str, Any] = {"name": name, "arms": arms.tolist(), "stiffness": stiffness, "pull": acts / stiffness, "pushes": True}
    return tendon if limit is None else tendon | {"limit": {"saturates": limit}}


def hand_of(
    body: int | str,
    held: Sequence[Touching],
    jacobians: Array,
    joints: Sequence[str],
    springs: Array,
    drives: Sequence[Mapping[str, Any]],
) -> dict[str, Any]:
    """Arguments of :meth:`grasp_lcp.Grasp.hand` for contacts and joints that have their forces of the simulation at rest."""
    if not held:
        raise ValueError(f"body {body!r}: nothing presses on it")
    forces, normals = np.array([touch.force for touch in held]), np.array([touch.normal for touch in held])
    # Torques on the joints that do not come from motors: of weights, springs and constraints.
    torque = np.einsum("nij,ni->j", jacobians, forces)
    for each in drives:
        torque -= np.array(each["arms"]) * each["stiffness"] * each.get("pull", 0.0)
    press = np.array([touch.press for touch in held])
    normal = press / [touch.depth for touch in held]
    first = np.array([_across(each) for each in normals])
    along = np.stack([np.sum(first * forces, axis=1), np.sum(np.cross(normals, first) * forces, axis=1)], axis=1)
    return {
        "points": [touch.point for touch in held],
        "normals": normals,
        "tangents": first,
        "jacobians": jacobians,
        "stiffness": springs,
        "joints": joints,
        "torque": torque,
        "tendons": drives,
        "friction": [touch.friction for touch in held],
        "series_stiffness": np.column_stack([normal, TANGENTIAL * normal]),
        # Each command stretches its spring by the force of the simulation.
        "command": np.column_stack([press / normal, along / (TANGENTIAL * normal)[:, None]]),
        "names": _apart([touch.name for touch in held]),
    }


def _across(normal: Array) -> Array:
    """A unit vector perpendicular to ``normal``."""
    across = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    return np.array(across / np.linalg.norm(across), dtype=float)


def _apart(names: list[str]) -> list[str]:
    """The names, with a number appended where several contacts have the same name."""
    return [name if names.count(name) == 1 else f"{name} {names[:place].count(name)}" for place, name in enumerate(names)]
