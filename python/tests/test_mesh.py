"""Pads on meshes: a bracket and a shaft against their values by hand."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from grasp_lcp import Grasp

Arrays = tuple[NDArray[np.float64], NDArray[np.int64]]

RUBBER = {"modulus": 2e6, "thickness": 0.003}
MIDDLE = [0.003, 0.025, 0.015]


def extruded(outline: list[tuple[float, float]], caps: list[list[int]], depth: float) -> Arrays:
    """A prism over an outline, counterclockwise, whose ends are these polygons of its corners."""
    n = len(outline)
    vertices = [(x, y, z) for z in (0.0, depth) for x, y in outline]
    faces = [(i, (i + 1) % n, n + (i + 1) % n) for i in range(n)] + [(i, n + (i + 1) % n, n + i) for i in range(n)]
    for cap in caps:
        for one, other in pairwise(cap[1:]):
            faces += [(cap[0], other, one), (n + cap[0], n + one, n + other)]
    return np.array(vertices), np.array(faces)


def bracket() -> Arrays:
    """An L of 60 x 40 mm, 6 thick and 30 deep, in mm."""
    return extruded([(0, 0), (60, 0), (60, 6), (6, 6), (6, 40), (0, 40)], [[0, 1, 2, 3], [0, 3, 4, 5]], 30)


def shaft(sides: int) -> Arrays:
    """A cylinder of radius 20 and length 80 mm, in m."""
    corners = [(0.02 * math.cos(a), 0.02 * math.sin(a)) for a in np.arange(sides) * 2 * math.pi / sides]
    return extruded(corners, [list(range(sides))], 0.08)


def jaw(name: str, at: list[float], closing: float, **more: Any) -> dict[str, Any]:
    return {"name": name, "friction": 0.5, "rectangle": [0.02, 0.03], "from": at, "closing": [closing, 0, 0], "layer": RUBBER, **more}


def gripped(mesh: Any = None) -> Grasp:
    """Two jaws on the upright leg of the bracket."""
    pads = [jaw("left", [-0.01, 0.025, 0.015], 1, pressed_with=40), jaw("right", [0.09, 0.025, 0.015], -1, pressed_with=40)]
    return Grasp.from_mesh(bracket() if mesh is None else mesh, pads, unit="mm", density=7850)


@pytest.mark.parametrize("pull", [[0, 1, 0], [0, 0, 1]])
def test_a_pull_across_takes_the_friction_of_both_pads(pull: list[float]) -> None:
    assert gripped().hold(np.concatenate([100 * np.array(pull), 100 * np.cross(MIDDLE, pull)])).lost == pytest.approx(0.4, rel=0.01)


def test_a_torque_takes_the_mean_distance_of_the_pads() -> None:
    lost = gripped().hold([0, 0, 0, 1, 0, 0]).lost
    assert lost == pytest.approx(0.38724, rel=0.01)


def test_its_weight_is_held() -> None:
    grasp = gripped()
    centre = grasp.centre_of_mass
    assert centre is not None and grasp.mass == pytest.approx(16920e-9 * 7850, rel=1e-12)
    np.testing.assert_allclose(centre, [0.020234, 0.010234, 0.015], atol=1e-6)
    for down in ([0, -1, 0], [0, 0, -1]):
        force = 9.81 * grasp.mass * np.array(down)
        assert grasp.hold(np.concatenate([force, np.cross(centre, force)])).holds


def test_a_pad_beyond_the_part_says_so() -> None:
    pads = [jaw("left", [-0.01, 0.04, 0.015], 1), jaw("right", [0.09, 0.025, 0.015], -1)]
    assert any("left misses the part with 50 %" in said for said in Grasp.from_mesh(bracket(), pads, unit="mm").warnings())
    with pytest.raises(ValueError, match=r"left.*misses the part"):
        Grasp.from_mesh(bracket(), [jaw("left", [-0.01, 0.06, 0.015], 1), pads[1]], unit="mm")


def test_a_pad_on_a_shaft_is_a_line_contact_on_an_elastic_foundation() -> None:
    deep, stiffness = 1e-4, 2e6 / 0.003
    pad = {"rectangle": [0.006, 0.03], "strips": [13, 1], "tangent": [0, 1, 0], "command": [deep, 0, 0]}
    pads = [jaw("left", [-0.03, 0, 0.04], 1, **pad), jaw("right", [0.03, 0, 0.04], -1, **pad)]
    state = Grasp.from_mesh(shaft(3000), pads).solve([0, 0, 0]).equilibrium
    assert state is not None
    expected = 4 / 3 * stiffness * deep * math.sqrt(2 * 0.02 * deep) * 0.03
    # The points of the left pad come first.
    forces = np.array([contact.force_world for contact in state.contacts])
    assert forces[: len(forces) // 2, 0].sum() == pytest.approx(expected, rel=0.01)


class _Mesh:
    """What trimesh has, too."""

    def __init__(self, vertices: Any, faces: Any) -> None:
        self.vertices, self.faces = vertices, faces


def test_a_mesh_comes_from_arrays_an_object_or_a_file(tmp_path: Path) -> None:
    vertices, faces = bracket()
    file = tmp_path / "bracket.obj"
    lines = [f"v {' '.join(map(str, row))}" for row in vertices] + [f"f {' '.join(map(str, row + 1))}" for row in faces]
    file.write_text("\n".join(lines))
    expected = gripped().hold([0, 30, 0])
    for mesh in (_Mesh(vertices, faces), str(file), file):
        assert gripped(mesh).hold([0, 30, 0]) == expected
    again = pickle.loads(pickle.dumps(gripped()))
    assert again == gripped() and again.hold([0, 30, 0]) == expected


def test_mistakes_in_a_mesh_are_named() -> None:
    vertices, faces = bracket()
    for mesh, said in [
        ((vertices, faces + 0.5), "faces: must be whole"),
        ((vertices, faces - 1), "faces: must be whole"),
        ((vertices[:, :2], faces), r"vertices: shape \(12, 2\)"),
        ((vertices[:5], faces), "corner .* is not there"),
        (7, "mesh: int given"),
        ("nowhere.stl", "nowhere.stl"),
    ]:
        with pytest.raises((TypeError, ValueError), match=said):
            gripped(mesh)
    with pytest.raises(TypeError, match=r"pads\[0\]: 7 given"):
        Grasp.from_mesh(bracket(), [7])  # type: ignore[list-item]
