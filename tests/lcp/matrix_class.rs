//! Matrices are classified correctly, and the guarantees of each class hold.
#![allow(clippy::doc_markdown, clippy::cast_possible_truncation, clippy::cast_sign_loss)]

use crate::common::{samples, seeded};
use grasp_lcp::lcp::{Copositivity, Definiteness, Guarantee, Lcp, MatrixClass, Outcome, Settings};
use nalgebra::{DMatrix, DVector};

fn class(n: usize, m: &[f64]) -> MatrixClass {
    MatrixClass::of(&DMatrix::from_row_slice(n, n, m)).unwrap()
}

#[test]
fn textbook_matrices() {
    let identity = class(2, &[1., 0., 0., 1.]);
    assert!(identity.symmetric && identity.z_matrix);
    assert_eq!(identity.guarantee(), Guarantee::UniqueSolution);

    let skew = class(2, &[0., -1., 1., 0.]);
    assert_eq!(skew.definiteness, Definiteness::PositiveSemidefinite);
    assert_eq!(skew.guarantee(), Guarantee::SolutionIfFeasible);
    assert_eq!(skew.p_matrix, Some(false));

    // Murty's matrix is a P-matrix with semidefinite symmetric part. With 3 instead of 2 it is not semidefinite.
    let murty = class(3, &[1., 0., 0., 2., 1., 0., 2., 2., 1.]);
    assert_eq!((murty.definiteness, murty.p_matrix), (Definiteness::PositiveSemidefinite, Some(true)));
    let steeper = class(3, &[1., 0., 0., 3., 1., 0., 3., 3., 1.]);
    assert_eq!((steeper.definiteness, steeper.p_matrix), (Definiteness::Indefinite, Some(true)));

    let nonnegative = class(2, &[1., 3., 2., 1.]);
    assert_eq!(nonnegative.copositivity, Copositivity::Strict);
    assert_eq!((nonnegative.p_matrix, nonnegative.guarantee()), (Some(false), Guarantee::Solution));

    let game = class(2, &[0., 1., 1., 0.]);
    assert_eq!((game.copositivity, game.guarantee()), (Copositivity::Plain, Guarantee::None));

    assert_eq!(class(1, &[-1.]).copositivity, Copositivity::Not);
    assert_eq!(class(2, &[1., -2., -2., 1.]).definiteness, Definiteness::Indefinite);
    assert_eq!(class(0, &[]).guarantee(), Guarantee::UniqueSolution);
    assert!(MatrixClass::of(&DMatrix::zeros(1, 2)).is_err());
}

#[test]
fn low_rank_gram_matrices_are_semidefinite_and_a_shift_makes_them_definite_or_indefinite() {
    let mut random = seeded(79);
    for trial in 0..samples(60) {
        let n = 2 + trial % 20;
        let a = DMatrix::from_fn(n, n / 2, |_, _| random.normal());
        let gram = &a * a.transpose();
        let of = |m: &DMatrix<f64>| MatrixClass::of(m).unwrap().definiteness;
        assert_eq!(of(&gram), Definiteness::PositiveSemidefinite);
        let shift = DMatrix::identity(n, n) * 1e-6;
        assert_eq!(of(&(&gram + &shift)), Definiteness::PositiveDefinite);
        assert_eq!(of(&(&gram - &shift)), Definiteness::Indefinite);
    }
}

/// A P-matrix has exactly one solution for every q (CPS 3.3.7): compare with the number found by enumeration.
#[test]
fn p_matrices_have_one_solution_and_what_is_guaranteed_is_solved() {
    let mut random = seeded(83);
    let mut seen = [0; 4];
    for _ in 0..samples(3000) {
        let n = random.integer(1, 4) as usize;
        let m = DMatrix::from_fn(n, n, |i, j| random.integer(-2, 2) as f64 + if i == j { 2.0 } else { 0.0 });
        let class = MatrixClass::of(&m).unwrap();
        let q = DVector::from_fn(n, |_, _| random.integer(-3, 3) as f64);
        let lcp = Lcp::new(m, q).unwrap();
        let one_path = Settings::default().with_retries(0).with_enumerate_up_to(0);
        let solved = matches!(lcp.solve_with(&one_path), Outcome::Solved(_));
        let all = lcp.all_solutions().unwrap().solutions.len();
        let guarantee = class.guarantee();
        seen[guarantee as usize] += 1;
        match guarantee {
            Guarantee::UniqueSolution => assert!(solved && all == 1, "{lcp:?}: {all} solutions"),
            Guarantee::Solution => assert!(solved && all >= 1, "{lcp:?}"),
            Guarantee::SolutionIfFeasible => assert_eq!(solved, all >= 1, "{lcp:?}"),
            Guarantee::None => {}
        }
    }
    assert!(seen.iter().all(|count| *count > samples(10)), "{seen:?}");
}
