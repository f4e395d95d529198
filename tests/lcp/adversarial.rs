//! Families of misleading problems cause no false proof, no false solution and no endless path. Rational arithmetic on the given doubles decides.
//!
//! `LCP_PROBLEMS=1000000 LCP_SEED=1 cargo test --release --test lcp adversarial -- --nocapture` sets the number of problems and the seed, and prints
//! the outcomes of each family.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::doc_markdown
)]

use crate::common::{Exact, Random, samples, seeded};
use grasp_lcp::lcp::{Basis, Lcp, Outcome, Parametric, PathEnd, Series, Settings};
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::{FromPrimitive, Signed};

/// Families of problems, by the construction of their entries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Family {
    /// Small integers: dense, sparse, skew, symmetric, Gram matrix, Gram matrix plus skew part, or nonnegative.
    Whole(usize),
    /// Integers, each times its own power of ten.
    Apart(i32),
    /// Integers, with rows and columns times powers of ten.
    Scaled(i32),
    /// Integers, with a last row that is linearly dependent on the others up to one part in 1e9 to 1e17.
    NearlySingular,
    /// q = w − M z for complementary z and w with common zeros, where large entries cancel.
    Degenerate,
    /// Doubles with random bits.
    Bits,
}

pub(crate) const FAMILIES: [Family; 16] = [
    Family::Whole(0),
    Family::Whole(1),
    Family::Whole(2),
    Family::Whole(3),
    Family::Whole(4),
    Family::Whole(5),
    Family::Whole(6),
    Family::Apart(3),
    Family::Apart(16),
    Family::Apart(32),
    Family::Apart(150),
    Family::Scaled(10),
    Family::Scaled(100),
    Family::NearlySingular,
    Family::Degenerate,
    Family::Bits,
];

/// An integer matrix with the structure of a kind.
fn whole(random: &mut Random, kind: usize, n: usize) -> DMatrix<f64> {
    let size = random.integer(1, 3);
    let keep = |random: &mut Random| kind != 1 || random.integer(0, 1) == 0;
    let a = DMatrix::from_fn(n, n, |_, _| {
        let entry = random.integer(-size, size) as f64;
        if keep(random) { entry } else { 0.0 }
    });
    match kind {
        2 => &a - a.transpose(),
        3 => &a + a.transpose(),
        4 => &a * a.transpose(),
        5 => {
            let skew = |i: usize, j: usize| f64::from(i8::from(i < j) - i8::from(i > j));
            &a * a.transpose() + DMatrix::from_fn(n, n, skew)
        }
        6 => a.abs(),
        _ => a,
    }
}

fn power(random: &mut Random, decades: i32) -> f64 {
    10f64.powi(random.integer(-i64::from(decades), i64::from(decades)) as i32)
}

