//! Stiffness and edges of a rectangular pad under uniform pressure, integrated by hand, agree with the behaviour of grasps by its points.

use grasp_lcp::Error;
use grasp_lcp::spatial::{Contact, Departure, Grasp, Ramp, SoftFingertip, Wrench};
use support::assert_relatively_close;
use support::facts;

const SIDES: [f64; 2] = [0.020, 0.012];
const KN: f64 = 30e3;
const KT: f64 = 10e3;
const MU: f64 = 0.4;
const N: f64 = 25.0;
const STRIPS: [[usize; 2]; 4] = [[1, 1], [2, 1], [1, 3], [2, 2]];

/// Pads on a table, with x along the first side and y along the second.
fn pads() -> Vec<(SoftFingertip, Contact, Grasp)> {
    let table = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(KN, KT)
        .friction(MU);
    let pad = |strips| {
        let pad = SoftFingertip::rectangle(SIDES, strips).expect("a pad");
        let grasp = Grasp::new(pad.contacts(&table).expect("points")).expect("a grasp");
        (pad, table.clone(), grasp)
    };
    STRIPS.into_iter().map(pad).collect()
}

fn pressed() -> Wrench {
    Wrench::force([0.0, 0.0, -N])
}

#[test]
fn it_gives_way_as_the_uniform_pad_does() {
    let [a, b] = SIDES;
    let moved = |grasp: &Grasp, load: Wrench| {
        let state = grasp.solve(pressed() + load).expect("a load");
        state.equilibrium().expect("pressed all over").twist
    };
    for (pad, table, grasp) in pads() {
        assert_relatively_close!(moved(&grasp, Wrench::ZERO).translation()[2], -N / KN);
        assert_relatively_close!(moved(&grasp, Wrench::force([1.0, 0.0, 0.0])).translation()[0], 1.0 / KT);
        assert_relatively_close!(moved(&grasp, Wrench::force([0.0, 1.0, 0.0])).translation()[1], 1.0 / KT);
        let turned = |axis: usize, moment: f64| {
            let along = std::array::from_fn(|k| if k == axis { moment } else { 0.0 });
            moved(&grasp, Wrench::new([0.0; 3], along)).rotation()[axis]
        };
        let [about_x, about_y] = [KN * b * b / 12.0, KN * a * a / 12.0];
        assert_relatively_close!(turned(0, 0.01), 0.01 / about_x);
        assert_relatively_close!(turned(1, 0.01), 0.01 / about_y);
        assert_relatively_close!(turned(2, 0.01), 0.01 / (KT * (a * a + b * b) / 12.0));
        assert_relatively_close!(pad.tilting_stiffnesses(&table)[0], about_x);
        assert_relatively_close!(pad.tilting_stiffnesses(&table)[1], about_y);
        assert_relatively_close!(pad.tilting_stiffness(&table), about_x);
        assert_relatively_close!(pad.torsional_stiffness(&table), KT * (a * a + b * b) / 12.0);
    }
}

/// The core of a rectangle is a rhombus: the first corner or edge opens at |M_x| 6/b + |M_y| 6/a = N.
#[test]
fn it_opens_where_the_core_ends() {
    let [a, b] = SIDES;
    for (pad, _, grasp) in pads() {
        for [x, y] in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [-2.0, 1.0], [0.5, -3.0]] {
            let onset =
                grasp.onset(Ramp::load(pressed(), Wrench::new([0.0; 3], [x, y, 0.0]))).expect("a ramp");
            let event = onset.event().expect("it opens");
            assert_relatively_close!(event.factor, N / (f64::abs(x) * 6.0 / b + f64::abs(y) * 6.0 / a));
            assert!(event.leaving.iter().all(|leaving| leaving.how == Departure::Opens));
        }
        assert_relatively_close!(pad.first_opening(N), N * b / 6.0);
    }
}

/// The corner has the largest distance from the centre, and slides first at μ N d/6 with the diagonal d.
#[test]
fn a_corner_slides_first_under_torsion() {
    let diagonal = SIDES[0].hypot(SIDES[1]);
    for (pad, table, grasp) in pads() {
        let onset =
            grasp.onset(Ramp::load(pressed(), Wrench::new([0.0; 3], [0.0, 0.0, 1.0]))).expect("a ramp");
        assert_relatively_close!(onset.factor().expect("slides"), MU * N * diagonal / 6.0);
        assert_relatively_close!(pad.first_sliding(&table, N), MU * N * diagonal / 6.0);
    }
}

/// ⟨r⟩ = D/3 + p² asinh(q/p)/6q + q² asinh(p/q)/6p over a rectangle of half sides p and q with D² = p² + q².
#[test]
fn the_torsional_limit_comes_from_below() {
    for sides in [SIDES, [0.02, 0.02], [0.05, 0.005]] {
        let [p, q] = sides.map(|side| 0.5 * side);
        let mean =
            p.hypot(q) / 3.0 + p * p * (q / p).asinh() / (6.0 * q) + q * q * (p / q).asinh() / (6.0 * p);
        for (strips, most) in [(1, 0.022), (2, 0.004)] {
            let (_, table, _) = &pads()[0];
            let pad = SoftFingertip::rectangle(sides, [strips; 2]).expect("a pad");
            let part = pad.torsional_limit(table, N) / (MU * N * mean);
            assert!(part < 1.0 && part > 1.0 - most, "{part}");
        }
    }
}

#[test]
fn what_is_no_rectangle_is_refused() {
    let refused = |sides, strips, datum: &str, value: &str| {
        let error = SoftFingertip::rectangle(sides, strips).expect_err(datum);
        assert!(matches!(error, Error::Fingertip { .. }));
        let [_, what, given] = facts(&error);
        assert!(what.ends_with(datum) && given == value, "{error}");
    };
    refused([0.0, 0.01], [1, 1], "first side", "0");
    refused([0.01, f64::NAN], [1, 1], "second side", "NaN");
    refused(SIDES, [0, 1], "the first side", "0");
    refused(SIDES, [1, 0], "the second side", "0");
    refused(SIDES, [17, 16], "number of points", "4352");
    assert!(SoftFingertip::rectangle(SIDES, [usize::MAX, usize::MAX]).is_err());
}
