//! A jump of slip ends in an equilibrium that enumeration of all contact states in exact rational arithmetic also finds.
//!
//! No other equilibrium has fewer sliding contacts. Jumps during which a contact opens are only counted, because the motion is then not straight. If
//! a jump has no end, no combination of contact states is an equilibrium, unless the library reports that an equilibrium exists elsewhere.

use grasp_lcp::planar::{Beyond, Change, ContactState, Grasp, Jump, Leg, PathEnd};
use num_traits::ToPrimitive;
use support::kinetic::{Catch, Datum, Scene, State};
use support::samples::{assert_met, samples, seeded};

const SCENES: usize = 250;

#[derive(Debug, Default)]
struct Tally {
    caught: usize,
    joined: usize,
    stuck_again: usize,
    opens: usize,
    lost: usize,
    at_the_edge: usize,
    elsewhere: usize,
}

impl Tally {
    fn caught(&mut self, jump: &Jump, catches: &[Catch]) {
        assert!(jump.energy_lost > 0.0, "{jump:?}");
        let changes = |so: fn(&Change) -> bool| jump.changes.iter().any(|change| so(&change.what));
        self.joined += usize::from(changes(|what| matches!(what, Change::Slides { .. })));
        if changes(|what| matches!(what, Change::Sticks)) {
            // If a contact has stuck again, its slip depends on the path, so the enumeration does not contain this state.
            self.stuck_again += 1;
            return;
        }
        self.caught += 1;
        let told = |i: usize| match jump.state.contacts[i].state {
            ContactState::Separated => State::Open,
            ContactState::Sliding { .. } if jump.state.contacts[i].force[1] > 0.0 => State::Forward,
            ContactState::Sliding { .. } => State::Backward,
            _ => State::Stuck,
        };
        let all = 0..jump.state.contacts.len();
        let is_it = |catch: &&Catch| {
            all.clone().all(|i| catch.states[i] == told(i)) && catch.off(&jump.state) < 1e-10
        };
        let at = catches.iter().find(is_it).unwrap_or_else(|| panic!("{jump:?}"));
        // If nothing opens, conditions that hold at both ends of the jump hold during the whole motion, because forces are affine and cones convex.
        let fewer = |catch: &&Catch| {
            all.clone().all(|i| !catch.slides(i) || at.slides(i))
                && all.clone().any(|i| at.slides(i) && !catch.slides(i))
        };
        if let Some(fewer) = catches.iter().find(fewer) {
            assert!(fewer.states.contains(&State::Open), "{jump:?}: {fewer:?}");
            self.opens += 1;
        }
    }
}

#[test]
fn jumps_end_where_rationals_say() {
    let mut random = seeded(0x6b69_6e65);
    let (mut tally, mut looked) = (Tally::default(), 0);
    let scenes = samples(SCENES);
    while looked < scenes {
        let scene = Scene::random(&mut random);
        let Some((part, first)) = scene.first_slip() else { continue };
        looked += 1;
        let grasp = Grasp::new(scene.contacts.iter().map(Datum::contact)).unwrap();
        // The load goes up to twice the load of first slip.
        let goal = scene.load(2.0 * part.to_f64().unwrap());
        let mut path = grasp.follow(scene.load(0.0), &[Leg::load_to(goal)]).unwrap();
        let catches = scene.catches(&part, first);
        if let Some(event) = path.next() {
            assert!((event.fraction - 0.5).abs() < 1e-12, "{looked}: {event:?}");
            assert!(matches!(event.changes[..], [ref change] if change.contact.index == first));
            tally.caught(&event.jump.expect("friction falls"), &catches);
            continue;
        }
        let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{looked}: {:?}", path.end()) };
        assert!((loss.fraction - 0.5).abs() < 1e-12);
        if loss.jumped.is_empty() {
            // No contact has jumped: even with static friction no continuation exists.
            tally.at_the_edge += 1;
        } else {
            match path.beyond() {
                Some(Beyond::LimitLoad) => {
                    tally.lost += 1;
                    assert!(catches.is_empty(), "{looked}: {catches:?}");
                }
                // Another equilibrium exists, but small quasi-static motions do not lead to it.
                Some(Beyond::Snap) => tally.elsewhere += 1,
                other => panic!("{looked}: {other:?}"),
            }
        }
    }
    println!("{tally:?}");
    assert_met(&[(tally.joined, 6), (tally.lost, 6)]);
    assert!(4 * tally.caught > 3 * scenes);
    assert!(50 * (tally.stuck_again + tally.opens) < scenes && 200 * tally.elsewhere < scenes);
}
