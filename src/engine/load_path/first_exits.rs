//! The first edges that contacts reach on the way.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
pub(super) type PathState = Vec<(usize, Vec<Exit>)>;

/// The first exits of contacts on the way.
pub(super) struct FirstExits {
    /// The step to the first edge, and all contacts that reach one there.
    pub(super) standing: Option<(f64, PathState)>,
    /// Sites that come to the edge of their cone before, without crossing it, while a load turns; with the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}
