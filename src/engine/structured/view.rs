//! The result of a search in a workspace.

use core::fmt::Debug;

use nalgebra::SVector;

use crate::forms::Row;
use crate::grasp::{Face, Twist};

/// The end of a search for an equilibrium.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Search<'a, const C: usize> {
    /// An equilibrium, each condition satisfied to 1e-10 of its terms ([`EquilibriumView::residual`]).
    Found(EquilibriumView<'a, C>),
    /// The load works on a motion that no contact resists: there is no equilibrium.
    FreeMotion,
    /// Lemke's paths ended on rays, at their pivot limit (10 000 + 100 per row of the
    /// kinematic form) or on a point that violates a condition. There may be an
    /// equilibrium or none.
    NotFound {
        /// The number of pivots of all paths.
        pivots: usize,
    },
}

/// An equilibrium in the memory of its workspace.
#[derive(Debug, Clone, Copy)]
pub struct EquilibriumView<'a, const C: usize> {
    workspace: &'a dyn Viewed,
}

impl<'a, const C: usize> Search<'a, C> {
    /// The result as the caller sees it.
    pub(crate) fn outside(inside: Search<'a, 3>) -> Self {
        match inside {
            Search::Found(EquilibriumView { workspace }) => Self::Found(EquilibriumView { workspace }),
            Search::FreeMotion => Self::FreeMotion,
            Search::NotFound { pivots } => Self::NotFound { pivots },
        }
    }
}

impl<'a, const C: usize> EquilibriumView<'a, C> {
    pub(super) fn of(workspace: &'a dyn Viewed) -> Self {
        Self { workspace }
    }

    /// Forces on the object in the contact frames, N, one per contact in the order of the grasp:
    /// (`F_n`, `F_t`…), `F_n` > 0 pushes.
    #[must_use]
    pub fn forces(&self) -> impl ExactSizeIterator<Item = SVector<f64, C>> + use<'a, C> {
        self.workspace.forces().iter().map(|force| SVector::leave(*force))
    }

    /// Motion of the object: displacement of the origin (m) and rotation (rad), the least one if
    /// the contacts leave it free motions.
    #[must_use]
    pub fn twist(&self) -> Twist<C> {
        Twist::leave(self.workspace.twist())
    }

    /// The largest violation of a condition, relative to the sizes of its terms: balance of forces
    /// and moments, friction cones, gaps and slips. At most 1e-10, usually a few roundings.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.workspace.residual()
    }

    /// The number of pivots of Lemke's method, on all paths; 0 if every contact sticks or Newton's method found
    /// the equilibrium.
    #[must_use]
    pub fn pivots(&self) -> usize {
        self.workspace.pivots()
    }

    /// The number of Newton's steps, if Newton's method found the equilibrium. On polygons no pivot was made then.
    #[must_use]
    pub fn newton_steps(&self) -> Option<usize> {
        self.workspace.newton_steps()
    }

    /// The pairs of the kinematic form whose jump (gap or slip) is basic, contact by contact. A
    /// contact that sticks has none, and one that is open has its [`Row::Gap`]. One that slides
    /// across a facet has one [`Row::Slip`], at a corner of the polygon it has two. On the round cone
    /// the facet that touches it has the number 0.
    pub fn jumps(&self) -> impl Iterator<Item = Row> + 'a {
        let workspace = self.workspace;
        (0..workspace.forces().len()).flat_map(move |contact| workspace.rows(contact)).flatten()
    }
}

/// The methods of a workspace behind its view.
pub(super) trait Viewed: Debug {
    fn forces(&self) -> &[SVector<f64, 3>];
    fn twist(&self) -> Twist<3>;
    fn residual(&self) -> f64;
    fn pivots(&self) -> usize;
    fn newton_steps(&self) -> Option<usize>;
    fn rows(&self, contact: usize) -> [Option<Row>; 3];
}
