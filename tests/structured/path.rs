//! Load programs followed on lists of contact states against `Grasp::follow`, which asks every contact at every event: the same events at
//! the same fractions, the same states on the way and at the end, the same way to end. Random programs in the plane and in space with
//! unloading, commands, openings and closings, and mirror images of them in which contacts change in pairs.

use std::mem::discriminant;

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::load_path::{Change, Event, PatchEvent, PathEnd};
use proptest::prelude::*;
use support::programs::changes;
use support::programs::draw::{
    few_planar_contacts, over, planar_scenes, spatial_scenes, three_spatial_contacts,
};
use support::programs::tally::Tally;
use support::programs::views::View;
use support::programs::{Goal, Scene, direction, same_state, sizes};
use support::samples::{assert_met, samples};

/// Fractions agree to this as a rule,
const FRACTION: f64 = 1e-12;
/// and to this where a stiff contact slides, so that soft ones hold what it has held in the trial state: up to four decades of stiffness
/// are four digits.
const STIFF_FRACTION: f64 = 1e-9;
/// Forces and motions agree to this part of them.
const STATE: f64 = 1e-9;

/// One change of one contact.
struct Told<const C: usize> {
    leg: usize,
    fraction: f64,
    contact: usize,
    change: Change<C>,
}

fn told<const C: usize>(events: &[Event<C>]) -> Vec<Told<C>> {
    let one = |e: &Event<C>, contact, change| Told { leg: e.leg, fraction: e.fraction, contact, change };
    events.iter().flat_map(|e| changes(e).into_iter().map(move |(i, change)| one(e, i, change))).collect()
}

fn same<const C: usize>(a: &Told<C>, b: &PatchEvent<C>) -> bool {
    let alike = match (direction(&a.change), direction(&b.change)) {
        (Some(x), Some(y)) => (x - y).norm() <= STATE,
        _ => true,
    };
    alike
        && a.leg == b.leg
        && (a.fraction - b.fraction).abs() <= STIFF_FRACTION
        && a.contact == b.contact
        && discriminant(&a.change) == discriminant(&b.change)
}

/// What two ways to follow paths agreed on.
#[derive(Debug, Default)]
struct Count {
    /// Changes, and those of them at fractions that differ by more than `FRACTION`.
    changes: usize,
    apart: usize,
    /// Paths that differ, where the long one says that it has other ways to go on.
    elsewhere: usize,
    /// Paths that one follows along a free motion to a gap that closes, and the other ends there.
    free_ways: usize,
    /// Ends at a loss of equilibrium, and those of them beyond which not the same is said to lie.
    lost: usize,
    named_otherwise: usize,
    states: usize,
}

fn compare<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
    count: &mut Count,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut long = asked.follow(&scene.start(), &scene.legs()).unwrap();
    let events = long.run();
    // A free motion to the gap that closes is for this path alone: that of patches ends where it begins.
    let free_way = events.iter().find(|event| event.jump.is_some()).map(|event| (event.leg, event.fraction));
    let expected = told(&events);
    let mut short = grasp.follow_patch(&scene.start(), &scene.legs()).unwrap();
    let list: Vec<_> = short.by_ref().collect();
    let beyond = [long.beyond(), short.beyond()].map(|beyond| beyond.as_ref().map(discriminant));
    let story = || {
        let expected: Vec<_> = expected.iter().map(|t| (t.leg, t.fraction, t.contact, t.change)).collect();
        let list: Vec<_> = list.iter().map(|t| (t.leg, t.fraction, t.contact, t.change)).collect();
        format!("{expected:?} {:?}\nagainst\n{list:?} {:?}", long.end(), short.end())
    };
    if let Some((leg, fraction)) = free_way {
        let loss = short.end().and_then(PathEnd::loss).map(|loss| (loss.leg, loss.fraction));
        let there = loss.is_some_and(|(l, f)| l == leg && (f - fraction).abs() <= STIFF_FRACTION);
        prop_assert!(there, "{}", story());
        count.free_ways += 1;
        return Ok(());
    }
    let kinds = [long.end(), short.end()].map(|end| end.map(discriminant));
    let agree = expected.len() == list.len()
        && expected.iter().zip(&list).all(|(a, b)| same(a, b))
        && kinds[0] == kinds[1];
    if !agree && events.iter().any(|e| e.other_continuations != Some(0)) {
        count.elsewhere += 1;
        return Ok(());
    }
    prop_assert!(agree, "{}", story());
    tally.count(&events, &long);
    count.changes += list.len();
    count.apart +=
        expected.iter().zip(&list).filter(|(a, b)| (a.fraction - b.fraction).abs() > FRACTION).count();
    if let [Some(a), Some(b)] = [long.end(), short.end()].map(|end| end.and_then(PathEnd::loss)) {
        count.lost += 1;
        count.named_otherwise += usize::from(beyond[0] != beyond[1]);
        prop_assert!(a.leg == b.leg && (a.fraction - b.fraction).abs() <= STIFF_FRACTION, "{}", story());
        prop_assert_eq!(&a.contacts, &b.contacts);
    }
    let mut alike = |a: &Equilibrium<C>, b: &Equilibrium<C>| {
        prop_assert!(a.residuals.worst() <= 1e-10, "{:?}\n{}", a.residuals, story());
        let travel = sizes(b).1;
        same_state(scene, a, b, STATE)?;
        for (x, y) in a.contacts.iter().zip(&b.contacts) {
            prop_assert!((x.slip - y.slip).norm() <= STATE * travel, "{:?} {:?}\n{}", x, y, story());
        }
        count.states += 1;
        Ok(())
    };
    if let (Some(a), Some(b)) = (short.state(), long.state()) {
        alike(&a, &b)?;
    }
    tally.checked += 1;
    if matches!(short.end(), Some(PathEnd::NoStart(_))) {
        // A path without a start has no way on which it could stop.
        return Ok(());
    }
    // The same once more, with a stop in the middle of every leg.
    let mut slow = grasp.follow_patch(&scene.start(), &scene.legs()).unwrap();
    let mut told = 0;
    for leg in 0..scene.goals.len() - 1 {
        while slow.next_before(leg, 0.5).is_some() {
            told += 1;
        }
        if let (true, Some(a), Some(b)) = (slow.end().is_none(), slow.state(), long.state_at(leg, 0.5)) {
            prop_assert_eq!(slow.place(), (leg, 0.5));
            alike(&a, &b)?;
        }
    }
    prop_assert_eq!(told + slow.count(), list.len());
    // And leg by leg.
    let mut parts = grasp.follow_patch(&scene.start(), &[]).unwrap();
    let mut events = Vec::new();
    for leg in scene.legs() {
        parts.continue_with(&[leg]).unwrap();
        events.extend(parts.by_ref());
    }
    prop_assert_eq!(&events, &list);
    Ok(())
}

