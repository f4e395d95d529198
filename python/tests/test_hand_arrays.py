"""Hands from arrays, against closed forms and against scenes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from grasp_lcp import Grasp

POINTS, NORMALS = [[-0.04, 0], [0.04, 0]], [[1, 0], [-1, 0]]
# Two jaws, each with a slide towards the object.
SLIDES = np.array([[[1, 0], [0, 0]], [[0, -1], [0, 0]]])


def jaws(**more: Any) -> Grasp:
    return Grasp.hand(
        POINTS, NORMALS, SLIDES, **{"stiffness": 2e3, "series_stiffness": [1e4, 8e3], "friction": 0.5, "pressed_with": 8.0, **more}
    )


def test_joints_and_pads_yield_in_series() -> None:
    state = jaws().solve([3, 0]).equilibrium
    assert state is not None
    assert state.twist[0] == pytest.approx(3 / (2 / (1 / 2e3 + 1 / 1e4)), rel=1e-12)
    assert jaws().onset([0, -1]).factor == pytest.approx(8.0, rel=1e-12)


def test_a_motor_stalls_at_its_limit() -> None:
    onset = jaws(limit=[None, 9.0], joints=["left", "right"]).onset([1, 0])
    assert onset.factor == pytest.approx(2 * (9 - 8), rel=1e-12) and "right" in str(onset)
    assert jaws(limit=9.0).onset([-1, 0]).factor == pytest.approx(2.0, rel=1e-12)


def test_a_matrix_couples_joints() -> None:
    rod = 1e9 * np.array([[1.0, -1.0], [-1.0, 1.0]])
    state = jaws(stiffness=np.diag([2e3, 2e3]) + rod).solve([3, 0]).equilibrium
    assert state is not None
    assert state.twist[0] == pytest.approx(3 / 2e4, rel=1e-5)


def test_joint_commands_and_torques_press() -> None:
    for given in ({"joint_command": 0.004}, {"torque": [8.0, 8.0]}):
        state = jaws(pressed_with=None, **given).solve([0, 0]).equilibrium
        assert state is not None
        # The pads yield, too: a command presses by the series, a torque as it is.
        expected = 8.0 / (1 + 2e3 / 1e4)
        assert state.contacts[0].force[0] == pytest.approx(expected, rel=1e-12)


def test_contacts_without_joints_stand_still() -> None:
    grasp = Grasp.hand(POINTS, NORMALS, SLIDES[:, :, :1], 2e3, series_stiffness=1e4, friction=0.5, pressed_with=8.0)
    state = grasp.solve([3, 0]).equilibrium
    assert state is not None
    assert state.twist[0] == pytest.approx(3 / (1 / (1 / 2e3 + 1 / 1e4) + 1e4), rel=1e-12)


def test_it_is_the_hand_of_a_scene() -> None:
    scene = jaws(limit=9.0, joints=["a", "b"]).to_dict()
    assert Grasp.from_dict(scene) == jaws(limit=9.0, joints=["a", "b"])
    joints = scene["planar"]["fingers"][0]["joints"]
    assert joints[1] == {"name": "b", "stiffness": 2e3, "limit": {"saturates": 9.0}}


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"jacobians": np.zeros((2, 3, 2))}, r"jacobians: shape \(2, 3, 2\) given, must be \(2, 2, joints\)"),
        ({"stiffness": [1.0, 2.0, 3.0]}, r"stiffness: shape \(3,\) given"),
        ({"joints": ["one"]}, "joints: 1 given, must be 2"),
        ({"torque": [1.0, 2.0, 3.0]}, "torque: 3 given"),
        ({"joint_command": np.nan}, "command is nan"),
    ],
)
def test_mistakes_are_named(more: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        Grasp.hand(**{"points": POINTS, "normals": NORMALS, "jacobians": SLIDES, "stiffness": 1.0, "friction": 0.5, **more})
