"""Ten thousand random grasps climb to better ones: plain gradient ascent on the load at which the first finger slides.

python improve_grasps.py

Three fingers hold an ellipsoid of 300 g. Each grasp goes along the derivative of its factor by where the fingers are and how the surface
tilts there, in steps that become shorter, and remembers the best it has seen. At a kink, where two fingers slide together, the derivative is
that of one of them: the path goes to and fro along it.
"""

from __future__ import annotations

import time

import numpy as np

from grasp_lcp import onset_gradients, onsets

GRASPS = 10_000
STEPS = 80
AXES = np.array([0.05, 0.035, 0.07])  # half axes, m
WEIGHT = np.array([0.0, 0.0, -0.3 * 9.81])
FINGERS = {"friction": 0.6, "series_stiffness": [2e3, 1.5e3], "pressed_with": 6.0}
FIRST, LAST = 4e-3, 4e-5  # steps, m


def on_the_surface(points: np.ndarray) -> np.ndarray:
    """Moves points towards the centre, or away from it, to the surface."""
    return points / np.linalg.norm(points / AXES, axis=-1, keepdims=True)


def inward(points: np.ndarray) -> np.ndarray:
    """Unit normals into the ellipsoid."""
    steep = points / AXES**2
    return -steep / np.linalg.norm(steep, axis=-1, keepdims=True)


def uphill(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Factors, and their derivatives along the surface: normals turn with the points."""
    normals = inward(points)
    found = onset_gradients(points, normals, WEIGHT, **FINGERS)
    steep = np.linalg.norm(points / AXES**2, axis=-1, keepdims=True)
    # A normal changes by the part across it of -dp / AXES² / |p / AXES²|; `found.normals` lies across already.
    along = found.points - found.normals / AXES**2 / steep
    along -= (along * normals).sum(axis=-1, keepdims=True) * normals
    return np.nan_to_num(found.factor, nan=0.0, posinf=0.0), np.nan_to_num(along)


def random_grasps(rng: np.random.Generator) -> np.ndarray:
    """Fingers anywhere on the surface, of grasps that stick when they close."""
    kept: list[np.ndarray] = []
    while sum(map(len, kept)) < GRASPS:
        points = on_the_surface(rng.normal(size=(4 * GRASPS, 3, 3)))
        factor = onsets(points, inward(points), WEIGHT, **FINGERS).factor
        kept.append(points[np.isfinite(factor)])
    return np.concatenate(kept)[:GRASPS]


def improve(points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The best points that each grasp has seen, their factors, and those at the start."""
    first = None
    best, highest = points.copy(), np.zeros(len(points))
    for step in np.geomspace(FIRST, LAST, STEPS):
        factor, along = uphill(points)
        first = factor if first is None else first
        better = factor > highest
        best[better], highest[better] = points[better], factor[better]
        # One that has lost its hold begins again from its best.
        lost = factor <= 0.0
        points[lost] = best[lost]
        length = np.linalg.norm(along, axis=(1, 2), keepdims=True)
        points = on_the_surface(points + step * along / np.maximum(length, 1e-30))
    assert first is not None
    return best, highest, first


def main() -> None:
    """Prints what the climb brought, and how long it took."""
    points = random_grasps(np.random.default_rng(1))
    start = time.perf_counter()
    best, highest, first = improve(points)
    seconds = time.perf_counter() - start
    print(f"{GRASPS} grasps, {STEPS} steps each: {seconds:.2f} s, {1e6 * seconds / GRASPS / STEPS:.2f} µs a step")
    for name, factors in (("before", first), ("after", highest)):
        low, middle, high = np.percentile(factors, [10, 50, 90])
        print(f"  {name:6} they hold {low:.3f}, {middle:.3f}, {high:.3f} times the weight (a tenth, half, nine tenths of them)")
    print(f"  best   {highest.max():.4f} times the weight, fingers at {np.round(1e3 * best[highest.argmax()], 1).tolist()} mm")


if __name__ == "__main__":
    main()
