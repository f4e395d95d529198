//! Every solvable problem of the literature is solved, and every infeasible one is proved infeasible.
#![allow(
    clippy::doc_markdown,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]

use crate::common::published::{Known, small};
use crate::common::{Integers, samples, seeded};
use grasp_lcp::lcp::{Lcp, Outcome, Solution};
use nalgebra::{DMatrix, DVector};
use std::cmp::Ordering;

fn solved(name: &str, lcp: &Lcp) -> Solution {
    match lcp.solve() {
        Outcome::Solved(solution) => {
            assert!(solution.residuals.within(1e-12), "{name}: {:?}", solution.residuals);
            assert!(lcp.residuals(&solution.z).within(1e-12), "{name}");
            assert!(solution.z.iter().chain(&solution.w).all(|x| *x >= 0.0), "{name}");
            solution
        }
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn small_problems_end_as_exact_arithmetic_says() {
    for (source, problem, known) in small() {
        assert_eq!(problem.exact().is_feasible(), known != Known::Infeasible, "{source}");
        assert_eq!(problem.exact().is_solvable(), known == Known::Solvable, "{source}");
        let lcp = problem.problem();
        match (lcp.solve(), known) {
            (Outcome::Solved(solution), Known::Solvable) => {
                assert!(solution.residuals.within(1e-14), "{source}: {solution:?}");
                let alpha: Vec<usize> = solution.basis.iter().collect();
                if let Some(z) = problem.exact().exact_point(&alpha) {
                    assert!(problem.exact().is_solution(&z), "{source}: {solution:?}");
                }
            }
            (Outcome::Infeasible(certificate), Known::Infeasible) => {
                assert!(lcp.proves_infeasible(&certificate.y), "{source}");
            }
            (Outcome::NoBasis { .. }, Known::Without) => {}
            (outcome, known) => panic!("{source} {known:?} {outcome:?}"),
        }
    }
}

#[test]
fn all_three_solutions_of_handbook_10_2_2_and_of_10_2_4_are_listed() {
    let problems = small();
    let count = |at: usize| problems[at].1.problem().all_solutions().unwrap().solutions;
    // The solutions of problem 10.2.2 are (1, 0), (0, 1) and (1/2, 1/2). The last one lies on a singular basis between the first two, so it may be
    // missing.
    assert!(count(1).len() >= 2);
    let games = count(3);
    assert_eq!(games.len(), 3);
    let mixed = games.iter().find(|s| s.z.iter().all(|z| *z > 0.0)).expect("the mixed equilibrium");
    for (z, expected) in mixed.z.iter().zip([1.0 / 90.0, 2.0 / 45.0, 1.0 / 90.0, 2.0 / 45.0]) {
        assert!((z - expected).abs() < 1e-15);
    }
}

/// Murty 1978: M has 1 on the diagonal and 2 below it. With q_i = −2ⁿ − 2ⁿ⁻¹ − … (i terms) Lemke's method takes about 2ⁿ pivots.
#[test]
fn murtys_exponential_family_ends_honestly() {
    for n in 1..=24 {
        let m = DMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            Ordering::Equal => 1.0,
            Ordering::Greater => 2.0,
            Ordering::Less => 0.0,
        });
        let q = DVector::from_fn(n, |i, _| -(0..=i).map(|k| 2.0_f64.powi((n - k) as i32)).sum::<f64>());
        match Lcp::new(m, q).unwrap().solve() {
            Outcome::Solved(solution) => {
                // The known solution is z = (2ⁿ, 0, …, 0).
                assert!((solution.z[0] / 2.0_f64.powi(n as i32) - 1.0).abs() < 1e-12, "n = {n}");
                assert!(solution.z.iter().skip(1).all(|z| *z == 0.0), "n = {n}: {:?}", solution.z);
            }
            Outcome::PivotLimit { pivots } => assert!(n > 13 && pivots >= 10_000, "n = {n}: {pivots} pivots"),
            other => panic!("n = {n}: {other:?}"),
        }
    }
}

/// With q = −1 the same matrices are easy for Lemke's method: z = (1, 0, …) for the lower, (0, …, 1) for the upper triangle.
#[test]
fn murtys_matrices_with_q_minus_one() {
    for n in [1, 2, 5, 10, 50, 100, 200] {
        let q = DVector::from_element(n, -1.0);
        let upper = DMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            Ordering::Equal => 1.0,
            Ordering::Less => 2.0,
            Ordering::Greater => 0.0,
        });
        let z = solved("upper", &Lcp::new(upper.clone(), q.clone()).unwrap()).z;
        assert!((z[n - 1] - 1.0).abs() < 1e-12 && z.sum() < 1.0 + 1e-12, "n = {n}");
        let z = solved("lower", &Lcp::new(upper.transpose(), q).unwrap()).z;
        assert!((z[0] - 1.0).abs() < 1e-12 && z.sum() < 1.0 + 1e-12, "n = {n}");
    }
}

/// Fathi 1979: M = L Lᵀ with Murty's L, q = −1: z = (1, 0, …, 0).
#[test]
fn fathis_family() {
    for n in [1, 2, 5, 10, 50, 100, 200] {
        let l = DMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            Ordering::Equal => 1.0,
            Ordering::Greater => 2.0,
            Ordering::Less => 0.0,
        });
        let lcp = Lcp::new(&l * l.transpose(), DVector::from_element(n, -1.0)).unwrap();
        let z = solved("Fathi", &lcp).z;
        assert!((z[0] - 1.0).abs() < 1e-10 && z.iter().skip(1).all(|z| *z < 1e-10), "n = {n}: {z:?}");
    }
}

