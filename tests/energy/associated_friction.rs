//! The associated law against its own definition, the least complementary energy, by an interior-point method; the loads it
//! holds that Coulomb's law does not; its dilation.

use std::cell::Cell;

use grasp_lcp::energy::{AssociatedOutcome, QuadraticProgram};
use grasp_lcp::equilibrium::{Outcome, Proof};
use nalgebra::{DMatrix, DVector, SVector};
use proptest::prelude::*;

use support::interior_point::{Oracle, interior_point};
use support::random::{Spread, for_all, scene};
use support::samples::assert_met;
use support::scene::{Scene, wrench};

/// `minimise Σ ½ F·K⁻¹F - a·F` over polygonal cones and `Σ G F + W = 0`, forces as unknowns.
fn complementary_energy<const D: usize, const C: usize>(scene: &Scene<D, C>) -> QuadraticProgram {
    let n = C * scene.contacts.len();
    let (mut g, mut h, mut a) = (DVector::zeros(n), DMatrix::zeros(n, n), DMatrix::zeros(D, n));
    let mut rows: Vec<DVector<f64>> = Vec::new();
    for (i, datum) in scene.contacts.iter().enumerate() {
        let frame = datum.frame();
        for axis in 0..C {
            g[C * i + axis] = -datum.drive()[axis];
            h[(C * i + axis, C * i + axis)] = 1.0 / datum.stiffness[axis];
            let column = wrench::<D, C>(&datum.point, &frame.column(axis).into_owned());
            a.view_mut((0, C * i + axis), (D, 1)).copy_from(&column);
        }
        let facets: u32 = if C == 2 { 2 } else { 8 };
        for facet in 0..facets {
            let mut row = DVector::zeros(n);
            row[C * i] = datum.friction;
            if C == 2 {
                row[C * i + 1] = if facet == 0 { -1.0 } else { 1.0 };
            } else {
                let half = std::f64::consts::PI / 8.0;
                let angle = half * f64::from(2 * facet + 1);
                row[C * i + 1] = -angle.cos() / half.cos();
                row[C * i + 2] = -angle.sin() / half.cos();
            }
            rows.push(row);
        }
    }
    let b = DMatrix::from_fn(rows.len(), n, |i, j| rows[i][j]);
    let d = DVector::zeros(rows.len());
    QuadraticProgram { g, h, a, c: -DVector::from_column_slice(scene.load.as_slice()), b, d }
}

fn least_complementary_energy<const D: usize, const C: usize>(counts: std::ops::Range<usize>, cases: usize) {
    let (sliding, none, silent) = (Cell::new(0), Cell::new(0), Cell::new(0));
    let add = |cell: &Cell<usize>| cell.set(cell.get() + 1);
    for_all(file!(), cases, &scene::<D, C>(counts, Spread::Narrow, 0.15), |mut scene| {
        // Loads are made of forces in the cones; turned round, few can be balanced.
        if scene.load[0] > 0.5 * scene.load.norm() {
            scene.load = -scene.load;
        }
        let grasp = scene.grasp();
        let outcome = grasp.energy().associated_friction(&scene.wrench()).unwrap();
        let qp = complementary_energy(&scene);
        let oracle = interior_point(&qp);
        let state = match (&outcome, &oracle) {
            (AssociatedOutcome::Rest(state), Oracle::Minimum(..) | Oracle::Silent) => state,
            (AssociatedOutcome::NoBalance, Oracle::None | Oracle::Silent) => {
                add(&none);
                return Ok(());
            }
            other => return Err(TestCaseError::fail(format!("{other:?}"))),
        };
        let forces: Vec<f64> =
            state.contacts.iter().flat_map(|c| c.force.iter().copied().collect::<Vec<_>>()).collect();
        let forces = DVector::from_vec(forces);
        let could = scene.contacts.iter().map(|d| d.stiffness.component_mul(&d.drive()).norm());
        let most = could.fold(forces.amax().max(scene.load.norm()), f64::max);
        // Cones, balance, and the value of the minimum.
        prop_assert!((&qp.b * &forces).min() >= -1e-11 * most);
        prop_assert!((&qp.a * &forces - &qp.c).amax() <= 1e-12 * most);
        if let Oracle::Minimum(x, tolerance) = oracle {
            let size = 0.5 * forces.dot(&(&qp.h * &forces)) + qp.g.dot(&forces).abs();
            let apart = (qp.value(&x) - qp.value(&forces)).abs();
            prop_assert!(apart <= 10.0 * tolerance * size.max(1e-3), "{apart} {size}");
        } else {
            add(&silent);
        }
        // The law itself, contact by contact: springs, and a jump that is normal to the cone.
        for (i, (c, datum)) in state.contacts.iter().zip(&scene.contacts).enumerate() {
            let u = support::scene::displacement(
                &datum.point,
                &SVector::<f64, D>::from_column_slice(state.twist.components()),
            );
            let stretch = datum.drive() - datum.frame().tr_mul(&u);
            let mut jump = -c.slip;
            jump[0] = c.gap;
            let missing = c.force.component_div(&datum.stiffness) - stretch - jump;
            let motion = 1.0 + u.norm();
            prop_assert!(missing.norm() <= 1e-11 * motion, "contact {i}: {missing:?}");
            prop_assert!(c.force.dot(&jump).abs() <= 1e-11 * most * motion);
            let reach: f64 = if C == 2 { 1.0 } else { (std::f64::consts::PI / 8.0).cos() };
            let slip = c.slip.norm();
            prop_assert!(c.gap >= datum.friction * slip * reach - 1e-11 * motion, "{c:?}");
            if slip > 1e-9 && c.force[0] > 1e-9 * most {
                add(&sliding);
                // It opens by μ|s| (for a polygon: by the length of the slip in the polygon's own measure).
                prop_assert!(c.dilation() <= datum.friction * slip * (1.0 + 1e-9) + 1e-11);
            }
        }
        Ok(())
    });
    println!(
        "D = {D}: {} sliding contacts, {} without balance, {} silent",
        sliding.get(),
        none.get(),
        silent.get()
    );
    assert_met(&[(sliding.get(), 6)]);
    assert!(none.get() >= 1);
}

