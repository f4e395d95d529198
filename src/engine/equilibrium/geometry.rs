//! Change of the grasp map of one contact under a small change of its point or of its frame.
//!
//! The grasp map G of a contact turns its force F, in the contact frame, into a wrench: `G F = (R F, p × R F)`. Here p is the arm from the reference
//! point, and R = (n, t…) the contact frame, with columns along the coordinate axes.
//!
//! ```text
//! point moved by δ:                      dG F = (0, δ × R F)
//! frame turned, dR = R S, Sᵀ = -S:       dG   = G S
//! ```
//!
//! The second formula holds for all rows of G, also for those of joints: the same forces `R F` act on other coordinates.

use nalgebra::{SMatrix, SVector};

use crate::grasp::{Site, Space};
use crate::numerics::Map;

/// The change of the grasp map of a contact per metre by which its point moves along a coordinate axis. `length`, m, is the unit in which the engine
/// measures arms, so that a metre is an arm of `1 / length`.
pub(super) fn map_by_point(site: &Site, axis: usize, length: f64) -> Map {
    let mut arm = SVector::<f64, 3>::zeros();
    arm[axis] = 1.0 / length;
    let mut map = site.space.grasp_map(site.map.size(), &arm, &site.frame);
    // A moved contact point leaves the resultant force unchanged; only its moment changes.
    (0..site.space.axes()).for_each(|k| map.set_row(k, &SVector::zeros()));
    map
}

/// The change of the grasp map of a contact per radian by which its frame turns. For axis 0, in space only, the frame turns about its normal
/// from t₁ to t₂. For axis 1 (in space also 2) the normal tilts towards tangent number 1 (or 2). `None` for an axis that does not exist.
pub(super) fn map_by_normal(site: &Site, axis: usize) -> Option<Map> {
    let (from, to) = match axis {
        0 if site.space == Space::Spatial => (1, 2),
        1.. if axis < site.space.axes() => (0, axis),
        _ => return None,
    };
    let mut turn = SMatrix::<f64, 3, 3>::zeros();
    (turn[(to, from)], turn[(from, to)]) = (1.0, -1.0);
    Some(site.map.times(&turn))
}
