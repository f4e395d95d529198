//! Every equilibrium satisfies the conditions of the problem. If everything sticks, it is the minimum of energy.
//!
//! The conditions `0 <= g ⟂ F_n >= 0`, the friction law, the springs and the balance are recomputed here from the data of the scene
//! (`support::scene`), without the library's residuals. The scenes are random grasps in the plane and in space. Each contact has its own friction
//! (zero, tiny, ordinary, huge, infinite) and stiffnesses from 1 to 1e6. In symmetric grasps several contacts reach the edge of their cone at once.
//! Sticking grasps are compared with the linear least-squares problem that they solve (`support::sticking`).

use std::cell::{Cell, RefCell};
use std::f64::consts::PI;

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::{ContactState, Equilibrium, FoundBy, NoEquilibrium, Outcome, Proof};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{Spread, for_all, scene};
use support::samples::{assert_met, samples};
use support::scene::{Datum, Scene};
use support::sticking;

/// Tolerance of the conditions, relative to the sizes of the scene.
const LAW: f64 = 1e-10;
const FACETS: usize = 8;

/// Counts of outcomes.
#[derive(Debug, Clone, Default)]
struct Tally {
    equilibria: usize,
    everything_sticks: usize,
    sliding: usize,
    separated: usize,
    /// Equilibria with a sticking contact on the edge of its cone, or with a sliding contact without slip or an open contact without gap.
    tied: usize,
    /// Equilibria with free motions.
    free: usize,
    several: usize,
    no_equilibrium: usize,
    undecided: usize,
    worst: f64,
}

impl Tally {
    fn count<const C: usize>(&mut self, e: &Equilibrium<C>) {
        let size = e.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
        let any = |what: &dyn Fn(usize) -> bool| usize::from((0..e.contacts.len()).any(what));
        self.equilibria += 1;
        self.everything_sticks += usize::from(e.rule == FoundBy::EverythingSticks);
        self.sliding += any(&|i| matches!(e.contacts[i].state, ContactState::Sliding { .. }));
        self.separated += any(&|i| e.contacts[i].state == ContactState::Separated);
        self.tied += any(&|i| {
            let c = &e.contacts[i];
            let still = c.gap.max(c.slip.norm()) <= 1e-12 * c.body_core.norm();
            if c.state == ContactState::Sticking { c.margin.abs() <= 1e-12 * size } else { still }
        });
        self.free += usize::from(!e.free_motions.is_empty());
    }

    fn assert_at_least(&self, counts: &[(&str, usize, usize)]) {
        println!("{self:?}");
        for &(what, count, least) in counts {
            let least = samples(least);
            assert!(count >= least, "{what} {count} {least}");
        }
    }
}

/// Solves a scene and checks the answer; with `list`, checks all equilibria.
fn check<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    list: bool,
    tally: &RefCell<Tally>,
) -> Result<(), TestCaseError> {
    let mut tally = tally.borrow_mut();
    let grasp = scene.grasp();
    let mut found = Vec::new();
    match grasp.solve(scene.wrench()).expect("a finite load") {
        Outcome::Equilibrium(e) => {
            tally.count(&e);
            found.push(*e);
        }
        Outcome::NoEquilibrium(_) => tally.no_equilibrium += 1,
        _ => tally.undecided += 1,
    }
    if list {
        let all = grasp.equilibria(scene.wrench()).expect("few contacts");
        prop_assert!(all.is_empty() == found.is_empty(), "{found:?} {all:?}");
        tally.several += usize::from(all.len() > 1);
        found.extend(all);
    }
    for e in &found {
        let violation = scene.violation(e, FACETS);
        prop_assert!(violation <= LAW, "{violation:e} in {e:?}");
        tally.worst = tally.worst.max(violation);
    }
    Ok(())
}

/// Four contacts at the ends of a cross in mirror-image pairs, with data from a coarse grid.
fn symmetric() -> impl Strategy<Value = Scene<3, 2>> {
    let pair = (1..5_i32, 1..3_i32, 1..3_i32, 0..5_i32, 0..4_i32, -2..3_i32);
    (pair.clone(), pair, -4..5_i32).prop_map(|(across, upright, load)| {
        let mut contacts = Vec::new();
        for ((at, kn, kt, mu, push, drag), axis) in [(across, [1.0, 0.0]), (upright, [0.0, 1.0])] {
            for side in [1.0, -1.0] {
                let [x, y] = axis;
                contacts.push(Datum {
                    point: SVector::from([side * x, side * y]) * f64::from(at) * 0.5,
                    normal: SVector::from([-side * x, -side * y]),
                    tangent: SVector::zeros(),
                    stiffness: SVector::from([f64::from(kn), f64::from(kt)]),
                    friction: f64::from(mu) * 0.25,
                    // Both sides of a pair are dragged in the same spatial direction.
                    command: SVector::from([f64::from(push) * 0.25, side * f64::from(drag) * 0.125]),
                    clearance: 0.0,
                });
            }
        }
        Scene { contacts, load: SVector::from([0.0, f64::from(load) * 0.125, 0.0]) }
    })
}

