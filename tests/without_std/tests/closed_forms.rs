//! Answers of the library without std against closed formulas.

use std::f64::consts::PI;

use grasp_lcp::lcp::{Lcp, Outcome};
use grasp_lcp::nalgebra::{DMatrix, DVector};
use grasp_lcp::{friction, planar, spatial};

/// A palm on side -1 or 1 that presses with 10 N, μ = 0.5.
fn palm(side: f64) -> planar::Contact {
    planar::Contact::new([side, 0.0], [-side, 0.0])
        .series_stiffness(1e3, 8e2)
        .friction(0.5)
        .pressed_with(10.0)
}

#[test]
fn two_fingers_of_the_paper_slide_at_the_root_of_65_over_66() {
    let finger = |side: f64| {
        planar::Contact::new([4.0 * side, 1.8], [-8.0 * side, -1.0])
            .series_stiffness(5.0, 5.0)
            .friction(0.25)
            .command([0.1, 0.0125 * side])
    };
    let grasp = planar::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    let onset = grasp.onset(planar::Wrench::force([0.0, -1.0])).unwrap();
    assert!((onset.factor().unwrap() - 65f64.sqrt() / 66.0).abs() < 1e-15);
}

#[test]
fn a_load_that_turns_slides_at_its_angle() {
    // A box of 12 N, tilted from its side, slides at the angle θ with 6 sin θ + 3 cos θ = 5.
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap();
    let turn = planar::Turn::tilting([12.0, 0.0], [0.0, 0.0]).reversed();
    let closed = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    assert!((grasp.onset_of_turn(turn).unwrap().onset.factor().unwrap() - closed).abs() < 1e-14);
}

#[test]
fn a_watch_sees_what_measured_forces_have_left() {
    // Each palm presses with 10 N, so that it holds up to 5 N, and carries 3 N. Of a further load of 5 N both palms hold four fifths. To hold all of
    // it, each must press with 11 N.
    let fingers = planar::Fingers::new(&[palm(-1.0), palm(1.0)]).unwrap();
    let watched = fingers.watch(&[[10.0, 3.0], [-10.0, 3.0]], &planar::Wrench::force([0.0, -5.0])).unwrap();
    assert!((watched.margin() - 2.0).abs() < 1e-13);
    assert!((watched.first_slip().factor().unwrap() - 0.8).abs() < 1e-13);
    assert!((watched.extra_squeeze().factor().unwrap() - 0.1).abs() < 1e-13);
}

#[test]
fn a_pinch_in_space_holds_what_its_round_cones_allow() {
    let finger = |side: f64| {
        spatial::Contact::new([side, 0.0, 0.0], [-side, 0.0, 0.0])
            .series_stiffness(1e3, 8e2)
            .friction(0.5)
            .pressed_with(10.0)
    };
    let grasp = spatial::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    for direction in [0.0, PI / 7.0, PI / 3.0, 2.0] {
        let (sin, cos) = direction.sin_cos();
        let pull = spatial::Wrench::force([0.0, cos, sin]);
        let onset = grasp.onset(pull).unwrap();
        assert!((onset.factor().unwrap() - 10.0).abs() < 1e-13);
        let verdict = grasp.hold(pull * 12.0).unwrap().to_string();
        assert!(verdict.starts_with("SLIDES") || verdict.contains("10 N"), "{verdict}");
    }
}

#[test]
fn a_linear_complementarity_problem_has_its_solution() {
    let m = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
    let problem = Lcp::new(m, DVector::from_vec(vec![-5.0, -6.0])).unwrap();
    let Outcome::Solved(solution) = problem.solve() else { panic!("M is positive definite") };
    assert!((solution.z - DVector::from_vec(vec![4.0 / 3.0, 7.0 / 3.0])).amax() < 1e-15);
}

#[test]
fn a_block_slides_along_the_push_on_the_floor() {
    let (mass, mu) = (2.0, 0.3);
    let q = DVector::from_vec(vec![-9.81, 3.0, 4.0]);
    let problem = friction::SpatialContacts::new(DMatrix::identity(3, 3) / mass, q, vec![mu]).unwrap();
    let outcome = problem.solve();
    let r = &outcome.solution().unwrap().r;
    let normal = 9.81 * mass;
    for (component, exact) in [normal, -mu * normal * 0.6, -mu * normal * 0.8].into_iter().enumerate() {
        assert!((r[component] - exact).abs() < 1e-12);
    }
}