#[test]
fn planar() {
    least_complementary_energy::<3, 2>(2..6, 150);
}

#[test]
fn spatial() {
    least_complementary_energy::<6, 3>(3..6, 60);
}

/// Beyond W* no equilibrium exists under Coulomb's law; under the associated one the fingers wedge themselves apart and
/// squeeze as much as it takes. By symmetry F_n and F_t = -μ F_n carry the load: W = 2 F_n (μ·8 - 1)/√65.
#[test]
fn it_holds_what_coulomb_friction_does_not() {
    let grasp = support::paper::two_fingers().unwrap();
    for w in [0.13, 0.14, 1.0, 10.0] {
        let laws = grasp.energy().three_laws(&(support::paper::down() * w)).unwrap();
        assert!(matches!(laws.comparison.equilibrium, Outcome::NoEquilibrium(ref n)
            if matches!(n.proof, Proof::EveryStateTried { .. })));
        let rest = laws.associated.rest().expect("at rest");
        let normal = w * 65f64.sqrt() / 2.0;
        for c in &rest.contacts {
            assert!((c.force[0] - normal).abs() < 1e-13 * normal, "{} {normal}", c.force[0]);
            assert!((c.force[1].abs() - normal / 4.0).abs() < 1e-13 * normal);
            assert!((c.dilation() - 0.25 * c.slip.norm()).abs() < 1e-14);
        }
        assert!((rest.contacts[0].dilation() - rest.contacts[1].dilation()).abs() < 1e-14);
        let text = laws.to_string();
        for needle in ["no equilibrium exists", "constraint binds", "dilation"] {
            assert!(text.contains(needle), "{text}");
        }
    }
}

/// While everything sticks the three laws are one.
#[test]
fn one_answer_while_everything_sticks() {
    let grasp = support::paper::two_fingers().unwrap();
    let laws = grasp.energy().three_laws(&(support::paper::down() * 0.1)).unwrap();
    let state = laws.comparison.equilibrium.equilibrium().unwrap();
    let minimum = laws.comparison.minimum.minimum().unwrap();
    let rest = laws.associated.rest().unwrap();
    for ((a, b), c) in state.contacts.iter().zip(&minimum.contacts).zip(&rest.contacts) {
        assert!((a.force - b.force).norm() < 1e-15 && (a.force - c.force).norm() < 1e-15);
        assert_eq!((c.gap, c.slip), (0.0, SVector::from([0.0, 0.0])));
    }
}
