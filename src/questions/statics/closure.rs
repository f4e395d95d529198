//! Force closure and form closure, each with its proof.
//!
//! A grasp is closed if sums of forces in its friction cones reach every wrench. Then forces *strictly inside* all cones balance each other, and
//! contacts resist every motion. For several bodies the wrenches are those on all of them at once, and a motion moves each of them.
//!
//! Take a unit force along the normal at every contact, and seek forces in the cones that balance the sum of these unit forces (see
//! `proofs/wrench_cone`). If no such forces exist, the wrench that remains unbalanced gives a motion along which no contact force does negative work.
//! Otherwise the unit force and the force found are added at each contact. The sums are projected onto forces that balance each other to the last
//! digit. Closure is proved if the projected forces are inside the cones by more than rounding.
//!
//! J. K. Salisbury and B. Roth, *Kinematic and force analysis of articulated mechanical hands*, 1983; A. Bicchi, *On the closure properties of
//! robotic grasping*, 1995.

use nalgebra::SVector;

use crate::contact::{LocalLaw, Mode, Polygon};
use crate::error::Error;
use crate::grasp::{BodyMotion, Engine, Twist};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Orthogonal, Vector, largest, mapped, moved, numbered, unit};
use crate::object::{Load, Problem};
use crate::prelude::*;
use crate::proofs::{Generator, NearestForces, nearest_forces, round_generators, straight_generators};
use crate::search::Settings;

/// Whether contact forces could balance any load on the object.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Closure<const C: usize> {
    /// Contact forces inside their friction cones could balance any load.
    #[non_exhaustive]
    Closed {
        /// Forces on the object in the contact frames, the largest 1 N, strictly inside their cones, that balance each other. Multiples of them can
        /// be added to any contact forces until all contact forces are inside their cones. For several bodies each force acts on the body that the
        /// normal points into, and the forces balance on every body.
        internal: Vec<SVector<f64, C>>,
    },
    /// Contact forces inside their friction cones could not balance every load.
    #[non_exhaustive]
    Open {
        /// A unit motion v along which no contact force in its cone does negative work. A load W that does positive work W·v along it cannot be
        /// balanced.
        motion: Twist<C>,
        /// The motions of all bodies in the same unit motion; `motion` is the motion of the body that loads act on. Empty for a single object.
        bodies: Vec<BodyMotion<C>>,
    },
    /// Up to rounding, the grasp is on the boundary between `Closed` and `Open`, so that neither is proved.
    Boundary,
}

