"""Hands with joints, and pictures."""

import doctest
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


def test_the_hand_in_the_help() -> None:
    """One tendon over both jaws: half of its 10 mm each, against 1 kN/m and two pads of 200 kN/m in series; both slide at 2 μ N."""
    attempted, failed = 0, 0
    for test in doctest.DocTestFinder().find(Grasp.from_dict, globs={"Grasp": Grasp}):
        found = doctest.DocTestRunner().run(test)
        attempted, failed = attempted + found.attempted, failed + found.failed
    assert attempted == 5 and failed == 0
    assert pytest.approx(9.9, abs=0.01) == 0.01 / (1 / 1000 + 2 / 2e5)


def test_a_finger_on_a_tendon_is_pressed_by_its_pull() -> None:
    jaw = {"joints": [{"prismatic": [1, 0]}], "contacts": [{"point": [-1, 0], "normal": [1, 0], "stiffness": 1e4, "pressed_with": 8}]}
    scene = {"format": "grasp-lcp/1", "planar": {"fingers": [jaw], "tendons": [{"arms": [1], "stiffness": 1e3}]}}
    with pytest.raises(ValueError, match="where a tendon moves the joint, its `pull` presses instead"):
        Grasp.from_dict(scene)
    scene["planar"]["tendons"][0]["pressed_with"] = 8  # type: ignore[index]
    del jaw["contacts"][0]["pressed_with"]  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match=r"tendons\[0\].pressed_with: unknown field .* `pull`"):
        Grasp.from_dict(scene)


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
