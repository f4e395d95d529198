//! If Lemke's ray proves nothing, linear programming finds a proof of infeasibility. Without this option the answer stays a ray.

use grasp_lcp::lcp::{Lcp, Outcome, Settings};
use nalgebra::{DMatrix, DVector};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// An integer problem with a vector y ≥ 0 whose first entry is 1: Mᵀy ≤ 0 and qᵀy = −1, so that no z ≥ 0 has M z + q ≥ 0.
fn infeasible(random: &mut Random, n: usize) -> Lcp {
    let mut whole = |most: i64| random.integer(-most, most) as f64;
    let mut m = DMatrix::from_fn(n, n, |_, _| whole(4));
    let mut q = DVector::from_fn(n, |_, _| whole(4));
    let y: Vec<f64> = (1..n).map(|_| whole(2).abs()).collect();
    for j in 0..n {
        let others: f64 = (1..n).map(|i| y[i - 1] * m[(i, j)]).sum();
        m[(0, j)] = -others - whole(3).abs();
    }
    q[0] = -(1..n).map(|i| y[i - 1] * q[i]).sum::<f64>() - 1.0;
    Lcp::new(m, q).expect("finite")
}

#[test]
fn without_the_search_a_ray_stays_a_ray() {
    let mut random = seeded(7);
    let one_path = Settings::default().with_retries(0).with_enumerate_up_to(0);
    let mut rays = 0;
    for _ in 0..samples(400) {
        let lcp = infeasible(&mut random, 6);
        let Outcome::Infeasible(proof) = lcp.solve_with(&one_path) else {
            panic!("a vector exists: {lcp:?}")
        };
        assert!(lcp.proves_infeasible(&proof.y));
        match lcp.solve_with(&one_path.clone().with_prove_infeasible(false)) {
            Outcome::Ray(ray) => {
                rays += 1;
                assert_eq!(ray.pivots, proof.pivots);
            }
            Outcome::Infeasible(of_the_ray) => assert_eq!(of_the_ray, proof),
            other => panic!("{other}"),
        }
    }
    assert_met(&[(rays, 20)]);
}
