//! Derivatives of equilibria and of factors of first slip agree with central differences of the solver. Steps of 1e-5 have an error of about 1e-10.
//! The check is independent, because the library computes derivatives by one linear solve for the contact states at the answer.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Onset, Parameter, Ramp};
use grasp_lcp::planar;
use nalgebra::SVector;
use support::jaws::jaw;
use support::samples::{samples, seeded};
use support::splitmix::Random;

const TOLERANCE: f64 = 1e-7;

#[derive(Clone)]
struct Scene<const D: usize, const C: usize> {
    point: Vec<SVector<f64, C>>,
    normal: Vec<SVector<f64, C>>,
    stiffness: Vec<SVector<f64, C>>,
    friction: Vec<f64>,
    command: Vec<SVector<f64, C>>,
    load: SVector<f64, D>,
    direction: SVector<f64, D>,
}

impl<const D: usize, const C: usize> Scene<D, C> {
    fn random(dice: &mut Random, contacts: usize) -> Self {
        let mut vector = || SVector::<f64, C>::from_fn(|_, _| dice.signed());
        let directions: Vec<_> = (0..contacts).map(|_| vector().normalize()).collect();
        let normal = directions.iter().map(|d| -d + vector() * 0.3).collect();
        let stiffness = (0..contacts).map(|_| vector().map(|x| 10f64.powf(1.0 + 0.5 * x))).collect();
        let command = (0..contacts)
            .map(|_| {
                let mut a = vector() * 0.02;
                a[0] = 0.1;
                a
            })
            .collect();
        let mut wrench = |size: f64| SVector::<f64, D>::from_fn(|_, _| size * dice.signed());
        let (load, direction) = (wrench(0.3), wrench(0.5));
        let friction = (0..contacts).map(|_| 0.4 + 0.35 * dice.signed()).collect();
        Self { point: directions, normal, stiffness, friction, command, load, direction }
    }

    fn grasp(&self) -> Grasp<C> {
        Grasp::new((0..self.point.len()).map(|i| {
            Contact::new(self.point[i], self.normal[i])
                .series_stiffness_axes(self.stiffness[i])
                .friction(self.friction[i])
                .command(self.command[i])
        }))
        .unwrap()
    }

    fn solve(&self) -> Option<Equilibrium<C>> {
        let outcome = self.grasp().solve(Wrench::from_components(self.load.as_slice())).unwrap();
        outcome.equilibrium().cloned()
    }

    fn onset(&self) -> Option<(f64, Vec<usize>)> {
        let ramp = Ramp::load(
            Wrench::from_components(self.load.as_slice()),
            Wrench::from_components(self.direction.as_slice()),
        );
        let Onset::At(event) = self.grasp().onset(&ramp).unwrap() else { return None };
        Some((event.factor, event.leaving.iter().map(|l| l.contact.index).collect()))
    }

    fn moved(&self, by: Parameter, step: f64) -> Self {
        let mut scene = self.clone();
        match by {
            Parameter::Friction { contact } => scene.friction[contact] += step,
            Parameter::Stiffness { contact, axis } => scene.stiffness[contact][axis] += step,
            Parameter::Command { contact, axis } => scene.command[contact][axis] += step,
            Parameter::Load { component } => scene.load[component] += step,
            other => unreachable!("{other:?}"),
        }
        scene
    }

    fn parameters(&self) -> Vec<Parameter> {
        let contacts = 0..self.point.len();
        let mut list: Vec<_> = contacts.clone().map(|contact| Parameter::Friction { contact }).collect();
        for contact in contacts {
            list.extend((0..C).map(|axis| Parameter::Stiffness { contact, axis }));
            list.extend((0..C).map(|axis| Parameter::Command { contact, axis }));
        }
        list.extend((0..D).map(|component| Parameter::Load { component }));
        list
    }

    fn step(by: Parameter) -> f64 {
        if let Parameter::Stiffness { .. } = by { 1e-4 } else { 1e-6 }
    }
}

fn states<const C: usize>(e: &Equilibrium<C>) -> Vec<u8> {
    let word = |c: &grasp_lcp::equilibrium::ContactAnswer<C>| {
        use grasp_lcp::equilibrium::ContactState::{Frictionless, Separated, Sliding, Sticking};
        match c.state {
            Separated => 0,
            Sticking => 1,
            Sliding { .. } => 2,
            Frictionless => 3,
        }
    };
    e.contacts.iter().map(word).collect()
}

