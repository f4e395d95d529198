//! The condition of an answer against what really happens when the data change a little.

use grasp_lcp::equilibrium::Equilibrium;
use nalgebra::SVector;
use proptest::prelude::*;
use std::cell::Cell;
use support::random::{Spread, for_all, scene};
use support::scene::{Datum, Scene};

/// Every number of the data changes by at most this part of itself.
const PART: f64 = 1e-9;
/// Scenes like this one that are tried.
const TRIALS: usize = 12;

/// A fixed sequence of numbers in [-1, 1].
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vary<const N: usize>(&mut self, v: &SVector<f64, N>) -> SVector<f64, N> {
        v.map(|x| x * (1.0 + PART * self.next()))
    }
}

fn varied<const D: usize, const C: usize>(scene: &Scene<D, C>, noise: &mut Noise) -> Scene<D, C> {
    let contacts = scene.contacts.iter().map(|d| Datum {
        point: noise.vary(&d.point),
        normal: noise.vary(&d.normal),
        stiffness: noise.vary(&d.stiffness),
        friction: d.friction * (1.0 + PART * noise.next()),
        command: noise.vary(&d.command),
        ..*d
    });
    Scene { contacts: contacts.collect(), load: noise.vary(&scene.load) }
}

fn largest_change<const D: usize, const C: usize>(a: &Equilibrium<D, C>, b: &Equilibrium<D, C>) -> f64 {
    a.contacts.iter().zip(&b.contacts).map(|(a, b)| (a.force - b.force).norm()).fold(0.0, f64::max)
}

fn in_proportion<const D: usize, const C: usize>(count: std::ops::Range<usize>, spread: Spread) {
    let compared = Cell::new(0);
    for_all(file!(), 150, &scene::<D, C>(count, spread, 0.1), |scene| {
        let solve = |scene: &Scene<D, C>| scene.grasp().solve(&scene.wrench()).expect("a finite load");
        let outcome = solve(&scene);
        let Some(answer) = outcome.equilibrium() else { return Ok(()) };
        let sizes = answer.contacts.iter().map(|c| c.force.norm());
        let largest = sizes.fold(SVector::<f64, C>::from_fn(|a, _| scene.load[a]).norm(), f64::max);
        let grasp = scene.grasp();
        let condition = grasp.accuracy(answer).expect("not on a path").condition;
        let clearly = grasp.distinct(answer).expect("its own answer").into_iter().all(|distinct| distinct);
        if !clearly || condition * PART > 1e-4 || largest == 0.0 {
            return Ok(());
        }
        let mut noise = Noise(7);
        let mut most = 0.0_f64;
        for _ in 0..TRIALS {
            let outcome = solve(&varied(&scene, &mut noise));
            let Some(other) = outcome.equilibrium() else { return Ok(()) };
            let same = |(a, b): (&_, &_)| std::mem::discriminant(a) == std::mem::discriminant(b);
            let states = |e: &Equilibrium<D, C>| e.contacts.iter().map(|c| c.state).collect::<Vec<_>>();
            if !states(answer).iter().zip(&states(other)).all(same) {
                return Ok(());
            }
            most = most.max(largest_change(answer, other) / (PART * largest));
        }
        compared.set(compared.get() + 1);
        prop_assert!(most <= 10.0 * condition, "changes by {most}, condition {condition}");
        prop_assert!(condition <= 30.0 * most, "changes by {most}, condition {condition}");
        Ok(())
    });
    assert!(compared.get() > 60, "{}", compared.get());
}

#[test]
fn in_the_plane() {
    in_proportion::<3, 2>(2..6, Spread::Narrow);
    in_proportion::<3, 2>(2..6, Spread::Wide);
}

#[test]
fn in_space() {
    in_proportion::<6, 3>(3..6, Spread::Narrow);
    in_proportion::<6, 3>(3..6, Spread::Wide);
}
