//! Small problems from the literature, as integers, with the source of each.

use super::Integers;

/// The known status of a problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Known {
    Solvable,
    /// No z ≥ 0 has M z + q ≥ 0.
    Infeasible,
    /// Some z ≥ 0 have M z + q ≥ 0, but no such z is complementary.
    Without,
}
use Known::{Infeasible, Solvable, Without};

fn entry(source: &'static str, m: &[i64], q: &[i64], known: Known) -> (&'static str, Integers, Known) {
    (source, Integers { n: q.len(), m: m.to_vec(), q: q.to_vec() }, known)
}

/// Handbook: Floudas et al., *Handbook of Test Problems in Local and Global Optimization*, 1999, chapter 10.
/// Made: constructed for this test from the failure of another solver.
#[allow(clippy::too_many_lines)] // a table
pub(crate) fn small() -> Vec<(&'static str, Integers, Known)> {
    let triangle = |n: usize, upper: bool, beside: i64| -> Vec<i64> {
        (0..n * n)
            .map(|k| {
                let (i, j) = (k / n, k % n);
                if i == j {
                    1
                } else if (i < j) == upper {
                    beside
                } else {
                    0
                }
            })
            .collect()
    };
    let fathi = |n: usize| -> Vec<i64> {
        (0..n * n)
            .map(|k| {
                let (i, j) = (k / n, k % n);
                4 * i.min(j) as i64 + if i == j { 1 } else { 2 }
            })
            .collect()
    };
    vec![
        entry("Handbook 10.2.1 (Murty 1988), n = 9", &triangle(9, true, 2), &[-1; 9], Solvable),
        entry("Handbook 10.2.2: three solutions", &[1, 1, 1, 1], &[-1, -1], Solvable),
        entry(
            "Handbook 10.2.3 (Cottle, Pang & Stone)",
            &[0, -1, 2, 2, 0, -2, -1, 1, 0],
            &[-3, 6, -1],
            Solvable,
        ),
        entry(
            "Handbook 10.2.4: bimatrix game, Lemke with ones ends in a ray",
            &[0, 0, 10, 20, 0, 0, 30, 15, 10, 20, 0, 0, 30, 15, 0, 0],
            &[-1; 4],
            Solvable,
        ),
        entry(
            "Handbook 10.2.9, l = 16: market equilibrium",
            &[11, 0, 10, -1, 0, 11, 10, -1, 10, 10, 21, -1, 1, 1, 1, 0],
            &[50, 50, 16, -6],
            Solvable,
        ),
        entry(
            "Handbook 10.2.9, l = 100",
            &[11, 0, 10, -1, 0, 11, 10, -1, 10, 10, 21, -1, 1, 1, 1, 0],
            &[50, 50, 100, -6],
            Solvable,
        ),
        entry("Kostreva 1979: principal pivoting cycles", &[1, 2, 0, 0, 1, 2, 2, 0, 1], &[-1; 3], Solvable),
        entry("Murty 1978: exponential, n = 3", &triangle(3, false, 2), &[-8, -12, -14], Solvable),
        entry("Fathi 1979, n = 6", &fathi(6), &[-1; 6], Solvable),
        entry("Csizmadia: exponential handicap, n = 8", &triangle(8, false, -1), &[-1; 8], Solvable),
        entry(
            "prisoners' dilemma in costs",
            &[0, 0, 2, 4, 0, 0, 1, 3, 2, 4, 0, 0, 1, 3, 0, 0],
            &[-1; 4],
            Solvable,
        ),
        entry(
            "matching pennies in costs",
            &[0, 0, 1, 3, 0, 0, 3, 1, 3, 1, 0, 0, 1, 3, 0, 0],
            &[-1; 4],
            Solvable,
        ),
        entry(
            "battle of the sexes in costs",
            &[0, 0, 1, 3, 0, 0, 3, 2, 2, 3, 0, 0, 3, 1, 0, 0],
            &[-1; 4],
            Solvable,
        ),
        entry("one variable, M = 0, q < 0", &[0], &[-1], Infeasible),
        entry("one variable, M = 0, q = 0", &[0], &[0], Solvable),
        entry("one variable, M = −1, q = −1 (Drake's failure test)", &[-1], &[-1], Infeasible),
        entry("one variable, M < 0: two solutions", &[-1], &[1], Solvable),
        entry("no variable", &[], &[], Solvable),
        entry("zero matrix", &[0; 16], &[1, 0, 3, 2], Solvable),
        entry("zero matrix, infeasible", &[0; 16], &[1, 0, -3, 2], Infeasible),
        entry("Made: w1 needs z2 > 0, which w2 = z2 forbids", &[0, 1, 0, 1], &[-1, 0], Without),
        entry("Made: skew, infeasible", &[0, -1, 1, 0], &[-1, -1], Infeasible),
        entry(
            "Made: a solution only on a singular basis",
            &[0, 1, 2, 0, 0, 0, 0, 0, 0],
            &[-2, 2, 0],
            Solvable,
        ),
        entry("Made: N-matrix, ray with ones although solvable", &[-1, 2, 2, -1], &[-1, -1], Solvable),
        entry("Made: z0 ties with every row", &[1, 0, 0, 0, 1, 0, 0, 0, 1], &[-1, -1, -1], Solvable),
        entry(
            "Made: one-contact friction of Stewart & Trinkle's form, μ = 1, sliding",
            &[2, 0, 0, 0, 0, 1, -1, 1, 0, -1, 1, 1, 1, -1, -1, 0],
            &[-4, -3, 3, 0],
            Solvable,
        ),
        entry(
            "Made: two contacts with μ = 0 and μ = 2",
            &[
                2, 0, 0, 0, 1, 0, 0, 0, //
                0, 1, -1, 1, 0, 0, 0, 0, //
                0, -1, 1, 1, 0, 0, 0, 0, //
                0, -1, -1, 0, 0, 0, 0, 0, //
                1, 0, 0, 0, 2, 0, 0, 0, //
                0, 0, 0, 0, 0, 1, -1, 1, //
                0, 0, 0, 0, 0, -1, 1, 1, //
                0, 0, 0, 0, 2, -1, -1, 0,
            ],
            &[-4, -3, 3, 0, -2, 1, -1, 0],
            Solvable,
        ),
    ]
}
