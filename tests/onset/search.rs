//! The load factor of first slip agrees with a bisection that does not use the library's method.
//!
//! While everything sticks, the forces solve a linear least-squares problem (`support::sticking`). Bisection finds the largest load factor with all
//! forces inside their cones. This must be the factor of first slip. Scenes in the plane and in space, on the round cone and on the polygon, are
//! checked under loads and finger commands. Just below this factor the solver must find that everything sticks, and just above it must not.

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::{ContactState, FoundBy, Outcome};
use grasp_lcp::load_path::{Onset, OnsetEvent};
use proptest::prelude::*;
use support::ramps::{Change, Friction, Tally, close, for_both, slack};
use support::scene::Scene;

/// The load factor at which the first contact slides or opens, by doubling and bisection. It is infinite if all contacts stick up to 2^40.
fn bisected<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    friction: Friction,
) -> Option<f64> {
    let sticks = |factor: f64| slack(&change.at(scene, factor), friction).is_some_and(|slack| slack >= 0.0);
    // Only scenes are used in which the forces at factor zero are clearly inside the cones, so that the outcome does not depend on rounding.
    if !slack(scene, friction).is_some_and(|slack| slack > 1e-3) {
        return None;
    }
    let mut above = 1.0;
    while sticks(above) {
        above *= 2.0;
        if above > 2_f64.powi(40) {
            return Some(f64::INFINITY);
        }
    }
    let mut below = if above > 1.0 { above / 2.0 } else { 0.0 };
    for _ in 0..60 {
        let middle = 0.5 * (below + above);
        *(if sticks(middle) { &mut below } else { &mut above }) = middle;
    }
    Some(below)
}

fn check_bisection<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let (grasp, ramp, settings) = (scene.grasp(), change.ramp(scene), Settings::default());
    for friction in [Friction::Round, Friction::Polygon] {
        let Some(expected) = bisected(scene, change, friction) else { continue };
        let onset = match friction {
            Friction::Round => grasp.with(&settings).onset(&ramp),
            Friction::Polygon => grasp.with(&settings.on_the_polygon()).onset(&ramp),
        };
        let onset = onset.expect("a finite ramp");
        if change.works_on_free_motion(scene) {
            let at_once = matches!(onset, Onset::GivesWay { factor: 0.0, .. });
            prop_assert!(at_once, "{onset:?}");
            continue;
        }
        let factor = onset.factor();
        prop_assert!(factor.is_some_and(|f| close(f, expected)), "{friction:?} {expected} {onset:?}");
        tally.count(&onset);
    }
    Ok(())
}

/// Checks that everything sticks just below the factor of first slip, and that something does not stick just above it.
fn check_both_sides<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    check_both_sides_on(scene, change, Friction::Polygon, tally)?;
    if C == 3 { check_both_sides_on(scene, change, Friction::Round, tally) } else { Ok(()) }
}

fn check_both_sides_on<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    friction: Friction,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    // Only scenes are used in which the forces at factor zero are clearly inside the cones.
    if slack(scene, friction).is_none_or(|slack| slack < 1e-6) {
        return Ok(());
    }
    let (grasp, ramp, round) = (scene.grasp(), change.ramp(scene), Settings::default());
    let (onset, settings) = match friction {
        Friction::Round => (grasp.with(&round).onset(&ramp), round),
        Friction::Polygon => (grasp.with(&round.on_the_polygon()).onset(&ramp), round.on_the_polygon()),
    };
    let onset = onset.expect("a finite ramp");
    let Some(event) = onset.event() else { return Ok(()) };
    // In a stiff scene a change of the factor by 1e-9 may change forces by less than the rounding of the largest force. Such scenes are skipped.
    let beyond = slack(&change.at(scene, event.factor * (1.0 + 1e-9)), friction);
    let Some(beyond) = beyond.filter(|slack| *slack < -2e-12) else { return Ok(()) };
    let solve = |part: f64| {
        let there = change.at(scene, event.factor * part);
        there.grasp().with(&settings).solve(there.wrench()).expect("a finite load")
    };
    let below = solve(1.0 - 1e-9);
    let sticks = below.equilibrium().is_some_and(|e| e.rule == FoundBy::EverythingSticks);
    prop_assert!(sticks, "{event:?} {below:?}");
    let above = solve(1.0 + 1e-9);
    let leaves = match &above {
        Outcome::Equilibrium(e) => e
            .contacts
            .iter()
            .any(|c| matches!(c.state, ContactState::Sliding { .. } | ContactState::Separated)),
        Outcome::NoEquilibrium(_) => true,
        // A nearly singular state cannot be decided so close to the edge of a cone. On the round cone no proof excludes all equilibria if one exists
        // for data that differ by a millionth.
        _ => friction == Friction::Round || beyond > -3e-10,
    };
    prop_assert!(leaves, "{event:?} {above:?}");
    is_at_the_edge(scene, event)?;
    tally.count(&onset);
    Ok(())
}

/// Checks the forces at the first slip: contacts that stop sticking are on the edge of their cones, all others inside.
fn is_at_the_edge<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    event: &OnsetEvent<C>,
) -> Result<(), TestCaseError> {
    prop_assert!(!event.leaving.is_empty());
    let state = scene.grasp().state_at_onset(event).expect("its own event");
    let size = state.contacts.iter().map(|c| c.force.norm()).fold(f64::MIN_POSITIVE, f64::max);
    for (i, c) in state.contacts.iter().enumerate() {
        let leaves = event.leaving.iter().any(|l| l.contact.index == i);
        let bounded = scene.contacts[i].friction > 0.0 && scene.contacts[i].friction.is_finite();
        let margin = if bounded { c.margin.min(c.force[0]) } else { c.force[0] };
        let allowed = 1e-10 * size * (1.0 + if bounded { scene.contacts[i].friction } else { 0.0 });
        prop_assert!(margin >= -allowed, "{i} {event:?}");
        prop_assert!(!leaves || margin <= allowed, "{i} {event:?}");
    }
    Ok(())
}

#[test]
fn the_onset_is_where_bisection_finds_it_in_the_plane() {
    for_both::<3, 2>(file!(), &(2..5), check_bisection).assert_at_least(250, 12, 5);
}

#[test]
fn the_onset_is_where_bisection_finds_it_in_space() {
    for_both::<6, 3>(file!(), &(2..6), check_bisection).assert_at_least(37, 5, 0);
}

#[test]
fn the_onset_has_two_sides_in_the_plane() {
    for_both::<3, 2>(file!(), &(2..5), check_both_sides).assert_at_least(75, 5, 0);
}

#[test]
fn the_onset_has_two_sides_in_space() {
    for_both::<6, 3>(file!(), &(3..5), check_both_sides).assert_at_least(25, 1, 0);
}
