//! Small problems with wedging are solved: W is positive definite and far from a multiple of the identity, and μ is large.
//!
//! Newton's method from the solutions on polygons does not converge for them.

use support::siconos::ReadProblem;

fn check(text: &str, most: f64) {
    let ReadProblem::Spatial(problem) = ReadProblem::from_siconos(text).expect("well formed") else {
        panic!("three components")
    };
    let eigenvalues = problem.matrix().symmetric_eigenvalues();
    assert!(eigenvalues.min() > 0.0 && eigenvalues.max() > most);
    let outcome = problem.solve();
    let solution = outcome.solution().unwrap_or_else(|| panic!("{outcome}"));
    assert!(problem.residuals(&solution.r).max() <= 1e-12);
}

#[test]
fn three_contacts_of_few_coordinates_are_solved() {
    check(include_str!("cases/three_contacts.dat"), 70.0);
}

#[test]
fn four_contacts_of_masses_far_apart_are_solved() {
    check(include_str!("cases/four_contacts.dat"), 1e4);
}
