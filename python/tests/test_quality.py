"""Force closure, ε and limits against linear programs of scipy; squeezes against closed forms."""

import numpy as np
import pytest
from grasps import grasp_map, pinch
from scipy.optimize import linprog

from grasp_lcp import Grasp


def edges(points: np.ndarray, normals: np.ndarray, mu: float) -> np.ndarray:
    """Wrenches of the edges of planar cones with unit normal forces, shape (d, 2 n)."""
    cones = [grasp_map(p, n) @ [[1, 1], [mu, -mu]] for p, n in zip(points, normals, strict=True)]
    return np.concatenate(cones, axis=1)


def random_grasp(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    angles = rng.uniform(0, 2 * np.pi, 3)
    points = 0.05 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return points, -points + rng.normal(0, 0.02, points.shape)


def test_force_closure_and_limits_are_those_of_linear_programs() -> None:
    rng, counts = np.random.default_rng(3), {True: 0, False: 0}
    for _ in range(60):
        points, normals = random_grasp(rng)
        generators = edges(points, normals, 0.4)
        # The largest least share of generators that balance each other: positive where all loads can be balanced.
        ones = np.ones(generators.shape[1])
        program = linprog(
            np.r_[0 * ones, -1],
            A_ub=np.c_[-np.eye(len(ones)), ones],
            b_ub=0 * ones,
            A_eq=np.r_[np.c_[generators, np.zeros(3)], [np.r_[ones, 0]]],
            b_eq=[0, 0, 0, 1],
            bounds=[(0, None)] * len(ones) + [(None, None)],
        )
        closed = program.status == 0 and -program.fun > 1e-9 and np.linalg.matrix_rank(generators) == 3
        grasp = Grasp.planar(points, normals, friction=0.4, series_stiffness=1e3)
        found = grasp.force_closure()
        assert found.closed == closed
        counts[closed] += 1
        if closed:
            assert found.internal is not None
            total = sum(grasp_map(p, n) @ f for p, n, f in zip(points, normals, found.internal, strict=True))
            assert np.abs(total).max() < 1e-12
        else:
            assert found.motion is not None and (generators.T @ found.motion >= -1e-9).all()
        load = np.r_[rng.normal(size=2), 0.02 * rng.normal()]
        limit = linprog(np.r_[0 * ones, -1], A_ub=[np.r_[ones, 0]], b_ub=[10], A_eq=np.c_[generators, load], b_eq=np.zeros(3))
        answer = grasp.load_limit(load, budget=10, each=False)
        assert answer.at_least == pytest.approx(-limit.fun, rel=1e-6, abs=1e-9)
    print(counts)
    assert min(counts.values()) >= 10


def test_the_ball_of_a_pinch() -> None:
    grasp = Grasp.planar([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], friction=0.5, series_stiffness=1e3)
    quality = grasp.quality()
    # A tetrahedron whose faces are 1/3 away.
    assert quality.epsilon == pytest.approx(1 / 3, abs=1e-9) and quality.ball.at_most == pytest.approx(1 / 3, abs=1e-9)
    assert quality.force_closure.closed and not quality.form_closure.closed


def test_how_much_squeeze() -> None:
    palms = pinch(0.5, 1.0)
    assert palms.least_squeeze([0, -12]).factor == pytest.approx(12, rel=1e-13)
    assert palms.least_squeeze([[0, -12], [0, 3]]).factor == pytest.approx(12, rel=1e-13)
    turned = palms.least_squeeze(turn={"weight": [0, -12]})
    assert turned.factor == pytest.approx(np.sqrt(180), rel=1e-12)
    assert palms.least_squeeze(any_force=12.0).factor == pytest.approx(np.sqrt(180), rel=1e-12)


def test_the_weakest_direction_of_a_pinch() -> None:
    found = pinch(0.5, 10.0, series_stiffness=1e3).weakest_direction()
    assert found.size == pytest.approx(np.sqrt(80), rel=1e-13)
    assert found.direction is not None and np.abs(found.direction) == pytest.approx(np.sqrt([0.2, 0.8]))
