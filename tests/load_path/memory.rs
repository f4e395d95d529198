//! A path without sticking again ends at an equilibrium of the one-shot law, in which every slip is parallel to the friction force at the end. A path
//! without events can be reversed. Random paths in the plane confirm this.

use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Change, PathEnd};
use proptest::prelude::*;
use support::programs::draw::{over, planar_scenes};
use support::programs::same_state;
use support::samples::assert_met;

/// If nothing snaps over and no contact sticks again, closes or reverses, all slips are along the friction at the end. So the end is an equilibrium
/// of the one-shot law. If enumeration finds only one equilibrium of this law, the path ends there.
#[test]
fn without_sticking_the_path_ends_at_the_one_shot_equilibrium() {
    let t = over(600, &planar_scenes(), |scene, tally| {
        let grasp = scene.grasp();
        let asked = grasp.with(&support::programs::polygon());
        let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
        let events = path.run();
        tally.count(&events, &path);
        let monotone = |change: &Change<2>| matches!(change, Change::Slides { .. } | Change::Opens);
        if !matches!(path.end(), Some(PathEnd::Completed))
            || events.iter().any(|event| event.jump.is_some())
            || !events.iter().flat_map(|e| &e.changes).all(|change| monotone(&change.what))
        {
            return Ok(());
        }
        let end = scene.goals.last().unwrap();
        let there = scene.grasp().with_commands(end.commands.iter().copied()).unwrap();
        let list = there.equilibria(Wrench::from_components(end.load.as_slice())).unwrap();
        prop_assert!(!list.is_empty());
        if list.len() == 1 {
            same_state(&scene, &list[0], &path.state().unwrap(), 1e-9)?;
            tally.checked += usize::from(!events.is_empty());
        }
        Ok(())
    });
    println!("{t:?}");
    assert_met(&[(t.checked, 40)]);
}

/// If a program without events is reversed leg by leg, the reversed legs have no events either, and end at the start up to rounding.
#[test]
fn a_path_without_events_can_be_reversed() {
    let t = over(400, &planar_scenes(), |mut scene, tally| {
        let there = scene.goals.len();
        scene.goals.extend(scene.goals.clone().into_iter().rev().skip(1));
        let grasp = scene.grasp();
        let asked = grasp.with(&support::programs::polygon());
        let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
        let events = path.run();
        tally.count(&events, &path);
        let Some(start) = path.state_at(0, 0.0) else { return Ok(()) };
        let quiet = start.contacts.iter().all(|c| !matches!(c.state, ContactState::Sliding { .. }));
        let reached = path.place().0 + 2 > there || path.place() == (there - 2, 1.0);
        if quiet && reached && events.iter().all(|e| e.leg + 1 >= there) {
            prop_assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
            prop_assert!(events.is_empty(), "{:?}", events[0].changes);
            same_state(&scene, &start, &path.state().unwrap(), 1e-13)?;
            tally.checked += 1;
        }
        Ok(())
    });
    println!("{t:?}");
    assert_met(&[(t.checked, 20)]);
}
