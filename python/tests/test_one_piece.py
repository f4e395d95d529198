"""One way to say a load, whatever is asked; answers that are cheap to read, and draw themselves after they were kept."""

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from grasps import pinch

import grasp_lcp
from grasp_lcp import Grasp, wrench

AT = {"force": np.array([0, -4.9]), "at": [0.0, 0.01]}
GRASP = pinch()
QUESTIONS: list[Callable[[Any], Any]] = [
    GRASP.solve,
    GRASP.onset,
    lambda load: GRASP.onset([1, 0], load),
    GRASP.hold,
    # An array does not know where its load acts, so that a squeeze under which the grasp buckles is found for the mapping alone.
    lambda load: GRASP.need("friction", load),
    lambda load: GRASP.follow([load]),
    GRASP.compare,
    lambda load: GRASP.shake([load]),
    GRASP.load_limit,
    GRASP.least_squeeze,
    GRASP.weakest_direction,
    lambda load: GRASP.identify(["friction"], [load]),
]


@pytest.mark.parametrize("ask", QUESTIONS)
def test_a_load_is_said_the_same_way_in_every_call(ask: Callable[[Any], Any]) -> None:
    assert ask(AT).to_json() == ask(wrench([0, -4.9], at=[0, 0.01])).to_json()


def test_numbers_that_are_read_without_json_are_those_in_it() -> None:
    state = pinch().solve([0.5, -3, 0.01]).equilibrium
    assert state is not None
    again = type(state).from_json(state.to_json())
    for name in ("forces", "forces_world", "slips", "gaps", "margins", "twist"):
        assert (getattr(state, name) == getattr(again, name)).all() and getattr(state, name).shape == getattr(again, name).shape


def test_answers_draw_themselves_after_they_were_kept() -> None:
    for answer in (GRASP.solve([0, -3]), GRASP.hold([0, -3]), GRASP.need("squeeze", [0, -3]), GRASP.follow([[0, -3]]), GRASP.quality()):
        drawn, kept = answer._repr_svg_(), pickle.loads(pickle.dumps(answer))._repr_svg_()
        assert drawn is not None and drawn.startswith("<svg") and drawn == kept


def test_scenes_may_have_arrays_and_no_stiffness() -> None:
    points, normals = np.array([[-0.04, 0], [0.04, 0]]), np.array([[1.0, 0], [-1, 0]])
    contacts = [
        {"point": p, "normal": n, "friction": np.float64(0.5), "pressed_with": np.int64(8)} for p, n in zip(points, normals, strict=True)
    ]
    scene = Grasp.from_dict({"format": "grasp-lcp/1", "planar": {"contacts": contacts}})
    assert scene == Grasp.planar(points, normals, friction=0.5, pressed_with=8)
    # Two contacts of friction 0.5 that press with 8 N carry 8 N.
    assert scene.onset([0, -1]).factor == pytest.approx(8, rel=1e-12)


def test_words_of_a_verdict() -> None:
    assert GRASP.hold([0, -1]).small_motions and grasp_lcp.__version__.count(".") == 2
    tilted = GRASP.turn(weight=[0, -30], degrees=30), GRASP.turn(weight=[0, -30], angle=np.pi / 6)
    assert tilted[0].to_json() == tilted[1].to_json()


def test_a_load_keeps_its_point_of_action() -> None:
    # Fingers at ±a that press with N take 2 N a of the 2 k a² that resist turning: a bar buckles under its weight from N = k a = 100 N on.
    for press in (99.0, 101.0):
        bar = Grasp.planar([[-0.05, 0], [0.05, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e5, 2e3], friction=0.5, pressed_with=press)
        for load in ({"force": [0, -1], "at": [0, 0]}, {"force": np.array([0, -1.0]), "at": [0.0, 0.0]}, {"mass": 0.1}):
            state = bar.solve(load).equilibrium
            assert state is not None
            assert state.is_beyond_small_motions == (press > 100)
