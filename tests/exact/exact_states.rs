//! Forces, displacements, states and error estimates agree with the same contact states solved in exact arithmetic.
//!
//! Stiffnesses differ by factors of up to 1e14, between contacts and between the axes of one. `support::truth` takes every number of a scene as exact
//! and solves for the states that the library returned. Any difference is the rounding of the library.

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::{Accuracy, ContactState, Equilibrium};
use proptest::prelude::*;
use std::cell::RefCell;
use support::random::{Spread, for_all, scene};
use support::samples::assert_met;
use support::scene::Scene;
use support::truth::{Errors, Truth};

/// Errors below this fraction of the largest force or displacement are treated as zero.
const NONE: f64 = 1e-18;

/// Counts of outcomes, and the largest errors.
#[derive(Debug, Default)]
struct Tally {
    sticking: usize,
    sliding: usize,
    /// Scenes without a returned equilibrium.
    none: usize,
    /// Scenes without a unique exact answer: the states have a free motion, or two contacts slide against each other.
    not_determined: usize,
    /// Scenes in which the answer reports that a state is not certain.
    not_distinct: usize,
    /// Largest errors of forces, of force components, and of motions.
    worst_sticking: [f64; 3],
    worst_sliding: [f64; 3],
    /// Largest ratio of the actual error to its estimate, for forces and for displacements.
    underestimated: [f64; 2],
    overestimated: f64,
    worst_condition: f64,
}

impl Tally {
    fn check<const D: usize, const C: usize>(&mut self, scene: &Scene<D, C>) -> Result<(), String> {
        let grasp = scene.grasp();
        let settings = Settings::default().with_most_states(2000);
        let outcome = grasp.with(&settings).solve(scene.wrench()).map_err(|e| e.to_string())?;
        let Some(answer) = outcome.equilibrium() else {
            self.none += 1;
            return Ok(());
        };
        let Some(truth) = Truth::of(scene, &grasp, answer) else {
            self.not_determined += 1;
            return Ok(());
        };
        let errors = truth.errors(&grasp, answer);
        let accuracy = grasp.accuracy(answer).ok_or("no accuracy")?;
        let told = grasp.distinct(answer).ok_or("another grasp")?;
        Self::states(answer, &told, &truth)?;
        let distinct = told.into_iter().all(|distinct| distinct);
        self.estimates(errors, accuracy, &truth, distinct).map_err(|what| format!("{what}\n{answer:?}"))?;
        self.not_distinct += usize::from(!distinct);
        let slides = answer.contacts.iter().any(|c| matches!(c.state, ContactState::Sliding { .. }));
        let (count, worst) = if slides {
            (&mut self.sliding, &mut self.worst_sliding)
        } else {
            (&mut self.sticking, &mut self.worst_sticking)
        };
        *count += 1;
        for (worst, error) in worst.iter_mut().zip([errors.force, errors.component, errors.motion]) {
            *worst = worst.max(error);
        }
        Ok(())
    }

    /// Checks that a state equals the exact state if the answer reports it as certain.
    fn states<const C: usize>(
        answer: &Equilibrium<C>,
        told: &[bool],
        truth: &Truth<C>,
    ) -> Result<(), String> {
        for condition in &truth.conditions {
            let distinct = told[condition.contact];
            if condition.part <= 0.0 && distinct || condition.part < -1e-12 {
                return Err(format!("{condition:?} {distinct}\n{answer:?}"));
            }
        }
        Ok(())
    }

    fn estimates<const C: usize>(
        &mut self,
        errors: Errors,
        accuracy: Accuracy,
        truth: &Truth<C>,
        distinct: bool,
    ) -> Result<(), String> {
        let ratio = |error: f64, estimate: f64, none: f64| if error <= none { 0.0 } else { error / estimate };
        let force = ratio(errors.newtons, accuracy.force, NONE * truth.largest);
        let motion = ratio(errors.metres, accuracy.displacement, NONE * truth.travel);
        self.underestimated = [self.underestimated[0].max(force), self.underestimated[1].max(motion)];
        // Estimates below a unit in the last place are not checked.
        let least = f64::EPSILON * truth.largest;
        if distinct {
            self.overestimated = self.overestimated.max(accuracy.force / errors.newtons.max(least));
        }
        self.worst_condition = self.worst_condition.max(accuracy.condition);
        if force > 10.0 || motion > 10.0 || force.is_nan() || motion.is_nan() {
            return Err(format!("{errors:?} {accuracy:?}"));
        }
        Ok(())
    }
}

fn tally<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    spread: Spread,
    cases: usize,
) -> Tally {
    let tally = RefCell::new(Tally::default());
    let scenes = (scene::<D, C>(count, spread, 0.3), -6.0..1.0_f64).prop_map(|(mut scene, decades)| {
        // Most loads are small for the stiff contacts, some are not.
        scene.load *= 10_f64.powf(decades);
        scene
    });
    for_all(file!(), cases, &scenes, |scene| tally.borrow_mut().check(&scene).map_err(TestCaseError::fail));
    println!("{:?}", tally.borrow());
    tally.into_inner()
}

fn assert_accurate(tally: &Tally) {
    assert!(tally.worst_sticking[0] <= 1e-14 && tally.worst_sliding[0] <= 2e-14, "{tally:?}");
    // Errors of single force components, relative to that component, are small, too.
    assert!(tally.worst_sticking[1] <= 1e-13 && tally.worst_sliding[1] <= 1e-9, "{tally:?}");
    assert!(tally.worst_sticking[2] <= 1e-15 && tally.worst_sliding[2] <= 1e-12, "{tally:?}");
    assert!(tally.overestimated <= 3.0, "{tally:?}");
}

#[test]
fn stiff_scenes_in_the_plane() {
    let tally = tally::<3, 2>(2..7, Spread::Stiff, 1417);
    assert_accurate(&tally);
    assert_met(&[(tally.sticking, 50), (tally.sliding, 166)]);
}

#[test]
fn stiff_scenes_in_space() {
    let tally = tally::<6, 3>(3..7, Spread::Stiff, 250);
    assert_accurate(&tally);
    assert_met(&[(tally.sticking, 15), (tally.sliding, 90)]);
}

#[test]
fn ordinary_scenes() {
    for tally in [tally::<3, 2>(2..7, Spread::Narrow, 100), tally::<6, 3>(3..7, Spread::Narrow, 60)] {
        assert_accurate(&tally);
        assert_met(&[(tally.sticking, 1), (tally.sliding, 20)]);
    }
}
