//! Solutions do not depend on the order of contacts, on the frame of their tangents, or on units.

use grasp_lcp::friction::SpatialContacts;
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// A problem with positive definite W, whose forces are almost always unique, and its forces.
fn solved(random: &mut Random, n: usize) -> (SpatialContacts, DVector<f64>) {
    let h = DMatrix::from_fn(3 * n, 3 * n + 3, |_, _| random.normal());
    let q = DVector::from_fn(3 * n, |_, _| random.normal());
    let mu = (0..n).map(|_| 0.05 + 0.2 * random.uniform()).collect();
    let problem = SpatialContacts::new(&h * h.transpose() / (3 * n) as f64, q, mu).expect("finite");
    let Outcome::Solved(solution) = problem.solve() else { panic!("definite") };
    (problem, solution.r)
}

fn forces(w: DMatrix<f64>, q: DVector<f64>, mu: Vec<f64>) -> DVector<f64> {
    let Outcome::Solved(solution) = SpatialContacts::new(w, q, mu).expect("finite").solve() else {
        panic!("definite")
    };
    solution.r
}

#[test]
fn order_frames_and_units_do_not_matter() {
    let mut random = seeded(71);
    for trial in 0..samples(60) {
        let n = 1 + trial % 5;
        let (problem, r) = solved(&mut random, n);
        let size = r.amax().max(1e-6);
        let (w, q, mu) = (problem.matrix(), problem.vector(), problem.friction());

        let other = |k: usize| 3 * (n - 1 - k / 3) + k % 3;
        let turned = forces(
            DMatrix::from_fn(3 * n, 3 * n, |i, j| w[(other(i), other(j))]),
            DVector::from_fn(3 * n, |i, _| q[other(i)]),
            mu.iter().rev().copied().collect(),
        );
        assert!((0..3 * n).all(|k| (turned[other(k)] - r[k]).abs() <= 1e-10 * size));

        let mut frame = DMatrix::zeros(3 * n, 3 * n);
        for i in 0..n {
            let (sin, cos) = (std::f64::consts::TAU * random.uniform()).sin_cos();
            let block = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos]);
            frame.view_mut((3 * i, 3 * i), (3, 3)).copy_from(&block);
        }
        let turned = forces(&frame * w * frame.transpose(), &frame * q, mu.to_vec());
        assert!((frame.tr_mul(&turned) - &r).amax() <= 1e-10 * size);

        let (metre, newton) = (1e9, 1e-7);
        let scaled = forces(w * (metre / newton), q * metre, mu.to_vec());
        assert!((scaled / newton - &r).amax() <= 1e-10 * size);
    }
}
