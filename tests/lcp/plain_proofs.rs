//! Proofs of infeasibility have few rows and short numbers. Problems with entries sixteen orders of magnitude apart are decided as in rational
//! arithmetic.

use grasp_lcp::lcp::{Lcp, Outcome};
use nalgebra::{DMatrix, DVector};
use support::exact_lcp::Exact;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

fn problem(m: &[f64], q: &[f64]) -> Lcp {
    Lcp::new(DMatrix::from_row_slice(q.len(), q.len(), m), DVector::from_column_slice(q)).expect("square")
}

fn proof(lcp: &Lcp) -> Vec<f64> {
    let outcome = lcp.solve();
    let Outcome::Infeasible(certificate) = outcome else { panic!("{outcome}") };
    assert!(lcp.proves_infeasible(&certificate.y));
    certificate.y.as_slice().to_vec()
}

/// The first row alone is infeasible, and the proof uses only this row.
#[test]
fn one_row_is_enough() {
    let lcp = problem(&[-1.0, -3.0, -1e-3, 2.0, 1.0, 1.0, 0.3, 0.7, -0.1], &[-1.0, 1.0, -1.0]);
    assert_eq!(proof(&lcp), [1.0, 0.0, 0.0]);
}

/// w₀ = z₀ − 3 z₁ − 1 and w₁ = −2 z₀ + 5 z₁. The vector y = (1, t) proves that no z ≥ 0 has w ≥ 0, for every t from 1/2 to 3/5. The reported ratio t
/// has few binary digits.
#[test]
fn two_rows_have_a_ratio_of_few_digits() {
    let y = proof(&problem(&[1.0, -3.0, 0.0, -2.0, 5.0, 0.0, 1.0, 1.0, 1.0], &[-1.0, 0.0, 1.0]));
    assert!(y[2] == 0.0 && (y[1] / y[0] * 1024.0).fract() == 0.0, "{y:?}");
}

/// If only one ratio of the entries of y gives a proof and this ratio is not a double, both entries are taken from the data.
#[test]
fn a_ratio_that_is_no_double_is_one_of_two_entries() {
    let y = proof(&problem(&[3.0, -3.0, -7.0, 7.0], &[-1.0, 0.0]));
    assert_eq!(y[1] / y[0], 3.0 / 7.0);
}

/// The second row needs z₀ ≥ 469.7, and the third row then z₂ = 9e11 z₀. The basis matrix is singular, but solutions with this basis exist.
#[test]
fn a_corner_of_a_singular_piece_is_found() {
    let rows = [
        [0.0, 0.0, 0.0, -3.75],
        [0.00528, -1395.0, 0.0, -7e-4],
        [-4.07e7, 0.345, 4.3e-5, 3.9e-8],
        [-3.45e4, 6.3e7, 1.35e6, -25.0],
    ];
    let lcp = problem(rows.as_flattened(), &[0.0, -2.48, 0.55, 3.4e-7]);
    let outcome = lcp.solve();
    let solution = outcome.solution().unwrap_or_else(|| panic!("{outcome}"));
    assert!(lcp.residuals(&solution.z).max() <= 1e-10);
    assert!(solution.z[0] >= 469.0 && solution.z[3] == 0.0);
}

/// With entries from 1e-8 to 1e8 and zeros, problems with a solution in rational arithmetic are solved, and `NoBasis` is returned only for feasible problems.
#[test]
fn entries_far_apart_are_decided_as_rationals_decide() {
    let mut random = seeded(97);
    let (mut solved, mut infeasible, mut none, mut open) = (0, 0, 0, 0);
    for trial in 0..samples(3000) {
        let n = random.index(1, 4);
        let entry = |random: &mut Random| {
            let sign = if random.uniform() < 0.5 { -1.0 } else { 1.0 };
            if random.uniform() < 0.35 { 0.0 } else { sign * 10.0_f64.powf(16.0 * random.uniform() - 8.0) }
        };
        let m = DMatrix::from_fn(n, n, |_, _| entry(&mut random));
        let q =
            DVector::from_fn(
                n,
                |_, _| if random.uniform() < 0.5 { random.normal() } else { entry(&mut random) },
            );
        let lcp = Lcp::new(m.clone(), q.clone()).expect("square");
        let exact = || Exact::of(&m, &q);
        match lcp.solve() {
            Outcome::Solved(_) => solved += 1,
            Outcome::Infeasible(certificate) => {
                assert!(lcp.proves_infeasible(&certificate.y), "{trial}");
                infeasible += 1;
            }
            Outcome::NoBasis { .. } => {
                assert!(!exact().is_solvable() && exact().is_feasible(), "{trial} {m} {q}");
                none += 1;
            }
            other => {
                assert!(!exact().is_solvable(), "{trial} {m} {q} {other}");
                open += 1;
            }
        }
    }
    println!("{solved} solved, {infeasible} infeasible, {none} without a basis, {open} open");
    assert_met(&[(solved, 1000), (infeasible, 500), (none, 100)]);
    assert!(open < samples(30));
}