/// Everything sticks: the forces solve the linear least-squares problem, and the energy is its minimum.
fn check_minimum<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    sticking_scenes: &Cell<usize>,
) -> Result<(), TestCaseError> {
    // Only the first solution method is tested here, so the long enumeration is switched off.
    let settings = Settings::default().with_most_states(0);
    let outcome = scene.grasp().with(&settings).solve(scene.wrench()).expect("a finite load");
    let expected = sticking::forces(scene);
    if let (Outcome::NoEquilibrium(NoEquilibrium { proof: Proof::FreeMotion { .. }, .. }), None) =
        (&outcome, &expected)
    {
        return Ok(());
    }
    let expected = expected.unwrap();
    // A scale for forces that cancel: the softest stiffness times the largest command.
    let softest = scene.contacts.iter().map(Datum::softest).fold(f64::INFINITY, f64::min);
    let command =
        scene.contacts.iter().map(|datum| datum.command.norm() + datum.clearance).fold(0.0, f64::max);
    let size = expected.iter().map(SVector::norm).fold(softest * command, f64::max);
    // The polygon in space lies between the round cone and a round cone narrower by cos(π/m); in the plane there is one cone.
    let narrower = if C == 2 { 1.0 } else { (PI / FACETS as f64).cos() };
    let slack = |part: f64| {
        let of = |(datum, f): (&Datum<C>, &SVector<f64, C>)| {
            let friction = f.rows_range(1..).norm();
            let bounded = datum.friction > 0.0 && datum.friction.is_finite();
            if bounded {
                f[0].min((part * datum.friction * f[0] - friction) / (1.0 + datum.friction))
            } else {
                f[0]
            }
        };
        scene.contacts.iter().zip(&expected).map(of).fold(f64::INFINITY, f64::min)
    };
    let e = outcome.equilibrium();
    if slack(1.0) < -1e-9 * size {
        prop_assert!(e.is_none_or(|e| e.rule != FoundBy::EverythingSticks));
    }
    if slack(narrower) < 1e-9 * size {
        return Ok(());
    }
    prop_assert!(e.is_some(), "{outcome:?}");
    let e = e.expect("just checked");
    prop_assert_eq!(e.rule, FoundBy::EverythingSticks);
    sticking_scenes.set(sticking_scenes.get() + 1);
    let mut energy = 0.0;
    for ((c, f), datum) in e.contacts.iter().zip(&expected).zip(&scene.contacts) {
        prop_assert!((c.force - f).norm() <= 1e-10 * size, "{} instead of {f}", c.force);
        energy += (0..datum.axes()).map(|a| 0.5 * f[a] * f[a] / datum.stiffness[a]).sum::<f64>();
    }
    prop_assert!((e.stored_energy - energy).abs() <= 1e-9 * energy);
    Ok(())
}

#[test]
fn the_law_holds_in_the_plane() {
    let tally = RefCell::default();
    for_all(file!(), 1000, &scene::<3, 2>(2..5, Spread::Wide, 0.2), |scene| check(&scene, true, &tally));
    let t = tally.into_inner();
    t.assert_at_least(&[("sliding", t.sliding, 375), ("separated", t.separated, 175)]);
    t.assert_at_least(&[("sticking", t.everything_sticks, 125), ("several equilibria", t.several, 125)]);
    t.assert_at_least(&[("no equilibrium", t.no_equilibrium, 7), ("free motions", t.free, 12)]);
    assert_eq!(t.undecided, 0);
}

#[test]
fn the_law_holds_where_everything_is_symmetric() {
    let tally = RefCell::default();
    for_all(file!(), 1000, &symmetric(), |scene| check(&scene, true, &tally));
    let t = tally.into_inner();
    t.assert_at_least(&[("sliding", t.sliding, 200), ("separated", t.separated, 200)]);
    t.assert_at_least(&[("sticking", t.everything_sticks, 250), ("several equilibria", t.several, 37)]);
    t.assert_at_least(&[("ties", t.tied, 62), ("free motions", t.free, 25)]);
    assert_eq!(t.undecided, 0);
}

#[test]
fn the_law_holds_with_more_contacts_than_can_be_listed() {
    const CASES: usize = 250;
    let tally = RefCell::default();
    for_all(file!(), CASES, &scene::<3, 2>(8..30, Spread::Wide, 0.2), |scene| check(&scene, false, &tally));
    let t = tally.into_inner();
    t.assert_at_least(&[("sliding", t.sliding, 150), ("separated", t.separated, 150)]);
    assert!(20 * t.undecided <= samples(CASES), "{} undecided", t.undecided);
}

#[test]
fn the_law_holds_in_space() {
    const CASES: usize = 625;
    let tally = RefCell::default();
    for_all(file!(), CASES, &scene::<6, 3>(2..6, Spread::Wide, 0.2), |scene| check(&scene, false, &tally));
    let t = tally.into_inner();
    t.assert_at_least(&[("sliding", t.sliding, 200), ("separated", t.separated, 100)]);
    t.assert_at_least(&[("sticking", t.everything_sticks, 50), ("free motions", t.free, 50)]);
    assert!(20 * t.undecided <= samples(CASES), "{} undecided", t.undecided);
}

#[test]
fn sticking_is_the_minimum_of_energy_in_the_plane() {
    let sticking = Cell::new(0);
    for_all(file!(), 750, &scene::<3, 2>(2..6, Spread::Wide, 0.03), |scene| check_minimum(&scene, &sticking));
    assert_met(&[(sticking.get(), 75)]);
}

#[test]
fn sticking_is_the_minimum_of_energy_in_space() {
    let sticking = Cell::new(0);
    for_all(file!(), 750, &scene::<6, 3>(2..6, Spread::Wide, 0.03), |scene| check_minimum(&scene, &sticking));
    assert_met(&[(sticking.get(), 75)]);
}
