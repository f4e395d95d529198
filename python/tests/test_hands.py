"""Hands with joints, and pictures."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from grasps import jar, pinch

from grasp_lcp import Grasp

HAND = Path(__file__).parents[2] / "examples" / "scenes" / "three_joint_pinch.json"


def hand() -> Grasp:
    return Grasp.from_json(HAND.read_text())


def test_a_hand_balances_joint_by_joint() -> None:
    grasp = hand()
    state = grasp.solve([0, -1]).equilibrium
    assert state is not None and state.joints
    # The object: forces and the load sum up to zero.
    assert state.forces_world.sum(axis=0) == pytest.approx([0, 1], abs=1e-12)
    for drive in state.joints:
        assert np.isfinite(drive.torque) and drive.state
    assert "by a hand" in repr(grasp) and "joint" in repr(state)


def test_fingers_that_draw_back_let_go() -> None:
    # Both fingers turn outwards by as much at every joint; weight 1 N, μ = 0.4, so that a pad slides below 0.5 / 0.4 N.
    outwards = np.array([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]) * 1e-3
    onset = hand().onset([0, 0], [0, -1], joint_change=outwards)
    assert onset.outcome == "at" and onset.state is not None and onset.factor is not None
    forces = onset.state.forces
    assert np.abs(forces[:, 1]) == pytest.approx(0.4 * forces[:, 0], rel=1e-12)
    # The way to the onset is a leg as well.
    path = hand().follow([[0, -1], {"joints_by": outwards * onset.factor * 2}])
    assert path.outcome == "lost" and path.leg == 1 and path.fraction == pytest.approx(0.5, rel=1e-9)


def test_what_is_no_question_for_hands_is_said() -> None:
    with pytest.raises(ValueError, match="quality"):
        hand().quality()


def svg_of(text: str | None) -> ElementTree.Element:
    assert text is not None
    return ElementTree.fromstring(text)


def test_pictures_in_the_plane() -> None:
    grasp = pinch(names=["left", "right"], outline=[[-0.04, -0.03], [0.04, -0.03], [0.04, 0.03], [-0.04, 0.03]])
    for shown in (grasp, grasp.solve([0, -3]), grasp.onset([0, -1])):
        root = svg_of(shown._repr_svg_())
        assert root.tag.endswith("svg") and shown._repr_html_() is None
        words = " ".join("".join(text.itertext()) for text in root.iter() if text.tag.endswith("text"))
        assert "left" in words and "right" in words
    assert grasp.solve([0, -30])._repr_svg_() is None


def test_pictures_in_space() -> None:
    points, normals = jar(np.random.default_rng(5))
    grasp = Grasp.spatial(points, normals, series_stiffness=[900, 600], friction=0.6, command=[0.006, 0, 0])
    answer = grasp.solve([0, 0, -3])
    assert svg_of(answer._repr_svg_()).tag.endswith("svg")
    page = answer._repr_html_()
    assert page is not None and page.startswith("<iframe srcdoc=") and "&lt;canvas" in page
