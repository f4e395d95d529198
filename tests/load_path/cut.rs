//! A load program whose legs are cut into shorter legs gives the same events at the same loads, the same states and the same end. The shorter legs
//! may be given all at once or one after the other, and cuts may lie on events. Random paths in the plane and in space confirm this.

use grasp_lcp::load_path::{Event, LoadPath, PathEnd};
use proptest::prelude::*;
use support::programs::changes;
use support::programs::draw::{over, planar_scenes, spatial_scenes};
use support::programs::tally::Tally;
use support::programs::{Scene, same_state};
use support::samples::assert_met;

/// The load program with its legs cut at these places (leg, fraction). For each piece, also its original leg and its fractions on this leg.
fn cut<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    places: &[(usize, f64)],
) -> (Scene<D, C>, Vec<(usize, [f64; 2])>) {
    let (mut goals, mut legs) = (vec![scene.goals[0].clone()], Vec::new());
    for (leg, to) in scene.goals[1..].iter().enumerate() {
        let from = &scene.goals[leg];
        let mut done = 0.0;
        for &(_, f) in places.iter().filter(|(at, _)| *at == leg) {
            let mut middle = to.clone();
            middle.load = from.load + (to.load - from.load) * f;
            for (m, (a, b)) in middle.commands.iter_mut().zip(from.commands.iter().zip(&to.commands)) {
                *m = a + (b - a) * f;
            }
            goals.push(middle);
            legs.push((leg, [done, f]));
            done = f;
        }
        goals.push(to.clone());
        legs.push((leg, [done, 1.0]));
    }
    (Scene { goals, ..scene.clone() }, legs)
}

/// Checks that the program in pieces, followed in one go or continued leg by leg, has the same events at the same loads and the same end.
fn same_in_pieces<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    path: &LoadPath<'_, C>,
    events: &[Event<C>],
    places: &[(usize, f64)],
) -> Result<(), TestCaseError> {
    // If the object sticks and snaps over hundreds of times, every snap magnifies the rounding errors so far. Such paths are not compared.
    if events.iter().any(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps)) {
        return Ok(());
    }
    let grasp = scene.grasp();
    let (more, legs) = cut(scene, places);
    let program = more.legs();
    let asked = grasp.with(&support::programs::polygon());
    let mut pieces = asked.follow(more.start(), &program).unwrap();
    let again = pieces.run();
    let asked = grasp.with(&support::programs::polygon());
    let mut continued = asked.follow(more.start(), &[]).unwrap();
    let mut later = continued.run();
    for leg in &program {
        continued.continue_with(std::slice::from_ref(leg)).unwrap();
        later.extend(continued.run());
    }
    let story = |events: &[Event<C>]| {
        format!("{:?}", events.iter().map(|e| (e.leg, e.fraction, &e.changes)).collect::<Vec<_>>())
    };
    prop_assert_eq!(story(&again), story(&later));
    prop_assert_eq!(events.len(), again.len(), "{} against {}", story(events), story(&again));
    let place = |leg: usize, f: f64| {
        let (leg, [from, to]) = legs[leg];
        leg as f64 + from + f * (to - from)
    };
    for (a, b) in events.iter().zip(&again) {
        let apart = a.leg as f64 + a.fraction - place(b.leg, b.fraction);
        prop_assert!(apart.abs() <= 1e-9, "{} against {}", story(events), story(&again));
        let what = |e: &Event<C>| {
            changes(e).iter().map(|(i, c)| (*i, std::mem::discriminant(c))).collect::<Vec<_>>()
        };
        prop_assert_eq!(what(a), what(b));
        same_state(scene, &a.state, &b.state, 1e-9)?;
    }
    let ends = [path, &pieces, &continued].map(|path| path.end().map(std::mem::discriminant));
    prop_assert_eq!(ends[0], ends[1], "{:?} against {:?}", path.end(), pieces.end());
    prop_assert_eq!(ends[1], ends[2]);
    let beyond = [path, &pieces, &continued].map(LoadPath::beyond);
    let kinds = beyond.each_ref().map(|beyond| beyond.as_ref().map(std::mem::discriminant));
    prop_assert!(kinds[0] == kinds[1] && kinds[1] == kinds[2], "{:?}", beyond);
    if let (Some(a), Some(b)) = (path.state(), pieces.state()) {
        same_state(scene, &a, &b, 1e-9)?;
    }
    Ok(())
}

/// Cuts each leg at a random place.
fn legs_may_be_cut<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    at: f64,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let places: Vec<_> = (0..scene.goals.len() - 1).map(|leg| (leg, at)).collect();
    same_in_pieces(scene, &path, &events, &places)?;
    tally.checked += usize::from(path.state().is_some());
    Ok(())
}

/// Cuts each leg at every event, and at the loss.
fn legs_may_be_cut_at_events<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let lost = path.end().and_then(PathEnd::loss).map(|loss| (loss.leg, loss.fraction));
    let mut places: Vec<_> = events.iter().map(|e| (e.leg, e.fraction)).chain(lost).collect();
    places.retain(|(_, f)| (1e-9..1.0 - 1e-9).contains(f));
    places.dedup();
    if !places.is_empty() {
        same_in_pieces(scene, &path, &events, &places)?;
        tally.checked += places.len();
    }
    Ok(())
}

#[test]
fn cutting_planar_legs_changes_nothing() {
    let cases = (planar_scenes(), 0.05..0.95_f64);
    let t = over(120, &cases, |(scene, at), tally| legs_may_be_cut(&scene, at, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 70), (t.events, 140)]);
}

#[test]
fn cutting_spatial_legs_changes_nothing() {
    let cases = (spatial_scenes(), 0.05..0.95_f64);
    let t = over(24, &cases, |(scene, at), tally| legs_may_be_cut(&scene, at, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 10), (t.events, 30)]);
}

#[test]
fn cutting_planar_legs_at_events_changes_nothing() {
    let t = over(120, &planar_scenes(), |scene, tally| legs_may_be_cut_at_events(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 120), (t.limits + t.snaps, 16)]);
}

#[test]
fn cutting_spatial_legs_at_events_changes_nothing() {
    let t = over(24, &spatial_scenes(), |scene, tally| legs_may_be_cut_at_events(&scene, tally));
    println!("{t:?}");
    assert_met(&[(t.checked, 12), (t.turns, 12)]);
}
