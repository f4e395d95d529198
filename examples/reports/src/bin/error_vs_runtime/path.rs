//! A load path: by exact events, and by implicit steps.
//!
//! An implicit step solves for the equilibrium at its end. Before each step the accumulated slip is subtracted from the finger commands. Afterwards
//! the slip of the answer is added to the accumulated slip.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Change, Leg};
use grasp_lcp::{planar, spatial};
use nalgebra::SVector;

use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;
use support::tractrix;

const STEPS: [u32; 4] = [10, 100, 1000, 10_000];

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    report.push(pad()?);
    report.push(dragged()?);
    Ok(())
}

/// A grasp that is followed in implicit steps, with the accumulated slip of each contact.
struct Stepper<const C: usize> {
    grasp: Grasp<C>,
    slips: Vec<SVector<f64, C>>,
}

/// Contact forces after a step, and the contacts that have slipped in it.
struct Step<const C: usize> {
    forces: Vec<SVector<f64, C>>,
    slipped: Vec<bool>,
}

impl<const C: usize> Stepper<C> {
    fn new(grasp: &Grasp<C>) -> Self {
        Self { grasp: grasp.clone(), slips: vec![SVector::zeros(); grasp.len()] }
    }

    /// Makes one step to another load and other commands.
    fn step(&mut self, load: &Wrench<C>, commands: &[SVector<f64, C>]) -> Result<Step<C>, Failure> {
        let left: Vec<_> = commands.iter().zip(&self.slips).map(|(a, s)| a - s).collect();
        self.grasp = self.grasp.clone().with_commands(left)?;
        let outcome = self.grasp.solve(load)?;
        let state = outcome.equilibrium().ok_or("the path goes on")?;
        for (slip, contact) in self.slips.iter_mut().zip(&state.contacts) {
            *slip += contact.slip;
        }
        Ok(Step {
            forces: state.contacts.iter().map(|c| c.force).collect(),
            slipped: state.contacts.iter().map(|c| c.slip.norm() > 0.0).collect(),
        })
    }
}

const SPRINGS: u32 = 16;
const FRICTION: f64 = 0.4;
/// Tangential stiffness of each spring, N/m.
const SHEAR: f64 = 6.25;

/// Normal force of each spring of the pad, N: a parabola.
fn pressed() -> Vec<f64> {
    let at = |i: u32| f64::from(2 * i + 1) / f64::from(SPRINGS) - 1.0;
    (0..SPRINGS).map(|i| 0.375 * (1.0 - at(i).powi(2))).collect()
}

/// The shear load, N, at which the pad is displaced by x, m, when it is sheared for the first time.
fn virgin(x: f64) -> f64 {
    pressed().iter().map(|n| (SHEAR * x).min(FRICTION * n)).sum()
}

