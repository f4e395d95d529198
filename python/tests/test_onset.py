"""Onsets against closed forms, and against a bisection on elastic forces that numpy computes."""

import math

import numpy as np
import pytest
from grasps import Array, jar, pinch, sticking_forces

from grasp_lcp import Grasp


def test_a_pinch_holds_twice_its_friction() -> None:
    for mu, press in [(0.5, 8.0), (0.25, 3.0), (1.5, 0.1)]:
        onset = pinch(mu, press).onset([0, -1])
        assert onset.factor == pytest.approx(2 * mu * press, rel=1e-13)
        assert [leaving.contact for leaving in onset.leaving] == [0, 1]
        assert [leaving.how for leaving in onset.leaving] == ["slides", "slides"]
        # The fingers stay and the object goes down: over it they slip upwards.
        assert onset.leaving[0].direction == pytest.approx([0, 1])
        assert onset.beyond is not None and onset.beyond.what == "limit_load"


def test_a_tilted_pull_slides_the_relieved_jaw_first() -> None:
    for angle in (0.3, 0.7, -0.5):
        onset = pinch(0.5, 10.0).onset([math.sin(angle), -math.cos(angle)])
        # W cos φ / 2 = μ (10 - W |sin φ| / 2)
        assert onset.factor == pytest.approx(10 / (math.cos(angle) + 0.5 * abs(math.sin(angle))), rel=1e-13)
        assert [leaving.contact for leaving in onset.leaving] == [0 if angle > 0 else 1]


def test_the_paper_s_grasp() -> None:
    grasp = Grasp.planar(
        [[-4, 1.8], [4, 1.8]], [[8, -1], [-8, -1]], body_stiffness=10, finger_stiffness=10, friction=0.25,
        command=[[0.1, -0.0125], [0.1, 0.0125]],
    )  # fmt: skip
    assert grasp.onset([0, -1]).factor == pytest.approx(math.sqrt(65) / 66, abs=1e-15)


def test_random_jars_against_bisection() -> None:
    rng = np.random.default_rng(7)
    springs, mu = np.array([900.0, 600.0, 600.0]), 0.6
    slid = 0
    for _ in range(40):
        points, normals = jar(rng)
        commands = np.tile([0.006, 0, 0], (3, 1))
        direction = np.concatenate([rng.normal(size=3), np.zeros(3)])

        asked = points, normals, springs, commands, direction

        def margin(factor: float, asked: tuple[Array, ...] = asked) -> float:
            f = sticking_forces(*asked[:4], factor * asked[4])
            return float(np.min(mu * f[:, 0] - np.linalg.norm(f[:, 1:], axis=1)))

        onset = Grasp.spatial(points, normals, series_stiffness=[900, 600], friction=mu, command=[0.006, 0, 0]).onset(direction)
        if margin(0.0) <= 0:
            assert onset.outcome != "at" or onset.factor == 0
            continue
        low, high = 0.0, 1e3
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if margin(middle) > 0 else (low, middle)
        assert onset.factor == pytest.approx(low, rel=1e-9)
        slid += 1
    print(f"{slid} jars")
    assert slid >= 30


def test_a_base_load_is_taken_off() -> None:
    grasp = pinch(0.5, 10.0)
    assert grasp.onset([0, -1], [0, -4]).factor == pytest.approx(6, rel=1e-13)
    assert grasp.onset([0, 1], base=[0, -4, 0]).factor == pytest.approx(14, rel=1e-13)


def test_commands_that_let_go() -> None:
    # Both jaws draw back by 1 mm a unit: 8 N + 8 N / 1000 N/m ... F_n = 8 - 1 τ, F_t = 2, μ = 0.5.
    onset = pinch().onset([0, 0], [0, -4], command_change=[[-1e-3, 0], [-1e-3, 0]])
    assert onset.factor == pytest.approx(4, rel=1e-13)


def test_a_weight_that_turns() -> None:
    # w/2 cos θ across, w/2 sin θ along the line of jaws, which press with 10 N.
    w = 9.0
    onset = pinch(0.5, 10.0).turn(force=[w, 0])
    assert onset.angle is not None
    # The jaw that the force relieves has F_n = 10 - w/2 cos θ and F_t = w/2 sin θ.
    left = w / 2 * math.sin(onset.angle) - 0.5 * (10 - w / 2 * math.cos(onset.angle))
    assert abs(left) < 1e-13


def test_onset_of_nothing_and_of_too_much() -> None:
    never = pinch(float("inf")).onset([0, -1])
    assert (never.outcome, never.factor, never.state) == ("never", float("inf"), None)
    base = pinch().onset([0, -1], [0, -100])
    assert base.outcome == "no_base" and base.proof is not None
