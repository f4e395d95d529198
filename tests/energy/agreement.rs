//! While everything sticks, the minimum of the paper's program is the equilibrium to 1e-12, for all stiffness ratios. Three ways of solution without
//! a common solver confirm this:
//!
//! * the minimum from orthogonal factors, against complementarity and against the orthogonal decomposition of `support::sticking`;
//! * the program as printed, in all displacements, by Lemke's method on its optimality conditions;
//! * the program as printed and the reduced program, by an interior-point method of another library.

use std::cell::Cell;

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::energy::{ComparisonVerdict, MinimumOutcome};
use grasp_lcp::grasp::Contact;
use nalgebra::{DVector, SVector};
use proptest::prelude::*;

use support::interior_point::{Oracle, interior_point};
use support::printed_program::{PrintedContact, PrintedProgram};
use support::random::{Spread, for_all, scene};
use support::reduced_program::ReducedProgram;
use support::samples::{assert_met, samples};
use support::scene::{Datum, Scene, displacement};
use support::sticking;

const CASES: usize = 300;

/// Random grasps that rarely slide: stiffnesses over this number of decades, friction up to 3, and loads that cause a small motion.
fn grasps<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    decades: f64,
) -> impl Strategy<Value = Scene<D, C>> {
    // `Spread::Narrow` draws stiffnesses 10^(0 … 1.3); a power stretches this range to the given number of decades.
    scene::<D, C>(count, Spread::Narrow, 0.03).prop_map(move |mut scene| {
        for datum in &mut scene.contacts {
            datum.stiffness = datum.stiffness.map(|k| k.powf(decades / 1.3));
            datum.friction *= 2.0;
            datum.clearance = 0.0;
        }
        scene
    })
}

/// The contacts with springs of body and finger: each series stiffness is divided in a random ratio.
fn both_springs<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Vec<PrintedContact<C>> {
    let contact = |(i, datum): (usize, &Datum<C>)| {
        let share = 0.2 + 0.15 * (i % 5) as f64;
        let contact = PrintedContact::of(datum.stiffness / share, datum.stiffness / (1.0 - share));
        PrintedContact { clearance: datum.clearance, ..contact }
    };
    scene.contacts.iter().enumerate().map(contact).collect()
}

/// The grasp of the scene, with separate springs of body and finger at each contact.
fn with_both_springs<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Grasp<C> {
    let contacts = scene.contacts.iter().zip(both_springs(scene));
    Grasp::new(contacts.map(|(datum, printed)| {
        let contact: Contact<C> = datum.contact();
        contact.body_stiffness_axes(printed.body).finger_stiffness_axes(printed.finger)
    }))
    .unwrap()
}

fn largest<const C: usize>(forces: &[SVector<f64, C>]) -> f64 {
    forces.iter().map(SVector::norm).fold(0.0, f64::max)
}

fn apart<const C: usize>(a: &[SVector<f64, C>], b: &[SVector<f64, C>]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y).norm()).fold(0.0, f64::max)
}

/// Worst relative differences: complementarity, decomposition, forces and twist of the printed program.
#[derive(Debug, Default)]
struct Worst {
    complementarity: Cell<f64>,
    decomposition: Cell<f64>,
    printed_force: Cell<f64>,
    printed_motion: Cell<f64>,
    compared: Cell<usize>,
}

fn raise(cell: &Cell<f64>, value: f64) {
    cell.set(if value.is_nan() { f64::INFINITY } else { cell.get().max(value) });
}

fn agree<const D: usize, const C: usize>(counts: std::ops::Range<usize>, decades: f64) -> Worst {
    let worst = Worst::default();
    let settings = Settings::default();
    for_all(file!(), CASES, &grasps::<D, C>(counts, decades), |scene| {
        let grasp = with_both_springs(&scene);
        let load = scene.wrench();
        let comparison = grasp.energy().compare(load).unwrap();
        let MinimumOutcome::Minimum(minimum) = &comparison.minimum else { return Ok(()) };
        if !minimum.binding.is_empty() {
            return Ok(());
        }
        prop_assert_eq!(comparison.verdict, ComparisonVerdict::Agree);
        prop_assert_eq!(minimum.out_of_balance(), (0.0, 0.0));
        let difference = comparison.difference.unwrap();
        raise(&worst.complementarity, difference.relative());
        let forces: Vec<_> = minimum.contacts.iter().map(|c| c.force).collect();
        let truth = sticking::forces(&scene).expect("balances");
        let size = largest(&truth);
        raise(&worst.decomposition, apart(&forces, &truth) / size);

        let printed = PrintedProgram::of(&grasp, &both_springs(&scene), &load, &settings.cone);
        let Some(qp) = printed.program.solve().unwrap() else {
            return Err(TestCaseError::fail("no minimum"));
        };
        let from_multipliers: Vec<_> =
            (0..scene.contacts.len()).map(|i| printed.force_on_object(&qp.equality_multipliers, i)).collect();
        raise(&worst.printed_force, apart(&from_multipliers, &truth) / size);
        let mut motion = 0.0_f64;
        for (i, datum) in scene.contacts.iter().enumerate() {
            let u = printed.displacements(&qp.x, i).body_core;
            let frame = datum.frame();
            motion = motion.max((frame * u - minimum.contacts[i].body_core).norm());
            let twisted =
                displacement(&datum.point, &SVector::<f64, D>::from_column_slice(printed.twist(&qp.x)));
            motion = motion.max((frame.tr_mul(&twisted) - u).norm());
        }
        raise(&worst.printed_motion, motion / difference.displacement_size);
        worst.compared.set(worst.compared.get() + 1);
        Ok(())
    });
    println!("D = {D}, 1e{decades}: {worst:?}");
    worst
}