/// A pad is sheared to nine tenths of its limit, and then as far in the other direction. Friction acts along the face, so that normal forces N_i are
/// constant: with the tangential stiffness c, spring i slides from the displacement x = μ N_i/c on. On the way back it slides after twice this
/// displacement (Masing's rule).
fn pad() -> Result<Panel, Failure> {
    let pressures = pressed();
    let (total, c) = (pressures.iter().sum::<f64>(), SHEAR);
    let limits: Vec<f64> = pressures.iter().map(|n| FRICTION * n).collect();
    let most = 0.9 * FRICTION * total;
    let exact: [Vec<Option<f64>>; 2] = [1.0, 2.0].map(|times| {
        let at = |limit: &f64| times * virgin(limit / c);
        limits.iter().map(|limit| Some(at(limit)).filter(|q| *q < times * most)).collect()
    });
    let grasp = Grasp::new((0..SPRINGS).zip(&pressures).map(|(i, n)| {
        let x = f64::from(2 * i + 1) / f64::from(SPRINGS) - 1.0;
        Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(70.0, c)
            .friction(FRICTION)
            .command([n / 70.0, 0.0])
    }))?;
    let load = |q: f64| planar::Wrench::force([q, -total]);
    let legs = [Leg::load_to(load(most)), Leg::load_to(load(-most))];
    // The largest error of a load at which a spring begins to slide, over the friction limit of the pad. Loads are measured from the start of their
    // leg. A missing event counts as an error of 1.
    let off = |found: &[Vec<Option<f64>>; 2]| {
        let pairs = found.iter().flatten().zip(exact.iter().flatten());
        let error = pairs.map(|pair| match pair {
            (Some(a), Some(b)) => (a - b).abs() / (FRICTION * total),
            (None, None) => 0.0,
            _ => 1.0,
        });
        error.fold(0.0, f64::max)
    };
    let mut panel = Panel::new(
        "path",
        "A pad of 16 springs sheared and back: when they slide",
        "error of the load at which a spring slides / limit load",
    );
    // The load at which each spring begins to slide, by leg and contact. The argument `slides` has the leg, the load and the contact of each event.
    let when = |slides: &[(usize, f64, usize)]| {
        let mut found = [(); 2].map(|()| vec![None; limits.len()]);
        for &(leg, q, contact) in slides {
            found[leg][contact] = Some(if leg == 0 { q } else { most - q });
        }
        found
    };
    let (slides, time) = timed(|| {
        let events = grasp.follow(load(0.0), &legs)?.run();
        let slides = events.iter().flat_map(|e| {
            let sliding = e.changes.iter().filter(|change| self::slides(&change.what));
            let contacts = sliding.map(|change| change.contact.index);
            contacts.map(|contact| (e.leg, e.load.to_vector()[0], contact))
        });
        Ok(slides.collect::<Vec<_>>())
    })?;
    panel.add("exact events, Grasp::follow", "", off(&when(&slides)), time);
    let commands: Vec<_> = grasp.contacts().iter().map(Contact::commanded).collect();
    for steps in STEPS {
        let (found, time) = timed(|| {
            let mut stepper = Stepper::new(&grasp);
            let mut found = [(); 2].map(|()| vec![None; limits.len()]);
            for (leg, way) in [most, -2.0 * most].into_iter().enumerate() {
                for k in 1..=steps {
                    let part = |k: u32| f64::from(k) / f64::from(steps);
                    let from = if leg == 0 { 0.0 } else { most };
                    let step = stepper.step(&load(from + way * part(k)), &commands)?;
                    for (event, _) in
                        found[leg].iter_mut().zip(&step.slipped).filter(|(_, slipped)| **slipped)
                    {
                        event.get_or_insert(way.abs() * 0.5 * (part(k - 1) + part(k)));
                    }
                }
            }
            Ok(found)
        })?;
        panel.add("implicit steps a leg", format!("{:.0e}", f64::from(steps)), off(&found), time);
    }
    Ok(panel)
}

fn slides<const C: usize>(change: &Change<C>) -> bool {
    matches!(change, Change::Slides { .. } | Change::Reverses { .. })
}

/// Measures the error of the friction force on a body that a finger drags along a tractrix.
fn dragged() -> Result<Panel, Failure> {
    const SAMPLES: u32 = 200;
    let (grasp, ways) = tractrix::scene()?;
    let legs = tractrix::legs(ways);
    let mut panel = Panel::new(
        "path",
        "A finger drags a body round a corner: its friction force",
        "worst error of the friction force / its size",
    );
    for tolerance in [1e-4, 1e-7, 1e-10, 1e-13] {
        let settings = Settings::default().with_step_error(tolerance);
        let grasp = grasp.with(&settings);
        let (path, time) = timed(|| {
            let mut path = grasp.follow(spatial::Wrench::ZERO, &legs)?;
            path.run();
            Ok(path)
        })?;
        let mut error = 0.0_f64;
        for k in 0..=SAMPLES {
            let fraction = f64::from(k) / f64::from(SAMPLES);
            let state = path.state_at(1, fraction).ok_or("the path goes on")?;
            error = error.max(tractrix::off(&state.contacts[0].force, tractrix::WAY * fraction));
        }
        panel.add("Grasp::follow, error of a step", format!("{tolerance:.0e}"), error, time);
    }
    let commands: Vec<_> = grasp.contacts().iter().map(spatial::Contact::commanded).collect();
    for steps in STEPS {
        let (forces, time) = timed(|| {
            let mut stepper = Stepper::new(&grasp);
            let at = |corner: f64, part: f64| {
                let [first, second] = ways;
                let more = tractrix::drag([0, 1].map(|a| corner * first[a] + part * second[a]));
                commands.iter().zip(more).map(|(a, b)| a + b).collect::<Vec<_>>()
            };
            stepper.step(&spatial::Wrench::ZERO, &at(1.0, 0.0))?;
            let mut forces = Vec::new();
            for k in 1..=steps {
                let part = f64::from(k) / f64::from(steps);
                let step = stepper.step(&spatial::Wrench::ZERO, &at(1.0, part))?;
                forces.push((part, step.forces[0]));
            }
            Ok(forces)
        })?;
        let errors = forces.iter().map(|(part, force)| tractrix::off(force, tractrix::WAY * part));
        panel.add("implicit steps", format!("{:.0e}", f64::from(steps)), errors.fold(0.0, f64::max), time);
    }
    Ok(panel)
}
