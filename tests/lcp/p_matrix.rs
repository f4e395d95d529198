//! P-matrices are recognised, and every q has exactly one solution with them.
#![allow(clippy::doc_markdown, clippy::cast_possible_truncation, clippy::cast_sign_loss)]

use crate::common::{samples, seeded};
use grasp_lcp::lcp::{Lcp, Outcome, Settings};
use nalgebra::{DMatrix, DVector};

fn is_p(n: usize, m: &[f64]) -> Option<bool> {
    Lcp::new(DMatrix::from_row_slice(n, n, m), DVector::zeros(n)).unwrap().has_p_matrix()
}

#[test]
fn textbook_matrices() {
    assert_eq!(is_p(0, &[]), Some(true));
    assert_eq!(is_p(1, &[-1.]), Some(false));
    assert_eq!(is_p(2, &[1., 0., 0., 1.]), Some(true));
    assert_eq!(is_p(2, &[0., -1., 1., 0.]), Some(false));
    // Murty's matrix is a P-matrix with semidefinite symmetric part. With 3 instead of 2 it is not semidefinite.
    assert_eq!(is_p(3, &[1., 0., 0., 2., 1., 0., 2., 2., 1.]), Some(true));
    assert_eq!(is_p(3, &[1., 0., 0., 3., 1., 0., 3., 3., 1.]), Some(true));
    assert_eq!(is_p(2, &[1., 3., 2., 1.]), Some(false));
    // Without positive entries off the diagonal, elimination decides whether a matrix is a P-matrix. The determinant of the first matrix is 1, of the
    // second -1.
    assert_eq!(is_p(2, &[1., -4., 0., 1.]), Some(true));
    assert_eq!(is_p(2, &[1., -2., -1., 1.]), Some(false));
}

#[test]
fn low_rank_gram_matrices_are_none_and_a_shift_makes_them_so() {
    let mut random = seeded(79);
    for trial in 0..samples(60) {
        let n = 2 + trial % 20;
        let a = DMatrix::from_fn(n, n / 2, |_, _| random.normal());
        let gram = &a * a.transpose();
        let of = |m: DMatrix<f64>| Lcp::new(m, DVector::zeros(n)).unwrap().has_p_matrix();
        let shift = DMatrix::identity(n, n) * 1e-6;
        assert_eq!(of(&gram + &shift), Some(true));
        // Beyond 12 rows a matrix of this kind is left undecided.
        assert_eq!(of(&gram - &shift), (n <= 12).then_some(false));
    }
}

/// A P-matrix has exactly one solution for every q (CPS 3.3.7): compare with the number found by enumeration.
#[test]
fn p_matrices_have_one_solution_and_others_may_have_none_or_many() {
    let mut random = seeded(83);
    let mut seen = [0; 3];
    for _ in 0..samples(3000) {
        let n = random.integer(1, 4) as usize;
        let m = DMatrix::from_fn(n, n, |i, j| random.integer(-2, 2) as f64 + if i == j { 2.0 } else { 0.0 });
        let q = DVector::from_fn(n, |_, _| random.integer(-3, 3) as f64);
        let lcp = Lcp::new(m, q).unwrap();
        let one_path = Settings::default().with_retries(0).with_enumerate_up_to(0);
        let solved = matches!(lcp.solve_with(&one_path), Outcome::Solved(_));
        let all = lcp.all_solutions().unwrap().solutions.len();
        if lcp.has_p_matrix().expect("few rows") {
            assert!(solved && all == 1, "{lcp:?}: {all} solutions");
            seen[0] += 1;
        } else {
            seen[if all == 1 { 1 } else { 2 }] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > samples(10)), "{seen:?}");
}
