//! Equilibrium under Coulomb's law and minimum of energy under friction constraints, compared for one load.

#[cfg(feature = "serde")]
use super::minimum::Inside;
use super::minimum::{MinimumEnergy, MinimumOutcome};
use crate::Settings;
use crate::equilibrium::{Equilibrium, Outcome};
use crate::error::Error;

use crate::grasp::{Engine, Wrench};
use crate::numerics::Vector;
use crate::numerics::tolerances::NEGLIGIBLE;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The equilibrium under Coulomb's law, compared with the minimum of energy under friction constraints ([`MinimumEnergy`]). In space both use the
/// same polygonal friction cone.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Comparison<const C: usize> {
    /// Answer of the complementarity problem: the equilibrium, a proof that no equilibrium exists, or undecided.
    pub equilibrium: Outcome<C>,
    /// Answer of the quadratic program: its minimum, with the binding friction constraints and the imbalance of forces, or the reason why it has no
    /// minimum.
    pub minimum: MinimumOutcome<C>,
    /// The differences between the equilibrium and the minimum; `None` unless both exist.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub difference: Option<Difference>,
    /// Whether the minimum of energy is the equilibrium; if not, the force and moment by which contact forces and load do not balance at the minimum.
    pub verdict: ComparisonVerdict,
}

/// The largest differences between the equilibrium and the minimum of energy under one load, and the reference values with which they are compared;
/// none is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Difference {
    /// Largest distance, over all contacts, between the displacement of the object at the contact in the equilibrium and that at the minimum, m.
    /// Motions that no spring resists, in the equilibrium or in the minimum, are not included.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub displacement: f64,
    /// Largest magnitude, over all contacts, of the vector difference between the contact force in the equilibrium and that at the minimum, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub force: f64,
    /// Magnitude of the difference between the energies stored in the springs, in the equilibrium and at the minimum, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub energy: f64,
    /// The reference value for `displacement`, m: the largest magnitude, over all contacts, of the object's displacement at the contact in the
    /// equilibrium and of the offset (command less clearance).
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub displacement_size: f64,
    /// The reference value for `force`: the largest magnitude of a contact force in the equilibrium, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub force_size: f64,
    /// The reference value for `energy`: the energy stored in the springs in the equilibrium, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub energy_size: f64,
}

#[cfg(feature = "serde")]
impl<const C: usize> Comparison<C> {
    /// This comparison without the data that JSON does not contain (motions in internal coordinates). It then equals a comparison read back from
    /// JSON.
    pub(crate) fn written(mut self) -> Self {
        if let MinimumOutcome::Minimum(minimum) = &mut self.minimum {
            minimum.inside = Inside::default();
        }
        self
    }
}

impl Difference {
    /// The largest of three relative differences: of displacement, force and energy. Each difference is divided by its reference value (the field
    /// with `_size` in its name). A difference of zero gives the quotient 0, even if the reference value is zero.
    #[must_use]
    pub fn relative(&self) -> f64 {
        let part = |difference: f64, size: f64| if difference == 0.0 { 0.0 } else { difference / size };
        part(self.displacement, self.displacement_size)
            .max(part(self.force, self.force_size))
            .max(part(self.energy, self.energy_size))
    }
}

/// How the answers of the complementarity problem and of the quadratic program compare under one load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum ComparisonVerdict {
    /// The minimum of energy is an equilibrium, and the complementarity problem gives the same equilibrium. This is also the verdict if the
    /// complementarity problem gave no equilibrium.
    Agree,
    /// The minimum is an equilibrium, and the complementarity problem has another equilibrium; they differ by more than 1e-9 of the largest contact
    /// force or displacement. With friction there may be several equilibria, and if a contact carries no force the object may have several positions.
    TwoEquilibria,
    /// An equilibrium exists, but at the minimum of energy contact forces and load do not balance.
    OutOfEquilibrium {
        /// At the minimum of energy, the magnitude of the sum of contact forces and load, `|Σ F + W|`, N.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        force: f64,
        /// At the minimum of energy, the magnitude of the sum of all moments about the origin, `|Σ r × F + M|`, N m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        moment: f64,
    },
    /// No equilibrium exists. The quadratic program has a minimum, at which contact forces and load do not balance.
    NoEquilibrium {
        /// At the minimum of energy, the magnitude of the sum of contact forces and load, `|Σ F + W|`, N.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        force: f64,
        /// At the minimum of energy, the magnitude of the sum of all moments about the origin, `|Σ r × F + M|`, N m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        moment: f64,
    },
    /// At the minimum of energy contact forces and load do not balance. It is not known whether an equilibrium exists.
    Unknown {
        /// At the minimum of energy, the magnitude of the sum of contact forces and load, `|Σ F + W|`, N.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        force: f64,
        /// At the minimum of energy, the magnitude of the sum of all moments about the origin, `|Σ r × F + M|`, N m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        moment: f64,
    },
    /// The quadratic program has no minimum: its constraints contradict each other, or the load does positive work along a motion that no spring
    /// resists.
    NoMinimum,
    /// The quadratic program was not solved, because of rounding or its limit of pivots.
    Unsolved,
}

