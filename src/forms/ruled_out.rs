//! States that clearly break a row of the kinematic form: a look at a few rows, where a solution of the whole scene would be needed to say that they hold.

use nalgebra::{DMatrix, DVector};

use super::rows::{Form, Row};
use crate::contact::{Mode, State};
use crate::prelude::*;

/// A row that is broken by this part of the largest force or jump is broken clearly: the form is known to some 1e-14.
const CLEARLY: f64 = 1e-9;
/// Jumps so many times as large as the forces say that rows depend on each other.
const DEPENDENT: f64 = 1e8;

/// Whether these states clearly break a row of the form, `largest` being the largest force of the trial state in units of its rows. Of contacts that slip across two facets
/// nothing is said.
pub(crate) fn clearly_breaks<const C: usize>(form: &Form, states: &[State<C>], largest: f64) -> bool {
    let (mut slack, mut jumps) = (Vec::new(), Vec::new());
    for (i, row) in form.rows.iter().enumerate() {
        let (Row::Gap { contact } | Row::Slip { contact, .. }) = *row else { return false };
        match (states[contact], row) {
            (Mode::Facet(slips), Row::Slip { facet, .. }) if usize::from(slips) == *facet => {
                jumps.push((i, true));
            }
            (Mode::Sticking | Mode::Facet(_), _) => slack.push(i),
            (Mode::Open, Row::Gap { .. }) => jumps.push((i, true)),
            // In the plane one facet says all of the slip of what is open, which has any sign.
            (Mode::Open, Row::Slip { facet: 0, .. }) if C == 2 => jumps.push((i, false)),
            (Mode::Open, Row::Slip { .. }) if C == 2 => {}
            _ => return false,
        }
    }
    let (m, q) = (form.lcp.matrix(), form.lcp.vector());
    let of_jumps = DMatrix::from_fn(jumps.len(), jumps.len(), |i, j| m[(jumps[i].0, jumps[j].0)]);
    let pushed = DVector::from_fn(jumps.len(), |i, _| -q[jumps[i].0]);
    let solved = if jumps.is_empty() { Some(pushed) } else { of_jumps.full_piv_lu().solve(&pushed) };
    let Some(z) = solved else { return false };
    let most = z.iter().fold(0.0, |most: f64, z| if z.abs() <= most { most } else { z.abs() });
    // Written so that it also turns away what is not a number.
    let known = most <= DEPENDENT * largest;
    if !known {
        return false;
    }
    let broken = -CLEARLY * largest.max(most);
    let w = |i: usize| q[i] + jumps.iter().zip(z.iter()).map(|((j, _), z)| m[(i, *j)] * z).sum::<f64>();
    jumps.iter().zip(z.iter()).any(|((_, has_sign), z)| *has_sign && *z < broken)
        || slack.into_iter().any(|i| w(i) < broken)
}
