//! Which of several equilibria is answered: the one that the sticking state becomes as friction falls to its value.
//!
//! Coulomb's law may admit several equilibria of one load, and Newton's method from far away ends in any of them: nearly equal scenes then have
//! unlike answers. With enough friction everything sticks, and that state is unique. As all coefficients fall together, in small steps, the state
//! moves continuously, unless it ceases to exist.

use super::elastic_trial::ElasticTrial;
use crate::contact::tangential_norm;
use crate::contact::Coulomb;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, mapped};
use crate::object::newton_on_cones;
use crate::prelude::*;

/// The twist to which the elastic trial moves as friction falls; `None` where that state ceases to exist on the way.
pub(super) fn twist_as_friction_falls(scene: &ElasticTrial<'_, '_>) -> Option<Vector> {
    let problem = scene.problem;
    let cones: Vec<Coulomb> = problem.locals().map(|local| local.cone()).collect();
    // With this factor on friction all contacts that press stick.
    let needed = |(cone, force): (&Coulomb, &nalgebra::SVector<f64, 3>)| {
        let limit = cone.limit(force[0]);
        if limit > 0.0 && cone.has_edges() { tangential_norm(force) / limit } else { 1.0 }
    };
    let rough = cones.iter().zip(&scene.state.forces).map(needed).fold(1.0, f64::max);
    let mut falling = problem.clone();
    let mut contacts = Vec::new();
    let mut at = |factor: f64, twist: &Vector, settled: f64| {
        falling.cones = mapped(&cones, &|cone| cone.times(factor));
        newton_on_cones(&falling, (twist.clone(), settled), &mut contacts)
    };
    let mut far = rough.min(MOST_FRICTION).ln();
    let began = at(far.exp(), &scene.state.twist, NEGLIGIBLE);
    if std::env::var("ZZ").is_ok() && began.is_none() { eprintln!("no start {rough} {:?}", scene.state.forces) }
    let (mut twist, ..) = began?;
    let mut step = far / 4.0;
    while far > 0.0 {
        let next = if far - step < 1e-9 { 0.0 } else { far - step };
        match at(next.exp(), &twist, NEGLIGIBLE) {
            Some((there, steps, _)) if steps <= 3 => {
                (twist, far) = (there, next);
                if steps <= 2 {
                    step *= 2.0;
                }
            }
            _ => step *= 0.5,
        }
        if step < 1e-4 {
            let next = (far - 1e-3).max(0.0);
            let jumped = at(next.exp(), &twist, NEGLIGIBLE);
            if std::env::var("ZZ").is_ok() { eprintln!("fold at {} of {} {:?}", far.exp(), rough, jumped.as_ref().map(|j| (j.1, (&j.0 - &twist).norm() / twist.norm()))) }
            let (there, ..) = jumped?;
            (twist, far) = (there, next);
            step = 0.05;
        }
    }
    Some(twist)
}

/// Friction beyond which a larger coefficient changes nothing.
const MOST_FRICTION: f64 = 1e3;
