"""Grasps read from MuJoCo, with joints and actuators, against closed forms, against springs by hand, and against the simulator's own limits."""

from __future__ import annotations

import csv
import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from grasp_lcp import Grasp
from grasp_lcp.mujoco import touching

mujoco = pytest.importorskip("mujoco")
pytest.importorskip("matplotlib")
EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def _example(name: str) -> ModuleType:
    sys.path.insert(0, str(EXAMPLES))
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


creep, pushes, watch = _example("mujoco_creep"), _example("mujoco_pushes"), _example("mujoco_watch")
PULLS = [[0, 0, -1], [0, 0, 1], [1, 0, 0], [0, 1, 0], [1, 1, -1]]
# Two jaws with a slide each on a box without weight; the second actuator may be replaced by an equality.
JAWS = """
<mujoco>
  <option gravity="0 0 0" timestep="0.001" tolerance="1e-12" cone="elliptic" impratio="100"/>
  <default><geom condim="3" friction="0.5"/></default>
  <worldbody>
    <body name="left" pos="-0.03 0 0"><joint name="left" type="slide" axis="1 0 0" damping="20"/>
      <geom name="left pad" type="{shape}" size="{size}" mass="0.05"/></body>
    <body name="right" pos="0.03 0 0"><joint name="right" type="slide" axis="-1 0 0" damping="20"/>
      <geom name="right pad" type="{shape}" size="{size}" mass="0.05"/></body>
    <body name="object"><freejoint/><geom type="box" size="0.02 0.02 0.02" mass="0.1"/></body>
  </worldbody>
  <actuator>{drives}</actuator>
  <equality>{equality}</equality>
</mujoco>"""
DRIVE = '<position name="{name} motor" joint="{name}" kp="1000" forcerange="-{most} {most}" forcelimited="true"/>'
FOLLOWS = '<joint joint1="right" joint2="left" polycoef="0 1 0 0 0" solref="0.002 1"/>'
TRAVEL = 0.006


def gripped(shape: str = "sphere", size: str = "0.01", most: float = 20.0, drives: tuple[str, ...] = ("left", "right")) -> Any:
    """Model and data of the jaws at rest, and the grasp."""
    equality = FOLLOWS if len(drives) == 1 else ""
    told = "".join(DRIVE.format(name=name, most=most) for name in drives)
    model = mujoco.MjModel.from_xml_string(JAWS.format(shape=shape, size=size, drives=told, equality=equality))
    data = mujoco.MjData(model)
    data.ctrl[:] = TRAVEL
    mujoco.mj_step(model, data, 3000)
    return Grasp.from_mujoco(model, data, "object")


def pressed(grasp: Grasp) -> float:
    """The force of each jaw, N, at rest."""
    state = grasp.solve([0, 0, 0]).equilibrium
    assert state is not None
    return float(sum(contact.force[0] for contact in state.contacts)) / 2


@pytest.mark.parametrize("pull", PULLS)
def test_the_jar_slides_where_springs_by_hand_say(pull: list[float]) -> None:
    model = creep.scene("elliptic", 1000.0)
    data = creep.squeezed(model)
    by_hand = watch.grasp_of(model, touching(model, data, "object"))
    assert Grasp.from_mujoco(model, data, "object").onset(pull).factor == pytest.approx(by_hand.onset(pull).factor, rel=1e-6)


@pytest.mark.parametrize("number", [0, 40, 90, 140, 200])
def test_a_pushed_block_slides_where_mujoco_lets_it(number: int) -> None:
    row = list(csv.DictReader(pushes.DATA.open()))[number]
    push = np.array([float(row[name]) for name in ("fx_N", "fy_N", "mz_Nm")])
    model = pushes.scene(row["support"], 0.3, 0.0005, 100.0)
    rest = mujoco.MjData(model)
    mujoco.mj_step(model, rest, 400)
    verdict = Grasp.from_mujoco(model, rest, "block").hold([push[0], push[1], 0, 0, 0, push[2]], base=[0, 0, -pushes.MASS * pushes.GRAVITY])
    exact = 0.3 * pushes.limit(pushes.block(row["support"]), push)
    assert verdict.lost == pytest.approx(exact, rel=2e-4)
    # A push that is held for T seconds moves the block half a millimetre if it exceeds the limit by a part in proportion to 1 / T².
    one, two = (pushes.slides_at(model, push, exact, watch=watch, halvings=15) for watch in (1.0, 2.0))
    assert (4 * two - one) / 3 == pytest.approx(verdict.lost, rel=2e-4)


@pytest.mark.parametrize(("shape", "size", "contacts"), [("sphere", "0.01", 2), ("box", "0.01 0.01 0.01", 8)])
def test_pads_with_several_contacts_hold_their_friction(shape: str, size: str, contacts: int) -> None:
    grasp = gripped(shape, size)
    assert len(grasp) == contacts
    press = pressed(grasp)
    assert 3 < press < 6
    # A pull along the jaws takes the friction of both.
    assert grasp.hold([0, 1000, 0]).lost == pytest.approx(2 * 0.5 * press / 1000, rel=1e-5)


def test_a_motor_stalls_at_its_force() -> None:
    grasp = gripped(most=5.0)
    press = pressed(grasp)
    onset = grasp.onset([1, 0, 0])
    # Both jaws are as stiff: the right one takes half of the pull.
    assert onset.factor == pytest.approx(2 * (5.0 - press), rel=1e-6)
    assert "right motor" in str(onset)


def test_jaws_that_are_coupled_do_not_yield_along_their_way() -> None:
    grasp = gripped(drives=("left",))
    springs = [contact["series_stiffness"][0] for contact in grasp.to_dict()["spatial"]["fingers"][0]["contacts"]]
    state = grasp.solve([0.5, 0, 0]).equilibrium
    assert state is not None
    assert state.twist[0] == pytest.approx(0.5 / sum(springs), rel=1e-4)


def test_what_cannot_be_read_is_named() -> None:
    model = creep.scene()
    with pytest.raises(ValueError, match="nothing presses on it"):
        Grasp.from_mujoco(model, mujoco.MjData(model), "object")
    stacked = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom type="plane" size="1 1 1"/><body name="low" pos="0 0 0.05"><freejoint name="loose"/>'
        '<geom type="box" size="0.05 0.05 0.05"/></body><body name="high" pos="0 0 0.15"><freejoint/>'
        '<geom type="box" size="0.05 0.05 0.05"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(stacked)
    mujoco.mj_step(stacked, data, 1000)
    with pytest.raises(ValueError, match="'loose': a free or a ball joint is behind a contact"):
        Grasp.from_mujoco(stacked, data, "high")
