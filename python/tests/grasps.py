"""Grasps that the tests share, and the mechanics of contacts in numpy alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from grasp_lcp import Grasp

Array = NDArray[np.float64]

SCENES = "examples/scenes"


def pinch(mu: float = 0.5, press: float = 8.0, **others: object) -> Grasp:
    """Two jaws that face each other along x."""
    given: dict[str, object] = {"series_stiffness": [1e3, 8e2], "friction": mu, "pressed_with": press} | others
    return Grasp.planar([[-0.04, 0], [0.04, 0]], [[1, 0], [-1, 0]], **given)  # type: ignore[arg-type]


def jar(rng: np.random.Generator, contacts: int = 3) -> tuple[Array, Array]:
    """Points around a jar and normals into it, neither quite even."""
    angles = 2 * np.pi * np.arange(contacts) / contacts + rng.uniform(-0.2, 0.2, contacts)
    points = np.stack([0.04 * np.cos(angles), 0.04 * np.sin(angles), rng.uniform(-0.01, 0.01, contacts)], axis=1)
    normals = -points * [1, 1, 0] + rng.normal(0, 0.002, (contacts, 3))
    return points, normals


def frame(normal: Array) -> Array:
    """Columns n, t (and t2) of a contact, as the docs say."""
    n = normal / np.linalg.norm(normal)
    if len(n) == 2:
        return np.stack([n, [n[1], -n[0]]], axis=1)
    axis = np.eye(3)[np.argmin(np.abs(n))]
    first = axis - n * (n @ axis)
    first /= np.linalg.norm(first)
    return np.stack([n, first, np.cross(n, first)], axis=1)


def wrench(point: Array, force: Array) -> Array:
    """A force at a point, about the origin."""
    if len(point) == 2:
        return np.array([*force, point[0] * force[1] - point[1] * force[0]])
    return np.concatenate([force, np.cross(point, force)])


def grasp_map(point: Array, normal: Array) -> Array:
    """From a contact force in its frame to a wrench on the object, shape (d, c)."""
    return np.stack([wrench(point, column) for column in frame(normal).T], axis=1)


def sticking_forces(points: Array, normals: Array, springs: Array, commands: Array, load: Array) -> Array:
    """Forces in the contact frames if every contact sticks: the elastic solution, shape (n, c)."""
    maps = [grasp_map(point, normal) for point, normal in zip(points, normals, strict=True)]
    stiffness = np.diag(springs)
    whole = sum(g @ stiffness @ g.T for g in maps)
    pushed = sum(g @ stiffness @ u for g, u in zip(maps, commands, strict=True))
    twist = np.linalg.solve(whole, pushed + load)
    return np.array([stiffness @ (u - g.T @ twist) for g, u in zip(maps, commands, strict=True)])