impl Difference {
    fn differ(&self) -> bool {
        self.force > NEGLIGIBLE * self.force_size || self.displacement > NEGLIGIBLE * self.displacement_size
    }
}

impl<const C: usize> MinimumEnergy<C> {
    /// Whether the object is in equilibrium at the minimum of energy, because the multipliers of friction constraints exert no resultant force or
    /// moment on it. [`MinimumEnergy::imbalance`] may be rounding, at most 1e-12 of the largest force (moments divided by the size of the grasp, a
    /// length).
    #[must_use]
    pub fn is_equilibrium(&self) -> bool {
        self.balanced
    }

    /// How far the object is from equilibrium at the minimum of energy. First comes the magnitude of the sum of contact forces and load, `|Σ F + W|`,
    /// N. Second comes that of the sum of their moments about the origin, `|Σ r × F + M|`, N m.
    #[must_use]
    pub fn out_of_balance(&self) -> (f64, f64) {
        let (mut force, mut moment) = (0.0_f64, 0.0_f64);
        for (k, x) in self.imbalance.components().iter().enumerate() {
            let sum = if k < C { &mut force } else { &mut moment };
            *sum = sum.hypot(*x);
        }
        (force, moment)
    }
}

impl Engine {
    pub(crate) fn compare_with_minimum_energy(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<Comparison<3>, Error> {
        let equilibrium = self.solve(load, &(*settings).on_the_polygon())?;
        let minimum = self.minimum_energy(load, settings)?;
        let difference = equilibrium
            .equilibrium()
            .zip(minimum.minimum())
            .map(|(equilibrium, minimum)| self.difference(equilibrium, minimum));
        let verdict = match (&minimum, &equilibrium) {
            (MinimumOutcome::Unsolved, _) => ComparisonVerdict::Unsolved,
            (MinimumOutcome::NoMinimum | MinimumOutcome::Unbounded { .. }, _) => ComparisonVerdict::NoMinimum,
            (MinimumOutcome::Minimum(m), _) if m.is_equilibrium() => match &difference {
                Some(d) if d.differ() => ComparisonVerdict::TwoEquilibria,
                _ => ComparisonVerdict::Agree,
            },
            (MinimumOutcome::Minimum(m), answer) => {
                let (force, moment) = m.out_of_balance();
                match answer {
                    Outcome::Equilibrium(_) => ComparisonVerdict::OutOfEquilibrium { force, moment },
                    Outcome::NoEquilibrium(_) => ComparisonVerdict::NoEquilibrium { force, moment },
                    Outcome::Undecided(_) => ComparisonVerdict::Unknown { force, moment },
                }
            }
        };
        Ok(Comparison { equilibrium, minimum, difference, verdict })
    }

    fn difference(&self, equilibrium: &Equilibrium<3>, minimum: &MinimumEnergy<3>) -> Difference {
        let mut d = Difference {
            displacement: 0.0,
            force: 0.0,
            energy: (equilibrium.stored_energy - minimum.stored_energy).abs(),
            displacement_size: 0.0,
            force_size: 0.0,
            energy_size: equilibrium.stored_energy,
        };
        // Motions that no spring resists are removed from the difference of the twists; in the internal coordinates, in which `inside` and `local`
        // store twists, they are orthonormal.
        let mut apart: Vector = equilibrium.local.twist.to() - minimum.inside.twist.to();
        for _ in 0..2 {
            for v in equilibrium.local.free_motions.iter().chain(&minimum.inside.free_motions) {
                let v: Vector = v.to();
                apart -= &v * v.dot(&apart);
            }
        }
        for ((a, b), (site, offset)) in
            equilibrium.contacts.iter().zip(&minimum.contacts).zip(self.sites().iter().zip(self.offsets()))
        {
            d.displacement = d.displacement.max(site.map.tr_mul(&apart).norm());
            d.displacement_size = d.displacement_size.max(a.body_core.norm()).max(offset.norm());
            d.force = d.force.max((a.force - b.force).norm());
            d.force_size = d.force_size.max(a.force.norm());
        }
        d
    }
}
