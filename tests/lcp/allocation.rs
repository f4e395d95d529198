//! After the first few problems a stream of problems in one workspace, or of right-hand sides in one series, allocates no memory.

use crate::common::{Random, seeded};
use allocation_counter::measure;
use grasp_lcp::lcp::{Lcp, OutcomeView, Series, Settings, Workspace};
use nalgebra::{DMatrix, DVector};

/// A problem with M = A Aᵀ + 1 and entries of q of both signs, which the first path solves.
fn definite(n: usize, random: &mut Random) -> Lcp {
    let mut number = || random.integer(-1000, 1000) as f64 / 1000.0;
    let a = DMatrix::from_fn(n, n, |_, _| number());
    let q = DVector::from_fn(n, |_, _| number());
    Lcp::new(&a * a.transpose() + DMatrix::identity(n, n), q).expect("finite")
}

#[test]
fn a_workspace_that_has_held_the_largest_problem_allocates_nothing() {
    let mut random = seeded(61);
    let problems: Vec<Lcp> = (0..200).map(|k| definite(40 - k % 37, &mut random)).collect();
    let settings = Settings::default();
    let mut workspace = Workspace::new();
    let first =
        measure(|| assert!(matches!(workspace.solve(&problems[0], &settings), OutcomeView::Solved(_))));
    assert!(first.count_total > 0, "the counter counts");
    let mut pivots = 0;
    let counted = measure(|| {
        for problem in &problems {
            let OutcomeView::Solved(solution) = workspace.solve(problem, &settings) else { continue };
            pivots += solution.pivots;
        }
    });
    assert!(pivots > 2000, "{pivots}");
    assert_eq!(counted.count_total, 0);
}

#[test]
fn a_series_allocates_nothing_from_its_third_problem_on() {
    let mut random = seeded(67);
    let problem = definite(30, &mut random);
    let sides: Vec<DVector<f64>> =
        (0..50).map(|_| DVector::from_fn(30, |_, _| random.integer(-1000, 1000) as f64 / 1000.0)).collect();
    let mut series = Series::new(problem.matrix().clone(), Settings::default()).expect("finite");
    let mut allocations = Vec::new();
    let mut pivots = 0;
    for q in &sides {
        let counted = measure(|| {
            if let Ok(OutcomeView::Solved(solution)) = series.solve(q) {
                pivots += solution.pivots;
            }
        });
        allocations.push(counted.count_total);
    }
    assert!(pivots > 200, "{pivots}");
    assert!(allocations[2..].iter().all(|count| *count == 0), "{allocations:?}");
}