fn compare_all<const D: usize, const C: usize>(
    cases: usize,
    scenes: &impl Strategy<Value = Scene<D, C>>,
) -> (Tally, Count) {
    let count = std::cell::RefCell::new(Count::default());
    let tally = over(cases, scenes, |scene, tally| compare(&scene, tally, &mut count.borrow_mut()));
    let count = count.into_inner();
    println!("{tally:?}\n{count:?}");
    // The patch path carries forces along from event to event: where pairs are lost at once, its events scatter by some 1e-12.
    assert!(count.apart * 40 <= count.changes, "{count:?}");
    // Whether another equilibrium exists just beyond may be a matter of rounding where pairs are lost at once.
    assert!(count.named_otherwise * 8 <= count.lost, "{count:?}");
    (tally, count)
}

/// A scene and its mirror image, held together: what happens, happens to a contact and its image at once.
fn with_its_image<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Scene<D, C> {
    let image = View::mirrored().scene(scene);
    let goal = |(a, b): (&Goal<D, C>, &Goal<D, C>)| Goal {
        load: a.load + b.load,
        commands: a.commands.iter().chain(&b.commands).copied().collect(),
        turn: None,
    };
    Scene {
        spots: scene.spots.iter().chain(&image.spots).cloned().collect(),
        goals: scene.goals.iter().zip(&image.goals).map(goal).collect(),
    }
}

#[test]
fn the_same_events_in_the_plane() {
    let (tally, count) = compare_all(300, &planar_scenes());
    let Tally { slides, sticks, opens, closes, completed, .. } = tally;
    assert_met(&[(slides, 250), (sticks, 125), (opens, 50), (closes, 25), (completed, 125)]);
    assert_met(&[(count.states, 500)]);
    assert!(count.elsewhere == 0);
}

#[test]
fn the_same_events_in_space() {
    let (tally, count) = compare_all(75, &spatial_scenes());
    let Tally { slides, sticks, turns, opens, closes, completed, .. } = tally;
    assert_met(&[(slides, 37), (sticks, 25), (turns, 62), (opens, 6), (closes, 3), (completed, 12)]);
    assert_met(&[(count.states, 62)]);
    assert!(count.elsewhere <= samples(1));
}

#[test]
fn the_same_events_in_pairs_in_the_plane() {
    let (tally, count) = compare_all(75, &few_planar_contacts().prop_map(|scene| with_its_image(&scene)));
    let Tally { slides, sticks, opens, closes, completed, .. } = tally;
    assert_met(&[(slides, 25), (sticks, 12), (opens, 5), (closes, 5), (completed, 12)]);
    assert_met(&[(count.states, 75)]);
    assert!(count.elsewhere <= samples(2));
}

#[test]
fn the_same_events_in_pairs_in_space() {
    let (tally, count) = compare_all(38, &three_spatial_contacts().prop_map(|scene| with_its_image(&scene)));
    let Tally { slides, sticks, turns, completed, .. } = tally;
    assert_met(&[(slides, 12), (sticks, 5), (turns, 5), (completed, 5)]);
    assert_met(&[(count.states, 25)]);
    assert!(count.elsewhere <= samples(2));
}