/// Ahn 1983: tridiagonal (1, 4, −2), q = −1.
#[test]
fn ahns_family() {
    for n in [1, 2, 10, 50, 100, 200] {
        let m = DMatrix::from_fn(n, n, |i, j| match j as i64 - i as i64 {
            0 => 4.0,
            1 => -2.0,
            -1 => 1.0,
            _ => 0.0,
        });
        solved("Ahn", &Lcp::new(m, DVector::from_element(n, -1.0)).unwrap());
    }
}

/// Csizmadia: 1 on the diagonal, −1 below; a P-matrix whose handicap grows like 4ⁿ. z_i = 2^(i−1) for q = −1.
#[test]
fn csizmadias_family() {
    for n in [1, 2, 10, 30, 50] {
        let m = DMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
            Ordering::Equal => 1.0,
            Ordering::Greater => -1.0,
            Ordering::Less => 0.0,
        });
        let z = solved("Csizmadia", &Lcp::new(m, DVector::from_element(n, -1.0)).unwrap()).z;
        for i in 0..n {
            assert!((z[i] / 2.0_f64.powi(i as i32) - 1.0).abs() < 1e-12, "n = {n}, i = {i}");
        }
    }
}

/// A string over an obstacle: −z'' + 1 ≥ 0 above a parabola, the model free-boundary problem.
#[test]
fn free_boundary_problems() {
    for n in [1, 2, 3, 10, 50, 100, 200] {
        let h = 1.0 / (n as f64 + 1.0);
        let m = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        });
        let obstacle = DVector::from_fn(n, |i, _| 0.5 - 8.0 * ((i as f64 + 1.0) * h - 0.45).powi(2));
        let lcp = Lcp::new(m.clone(), &m * &obstacle + DVector::from_element(n, h * h)).unwrap();
        let solution = solved("obstacle", &lcp);
        let contact = (0..n).filter(|i| !solution.basis.contains(*i)).count();
        assert!(n < 10 || (contact > 0 && contact < n), "n = {n}: {contact} points touch");
    }
}

/// Implicit time steps of an American put (Black–Scholes operator, strike 1), n = 100.
#[test]
fn american_put() {
    let (n, sigma, rate, dt) = (100, 0.3, 0.05, 0.02);
    let payoff = DVector::from_fn(n, |i, _| (1.0 - (i as f64 + 1.0) * 0.02).max(0.0));
    let operator = DMatrix::from_fn(n, n, |i, j| {
        let s = i as f64 + 1.0;
        let diffusion = 0.5 * sigma * sigma * s * s * dt;
        match j as i64 - i as i64 {
            0 => 1.0 + 2.0 * diffusion + rate * dt,
            1 => -diffusion - 0.5 * rate * s * dt,
            -1 => -diffusion + 0.5 * rate * s * dt,
            _ => 0.0,
        }
    });
    let mut value = payoff.clone();
    for step in 0..25 {
        // One implicit time step: the new option value is payoff + z, and w is the residual of the discretised equation for it, `operator · (payoff +
        // z) − value`.
        let mut q = &operator * &payoff - &value;
        q[0] -= 0.5 * sigma * sigma * dt - 0.5 * rate * dt;
        let solution = solved("put", &Lcp::new(operator.clone(), q).unwrap());
        let next = &payoff + &solution.z;
        assert!((&next - &value).min() > -1e-12, "{step}");
        value = next;
    }
}

/// Bimatrix games with random integer costs: M = [0, A; Bᵀ, 0] with positive entries, q = −1. There always is an equilibrium.
#[test]
fn bimatrix_games_have_equilibria() {
    let mut random = seeded(41);
    for trial in 0..samples(200) {
        let (r, c) = (1 + trial % 8, 1 + trial % 5);
        let n = r + c;
        let m =
            DMatrix::from_fn(n, n, |i, j| if (i < r) == (j < r) { 0.0 } else { random.integer(1, 9) as f64 });
        let lcp = Lcp::new(m, DVector::from_element(n, -1.0)).unwrap();
        let solution = solved("game", &lcp);
        assert!(solution.z.rows(0, r).sum() > 0.0 && solution.z.rows(r, c).sum() > 0.0);
    }
}

/// Subset sum as a complementarity problem (Chung 1989 shows NP-completeness this way): x_i ∈ {0, 1} since −x_i + 1 ≥ 0 is complementary
/// to x_i, and Σ a_i x_i = b by two rows.
#[test]
fn subset_sums_are_decided() {
    let mut random = seeded(43);
    let mut solvable = 0;
    for _ in 0..samples(60) {
        let k = random.integer(2, 4) as usize;
        let n = k + 2;
        let weights: Vec<i64> = (0..k).map(|_| random.integer(1, 9)).collect();
        let total: i64 = weights.iter().sum();
        let goal = random.integer(1, total);
        let mut m = vec![0; n * n];
        let mut q = vec![1; n];
        for i in 0..k {
            m[i * n + i] = -1;
            m[k * n + i] = weights[i];
            m[(k + 1) * n + i] = -weights[i];
        }
        m[k * n + k] = -(n as i64);
        m[(k + 1) * n + k + 1] = -(n as i64);
        (q[k], q[k + 1]) = (-goal, goal);
        let problem = Integers { n, m, q };
        let expected = problem.exact().is_solvable();
        solvable += usize::from(expected);
        match problem.problem().solve() {
            Outcome::Solved(solution) => assert!(expected && solution.residuals.within(1e-12), "{problem:?}"),
            Outcome::Infeasible(_) | Outcome::NoBasis { .. } => assert!(!expected, "{problem:?}"),
            other => panic!("{problem:?} {other:?}"),
        }
    }
    assert!((samples(10)..samples(50)).contains(&solvable), "{solvable} solvable");
}
