"""Gradients of batches: differences of factors, numpy's broadcasting, what is told where there is none."""

import importlib.util
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from grasps import jar

from grasp_lcp import OnsetStatus, onset_gradients, onsets

EXAMPLE = Path(__file__).parents[1] / "examples" / "improve_grasps.py"
DOWN = np.array([0.1, 0.2, -1.0, 0.001, -0.002, 0.001])


def made(rows: int = 20, contacts: int = 3) -> dict[str, Any]:
    rng = np.random.default_rng(3)
    grasps = [jar(rng, contacts) for _ in range(rows)]
    normals = np.array([normals for _, normals in grasps])
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    shape = (rows, contacts)
    return {
        "points": np.array([points for points, _ in grasps]),
        "normals": normals,
        "friction": rng.uniform(0.7, 1.0, shape),
        "series_stiffness": rng.uniform(500, 2000, (*shape, 2)),
        "command": np.stack([rng.uniform(0.005, 0.008, shape), *rng.uniform(-3e-4, 3e-4, (2, *shape))], axis=-1),
        "tangents": np.cross(normals, rng.normal(size=(*shape, 3))),
        "base": np.tile([0.05, -0.02, -0.1, 0.0, 0.001, 0.0], (rows, 1)),
        "direction": np.tile(DOWN, (rows, 1)),
    }


def turned(data: dict[str, Any], tilt: np.ndarray) -> dict[str, Any]:
    """Frames that tilt: normals by a vector across them, tangents back along the normals."""
    along = (tilt * data["tangents"]).sum(axis=-1, keepdims=True)
    return data | {"normals": data["normals"] + tilt, "tangents": data["tangents"] - along * data["normals"]}


def difference(data: dict[str, Any], name: str, index: tuple[int, ...], step: float) -> np.ndarray:
    factors = []
    for side in (step, -step):
        change = np.zeros_like(data[name])
        change[(slice(None), *index)] = side
        if name == "normals":
            across = change - (change * data["normals"]).sum(axis=-1, keepdims=True) * data["normals"]
            factors.append(onsets(**turned(data, across)).factor)
        else:
            factors.append(onsets(**data | {name: data[name] + change}).factor)
    return (factors[0] - factors[1]) / (2 * step)


STEPS = {"points": 1e-7, "normals": 1e-6, "friction": 1e-6, "series_stiffness": 1e-2, "base": 1e-6, "direction": 1e-6}


DISC = {"disc": {"radius": 0.004, "annuli": 1, "points": 4}}


@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize(("contacts", "soft"), [(3, None), (2, DISC), (3, [DISC, None, None])])
def test_fields_are_differences_of_factors(name: str, contacts: int, soft: Any) -> None:
    """Also of whole pads, whose points move and tilt with them and share their springs."""
    data = made(contacts=contacts) | {"soft": soft}
    found = onset_gradients(**data)
    assert (found.status == OnsetStatus.LEAVES).all() and not found.one_sided.any()
    assert (found.factor == onsets(**data).factor).all()
    field = getattr(found, name)
    for index in np.ndindex(*field.shape[1:]):
        expected = difference(data, name, index, STEPS[name])
        size = np.abs(field).max()
        assert np.abs(field[(slice(None), *index)] - expected).max() < 1e-6 * size, (name, index)


def test_commands_along_the_axes() -> None:
    data = made()
    del data["command"], data["tangents"]
    data["command_world"] = 0.006 * data["normals"] + np.random.default_rng(5).normal(0, 1e-4, data["normals"].shape)
    field = onset_gradients(**data).command_world
    for index in np.ndindex(*field.shape[1:]):
        expected = difference(data, "command_world", index, 1e-8)
        assert np.abs(field[(slice(None), *index)] - expected).max() < 1e-5 * np.abs(field).max()


def test_broadcasting_is_that_of_numpy() -> None:
    data = made(6)
    pulls = np.random.default_rng(2).normal(size=(5, 3))
    del data["base"], data["direction"]
    table = onset_gradients(**{name: each[:, None] for name, each in data.items()}, direction=pulls)
    assert table.points.shape == (6, 5, 3, 3) and table.base.shape == (6, 5, 6) and table.leaving.shape == (6, 5, 3)
    for k in range(5):
        row = onset_gradients(**data, direction=np.tile(pulls[k], (6, 1)))
        for name in ("factor", "points", "normals", "friction", "base", "contact", "leaving"):
            assert np.array_equal(getattr(row, name), getattr(table, name)[:, k], equal_nan=True), name


def test_rows_without_a_factor_say_why() -> None:
    data = made(5)
    data["points"][1, 0, 0] = np.nan
    data["friction"][2] = -1.0
    data["command"][3] = 0.0
    data["direction"][4] = 0.0
    found = onset_gradients(**data)
    assert found.status.tolist() == [
        OnsetStatus.LEAVES, OnsetStatus.NOT_A_NUMBER, OnsetStatus.MALFORMED, OnsetStatus.NOT_STICKING, OnsetStatus.MALFORMED,
    ]  # fmt: skip
    assert found.contact.tolist()[1:] == [-1] * 4 and not found.leaving[1:].any()
    assert np.isnan(found.points[1:]).all() and np.isfinite(found.points[0]).all()
    assert repr(found) == "<OnsetGradients (5,): 1 with a factor, 0 one-sided>"


