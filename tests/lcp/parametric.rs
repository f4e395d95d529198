//! Paths of q₀ + τ dq, series with one matrix, and warm starts give the same solutions as separate problems.
#![allow(clippy::doc_markdown, clippy::cast_possible_truncation, clippy::cast_sign_loss)]

use crate::common::{Random, samples, seeded};
use grasp_lcp::lcp::{
    Basis, Lcp, Outcome, OutcomeView, Parametric, PathEnd, Series, Settings, Solution, Trend, Workspace,
};
use nalgebra::{DMatrix, DVector};

fn definite(n: usize, random: &mut Random) -> DMatrix<f64> {
    let a = DMatrix::from_fn(n, n, |_, _| random.normal());
    let skew = DMatrix::from_fn(n, n, |_, _| random.normal());
    &a * a.transpose() + DMatrix::identity(n, n) + &skew - skew.transpose()
}

fn vector(n: usize, random: &mut Random) -> DVector<f64> {
    DVector::from_fn(n, |_, _| random.normal())
}

fn solution(lcp: &Lcp) -> Solution {
    let Outcome::Solved(solution) = lcp.solve() else { panic!("positive definite") };
    solution
}

#[test]
fn on_a_definite_matrix_the_path_goes_forward_through_every_solution() {
    let mut random = seeded(61);
    for trial in 0..samples(60) {
        let n = 1 + trial % 20;
        let m = definite(n, &mut random);
        let (q, dq) = (vector(n, &mut random), vector(n, &mut random));
        let lcp = Lcp::new(m.clone(), q.clone()).unwrap();
        let mut path = Parametric::new(&lcp, &dq, Settings::default()).unwrap();
        let mut basis = path.start().solution().unwrap().basis.clone();
        let mut from = 0.0;
        for breakpoint in path.by_ref() {
            assert_eq!(breakpoint.trend, Trend::Forward);
            assert!(breakpoint.tau >= from);
            // In the middle between this breakpoint and the previous one, the solution has the basis of the path.
            let middle =
                solution(&Lcp::new(m.clone(), &q + &dq * f64::midpoint(from, breakpoint.tau)).unwrap());
            assert_eq!(middle.basis, basis);
            // At the breakpoint z is the solution. Slightly beyond the breakpoint, the solution is z + δ dz/dτ.
            let at = solution(&Lcp::new(m.clone(), &q + &dq * breakpoint.tau).unwrap());
            assert!((&at.z - &breakpoint.z).amax() <= 1e-10 * (1.0 + at.z.amax()));
            let later = breakpoint.tau + 1e-7;
            let after = solution(&Lcp::new(m.clone(), &q + &dq * later).unwrap());
            if after.basis == breakpoint.basis {
                let predicted = &breakpoint.z + &breakpoint.rate * 1e-7;
                assert!((&after.z - predicted).amax() <= 1e-10 * (1.0 + at.z.amax()));
            }
            assert_eq!(breakpoint.leaving.complement(), breakpoint.entering);
            (from, basis) = (breakpoint.tau, breakpoint.basis);
        }
        assert_eq!(path.end(), Some(&PathEnd::Unbounded(Trend::Forward)));
        let last = solution(&Lcp::new(m, &q + &dq * (2.0 * from + 1.0)).unwrap());
        assert_eq!(last.basis, basis);
    }
}

/// w = −z + 1 − τ has solutions z = 0 and z = 1 − τ up to τ = 1 and none beyond: the path turns back.
#[test]
fn a_path_turns_back_where_solutions_end() {
    let lcp = Lcp::new(DMatrix::from_element(1, 1, -1.0), DVector::from_element(1, 1.0)).unwrap();
    let dq = DVector::from_element(1, -1.0);
    let mut path = Parametric::new(&lcp, &dq, Settings::default()).unwrap();
    let turn = path.next().unwrap();
    assert_eq!((turn.tau, turn.trend, turn.rate[0]), (1.0, Trend::Backward, -1.0));
    assert!(path.next().is_none());
    assert_eq!(path.end(), Some(&PathEnd::Unbounded(Trend::Backward)));

    // From the other solution the path ends in the same way, in reverse order.
    let basis = Basis::from_indices(1, [0]);
    let mut path = Parametric::from_basis(&lcp, &basis, &dq, Settings::default()).unwrap();
    assert_eq!(path.start().solution().unwrap().z[0], 1.0);
    let turn = path.next().unwrap();
    assert_eq!((turn.tau, turn.trend), (1.0, Trend::Backward));
    assert!(path.next().is_none());
}

