//! The load factor of first slip does not depend on coordinates, on units, or on a contact split in two.
//!
//! Each ramp is compared with its own image, so no expected numbers are needed. The factor and the sliding contacts must be the same.

use std::f64::consts::TAU;

use grasp_lcp::Settings;
use grasp_lcp::load_path::OnsetEvent;
use nalgebra::SVector;
use proptest::prelude::*;
use support::ramps::{CASES, Change, Friction, Tally, close, for_both, ramps, slack};
use support::random::{Spread, for_all};
use support::scene::Scene;
use support::transform::Transform;

/// Checks that the same contacts stop sticking. A contact that stops sticking in one scene only must be on the edge of its cone in the other scene.
fn same_leave<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    image: &Scene<D, C>,
    [event, seen]: [&OnsetEvent<C>; 2],
) -> Result<(), TestCaseError> {
    let leaves = |event: &OnsetEvent<C>, i: usize| event.leaving.iter().any(|l| l.contact.index == i);
    for (i, datum) in scene.contacts.iter().enumerate() {
        if leaves(event, i) == leaves(seen, i) {
            continue;
        }
        for (scene, event) in [(scene, event), (image, seen)] {
            let state = scene.grasp().state_at_onset(event).expect("its own event");
            let size = state.contacts.iter().map(|c| c.force.norm()).fold(f64::MIN_POSITIVE, f64::max);
            let c = &state.contacts[i];
            let bounded = datum.friction > 0.0 && datum.friction.is_finite();
            let slack = if bounded { c.force[0].min(c.margin / (1.0 + datum.friction)) } else { c.force[0] };
            prop_assert!(slack <= 1e-9 * size, "{i} {event:?} {seen:?}");
        }
    }
    Ok(())
}

fn check_image<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    transform: &Transform<C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    // Scenes are used only if all forces at factor zero are clearly inside their cones. Otherwise the first slip may depend on rounding.
    if slack(scene, Friction::Polygon).is_none_or(|slack| slack < 1e-3) {
        return Ok(());
    }
    let (load, commands) = transform.ramp(&change.load, &change.commands);
    let image = transform.scene(scene);
    let image_change = Change { load, commands };
    let settings = Settings::default();
    let onset = scene.grasp().with(&settings).onset(change.ramp(scene)).expect("a finite ramp");
    let seen = image.grasp().with(&settings).onset(image_change.ramp(&image)).expect("a finite ramp");
    let (a, b) = (onset.factor(), seen.factor());
    prop_assert!(a.zip(b).is_some_and(|(a, b)| close(a, b)), "{onset:?}\n{seen:?}");
    if let (Some(event), Some(seen)) = (onset.event(), seen.event()) {
        same_leave(scene, &image, [event, seen])?;
    }
    tally.count(&onset);
    Ok(())
}

/// Checks that the first slip is the same if the first contact is split into two halves.
fn check_split<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    change: &Change<D, C>,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    if slack(scene, Friction::Polygon).is_none_or(|slack| slack < 1e-3) {
        return Ok(());
    }
    let (mut split, mut split_change) = (scene.clone(), change.clone());
    split.contacts[0].stiffness *= 0.5;
    split.contacts.push(split.contacts[0]);
    split_change.commands.push(change.commands[0]);
    let settings = Settings::default();
    let onset = scene.grasp().with(&settings).onset(change.ramp(scene)).expect("a finite ramp");
    let halves = split.grasp().with(&settings).onset(split_change.ramp(&split)).expect("a finite ramp");
    let (a, b) = (onset.factor(), halves.factor());
    prop_assert!(a.zip(b).is_some_and(|(a, b)| close(a, b)), "{onset:?}\n{halves:?}");
    tally.count(&onset);
    Ok(())
}

fn transforms<const C: usize>() -> impl Strategy<Value = Transform<C>> {
    prop_oneof![
        [0.0..TAU, 0.0..TAU, 0.0..TAU].prop_map(Transform::turned),
        Just(()).prop_map(|()| Transform::mirrored()),
        prop::collection::vec(-5.0..5.0_f64, C).prop_map(|x| Transform::moved(SVector::from_vec(x))),
        (-6..7_i32, -6..7_i32).prop_map(|(l, f)| Transform::in_units(10_f64.powi(l), 10_f64.powi(f))),
    ]
}

#[test]
fn the_onset_is_the_same_from_every_side_in_the_plane() {
    let tally = Tally::default();
    for spread in [Spread::Narrow, Spread::Wide] {
        let images = (ramps::<3, 2>(2..5, spread), transforms::<2>());
        for_all(file!(), CASES, &images, |((s, change), image)| check_image(&s, &change, &image, &tally));
    }
    tally.assert_at_least(100, 10, 2);
}

#[test]
fn the_onset_is_the_same_from_every_side_in_space() {
    let tally = Tally::default();
    for spread in [Spread::Narrow, Spread::Wide] {
        let images = (ramps::<6, 3>(2..5, spread), transforms::<3>());
        for_all(file!(), CASES, &images, |((s, change), image)| check_image(&s, &change, &image, &tally));
    }
    tally.assert_at_least(20, 2, 0);
}

#[test]
fn the_onset_does_not_feel_a_contact_split_in_two_in_the_plane() {
    for_both::<3, 2>(file!(), &(2..5), check_split).assert_at_least(100, 10, 2);
}

#[test]
fn the_onset_does_not_feel_a_contact_split_in_two_in_space() {
    for_both::<6, 3>(file!(), &(2..5), check_split).assert_at_least(20, 2, 0);
}
