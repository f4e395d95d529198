//! Cutting the legs of a load program in two changes nothing: the same events at the same loads, the same states, the same
//! end. Random paths in the plane and in space.

mod common_path;

use common_path::draw::{over, planar_scenes, spatial_scenes};
use common_path::tally::Tally;
use common_path::{Scene, same_state};
use grasp_lcp::load_path::Event;
use proptest::prelude::*;

/// Each leg cut somewhere: the same events at the same loads, the same end.
fn legs_may_be_cut<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    cut: f64,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let mut path = grasp.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let mut more = scene.clone();
    for leg in (0..scene.goals.len() - 1).rev() {
        let (from, to) = (&scene.goals[leg], &scene.goals[leg + 1]);
        let mut middle = to.clone();
        middle.load = from.load + (to.load - from.load) * cut;
        for (m, (a, b)) in middle.commands.iter_mut().zip(from.commands.iter().zip(&to.commands)) {
            *m = a + (b - a) * cut;
        }
        more.goals.insert(leg + 1, middle);
    }
    let mut pieces = grasp.follow(more.start(), &more.legs()).unwrap();
    let again = pieces.run();
    let whole =
        |leg: usize, f: f64| (leg / 2, if leg.is_multiple_of(2) { f * cut } else { cut + f * (1.0 - cut) });
    let story = |events: &[Event<D, C>]| {
        format!("{:?}", events.iter().map(|e| (e.leg, e.fraction, &e.changes)).collect::<Vec<_>>())
    };
    prop_assert_eq!(events.len(), again.len(), "{} against {}", story(&events), story(&again));
    for (a, b) in events.iter().zip(&again) {
        let (leg, fraction) = whole(b.leg, b.fraction);
        let place = (a.leg as f64 + a.fraction) - (leg as f64 + fraction);
        prop_assert!(place.abs() <= 1e-9, "{} against {}", story(&events), story(&again));
        let what = |e: &Event<D, C>| {
            e.changes.iter().map(|(i, c)| (*i, std::mem::discriminant(c))).collect::<Vec<_>>()
        };
        prop_assert_eq!(what(a), what(b));
        same_state(scene, &a.state, &b.state, 1e-9)?;
    }
    let ends = [path.end(), pieces.end()].map(|end| end.map(std::mem::discriminant));
    prop_assert_eq!(ends[0], ends[1], "{:?} against {:?}", path.end(), pieces.end());
    if let (Some((_, _, a)), Some((_, _, b))) = (path.position(), pieces.position()) {
        same_state(scene, &a, &b, 1e-9)?;
        tally.checked += 1;
    }
    Ok(())
}

#[test]
fn cutting_planar_legs_changes_nothing() {
    let cases = (planar_scenes(), 0.05..0.95_f64);
    let t = over(2000, &cases, |(scene, cut), tally| legs_may_be_cut(&scene, cut, tally));
    println!("{t:?}");
    assert!(t.checked > 1200 && t.events > 2000, "{t:?}");
}

#[test]
fn cutting_spatial_legs_changes_nothing() {
    let cases = (spatial_scenes(), 0.05..0.95_f64);
    let t = over(400, &cases, |(scene, cut), tally| legs_may_be_cut(&scene, cut, tally));
    println!("{t:?}");
    assert!(t.checked > 150 && t.events > 250, "{t:?}");
}
