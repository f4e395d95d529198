"""Soft pads, suction cups and forces from arrays, against closed forms and against scenes."""

import math

import numpy as np
import pytest

from grasp_lcp import Grasp

RECTANGLE = {"rectangle": {"sides": [0.02, 0.012]}}


def jaws(**more: object) -> Grasp:
    return Grasp.spatial(
        [[-0.04, 0, 0], [0.04, 0, 0]],
        [[1, 0, 0], [-1, 0, 0]],
        tangents=[0, 1, 0],
        friction=0.5,
        series_stiffness=[3e4, 1e4],
        pressed_with=20.0,
        names=["left", "right"],
        **more,  # type: ignore[arg-type]
    )


def test_two_pads_twist_as_the_uniform_rectangle_does() -> None:
    a, b = 0.02, 0.012
    state = jaws(soft=RECTANGLE).solve([0, 0, 0, 0.01, 0, 0]).equilibrium
    assert state is not None
    k_theta = 1e4 * (a * a + b * b) / 12
    assert state.twist[3] == pytest.approx(0.01 / (2 * k_theta), rel=1e-11)
    onset = jaws(soft=[RECTANGLE, RECTANGLE]).onset([0, 0, 0, 1, 0, 0])
    assert onset.factor == pytest.approx(2 * 0.5 * 20 * math.hypot(a, b) / 6, rel=1e-11)


def test_one_pad_may_stay_a_point() -> None:
    grasp = jaws(soft=[{"ring": {"radius": 0.005, "points": np.int64(6)}}, None])
    contacts = grasp.to_dict()["spatial"]["contacts"]
    assert contacts[0]["soft"] == {"ring": {"radius": 0.005, "points": 6}} and "soft" not in contacts[1]
    assert len(grasp) == 2


def test_a_cup_and_a_vacuum() -> None:
    cup = Grasp.spatial([[0, 0, 0]], [[0, 0, -1]], friction=0.5, series_stiffness=[8e3, 4e3], suction={"radius": 0.02, "pressure": 60e3})
    vacuum = 60e3 * math.pi * 0.02**2
    assert cup.onset([1, 0, 0]).factor == pytest.approx(0.5 * vacuum, rel=1e-11)
    hangs = cup.hold([0, 0, -vacuum / 2])
    assert hangs.holds and hangs.lost == pytest.approx(2.0, rel=1e-9)
    beam = Grasp.planar([[-0.1, 0], [0.1, 0]], [[0, -1], [0, -1]], friction=0.5, series_stiffness=5e3, suction=[30.0, 30.0])
    assert beam.hold([0, -90]).says.startswith("DROPS at 60 N of 90 N")


def test_what_is_refused_names_the_argument() -> None:
    with pytest.raises(ValueError, match=r"soft: 3 given, must be one for all or 2, one a contact"):
        jaws(soft=[None, None, None])
    with pytest.raises(ValueError, match=r"soft: .*contacts\[0\].*unknown name `circle`"):
        jaws(soft={"circle": {"radius": 1}})
    with pytest.raises(ValueError, match=r"soft: .*left: soft fingertip: first side is 0, must be from"):
        jaws(soft={"rectangle": {"sides": [0, 1]}})
    with pytest.raises(ValueError, match=r"suction: .*left: suction is -1, must be from 0"):
        jaws(suction=-1)
    with pytest.raises(ValueError, match=r"soft\[0\]\['pair'\]\['width'\] is nan, must be finite"):
        jaws(soft={"pair": {"width": float("nan")}})


def test_a_force_stays_whatever_pushes_along_it() -> None:
    grasp = Grasp.planar([[-0.03, 0], [0.03, 0]], [[1, 0], [-1, 0]], friction=0.5, series_stiffness=1e3, force=[10.0, None])
    state = grasp.solve([3.0, 0.0]).equilibrium
    assert state is not None
    assert [contact.force[0] for contact in state.contacts] == pytest.approx([10.0, 13.0], rel=1e-12)
    with pytest.raises(ValueError, match="pressed_with and force"):
        Grasp.planar([[0, 0]], [[0, 1]], friction=0.5, series_stiffness=1e3, pressed_with=1.0, force=2.0)


def test_needs_on_top_of_a_load() -> None:
    grasp = Grasp.planar([[-0.03, 0], [0.03, 0]], [[1, 0], [-1, 0]], friction=0.5, series_stiffness=1e3, pressed_with=10.0)
    assert grasp.need("load", [0.0, -1.0], base=[0.0, -6.0]).amount == pytest.approx(4.0, rel=1e-10)
