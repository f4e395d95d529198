//! Blocks that are singular except for rounding must not be accepted as solutions.
//!
//! The kinematic form of a grasp that cannot be held has no solution. Some of its complementary blocks are singular, with computed determinants of
//! 1e-16 instead of zero. A z of 1e13 in such a basis satisfies every row to a small fraction of its terms. It may even solve the given data exactly.
//! So whatever the solver reports as solved is checked in rational arithmetic.

use grasp_lcp::lcp::{Basis, Lcp, Outcome, Series, Settings};
use grasp_lcp::{PolygonCone, planar};
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::Signed;
use support::elimination::Eliminated;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Two or three fingers around the origin. Their stiffnesses differ by up to `decades` powers of ten.
fn grasp(numbers: &mut Random, n: usize, decades: f64) -> planar::Grasp {
    let contacts = (0..n).map(|_| {
        let (y, x) = (std::f64::consts::TAU * numbers.uniform()).sin_cos();
        let stiffness = [0, 1].map(|_| 10_f64.powf(decades * (numbers.uniform() - 0.5)));
        let point = [x + 0.3 * numbers.signed(), y];
        let normal = [-x + 0.5 * numbers.signed(), -y + 0.5 * numbers.signed()];
        planar::Contact::new(point, normal)
            .series_stiffness(stiffness[0], stiffness[1])
            .friction(2.0 * numbers.uniform())
            .command([0.1 * numbers.uniform(), 0.05 * numbers.signed()])
    });
    planar::Grasp::new(contacts.collect::<Vec<_>>()).unwrap()
}

/// Whether the basis solves the problem exactly, in rational arithmetic on the given doubles.
fn solves_exactly(lcp: &Lcp, basis: &Basis) -> bool {
    let exact = |x: f64| BigRational::from_float(x).expect("finite");
    let (m, q) = (lcp.matrix(), lcp.vector());
    let alpha: Vec<usize> = basis.iter().collect();
    let row = |i: &usize| alpha.iter().map(|j| exact(m[(*i, *j)])).chain([-exact(q[*i])]).collect();
    let Some(z) = Eliminated::of(alpha.iter().map(row), alpha.len()).solution() else { return false };
    let slack = |i: usize| {
        let terms = alpha.iter().zip(&z).map(|(j, z)| exact(m[(i, *j)]) * z);
        terms.fold(exact(q[i]), |sum, term| sum + term)
    };
    !z.iter().any(Signed::is_negative) && (0..lcp.len()).all(|i| basis.contains(i) || !slack(i).is_negative())
}

#[test]
fn what_is_called_solved_without_an_equilibrium_solves_the_data_exactly() {
    let mut numbers = seeded(7);
    let (mut without, mut solved, mut missed) = (0, 0, 0);
    for scene in 0..samples(375) {
        let grasp = grasp(&mut numbers, 2 + scene % 2, if scene % 4 < 2 { 0.5 } else { 6.0 });
        let pull = [0.1 * numbers.signed(), 0.1 * numbers.signed()];
        let load = planar::Wrench::new(pull, 0.05 * numbers.signed());
        let holds = grasp.solve(load).expect("a load in range").equilibrium().is_some();
        without += usize::from(!holds);
        let form = grasp.kinematic_form(load, &PolygonCone::default()).expect("a load in range");
        let Some(form) = form else { continue };
        match form.lcp.solve() {
            Outcome::Solved(solution) if !holds => {
                assert!(solves_exactly(&form.lcp, &solution.basis), "scene {scene}: {solution:?}");
                solved += 1;
            }
            Outcome::Solved(_) => {}
            _ => missed += usize::from(holds),
        }
    }
    assert_met(&[(without, 125)]);
    assert!(solved < without / 50, "{solved} {without}");
    assert_eq!(missed, 0);
}

/// Regular blocks with zeros and with entries of very different sizes are not reported as singular. Each problem has one solution in closed form.
#[test]
fn entries_far_apart_are_solved_or_left_open_and_never_denied() {
    let rows = |n: usize, m: &[f64], q: &[f64]| {
        Lcp::new(DMatrix::from_row_slice(n, n, m), DVector::from_row_slice(q)).expect("finite")
    };
    let mut solved = 0;
    let mut all = 0;
    let mut judge = |lcp: &Lcp, z: &[f64]| {
        all += 1;
        if let Outcome::Solved(solution) = lcp.solve() {
            solved += 1;
            for (found, z) in solution.z.iter().zip(z) {
                assert!((found - z).abs() <= 1e-9 * z.abs().max(1e-300), "{:?} {z:?}", solution.z);
            }
        }
        let listed = lcp.all_solutions().expect("small").solutions;
        assert_eq!(listed.len(), 1);
    };
    for exponent in [-30, -32, -60, -120, -250] {
        let tiny = 10f64.powi(exponent);
        judge(&rows(2, &[1.0, -1.0, 0.0, 1.0], &[tiny, -1.0]), &[1.0, 1.0]);
    }
    judge(
        &rows(3, &[2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 2.0], &[-1.0, 1e-60, 1e-60]),
        &[0.75, 0.5, 0.25],
    );
    judge(
        &rows(3, &[1e-8, 0.0, -1.0, 0.0, -1e8, 1e-8, 0.0, 1.0, 0.0], &[1e-8, 1e-8, -1.0]),
        &[1e24, 1.0, 1e16],
    );
    assert_eq!(solved, all);
}

/// In rows with terms of 1e14 the solver does not take a value of 3 for rounding, nor a slack of -6 for a tie, for any basis at the start of the
/// path.
#[test]
fn small_values_beside_large_terms_are_told_from_noise() {
    let check = |m: &[f64], q: &[f64], z: &[f64]| {
        let n = q.len();
        let m = DMatrix::from_row_slice(n, n, m);
        let q = DVector::from_row_slice(q);
        let lcp = Lcp::new(m.clone(), q.clone()).expect("finite");
        let mut series = Series::new(m, Settings::default()).expect("finite");
        let outcomes = (0..1_u32 << n).map(|bits| {
            let start = Basis::from_indices(n, (0..n).filter(|i| bits >> i & 1 == 1));
            lcp.solve_from(&start, &Settings::default())
        });
        let by_series = series.solve(&q).expect("finite").into_outcome();
        for outcome in outcomes.chain([lcp.solve(), by_series]) {
            let solution = outcome.solution().unwrap_or_else(|| panic!("{outcome}"));
            // The rounding of the largest term.
            let rounding = f64::EPSILON * 4e14;
            assert!(
                solution.z.iter().zip(z).all(|(found, z)| (found - z).abs() <= rounding),
                "{}",
                solution.z
            );
        }
    };
    check(&[2e14, 0.0, 1e14, 2.0], &[-2e14, -1e14 - 6.0], &[1.0, 3.0]);
    check(&[4e14, 0.0, 1e14, 5.0], &[-8e14, -2e14 - 10.0], &[2.0, 2.0]);
}