fn within(worst: &Worst, tolerance: f64, at_least: usize) {
    assert!(worst.compared.get() >= samples(at_least), "{worst:?}");
    for cell in [&worst.complementarity, &worst.decomposition, &worst.printed_force, &worst.printed_motion] {
        assert!(cell.get() <= tolerance, "{worst:?}");
    }
}

#[test]
fn planar_grasps_with_similar_springs() {
    within(&agree::<3, 2>(2..6, 1.0), 1e-12, 60);
}

#[test]
fn planar_grasps_with_springs_over_eight_decades() {
    within(&agree::<3, 2>(2..6, 8.0), 1e-12, 20);
}

#[test]
fn spatial_grasps_with_similar_springs() {
    within(&agree::<6, 3>(3..6, 1.0), 1e-12, 20);
}

#[test]
fn spatial_grasps_with_springs_over_eight_decades() {
    within(&agree::<6, 3>(3..6, 8.0), 1e-12, 10);
}

/// Whether constraints bind or not, the minimum agrees with the interior-point method, the printed program and the reduced programs.
fn same_minimum<const D: usize, const C: usize>(
    counts: std::ops::Range<usize>,
    cases: usize,
) -> (usize, usize) {
    let (sticking, binding, compared) = (Cell::new(0), Cell::new(0), Cell::new(0));
    let settings = Settings::default();
    for_all(file!(), cases, &scene::<D, C>(counts, Spread::Narrow, 0.1), |scene| {
        let grasp = with_both_springs(&scene);
        let load = scene.wrench();
        let outcome = grasp.with(&settings).energy().minimum(load).unwrap();
        let printed = PrintedProgram::of(&grasp, &both_springs(&scene), &load, &settings.cone);
        let drives: Vec<_> = scene.contacts.iter().map(Datum::drive).collect();
        let reduced = ReducedProgram::of(&grasp, &drives, &load, &settings.cone, true);
        let twist_only = ReducedProgram::of(&grasp, &drives, &load, &settings.cone, false);
        let oracle = interior_point(&printed.program);
        let MinimumOutcome::Minimum(minimum) = &outcome else {
            prop_assert!(!matches!(oracle, Oracle::Minimum(..)), "{outcome:?}");
            return Ok(());
        };
        prop_assert!(!matches!(oracle, Oracle::None));
        let value = minimum.potential_energy;
        let size = printed.constant + minimum.stored_energy + (value - minimum.stored_energy).abs();
        let close = |x: &DVector<f64>, tolerance: f64, what: &str| {
            let apart = (printed.program.value(x) + printed.constant - value).abs();
            prop_assert!(apart <= tolerance * size, "{what} {apart} {size}");
            for (i, (c, datum)) in minimum.contacts.iter().zip(&scene.contacts).enumerate() {
                // If the energy is ε above its minimum, ½ ΔF·K⁻¹ΔF <= ε.
                let change = printed.force(x, i) - c.force;
                let energy = 0.5 * change.component_div(&datum.stiffness).dot(&change);
                prop_assert!(energy <= 4.0 * tolerance * size, "{what} {i} {energy} {size}");
            }
            Ok(())
        };
        if let Oracle::Minimum(x, tolerance) = &oracle {
            close(x, *tolerance, "interior point")?;
            compared.set(compared.get() + 1);
        }
        let Some(lemke) = printed.program.solve().unwrap() else {
            return Err(TestCaseError::fail("printed program"));
        };
        close(&lemke.x, 1e-13, "Lemke")?;
        let Some(smaller) = reduced.program.solve().unwrap() else {
            return Err(TestCaseError::fail("reduced program"));
        };
        prop_assert!((smaller.value + reduced.constant - value).abs() <= 1e-9 * size);
        // A program with fewer unknowns has no lower minimum.
        if let Some(fewer) = twist_only.program.solve().unwrap() {
            prop_assert!(fewer.value + twist_only.constant >= value - 1e-9 * size);
        }
        let counter = if minimum.binding.is_empty() { &sticking } else { &binding };
        counter.set(counter.get() + 1);
        Ok(())
    });
    println!("D = {D}: {} sticking, {} binding, {} compared", sticking.get(), binding.get(), compared.get());
    assert!(10 * compared.get() >= 9 * (sticking.get() + binding.get()));
    (sticking.get(), binding.get())
}

#[test]
fn planar_minimum_by_an_interior_point_method() {
    let (sticking, binding) = same_minimum::<3, 2>(1..6, 100);
    assert_met(&[(sticking, 12), (binding, 12)]);
}

#[test]
fn spatial_minimum_by_an_interior_point_method() {
    let (sticking, binding) = same_minimum::<6, 3>(2..5, 50);
    assert_met(&[(sticking, 1), (binding, 16)]);
}
