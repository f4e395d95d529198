//! The work of following a path on lists of contact states: an event concerns one contact, and only those contacts are looked at that can have come
//! to an edge. Counted, not timed. Residuals stay what they are for a few contacts.

use grasp_lcp::planar::{Contact, Grasp, Leg, PathEnd, Wrench};
use grasp_lcp::spatial;
use support::patches::uneven;

/// A pad pressed unevenly, sheared and tilted, let go and sheared the other way: events, contacts looked at, residual.
fn planar(n: usize) -> (usize, usize, f64) {
    let press = |i: usize| {
        let x = (2 * i + 1) as f64 / n as f64 - 1.0;
        (x, (1.0 - x * x).sqrt() * (0.9 + 0.2 * uneven(i)))
    };
    let contact = |i: usize| {
        let (x, press) = press(i);
        Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1.0 + uneven(3 * i), 0.8)
            .friction(0.3 + 0.1 * uneven(7 * i))
            .command([press, 0.0])
    };
    let grasp = Grasp::new((0..n).map(contact)).unwrap();
    let pressed: f64 = (0..n).map(|i| press(i).1 * (1.0 + uneven(3 * i))).sum();
    let load = |shear: f64, tilt: f64| Wrench::new([shear * 0.3 * pressed, -pressed], tilt * pressed);
    let legs = [load(0.9, 0.2), load(0.0, 0.0), load(-0.8, -0.1)].map(Leg::load_to);
    let mut path = grasp.follow_patch(&load(0.0, 0.0), &legs).unwrap();
    let events = path.by_ref().count();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    (events, path.contacts_looked_at(), path.state().unwrap().residuals.worst())
}

#[test]
fn the_work_grows_about_like_the_number_of_events() {
    let sizes = [1000, 10_000].map(planar);
    for (n, (events, looked, residual)) in [1000, 10_000].into_iter().zip(sizes) {
        println!("{n} contacts: {events} events, {looked} looked at, residual {residual:e}");
        assert!(events > n && residual <= 1e-10);
        // If every event asked every contact this would be n.
        assert!(looked < 60 * events, "{looked} for {events} events");
    }
    let growth = (sizes[1].1 as f64 / sizes[0].1 as f64).log10();
    assert!(growth < 1.2, "n^{growth:.2}");
}

#[test]
fn the_same_in_space() {
    let (grasp, pressed) = support::patches::round_pad(1000).unwrap();
    let load = |x: f64, y: f64, turn: f64| {
        spatial::Wrench::new([x * pressed, y * pressed, -pressed], [0.0, 0.0, turn * pressed])
    };
    let legs = [load(0.23, 0.07, 0.03), load(0.0, 0.2, 0.0), load(0.0, 0.0, 0.0)].map(spatial::Leg::load_to);
    let mut path = grasp.follow_patch(&load(0.0, 0.0, 0.0), &legs).unwrap();
    let events = path.by_ref().count();
    assert!(matches!(path.end(), Some(spatial::PathEnd::Completed)), "{:?}", path.end());
    let (looked, residual) = (path.contacts_looked_at(), path.state().unwrap().residuals.worst());
    println!("{events} events, {looked} looked at, residual {residual:e}");
    assert!(events > 1500 && looked < 60 * events && residual <= 1e-10);
}