/// Compares derivatives of forces on random scenes with differences. Returns the number of comparisons in scenes with sliding contacts.
fn compare_equilibria<const D: usize, const C: usize>(seed: u64, scenes: usize, contacts: usize) -> usize {
    let (mut dice, mut sliding) = (seeded(seed), 0);
    for _ in 0..samples(scenes) {
        let scene = Scene::<D, C>::random(&mut dice, contacts);
        let Some(here) = scene.solve() else { continue };
        if !here.free_motions.is_empty() {
            continue;
        }
        let grasp = scene.grasp();
        for by in scene.parameters() {
            let step = Scene::<D, C>::step(by);
            let (Some(up), Some(down)) = (scene.moved(by, step).solve(), scene.moved(by, -step).solve())
            else {
                continue;
            };
            if states(&up) != states(&here) || states(&down) != states(&here) {
                continue;
            }
            let exact = grasp.sensitivity().of(&here, by).expect("a regular piece");
            let scale = |x: f64| TOLERANCE * (1.0 + x.abs());
            for (i, force) in exact.forces.iter().enumerate() {
                let difference = (up.contacts[i].force - down.contacts[i].force) / (2.0 * step);
                // If a force jumps within the step, the contact slides along another edge of the polygon, or another equilibrium is found. Such
                // differences are skipped.
                if (up.contacts[i].force - here.contacts[i].force).norm() > 1e-3 {
                    continue;
                }
                assert!((difference - force).norm() < scale(force.norm()), "{by:?} {i} {difference} {force}");
            }
            sliding += usize::from(states(&here).contains(&2));
        }
    }
    sliding
}

#[test]
fn equilibria_in_the_plane() {
    assert!(compare_equilibria::<3, 2>(1, 50, 4) > samples(100));
}

#[test]
fn equilibria_in_space() {
    assert!(compare_equilibria::<6, 3>(2, 20, 6) > samples(100));
}

fn compare_onsets<const D: usize, const C: usize>(seed: u64, scenes: usize, contacts: usize) -> usize {
    let (mut dice, mut compared) = (seeded(seed), 0);
    for _ in 0..samples(scenes) {
        let mut scene = Scene::<D, C>::random(&mut dice, contacts);
        scene.load *= 0.1;
        let Some((factor, leaving)) = scene.onset() else { continue };
        if factor == 0.0 {
            continue;
        }
        let grasp = scene.grasp();
        let ramp = Ramp::load(
            Wrench::from_components(scene.load.as_slice()),
            Wrench::from_components(scene.direction.as_slice()),
        );
        let onset = grasp.onset(&ramp).unwrap();
        let Some(margins) = grasp.sensitivity().onset(onset.event().unwrap()) else { continue };
        if margins.leavers().len() != 1 {
            continue;
        }
        for by in scene.parameters() {
            let step = 0.1 * Scene::<D, C>::step(by);
            let (Some(up), Some(down)) = (scene.moved(by, step).onset(), scene.moved(by, -step).onset())
            else {
                continue;
            };
            if up.1 != leaving || down.1 != leaving {
                continue;
            }
            let exact = margins.by(by).expect("a datum")[0];
            let difference = (up.0 - down.0) / (2.0 * step);
            assert!(
                (difference - exact).abs() < TOLERANCE * (1.0 + exact.abs()) * (1.0 + factor),
                "{by:?} {difference} {exact}"
            );
            compared += 1;
        }
    }
    compared
}

#[test]
fn onsets_in_the_plane() {
    assert!(compare_onsets::<3, 2>(3, 100, 3) > samples(120));
}

#[test]
fn onsets_on_the_round_cone() {
    assert!(compare_onsets::<6, 3>(4, 500, 4) > samples(120));
}

/// A symmetric pinch by hand: N = k a, so dN/da = k/2 for one command alone (the other spring is compressed as much), and the object moves by half the
/// command.
#[test]
fn position_control_of_a_pinch() {
    let (k, kt) = (30.0, 10.0);
    let grasp =
        planar::Grasp::new([-1.0, 1.0].map(|x| jaw::<2>(x, [k, kt], 0.5).command([0.1, 0.0]))).unwrap();
    let outcome = grasp.solve(planar::Wrench::ZERO).unwrap();
    let by = |contact: usize| {
        let command = Parameter::Command { contact, axis: 0 };
        grasp.sensitivity().of(outcome.equilibrium().unwrap(), command).unwrap()
    };
    for (finger, moves) in [(0, 0.5), (1, -0.5)] {
        let by = by(finger);
        assert!((by.twist.translation()[0] - moves).abs() < 1e-15);
        assert!(by.forces.iter().all(|force| (force[0] - k / 2.0).abs() < 1e-13));
    }
}
