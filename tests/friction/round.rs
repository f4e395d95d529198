//! On the round cone the contact law holds to 1e-12 for random, redundant and nonsymmetric problems. Solutions on polygons do not satisfy it.

use grasp_lcp::friction::{ContactMode, SpatialContacts};
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector, Vector3};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A problem with W = H Hᵀ, where H has `rank` columns, and q = H v: bodies that would move with v.
fn problem(random: &mut Random, n: usize, rank: usize, skew: f64) -> SpatialContacts {
    let size = 3 * n;
    let h = DMatrix::from_fn(size, rank, |_, _| random.normal());
    let v = DVector::from_fn(rank, |_, _| random.normal());
    let a = DMatrix::from_fn(size, size, |_, _| skew * random.normal());
    let mu = (0..n).map(|i| if i % 7 == 6 { 0.0 } else { 0.1 + random.uniform() }).collect();
    SpatialContacts::new(&h * h.transpose() / rank as f64 + &a - a.transpose(), &h * v, mu).expect("finite")
}

/// Checks Coulomb's law independently of the library, for each contact by its state.
fn check_law(problem: &SpatialContacts, r: &DVector<f64>, states: &[ContactMode]) {
    let u = problem.matrix() * r + problem.vector();
    let terms = problem.matrix().abs() * r.abs() + problem.vector().abs();
    for (i, state) in states.iter().enumerate() {
        let part = |v: &DVector<f64>| Vector3::new(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
        let (force, velocity, size) = (part(r), part(&u), part(&terms).amax());
        let tangent = |v: &Vector3<f64>| Vector3::new(0.0, v[1], v[2]);
        let (friction, slip) = (tangent(&force), tangent(&velocity));
        let most = problem.friction()[i] * force[0];
        let (of_force, of_velocity) = (1e-11 * r.amax(), 1e-11 * size);
        match state {
            ContactMode::Open => {
                assert_eq!(force, Vector3::zeros());
                assert!(velocity[0] >= -of_velocity);
            }
            ContactMode::Sticking => {
                assert!(velocity.norm() <= of_velocity && friction.norm() <= most + of_force);
            }
            ContactMode::Sliding => {
                assert!(velocity[0].abs() <= of_velocity && force[0] >= -of_force);
                assert!((friction.norm() - most).abs() <= of_force);
                assert!(
                    (friction * slip.norm() + slip * most).norm() <= of_force * size + of_velocity * r.amax()
                );
            }
        }
    }
}

fn solve_all(seed: u64, n: usize, rank: usize, skew: f64, count: usize) -> usize {
    let mut random = seeded(seed);
    let mut solved = 0;
    for _ in 0..samples(count) {
        let problem = problem(&mut random, n, rank, skew);
        match problem.solve() {
            Outcome::Solved(solution) => {
                assert!(solution.residuals.max() <= 1e-12);
                assert_eq!(solution.residuals, problem.residuals(&solution.r));
                check_law(&problem, &solution.r, &solution.states);
                solved += 1;
            }
            Outcome::Breakdown { .. } => {}
            other => panic!("{other}: {problem:?}"),
        }
    }
    solved
}

#[test]
fn definite_problems_are_solved() {
    for n in [1, 2, 3, 5, 8, 12] {
        assert_eq!(solve_all(31 + n as u64, n, 3 * n + 2, 0.0, 60), samples(60), "n = {n}");
    }
}

#[test]
fn nonsymmetric_problems_are_solved() {
    for n in [1, 2, 4, 8] {
        assert_eq!(solve_all(41 + n as u64, n, 3 * n + 2, 0.2, 60), samples(60), "n = {n}");
    }
}

/// H has six columns, for one body. Its forces are not unique from three contacts on.
#[test]
fn redundant_contacts_are_solved() {
    for n in [2, 3, 5, 8, 12] {
        let solved = solve_all(51 + n as u64, n, 6, 0.0, 100);
        assert_met(&[(solved, 98)]);
    }
}

/// The error of polygons in the law falls with the square of the number of facets; the round cone has none.
#[test]
fn polygons_miss_the_law() {
    let mut random = seeded(61);
    let mut missed = [0.0_f64; 3];
    for _ in 0..samples(40) {
        let problem = problem(&mut random, 4, 14, 0.0);
        for (missed, facets) in missed.iter_mut().zip([8, 16, 32]) {
            let polygon = problem.facets(facets).expect("small numbers");
            let Outcome::Solved(solution) = polygon.lcp.solve() else { panic!("copositive") };
            let r = polygon.forces(&solution.z).expect("it fits");
            *missed = missed.max(problem.residuals(&r).max());
        }
    }
    assert!(missed[0] > 0.1 && missed[2] > 1e-2 && missed[2] < missed[0], "{missed:?}");
}
