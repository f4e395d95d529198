//! Equilibrating and interaction forces.

use nalgebra::SVector;

use super::answer::{ContactState, Equilibrium};
use crate::formulation::least_forces;
use crate::grasp::Grasp;

/// Contact forces split in two, each along the coordinate axes, contact by contact (N).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Decomposition<const C: usize> {
    /// The smallest forces that balance the load: `F_E = -G⁺W` over the contacts that carry force.
    pub equilibrating: Vec<SVector<f64, C>>,
    /// What the contacts only exert on each other: `F_I = F - F_E`, with `Σ G_i F_I = 0`.
    pub interaction: Vec<SVector<f64, C>>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Splits the contact forces of an equilibrium of this grasp into equilibrating and interaction forces (section
    /// 5.2 of the paper): the equilibrating forces are the least-squares solution of `Σ G_i F_i = -W`, in which the
    /// difference of the forces of any two frictional contacts has no component along the line that joins them.
    #[must_use]
    pub fn decompose(&self, equilibrium: &Equilibrium<D, C>) -> Decomposition<C> {
        let carries: Vec<bool> =
            equilibrium.contacts.iter().map(|c| c.state != ContactState::Separated).collect();
        let load = self.inside_unchecked(&equilibrium.load);
        let equilibrating: Vec<_> = least_forces(self.sites(), &carries, &load)
            .into_iter()
            .zip(self.sites())
            .map(|(force, site)| site.frame * force)
            .collect();
        let interaction =
            equilibrium.contacts.iter().zip(&equilibrating).map(|(c, e)| c.force_world - e).collect();
        Decomposition { equilibrating, interaction }
    }
}