def test_a_faulty_load_comes_before_a_faulty_contact() -> None:
    data = made(2)
    data["friction"][:, 0], data["direction"][0, 0] = -1.0, np.nan
    for asked in (onsets, onset_gradients):
        assert asked(**data).status.tolist() == [OnsetStatus.NOT_A_NUMBER, OnsetStatus.MALFORMED]


def test_rows_of_pads_that_share_loads() -> None:
    """Each grasp under all loads, squeezed by forces, with two kinds of pads and a finger that leaves first."""
    jaws = np.broadcast_to([[-0.03, 0.0, 0.0], [0.03, 0.0, 0.0]], (4, 1, 2, 3))
    data = {
        "points": jaws, "normals": -jaws, "friction": np.array([0.5, 0.4]), "series_stiffness": [2e4, 1e4],
        "soft": [{"ring": {"radius": 0.006, "points": 8}}, {"rectangle": {"sides": [0.01, 0.008]}}],
        "direction": np.array([[0.0, 0.1, -1.0, 0.0, 0.001, 0.0], [0.0, -1.0, -0.2, 0.0, 0.0, 0.0005], [1.0, 0.0, 0.0, 0.0, 0.0, np.nan]]),
    }  # fmt: skip
    press = np.linspace(8.0, 11.0, 4)[:, None, None]
    found, more = (onset_gradients(**data, pressed_with=press + change) for change in (0.0, 1e-6))
    assert found.factor.shape == (4, 3) and (found.status[:, 2] == OnsetStatus.NOT_A_NUMBER).all() and np.isnan(found.points[:, 2]).all()
    assert np.array_equal(found.factor, onsets(**data, pressed_with=press).factor, equal_nan=True)
    assert (found.contact[:, :2] == 1).all() and found.leaving[:, :2, 1].all()
    # One newton more at both presses by 1 / k_n along both normals.
    slope = (found.command_world * -data["points"] / 0.03).sum(axis=(-1, -2)) / 2e4
    assert np.allclose((more.factor - found.factor)[:, :2] / 1e-6, slope[:, :2], rtol=1e-6)


def test_ties_are_told() -> None:
    """Two jaws that face each other slide together, each by its own friction."""
    found = onset_gradients(
        [[-0.04, 0], [0.04, 0]], [[1, 0], [-1, 0]], [0, -1.0], series_stiffness=[1e3, 8e2], friction=0.5, pressed_with=8.0
    )  # fmt: skip
    assert found.one_sided and found.leaving.all() and found.contact == 0
    assert found.friction == pytest.approx([16.0, 0.0])


def test_more_contacts_are_refused_by_name() -> None:
    points, normals = jar(np.random.default_rng(1), 6)
    with pytest.raises(ValueError, match="points: gradients are of grasps of 2 to 5 contacts"):
        onset_gradients(points, normals, [0, 0, -1.0], series_stiffness=1e3, friction=0.5)


def test_the_example_climbs_in_time() -> None:
    done = subprocess.run([sys.executable, str(EXAMPLE)], check=True, capture_output=True, text=True)
    figures = done.stdout.splitlines()
    seconds = float(figures[0].split(": ")[1].split(" s,")[0])
    before, after = [float(line.split("hold ")[1].split(",")[1]) for line in figures[1:3]]
    assert after > 1.5 * before, done.stdout
    assert seconds < 60, done.stdout
    # From the best of the climb on the same triangles nothing is lost.
    best, improved = float(figures[3].split()[1]), float(figures[4].split(": ")[1].split()[0])
    assert improved >= best, done.stdout


def test_normals_of_the_example_turn_as_its_derivatives_say() -> None:
    spec = importlib.util.spec_from_file_location("improve_grasps", EXAMPLE)
    assert spec is not None and spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    sys.modules["improve_grasps"] = example
    spec.loader.exec_module(example)
    mesh, rng = example.pear(), np.random.default_rng(4)
    points, faces = mesh.put(rng.normal(size=(2000, 3)), rng.integers(len(mesh.corners), size=2000))
    parts = np.einsum("mij,mj->mi", mesh.weights[faces], points)
    assert parts.min() > -1e-9 and np.allclose(parts.sum(axis=1), 1, atol=1e-9)
    step = np.cross(mesh.normals[faces], rng.normal(size=(2000, 3)))
    after, at = mesh.put(points + 6e-3 * step / np.linalg.norm(step, axis=1, keepdims=True), faces)
    # Over a few triangles flat normals turn by as much in the mean.
    seen = mesh.normals[at] - mesh.normals[faces]
    told = np.einsum("mij,mj->mi", mesh.turns[faces] + mesh.turns[at], after - points) / 2
    assert (seen * told).sum() / (told * told).sum() == pytest.approx(1, abs=0.1)
