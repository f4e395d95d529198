//! What contacts reach first on the way.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts that stand on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
pub(super) type PathState<const C: usize> = Vec<(usize, Vec<Exit<C>>)>;

/// What happens first to the contacts on the way.
pub(super) struct FirstExits<const C: usize> {
    /// The step there, and everything that reaches an edge.
    pub(super) standing: Option<(f64, PathState<C>)>,
    /// Sites that come to the edge of their cone before and do not cross it, while a load turns, and where, rad.
    pub(super) touches: Vec<(usize, f64)>,
}
