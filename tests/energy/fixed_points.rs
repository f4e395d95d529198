//! The minimum power principle gives Coulomb friction if it is used with the normal forces of the equilibrium. Only if these do not depend on the
//! motion can they be known beforehand.

use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::planar::Equilibrium;
use support::minimum_power::minimum_power;
use support::paper::{down, two_fingers_on_rests};

/// The equilibrium with sliding fingers, and the errors of the principle: with the normal forces before the load, and with the normal forces of the
/// equilibrium.
fn errors(slope: f64) -> (Equilibrium, f64, f64) {
    let grasp = two_fingers_on_rests(slope).unwrap();
    let load = down() * 0.5;
    let outcome = grasp.solve(load).unwrap();
    let state = outcome.equilibrium().unwrap().clone();
    for c in &state.contacts[..2] {
        assert!(matches!(c.state, ContactState::Sliding { .. }));
    }
    let unloaded = grasp.contacts().iter().map(|c| c.series_stiffness_of_axes()[0] * c.commanded()[0]);
    let own = state.contacts.iter().map(|c| c.force[0]);
    let off = |normal: Vec<f64>| {
        let answer = minimum_power(&grasp, &load, &normal).expect("a minimum");
        let each = answer.forces.iter().zip(&state.contacts).map(|(f, c)| (f - c.force).norm());
        each.fold(0.0, f64::max)
    };
    let (before, after) = (off(unloaded.collect()), off(own.collect()));
    (state, before, after)
}

#[test]
fn it_holds_where_normal_forces_do_not_depend_on_the_motion() {
    let (state, before, after) = errors(0.0);
    assert!(before < 1e-14 && after < 1e-14, "{before:e} {after:e}");
    // By hand: friction carries 2 · μ 0.5 N, and the rests carry the remaining 0.25 N.
    assert!((state.contacts[2].force[0] - 0.125).abs() < 1e-14);
}

#[test]
fn elsewhere_it_needs_the_normal_forces_of_the_answer() {
    let (_, before, after) = errors(0.125);
    assert!(before > 1e-2, "{before:e}");
    assert!(after < 1e-13, "{after:e}");
}
