//! Larger problems are solved if they have a known solution by construction, with integer data and many ties.
#![allow(
    clippy::doc_markdown,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]

use crate::common::{samples, seeded};
use grasp_lcp::lcp::{Lcp, Outcome};
use nalgebra::{DMatrix, DVector};

/// Semidefinite M (A Aᵀ of any rank plus a skew part) with a known degenerate solution: Lemke's method must find a solution.
#[test]
fn semidefinite_problems_with_a_planted_solution_are_solved() {
    let mut random = seeded(89);
    for trial in 0..samples(300) {
        let n = 2 + trial % 60;
        let rank = random.integer(0, n as i64) as usize;
        let a = DMatrix::from_fn(n, rank, |_, _| random.integer(-2, 2) as f64);
        let b = DMatrix::from_fn(n, n, |_, _| random.integer(-1, 1) as f64);
        let m = &a * a.transpose() + (&b - b.transpose()) * (trial % 2) as f64;
        let kind: Vec<i64> = (0..n).map(|_| random.integer(0, 3)).collect();
        let z = DVector::from_fn(n, |i, _| if kind[i] == 0 { random.integer(1, 3) as f64 } else { 0.0 });
        let w = DVector::from_fn(n, |i, _| if kind[i] == 1 { random.integer(1, 3) as f64 } else { 0.0 });
        let lcp = Lcp::new(m.clone(), w - m * z).unwrap();
        match lcp.solve() {
            Outcome::Solved(solution) => {
                assert!(solution.residuals.within(1e-12), "{:?}", solution.residuals);
            }
            other => panic!("{trial} {n} {rank} {other:?}"),
        }
    }
}

/// M of any class with a known Farkas vector: the answer must be a valid proof.
#[test]
fn infeasible_problems_are_proved_infeasible() {
    let mut random = seeded(97);
    for trial in 0..samples(300) {
        let n = 1 + trial % 40;
        let y: Vec<i64> = (0..n).map(|i| if i + 1 == n { 1 } else { random.integer(0, 2) }).collect();
        let mut m = DMatrix::from_fn(n, n, |_, _| random.integer(-2, 2) as f64);
        let mut q = DVector::from_fn(n, |_, _| random.integer(-2, 3) as f64);
        for j in 0..n {
            let rest: f64 = (0..n - 1).map(|i| m[(i, j)] * y[i] as f64).sum();
            m[(n - 1, j)] = -rest - random.integer(0, 1) as f64;
        }
        let rest: f64 = (0..n - 1).map(|i| q[i] * y[i] as f64).sum();
        q[n - 1] = -rest - 1.0;
        let lcp = Lcp::new(m, q).unwrap();
        assert!(lcp.proves_infeasible(&DVector::from_fn(n, |i, _| y[i] as f64)));
        match lcp.solve() {
            Outcome::Infeasible(certificate) => assert!(lcp.proves_infeasible(&certificate.y)),
            other => panic!("trial {trial}, n = {n}: {other:?}"),
        }
    }
}

/// Planar contacts in Stewart and Trinkle's form, with different μ, some zero, or all equal. M is copositive, so a
/// solution is found.
#[test]
fn frictional_contacts_on_a_compliant_body_are_solved() {
    let mut random = seeded(101);
    for trial in 0..samples(200) {
        let contacts = 1 + trial % 12;
        let n = 4 * contacts;
        let j = DMatrix::from_fn(2 * contacts, 3, |_, _| random.integer(-2, 2) as f64);
        let w = &j * j.transpose() + DMatrix::identity(2 * contacts, 2 * contacts) * 0.25;
        let mut m = DMatrix::zeros(n, n);
        // Row 4i belongs to the normal force of contact i, rows 4i+1 and 4i+2 to the two friction directions, and row 4i+3 to the size of the slip.
        let index = |k: usize| {
            let (i, axis, sign) = match k % 4 {
                0 => (k / 4, 0, 1.0),
                1 => (k / 4, 1, 1.0),
                _ => (k / 4, 1, -1.0),
            };
            (2 * i + axis, sign)
        };
        for a in (0..n).filter(|a| a % 4 != 3) {
            for b in (0..n).filter(|b| b % 4 != 3) {
                let ((ia, sa), (ib, sb)) = (index(a), index(b));
                m[(a, b)] = sa * sb * w[(ia, ib)];
            }
        }
        let mut q = DVector::zeros(n);
        for i in 0..contacts {
            m[(4 * i + 3, 4 * i)] = [0.0, 0.5, 0.5, 2.0][random.integer(0, 3) as usize];
            for a in [1, 2] {
                m[(4 * i + 3, 4 * i + a)] = -1.0;
                m[(4 * i + a, 4 * i + 3)] = 1.0;
            }
            q[4 * i] = random.integer(-4, 1) as f64;
            q[4 * i + 1] = random.integer(-3, 3) as f64;
            q[4 * i + 2] = -q[4 * i + 1];
        }
        match Lcp::new(m, q).unwrap().solve() {
            Outcome::Solved(solution) => {
                assert!(solution.residuals.within(1e-12), "{:?}", solution.residuals);
            }
            other => panic!("{trial} {contacts} {other:?}"),
        }
    }
}
