//! The least force, of all directions, at which a contact slides.

use core::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::SVector;

use super::loads::check_point;
use super::sticking_response::{Push, StickingResponse, is_broken, push, round_parts, round_row};
use crate::contact::Edges;
use crate::error::Error;
use crate::grasp::{Engine, Motion, Wrench};
use crate::load_path::Leaver;
use crate::numerics::Turning;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Settings;

/// The answer to "a force of which direction slides first?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum WeakestDirection<const C: usize> {
    /// A force of this size in this direction makes a contact slide; no smaller force does in any direction.
    #[non_exhaustive]
    Force {
        /// Its size, N, exact up to rounding.
        size: f64,
        /// Unit direction, coordinate axes.
        direction: [f64; C],
        /// The base load with that force.
        load: Wrench<C>,
        /// The contact that stops sticking, or the drive of a hand that reaches its limit.
        leaver: Leaver,
    },
    /// All contacts keep sticking under a force of any size in any direction.
    Never,
    /// Some force works on this motion, which nothing resists.
    GivesWay {
        /// A unit motion of the object.
        motion: Motion<C>,
    },
    /// Under the base load a contact slides or is open, or no equilibrium exists.
    NotSticking,
    /// Rounding keeps the search from ending.
    Undecided,
}

impl Engine {
    /// [`Grasp::weakest_direction`](crate::ask::Grasp::weakest_direction).
    pub(crate) fn weakest_direction(
        &self,
        base: &Wrench<3>,
        point: impl Into<[f64; 3]>,
        settings: &Settings,
    ) -> Result<WeakestDirection<3>, Error> {
        let point = point.into();
        check_point(&point)?;
        let load = self.load_alone(base, "base load")?;
        let sticking = StickingResponse::new(self, settings);
        let Ok(forces) = sticking.forces(&self.drives(), &load) else {
            return Ok(WeakestDirection::NotSticking);
        };
        let sticks = |((edges, force), size): ((&Edges, &SVector<f64, 3>), &f64)| {
            edges.worst(force).is_none_or(|(row, value)| !is_broken(value, &row, *size))
        };
        if !sticking.edges.iter().zip(&forces.of).zip(&forces.sizes).all(sticks) {
            return Ok(WeakestDirection::NotSticking);
        }
        let pushes = match sticking.pushes(&point) {
            Ok(pushes) => pushes,
            Err(motion) => return Ok(WeakestDirection::GivesWay { motion }),
        };
        let mut least = Least { size: f64::INFINITY, direction: SVector::zeros(), site: 0 };
        let sites = sticking.edges.iter().zip(&forces.of).zip(&pushes);
        for (site, ((edges, force), pushes)) in sites.enumerate() {
            match edges {
                Edges::Rows(rows) => rows.iter().for_each(|row| least.cut(site, force, pushes, row)),
                Edges::Round { limit } => {
                    if !least.go_round(site, *limit, force, pushes) {
                        return Ok(WeakestDirection::Undecided);
                    }
                }
            }
        }
        let Least { size, direction, site } = least;
        let Some(leaver) = self.leaver(site).filter(|_| size.is_finite()) else {
            return Ok(WeakestDirection::Never);
        };
        let direction = direction.into();
        Ok(WeakestDirection::Force { size, direction, load: *base + push(&point, &direction) * size, leaver })
    }
}

/// The least force known so far.
struct Least {
    size: f64,
    direction: SVector<f64, 3>,
    site: usize,
}

impl Least {
    /// The least force that breaks one condition.
    fn cut(&mut self, site: usize, force: &SVector<f64, 3>, pushes: &Push, row: &SVector<f64, 3>) {
        let felt = pushes.felt(row);
        let size = row.dot(force).max(0.0) / felt.norm();
        if size < self.size {
            *self = Self { size, direction: -felt.normalize(), site };
        }
    }

    /// Lowers the force to the least that breaks a condition of a round cone. Returns whether it was found before cuts ran out.
    fn go_round(&mut self, site: usize, limit: f64, force: &SVector<f64, 3>, pushes: &Push) -> bool {
        // First cuts: the facets towards and against the friction force, and across it.
        let begin = force[2].atan2(force[1]);
        for quarter in 0_u8..4 {
            let angle = begin + f64::from(quarter) * FRAC_PI_2;
            self.cut(site, force, pushes, &round_row(limit, angle));
        }
        if self.size.is_infinite() {
            // Forces that change no condition at four angles change none, as three vectors determine the change at every angle.
            return true;
        }
        let number = round_parts(limit).map(|&(times, axis)| times * force[axis]);
        // Each cut lowers the force, with quadratic convergence; beyond this number cuts are rounding.
        for _ in 0..200 {
            let turning = Turning { number, vector: pushes.turning(limit, self.size) };
            let Some(angle) = turning.deepest(TAU) else { return true };
            let before = self.size;
            self.cut(site, force, pushes, &round_row(limit, angle));
            if self.size >= before {
                // The rest is rounding.
                return true;
            }
        }
        false
    }
}