pub(crate) fn problem(random: &mut Random, family: Family) -> (DMatrix<f64>, DVector<f64>) {
    let n = random.integer(1, 4) as usize;
    let kind = random.integer(0, 6) as usize;
    let small = |random: &mut Random| random.integer(-2, 2) as f64;
    match family {
        Family::Whole(kind) => (whole(random, kind, n), DVector::from_fn(n, |_, _| small(random))),
        Family::Apart(decades) => {
            let m = whole(random, kind, n).map(|m| m * power(random, decades));
            (m, DVector::from_fn(n, |_, _| small(random) * power(random, decades)))
        }
        Family::Scaled(decades) => {
            let [rows, columns] = [0, 1].map(|_| DVector::from_fn(n, |_, _| power(random, decades)));
            let m = whole(random, kind, n);
            let m = DMatrix::from_fn(n, n, |i, j| m[(i, j)] * rows[i] * columns[j]);
            (m, DVector::from_fn(n, |i, _| small(random) * rows[i]))
        }
        Family::NearlySingular => {
            let n = n.max(2);
            let mut m = whole(random, kind, n);
            let weights: Vec<f64> = (1..n).map(|_| small(random)).collect();
            for j in 0..n {
                m[(n - 1, j)] = (0..n - 1).map(|i| weights[i] * m[(i, j)]).sum();
            }
            let at = (random.integer(0, n as i64 - 1) as usize, random.integer(0, n as i64 - 1) as usize);
            let exponent = random.integer(9, 17) as i32;
            m[at] += if m[at] == 0.0 { 1.0 } else { m[at] } * 10f64.powi(-exponent);
            (m, DVector::from_fn(n, |_, _| small(random)))
        }
        Family::Degenerate => {
            let large = 10f64.powi(random.integer(0, 16) as i32).round();
            let mut m = whole(random, kind, n);
            let scaled = random.integer(0, n as i64 - 1) as usize;
            m.column_mut(scaled).scale_mut(large);
            let (mut z, mut w) = (DVector::zeros(n), DVector::zeros(n));
            for i in 0..n {
                match random.integer(0, 2) {
                    0 => z[i] = random.integer(1, 3) as f64,
                    1 => w[i] = random.integer(1, 3) as f64,
                    _ => {}
                }
            }
            let q = w - &m * z;
            (m, q)
        }
        Family::Bits => {
            let any = |random: &mut Random| {
                let x = f64::from_bits(random.bits());
                if x.is_finite() { x } else { 0.0 }
            };
            (DMatrix::from_fn(n, n, |_, _| any(random)), DVector::from_fn(n, |_, _| any(random)))
        }
    }
}

/// Counts of outcomes of a family.
#[derive(Debug, Default, Clone)]
pub(crate) struct Tally {
    pub(crate) solved: usize,
    /// Reported as solved, although the exact point of the reported basis violates a condition or does not exist.
    pub(crate) rounded: usize,
    /// Problems counted in `rounded` whose residuals are larger than rounding.
    pub(crate) coarse: usize,
    /// Reported as solved up to rounding, although no solution exists.
    pub(crate) unsolvable: usize,
    pub(crate) infeasible: usize,
    pub(crate) nearly: usize,
    pub(crate) without: usize,
    /// No result, although a solution exists.
    pub(crate) missed: usize,
    /// No result, and no solution exists.
    pub(crate) open: usize,
}

/// Whether z violates 0 ≤ z ⟂ w ≥ 0 by more than 2e-10 of the terms of a row, in rational arithmetic. For this comparison, z_j counts as its largest
/// contribution to the terms of any row.
fn violates(exact: &Exact, z: &[BigRational]) -> bool {
    let whole = |x: &num_bigint::BigInt| BigRational::from_integer(x.clone());
    let tolerance = BigRational::from_f64(2e-10).expect("finite");
    let products = |row: &Vec<num_bigint::BigInt>| -> Vec<BigRational> {
        row.iter().zip(z).map(|(m, z)| (whole(m) * z).abs()).collect()
    };
    let shares: Vec<Vec<BigRational>> = exact.m.iter().map(products).collect();
    let terms: Vec<BigRational> =
        shares.iter().zip(&exact.q).map(|(row, q)| row.iter().fold(whole(q).abs(), |a, b| a + b)).collect();
    let counts = |j: usize| shares.iter().zip(&terms).any(|(row, terms)| row[j] > &tolerance * terms);
    let w = exact.slack(z);
    z.iter().any(Signed::is_negative)
        || (0..z.len()).any(|i| {
            let least = &tolerance * &terms[i];
            w[i] < -&least || (w[i] > least && z[i].is_positive() && counts(i))
        })
}

