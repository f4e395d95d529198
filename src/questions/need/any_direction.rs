//! The trial of an amount under a force of any direction. It has a closed form while everything sticks; otherwise many directions are tried one by
//! one.

use core::f64::consts::{PI, TAU};

use super::loading::Loading;
use super::question::Demand;
use super::trial::Trial;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Ramp;
use crate::numerics::{Space, dot, numbered};
use crate::prelude::*;
use crate::squeeze::WeakestDirection;

impl Loading {
    /// Whether everything sticks at rest, under `load` alone, and with a force of any direction added to `load`. `None` where something slides and
    /// the demand allows sliding.
    pub(super) fn any_force(
        &self,
        load: Wrench<3>,
        size: f64,
        point: [f64; 3],
        demand: Demand,
    ) -> Result<Option<Trial>, Error> {
        let base = &(self.base + load);
        let verdict = self.grasp.hold(Ramp::load(self.base, load))?;
        let at_rest = self.judged((&verdict, f64::INFINITY), Demand::Sticks);
        if !at_rest.does() {
            return Ok((demand == Demand::Sticks).then_some(match at_rest {
                Trial::DoesNot { says, carried, .. } => Trial::does_not(says, carried - 1.0),
                other => other,
            }));
        }
        Ok(Some(match self.grasp.weakest_direction(base, point)? {
            WeakestDirection::Never => Trial::always(),
            WeakestDirection::Force { size: most, .. } if most >= size => {
                Trial::carries(most / size)
            }
            WeakestDirection::Force { .. } if demand != Demand::Sticks => return Ok(None),
            WeakestDirection::Force { load, size: most, .. } => {
                let first = self.grasp.hold(Ramp::load(*base, load - *base))?;
                let who = first.first_slip.map_or_else(|| "it slides".to_owned(), |first| self.said(&first));
                Trial::does_not(format!("{who} under a force of one direction"), most / size)
            }
            WeakestDirection::GivesWay { .. } => Trial::nothing("nothing resists a force of one direction"),
            // A contact that is open before the force acts may be closed by the force. In that case no closed form compares directions.
            WeakestDirection::NotSticking => Trial::Unknown(
                "a contact is open or at its edge before the force acts, and directions are compared only where all of \
                 them press"
                    .to_owned(),
            ),
            WeakestDirection::Undecided => {
                Trial::Unknown("rounding keeps the weakest direction from being told".to_owned())
            }
        }))
    }

    /// Improves on `weakest`, the trial for the evenly spread direction that carries least of the load. From this `direction` the search moves to
    /// neighbours that carry less. Its step is halved where no neighbour carries less.
    pub(super) fn weakest_near(
        &self,
        mut direction: [f64; 3],
        along: &dyn Fn([f64; 3]) -> Ramp<3>,
        mut weakest: Trial,
    ) -> Result<Trial, Error> {
        let space = self.grasp.space();
        // The first step is half of the distance between evenly spread directions, rad. The carried parts of the load in directions within the last
        // step differ by less than 1e-6.
        let (mut step, last) = (if space == Space::Planar { 0.5 * TAU / 72.0 } else { 0.125 }, 1e-3);
        for _ in 0..50 {
            // If the weakest direction carries far more than the load, so do its neighbours, and the search ends.
            let Trial::Does { carried, .. } = weakest else { break };
            if step < last || carried > 1.1 {
                break;
            }
            let mut best = None;
            for across in tangents(direction, space) {
                for sign in [1.0, -1.0] {
                    let d = unit([0, 1, 2].map(|a| direction[a] + sign * step * across[a]));
                    let (verdict, path) = self.grasp.hold_to_an_extent(&along(d), self.extent)?;
                    let trial = self.judged((&verdict, 1.0 - path.farthest), Demand::Held);
                    if !trial.does() || trial.carried() < weakest.carried() {
                        (best, weakest) = (Some(d), weakest.or_worse(trial));
                    }
                }
            }
            match best {
                Some(better) => direction = better,
                None => step *= 0.5,
            }
        }
        Ok(weakest)
    }
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(&vector, &vector).sqrt();
    vector.map(|x| x / length)
}

/// Unit vectors at right angles to a direction: one in the plane, two in space.
fn tangents([x, y, z]: [f64; 3], space: Space) -> Vec<[f64; 3]> {
    if space == Space::Planar {
        return vec![[-y, x, 0.0]];
    }
    let first = unit(if x.abs() > y.abs() { [-z, 0.0, x] } else { [0.0, z, -y] });
    let [a, b, c] = first;
    vec![first, [y * c - z * b, z * a - x * c, x * b - y * a]]
}

/// Evenly spread unit vectors: on a circle, or on a golden spiral over the sphere.
pub(super) fn directions(space: Space) -> Vec<[f64; 3]> {
    // The load at a loss has no closed form in the direction. With fewer directions the weakest one could be missed.
    let count = if space == Space::Planar { 72 } else { 200 };
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let direction = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let (radius, angle, z) = match space {
            Space::Planar => (1.0, TAU / count as f64, 0.0),
            Space::Spatial => ((1.0 - z * z).sqrt(), golden, z),
        };
        let (sin, cos) = (angle * k as f64).sin_cos();
        [radius * cos, radius * sin, z]
    };
    numbered(count, &direction)
}
