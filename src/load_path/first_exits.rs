//! The first edges that contacts reach on the way.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
pub(super) type PathState<const C: usize> = Vec<(usize, Vec<Exit<C>>)>;

/// The first exits of contacts on the way.
pub(super) struct FirstExits<const C: usize> {
    /// The step to the first edge, and all contacts that reach one there.
    pub(super) standing: Option<(f64, PathState<C>)>,
    /// Sites that come to the edge of their cone before, without crossing it, while a load turns; with the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}