/// Checks one answer.
pub(crate) fn judge(lcp: &Lcp, outcome: &Outcome, tally: &mut Tally) -> Result<(), String> {
    let exact = Exact::of(lcp.matrix(), lcp.vector());
    match outcome {
        Outcome::Solved(solution) => {
            tally.solved += 1;
            let alpha: Vec<usize> = solution.basis.iter().collect();
            let rational = |z: &f64| BigRational::from_f64(*z).expect("finite");
            let z: Vec<BigRational> = solution.z.iter().map(rational).collect();
            let holds =
                exact.is_solution(&z) || exact.exact_point(&alpha).is_some_and(|z| exact.is_solution(&z));
            if !holds {
                tally.rounded += 1;
                tally.unsolvable += usize::from(!exact.is_solvable());
                tally.coarse += usize::from(solution.residuals.max() > 1e-14);
                // A solution up to rounding exactly solves slightly different data. From residuals nothing more can be concluded.
                if violates(&exact, &z) {
                    return Err("a false solution".into());
                }
            }
        }
        Outcome::Infeasible(certificate) => {
            tally.infeasible += 1;
            if exact.is_feasible() || !lcp.proves_infeasible(&certificate.y) {
                return Err("a false proof".into());
            }
        }
        Outcome::NoBasis { .. } => {
            tally.without += 1;
            if exact.is_solvable() {
                return Err("a false exclusion".into());
            }
        }
        Outcome::NearlyInfeasible(_) => tally.nearly += 1,
        _ if exact.is_solvable() => tally.missed += 1,
        _ => tally.open += 1,
    }
    Ok(())
}

fn finite(m: &DMatrix<f64>, q: &DVector<f64>) -> bool {
    m.iter().chain(q).all(|x| x.is_finite())
}

#[test]
fn no_answer_says_more_than_is_known() {
    for (k, family) in FAMILIES.into_iter().enumerate() {
        let mut random = seeded(1000 + k as u64);
        let mut tally = Tally::default();
        for _ in 0..samples(1300 / FAMILIES.len()) {
            let (m, q) = problem(&mut random, family);
            if !finite(&m, &q) {
                continue;
            }
            let lcp = Lcp::new(m, q).expect("finite");
            let n = lcp.len();
            let start = Basis::from_indices(n, (0..n).filter(|_| random.integer(0, 1) == 0));
            let mut series = Series::new(lcp.matrix().clone(), Settings::default()).expect("finite");
            let other = DVector::from_fn(n, |_, _| random.integer(-2, 2) as f64);
            drop(series.solve(&other));
            let outcomes = [
                lcp.solve(),
                lcp.solve_from(&start, &Settings::default()),
                series.solve(lcp.vector()).expect("finite").into_outcome(),
            ];
            let mut others = Tally::default();
            for (k, outcome) in outcomes.iter().enumerate() {
                if let Err(fault) = judge(&lcp, outcome, if k == 0 { &mut tally } else { &mut others }) {
                    panic!("{fault}: {lcp:?} {outcome:?}");
                }
            }
        }
        println!("{family:?}: {tally:?}");
        if matches!(family, Family::Whole(_)) {
            let Tally { unsolvable, coarse, nearly, missed, open, .. } = tally;
            assert_eq!([unsolvable, coarse, nearly, missed, open], [0; 5], "{family:?}");
        }
    }
}

/// A path has at most one piece for each of its 2ⁿ bases before a cycle is detected.
#[test]
fn every_parametric_path_ends() {
    for (k, family) in FAMILIES.into_iter().enumerate() {
        let mut random = seeded(2000 + k as u64);
        let (mut loops, mut longest) = (0, 0);
        for _ in 0..samples(1300 / FAMILIES.len()) {
            let (m, q) = problem(&mut random, family);
            let dq = DVector::from_fn(q.len(), |_, _| random.integer(-2, 2) as f64);
            if !finite(&m, &q) {
                continue;
            }
            let lcp = Lcp::new(m, q).expect("finite");
            let mut path = Parametric::new(&lcp, &dq, Settings::default()).expect("finite");
            longest = longest.max(path.by_ref().count());
            let end = path.end().expect("it has ended");
            assert_ne!(*end, PathEnd::PivotLimit, "{family:?} {lcp:?} {dq:?}");
            loops += usize::from(*end == PathEnd::Loop);
        }
        println!("{family:?}: {loops} loops, {longest} breakpoints at most");
        assert!(longest <= 3 * 16, "{family:?}");
    }
}
