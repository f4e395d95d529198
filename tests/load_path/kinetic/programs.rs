//! In programs of several legs to and fro, at every event and at the end, sticking contacts are within static friction and sliding contacts have
//! kinetic friction.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Leg, PathEnd};
use nalgebra::SVector;
use support::samples::{assert_met, samples, seeded};

use super::overdamped::scene;

#[derive(Debug, Default)]
struct Tally {
    completed: usize,
    lost: usize,
    undecided: usize,
    jumps: usize,
    slides: usize,
}

fn obeys<const C: usize>(state: &Equilibrium<C>, friction: &[[f64; 2]], tally: &mut Tally, context: &str) {
    assert!(state.residuals.worst() < 1e-9, "{context}: {:?}", state.residuals);
    let size = state.largest_force();
    for (contact, [rest, sliding]) in state.contacts.iter().zip(friction) {
        let (normal, tangential) = (contact.force[0], contact.force.rows(1, C - 1).norm());
        if matches!(contact.state, ContactState::Sliding { .. }) {
            assert!((tangential - sliding * normal).abs() < 1e-8 * size, "{context}: {contact:?}");
            tally.slides += 1;
        } else {
            assert!(tangential - rest * normal < 1e-8 * size, "{context}: {contact:?}");
        }
    }
}

fn programs<const D: usize, const C: usize>(count: usize, seed: u64) -> Tally {
    let mut random = seeded(seed);
    let mut tally = Tally::default();
    for number in 0..samples(count) {
        let (contacts, kinetic, base, _) = scene::<D, C>(&mut random);
        let friction: Vec<_> =
            contacts.iter().zip(&kinetic).map(|(datum, mu)| [datum.friction, *mu]).collect();
        let made = contacts.iter().zip(&kinetic).map(|(datum, mu)| datum.contact().kinetic(*mu));
        let grasp = Grasp::new(made).expect("a grasp");
        let load = |w: SVector<f64, D>| Wrench::<C>::from_components(w.as_slice());
        let size = 0.3 + random.uniform();
        let mut goal = || load(base + SVector::from_fn(|_, _| size * random.normal()));
        let legs: Vec<_> = (0..4).map(|_| Leg::load_to(goal())).chain([Leg::load_to(load(base))]).collect();
        let mut path = grasp.follow(load(base), &legs).expect("finite");
        let mut begun = true;
        for event in path.by_ref() {
            let context = format!("{number}: leg {} at {}", event.leg, event.fraction);
            // At the start of the path the contact states are those of the continuation, so a contact may already slide with static friction. This
            // event is not checked.
            if !begun {
                obeys(&event.state, &friction, &mut tally, &context);
            }
            begun = false;
            if let Some(jump) = &event.jump {
                assert!(jump.energy_lost > 0.0 && !jump.slips.is_empty(), "{context}: {jump:?}");
                obeys(&jump.state, &friction, &mut tally, &format!("{context}, jump"));
                tally.jumps += 1;
            }
        }
        for energy in path.energies() {
            assert!(energy.dissipated >= -1e-9 * energy.turnover, "{number}: {energy:?}");
            assert!(energy.residual().abs() < 1e-8, "{number}: {energy:?}");
        }
        match path.end() {
            Some(PathEnd::Completed) => {
                obeys(&path.state().expect("there"), &friction, &mut tally, &format!("{number}: end"));
                tally.completed += 1;
            }
            Some(PathEnd::Lost(_)) => tally.lost += 1,
            end => {
                println!("{number}: {end:?}");
                tally.undecided += 1;
            }
        }
    }
    println!("{tally:?}");
    tally
}

#[test]
fn in_the_plane() {
    let tally = programs::<3, 2>(150, 11);
    assert_met(&[(tally.completed, 37), (tally.jumps, 150)]);
    assert!(tally.undecided == 0, "{tally:?}");
}

#[test]
fn on_the_round_cone() {
    let tally = programs::<6, 3>(60, 12);
    assert_met(&[(tally.completed, 15), (tally.jumps, 60)]);
    assert!(tally.undecided <= samples(2), "{tally:?}");
}
