//! If the kinetic coefficient approaches the static coefficient, paths and events converge, in proportion, to the paths and events with one
//! coefficient.

use grasp_lcp::planar::{Change, Equilibrium, Event, Grasp, Leg, PathEnd, Ramp};
use support::kinetic::{Datum, Scene};
use support::samples::{assert_met, samples, seeded};

/// The changes of contacts, in order.
fn story(events: &[Event]) -> Vec<(usize, std::mem::Discriminant<Change>)> {
    events
        .iter()
        .flat_map(|event| &event.changes)
        .map(|c| (c.contact.index, std::mem::discriminant(&c.what)))
        .collect()
}

fn apart(a: &Equilibrium, b: &Equilibrium) -> f64 {
    let both = a.contacts.iter().zip(&b.contacts);
    both.map(|(a, b)| (a.force - b.force).norm()).fold(0.0, f64::max) / a.largest_force()
}

/// A path with more events than this is not followed further.
const MOST: usize = 400;

/// Relative differences of static and kinetic friction.
const PARTS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// Means and maxima of differences between paths with two coefficients and with one, divided by the relative difference of the coefficients.
#[derive(Default)]
struct Apart {
    count: [usize; 5],
    sum: [f64; 5],
    most: [f64; 5],
}

impl Apart {
    fn add(&mut self, k: usize, off: f64) {
        self.count[k] += 1;
        self.sum[k] += off / PARTS[k];
        self.most[k] = self.most[k].max(off / PARTS[k]);
    }

    fn told(&self, what: &str) {
        let means: Vec<_> = self.sum.iter().zip(self.count).map(|(sum, count)| sum / count as f64).collect();
        println!(
            "{what} apart over 1 - μ_k/μ_s = {PARTS:?}: mean {means:?}, most {:?} of {:?}",
            self.most, self.count
        );
    }
}

#[test]
fn paths_converge_in_proportion() {
    let mut random = seeded(0x006f_6e65);
    let (mut events_apart, mut forces_apart, mut in_turn) =
        (Apart::default(), Apart::default(), Apart::default());
    let mut count = 0;
    while count < samples(75) {
        let scene = Scene::random(&mut random);
        let legs = [2.0, 0.0].map(|times| Leg::load_to(scene.load(times)));
        let followed = |kinetic: Option<f64>| {
            let contact = |datum: &Datum| {
                let contact = datum.plain();
                kinetic.map_or(contact.clone(), |part| contact.kinetic(datum.friction[0] * (1.0 - part)))
            };
            let grasp = Grasp::new(scene.contacts.iter().map(contact)).unwrap();
            let mut path = grasp.follow(scene.load(0.0), &legs).unwrap();
            let events: Vec<_> = path.by_ref().take(MOST).collect();
            (events, matches!(path.end(), Some(PathEnd::Completed)).then(|| path.state()).flatten())
        };
        let (plain, end) = followed(None);
        let Some(end) = end else { continue };
        if !plain.iter().any(|event| event.changes.iter().any(|c| matches!(c.what, Change::Slides { .. }))) {
            continue;
        }
        count += 1;
        let all = PARTS.map(|part| followed(Some(part)));
        // Contacts that slide together with one coefficient may stick and slip one after another with two coefficients, in more and smaller jumps.
        // Such paths are counted apart.
        let alike = all[2..].iter().all(|(events, _)| story(events) == story(&plain));
        for (k, (events, state)) in all.iter().enumerate() {
            let Some(state) = state else { continue };
            if !alike {
                in_turn.add(k, apart(&end, state));
            } else if story(events) == story(&plain) {
                let off = events.iter().zip(&plain).map(|(a, b)| (a.fraction - b.fraction).abs());
                events_apart.add(k, off.fold(0.0, f64::max));
                forces_apart.add(k, apart(&end, state));
            }
        }
    }
    events_apart.told("events");
    forces_apart.told("forces");
    in_turn.told("forces in turn");
    for apart in [&events_apart, &forces_apart] {
        // First-order convergence: if the coefficients differ by a hundredth as much, so do the paths. Differences divided by the difference of the
        // coefficients stay the same.
        assert!(apart.most[4] < 2.0 * apart.most[2] && apart.most[4] > 0.5 * apart.most[2]);
        assert_met(&[(apart.count[4], 37)]);
    }
    assert!(in_turn.most[..3].iter().all(|most| *most < 10.0));
}

/// If the kinetic coefficient equals the static one, no bit of the answers changes.
#[test]
fn friction_of_rest_given_twice_is_given_once() {
    let mut random = seeded(0x6269_7473);
    for _ in 0..samples(100) {
        let scene = Scene::random(&mut random);
        let [once, twice] = [false, true].map(|twice| {
            let contact = |datum: &Datum| {
                let contact = datum.plain();
                if twice { contact.kinetic(datum.friction[0]) } else { contact }
            };
            let grasp = Grasp::new(scene.contacts.iter().map(contact)).unwrap();
            let mut path = grasp.follow(scene.load(0.0), &[Leg::load_to(scene.load(1.0))]).unwrap();
            let events = path.run();
            (events, path.place(), path.forces())
        });
        assert!(once == twice);
    }
}

/// The first slip does not depend on the kinetic coefficient, to the last bit.
#[test]
fn the_first_slip_is_a_matter_of_rest() {
    let mut random = seeded(0x6f6e_7365);
    let mut slides = 0;
    for _ in 0..samples(100) {
        let scene = Scene::random(&mut random);
        let [plain, falling] = [Datum::plain, Datum::contact].map(|contact| {
            let grasp = Grasp::new(scene.contacts.iter().map(contact)).unwrap();
            let onset = grasp.onset(Ramp::load(scene.load(0.0), scene.load(1.0) - scene.load(0.0))).unwrap();
            (onset.factor().map(f64::to_bits), onset.to_string())
        });
        slides += usize::from(plain.0.is_some());
        assert_eq!(plain, falling);
    }
    assert_met(&[(slides, 50)]);
}
