"""Does it hold, and how much does it need, against closed forms."""

import math
from typing import Any

import pytest
from grasps import pinch

from grasp_lcp import Grasp, Verdict, answers, warnings


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
    # A verdict is true where it says that the load is held.
    assert grasp.hold([0, -7]) and not lost


def test_what_a_pinch_needs() -> None:
    grasp = pinch(0.5, 8.0)
    squeeze = grasp.need("squeeze", [0, -12], squeeze_less=0)
    assert squeeze.amount == pytest.approx(1.5, rel=1e-11)
    assert squeeze.safe == pytest.approx(1.5 / 0.9, rel=1e-11)
    assert squeeze.presses == pytest.approx((12.0, 12.0), rel=1e-11)
    assert grasp.need("friction", [0, -12], may_slide=True).amount == pytest.approx(0.75, rel=1e-11)
    assert grasp.need("load", loads=[[0, -12], [0, -4]]).amount == pytest.approx(8 / 12, rel=1e-11)
    with pytest.raises(ValueError, match="'luck', must be one of squeeze"):
        grasp.need("luck", [0, -12])


def test_how_far_a_weight_may_be_tilted() -> None:
    # F_n = 8 - W/2 sin θ, F_t = W/2 cos θ at the jaw above: W/2 (cos θ + μ sin θ) = 8 μ, for W = 7.5 N.
    grasp = pinch(0.5, 8.0)
    needed = grasp.need("angle", turn={"weight": [0, -7.5]}, sticks=True)
    at = (3.75 * math.cos(needed.amount or 0.0), 3.75 * math.sin(needed.amount or 0.0))
    assert at[0] + 0.5 * at[1] == pytest.approx(4.0, rel=1e-11)
    # The one is halved towards as a verdict, the other is the root of a margin.
    assert needed.amount == pytest.approx(grasp.turn(weight=[0, -7.5]).angle, rel=1e-9)
    assert str(needed).startswith("TAKES ")
    with pytest.raises(TypeError, match="turn: list given, must be a mapping"):
        grasp.need("angle", turn=[0, -7.5])
    with pytest.raises(ValueError, match="turn is missing"):
        grasp.need("angle")


