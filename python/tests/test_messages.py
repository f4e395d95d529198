"""Wrong input: what is refused, by which exception, in which words."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from grasps import pinch

import grasp_lcp
from grasp_lcp import Grasp, answers, friction, lcp, onsets, solve_batch, wrench

POINTS, NORMALS = [[-1, 0], [1, 0]], [[1, 0], [-1, 0]]
IN_SPACE = ([[-1, 0, 0], [1, 0, 0]], [[1, 0, 0], [-1, 0, 0]])


def scene(**given: Any) -> Grasp:
    """The grasp of a scene with one contact."""
    return Grasp.from_dict({"format": "grasp-lcp/1", "planar": {"contacts": [{"point": [0, 0], "normal": [1, 0], **given}]}})


def planar(points: Any = POINTS, normals: Any = NORMALS, **others: Any) -> Grasp:
    return Grasp.planar(points, normals, **({"series_stiffness": 1e3} | others))


def spatial(**others: Any) -> Grasp:
    return Grasp.spatial(*IN_SPACE, **({"series_stiffness": 1e3, "friction": 0.5, "pressed_with": 8.0} | others))


CASES: list[tuple[Callable[[], object], type[Exception], str]] = [
    # The grasp.
    (lambda: Grasp(), TypeError, "Grasp: make one with Grasp.planar, Grasp.spatial, Grasp.from_dict or Grasp.from_json"),
    (lambda: planar("points"), TypeError, "points: text given, must be numbers"),
    (lambda: planar([[-1, 0], [1, 1j]]), TypeError, "points: complex numbers given, must be numbers"),
    (lambda: planar([[-1, 0], [1, None]]), TypeError, "points: None given, must be numbers"),
    (lambda: planar([[-1, 0], [1]]), ValueError, "points: rows of different lengths given, must be an array"),
    (lambda: planar([-1, 0]), ValueError, "points: shape (2,) given, must be (..., n, 2)"),
    (lambda: planar(IN_SPACE[0]), ValueError, "points: shape (2, 3) given, must end in 2"),
    (lambda: planar([POINTS]), ValueError, "points: (1,) grasps given, must be one, shape (n, 2); for many there is grasp_lcp.onsets"),
    (lambda: planar([[-1, 0], [np.nan, 0]]), ValueError, "points[1] is NaN, must be finite and at most 1e50 in size"),
    (lambda: planar(normals=[[1, 0], [0, 0]]), ValueError, "normals[1] is 0, must be of positive, finite length"),
    (lambda: planar(normals=np.eye(3)[:, :2]), ValueError, "normals: shape (3,) given for contacts of shape (2,), must broadcast to it"),
    (lambda: planar(tangents=NORMALS), ValueError, "tangents[0] is 1, must be finite and not along the normal"),
    (lambda: planar(friction=-0.5), ValueError, "friction[0] is -0.5, must be from 0 to 1e50, or infinite"),
    (lambda: planar(friction=[0.5, np.nan]), ValueError, "friction[1] is NaN, must be from 0 to 1e50, or infinite"),
    (
        lambda: planar(command=[0.01, 0], pressed_with=8),
        ValueError,
        "pressed_with: given beside a command with a normal part, must be alone",
    ),
    (
        lambda: planar(points=np.array(POINTS, dtype=object)),
        TypeError,
        "points: an array of objects given, must be numbers: points.astype(float) makes them",
    ),
    (
        lambda: pinch().solve({"forc": [0, -1]}),
        ValueError,
        "load: unknown field `forc`, expected one of `force`, `moment`, `at`, `mass`, `inertia`, `gravity`, `accelerated`, `turning`",
    ),
    (lambda: pinch().turn(weight=[0, -1], angle=1.0, degrees=30), ValueError, "degrees: given beside angle, must be alone"),
    (lambda: planar(series_stiffness=-1), ValueError, "series_stiffness[0] is -1, must be positive and finite"),
    (
        lambda: planar(series_stiffness=[1, 2, 3]),
        ValueError,
        "series_stiffness: shape (3,) given, must be one number or end in 2, normal first",
    ),
    (
        lambda: planar(body_stiffness=1e3),
        ValueError,
        "series_stiffness: given beside body_stiffness or finger_stiffness, must be alone",
    ),
    (
        lambda: Grasp.planar(POINTS, NORMALS, body_stiffness=np.inf),
        ValueError,
        "series_stiffness[0] is inf, must be from 1e-50 to 1e50 (give a stiffness, and leave at most one side rigid)",
    ),
    (lambda: planar(command=0.1), ValueError, "command: shape () given, must end in 2"),
    (lambda: planar(command=[1, 0], command_world=[1, 0]), ValueError, "command_world: given beside command, must be alone"),
    (lambda: planar(pressed_with=-3), ValueError, "pressed_with[0] is -3, must be from 0 to 1e50"),
    (lambda: planar(clearance=1e60), ValueError, "clearance[0] is 1e60, must be finite and at most 1e50 in size"),
    (lambda: planar(hold="glued"), ValueError, "hold[0] is 'glued', must be one of unilateral, kept_closed, bonded"),
    (lambda: planar(hold=3), TypeError, "hold: 3 given, must be a word, or one for each contact"),
    (lambda: planar(hold=["bonded"]), ValueError, "hold: 1 given, must be one word, or 2, one a contact"),
    (lambda: planar(names=["left"]), ValueError, "names: 1 given, must be 2, one a contact"),
    (lambda: planar(names="left"), ValueError, "names: 1 given, must be 2, one a contact"),
    (lambda: planar(names=["left", 3]), TypeError, "names[1]: 3 given, must be text or None"),
    (lambda: planar(outline=[[0, np.inf]]), ValueError, "outline[0, 1] is inf, must be finite"),
    (
        lambda: planar(settings={"cones": "round"}),
        ValueError,
        "settings: unknown field `cones`, expected one of `cone`, `polygon`, `max_pivots`, `most_states`, `step_error`, `most_steps`, "
        "`most_load`, `most_cycles`, `small_motions`",
    ),
    # Loads.
    (lambda: pinch().solve(None), TypeError, "load: NoneType given, must be an array or a list of numbers"),
    (lambda: pinch().solve("down"), TypeError, "load: str given, must be an array or a list of numbers"),
    (lambda: pinch().solve([0, "down"]), TypeError, "load[1] is 'down', must be a number"),
    (lambda: pinch().solve([0]), ValueError, "load: 1 numbers given, must be 2 of a force or 3 of a force and a moment"),
    (lambda: pinch().solve(range(9)), ValueError, "load: more than 6 numbers given, must be 2 of a force or 3 of a force and a moment"),
    (lambda: pinch().solve(np.zeros((1, 2))), ValueError, "load: an array of 2 dimensions given, must have one"),
    (lambda: pinch().solve(np.zeros(2, complex)), TypeError, "load: an array of complex128 given, must be of numbers"),
    (lambda: pinch().solve([0, np.nan]), ValueError, "load[1] is NaN, must be finite and at most 1e50 in size"),
    (lambda: pinch().solve([0, 1e60]), ValueError, "load[1] is 1e60, must be finite and at most 1e50 in size"),
    # Questions.
    (
        lambda: pinch().onset([0, 0]),
        ValueError,
        "direction, command_change and joint_change are zero, one of them must change something",
    ),
    (lambda: pinch().onset([0, 1], [np.inf, 0]), ValueError, "base[0] is inf, must be finite and at most 1e50 in size"),
    (
        lambda: pinch().onset([0, 1], command_change=[[1, 2]]),
        ValueError,
        "command_change: 1 rows given, must be 2, one a contact",
    ),
    (
        lambda: pinch().onset([0, 1], joint_change=[1]),
        ValueError,
        "joint_change: 1 given, must be 0, one a joint and one a tendon",
    ),
    (lambda: pinch().identify("luck", [0, -4]), ValueError, "unknowns[0]: 'luck' given, must be friction, carried, squeeze or stiffness"),
    (lambda: pinch().identify([3], [0, -4]), TypeError, "unknowns[0]: int given, must be a text or a mapping with a quantity"),
    (lambda: pinch().identify(["friction"], [[0, -4], [0, np.nan]]), ValueError, "loads[1, 1] is nan, must be finite"),
    (
        lambda: pinch().identify(["friction"], [[0, -4]], squeeze=[1, 2]),
        ValueError,
        "squeeze: 2 given, must be one for all or 1, one a slip",
    ),
    (
        lambda: pinch().identify(["friction"], [[0, -4], [0, -5]], group=["a"]),
        ValueError,
        "group: 1 given, must be one for all or 2, one a slip",
    ),
    (
        lambda: pinch().identify(["friction"], [[0, -4], [0, -5]], group=[3, 3]),
        ValueError,
        "slips: number of groups is 1, must be at least 2: errors of groups are told by how far they are apart",
    ),
    (lambda: pinch().identify(["friction"], [0, 0]), ValueError, "slip 0: size of the load is 0, must be more than 0"),
    (
        lambda: pinch().turn(),
        ValueError,
        "turn: weight is missing: give weight, or force, or cosine and sine; without them gravity turns, "
        "where a scene's bodies have masses under `gravity`, by onset_of_turn and need",
    ),
    (lambda: pinch().turn(weight=[0, np.nan]), ValueError, "weight[1] is nan, must be finite"),
    (
        lambda: pinch().turn(weight=[0, -1], angle=-1),
        ValueError,
        "turn: angle of the turn is -1, must be more than 0 and at most 1e6 rad",
    ),
    (
        lambda: spatial().turn(weight=[0, 0, -1], axis=[0, 0, 0]),
        ValueError,
        "turn: length of the axis is 0, must be more than 0 and at most 1e50",
    ),
    (lambda: pinch().follow(3), TypeError, "legs: 3 given, must be a list of loads or legs"),  # type: ignore[arg-type]
    (
        lambda: pinch().follow([{"load": [0, -1]}]),  # type: ignore[list-item]
        ValueError,
        "legs[0]: 'load' given, must be one of load_by, load_to, commands_by, commands_to, joints_by, joints_to, torques_by, torques_to, "
        "body_loads_by, body_loads_to, turn",
    ),
    (
        lambda: pinch().follow([[0, -1], [0, -1, 0, 0]]),
        ValueError,
        "legs[1]: shape (4,) given, must be (2,) of a force or (3,) of a force and a moment",
    ),
    (
        lambda: pinch().improve([0, -1]),
        ValueError,
        "improve: surface is given of no contact and no greatest force, must be one: nothing may change",
    ),
    (lambda: pinch().improve([0, -1], at_most=1, goal="grip"), ValueError, "goal: 'grip' given, must be first_slip or reserve"),
    (lambda: pinch().improve([0, -1], at_most=1, starts=1001), ValueError, "number of starts is 1001, must be at most 1000"),
    (lambda: pinch().watch()([1, 2], [0, -1]), ValueError, "forces: shape (2,) given, must be (n, c), one row a contact"),
    (lambda: pinch().watch()([[1, 2, 3]], [0, -1]), ValueError, "forces: shape (1, 3) given, must be (2, 2)"),
    (lambda: pinch().watch()([[1, 2], [np.nan, 0]], [0, -1]), ValueError, "forces[1] is NaN, must be a number of at most 1e50 N"),
    (lambda: pinch().watch()([[1, 2], [3, 0]], [0, np.inf]), ValueError, "to_come[1] is inf, must be finite and at most 1e50 in size"),
    (lambda: pinch().improve(at_most=1), ValueError, "improve: load is missing, must be one of load, loads and any_force"),
    (lambda: pinch().quality(budget=-1), ValueError, "budget is -1, must be more than 0 and at most 1e50"),
    (lambda: pinch().load_limit([0, 0]), ValueError, "size of direction is 0, must be more than 0"),
    (lambda: pinch().least_squeeze(), TypeError, "least_squeeze: give one of loads, any_force and turn"),
    (lambda: pinch().least_squeeze(any_force=-1), ValueError, "any_force is -1, must be zero, or more and at most 1e50"),
    (lambda: pinch().weakest_direction(at=[0, 0, 0]), ValueError, "at: 3 numbers given, must be 2"),
    (
        lambda: pinch().need("squeze", [0, -1]),  # type: ignore[arg-type]
        ValueError,
        "quantity: 'squeze' (squeeze?), must be one of squeeze, friction, load, arm, angle, force",
    ),
    (lambda: pinch().need(3, [0, -1]), ValueError, "quantity: 3, must be one of squeeze, friction, load, arm, angle, force"),  # type: ignore[arg-type]
    # Scenes.
    (lambda: Grasp.from_json("{"), ValueError, "line 1, column 1: the text ends within an object: something is missing, perhaps a bracket"),
    (lambda: scene(friction=np.nan), ValueError, "planar.contacts[0].friction: nan given, must be a finite number"),
    (
        lambda: scene(friction=np.inf),
        ValueError,
        'planar.contacts[0].friction: inf given, must be a finite number or a word: "infinite" friction, "rigid" stiffness',
    ),
    (lambda: scene(point=np.array([0, np.nan])), ValueError, "planar.contacts[0].point[1]: nan given, must be a finite number"),
    (lambda: answers({"format": "grasp-lcp/1"}), ValueError, "missing field `planar` or `spatial`"),
    # Batches: what is wrong with all rows at once.
    (lambda: onsets([1, 2], NORMALS, [0, 1]), ValueError, "points: shape (2,) given, must be (..., n, 2) or (..., n, 3)"),
    (
        lambda: onsets(POINTS, NORMALS, [0, 1]),
        ValueError,
        "series_stiffness: nothing given, must be given, or body_stiffness or finger_stiffness",
    ),
    (
        lambda: onsets(POINTS, NORMALS, [0, 1, 2, 3], series_stiffness=1),
        ValueError,
        "direction: shape (4,) given, must end in 2 of a force or 3 of a force and a moment",
    ),
    (
        lambda: onsets([POINTS] * 3, NORMALS, np.ones((2, 2)), series_stiffness=1),
        ValueError,
        "direction or load: shape (2,) of loads given for grasps of shape (3,), must broadcast to it",
    ),
    (
        lambda: onsets(POINTS, NORMALS, np.ones((3, 2)), np.ones((4, 2)), series_stiffness=1),
        ValueError,
        "base: shape (4, 3) given for direction of shape (3, 3), must broadcast to it",
    ),
    (lambda: solve_batch(POINTS, NORMALS, [0, 1], series_stiffness=1, friction="low"), TypeError, "friction: text given, must be numbers"),
    # Problems by themselves.
    (lambda: lcp.solve([[1, 2]], [1]), ValueError, "M: 1 x 2 given, must be square"),
    (lambda: lcp.solve([1], [1]), ValueError, "M: shape (1,) given, must have 2 dimensions"),
    (lambda: lcp.solve([[1]], [1, 2]), ValueError, "q: 2 numbers given, must be 1"),
    (lambda: lcp.solve([[np.nan]], [1]), ValueError, "M[0, 0] is NaN, must be finite"),
    (lambda: friction.solve([[1]], [1], [0.5]), ValueError, "q: 1 numbers given, must be 2 or 3 for each of the 1 in mu"),
    (
        lambda: friction.solve(np.eye(3), [1, 2, 3], [-0.5]),
        ValueError,
        "mu[0] is -0.5, must be finite and not negative",
    ),
    (lambda: wrench([0, 1], at=[0, 0, 0]), ValueError, "at: shape (3,) given, must be (2,)"),
    (lambda: wrench([0, 1], [0.01, 0]), ValueError, "moment: shape (2,) given, must be (1,) (the point of the force is at=)"),
    # Other words for an argument.
    (lambda: pinch().turn([0, -1]), TypeError, "turn: a load given without a word, must be weight= or force="),  # type: ignore[call-arg]
    (lambda: planar(stiffness=1e3), TypeError, "planar: stiffness= given, must be series_stiffness="),
    (lambda: spatial(mu=0.5), TypeError, "spatial: mu= given, must be friction="),
    (
        lambda: pinch().need("friction", [0, -1], contact="left"),
        ValueError,
        "contact: none is called 'left', must be the name of one of ['contact 0', 'contact 1'], or a number from 0",
    ),
    (
        lambda: pinch().need("friction", [0, -1], contact=5),
        ValueError,
        "contact: 5 given, must be less than 2, the number of contacts, which are counted from 0",
    ),
]


@pytest.mark.parametrize("call, kind, message", CASES, ids=[message[:40] for _, _, message in CASES])
def test_what_is_wrong_is_named(call: Callable[[], object], kind: type[Exception], message: str) -> None:
    with pytest.raises(kind) as raised:
        call()
    assert type(raised.value) is kind and str(raised.value) == message


def test_no_equilibrium_is_an_answer() -> None:
    assert pinch().solve([0, -100]).outcome == "no_equilibrium"
    assert pinch(friction=0.0).onset([0, -1]).outcome != "at"


def test_a_direction_of_zero_is_malformed_in_its_row() -> None:
    for contacts in (POINTS, POINTS * 3):
        normals = NORMALS * (len(contacts) // 2)
        given = {"series_stiffness": 1e3, "friction": 0.5, "pressed_with": 8.0}
        found = onsets([contacts] * 2, normals, [[0, -1], [0, 0]], complete=True, **given)  # type: ignore[arg-type]
        assert found.answered.tolist() == [True, False] and found.status[1] == 8


def test_numbers_of_numpy_are_numbers() -> None:
    needed = pinch().need("friction", [0, -4], contact=1, safety=2.0)
    for contact in (np.int64(1), "contact 1"):
        assert pinch().need("friction", [0, -4], contact=contact, safety=np.float32(2)).says == needed.says  # type: ignore[arg-type]
    loads = [[0, -4], [0, -4.1]]
    unknown = {"quantity": "friction", "contacts": [0, 1]}
    seen = pinch().identify(unknown, loads, known=[([0], 0.5, 0.1)], iterations=20).says
    for contacts in (np.array([0, 1]), [np.int64(0), np.int64(1)]):
        same = pinch().identify(
            unknown | {"contacts": contacts}, loads, known=[([np.int64(0)], np.float64(0.5), np.float32(0.1))], iterations=np.int64(20)
        )  # type: ignore[call-overload]
        assert same.says == seen


def test_all_names_are_listed() -> None:
    assert set(grasp_lcp.__all__) <= set(dir(grasp_lcp))
