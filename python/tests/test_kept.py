"""Grasps and answers that are kept: pickles, JSON, dictionaries, comparisons."""

import copy
import json
import pickle
from pathlib import Path

import numpy as np
import pytest
from grasps import jar, pinch

import grasp_lcp
from grasp_lcp import Grasp
from grasp_lcp.answers import Answer

SCENES = sorted((Path(__file__).parents[2] / "examples" / "scenes").glob("*.json"))


def some_answers() -> list[Answer]:
    points, normals = jar(np.random.default_rng(3))
    spatial = Grasp.spatial(points, normals, series_stiffness=[900, 600], friction=0.6, command=[0.006, 0, 0])
    grasp = pinch(names=["left", None])
    return [
        grasp.solve([0, -3]),
        grasp.solve([0, -30]),
        grasp.onset([0.1, -1]),
        grasp.onset([0, -1], [0, -30]),
        pinch(float("inf")).onset([0, -1]),
        grasp.turn(force=[12, 0]),
        grasp.follow([[0, -3], [0, 0], [0, -20]]),
        spatial.solve([0, 0, -3]),
        spatial.onset([0, 0, -1]),
        spatial.turn(weight=[0, 0, -3], axis=[1, 0, 0]),
        spatial.follow([[0, 0, -20]]),
    ]


@pytest.mark.parametrize("answer", some_answers(), ids=lambda answer: f"{type(answer).__name__} {answer.outcome}")
def test_answers_come_back_to_the_bit(answer: Answer) -> None:
    kind = type(answer)
    pickled = pickle.loads(pickle.dumps(answer))
    for other in (pickled, copy.deepcopy(answer), kind.from_json(answer.to_json()), kind.from_dict(answer.to_dict())):
        assert type(other) is kind and other == answer and hash(other) == hash(answer)
        assert other.outcome == answer.outcome and repr(other) == repr(answer)
        for name in ("factor", "angle_rad"):
            assert getattr(other, name, None) == getattr(answer, name, None)
        if answer.state is not None:
            assert other.state is not None and (other.state.forces == answer.state.forces).all()


def test_different_answers_differ() -> None:
    found = some_answers()
    assert len({answer.to_json() for answer in found}) == len(set(found)) == len(found)


def test_answers_cannot_be_changed_by_accident() -> None:
    state = pinch().solve([0, -3]).equilibrium
    assert state is not None
    with pytest.raises(ValueError, match="read-only"):
        state.forces[0, 0] = 1
    tree = state.to_dict()
    tree["twist"] = None
    assert state.to_dict()["twist"] is not None


def test_grasps_are_scenes() -> None:
    points, normals = jar(np.random.default_rng(4))
    for grasp in (
        pinch(names=["left", "right"], outline=[[0, 0], [1, 0], [0, 1]], settings={"max_pivots": 77}),
        pinch(command_world=[0.001, 0], press=1.0, clearance=[0.1, -1 / 3]),
        Grasp.spatial(points, normals, body_stiffness=[1e4, 2e4, 3e4], finger_stiffness=900, friction=[0.1, 0.7, float("inf")]),
    ):
        again = Grasp.from_json(grasp.to_json())
        for other in (again, pickle.loads(pickle.dumps(grasp)), Grasp.from_dict(grasp.to_dict())):
            assert other == grasp and hash(other) == hash(grasp) and repr(other) == repr(grasp)
            assert other.to_json() == grasp.to_json()
        down = [0] * (grasp.axes - 1) + [-1]
        assert again.onset(down) == grasp.onset(down)


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_the_scenes_of_the_repository(scene: Path) -> None:
    text = scene.read_text()
    questions = next(setup["questions"] for key, setup in json.loads(text).items() if key in ("planar", "spatial"))
    found = grasp_lcp.answers(text)
    grasp = Grasp.from_json(text)
    assert len(found) == len(questions) and found == grasp_lcp.answers(json.loads(text))
    compared = 0
    for question, answer in zip(questions, found, strict=True):
        ((kind, asked),) = question.items()
        # Of loads at a point, and words of legs, JSON knows more than arrays say.
        if kind == "solve" and set(asked["load"]) == {"force"}:
            assert grasp.solve(asked["load"]["force"]) == answer
            compared += 1
        elif kind == "onset" and set(asked) == {"direction"} and set(asked["direction"]) == {"force"}:
            assert grasp.onset(asked["direction"]["force"]) == answer
            compared += 1
        elif kind == "follow":
            assert grasp.follow(asked["legs"], asked.get("start")) == answer
            compared += 1
    print(f"{len(questions)} questions, {compared} of them asked of the grasp as well")
    assert len(SCENES) >= 10
