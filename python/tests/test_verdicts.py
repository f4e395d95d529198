"""Batches of verdicts and of amounts: the answers of single grasps, pads among them."""

import numpy as np
import pytest
from grasps import jar

import grasp_lcp
from grasp_lcp import AmountStatus, Grasp, LossMotion, OnsetStatus, VerdictStatus, hold_batch, need_batch, onsets

SPRINGS = {"series_stiffness": [900.0, 600.0], "friction": 0.6, "command": [0.006, 0, 0]}
JAWS = ([[-0.03, 0, 0], [0.03, 0, 0]], [[1, 0, 0], [-1, 0, 0]])
PAD = {"disc": {"radius": 0.006, "annuli": 1, "points": 8}}


def jars(rows: int, contacts: int = 3, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    made = [jar(rng, contacts) for _ in range(rows)]
    return np.array([points for points, _ in made]), np.array([normals for _, normals in made])


@pytest.mark.parametrize("contacts", [2, 3, 4, 6])
def test_rows_are_single_verdicts(contacts: int) -> None:
    points, normals = jars(40, contacts)
    loads = np.linspace(0.5, 12, 40)[:, None] * [0.1, 0.2, -1.0]
    found = hold_batch(points, normals, loads, kinetic_friction=0.5, **SPRINGS)
    far = hold_batch(points, normals, loads, kinetic_friction=0.5, beyond=True, **SPRINGS)
    for row in range(40):
        one = Grasp.spatial(points[row], normals[row], kinetic_friction=0.5, **SPRINGS).hold(loads[row])
        assert VerdictStatus(found.status[row]).name.lower() == one.outcome
        assert found.status[row] == far.status[row] and found.holds[row] == bool(one.holds)
        words = str(one)
        if found.status[row] == VerdictStatus.LOST:
            assert words.startswith(LossMotion(found.motion[row]).name.replace("_", " "))
            assert found.held_to[row] == pytest.approx(one.lost, rel=1e-9)
        if one.lost is not None:
            assert far.held_to[row] == one.lost
        slides = one.everything_slides
        assert np.isnan(far.gross_slip[row]) if slides is None else far.gross_slip[row] == slides
        if one.first_slip is not None and found.holds[row]:
            assert found.first_slip[row] == pytest.approx(one.first_slip, rel=1e-9)


def test_a_parallel_jaw_with_pads_is_answered() -> None:
    friction = np.linspace(0.2, 0.8, 50)[:, None]
    given = {"series_stiffness": [2e4, 1e4], "friction": friction, "pressed_with": 10.0}
    # Points alone spin about their line, pads hold 2 μ N along their faces.
    found = onsets(*JAWS, [0, 0, -1.0], soft=PAD, **given)
    assert (found.status == OnsetStatus.LEAVES).all() and found.leaving.shape == (50, 2) and found.leaving.all()
    np.testing.assert_allclose(found.factor, 20 * friction[:, 0], rtol=1e-12)
    # Own loads take the same road.
    own = onsets(*JAWS, np.broadcast_to([0, 0, -1.0], (50, 3)), soft=PAD, **given)
    assert (own.factor == found.factor).all()
    verdicts = hold_batch(*JAWS, [0, 0, -8.0], soft=PAD, **given)
    np.testing.assert_array_equal(verdicts.holds, 20 * friction[:, 0] > 8)
    assert set(verdicts.motion[~verdicts.holds]) <= {LossMotion.SLIPS_OUT, LossMotion.DROPS}
    # One jaw may stay a point.
    one = onsets(*JAWS, [0, 0, -1.0], soft=[PAD, None], **given)
    single = Grasp.spatial(*JAWS, soft=[PAD, None], series_stiffness=[2e4, 1e4], friction=0.2, pressed_with=10.0).onset([0, 0, -1.0])
    assert one.factor[0] == pytest.approx(single.factor, rel=1e-9)
    with pytest.raises(ValueError, match=r"soft\[0\]"):
        onsets(*JAWS, [0, 0, -1.0], soft=[{"ring": {"radius": -1.0, "points": 6}}, None], **given)


def test_amounts_are_those_of_single_grasps() -> None:
    points, normals = jars(12)
    loads = np.linspace(0.5, 6, 12)[:, None] * [0.1, 0.2, -1.0]
    for quantity in ("squeeze", "load"):
        for sticks in (False, True):
            found = need_batch(points, normals, loads, quantity=quantity, sticks=sticks, **SPRINGS)
            for row in range(0, 12, 4):
                one = Grasp.spatial(points[row], normals[row], **SPRINGS).need(quantity, loads[row], sticks=sticks)  # type: ignore[arg-type]
                assert found.status[row] == AmountStatus.BOUND
                assert found.amount[row] == pytest.approx(one.amount, rel=1e-7)


def test_amounts_where_motions_end_what_is_held() -> None:
    """Soft fingers whose object goes too far before it is lost, so that the load at its loss does not tell the squeeze."""
    rng = np.random.default_rng(2)
    angles = 2 * np.pi * np.arange(3) / 3 + rng.uniform(-0.3, 0.3, (30, 3))
    points = np.stack([0.04 * np.cos(angles), 0.04 * np.sin(angles), rng.uniform(-0.01, 0.01, (30, 3))], axis=-1)
    normals, loads = -points * [1, 1, 0], rng.normal(size=(30, 6)) * [5, 5, 5, 0.1, 0.1, 0.1]
    given = {"friction": 0.6, "series_stiffness": [1500, 900], "pressed_with": 10.0}
    found = need_batch(points, normals, loads, **given)
    single = [Grasp.spatial(*row, **given).need("squeeze", load) for *row, load in zip(points, normals, loads, strict=True)]
    assert [AmountStatus(status).name.lower() for status in found.status] == [one.outcome for one in single]
    bounds = [np.nan if one.amount is None else one.amount for one in single]
    np.testing.assert_allclose(found.amount, bounds, rtol=1e-7)
    assert 5 < np.isfinite(bounds).sum() < 25


def test_loads_are_written_as_for_a_single_grasp() -> None:
    given = {"series_stiffness": 1e4, "friction": 0.5, "pressed_with": 8.0}
    jaws = ([[-0.04, 0.0], [0.04, 0.0]], [[1, 0], [-1, 0]])
    loads = [{"mass": 0.5}, {"force": [0, -5], "at": [0.01, 0]}, [0, -20]]
    found = hold_batch(*jaws, loads, **given)
    single = [Grasp.planar(*jaws, **given).hold(load) for load in loads]
    assert found.holds.tolist() == [verdict.holds for verdict in single] == [True, True, False]
    assert found.first_slip == pytest.approx([verdict.first_slip for verdict in single])
    assert onsets(*jaws, loads[1], **given).factor == pytest.approx(single[1].first_slip)
    assert need_batch(*jaws, loads[0], **given).amount == pytest.approx(0.5 * 9.80665 / 8, rel=1e-3)
    with pytest.raises(ValueError, match=r"load\[1\].*wait"):
        hold_batch(*jaws, [[0, -1], {"wait": 1}], **given)


def test_bad_rows_stop_nothing() -> None:
    points, normals = jars(4)
    friction = np.full((4, 3), 0.6)
    friction[1, 2], friction[2, 0] = np.nan, -1
    given = SPRINGS | {"friction": friction}
    verdicts = hold_batch(points, normals, [0, 0, -1.0], **given)
    assert verdicts.status.tolist() == [0, VerdictStatus.NOT_A_NUMBER, VerdictStatus.MALFORMED, 0]
    assert repr(verdicts) == "<Verdicts (4,): 2 sticks, 1 not_a_number, 1 malformed>" and verdicts.answered.tolist() == [
        True,
        False,
        False,
        True,
    ]
    amounts = need_batch(points, normals, [0, 0, -1.0], **given)
    assert amounts.status.tolist() == [0, AmountStatus.NOT_A_NUMBER, AmountStatus.MALFORMED, 0]
    assert hold_batch(np.zeros((0, 3, 3)), normals[0], [0, 0, -1.0], **SPRINGS).holds.shape == (0,)
    table = hold_batch(points[:, None], normals[:, None], [[0, 0, -1.0], [0, 0, -2.0]], **SPRINGS)
    assert table.holds.shape == (4, 2) and "Verdicts (4, 2)" in repr(table)
    with pytest.raises(ValueError, match="quantity"):
        need_batch(points, normals, [0, 0, -1.0], quantity="hope", **SPRINGS)
    assert grasp_lcp.Doubt.NONE == 255