def test_friction_of_one_contact_by_its_name() -> None:
    # Both carry half of 10 N: with 8 N at each μ = 5/8 has to do at left, whatever right has beyond that.
    jaws = Grasp.planar(
        [[-1, 0], [1, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 1e3], friction=[0.1, 0.9], pressed_with=8.0, names=["left", "right"]
    )
    by_name, by_number = (jaws.need("friction", [0, -10], contact=contact, sticks=True).amount for contact in ("left", 0))
    assert by_name == by_number == pytest.approx(5 / 8, rel=1e-11)
    with pytest.raises(ValueError, match=r"contact: none is called 'lift', must be the name of one of \['left', 'right'\]"):
        jaws.need("friction", [0, -10], contact="lift")


def test_a_scene_asks() -> None:
    jaw = {"series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 8}
    scene: dict[str, Any] = {
        "format": "grasp-lcp/1",
        "planar": {
            "contacts": [{"point": [-1, 0], "normal": [1, 0], **jaw}, {"point": [1, 0], "normal": [-1, 0], **jaw}],
            "questions": [{"hold": {"load": {"force": [0, -4]}}}],
        },
    }
    (verdict,) = answers(scene)
    assert isinstance(verdict, Verdict) and verdict.holds
    assert warnings(scene) == []
    scene["planar"]["questions"] = [{"hold": {"load": {"mass": 500}}}]
    (warning,) = warnings(scene)
    assert warning.endswith("masses are in kg; is this in g?")
    scene["planar"]["questions"] = [{"hold": {"load": {"mass": 0.1, "at": [0, -400]}}}]
    (warning,) = warnings(scene)
    assert warning.startswith("a load acts at a distance of 400 m")


def test_a_block_walks_while_it_is_rocked() -> None:
    feet = Grasp.planar([[-0.1, 0], [0.1, 0]], [[0, 1], [0, 1]], series_stiffness=[1e5, 1e5], friction=0.5)
    shaken = feet.shake([[0, 0, 0.4], [0, 0, -0.4]], base=[3.5, -10])
    assert (shaken.outcome, shaken.rests, shaken.stays) == ("walks", False, False)
    assert str(shaken).startswith("WALKS: the object moves 0.01 mm along +x in every cycle, contact 0 and contact 1 slide")
    assert feet.shake([[0, 0, 0.2], [0, 0, -0.2]], base=[3.5, -10]).rests
    found = feet.shakedown([[0, 0, 0.2], [0, 0, -0.2]], base=[3.5, -10])
    assert found.factor == pytest.approx(1.5, rel=1e-8) and str(found).startswith("RESTS in whichever order they come")
    assert (found.outcome, found.rests, found.slips_change_normal_forces) == ("rests", True, False)
    assert feet.shakedown([[0, 0, 0.4], [0, 0, -0.4]], base=[3.5, -10]).outcome == "never_rests"
    least = feet.need("friction", loads=[[0, 0, 0.4], [0, 0, -0.4]], base=[3.5, -10], repeats=True).amount
    assert least == pytest.approx(3.5 / 6, rel=1e-8)


def test_fingers_are_placed_where_they_slide_late() -> None:
    jaws = Grasp.planar([[-0.03, 0.004], [0.03, -0.006]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 8e2], friction=0.5, pressed_with=8.0)
    sides = [{"segment": [[x, -0.02], [x, 0.02]]} for x in (-0.03, 0.03)]
    improved = jaws.improve([0, -1], surfaces=sides, at_most=10)
    assert improved.after == pytest.approx(10, rel=1e-10) and improved.is_locally_best
    assert improved.before is not None and improved.before < 8
    assert str(improved).startswith("FIRST SLIP at 10 N instead of")
    better = jaws.placed_as(improved)
    assert better.onset([0, -1]).factor == pytest.approx(10, rel=1e-10)
    assert improved.points[0, 1] == pytest.approx(improved.points[1, 1], abs=1e-9)


def test_fingers_are_placed_where_most_friction_is_left() -> None:
    # 4 N hang 10 mm aside: one jaw higher by W e / N, 4 mm, each carries half, and μ N - W / 2 is left.
    jaws = Grasp.planar([[-0.03, 0], [0.03, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 8e2], friction=0.5, pressed_with=10.0)
    sides = [{"segment": [[x, -0.02], [x, 0.02]]} for x in (-0.03, 0.03)]
    improved = jaws.improve({"force": [0, -4], "at": [0.01, 0]}, surfaces=sides, goal="reserve", starts=2, steps=50, seed=1)
    assert improved.goal == "reserve" and improved.after == pytest.approx(3, rel=1e-10)
    assert improved.points[1, 1] - improved.points[0, 1] == pytest.approx(0.004, abs=1e-8)
    assert str(improved).startswith("RESERVE of 3 N instead of")


def test_measured_forces_are_watched() -> None:
    # Each bears 3 N of the 5 N that it can; of 5 N more they hold four fifths, and with a tenth more squeeze all.
    jaws = Grasp.planar([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 8e2], friction=0.5, pressed_with=10.0)
    watch = jaws.watch()
    seen = watch([[10, 3], [-10, 3]], [0, -5])
    assert (seen.margin, seen.first_slip, seen.extra_squeeze) == pytest.approx((2.0, 0.8, 0.1), rel=1e-13)
    assert (seen.tightest, seen.leaving, seen.status.name) == (0, (0, 1), "LEAVES")
    # One that slides already has no first slip, and a load that presses no further needs nothing.
    assert watch([[10, 6], [-10, 0]], [0, -5]).first_slip is None
    assert watch([[10, 3], [-10, 3]], [0, 0]).extra_squeeze == 0.0
    with pytest.raises(ValueError, match="2 to 5"):
        Grasp.planar([[0, 0]], [[0, 1]], series_stiffness=1.0, friction=0.5, pressed_with=1.0).watch()


def test_friction_that_is_lower_once_contacts_slide() -> None:
    # Two feet share a pull. The stiff one begins to slide at 7.5 N and keeps 4 N; the other one catches 3.5 N, and slides at 9 N.
    feet = Grasp.planar(
        [[-0.1, 0], [0.1, 0], [-0.1, 0.1], [0.1, 0.1]], [[0, 1], [0, 1], [0, -1], [0, -1]],
        series_stiffness=[[1e3, 1e3], [1e3, 5e2], [1e3, 1.0], [1e3, 1.0]], friction=[0.5, 0.5, 0.0, 0.0],
        kinetic_friction=[0.4, 0.4, None, None], pressed_with=10.0, names=["left", "right", "a", "b"],
    )  # fmt: skip
    verdict = feet.hold([8, 0])
    assert verdict.holds and "caught after slipping 3 mm at left" in str(verdict)
    assert feet.need("load", [8, 0], may_slide=True).amount == pytest.approx(9 / 8, rel=1e-9)
    shaken = feet.shake([[8, 0]])
    assert (shaken.outcome, shaken.every) == ("rests", 1)
    with pytest.raises(ValueError, match="kinetic_friction"):
        Grasp.planar([[0, 0]], [[0, 1]], series_stiffness=1.0, friction=0.5, kinetic_friction=0.6)


def test_what_slips_tell_of_a_pinch() -> None:
    grasp = pinch(0.5, 8.0)
    loads = [[0, -4.7], [0, -4.9], [0, -4.8], [0, -4.6]]
    found = grasp.identify(["friction"], loads)
    # 2 μ N = W, in logarithms.
    logs = [math.log(-load[1] / 16.0) for load in loads]
    mean = sum(logs) / 4
    (mu,) = found.estimates
    assert mu.value == pytest.approx(math.exp(mean), rel=1e-6)
    deviation = math.sqrt(sum((x - mean) ** 2 for x in logs) / 3)
    assert found.residuals == pytest.approx([x - mean for x in logs], abs=1e-6)
    assert mu.standard_error is not None and mu.interval is not None
    assert mu.standard_error == pytest.approx(mu.value * deviation / 2, rel=0.15)
    assert mu.interval[0] < mu.value < mu.interval[1]
    assert (found.outcome, mu.is_fixed, found.not_fixed) == ("converged", True, ())
    assert str(found).startswith("friction 0.29")
    assert grasp.identify("friction", loads) == found
    told = grasp.identify(["friction"], loads, scatter=0.02, base=[0, 0])
    assert told.misfit is not None and told.scatter is None


def test_slips_that_share_errors() -> None:
    grasp = pinch(0.5, 8.0)
    newtons = [4.5, 4.6, 4.7, 4.7, 4.8, 4.9, 5.0, 5.1, 5.2]
    loads = [[0, -force] for force in newtons]
    found = grasp.identify(["friction"], loads, group=["monday"] * 3 + ["tuesday"] * 3 + ["friday"] * 3, outliers=1e9)
    # The mean of three means: s / √3, and Student's quantile with two degrees of freedom.
    logs = [math.log(force / 16.0) for force in newtons]
    means = [sum(logs[k : k + 3]) / 3 for k in (0, 3, 6)]
    error = math.sqrt(sum((x - sum(logs) / 9) ** 2 for x in means) / 2 / 3)
    (mu,) = found.estimates
    assert mu.standard_error is not None and mu.interval is not None
    assert mu.standard_error == pytest.approx(mu.value * error, rel=1e-6)
    assert mu.degrees_of_freedom == pytest.approx(2)
    assert mu.interval[0] == pytest.approx(mu.value * math.exp(-4.302653 * error), rel=1e-6)
    assert found.groups == 3 and "from 9 slips in 3 groups" in str(found)
    alone = grasp.identify(["friction"], loads)
    assert alone.groups is None and alone.estimates[0].degrees_of_freedom == 8


def test_what_slips_do_not_fix() -> None:
    grasp = pinch(0.5, 8.0)
    loads = [[0, -4.7], [0, -4.9], [0, -4.8]]
    found = grasp.identify(["friction", "squeeze"], loads)
    assert found.not_fixed == ("friction and squeeze are not fixed apart by these slips: only their product",)
    assert [(each.is_fixed, each.standard_error, each.interval) for each in found.estimates] == [(False, None, None)] * 2
    weighed = grasp.identify(["friction", {"quantity": "squeeze", "name": "motor"}], loads, known=[([1], 1.0, 0.01)])
    assert [each.is_fixed for each in weighed.estimates] == [True, True]
    assert weighed.estimates[1].name == "motor"
    moved = grasp.identify(["friction"], loads, slip="first", layouts=[[[-0.05, 0], [0.05, 0]]], layout=[0, 1, 1])
    assert moved.estimates[0].value == pytest.approx(0.3, abs=0.01)
    with pytest.raises(TypeError, match="give one of loads and turns"):
        grasp.identify(["friction"])


def test_the_minimum_of_energy_is_compared():
    # A block of 20 N on two points, pushed along the floor: the left one, twice as stiff, slides from 7.5 N on.
    block = Grasp.planar(
        [[-0.1, 0], [0.1, 0]],
        [[0, 1], [0, 1]],
        series_stiffness=[[1000, 800], [1000, 400]],
        friction=0.5,
        pressed_with=10.0,
        names=["left", "right"],
    )
    found = block.compare([9, 0], base=[0, -20])
    assert found.outcome == "out_of_equilibrium"
    assert found.agrees_up_to * 9 == pytest.approx(7.5)
    assert str(found).startswith("DIFFERS: left slides")
    assert block.compare([6, 0], base=[0, -20]).outcome == "agree"


def test_slips_of_two_jaws_belong_to_one_of_them() -> None:
    """The weaker jaw lets go, at 20 N times its friction; which one that is no start of the search says."""
    for start in ([0.3, 0.5], [0.5, 0.3]):
        grasp = Grasp.planar(
            [[-0.03, 0], [0.03, 0]], [[1, 0], [-1, 0]], series_stiffness=[1e3, 8e2], friction=start, pressed_with=10, names=["left", "right"]
        )  # fmt: skip
        each = [{"quantity": "friction", "contacts": ["left"]}, {"quantity": "friction", "contacts": ["right"]}]
        found = grasp.identify(each, [[0, -load] for load in (8.3, 8.62, 8.44, 8.57, 8.28, 8.55)])
        assert found.says.startswith("one of the two is 0.42") and "which one is not fixed" in found.says
        assert not any(estimate.is_fixed for estimate in found.estimates)
        fixed = [[estimate.is_fixed for estimate in each] for each in found.assignments]
        assert sorted(fixed) == [[False, True], [True, False]]


def test_what_hangs_swings() -> None:
    """A force F to the side of a weight W below a hinge turns it by F/W."""
    lamp = Grasp.from_dict({"format": "grasp-lcp/1", "planar": {"links": [{"name": "hook", "hinge": {"point": [0, 0]}}]}})
    verdict = lamp.hold({"force": [1, 0], "at": [0, -0.2]}, base={"force": [0, -20], "at": [0, -0.2]})
    assert verdict.says.startswith("SWINGS") and not verdict
    assert verdict.swing == pytest.approx([0, 0, 0.05], abs=1e-9)
    assert lamp.hold({"force": [0, -20], "at": [0, -0.2]}).swing is None
