//! Groups of contacts that are not coupled by W are solved separately.

use grasp_lcp::friction::{PlanarContacts, Settings, SpatialContacts};
use grasp_lcp::lcp::{BreakdownCause, Outcome};
use nalgebra::{DMatrix, DVector};
use support::samples::{samples, seeded};

/// In a problem of two islands with alternating contacts, each island has the forces that it has alone.
#[test]
fn islands_have_the_forces_that_they_have_alone() {
    let mut random = seeded(91);
    for _ in 0..samples(50) {
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

/// One contact must approach under all admissible forces, the other contact need not.
#[test]
fn a_proof_of_one_island_is_one_of_all() {
    let w = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 1.0, 0.0, 0.0]));
    let q = DVector::from_vec(vec![-1.0, 0.3, -1e-3, 0.0]);
    let problem = PlanarContacts::new(w, q, vec![0.5; 2]).expect("finite");
    let Outcome::Infeasible(certificate) = problem.solve() else { panic!("second is immovable") };
    assert!(problem.proves_infeasible(&certificate.y));
    assert_eq!(certificate.y[0], 0.0);
}

/// With a tolerance of zero the second island does not converge. The report names its contact by the index in the whole problem.
#[test]
fn a_contact_of_an_island_is_named_by_its_index_in_the_whole_problem() {
    let mut random = seeded(17);
    let mut missed = 0;
    for _ in 0..samples(12) {
        let scale = DVector::from_fn(4, |_, _| 10_f64.powf(6.0 * random.uniform()));
        let h = DMatrix::from_diagonal(&scale) * DMatrix::from_fn(4, 4, |_, _| random.normal());
        let mut w = DMatrix::identity(8, 8);
        w.view_mut((4, 4), (4, 4)).copy_from(&(&h * h.transpose()));
        // The first two contacts are islands of one contact each, and carry no force because they separate.
        let mut q = DVector::from_fn(8, |_, _| random.normal());
        (q[0], q[2]) = (1.0, 1.0);
        let problem = PlanarContacts::new(w, q, vec![0.9; 4]).expect("finite");
        let outcome = problem.solve_with(&Settings::default().with_tolerance(0.0));
        if let Outcome::Breakdown { cause: BreakdownCause::NoConvergence { contact, .. }, .. } = outcome {
            missed += 1;
            assert!([2, 3].contains(&contact), "contact {contact}");
        }
    }
    assert!(missed > 0);
}
