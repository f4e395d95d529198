"""The contacts of simulated scenes against statics by hand and the simulators' own forces; their creep against an equilibrium that rests."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from grasp_lcp import Grasp
from grasp_lcp.drake import touching as touching_in_drake
from grasp_lcp.mujoco import touching

mujoco = pytest.importorskip("mujoco")
pytest.importorskip("matplotlib")


def _example(name: str) -> ModuleType:
    path = Path(__file__).resolve().parents[1] / "examples" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # Dataclasses look their module up by its name.
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "examples"))
creep = _example("mujoco_creep")
TIP, JAR = '<geom type="sphere" size="0.01" pos="0.04 0 0" mass="0.05"/>', '<geom type="cylinder" size="0.03 0.04" mass="0.2"/>'
PAD, BALL = '<geom type="box" size="0.01 0.01 0.01" pos="0.04 0 0" mass="0.05"/>', '<geom type="sphere" size="0.03" mass="0.2"/>'
THREE, TWO = '<replicate count="3" euler="0 0 120">', '<replicate count="2" euler="0 0 180">'
# With the centre of mass 5 mm off the axis, towards the first finger.
LOPSIDED = JAR + '<inertial pos="0.005 0 0" mass="0.2" diaginertia="1e-4 1e-4 1e-4"/>'


def changed(*pairs: tuple[str, str]) -> Any:
    """The scene with other bodies in it."""
    text: str = creep.SCENE
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return mujoco.MjModel.from_xml_string(text.format(cone="elliptic", impratio=1.0, tolerance=creep.TOLERANCE))


def read(model: Any) -> tuple[list[Any], Any]:
    """The contacts and the grasp of a scene."""
    data = creep.squeezed(model)
    return touching(model, data, "object"), Grasp.from_mujoco(model, data, "object")


def uneven(held: list[Any]) -> float:
    """By how much, relatively, contacts that are not quite symmetric shift the onset.

    Level contacts on a circle of radius r about a centre that is e beside the axis carry 1/n (1 + 2 e/r) of the weight at most. An
    uneven squeeze counts in full. A normal that is tilted by ν carries ν of its press, and takes μ ν of its friction.
    """
    points, normals = np.array([t.point for t in held]), np.array([t.normal for t in held])
    press, mu = np.array([t.press for t in held]), held[0].friction
    beside = 2 * np.linalg.norm(points.mean(axis=0)[:2]) / np.linalg.norm(points, axis=1).min()
    return float(beside + np.abs(press / press.mean() - 1).max() + np.abs(normals[:, 2]).max() * (1 / mu + mu))


SCENES = {
    "jar in three tips": (),
    "ball in three pads": ((TIP, PAD), (JAR, BALL)),
    "ball in two pads": ((TIP, PAD), (JAR, BALL), (THREE, TWO)),
}


@pytest.mark.parametrize("pairs", SCENES.values(), ids=SCENES.keys())
def test_contacts_are_taken_over_and_hold_their_friction(pairs: tuple[tuple[str, str], ...]) -> None:
    model = changed(*pairs)
    held, grasp = read(model)
    data = creep.squeezed(model)
    object_first = {int(model.geom_bodyid[contact.geom[0]]) == model.body("object").id for contact in data.contact}
    # A sphere comes before a cylinder or a box: of the ball the frames are turned round.
    assert object_first == {bool(pairs)}
    assert len(held) == len(grasp) == model.nu
    for touch in held:
        assert touch.normal @ -touch.point > 0.9 * np.linalg.norm(touch.point)
        # What the actuator of the finger says that it pushes with; it slides along its own axis alone.
        assert touch.press == pytest.approx(data.actuator(touch.name.replace("finger", "press")).force[0], rel=1e-9)
        assert np.linalg.norm(touch.force - touch.press * touch.normal) < 1e-6
    squeezed = grasp.solve([0, 0, 0]).equilibrium
    assert squeezed is not None
    assert squeezed.forces[:, 0] == pytest.approx([touch.press for touch in held], rel=1e-9)

    onset = grasp.onset([0, 0, -1])
    by_hand = sum(touch.friction * touch.press for touch in held)
    print(f"onset {onset.factor} N, by hand {by_hand} N, geometry allows {uneven(held):.1e}")
    assert uneven(held) < 1e-6
    assert onset.factor == pytest.approx(by_hand, rel=uneven(held) + 1e-12)


def test_a_lopsided_jar_slides_at_its_heavy_side() -> None:
    held, grasp = read(changed((JAR, LOPSIDED)))
    radius = np.linalg.norm(held[0].point - np.mean([t.point for t in held], axis=0))
    # The heavy side carries (1 + 2 e/r) / 3 of the weight, by moments about the level axes.
    by_hand = 3 * held[0].friction * held[0].press / (1 + 2 * 0.005 / radius)
    onset = grasp.onset([0, 0, -1])
    assert onset.factor == pytest.approx(by_hand, rel=1e-9)
    assert [leaving.label for leaving in onset.leaving] == ["finger0"]


@pytest.fixture(scope="module")
def sharp() -> tuple[Any, Any, float]:
    """The jar where creep is least, its grasp and the onset."""
    model = creep.scene("elliptic", 1000.0)
    grasp = read(model)[1]
    onset = grasp.onset([0, 0, -1]).factor
    assert onset is not None
    return model, grasp, onset


def test_below_the_onset_the_simulator_creeps_and_the_grasp_rests(sharp: tuple[Any, Any, float]) -> None:
    _, grasp, onset = sharp
    found = {}
    for impratio in (1.0, 10.0):
        model = creep.scene("elliptic", impratio)
        for fraction in (0.3, 0.9):
            found[impratio, fraction] = creep.drift(model, fraction * onset)
            rests = grasp.solve([0, 0, -fraction * onset]).equilibrium
            assert rests is not None and rests.residual < 1e-12
            assert set(rests.states) == {"sticking"}
            # The fingertips in the simulator are where the springs of the grasp have them; their oscillation dies away.
            assert found[impratio, fraction].sink == pytest.approx(-1e3 * rests.twist[2], rel=1e-3)
    print({asked: drift.slip for asked, drift in found.items()})
    # Creep is a damper: three times the load, three times the slip; impratio divides it.
    assert found[1.0, 0.3].slip > 1.0
    assert found[1.0, 0.9].slip == pytest.approx(3 * found[1.0, 0.3].slip, rel=1e-3)
    assert found[10.0, 0.9].slip == pytest.approx(found[1.0, 0.9].slip / 10, rel=1e-3)


def test_under_a_load_both_carry_the_same(sharp: tuple[Any, Any, float]) -> None:
    model, grasp, onset = sharp
    simulated = touching(model, creep.loaded(model, onset / 2), "object")
    state = grasp.solve([0, 0, -onset / 2]).equilibrium
    assert state is not None
    for touch, force in zip(simulated, state.forces_world, strict=True):
        assert touch.force == pytest.approx(force, abs=1e-3 * onset)
    assert sum(touch.force[2] for touch in simulated) == pytest.approx(onset / 2, rel=2e-3)


def test_beyond_the_onset_nothing_holds(sharp: tuple[Any, Any, float]) -> None:
    model, grasp, onset = sharp
    for fraction in (1.001, 1.05, 1.2):
        answer = grasp.solve([0, 0, -fraction * onset])
        assert answer.outcome == "no_equilibrium" and answer.proof is not None
    # MuJoCo's own limit, by bisection. Its slip has doubled about a ten-thousandth beyond it.
    own = creep.gives_way(model, 0.5 * onset, 1.1 * onset)
    print(f"MuJoCo gives way at {own / onset} of the onset")
    assert own == pytest.approx(onset, rel=5e-4)
    assert creep.drift(model, 1.05 * onset).slip > 100 * creep.drift(model, 0.95 * onset).slip


def test_the_example_runs_and_draws(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "pictures" / "creep.svg"
    creep.main(picture, (0.5, 1.1))
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert any(line[:2] == ["3.000", "0.50"] and line[-4] == "rests," for line in lines)
    assert any(line[:2] == ["6.600", "1.10"] and line[-2:] == ["no", "equilibrium"] for line in lines)
    assert "<svg" in picture.read_text() and picture.stat().st_size > 5000


def test_a_jar_that_is_watched_does_not_slip() -> None:
    watch = _example("mujoco_watch")
    alone, watched = watch.run(False), watch.run(True)
    # Three fingers of 4 N and μ = 0.5 hold 6 N; under more the jar slips and is lost.
    assert alone.holds == pytest.approx(6, rel=1e-9)
    assert alone.lost and 6 < alone.load < 8
    # With the watch each presses with a third of the load and a tenth more, over μ.
    assert watched.slipped is None and not watched.lost and watched.down < 1e-4 and watched.margin > 0
    assert watched.press == pytest.approx(1.1 * watch.FULL / 3 / 0.5, rel=0.01)


def test_drake_s_contacts_slide_where_its_jar_does(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pydrake")
    drake = _example("drake_contacts")
    for solver in ("sap", "similar"):
        scene = drake.Scene(solver)
        held = touching_in_drake(scene.plant, scene.context, "object")
        assert [touch.name for touch in held] == ["finger0", "finger1", "finger2"]
        for k, touch in enumerate(held):
            assert touch.normal @ -touch.point > 0.9 * np.linalg.norm(touch.point)
            # The finger stands still: its actuator pushes as much as the contact.
            travelled = scene.plant.GetJointByName(f"press{k}").get_translation(scene.context)
            assert touch.press == pytest.approx(drake.GAIN * (drake.TRAVEL - travelled), rel=1e-6)
        grasp = Grasp.from_drake(scene.plant, scene.context, "object")
        onset = grasp.onset([0, 0, -1]).factor
        assert uneven(held) < 1e-6
        assert onset == pytest.approx(sum(t.friction * t.press for t in held), rel=uneven(held) + 1e-12)
        scene.load(0.9 * onset)
        state = grasp.solve([0, 0, -0.9 * onset]).equilibrium
        assert state is not None and state.residual < 1e-12
        # The fingertips have sunk as the springs of the grasp say.
        assert scene.heights()[1] == pytest.approx(state.twist[2], rel=1e-3)
        below = scene.slip()
        beyond = drake.Scene(solver)
        beyond.load(1.05 * onset)
        assert 0 < 20 * below < beyond.slip()
        assert grasp.solve([0, 0, -1.05 * onset]).outcome == "no_equilibrium"
    drake.main(["sap"], [0.5])
    told = capsys.readouterr().out.splitlines()[-1].split()
    assert told[0] == "sap" and told[1] == told[2] and float(told[3]) > 0
