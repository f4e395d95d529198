//! The check of Farkas vectors has no rounding errors: it agrees with rational arithmetic on the given doubles.
#![allow(clippy::doc_markdown)]

use crate::common::{Random, assert_met, samples, seeded};
use grasp_lcp::lcp::{Lcp, Outcome};
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::{FromPrimitive, Signed, ToPrimitive, Zero};

fn exact(x: f64) -> BigRational {
    BigRational::from_f64(x).expect("finite")
}

fn times(column: impl Iterator<Item = f64>, y: &DVector<f64>) -> BigRational {
    column.zip(y).fold(BigRational::zero(), |sum, (m, y)| sum + exact(m) * exact(*y))
}

/// What the vector y proves in rational arithmetic: whether the problem is infeasible, and otherwise a lower bound on the sum of the entries of z.
fn shown(m: &DMatrix<f64>, q: &DVector<f64>, y: &DVector<f64>) -> (bool, f64) {
    let descent = times(q.iter().copied(), y);
    if !descent.is_negative() {
        return (false, 0.0);
    }
    let worst = (0..q.len()).map(|j| times(m.column(j).iter().copied(), y)).max().expect("not empty");
    if !worst.is_positive() {
        return (true, f64::INFINITY);
    }
    (false, (-descent / worst).to_f64().unwrap_or(f64::INFINITY))
}

/// A random number of any size, sometimes zero.
fn wild(random: &mut Random, decades: i64) -> f64 {
    match random.integer(0, 5) {
        0 => 0.0,
        1 => random.integer(-3, 3) as f64,
        _ => random.normal() * 10f64.powi(i32::try_from(random.integer(-decades, decades)).expect("small")),
    }
}

#[test]
fn a_vector_proves_what_rationals_say() {
    let mut random = seeded(131);
    let (mut proofs, mut bounds) = (0, 0);
    for trial in 0..samples(1500) {
        let decades = [0, 3, 20, 150, 300][trial % 5];
        let n = 1 + trial % 4;
        let mut m = DMatrix::from_fn(n, n, |_, _| wild(&mut random, decades));
        let y = DVector::from_fn(n, |_, _| wild(&mut random, decades).abs());
        let mut q = DVector::from_fn(n, |_, _| wild(&mut random, decades));
        if trial % 3 == 0 {
            // Columns that are orthogonal to y, exactly or up to rounding.
            for j in 0..n {
                let rest: f64 = (1..n).map(|i| m[(i, j)] * y[i]).sum();
                let balanced = -rest / y[0];
                m[(0, j)] = if balanced.is_finite() { balanced } else { -1.0 };
            }
            q[0] = -q[0].abs();
        }
        let lcp = Lcp::new(m.clone(), q.clone()).expect("finite");
        let (proved, least) = shown(&m, &q, &y);
        assert_eq!(lcp.proves_infeasible(&y), proved, "{m} {q} {y}");
        let told = lcp.least_feasible(&y);
        assert!(told <= least, "{told} {least}");
        assert!(least > f64::MAX || told >= least * (1.0 - 1e-13), "{told} {least}");
        proofs += usize::from(proved);
        bounds += usize::from(!proved && least > 0.0);
    }
    assert_met(&[(proofs, 75), (bounds, 250)]);
}

/// Problems with random data that are reported as infeasible are infeasible in rational arithmetic. If a problem is reported as nearly infeasible,
/// the entries of any solution have at least the reported sum.
#[test]
fn no_proof_is_false() {
    let mut random = seeded(137);
    let (mut proofs, mut nearly) = (0, 0);
    for trial in 0..samples(1000) {
        let n = 1 + trial % 5;
        let decades = [0, 2, 32, 200][trial % 4];
        let rank = usize::try_from(random.integer(0, i64::try_from(n).expect("small"))).expect("positive");
        let a = DMatrix::from_fn(n, rank, |_, _| wild(&mut random, decades / 2));
        let m = if trial % 2 == 0 {
            &a * a.transpose()
        } else {
            DMatrix::from_fn(n, n, |_, _| wild(&mut random, decades))
        };
        let q = DVector::from_fn(n, |_, _| wild(&mut random, decades));
        if !m.iter().chain(&q).all(|x| x.is_finite()) {
            continue;
        }
        let lcp = Lcp::new(m.clone(), q.clone()).expect("finite");
        match lcp.solve() {
            Outcome::Infeasible(certificate) => {
                assert!(shown(&m, &q, &certificate.y).0, "{m} {q} {certificate:?}");
                proofs += 1;
            }
            Outcome::NearlyInfeasible(certificate) => {
                let (proved, least) = shown(&m, &q, &certificate.y);
                let told = lcp.least_feasible(&certificate.y);
                assert!(!proved && told <= least && least > 0.0, "{m} {q} {certificate:?}");
                nearly += 1;
            }
            _ => {}
        }
    }
    assert_met(&[(proofs, 100), (nearly, 12)]);
}

/// If a product underflows, rounded arithmetic would report a feasible problem as infeasible: z = (1e631, …) satisfies the constraints.
#[test]
fn underflow_proves_nothing() {
    let m = DMatrix::from_row_slice(2, 2, &[-2.0, 1.0, 1.5e-323, 0.0]);
    let lcp = Lcp::new(m, DVector::from_vec(vec![-1.0, -1.7e308])).expect("finite");
    let outcome = lcp.solve();
    assert!(!matches!(outcome, Outcome::Infeasible(_)), "{outcome:?}");
    assert!(!lcp.proves_infeasible(&DVector::from_vec(vec![0.0, 1.0])));
}
