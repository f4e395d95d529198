//! A sliding contact has the right friction force in any direction, and there is a proof that an overloaded patch of many contacts has no
//! equilibrium.

use grasp_lcp::{planar, spatial};
use nalgebra::SVector;
use std::f64::consts::TAU;

/// The friction force of a sliding contact is opposite to its slip, without the error of facets.
#[test]
fn sliding_on_the_round_cone() {
    // A block of 10 N on a foot, with three soft guides around it that are equally stiff in all horizontal directions.
    let foot = spatial::Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(1e3, 8e2).friction(0.5);
    let guide = |third: f64| {
        let (sin, cos) = (third * TAU / 3.0).sin_cos();
        spatial::Contact::new([cos, sin, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e-3, 50.0).bonded()
    };
    let grasp = spatial::Grasp::new([foot, guide(0.0), guide(1.0), guide(2.0)]).expect("valid");
    for angle in (0..64).map(|k| f64::from(k) * 0.1) {
        let load = spatial::Wrench::force([8.0 * angle.cos(), 8.0 * angle.sin(), -10.0]);
        let outcome = grasp.solve(load).expect("finite");
        let found = outcome.equilibrium().expect("holds");
        let force = found.contacts[0].force;
        let friction = grasp.frames().next().expect("the foot") * SVector::from([0.0, force[1], force[2]]);
        let along = SVector::from([angle.cos(), angle.sin(), 0.0]);
        assert!((friction + along * (0.5 * force[0])).norm() < 1e-9, "{friction}");
        assert!(
            matches!(found.contacts[0].state, spatial::ContactState::Sliding { .. })
                && found.residuals.worst() < 1e-13
        );
    }
}

/// For a load beyond the limit of friction the answer is a proof, for any number of contacts.
#[test]
fn an_overloaded_patch() {
    for n in [300, 3000] {
        let contact = |i: usize| {
            planar::Contact::new([(i as f64 + 0.5) / n as f64 * 2.0 - 1.0, 0.0], [0.0, 1.0])
                .series_stiffness(1.0, 0.8)
                .friction(0.3)
                .command([1.0 + 0.1 * (7.3 * i as f64).sin(), 0.0])
        };
        let grasp = planar::Grasp::new((0..n).map(contact)).expect("valid");
        let press = n as f64;
        let held = grasp.solve(planar::Wrench::new([0.29 * press, -press], 0.0)).expect("finite");
        assert!(held.equilibrium().is_some());
        let outcome = grasp.solve(planar::Wrench::new([0.31 * press, -press], 0.0)).expect("finite");
        let planar::Outcome::NoEquilibrium(none) = outcome else { panic!("{outcome:?}") };
        assert!(matches!(none.proof, planar::Proof::SeparatingMotion { .. }));
    }
}
