//! Units do not matter: powers of ten on rows, columns, M and q do not change the basis of the solution.
#![allow(clippy::doc_markdown, clippy::cast_possible_truncation, clippy::cast_sign_loss)]

use crate::common::published::small;
use crate::common::{Integers, Random, samples, seeded};
use grasp_lcp::lcp::{Lcp, Outcome};
use nalgebra::{DMatrix, DVector};

fn basis(lcp: &Lcp) -> Option<Vec<usize>> {
    match lcp.solve() {
        Outcome::Solved(solution) => Some(solution.basis.iter().collect()),
        Outcome::Infeasible(_) | Outcome::NearlyInfeasible(_) | Outcome::NoBasis { .. } | Outcome::Ray(_) => {
            None
        }
        other => panic!("{lcp:?}: {other:?}"),
    }
}

/// The problem after rows, columns and q are multiplied by factors. All factors are powers of ten with exponents up to ±`range`.
fn rescaled(m: &DMatrix<f64>, q: &DVector<f64>, random: &mut Random, range: i64) -> Lcp {
    let mut factor = || 10.0_f64.powi(random.integer(-range, range) as i32);
    let n = q.len();
    let rows: Vec<f64> = (0..n).map(|_| factor()).collect();
    let columns: Vec<f64> = (0..n).map(|_| factor()).collect();
    let load = factor();
    let m = DMatrix::from_fn(n, n, |i, j| m[(i, j)] * rows[i] * columns[j]);
    Lcp::new(m, DVector::from_fn(n, |i, _| q[i] * rows[i] * load)).unwrap()
}

#[test]
fn whole_problems_times_powers_of_ten() {
    for (source, problem, _) in small() {
        let (m, q) = (problem.matrix(), problem.vector());
        let plain = basis(&problem.problem());
        for k in -12..=12 {
            for (a, b) in [(k, 0), (0, k), (k, k), (k, -k)] {
                let scaled = Lcp::new(&m * 10.0_f64.powi(a), &q * 10.0_f64.powi(b)).unwrap();
                assert_eq!(basis(&scaled), plain, "{source}: M times 1e{a}, q times 1e{b}");
            }
        }
    }
}

#[test]
fn rows_and_columns_of_published_problems_times_powers_of_ten() {
    let mut random = seeded(47);
    for (source, problem, _) in small() {
        let plain = basis(&problem.problem());
        for _ in 0..samples(40) {
            let scaled = rescaled(&problem.matrix(), &problem.vector(), &mut random, 12);
            assert_eq!(basis(&scaled), plain, "{source}: {scaled:?}");
        }
    }
}

#[test]
fn rows_and_columns_of_random_integer_problems_times_powers_of_ten() {
    let mut random = seeded(53);
    for trial in 0..samples(250) {
        let n = random.integer(1, 7) as usize;
        let m: Vec<i64> = (0..n * n)
            .map(|_| if trial % 2 == 0 || random.integer(0, 2) > 0 { random.integer(-3, 4) } else { 0 })
            .collect();
        let q = (0..n).map(|_| random.integer(-3, 3)).collect();
        let problem = Integers { n, m, q };
        let plain = basis(&problem.problem());
        for _ in 0..5 {
            let scaled = rescaled(&problem.matrix(), &problem.vector(), &mut random, 12);
            assert_eq!(basis(&scaled), plain, "{problem:?}: {scaled:?}");
        }
    }
}

/// Small integer problems with common zeros of z and w, with rows that are singular up to rounding, or solved only after several
/// paths. Among a million problems, these confuse rounding errors with numbers most easily.
#[test]
fn rows_and_columns_of_the_most_degenerate_problems_times_powers_of_ten() {
    let problems: [(&[i64], &[i64]); 5] = [
        (&[0, 0, 3, 4, 0, 1, 0, 4, 1], &[0, -3, 0]),
        (&[4, 1, 3, 3, -1, 0, 2, 0, -3, 0, -2, 1, 4, 3, -1, -2], &[-1, 0, -3, 3]),
        (&[0, 0, -3, 0, 0, 0, 0, 0, 2, -2, 0, 2, 0, 0, -3, 0], &[2, 2, -2, 2]),
        (
            &[
                1, -3, 0, 1, 3, -1, -2, 3, 4, -1, 3, 2, 0, 0, 2, 0, -2, -2, -1, -2, 0, 0, 2, 1, -1, 1, 0, 0,
                -2, 3, 3, 4, 0, 3, -1, 0,
            ],
            &[1, -1, -1, -1, -1, 0],
        ),
        (
            &[
                0, -1, -1, 0, 0, 2, -1, 2, 4, 2, 0, 3, 2, -2, -1, 0, 2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0,
                3, 2, -2, -3, 0, -1, -3,
            ],
            &[3, -2, -1, 2, 0, -1],
        ),
    ];
    let mut random = seeded(59);
    for (m, q) in problems {
        let problem = Integers { n: q.len(), m: m.to_vec(), q: q.to_vec() };
        let plain = basis(&problem.problem());
        assert!(plain.is_some(), "{problem:?}");
        for _ in 0..samples(500) {
            let scaled = rescaled(&problem.matrix(), &problem.vector(), &mut random, 12);
            assert_eq!(basis(&scaled), plain, "{problem:?}: {scaled:?}");
        }
    }
}
