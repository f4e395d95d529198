//! A few linear equations that are solved once, in place, by elimination with exchanges of rows.

use super::add_times::add_times;
use super::mapped::largest;
use super::tolerances::PARTIAL_PIVOT;

/// Upper limit of the number of unknowns that [`solved`] can find.
pub(crate) const MOST_UNKNOWNS: usize = 7;

/// One equation: the coefficients of its unknowns, then zeros, and the right-hand side in the last place.
pub(crate) type Equation = [f64; MOST_UNKNOWNS + 1];

/// The solution of as many equations as unknowns; `None` if a coefficient is not finite, or a pivot is below the fraction `PARTIAL_PIVOT` of the
/// largest coefficient: the equations are then nearly singular.
pub(crate) fn solved(equations: &mut [Equation]) -> Option<[f64; MOST_UNKNOWNS]> {
    let count = equations.len();
    let size = |equation: &Equation| largest(&equation[..count], &|x| x.abs());
    let largest = largest(equations, &size);
    for k in 0..count {
        let mut pivot = k;
        for i in k + 1..count {
            if equations[i][k].abs() > equations[pivot][k].abs() {
                pivot = i;
            }
        }
        // `large_enough` is false for NaN, too, so that equations with NaN have no solution.
        let size = equations[pivot][k].abs();
        let large_enough = size > PARTIAL_PIVOT * largest && size.is_finite();
        if !large_enough {
            return None;
        }
        equations.swap(k, pivot);
        let (above, below) = equations.split_at_mut(k + 1);
        let (top, reciprocal) = (&above[k], 1.0 / above[k][k]);
        for equation in below {
            let part = equation[k] * reciprocal;
            add_times(equation, top, -part);
        }
    }
    let mut solution = [0.0; MOST_UNKNOWNS];
    for k in (0..count).rev() {
        let equation = &equations[k];
        let mut rest = equation[MOST_UNKNOWNS];
        for j in k + 1..count {
            rest -= equation[j] * solution[j];
        }
        solution[k] = rest / equation[k];
    }
    Some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_what_needs_its_rows_exchanged() {
        // The solution is (1, -2, 0.5).
        let equation = |a: [f64; 3], right: f64| [a[0], a[1], a[2], 0.0, 0.0, 0.0, 0.0, right];
        let rows = [
            equation([0.0, 2.0, 1.0], -3.5),
            equation([1.0, 0.0, -3.0], -0.5),
            equation([4.0, 1.0, 0.0], 2.0),
        ];
        let found = solved(&mut rows.clone()).unwrap_or_default();
        assert!(found.iter().zip([1.0, -2.0, 0.5]).all(|(x, known)| (x - known).abs() < 1e-15), "{found:?}");
        assert_eq!(found[3..], [0.0; 4]);
        let mut twice = [rows[0], rows[1], rows[1]];
        assert_eq!(solved(&mut twice), None);
        assert_eq!(solved(&mut [[f64::NAN; 8]]), None);
    }
}