impl Engine {
    pub(crate) fn force_closure(&self, settings: &Settings) -> Result<Closure<3>, Error> {
        self.refuse_joints("force_closure")?;
        let problem = self.without_load(settings);
        let axes = |(i, local): (usize, LocalLaw<'_>)| (0..local.springs.axes()).map(move |axis| (i, axis));
        let axes: Vec<_> = problem.locals().enumerate().flat_map(axes).list();
        // Without load and commands the possible forces of every contact form a cone. Thus each contact has generators: forces along the corners of
        // its cone, where two facets meet.
        let straight = straight_generators(&problem).unwrap_or_default();
        let inside = |forces: &[SVector<f64, 3>]| {
            problem.locals().zip(forces).all(|(local, force)| {
                local
                    .edges(&Mode::Sticking)
                    .worst(force)
                    .is_none_or(|(row, value)| value > NEGLIGIBLE * row.norm())
            })
        };
        let closure = self.closure(&axes, &straight, &|v| round_generators(&problem, v), &inside);
        self.whatever_vacuums_hold(closure, "force_closure")
    }

    pub(crate) fn form_closure(&self) -> Result<Closure<3>, Error> {
        self.refuse_joints("form_closure")?;
        let axes: Vec<_> = numbered(self.len(), &|i| (i, 0));
        let normals: Vec<_> = self.normals().list();
        let inside = |forces: &[SVector<f64, 3>]| forces.iter().all(|force| force[0] > NEGLIGIBLE);
        let closure = self.closure(&axes, &normals, &|_| Vec::new(), &inside);
        self.whatever_vacuums_hold(closure, "form_closure")
    }

    /// The answer `closure`, or an error if the vacuum of a suction cup might change it. If the contacts alone can balance every load, they can do so
    /// with a vacuum, too. Otherwise the vacuum may hold loads that the contacts do not hold, so that neither closure nor its absence is proved here.
    fn whatever_vacuums_hold(
        &self,
        closure: Closure<3>,
        question: &'static str,
    ) -> Result<Closure<3>, Error> {
        match (&closure, self.first_cup()) {
            (Closure::Closed { .. }, _) | (_, None) => Ok(closure),
            (_, Some(contact)) => Err(Error::Vacuum { question, contact }),
        }
    }

    /// Decides closure for friction cones that are spanned by generators. These are forces along the corners of polygonal cones (`straight`), or
    /// forces on the boundaries of round cones. `round` returns, for a motion, the generator of each round cone that does the most negative work
    /// along it. `axes` has pairs of a contact and one of its axes; forces have components along these axes only. `inside` returns whether forces are
    /// strictly inside their cones.
    fn closure(
        &self,
        axes: &[(usize, usize)],
        straight: &[Generator],
        round: &dyn Fn(&Vector) -> Vec<Generator>,
        inside: &dyn Fn(&[SVector<f64, 3>]) -> bool,
    ) -> Closure<3> {
        let sites = self.sites();
        let factor =
            Orthogonal::new(self.size(), &axes.iter().map(|&(i, axis)| sites[i].map.column(axis)).list());
        if let Some(motion) = factor.null_space().first() {
            return self.open(motion);
        }
        let mut forces = vec![SVector::zeros(); self.len()];
        let mut sum = Vector::zeros();
        for normal in self.normals() {
            forces[normal.contact] += normal.force;
            sum += normal.wrench;
        }
        let size = sum.norm();
        if size > 0.0 {
            let NearestForces { motion, negative_work, coefficients } =
                nearest_forces(self.size(), straight, round, &(-sum / size));
            let missing = motion.norm();
            if missing > NEGLIGIBLE && negative_work <= NEGLIGIBLE * missing {
                return self.open(&(motion / missing));
            }
            for (generator, coefficient) in coefficients {
                forces[generator.contact] += generator.force * (coefficient * size);
            }
        }
        let mut x: Vec<f64> = mapped(axes, &|&(i, axis)| forces[i][axis]);
        factor.project(&mut x, &Vector::zeros());
        for (&(i, axis), x) in axes.iter().zip(&x) {
            forces[i][axis] = *x;
        }
        let largest = largest(&forces, &SVector::norm);
        let internal: Vec<_> = moved(forces, &|force| force / largest);
        if inside(&internal) { Closure::Closed { internal } } else { Closure::Boundary }
    }

    /// [`Closure::Open`] with this motion, along which no contact force does negative work.
    fn open(&self, motion: &Vector) -> Closure<3> {
        let outside = self.outside_coordinates(motion);
        Closure::Open { motion: Twist::among(self.space(), &outside), bodies: self.body_motions(&outside) }
    }

    /// For each contact the wrench of a unit force along its normal.
    fn normals(&self) -> impl Iterator<Item = Generator> {
        let sites = self.sites().iter().enumerate();
        sites.map(|(contact, site)| Generator::along(contact, site, unit(0)))
    }

    /// The equilibrium problem of this grasp without load and without commands.
    pub(super) fn without_load(&self, settings: &Settings) -> Problem<'_> {
        let nothing = Load::from(&Vector::zeros());
        let offsets = vec![SVector::zeros(); self.sites().len()];
        self.problem(
            Polygon::shared(self.space(), &settings.cone),
            settings.is_round(self.space()),
            offsets,
            &nothing,
        )
    }
}
