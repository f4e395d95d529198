//! On random ramps of loads and commands, the factor of first slip is the factor at which a friction constraint of the paper's quadratic program
//! first binds. The first slip comes from a walk along sticking states. The binding constraint comes from Lemke's method on the program's optimality
//! conditions, with the load as parameter.

use std::cell::Cell;

use grasp_lcp::Settings;
use grasp_lcp::energy::{Agreement, ComparisonVerdict};
use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::load_path::{Departure, Onset, OnsetEvent};
use nalgebra::SVector;
use proptest::prelude::*;

use support::ramps::ramps;
use support::random::{Spread, for_all};
use support::samples::assert_met;

#[derive(Debug, Default)]
struct Tally {
    finite: Cell<usize>,
    opens: Cell<usize>,
    never: Cell<usize>,
    not_sticking: Cell<usize>,
    worst: Cell<f64>,
}

fn add(cell: &Cell<usize>) {
    cell.set(cell.get() + 1);
}

fn same_onset<const D: usize, const C: usize>(
    counts: std::ops::Range<usize>,
    spread: Spread,
    cases: usize,
) -> Tally {
    let tally = Tally::default();
    // The program's friction constraints are the facets of the polygon.
    let settings = Settings::default().on_the_polygon();
    for_all(file!(), cases, &ramps::<D, C>(counts, spread), |(mut scene, change)| {
        // Frictionless contacts may open without ending the agreement. They have their own test.
        for datum in &mut scene.contacts {
            if datum.friction == 0.0 {
                datum.friction = 0.3;
            }
        }
        // Loads are sums of forces on the edges of cones, so that single contacts are often exactly on their edge. This change avoids that.
        let size = scene.load.norm();
        scene.load += SVector::<f64, D>::from_fn(|k, _| 0.013 * size * (1.7 * (k + 1) as f64).sin());
        let grasp = scene.grasp();
        let ramp = change.ramp(&scene);
        // A contact without force leaves the position open, and the program's sticking row holds an open contact with friction.
        // Only ramps that start with all contacts sticking are compared.
        let base = grasp.with(&settings).solve(scene.wrench()).unwrap();
        let sticks = base.equilibrium().is_some_and(|e| {
            let most = e.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
            e.contacts.iter().all(|c| c.state == ContactState::Sticking && c.force[0] > 1e-9 * most)
        });
        if !sticks {
            add(&tally.not_sticking);
            return Ok(());
        }
        let onset = grasp.with(&settings.on_the_polygon()).onset(&ramp).unwrap();
        let agreement = grasp.with(&settings).energy().agreement(&ramp).unwrap();
        let slides = |event: &OnsetEvent<C>| {
            event.leaving.iter().all(|leaving| matches!(leaving.how, Departure::Slides { .. }))
        };
        match (&onset, &agreement) {
            // A contact opens through the apex of its cone. If its sticking row then keeps it without force, the minimum
            // remains an equilibrium.
            (Onset::At(event), _) if !slides(event) => {
                add(&tally.opens);
                prop_assert!(agreement.factor().is_some_and(|f| f >= event.factor * (1.0 - 1e-12)));
            }
            (Onset::At(event), Agreement::UpTo { factor, binding }) => {
                add(&tally.finite);
                // The difference is relative to the whole load, because at factor 1 the change of the load is as large as the base load.
                let apart = (event.factor - factor).abs() / (1.0 + event.factor);
                tally.worst.set(tally.worst.get().max(apart));
                prop_assert!(apart <= 1e-12, "{} {}", event.factor, factor);
                for leaving in &event.leaving {
                    prop_assert!(binding.iter().any(|(contact, _)| *contact == leaving.contact.index));
                }
                // Just below the factor of first slip both methods agree, and just beyond it they do not.
                let at = |tau: f64| {
                    let there = change.at(&scene, tau);
                    there.grasp().energy().compare(there.wrench()).unwrap().verdict
                };
                prop_assert_eq!(at(0.999 * factor), ComparisonVerdict::Agree);
                let beyond = at(1.001 * factor + 1e-9);
                prop_assert!(
                    !matches!(beyond, ComparisonVerdict::Agree | ComparisonVerdict::TwoEquilibria),
                    "{beyond:?}"
                );
            }
            (Onset::Never, Agreement::Always) => add(&tally.never),
            (Onset::GivesWay { factor, .. }, Agreement::Unbounded) => prop_assert_eq!(*factor, 0.0),
            _ => prop_assert!(false, "{onset:?}\n{agreement:?}"),
        }
        Ok(())
    });
    println!("{tally:?}");
    tally
}

#[test]
fn planar_ramps() {
    let tally = same_onset::<3, 2>(2..6, Spread::Narrow, 400);
    assert_met(&[(tally.finite.get(), 80)]);
}

#[test]
fn planar_ramps_with_different_springs() {
    let tally = same_onset::<3, 2>(2..6, Spread::Wide, 400);
    assert_met(&[(tally.finite.get(), 26)]);
}

#[test]
fn spatial_ramps() {
    let tally = same_onset::<6, 3>(3..6, Spread::Narrow, 150);
    assert_met(&[(tally.finite.get(), 7)]);
}
