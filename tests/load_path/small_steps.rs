//! Every event of a path lies where small implicit steps find it. If a path is lost, the steps find no equilibrium nearby.
//!
//! The steps ([`support::programs::steps`]) take only the initial state from the crate. At the end of each step they solve the contact law with the
//! previous slip by trying all combinations of contact states. Contact states and forces must agree with the path, except in a step with an event and
//! in the step after it.

use grasp_lcp::load_path::PathEnd;
use proptest::prelude::*;
use support::programs::draw::{few_planar_contacts, over, turning};
use support::programs::steps::Step;
use support::programs::tally::Tally;
use support::programs::{Scene, sizes};
use support::samples::assert_met;

/// Number of steps of each leg.
const STEPS: usize = 100;
/// Number of bisections of a step with a change, so that events are found to 1/25600 of a leg.
const HALVINGS: usize = 8;
/// Tolerance of forces relative to the largest force, the error of slip if a contact changes within a step.
const FORCES: f64 = 5e-4;
/// Length of a step beyond a loss.
const AHEAD: f64 = 1e-6;
/// A state that differs from the last state by more than this (relative forces and motion) is no continuation.
const JUMP: f64 = 1e-3;

fn follows(scene: &Scene<3, 2>, tally: &mut Tally) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let Some(start) = path.state_at(0, 0.0) else { return Ok(()) };
    let ((last_leg, last), end) = (path.place(), path.state().unwrap());
    let width = 1.0 / STEPS as f64;
    let mut step = scene.first_step(&start);
    for leg in 0..=last_leg {
        for k in 1..=STEPS {
            let (from, to) = ((k - 1) as f64 * width, k as f64 * width);
            if leg == last_leg && to > last {
                break;
            }
            // After an event with several continuations the two methods may differ.
            let before = |e: &&grasp_lcp::planar::Event| (e.leg, e.fraction) <= (leg, to);
            if events.iter().filter(before).any(|e| e.other_continuations != Some(0)) {
                return Ok(());
            }
            let Some(mut next) = scene.advance(leg, [from, to], &step, HALVINGS) else {
                return Err(TestCaseError::fail(format!("{leg} {to}: {:?}", path.end())));
            };
            let exact = path.state_at(leg, to).unwrap();
            let states = scene.does(&exact);
            // A contact that stays on an edge may have several equivalent states.
            if next.does != states {
                let tied = |other: &Step| other.does == states && next.apart(other) <= 1e-9;
                next = scene.steps_to(leg, to, &next).into_iter().find(tied).unwrap_or(next);
            }
            let near = |f: f64| f > from - width + 1e-9 && f < to + 1e-9;
            if !events.iter().any(|e| e.leg == leg && near(e.fraction)) {
                prop_assert!(next.does == states, "{leg} {to} {:?} {states:?}", next.does);
                let forces: Vec<_> = exact.contacts.iter().map(|c| c.force).collect();
                let (off, most) = (next.distance(&forces), sizes(&exact).0.max(scene.press()));
                prop_assert!(off <= FORCES * most, "{leg} {off:e} {most}");
                tally.checked += 1;
            }
            step = next;
        }
    }
    if let Some(loss) = path.end().and_then(PathEnd::loss)
        && events.iter().all(|e| e.other_continuations == Some(0))
    {
        let end = scene.first_step(&end);
        let near = |last: &Step, ahead: f64| -> Vec<Step> {
            let steps = scene.steps_to(loss.leg, loss.fraction + ahead, last).into_iter();
            steps.take_while(|next| last.apart(next) <= JUMP).collect()
        };
        // Just beyond a loss a step may still have an equilibrium, for example with a contact that closes in this step and has no friction yet. So a
        // second, longer step follows, which must have none.
        for next in near(&end, AHEAD) {
            let after = near(&next, 30.0 * AHEAD);
            prop_assert!(after.is_empty(), "{:?}, but {next:?} and {:?}", path.end(), after[0]);
        }
        let beyond = scene.steps_to(loss.leg, loss.fraction + AHEAD, &end);
        tally.nothing_beyond += usize::from(beyond.is_empty());
    }
    Ok(())
}

#[test]
fn events_lie_where_small_steps_find_them() {
    let t = over(250, &few_planar_contacts(), |scene, tally| follows(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 100), (t.sticks, 62), (t.opens, 18), (t.closes, 10)]);
    assert_met(&[(t.checked, 12500), (t.nothing_beyond, 37)]);
}

#[test]
fn events_of_loads_that_turn_lie_there_too() {
    let t = over(250, &turning(few_planar_contacts(), 2.5), |scene, tally| follows(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.slides, 100), (t.sticks, 62), (t.opens, 18), (t.closes, 6)]);
    assert_met(&[(t.checked, 12500), (t.nothing_beyond, 12)]);
}
