//! The reported condition of an answer agrees with its actual change under small changes of the data.

use grasp_lcp::equilibrium::Equilibrium;
use nalgebra::SVector;
use proptest::prelude::*;
use std::cell::Cell;
use support::random::{Spread, for_all, scene};
use support::samples::{assert_met, seeded};
use support::scene::{Datum, Scene};
use support::splitmix::Random;

/// Each number of the data is changed by up to this fraction.
const PART: f64 = 1e-9;
/// Number of changed copies of each scene.
const TRIALS: usize = 12;

fn vary<const N: usize>(v: &SVector<f64, N>, noise: &mut Random) -> SVector<f64, N> {
    v.map(|x| x * (1.0 + PART * noise.signed()))
}

fn varied<const D: usize, const C: usize>(scene: &Scene<D, C>, noise: &mut Random) -> Scene<D, C> {
    let contacts = scene.contacts.iter().map(|d| Datum {
        point: vary(&d.point, noise),
        normal: vary(&d.normal, noise),
        stiffness: vary(&d.stiffness, noise),
        friction: d.friction * (1.0 + PART * noise.signed()),
        command: vary(&d.command, noise),
        ..*d
    });
    Scene { contacts: contacts.collect(), load: vary(&scene.load, noise) }
}

fn largest_change<const C: usize>(a: &Equilibrium<C>, b: &Equilibrium<C>) -> f64 {
    a.contacts.iter().zip(&b.contacts).map(|(a, b)| (a.force - b.force).norm()).fold(0.0, f64::max)
}

fn in_proportion<const D: usize, const C: usize>(count: std::ops::Range<usize>, spread: Spread) {
    let compared = Cell::new(0);
    for_all(file!(), 75, &scene::<D, C>(count, spread, 0.1), |scene| {
        let solve = |scene: &Scene<D, C>| scene.grasp().solve(scene.wrench()).expect("a finite load");
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
        let mut noise = seeded(7);
        let mut most = 0.0_f64;
        for _ in 0..TRIALS {
            let outcome = solve(&varied(&scene, &mut noise));
            let Some(other) = outcome.equilibrium() else { return Ok(()) };
            let same = |(a, b): (&_, &_)| std::mem::discriminant(a) == std::mem::discriminant(b);
            let states = |e: &Equilibrium<C>| e.contacts.iter().map(|c| c.state).collect::<Vec<_>>();
            if !states(answer).iter().zip(&states(other)).all(same) {
                return Ok(());
            }
            most = most.max(largest_change(answer, other) / (PART * largest));
        }
        compared.set(compared.get() + 1);
        prop_assert!(most <= 10.0 * condition, "{most} {condition}");
        prop_assert!(condition <= 30.0 * most, "{most} {condition}");
        Ok(())
    });
    assert_met(&[(compared.get(), 30)]);
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
