//! Contacts that do not move each other are solved by themselves.

use grasp_lcp::friction::{PlanarContacts, SpatialContacts};
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use support::splitmix::Random;

/// Two islands whose contacts alternate: each has the forces that it has alone.
#[test]
fn islands_have_the_forces_that_they_have_alone() {
    let mut random = Random(91);
    for _ in 0..50 {
        let n = random.index(1, 4);
        let mut alone = || {
            let h = DMatrix::from_fn(3 * n, 3 * n + 1, |_, _| random.normal());
            let q = DVector::from_fn(3 * n, |_, _| random.normal());
            let mu: Vec<f64> = (0..n).map(|_| 0.2 + 0.5 * random.uniform()).collect();
            (&h * h.transpose(), q, mu)
        };
        let parts = [alone(), alone()];
        let place = |island: usize, k: usize| 6 * (k / 3) + 3 * island + k % 3;
        let (mut w, mut q, mut mu) = (DMatrix::zeros(6 * n, 6 * n), DVector::zeros(6 * n), vec![0.0; 2 * n]);
        for (island, (w_alone, q_alone, mu_alone)) in parts.iter().enumerate() {
            for i in 0..3 * n {
                q[place(island, i)] = q_alone[i];
                mu[2 * (i / 3) + island] = mu_alone[i / 3];
                for j in 0..3 * n {
                    w[(place(island, i), place(island, j))] = w_alone[(i, j)];
                }
            }
        }
        let together = SpatialContacts::new(w, q, mu).expect("finite").solve();
        let together = together.solution().expect("W is positive definite");
        for (island, (w, q, mu)) in parts.into_iter().enumerate() {
            let outcome = SpatialContacts::new(w, q, mu).expect("finite").solve();
            let alone = outcome.solution().expect("W is positive definite");
            for k in 0..3 * n {
                assert_eq!(together.r[place(island, k)], alone.r[k]);
            }
        }
    }
}

/// A contact that cannot be kept from approaching, beside one that can.
#[test]
fn a_proof_of_one_island_is_one_of_all() {
    let w = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 1.0, 0.0, 0.0]));
    let q = DVector::from_vec(vec![-1.0, 0.3, -1e-3, 0.0]);
    let problem = PlanarContacts::new(w, q, vec![0.5; 2]).expect("finite");
    let Outcome::Infeasible(certificate) = problem.solve() else { panic!("the second is immovable") };
    assert!(problem.proves_infeasible(&certificate.y));
    assert_eq!(certificate.y[0], 0.0);
}
