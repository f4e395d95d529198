//! Which contact states working precision tells apart from their neighbours.
//!
//! Open and touching, rolling and sliding, sliding this way and that meet where a gap, a force, the friction in reserve or a slip
//! vanishes. Next to such an edge the last digits of the question decide.

use crate::contact::Mode;
use crate::object::Problem;
use crate::search::Found;

/// A condition met by less than this part of the size of its terms may be rounding of the data: normals, arms and products of
/// them carry a few units of 1e-16, which well-posed grasps magnify a hundred times and more.
const ROUNDING_OF_DATA: f64 = 1e-12;
/// Nor by less than so many times the estimated error.
const ERRORS: f64 = 10.0;

/// Contact by contact, whether every condition of its state holds clearly. The errors are those of forces, N, and displacements, m.
pub(super) fn distinct<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    found: &Found<D, C>,
    [force_error, displacement_error]: [f64; 2],
) -> Vec<bool> {
    let largest = problem.largest_force(&found.forces, &found.twist);
    let part = |error: f64, size: f64| if size > 0.0 { ERRORS * error / size } else { 0.0 };
    (0..problem.len())
        .map(|i| {
            let at = problem.at(i, &found.forces[i], &found.twist, largest);
            let of_forces = part(force_error, largest);
            let of_displacements = part(displacement_error, at.span);
            let least = ROUNDING_OF_DATA.max(match found.states[i] {
                Mode::Open => of_displacements,
                Mode::Rolling => of_forces,
                _ => of_forces.max(of_displacements),
            });
            let mut distinct = true;
            problem.local(i).for_each_condition(&found.states[i], &at, |value, size| {
                distinct &= value > least * size;
            });
            distinct
        })
        .collect()
}
