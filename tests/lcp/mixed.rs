//! Mixed problems, with free variables and equality rows, are solved.

use crate::common::{samples, seeded};
use grasp_lcp::lcp::{LcpError, MixedLcp, Outcome};
use nalgebra::{DMatrix, DVector};

/// The optimality conditions of min ½ xᵀHx + gᵀx, E x = e, x ≥ 0: A = 0, C = E, D = −Eᵀ, M = H.
fn program(h: &DMatrix<f64>, g: &DVector<f64>, e: &DMatrix<f64>, rhs: &DVector<f64>) -> MixedLcp {
    let zero = DMatrix::zeros(e.nrows(), e.nrows());
    MixedLcp::new(&zero, e, &-e.transpose(), h, &-rhs, g).expect("sizes match")
}

#[test]
fn quadratic_programs_with_equalities_are_solved() {
    let mut random = seeded(17);
    for trial in 0..samples(300) {
        let n = 2 + trial % 9;
        let m = 1 + trial % n.min(4);
        let a = DMatrix::from_fn(n, n, |_, _| random.normal());
        // Every third Hessian is zero: a linear program, bounded since g ≥ 0.
        let h = if trial % 3 == 0 { DMatrix::zeros(n, n) } else { &a * a.transpose() };
        let g = DVector::from_fn(n, |_, _| random.uniform());
        let e = DMatrix::from_fn(m, n, |_, _| random.integer(-2, 3) as f64);
        let feasible = DVector::from_fn(n, |_, _| random.integer(0, 2) as f64);
        let problem = program(&h, &g, &e, &(&e * &feasible));
        let Outcome::Solved(solution) = problem.solve() else { panic!("{problem:?}") };
        assert!(solution.residuals.max() < 1e-12, "{:?}", solution.residuals);
        assert!((problem.residuals(&solution.u, &solution.z).max() - solution.residuals.max()).abs() < 1e-12);
        let cost = |x: &DVector<f64>| 0.5 * (x.transpose() * &h * x)[0] + g.dot(x);
        assert!(cost(&solution.z) <= cost(&feasible) + 1e-9);
    }
}

#[test]
fn a_regular_block_is_eliminated_like_a_schur_complement() {
    let mut random = seeded(23);
    for _ in 0..samples(200) {
        let (m, n) = (3, 5);
        let block = DMatrix::from_fn(m + n, m + n, |_, _| random.normal());
        let k = &block * block.transpose();
        let v = DVector::from_fn(m + n, |_, _| random.normal());
        let part = |i, j, r, c| k.view((i, j), (r, c)).into_owned();
        let (a, c, d, mm) = (part(0, 0, m, m), part(0, m, m, n), part(m, 0, n, m), part(m, m, n, n));
        let (b, q) = (v.rows(0, m).into_owned(), v.rows(m, n).into_owned());
        let Outcome::Solved(solution) = MixedLcp::new(&a, &c, &d, &mm, &b, &q).unwrap().solve() else {
            panic!("positive definite")
        };
        let inverse = a.clone().try_inverse().unwrap();
        let reduced = grasp_lcp::lcp::Lcp::new(&mm - &d * &inverse * &c, &q - &d * &inverse * &b).unwrap();
        let Outcome::Solved(expected) = reduced.solve() else { panic!("positive definite") };
        assert_eq!(solution.basis, expected.basis);
        assert!((&solution.z - &expected.z).amax() <= 1e-9 * (1.0 + expected.z.amax()));
    }
}

#[test]
fn a_free_variable_that_nothing_determines_is_named() {
    // The second free variable has a zero row and column.
    let a = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.0]);
    let c = DMatrix::from_row_slice(2, 1, &[1.0, 0.0]);
    let d = DMatrix::from_row_slice(1, 2, &[-1.0, 0.0]);
    let m = DMatrix::from_element(1, 1, 1.0);
    let problem = |b2: f64| {
        MixedLcp::new(&a, &c, &d, &m, &DVector::from_vec(vec![1.0, b2]), &DVector::from_element(1, -3.0))
            .unwrap()
    };
    let Outcome::Solved(solution) = problem(0.0).solve() else { panic!("solvable") };
    assert_eq!((solution.undetermined, solution.dependent), (vec![1], vec![1]));
    assert!((solution.z[0] - 1.0).abs() < 1e-15 && (solution.u[0] + 2.0).abs() < 1e-15);

    // 0 = 1 in the second row.
    let unsolvable = problem(1.0);
    let Outcome::Infeasible(certificate) = unsolvable.solve() else { panic!("0 = 1") };
    assert!(unsolvable.proves_infeasible(&certificate.y));
    assert!(!problem(0.0).proves_infeasible(&certificate.y));
}

#[test]
fn blocks_that_do_not_fit_are_refused() {
    let (one, two) = (DMatrix::zeros(1, 1), DMatrix::zeros(2, 2));
    let (v1, v2) = (DVector::zeros(1), DVector::zeros(2));
    assert!(MixedLcp::new(&one, &one, &one, &one, &v1, &v1).is_ok());
    assert!(MixedLcp::new(&two, &one, &one, &one, &v1, &v1).is_err());
    assert!(MixedLcp::new(&one, &two, &one, &one, &v1, &v1).is_err());
    assert!(MixedLcp::new(&one, &one, &two, &one, &v1, &v1).is_err());
    assert!(MixedLcp::new(&one, &one, &one, &two, &v1, &v1).is_err());
    assert!(MixedLcp::new(&one, &one, &one, &one, &v2, &v1).is_err());
    assert!(MixedLcp::new(&one, &one, &one, &one, &v1, &v2).is_err());
    let error =
        MixedLcp::new(&one, &one, &DMatrix::from_element(1, 1, f64::NAN), &one, &v1, &v1).unwrap_err();
    let LcpError::MatrixEntry { what: "D", row: 0, column: 0, value } = error else { panic!("{error}") };
    assert!(value.is_nan());
}

/// Contradictory equalities with a singular A are infeasible, even if quotients of rounding errors satisfy them up to rounding.
#[test]
fn quotients_of_noise_are_no_solution() {
    let rows = |n: usize, m: usize, entries: &[f64]| DMatrix::from_row_slice(n, m, entries);
    let one = |x: f64| DVector::from_element(1, x);
    let by_symmetric_block = MixedLcp::new(
        &rows(3, 3, &[11.0, 3.0, 6.0, 3.0, 19.0, 18.0, 6.0, 18.0, 18.0]),
        &rows(3, 1, &[2.0, -2.0, 0.0]),
        &rows(1, 3, &[-2.0, 2.0, 0.0]),
        &rows(1, 1, &[0.0]),
        &DVector::from_vec(vec![1.0, 0.0, 1.0]),
        &one(-2.0),
    );
    // The second unknown is 1/2, far above the rounding errors of the others.
    let beside_a_clear_value = MixedLcp::new(
        &rows(3, 3, &[1.0, 2.0, -1.0, -1.0, 1.0, -2.0, 0.0, 2.0, 0.0]),
        &rows(3, 1, &[0.0, 1.0, 0.0]),
        &rows(1, 3, &[-2.0, 1.0, -1.0]),
        &rows(1, 1, &[1.0]),
        &DVector::from_vec(vec![-2.0, 1.0, -1.0]),
        &one(-2.0),
    );
    for problem in [by_symmetric_block, beside_a_clear_value].map(Result::unwrap) {
        let outcome = problem.solve();
        let Outcome::Infeasible(certificate) = &outcome else { panic!("{outcome}") };
        assert!(problem.proves_infeasible(&certificate.y));
    }
}
