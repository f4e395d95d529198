//! Where some contact approaches whatever the forces, weights of the contacts prove it.

use grasp_lcp::friction::{PlanarContacts, SpatialContacts};
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use support::splitmix::Random;

/// A body between two walls that close in on it: u_N of one is that of the other with the opposite sign, less the closing.
#[test]
fn closing_walls_cannot_be_kept_apart() {
    let half = |closing: f64| {
        let h = DMatrix::from_row_slice(
            6,
            3,
            &[1., 0., 0., 0., 1., 0., 0., 0., 1., -1., 0., 0., 0., 1., 0., 0., 0., 1.],
        );
        let q = DVector::from_vec(vec![0.2 - closing, 0.1, 0.0, -0.2 - closing, 0.1, 0.0]);
        SpatialContacts::new(&h * h.transpose(), q, vec![0.5, 0.8]).expect("finite")
    };
    let Outcome::Infeasible(certificate) = half(0.01).solve() else { panic!("they close") };
    assert!(half(0.01).proves_infeasible(&certificate.y));
    assert!(!half(0.0).proves_infeasible(&certificate.y) && !half(-0.1).proves_infeasible(&certificate.y));
    assert!(half(-0.1).solve().solution().is_some());
}

/// A wedge between two inclined walls jams if friction spans the angle between them, and is pushed out by closing walls if not.
#[test]
fn a_wedge_is_pushed_out_below_the_angle_of_friction() {
    let incline = 0.2_f64;
    let wedge = |mu: f64| {
        let (sin, cos) = incline.sin_cos();
        // Normals (±cos, sin), tangents (−sin, ±cos), as seen of (v_x, v_y).
        let h = DMatrix::from_row_slice(4, 2, &[cos, sin, -sin, cos, -cos, sin, sin, cos]);
        PlanarContacts::new(&h * h.transpose(), DVector::from_vec(vec![-1.0, 0.0, -1.0, 0.0]), vec![mu; 2])
            .expect("finite")
    };
    let slips = wedge(0.9 * incline.tan()).solve();
    assert!(slips.solution().is_some_and(|solution| solution.residuals.max() < 1e-13), "{slips}");
    // The relation u_N1 + u_N2 = 2 sin v_y leaves a way out as long as v_y may grow: no weights prove anything.
    let jams = wedge(1.1 * incline.tan());
    let outcome = jams.solve();
    assert!(outcome.solution().is_none() || outcome.solution().unwrap().residuals.max() < 1e-12, "{outcome}");
}

/// Immovable contacts: W = 0.
#[test]
fn an_immovable_contact_that_approaches_has_a_proof() {
    let problem = |q: f64| {
        SpatialContacts::new(DMatrix::zeros(3, 3), DVector::from_vec(vec![q, 1.0, 0.0]), vec![1.0]).unwrap()
    };
    assert!(matches!(problem(-1e-9).solve(), Outcome::Infeasible(_)));
    assert!(problem(0.0).solve().solution().is_some());
}

/// No weights prove anything of a problem that is solved.
#[test]
fn no_proof_of_what_is_solved() {
    let mut random = Random(81);
    let mut tried = 0;
    for _ in 0..500 {
        let n = random.index(1, 3);
        let h = DMatrix::from_fn(3 * n, 2, |_, _| random.integer(-2, 2) as f64);
        let q = DVector::from_fn(3 * n, |_, _| random.integer(-2, 2) as f64);
        let mu = (0..n).map(|_| random.uniform()).collect();
        let problem = SpatialContacts::new(&h * h.transpose(), q, mu).expect("finite");
        let outcome = problem.solve();
        if outcome.solution().is_some() {
            tried += 1;
            for _ in 0..20 {
                let y = DVector::from_fn(n, |_, _| random.integer(0, 2) as f64);
                assert!(!problem.proves_infeasible(&y), "{problem:?} {y}");
            }
        }
    }
    assert!(tried > 200, "{tried}");
}
