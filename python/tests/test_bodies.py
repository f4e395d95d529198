"""Several bodies from arrays: the numbers that are known by hand, and the same as from a scene."""

from pathlib import Path

import numpy as np
import pytest

from grasp_lcp import Grasp, answers, wrench

SCENES = Path(__file__).parents[2] / "examples" / "scenes" / "bodies"


def boxes(**other: object) -> Grasp:
    """A box of 10 N on a box of 20 N on a table, μ = 0.3 between them and 0.5 below."""
    points = [[-0.2, 0], [0.2, 0], [-0.2, 0.2], [0.2, 0.2]]
    contacts = Grasp.planar(points, [[0, 1]] * 4, series_stiffness=1e5, friction=[0.5, 0.5, 0.3, 0.3])
    weights = [wrench([0, -20], at=[0, 0.1]), wrench([0, -10], at=[0, 0.3])]
    return contacts.of_bodies(["lower", "upper"], [0, 0, 1, 1], np.array([-1, -1, 0, 0]), **{"load": weights, **other})


def pull(newtons: float, height: float) -> np.ndarray:
    return wrench([newtons, 0], at=[0, height])


def test_two_boxes_are_pulled() -> None:
    verdict = boxes().hold(pull(20, 0.01))
    assert verdict.lost == pytest.approx(15 / 20, abs=1e-12)
    assert verdict.says.startswith("SLIPS OUT at 15 N of 20 N: lower and upper move along +x")
    together = boxes().hold(pull(10, 0.01), together_with={"upper": pull(-5, 0.21)})
    assert together.lost == pytest.approx(0.6, abs=1e-12)
    needed = boxes().need("load", pull(10, 0.01), together_with={"upper": pull(-5, 0.21)}, may_slide=True, friction_less=0, squeeze_less=0)
    assert "0.6 times" in str(needed)


def test_weights_from_masses_are_the_same() -> None:
    by_mass = boxes(load=None, mass=[2, 1], centre_of_mass=[[0, 0.1], [0, 0.3]], gravity=[0, -10])
    assert by_mass.hold(pull(20, 0.01)).lost == pytest.approx(15 / 20, abs=1e-12)
    # All weights turn together: the upper box slides at tan θ = 0.3.
    tray = boxes(load=None, mass=[2, 1], centre_of_mass=[[0, 0.1], [0, 0.3]], shared_by_mass=True)
    needed = tray.need("angle", turn={"weight": [0, -30], "at": [0, 0.5 / 3]}, may_slide=True)
    assert str(needed).startswith("TAKES 16.6992°")


def test_mappings_of_loads_are_completed_as_in_scenes() -> None:
    heavy = boxes(load=None, mass=[2, 1], centre_of_mass=[[0, 0.1], [0, 0.3]], gravity=[0, -10], shared_by_mass=True)
    for load in ({"accelerated": [-1, 0]}, {"force": [3, 0]}):
        scene = heavy.to_dict()
        scene["planar"]["questions"] = [{"hold": {"load": load}}, {"onset": {"direction": load}}]
        held, slipped = answers(scene)
        for same in (heavy, Grasp.from_dict(heavy.to_dict())):
            assert same.hold(load).says == held.says
            assert same.onset(load).says == slipped.says
    # 3 m/s² overcome the friction between the boxes, 0.3 · 10 m/s².
    assert heavy.hold({"accelerated": [-6, 0]}).lost == pytest.approx(0.5, abs=1e-12)
    # A force as an array acts through the origin.
    assert heavy.hold([3, 0]).says == heavy.hold([3, 0, 0]).says
    for ask in (heavy.hold, heavy.solve, heavy.onset):
        with pytest.raises(ValueError, match="gravity already pulls at lower"):
            ask({"mass": 3})


def test_bodies_move_by_name() -> None:
    state = boxes().solve(pull(4, 0.01), together_with={"upper": pull(1, 0.21)}).equilibrium
    assert state is not None and list(state.bodies) == ["lower", "upper"]
    assert state.bodies["upper"][0] > state.bodies["lower"][0] > 0
    assert state.forces_world[:2, 0].sum() == pytest.approx(-5, abs=1e-12)


def test_programs_load_each_body() -> None:
    path = boxes().follow([{"body_loads_to": {"upper": pull(-2.9, 0.21)}}, pull(20, 0.01)])
    assert path.outcome == "lost" and path.leg == 1
    assert path.fraction == pytest.approx(17.9 / 20, abs=1e-12)
    assert path.state is not None and path.state.body_loads["upper"][0] == pytest.approx(-2.9)


def test_shaken_to_and_fro() -> None:
    assert boxes().shake([pull(2, 0.21), pull(-2, 0.21)]).rests
    assert boxes(loaded="upper").shake([pull(4, 0.21)]).stays is False


def test_closure_names_what_may_move() -> None:
    on_a_table = boxes().force_closure()
    assert not on_a_table.closed and on_a_table.bodies["upper"][1] > 0
    points = [[-1, 0], [-1, 0.5], [0, 0], [0, 0.5], [1, 0], [1, 0.5]]
    normals = [[1, 0]] * 4 + [[-1, 0]] * 2
    row = Grasp.planar(points, normals, series_stiffness=1e4, friction=0.5)
    held = row.of_bodies(["left", "right"], ["left"] * 2 + ["right"] * 4, [None] * 2 + ["left"] * 2 + [None] * 2)
    closure = held.force_closure()
    assert closure.closed and closure.internal is not None and closure.internal.shape == (6, 2)
    with pytest.raises(ValueError, match="neither joints nor several bodies"):
        held.quality()


def test_links_and_scenes() -> None:
    tongs = Grasp.from_json((SCENES / "tongs.json").read_text())
    assert tongs.hold([0, -60]).holds is False
    again = Grasp.from_dict(tongs.to_dict())
    assert again == tongs
    contacts = Grasp.spatial([[0.1, 0, 0]], [[0, 0, 1]], series_stiffness=1e4, friction=0.5)
    lever = contacts.of_bodies(["lever"], [0], links=[{"hinge": {"point": [0, 0, 0], "axis": [0, 1, 0], "length": 0.1}, "on": "lever"}])
    verdict = lever.hold(wrench([0, 0, -10], at=[0.2, 0, 0]))
    assert verdict.holds, str(verdict)


def test_what_is_wrong_is_named() -> None:
    contacts = Grasp.planar([[0, 0], [1, 0]], [[0, 1]] * 2, series_stiffness=1.0)
    for arguments, message in [
        ((["a", "b"], [0]), "on: 1 given, must be 2, one a contact"),
        ((["a", "b"], [0, 2]), r"on\[1\] is 2, must be from 0 to 1, or -1 for the ground"),
        ((["a", "b"], ["a", "c"]), "is none of a, b"),
        ((["a", "b"], [0, 1], [1, 1]), "is on both sides of"),
    ]:
        with pytest.raises(ValueError, match=message):
            contacts.of_bodies(*arguments)
    with pytest.raises(ValueError, match=r"mass: shape \(3,\) given, must be \(2,\)"):
        contacts.of_bodies(["a", "b"], [0, 1], mass=[1, 2, 3])
    with pytest.raises(TypeError, match=r"on\[0\]: 0.5 given"):
        contacts.of_bodies(["a", "b"], [0.5, 1])
    with pytest.raises(ValueError, match="is to be loaded, and is none of the scene"):
        boxes().hold([1, 0], together_with={"lid": [1, 0]})
