//! Force closure and form closure, each with what proves it.
//!
//! A grasp is closed if its friction cones together reach every wrench: then forces *strictly inside* all cones balance each other, and no
//! motion is free. Take a unit normal force at every contact. What is missing to balance their sum is looked for in the cones: if it is
//! found, all forces together are such; if not, the rest is a motion against which no force works (see `proofs/wrench_cone`). (J. K.
//! Salisbury and B. Roth 1983; A. Bicchi, *On the closure properties of robotic grasping*, 1995.)

use nalgebra::SVector;

use crate::contact::Polygon;
use crate::error::Error;
use crate::grasp::{Grasp, Twist};
use crate::numerics::{Orthogonal, unit};
use crate::object::{Load, Problem};
use crate::proofs::{Generator, NearestForces, nearest_forces, round_generators, straight_generators};
use crate::search::Settings;

/// What is missing of a sum of unit wrenches, as a part of it, and still counts as found: it is computed.
const FOUND: f64 = 1e-9;
/// A generator may work against a motion by this part of it.
const NO_WORK: f64 = 1e-9;

/// The answer to "could contact forces balance any load?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Closure<const D: usize, const C: usize> {
    /// They could.
    #[non_exhaustive]
    Closed {
        /// Forces in the contact frames, the largest 1 N, strictly inside their cones, that balance each other: the grasp can be squeezed
        /// with them as much as a load needs.
        internal: Vec<SVector<f64, C>>,
    },
    /// They could not.
    #[non_exhaustive]
    Open {
        /// A unit motion against which no contact force works. A load that works along it cannot be balanced, unless some contact
        /// force does, too.
        motion: Twist<D, C>,
    },
    /// On the boundary, as far as rounding can tell.
    Boundary,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Whether contact forces inside their friction cones could balance any load, on the round cone in space.
    ///
    /// Stiffness, commands and squeeze play no part in this: it says what fingers *could* hold if they pressed as needed, not what these do.
    ///
    /// ```
    /// use grasp_lcp::planar::{Closure, Contact, Grasp};
    ///
    /// // Two fingers opposite each other with friction; in the plane that is enough. One that is moved up lies outside the other's cone.
    /// let finger = |x: f64, y: f64| Contact::new([x, y], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5);
    /// let pinch = Grasp::new([finger(-1.0, 0.0), finger(1.0, 0.0)])?;
    /// assert!(matches!(pinch.force_closure()?, Closure::Closed { .. }) && matches!(pinch.form_closure()?, Closure::Open { .. }));
    /// let apart = Grasp::new([finger(-1.0, 0.0), finger(1.0, 1.5)])?;
    /// assert!(matches!(apart.force_closure()?, Closure::Open { .. }));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand.
    pub fn force_closure(&self) -> Result<Closure<D, C>, Error> {
        self.force_closure_with(&Settings::default())
    }

    /// The same with other [`Settings`], which say for which cone.
    ///
    /// # Errors
    /// As for [`Self::force_closure`].
    pub fn force_closure_with(&self, settings: &Settings) -> Result<Closure<D, C>, Error> {
        self.refuse_hands("force_closure")?;
        let problem = self.without_load(settings);
        if let Some(motion) = problem.trial().free_motions().first() {
            return Ok(Closure::Open { motion: self.outside(motion) });
        }
        // Sites that keep a whole cone at rest always have generators.
        let straight = straight_generators(&problem).unwrap_or_default();
        Ok(self.closure(&straight, |v| round_generators(&problem, v).collect()))
    }

    /// Whether the contacts hold the object without any friction: normal forces could balance any load, and no motion is left, to first
    /// order.
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand.
    pub fn form_closure(&self) -> Result<Closure<D, C>, Error> {
        self.refuse_hands("form_closure")?;
        let normals: Vec<_> = self.normals().collect();
        let factor = Orthogonal::new(normals.iter().map(|generator| generator.wrench).collect());
        if let Some(motion) = factor.null_space().first() {
            return Ok(Closure::Open { motion: self.outside(motion) });
        }
        Ok(self.closure(&normals, |_| Vec::new()))
    }

    /// The closure of cones with these generators and those of round cones, of a grasp that leaves no motion free.
    fn closure(
        &self,
        straight: &[Generator<D, C>],
        round: impl Fn(&SVector<f64, D>) -> Vec<Generator<D, C>>,
    ) -> Closure<D, C> {
        let sum = self.normals().fold(SVector::zeros(), |sum, normal| sum + normal.wrench);
        let size = sum.norm();
        let mut forces = vec![SVector::zeros(); self.len()];
        for normal in self.normals() {
            forces[normal.contact] += normal.force;
        }
        if size > 0.0 {
            let NearestForces { motion, against, shares } = nearest_forces(straight, round, &(-sum / size));
            let missing = motion.norm();
            if missing > FOUND {
                let no_work = against <= NO_WORK * missing;
                return if no_work {
                    Closure::Open { motion: self.outside(&(motion / missing)) }
                } else {
                    Closure::Boundary
                };
            }
            for (generator, share) in shares {
                forces[generator.contact] += generator.force * (share * size);
            }
        }
        // Near the boundary the forces that are needed beside the normal ones grow without bound.
        let largest = forces.iter().map(SVector::norm).fold(0.0, f64::max);
        let least = self.normals().map(|normal| normal.force.norm()).fold(f64::INFINITY, f64::min);
        if least <= FOUND * largest {
            return Closure::Boundary;
        }
        Closure::Closed { internal: forces.into_iter().map(|force| force / largest).collect() }
    }

    /// A unit wrench along every normal.
    fn normals(&self) -> impl Iterator<Item = Generator<D, C>> {
        let sites = self.sites().iter().enumerate();
        sites.map(|(contact, site)| Generator::along(contact, site, unit(0)))
    }

    /// The problem without load and commands.
    fn without_load(&self, settings: &Settings) -> Problem<'_, D, C> {
        let nothing = Load::from(&SVector::zeros());
        let drives = vec![SVector::zeros(); self.sites().len()];
        self.problem(Polygon::shared(&settings.cone), settings.is_round::<C>(), drives, &nothing)
    }
}
