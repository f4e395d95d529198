//! Equilibrating and interaction forces.

use std::borrow::Cow;

use nalgebra::{SMatrix, SVector};

use super::answer::{ContactState, Equilibrium};
use crate::grasp::{Grasp, Site, object_alone};
use crate::object::least_forces;

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
    /// 5.2 of the paper).
    ///
    /// The equilibrating forces are the least-squares solution of `Σ G_i F_i = -W`. In it the difference of the forces of any two
    /// frictional contacts has no component along the line that joins them. Separated contacts carry neither. Lists as long as the shorter of grasp and equilibrium, if that is one of another grasp.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::Vector2;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(&Wrench::force([0.0, -4.0]))?;
    /// let split = grasp.decompose(outcome.equilibrium().expect("holds"));
    /// assert!((split.equilibrating[0] - Vector2::new(0.0, 2.0)).norm() < 1e-14);
    /// assert!((split.interaction[0] - Vector2::new(10.0, 0.0)).norm() < 1e-14);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn decompose(&self, equilibrium: &Equilibrium<D, C>) -> Decomposition<C> {
        let contact = |i: usize| equilibrium.contacts.get(i);
        let carries: Vec<bool> =
            (0..self.len()).map(|i| contact(i).is_some_and(|c| c.state != ContactState::Separated)).collect();
        let load = self.inside_unchecked(&equilibrium.load);
        // Forces on the object, whatever joints are behind them.
        let load = object_alone::<D, C>(&load);
        let on_object = |site: &Site<D, C>| {
            let columns: [_; C] = std::array::from_fn(|a| object_alone::<D, C>(&site.map.column(a).into()));
            site.with_map(SMatrix::from_columns(&columns))
        };
        let sites: Cow<'_, [Site<D, C>]> = match self.linkage() {
            None => self.sites().into(),
            Some(_) => self.sites()[..self.len()].iter().map(on_object).collect(),
        };
        let equilibrating: Vec<_> = least_forces(&sites, &carries, &load)
            .into_iter()
            .zip(self.sites())
            .take(equilibrium.contacts.len())
            .map(|(force, site)| site.frame * force)
            .collect();
        let interaction =
            equilibrium.contacts.iter().zip(&equilibrating).map(|(c, e)| c.force_world - e).collect();
        Decomposition { equilibrating, interaction }
    }
}
