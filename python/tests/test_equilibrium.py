"""Equilibria: the equations summed up again in numpy, the law checked contact by contact."""

import numpy as np
import pytest
from grasps import grasp_map, jar, pinch, wrench

from grasp_lcp import Grasp

SPRINGS, MU, SQUEEZE = np.array([900.0, 600.0, 600.0]), 0.6, 0.006


def jars() -> list[tuple[np.ndarray, np.ndarray, Grasp, np.ndarray]]:
    rng = np.random.default_rng(11)
    made = []
    for contacts in (3, 4, 5):
        for _ in range(8):
            points, normals = jar(rng, contacts)
            grasp = Grasp.spatial(points, normals, series_stiffness=[900, 600], friction=MU, command=[SQUEEZE, 0, 0])
            made.append((points, normals, grasp, np.concatenate([rng.normal(0, 6, 3), rng.normal(0, 0.05, 3)])))
    return made


def test_forces_balance_and_obey_the_law() -> None:
    held, states = 0, set()
    for points, normals, grasp, load in jars():
        state = grasp.solve(load).equilibrium
        if state is None:
            continue
        held += 1
        total = sum(wrench(p, f) for p, f in zip(points, state.forces_world, strict=True)) + load
        assert np.abs(total).max() < 1e-10
        for touch, point, normal in zip(state.contacts, points, normals, strict=True):
            states.add(touch.state)
            moved = grasp_map(point, normal).T @ state.twist
            sprung = SPRINGS * ([SQUEEZE, 0, 0] - moved - touch.slip + [touch.gap, 0, 0])
            tangential = float(np.linalg.norm(touch.force[1:]))
            assert touch.force[0] >= -1e-12 and tangential <= MU * touch.force[0] + 1e-9
            assert touch.gap * touch.force[0] < 1e-12
            if touch.state != "separated":
                assert sprung == pytest.approx(touch.force, abs=1e-9)
            if touch.state == "sliding":
                # Friction drags the body along with the finger: F_t and the slip point one way.
                slip = touch.slip[1:]
                assert touch.force[1:] @ slip == pytest.approx(tangential * np.linalg.norm(slip), rel=1e-6)
            assert touch.margin == pytest.approx(MU * touch.force[0] - tangential, abs=1e-9)
    print(f"{held} equilibria, states {sorted(states)}")
    assert held >= 15 and {"sticking", "sliding"} <= states


def test_beyond_the_limit_there_is_a_proof() -> None:
    answer = pinch().solve([0, -8.1])
    assert answer.outcome == "no_equilibrium" and answer.equilibrium is None
    assert answer.proof is not None and answer.proof.kind == "every_state_tried"
    weightless = Grasp.planar([[0, 0]], [[0, 1]], series_stiffness=1e3).solve([0, 1])
    assert weightless.proof is not None and weightless.proof.motion is not None
    assert weightless.proof.motion @ [0, 1, 0] > 0


def test_paths_slide_where_the_onset_says() -> None:
    lost = 0
    for points, _, grasp, load in jars():
        onset, path = grasp.onset(load), grasp.follow([20 * load])
        if onset.outcome != "at" or not path.events:
            continue
        first = path.events[0]
        assert 20 * first.fraction == pytest.approx(onset.factor, rel=1e-9)
        assert {c.contact for c in first.changes} == {leaving.contact for leaving in onset.leaving}
        for event in path.events:
            total = sum(wrench(p, f) for p, f in zip(points, event.state.forces_world, strict=True)) + event.load
            assert np.abs(total).max() < 1e-8
        assert all(energy["residual"] < 1e-6 for energy in path.energies)
        lost += path.outcome == "lost" and path.load is not None and path.kind is not None
    print(f"{lost} paths lost")
    assert lost >= 10


def test_legs_go_and_come_back() -> None:
    grasp = pinch()
    path = grasp.follow([{"load_by": [0, -3]}, {"commands_by": [[1e-3, 0]] * 2}, {"turn": {"weight": [0, -3], "angle_rad": 1.0}}])
    assert path.outcome == "completed" and path.state is not None
    assert path.state.load == pytest.approx([-3 * np.sin(1.0), -3 * np.cos(1.0), 0], abs=1e-13)
    assert path.state.forces[:, 0].mean() == pytest.approx(9, rel=1e-12)


def test_all_equilibria_balance() -> None:
    found = pinch().equilibria([0, -5])
    assert found
    for state in found:
        assert state.forces_world.sum(axis=0) == pytest.approx([0, 5], abs=1e-12)


def test_large_motions_are_told() -> None:
    # A beam in two bonded springs turns by M / (2 k a²).
    beam = Grasp.planar([[-0.05, 0], [0.05, 0]], [[0, 1]] * 2, series_stiffness=1e3, hold="bonded")
    for angle, far in [(0.09, False), (-0.11, True)]:
        state = beam.solve([0, 0, 5 * angle]).equilibrium
        assert state is not None and state.twist[2] == pytest.approx(angle, rel=1e-12)
        assert state.is_beyond_small_motions == far and ("no longer apply" in repr(state)) == far
