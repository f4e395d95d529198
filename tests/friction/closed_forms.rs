//! Frictional contact problems of bodies on legs agree with closed forms.

use grasp_lcp::friction::{ContactMode, SpatialContacts};
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

const GRAVITY: f64 = 9.81;
const MASS: f64 = 3.0;

/// A stool whose legs end at `feet`, relative to its centre of mass, with upward normals. Without contact forces it would move with `velocity`.
fn stool(feet: &[Vector3<f64>], velocity: Vector3<f64>, mu: f64) -> SpatialContacts {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4));
    let n = feet.len();
    let axes = [Vector3::z(), Vector3::x(), Vector3::y()];
    // Rows of Hᵀ map (v, ω) to the velocity of a foot.
    let h = DMatrix::from_fn(3 * n, 6, |k, j| {
        let (foot, axis) = (feet[k / 3], axes[k % 3]);
        if j < 3 { axis[j] } else { foot.cross(&axis)[j - 3] }
    });
    let inverse = DMatrix::from_fn(6, 6, |i, j| match (i, j) {
        (i, j) if i == j && i < 3 => 1.0 / MASS,
        (i, j) if i == j => 1.0 / inertia[(i - 3, i - 3)],
        _ => 0.0,
    });
    let free = DVector::from_fn(6, |i, _| if i < 3 { velocity[i] } else { 0.0 });
    SpatialContacts::new(&h * inverse * h.transpose(), &h * free, vec![mu; n]).expect("finite")
}

fn square(height: f64) -> Vec<Vector3<f64>> {
    [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
        .iter()
        .map(|[x, y]| Vector3::new(*x, *y, -height))
        .collect()
}

/// Pushed in a direction of symmetry of its legs, the stool slides with Δv = (P − μ m g) / m, whatever the distribution of forces
/// over the redundant legs.
#[test]
fn a_stool_slides_with_what_friction_leaves() {
    for turn in 0..8 {
        let along = f64::from(turn) * std::f64::consts::FRAC_PI_4;
        let direction = Vector3::new(along.cos(), along.sin(), 0.0);
        let (push, mu) = (2.0, 0.15);
        let problem = stool(&square(0.3), direction * push - Vector3::z() * GRAVITY, mu);
        let outcome = problem.solve();
        let Outcome::Solved(solution) = &outcome else { panic!("{outcome}") };
        // Three legs or all four may carry the stool.
        assert!(solution.states.iter().all(|state| *state != ContactMode::Sticking));
        let pressed: f64 = (0..4).map(|i| solution.r[3 * i]).sum();
        assert!((pressed - MASS * GRAVITY).abs() < 1e-11);
        let left = push - mu * GRAVITY;
        for i in 0..4 {
            let slip = Vector3::new(solution.u[3 * i + 1], solution.u[3 * i + 2], 0.0);
            assert!((slip - direction * left).norm() < 1e-11, "{slip} {left}");
            assert!(solution.u[3 * i].abs() < 1e-11);
        }
    }
}

/// With more friction the stool stands. If it is high relative to its width, it tips about two of its legs.
#[test]
fn a_stool_stands_or_tips() {
    let push = Vector3::new(2.0, 0.0, -GRAVITY);
    let Outcome::Solved(stands) = stool(&square(0.3), push, 0.5).solve() else { panic!("it stands") };
    assert!(stands.u.amax() < 1e-12);
    let Outcome::Solved(tips) = stool(&square(8.0), push, 0.5).solve() else { panic!("it tips") };
    assert_eq!(tips.states[1..3], [ContactMode::Open; 2]);
    assert!(tips.u[3] > 0.1 && tips.u[6] > 0.1);
}

/// A single contact whose friction force is opposite to its velocity, in closed form.
#[test]
fn one_contact_slides_against_its_velocity() {
    // W = identity and q = (−1, a), so that r_N = 1, r_T = −μ a/‖a‖, u_T = a − μ a/‖a‖.
    let problem =
        SpatialContacts::new(DMatrix::identity(3, 3), DVector::from_vec(vec![-1.0, 0.6, 0.8]), vec![0.25])
            .unwrap();
    let Outcome::Solved(solution) = problem.solve() else { panic!("solvable") };
    let expected = [1.0, -0.15, -0.2];
    assert!(solution.r.iter().zip(expected).all(|(r, e)| (r - e).abs() < 1e-15), "{}", solution.r);
}
