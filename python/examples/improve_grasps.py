"""Ten thousand random grasps of a mesh climb to better ones: plain gradient ascent on the load at which the first finger slides, beside `improve`.

python improve_grasps.py

Three fingers hold a pear of 300 g, a mesh of 1280 triangles whose flat normals count. Each grasp goes along the derivative of its factor by
where the fingers are and how the surface tilts there, in steps that become shorter, over edges from triangle to triangle, and remembers the
best it has seen. At a kink, where two fingers slide together, the derivative is that of one of them: the path goes to and fro along it.
`Grasp.improve` takes kinks as they are, goes over edges where that gains, and may prove that nothing on its last triangles is better; it begins
at the best that the climb has found, and beside that at random grasps.
"""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from grasp_lcp import Grasp, onset_gradients, onsets

GRASPS = 10_000
STEPS = 80
WEIGHT = np.array([0.0, 0.0, -0.3 * 9.81])
FINGERS = {"friction": 0.6, "series_stiffness": [2e3, 1.5e3], "pressed_with": 6.0}
FIRST, LAST = 4e-3, 4e-5  # steps, m
FEW = 5  # of the best, and of random ones, which `improve` begins at


@dataclass(frozen=True)
class Mesh:
    """Triangles around the origin, which sees all of each: m outward triangles of corners, shape (m, 3, 3), and what is computed of them."""

    corners: np.ndarray
    normals: np.ndarray
    """Unit normals into the body, shape (m, 3)."""
    turns: np.ndarray
    """How normals turn along the surface in the mean, as those interpolated between vertices do: ``turns @ dp``, shape (m, 3, 3)."""
    weights: np.ndarray
    """``weights @ p`` are the parts of the corners in a point of the cone over the triangle: none is negative within it. Shape (m, 3, 3)."""
    beyond: np.ndarray
    """The triangle across the edge opposite each corner, shape (m, 3)."""

    @classmethod
    def of(cls, vertices: np.ndarray, faces: np.ndarray) -> Mesh:
        """The mesh of vertices and of corners in counterclockwise order."""
        corners = vertices[faces]
        area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = -area / np.linalg.norm(area, axis=1, keepdims=True)
        # At a vertex, that of all triangles around it.
        around = np.zeros_like(vertices)
        np.add.at(around, faces, -area[:, None, :])
        around /= np.linalg.norm(around, axis=1, keepdims=True)
        # Along the surface the parts of a corner change by 1 / height, away from the opposite edge.
        opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
        slopes = np.cross(opposite, normals[:, None, :]) / np.linalg.norm(area, axis=1)[:, None, None]
        turns = np.einsum("mij,mik->mjk", around[faces], slopes)
        weights = np.linalg.inv(np.swapaxes(corners, 1, 2))
        edges = {(int(a), int(b)): face for face, row in enumerate(faces) for a, b in zip(row, np.roll(row, -1), strict=True)}
        beyond = np.array([[edges[int(row[(k + 2) % 3]), int(row[(k + 1) % 3])] for k in range(3)] for row in faces])
        return cls(corners, normals, turns, weights, beyond)

    def put(self, points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Points moved towards the origin, or away from it, to the surface, and their triangles: found from those given, from edge to edge."""
        points, faces = points.copy(), faces.copy()
        flat, at = points.reshape(-1, 3), faces.reshape(-1)
        astray = np.arange(len(at))
        for _ in range(len(self.corners)):
            parts = np.einsum("mij,mj->mi", self.weights[at[astray]], flat[astray])
            out = parts.min(axis=1) < -1e-12
            flat[astray[~out]] /= parts[~out].sum(axis=1, keepdims=True)
            astray = astray[out]
            if not len(astray):
                break
            at[astray] = self.beyond[at[astray], parts[out].argmin(axis=1)]
        return points, faces

    def uphill(self, points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Factors, and their derivatives along the surface: normals turn with the points."""
        normals = self.normals[faces]
        found = onset_gradients(points, normals, WEIGHT, **FINGERS)
        along = found.points + np.einsum("...jk,...j->...k", self.turns[faces], found.normals)
        along -= (along * normals).sum(axis=-1, keepdims=True) * normals
        return np.nan_to_num(found.factor, nan=0.0, posinf=0.0), np.nan_to_num(along)


def pear() -> Mesh:
    """An icosahedron, its triangles cut in four three times and put on a pear."""
    golden = (1 + 5**0.5) / 2
    ring = [(0, a, b * golden) for a in (-1, 1) for b in (-1, 1)]
    vertices = [np.roll(point, turn) / np.hypot(1, golden) for turn in range(3) for point in ring]
    near = {(a, b) for a in range(12) for b in range(12) if a != b and np.dot(vertices[a], vertices[b]) > 0.4}
    faces = [(a, b, c) for a, b in near for c in range(12) if {(b, c), (c, a)} <= near and a < min(b, c)]
    faces = [face for face in faces if np.linalg.det([vertices[k] for k in face]) > 0]
    for _ in range(3):
        known: dict[tuple[int, int], int] = {}

        def middle(a: int, b: int, known: dict[tuple[int, int], int] = known) -> int:
            key = (min(a, b), max(a, b))
            if key not in known:
                known[key] = len(vertices)
                point = vertices[a] + vertices[b]
                vertices.append(point / np.linalg.norm(point))
            return known[key]

        cut = [((a, b, c), (middle(a, b), middle(b, c), middle(c, a))) for a, b, c in faces]
        faces = [face for (a, b, c), (ab, bc, ca) in cut for face in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    ball = np.array(vertices)
    return Mesh.of(ball * [0.045, 0.035, 0.06] * (1 - 0.3 * ball[:, 2:]) ** [1, 1, 0], np.array(faces))


def random_grasps(mesh: Mesh, rng: np.random.Generator, grasps: int = GRASPS) -> tuple[np.ndarray, np.ndarray]:
    """Fingers anywhere on the surface, of grasps that stick when they close."""
    kept: list[tuple[np.ndarray, np.ndarray]] = []
    while sum(len(points) for points, _ in kept) < grasps:
        shape = (4 * grasps, 3)
        points, faces = mesh.put(rng.normal(size=(*shape, 3)), rng.integers(len(mesh.corners), size=shape))
        sticks = np.isfinite(onsets(points, mesh.normals[faces], WEIGHT, **FINGERS).factor)
        kept.append((points[sticks], faces[sticks]))
    points, faces = (np.concatenate(part)[:grasps] for part in zip(*kept, strict=True))
    return points, faces


def climb(mesh: Mesh, points: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """The best points that each grasp has seen with their triangles, their factors, and those at the start."""
    first = None
    best, at, highest = points.copy(), faces.copy(), np.zeros(len(points))
    for step in np.geomspace(FIRST, LAST, STEPS):
        factor, along = mesh.uphill(points, faces)
        first = factor if first is None else first
        better = factor > highest
        best[better], at[better], highest[better] = points[better], faces[better], factor[better]
        # One that has lost its hold begins again from its best.
        lost = factor <= 0.0
        points[lost], faces[lost] = best[lost], at[lost]
        length = np.linalg.norm(along, axis=(1, 2), keepdims=True)
        points, faces = mesh.put(points + step * along / np.maximum(length, 1e-30), faces)
    assert first is not None
    return best, at, highest, first


def improved(mesh: Mesh, points: np.ndarray, faces: np.ndarray, starts: int) -> tuple[float, bool]:
    """What `improve` makes of a grasp: its factor, and whether it is proved that nothing on its triangles is better."""
    grasp = Grasp.spatial(points, mesh.normals[faces], **FINGERS)
    answer = grasp.improve(WEIGHT, surfaces={"triangles": mesh.corners}, starts=starts)
    return answer.after or 0.0, answer.is_locally_best


def main() -> None:
    """Prints what the climb brought, what `improve` made of its best and of random grasps, and how long that took."""
    mesh = pear()
    points, faces = random_grasps(mesh, np.random.default_rng(1))
    start = time.perf_counter()
    best, at, highest, first = climb(mesh, points, faces)
    seconds = time.perf_counter() - start
    each = 1e6 * seconds / GRASPS / STEPS
    print(f"{GRASPS} grasps of {len(mesh.corners)} triangles, {STEPS} steps each: {seconds:.2f} s, {each:.2f} µs a step")
    for name, factors in (("before", first), ("after", highest)):
        low, middle, high = np.percentile(factors, [10, 50, 90])
        print(f"  {name:6} they hold {low:.3f}, {middle:.3f}, {high:.3f} times the weight (a tenth, half, nine tenths of them)")
    print(f"  best   {highest.max():.4f} times the weight, fingers at {np.round(1e3 * best[highest.argmax()], 1).tolist()} mm")
    order = np.argsort(-highest)[:FEW]
    for name, chosen, starts in (
        (f"improve, from the {FEW} best of the climb", [(best[k], at[k]) for k in order], 0),
        (f"improve, from {FEW} random grasps, 8 starts each", [(points[k], faces[k]) for k in range(FEW)], 8),
    ):
        start = time.perf_counter()
        answers = [improved(mesh, *grasp, starts) for grasp in chosen]
        seconds = time.perf_counter() - start
        proved = sum(is_best for _, is_best in answers)
        print(f"{name}: {max(answers)[0]:.4f} times the weight, {1e3 * seconds / FEW:.1f} ms each, {proved} proved on their triangles")


if __name__ == "__main__":
    main()
