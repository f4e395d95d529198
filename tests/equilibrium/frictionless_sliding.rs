//! The paper's program and complementarity agree for frictionless sliding too, even if contacts open.

use std::cell::Cell;

use grasp_lcp::Settings;
use grasp_lcp::energy::{Agreement, ComparisonVerdict, MinimumOutcome};
use grasp_lcp::equilibrium::{ContactState, Outcome};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::planar;
use proptest::prelude::*;

use support::printed_program::{PrintedContact, PrintedProgram};
use support::random::{Spread, for_all, scene};
use support::samples::assert_met;
use support::scene::Datum;

fn agree_without_friction<const D: usize, const C: usize>(counts: std::ops::Range<usize>, decades: f64) {
    let (opened, neither) = (Cell::new(0), Cell::new(0));
    let worst = Cell::new(0.0_f64);
    let add = |cell: &Cell<usize>| cell.set(cell.get() + 1);
    let settings = Settings::default();
    for_all(file!(), 150, &scene::<D, C>(counts, Spread::Narrow, 0.2), |mut scene| {
        for datum in &mut scene.contacts {
            datum.friction = 0.0;
            datum.stiffness = datum.stiffness.map(|k| k.powf(decades / 1.3));
        }
        // A load that pressing contacts can balance.
        let mut load = nalgebra::SVector::<f64, D>::zeros();
        for (i, datum) in scene.contacts.iter().enumerate() {
            let push = 0.1 * ((2 * i) % 5 + 1) as f64;
            load -= support::scene::wrench::<D, C>(&datum.point, &(datum.frame().column(0) * push));
        }
        scene.load = load;
        let grasp = scene.grasp();
        let comparison = grasp.energy().compare(scene.wrench()).unwrap();
        match (&comparison.equilibrium, &comparison.minimum) {
            (Outcome::Equilibrium(state), MinimumOutcome::Minimum(minimum)) => {
                prop_assert_eq!(comparison.verdict, ComparisonVerdict::Agree, "{:?}", comparison.difference);
                prop_assert_eq!(minimum.out_of_balance(), (0.0, 0.0));
                prop_assert!(minimum.binding.is_empty());
                let relative = comparison.difference.expect("both").relative();
                worst.set(worst.get().max(relative));
                if state.contacts.iter().any(|c| c.state == ContactState::Separated && c.gap > 0.0) {
                    add(&opened);
                }
                for c in &minimum.contacts {
                    prop_assert!(c.gap == 0.0 || c.force[0].abs() <= 1e-300, "{:?}", c);
                }
            }
            (Outcome::NoEquilibrium(_), MinimumOutcome::Unbounded { .. } | MinimumOutcome::NoMinimum) => {
                add(&neither);
            }
            (_, other) => return Err(TestCaseError::fail(format!("{other:?} {comparison:?}"))),
        }
        // The printed program, with springs on both sides, has the same minimum.
        if decades < 2.0
            && let Some(minimum) = comparison.minimum.minimum()
        {
            let both = |datum: &Datum<C>| {
                let k = datum.stiffness * 2.0;
                PrintedContact { clearance: datum.clearance, ..PrintedContact::of(k, k) }
            };
            let contacts: Vec<_> = scene.contacts.iter().map(both).collect();
            let printed = PrintedProgram::of(&grasp, &contacts, &scene.wrench(), &settings.cone);
            let Some(qp) = printed.program.solve().unwrap() else {
                return Err(TestCaseError::fail("no minimum"));
            };
            let work = (minimum.potential_energy - minimum.stored_energy).abs();
            let size = printed.constant + minimum.stored_energy + work;
            let value = qp.value + printed.constant;
            prop_assert!((value - minimum.potential_energy).abs() <= 1e-10 * size);
        }
        Ok(())
    });
    println!("D = {D}: worst {:e}, {} opened, {} without", worst.get(), opened.get(), neither.get());
    assert_met(&[(opened.get(), 12)]);
    assert!(worst.get() <= 1e-12);
}

#[test]
fn planar_grasps() {
    agree_without_friction::<3, 2>(3..7, 1.0);
}

#[test]
fn planar_grasps_with_springs_over_eight_decades() {
    agree_without_friction::<3, 2>(3..7, 8.0);
}

#[test]
fn spatial_grasps() {
    agree_without_friction::<6, 3>(6..10, 1.0);
}

/// An object between two frictionless fingers stands on a foot with friction. A force w pulls it sideways half way between fingers and foot. By moments
/// about the fingers' line, the foot carries w/2 by friction, and the fingers the rest. One finger opens at w/2 = 2 k a = 0.4 N, and the foot
/// slides at w/2 = μ 1 N. The methods agree beyond the opening, up to w = 1 N.
#[test]
fn a_frictionless_finger_that_opens_does_not_end_the_agreement() {
    let finger =
        |x: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(10.0, 10.0).command([0.02, 0.0]);
    let foot = planar::Contact::new([0.0, -1.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(0.5);
    let grasp = planar::Grasp::new([finger(-1.0), finger(1.0), foot]).unwrap();
    let weight = planar::Wrench::force([0.0, -1.0]);
    let pull = planar::Wrench::force_at([1.0, 0.0], [0.0, -0.5]);
    for w in [0.0, 0.3, 0.6, 0.79, 0.81, 0.95, 0.999] {
        let comparison = grasp.energy().compare(weight + pull * w).unwrap();
        assert_eq!(comparison.verdict, ComparisonVerdict::Agree, "{w}");
        assert!(comparison.difference.expect("both").relative() < 1e-13);
        let state = comparison.equilibrium.equilibrium().expect("holds");
        assert_eq!(state.contacts[0].state == ContactState::Separated, w > 0.8);
    }
    let beyond = grasp.energy().compare(weight + pull * 1.01).unwrap();
    assert!(matches!(beyond.verdict, ComparisonVerdict::NoEquilibrium { .. }), "{:?}", beyond.verdict);
    let ends = grasp.energy().agreement(Ramp::load(weight, pull)).unwrap();
    let Agreement::UpTo { factor, binding } = ends else { panic!("{ends:?}") };
    assert!((factor - 1.0).abs() < 1e-14, "{factor}");
    assert_eq!(binding.iter().map(|(contact, _)| *contact).collect::<Vec<_>>(), [2]);
}
