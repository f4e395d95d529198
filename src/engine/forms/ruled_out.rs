//! A quick test that excludes contact states which clearly violate a complementary pair of the kinematic form. In this complementarity problem the
//! unknowns are gaps and slips, and the slacks are normal forces and friction margins `μ F_n - h·F_t` at facets with normals h. The pairs of the form
//! need not include all contacts. Only a solution with all contacts shows whether the states that the test does not exclude satisfy every condition.

use crate::numerics::{Reals, matrix_of, vector_of};

use super::rows::{Form, Row};
use crate::contact::{Mode, State};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

/// True if these contact states clearly make an unknown or a slack of the form negative. `largest` is the largest force of the elastic trial (the
/// solution in which every contact sticks), in units of the slacks. Returns false if the equations are singular, and in two cases that the test does
/// not cover: a contact slides at a corner of its cone, or a contact in space with friction is open.
pub(crate) fn clearly_breaks(form: &Form, is_planar: bool, states: &[State], largest: f64) -> bool {
    let (mut slack, mut jumps) = (Vec::new(), Vec::new());
    for (i, row) in form.rows.iter().enumerate() {
        let (Row::Gap { contact } | Row::Slip { contact, .. }) = *row else { return false };
        match (states[contact], row) {
            (Mode::Facet(slips), Row::Slip { facet, .. }) if usize::from(slips) == *facet => {
                jumps.push((i, true));
            }
            (Mode::Sticking | Mode::Facet(_), _) => slack.push(i),
            (Mode::Open, Row::Gap { .. }) => jumps.push((i, true)),
            // In the plane the tangential displacement of an open contact is the unknown of facet 0, with either sign.
            (Mode::Open, Row::Slip { facet: 0, .. }) if is_planar => jumps.push((i, false)),
            (Mode::Open, Row::Slip { .. }) if is_planar => {}
            _ => return false,
        }
    }
    let (m, q) = (form.lcp.matrix(), form.lcp.vector());
    let of_jumps = matrix_of(jumps.len(), jumps.len(), &|i, j| m[(jumps[i].0, jumps[j].0)]);
    let pushed = vector_of(jumps.len(), &|i| -q[jumps[i].0]);
    let solved = if jumps.is_empty() { Some(pushed) } else { of_jumps.full_piv_lu().solve(&pushed) };
    let Some(z) = solved else { return false };
    let most = z.iter().fold(0.0, |most: f64, z| if z.abs() <= most { most } else { z.abs() });
    // Gaps or slips larger than 1e8 times the largest force (both scaled) show that the equations are linearly dependent. The test then excludes
    // nothing. For NaN the comparison is false, so that the test excludes nothing either.
    let known = most <= 1e8 * largest;
    if !known {
        return false;
    }
    // An unknown or slack is clearly negative if it is below minus the fraction `NEGLIGIBLE` of the largest force, gap or slip (scaled). Rounding
    // errors of the kinematic form are far smaller, some 1e-14 of the largest.
    let broken = -NEGLIGIBLE * largest.max(most);
    let w = |i: usize| q[i] + jumps.iter().zip(z.iter()).map(|((j, _), z)| m[(i, *j)] * z).added();
    jumps.iter().zip(z.iter()).any(|((_, has_sign), z)| *has_sign && *z < broken)
        || slack.into_iter().any(|i| w(i) < broken)
}