#[test]
fn a_problem_without_solution_has_no_path() {
    let lcp = Lcp::new(DMatrix::zeros(1, 1), DVector::from_element(1, -1.0)).unwrap();
    let mut path = Parametric::new(&lcp, &DVector::from_element(1, 1.0), Settings::default()).unwrap();
    assert!(path.next().is_none());
    assert_eq!(path.end(), Some(&PathEnd::NoStart));
    assert!(Parametric::new(&lcp, &DVector::zeros(2), Settings::default()).is_err());
    assert!(Parametric::new(&lcp, &DVector::from_element(1, f64::NAN), Settings::default()).is_err());
}

#[test]
fn series_and_warm_starts_find_the_cold_solutions() {
    let mut random = seeded(67);
    for trial in 0..samples(40) {
        let n = 1 + trial % 30;
        let m = definite(n, &mut random);
        let mut q = vector(n, &mut random);
        let mut series = Series::new(m.clone(), Settings::default()).unwrap();
        let mut basis = Basis::slack(n);
        for step in 0..6 {
            let lcp = Lcp::new(m.clone(), q.clone()).unwrap();
            let cold = solution(&lcp);
            let OutcomeView::Solved(view) = series.solve(&q).unwrap() else { panic!("positive definite") };
            assert_eq!(*view.basis, cold.basis, "{trial} {step}");
            assert!(view.residuals.within(1e-13));
            let Outcome::Solved(warm) = lcp.solve_from(&basis, &Settings::default()) else {
                panic!("definite")
            };
            assert_eq!(warm.basis, cold.basis);
            // If the solver starts with the basis of the solution, it needs no pivot at all.
            let Outcome::Solved(again) = lcp.solve_from(&cold.basis, &Settings::default()) else {
                panic!("definite")
            };
            assert_eq!((again.pivots, &again.basis), (0, &cold.basis));
            basis = cold.basis;
            q += vector(n, &mut random) * 0.1;
        }
    }
}

#[test]
fn a_neighbouring_basis_costs_the_pivots_in_which_it_differs() {
    let mut random = seeded(71);
    let n = 60;
    let m = definite(n, &mut random);
    let (q, dq) = (vector(n, &mut random), vector(n, &mut random));
    let lcp = Lcp::new(m.clone(), q.clone()).unwrap();
    let taus: Vec<f64> =
        Parametric::new(&lcp, &dq, Settings::default()).unwrap().take(2).map(|b| b.tau).collect();
    let mut series = Series::new(m, Settings::default()).unwrap();
    series.solve(&q).unwrap();
    let OutcomeView::Solved(view) = series.solve(&(&q + &dq * f64::midpoint(taus[0], taus[1]))).unwrap()
    else {
        panic!("positive definite")
    };
    // Two pivots: the artificial variable z₀ of Lemke's method enters the basis, and leaves it when the pair that differs has changed.
    assert_eq!(view.pivots, 2);
}

#[test]
fn a_workspace_gives_the_same_answers_as_fresh_memory() {
    let mut random = seeded(73);
    let mut workspace = Workspace::new();
    for _ in 0..samples(200) {
        let n = random.integer(0, 12) as usize;
        let m = DMatrix::from_fn(n, n, |_, _| random.integer(-2, 3) as f64);
        let q = DVector::from_fn(n, |_, _| random.integer(-2, 2) as f64);
        let lcp = Lcp::new(m, q).unwrap();
        assert_eq!(workspace.solve(&lcp, &Settings::default()).into_outcome(), lcp.solve());
    }
}

/// A closed path is reported as such. Its parameter τ reverses at 0, -4/3, -2/3 and -1, where the path reaches the basis with which it started.
#[test]
fn a_closed_loop_is_an_end_of_its_own() {
    let m = DMatrix::from_row_slice(2, 2, &[-1.0, 1.0, -1.0, -2.0]);
    let lcp = Lcp::new(m.clone(), DVector::from_vec(vec![2.0, 0.0])).unwrap();
    let dq = DVector::from_vec(vec![2.0, -1.0]);
    let mut path = Parametric::new(&lcp, &dq, Settings::default()).unwrap();
    let start = path.start().solution().unwrap().basis.clone();
    let breakpoints: Vec<_> = path.by_ref().collect();
    assert_eq!(path.end(), Some(&PathEnd::Loop));
    assert_eq!(breakpoints.len(), 4);
    for (breakpoint, tau) in breakpoints.iter().zip([0.0, -4.0 / 3.0, -2.0 / 3.0, -1.0]) {
        assert!((breakpoint.tau - tau).abs() < 1e-15, "{breakpoints:?}");
    }
    assert_eq!(breakpoints.last().unwrap().basis, start);
    // At every breakpoint τ, z solves the problem with the vector q + τ dq.
    for breakpoint in &breakpoints {
        let at = Lcp::new(m.clone(), lcp.vector() + &dq * breakpoint.tau).unwrap();
        assert!(at.residuals(&breakpoint.z).within(1e-13), "{breakpoint:?}");
    }
}
