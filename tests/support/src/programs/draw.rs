//! Reproducible random scenes and load programs.

use std::f64::consts::TAU;

use grasp_lcp::grasp::Hold;
use nalgebra::{SMatrix, SVector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestError};

use super::tally::Tally;
use super::{Goal, Scene, Spot, Swing};
use crate::samples::{config, runner};

/// Tests a property on random scenes and returns the counts. The scenes are the same in every run; `default` is their number unless more are
/// requested. A failing scene is shrunk before it is printed.
pub fn over<S: Strategy>(
    default: usize,
    scenes: &S,
    property: impl Fn(S::Value, &mut Tally) -> Result<(), TestCaseError>,
) -> Tally {
    let tally = std::cell::RefCell::new(Tally::default());
    let config = Config { max_shrink_iters: 30, ..config(default) };
    let result = runner(config).run(scenes, |scene| property(scene, &mut tally.borrow_mut()));
    match result {
        Ok(()) => tally.into_inner(),
        Err(TestError::Fail(why, scene)) => panic!("{why}\n{scene:?}"),
        Err(error) => panic!("{error}"),
    }
}

/// Random numbers of one contact: some from -1 to 1, one for its friction, and one for clearance and hold. [`scene`] interprets them.
type Draw = (Vec<f64>, u8, u8);

fn draws(contacts: std::ops::Range<usize>) -> impl Strategy<Value = (Vec<Draw>, Vec<Vec<f64>>)> {
    let contact = (vec(-1.0..1.0_f64, 9), 0..20_u8, 0..10_u8);
    contacts.prop_flat_map(move |n| {
        let leg = vec(-1.0..1.0_f64, 6 + 3 * n);
        (vec(contact.clone(), n), vec(leg, 2..6))
    })
}

/// Planar scenes of 2–5 contacts around an object with programs of 1–4 legs.
pub fn planar_scenes() -> impl Strategy<Value = Scene<3, 2>> {
    draws(2..6).prop_map(|(contacts, legs)| scene(&contacts, &legs))
}

/// Planar scenes of 2 or 3 contacts.
pub fn few_planar_contacts() -> impl Strategy<Value = Scene<3, 2>> {
    draws(2..4).prop_map(|(contacts, legs)| scene(&contacts, &legs))
}

/// Scenes in space of 3–5 contacts.
pub fn spatial_scenes() -> impl Strategy<Value = Scene<6, 3>> {
    draws(3..6).prop_map(|(contacts, legs)| scene(&contacts, &legs))
}

/// The scenes with loads that turn along most legs, by up to `most` radians.
pub fn turning<const D: usize, const C: usize>(
    scenes: impl Strategy<Value = Scene<D, C>>,
    most: f64,
) -> impl Strategy<Value = Scene<D, C>> {
    let leg = vec(-1.0..1.0_f64, 2 * D + 1);
    (scenes, vec(leg, 5)).prop_map(move |(mut scene, legs)| {
        for (j, x) in (1..scene.goals.len()).zip(&legs) {
            let (before, goal) = (scene.goals[j - 1].clone(), &mut scene.goals[j]);
            let part =
                |from: usize| SVector::from_fn(|a, _| 1.3 * x[from + a] * if a < C { 1.0 } else { 0.6 });
            let swing = Swing { cosine: part(0), sine: part(D), angle: most * (0.51 + 0.49 * x[2 * D]) };
            if x[0].abs() < 0.8 {
                goal.load = before.load + swing.at(1.0);
                (goal.commands, goal.turn) = (before.commands, Some(swing));
            }
        }
        scene
    })
}

/// A scene of contacts around an object, with normals roughly inwards. Stiffnesses span four decades. Friction is zero, small, moderate,
/// large or infinite. Some contacts have clearance, are kept closed or bonded. Forces at rest and loads are about 1 N. Commands squeeze and release.
fn scene<const D: usize, const C: usize>(contacts: &[Draw], legs: &[Vec<f64>]) -> Scene<D, C> {
    let n = contacts.len();
    let mut press = Vec::new();
    let spots = contacts
        .iter()
        .enumerate()
        .map(|(i, (x, friction, loose))| {
            let angle = TAU * (i as f64 + 0.35 * x[0]) / n as f64;
            let out = SVector::<f64, C>::from_fn(|a, _| [angle.cos(), angle.sin(), 0.6 * x[1]][a]);
            let tilt = SVector::<f64, C>::from_fn(|a, _| [0.35 * x[2], 0.35 * x[3], 0.35 * x[4]][a]);
            let normal = (tilt - out).normalize();
            let k = 30.0 * 10.0_f64.powf(2.0 * x[5]);
            let mut stiffness = SVector::repeat(k * (0.6 + 0.35 * x[6]));
            stiffness[0] = k;
            // Pressed with 0.2 to 2 N.
            press.push((1.1 + 0.9 * x[7]) / k);
            Spot {
                point: out * (1.0 + 0.2 * x[8]),
                frame: frame(&normal),
                k: stiffness,
                mu: match friction {
                    0..2 => 0.0,
                    2..7 => 0.03 + 0.02 * f64::from(*friction),
                    7..14 => 0.1 * f64::from(friction - 4),
                    14..18 => f64::from(friction - 12) * 0.5,
                    _ => f64::INFINITY,
                },
                clearance: if *loose < 2 { 0.6 * press[i] } else { 0.0 },
                hold: match loose {
                    8 => Hold::KeptClosed,
                    9 if x[0] > 0.0 => Hold::Bonded,
                    _ => Hold::Unilateral,
                },
            }
        })
        .collect();
    let mut goals = Vec::new();
    for (j, x) in legs.iter().enumerate() {
        let most = if j == 0 { 0.2 } else { 1.5 };
        let commands = (0..n).map(|i| {
            let sway = if j == 0 { 0.0 } else { 0.7 };
            let mut a = SVector::from_fn(|axis, _| sway * press[i] * x[6 + 3 * i + axis]);
            a[0] += press[i];
            a
        });
        let load = SVector::from_fn(|a, _| most * x[a] * if a < C { 1.0 } else { 0.6 });
        let goal = Goal { load, commands: commands.collect(), turn: None };
        // The random number |x[5]| decides whether a leg changes only the load (probability 0.3), only commands (0.2), returns to the start (0.2), or
        // changes both.
        goals.push(match (j, x[5].abs()) {
            (1.., ..0.3) => Goal {
                commands: goals.last().map_or(goal.commands, |g: &Goal<D, C>| g.commands.clone()),
                ..goal
            },
            (1.., 0.3..0.5) => Goal { load: goals.last().map_or(goal.load, |g: &Goal<D, C>| g.load), ..goal },
            (1.., 0.5..0.7) => goals[0].clone(),
            _ => goal,
        });
    }
    Scene { spots, goals }
}

/// A right-handed contact frame on a normal; in the plane t = (n_y, -n_x).
fn frame<const C: usize>(n: &SVector<f64, C>) -> SMatrix<f64, C, C> {
    let mut frame = SMatrix::<f64, C, C>::zeros();
    frame.set_column(0, n);
    if C == 2 {
        frame[(0, 1)] = n[1];
        frame[(1, 1)] = -n[0];
        return frame;
    }
    let mut axis = SVector::<f64, C>::zeros();
    axis[n.iamin()] = 1.0;
    let t = (axis - n * n.dot(&axis)).normalize();
    frame.set_column(1, &t);
    for a in 0..C {
        let (b, c) = ((a + 1) % C, (a + 2) % C);
        frame[(a, 2)] = n[b] * t[c] - n[c] * t[b];
    }
    frame
}
