//! The least force, over all directions, that makes a contact cease to stick when it acts at a given point. The base load is constant and acts before
//! that force. A facet is a plane that bounds a polygonal friction cone, or one that touches a round cone; in the code the facets of a contact are
//! edges. A drive is the spring of a joint or tendon of a hand, with its force limit.

use crate::numerics::IntoList;
use core::f64::consts::FRAC_PI_2;

use nalgebra::SVector;

use super::loads::check_point;
use crate::contact::Edges;
use crate::equilibrium::{Influence, StickingResponse, push};
use crate::error::Error;
use crate::grasp::{Engine, Motion, Wrench};
use crate::load_path::DepartingPart;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Settings;

/// The answer to "in which direction does the least force at this point make a contact cease to stick?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum WeakestDirection<const C: usize> {
    /// A force of this magnitude in this direction makes a contact cease to stick, or a drive of a hand reach its force limit. No smaller force has
    /// this effect, in any direction.
    #[non_exhaustive]
    Force {
        /// Magnitude of the least force, N, exact up to rounding.
        size: f64,
        /// Unit vector along the least force, in coordinate axes.
        direction: [f64; C],
        /// The base load plus the least force at its point, N and N m.
        load: Wrench<C>,
        /// The contact that ceases to stick, or the drive of a hand that reaches its force limit.
        leaver: DepartingPart,
    },
    /// All contacts keep sticking, and no drive reaches its force limit, under a force of any magnitude in any direction.
    Never,
    /// Nothing resists this motion, and a force at this point can do work along it.
    GivesWay {
        /// The motion that nothing resists, scaled to unit length.
        motion: Motion<C>,
    },
    /// Under the base load a contact slides or is open, a drive is at its force limit, or no equilibrium with all contacts sticking exists.
    NotSticking,
    /// The search for the least force did not end within its number of steps, because of rounding.
    Undecided,
}

impl Engine {
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
        let mut least = LeastForce { size: f64::INFINITY, direction: SVector::zeros(), site: 0 };
        for (site, edges) in sticking.edges.iter().enumerate() {
            if !least.lowered_to(site, edges, &forces.of[site], &influences[site]) {
                return Ok(WeakestDirection::Undecided);
            }
        }
        let LeastForce { size, direction, site } = least;
        let Some(leaver) = self.leaver(site).filter(|_| size.is_finite()) else {
            return Ok(WeakestDirection::Never);
        };
        let direction = direction.into();
        Ok(WeakestDirection::Force { size, direction, load: *base + push(&point, &direction) * size, leaver })
    }
}

/// The least force known so far that takes the force of a contact to the boundary of its cone, or a drive to its force limit. `site` is the index,
/// from 0, of this contact or drive (drives follow the contacts).
struct LeastForce {
    size: f64,
    direction: SVector<f64, 3>,
    site: usize,
}

impl LeastForce {
    /// Finds the least force that takes the force of this contact to the boundary of its cone. It is kept if it is less than the least force so far.
    /// A round cone is approximated by tangent planes, more of them in each round. Returns whether the search ended within the allowed number of
    /// rounds.
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
        // The first planes are all facets of a polygonal cone. For a round cone the first planes are four facets: along the friction force, opposite
        // to it, and at right angles to it on both sides.
        let begin = force[2].atan2(force[1]);
        let quarters = |quarter: u8| begin + f64::from(quarter) * FRAC_PI_2;
        let mut size = cut(edges.rows(&|_| (0..4).map(quarters).list()));
        // Each round adds planes, which reduces the least force; the force converges quadratically. After this many rounds only rounding could still
        // change the force.
        for _ in 0..200 {
            // The margin on the facet at angle φ of the round cone has a gradient with respect to the force at the point. It is a + b cos φ + c sin
            // φ, with constant vectors a, b and c. If this gradient vanishes at four angles, it vanishes at all angles, and no force makes this
            // contact slide.
            if size.is_infinite() {
                return true;
            }
            let before = size;
            size = cut(edges.on_a_sphere(force, &influence.of, size));
            if size >= before {
                // If further planes do not lower the force, this force and the true least force differ only by rounding.
                return true;
            }
        }
        false
    }
}
