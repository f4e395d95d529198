//! The least force, of all directions, at which a contact slides.

use crate::numerics::IntoList;
use core::f64::consts::FRAC_PI_2;

use nalgebra::SVector;

use super::loads::check_point;
use crate::contact::Edges;
use crate::equilibrium::{Influence, StickingResponse, push};
use crate::error::Error;
use crate::grasp::{Engine, Motion, Wrench};
use crate::load_path::Leaver;
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
        /// Size of the force, N, exact up to rounding.
        size: f64,
        /// Unit vector along the force, in coordinate axes.
        direction: [f64; C],
        /// The base load together with the least force.
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
    /// Implements [`Grasp::weakest_direction`](crate::ask::Grasp::weakest_direction).
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
        let Ok(forces) = sticking.forces(&self.offsets(), &load) else {
            return Ok(WeakestDirection::NotSticking);
        };
        let mut sites = sticking.edges.iter().zip(forces.of.iter().zip(&forces.sizes));
        if !sites.all(|(edges, (force, size))| edges.hold(force, *size)) {
            return Ok(WeakestDirection::NotSticking);
        }
        let influences = match sticking.influences(&point) {
            Ok(influences) => influences,
            Err(motion) => return Ok(WeakestDirection::GivesWay { motion }),
        };
        let mut least = Least { size: f64::INFINITY, direction: SVector::zeros(), site: 0 };
        for (site, edges) in sticking.edges.iter().enumerate() {
            if !least.lowered_to(site, edges, &forces.of[site], &influences[site]) {
                return Ok(WeakestDirection::Undecided);
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

/// The least force known so far that makes a contact slide, and its contact.
struct Least {
    size: f64,
    direction: SVector<f64, 3>,
    site: usize,
}

impl Least {
    /// Lowers the least force to the one at which this contact leaves its cone, if that is smaller. The cone is replaced by more and more planes that
    /// touch it. Returns whether the allowed number of planes was enough.
    fn lowered_to(
        &mut self,
        site: usize,
        edges: &Edges,
        force: &SVector<f64, 3>,
        influence: &Influence,
    ) -> bool {
        let mut cut = |rows: Vec<SVector<f64, 3>>| {
            for row in rows {
                let gradient = influence.gradient_of(&row);
                let size = row.dot(force).max(0.0) / gradient.norm();
                if size < self.size {
                    *self = Self { size, direction: -gradient.normalize(), site };
                }
            }
            self.size
        };
        // The first planes are all facets of a polygonal cone. For a round cone they are four facets: towards, against and across the friction force.
        let begin = force[2].atan2(force[1]);
        let quarters = |quarter: u8| begin + f64::from(quarter) * FRAC_PI_2;
        let mut size = cut(edges.rows(&|_| (0..4).map(quarters).list()));
        // Each further plane lowers the force, with quadratic convergence. Beyond this many planes only rounding could change the force.
        for _ in 0..200 {
            // The margin on the facet at angle φ of the round cone has the gradient a + b cos φ + c sin φ by the force. If this vanishes at four
            // angles, it vanishes at all of them, and no force makes this contact slide.
            if size.is_infinite() {
                return true;
            }
            let before = size;
            size = cut(edges.on_a_sphere(force, &influence.of, size));
            if size >= before {
                // If a further plane does not lower the force, the bound and the true least force differ only by rounding.
                return true;
            }
        }
        false
    }
}
