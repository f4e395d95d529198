"""Does it hold, and how much does it need, against closed forms."""

import pytest
from grasps import pinch

from grasp_lcp import Verdict, answers


def test_a_pinch_holds_twice_its_friction() -> None:
    grasp = pinch(0.5, 8.0)
    verdict = grasp.hold([0, -4])
    assert (verdict.outcome, verdict.holds) == ("sticks", True)
    assert verdict.lost == pytest.approx(2.0, rel=1e-12)
    assert str(verdict).startswith("HOLDS, everything sticks")
    assert verdict.state is not None
    lost = grasp.hold([0, -10])
    assert (lost.outcome, lost.holds, lost.state) == ("lost", False, None)
    assert lost.says.startswith("SLIPS OUT at 8 N of 10 N")


def test_what_a_pinch_needs() -> None:
    grasp = pinch(0.5, 8.0)
    squeeze = grasp.need("squeeze", [0, -12], squeeze_less=0)
    assert squeeze.amount == pytest.approx(1.5, rel=1e-11)
    assert squeeze.safe == pytest.approx(1.5 / 0.9, rel=1e-11)
    assert squeeze.presses == pytest.approx((12.0, 12.0), rel=1e-11)
    assert grasp.need("friction", [0, -12], may_slide=True).amount == pytest.approx(0.75, rel=1e-11)
    assert grasp.need("load", loads=[[0, -12], [0, -4]]).amount == pytest.approx(8 / 12, rel=1e-11)
    with pytest.raises(ValueError, match="unknown variant `luck`"):
        grasp.need("luck", [0, -12])


def test_a_scene_asks() -> None:
    jaw = {"series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 8}
    scene = {
        "format": "grasp-lcp/1",
        "planar": {
            "contacts": [{"point": [-1, 0], "normal": [1, 0], **jaw}, {"point": [1, 0], "normal": [-1, 0], **jaw}],
            "questions": [{"hold": {"load": {"force": [0, -4]}}}],
        },
    }
    (verdict,) = answers(scene)
    assert isinstance(verdict, Verdict) and verdict.holds
