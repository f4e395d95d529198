"""Complementarity and frictional contact problems, checked by their own conditions."""

import numpy as np
import pytest

from grasp_lcp import friction, lcp


def test_solutions_satisfy_the_conditions() -> None:
    rng = np.random.default_rng(5)
    for n in (1, 2, 5, 20):
        for _ in range(10):
            a = rng.normal(size=(n, n))
            m, q = a @ a.T + 0.1 * np.eye(n), rng.normal(size=n)
            found = lcp.solve(m, q)
            assert found.solved and found.z is not None and found.w is not None
            w = m @ found.z + q
            assert (found.z >= 0).all() and (w >= -1e-9).all() and abs(found.z @ w) < 1e-8
            assert found.w == pytest.approx(w, abs=1e-9)
            assert found.basis == tuple(np.flatnonzero(found.z > 0))


def test_an_infeasible_problem_has_a_vector_of_farkas() -> None:
    m, q = np.array([[-1.0, -2.0], [-1.0, -1.0]]), np.array([-1.0, 2.0])
    found = lcp.solve(m, q)
    assert found.outcome == "infeasible" and found.z is None and found.certificate is not None
    y = found.certificate
    assert (y >= 0).all() and (m.T @ y <= 0).all() and q @ y < 0


def test_sliding_blocks() -> None:
    rng, seen = np.random.default_rng(6), set()
    for _ in range(50):
        mass, mu, push = rng.uniform(1, 3), rng.uniform(0.1, 0.8), rng.normal(0, 4, 2)
        found = friction.solve(np.eye(3) / mass, [-9.81, *push], [mu])
        assert found.r is not None and found.u is not None and found.states is not None
        normal, size = 9.81 * mass, float(np.linalg.norm(push))
        slides = size > mu * 9.81
        seen.add(slides)
        assert found.states == (("sliding" if slides else "sticking"),)
        drag = -push / size * min(mu * normal, mass * size)
        assert found.r == pytest.approx([normal, *drag], rel=1e-9, abs=1e-9)
        assert found.u == pytest.approx(found.r / mass + [-9.81, *push], abs=1e-9)
    assert seen == {True, False}


def test_a_planar_problem_obeys_coulomb() -> None:
    rng = np.random.default_rng(8)
    a = rng.normal(size=(6, 6))
    w, q, mu = a @ a.T + np.eye(6), rng.normal(size=6) - [1, 0, 1, 0, 1, 0], np.full(3, 0.4)
    found = friction.solve(w, q, mu)
    assert found.solved and found.r is not None
    u = w @ found.r + q
    for i in range(3):
        (rn, rt), (un, ut) = found.r[2 * i : 2 * i + 2], u[2 * i : 2 * i + 2]
        assert rn >= 0 and un >= -1e-9 and abs(rt) <= 0.4 * rn + 1e-9 and abs(rn * un) < 1e-9
        assert abs(ut) < 1e-9 or rt == pytest.approx(-0.4 * rn * np.sign(ut), abs=1e-9)
