//! If some contact must approach under all admissible forces, the answer has weights of the contacts that prove it.

use grasp_lcp::friction::{FrictionProblem, PlanarContacts, SpatialContacts};
use grasp_lcp::lcp::Outcome;
use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::{FromPrimitive, Signed, Zero};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A body between two approaching walls: the two normal velocities have opposite signs, minus the closing velocity.
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

/// A wedge between two approaching walls is pushed out if μ < tan α. With more friction it jams: every combination of sticking and
/// sliding is excluded.
///
/// In units in which all numbers are whole, sin α = 7/25: with u_N = 7 v_y − 25 = 0 at both walls and v_y = 2 (7 − 24 μ) r_N.
#[test]
fn a_wedge_is_pushed_out_below_the_angle_of_friction() {
    let wedge = |mu: f64| {
        // Rows map the velocity (v_x, v_y) of the wedge to normal and tangential velocities: normals (±24, 7), tangents (−7, 24) and (7, 24).
        let h = DMatrix::from_row_slice(4, 2, &[24.0, 7.0, -7.0, 24.0, -24.0, 7.0, 7.0, 24.0]);
        let q = DVector::from_vec(vec![-25.0, 0.0, -25.0, 0.0]);
        PlanarContacts::new(&h * h.transpose(), q, vec![mu; 2]).expect("finite").solve()
    };
    let slips = wedge(0.25);
    let solution = slips.solution().expect("it slips out");
    let pressed = 25.0 / 7.0 / (2.0 * (7.0 - 24.0 * 0.25));
    for normal in [solution.r[0], solution.r[2]] {
        assert!((normal / pressed - 1.0).abs() < 1e-13, "{normal} {pressed}");
    }
    let jams = wedge(0.375);
    assert!(matches!(jams, Outcome::NoBasis { .. }), "{jams}");
}

/// A contact whose matrix W (velocity due to forces) is zero, so that no force changes its velocity.
#[test]
fn an_immovable_contact_that_approaches_has_a_proof() {
    let problem = |q: f64| {
        SpatialContacts::new(DMatrix::zeros(3, 3), DVector::from_vec(vec![q, 1.0, 0.0]), vec![1.0]).unwrap()
    };
    assert!(matches!(problem(-1e-9).solve(), Outcome::Infeasible(_)));
    assert!(problem(0.0).solve().solution().is_some());
}

/// For a solved problem no weights are accepted as a proof of infeasibility.
#[test]
fn no_proof_of_what_is_solved() {
    let mut random = seeded(81);
    let mut tried = 0;
    for _ in 0..samples(125) {
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
    assert_met(&[(tried, 50)]);
}

fn exact(x: f64) -> BigRational {
    BigRational::from_f64(x).expect("finite")
}

/// The check in rational arithmetic: a_N ≤ 0, μ² a_T·a_T ≤ a_N², q_Nᵀy < 0, with a relative margin.
fn proves<const C: usize>(problem: &FrictionProblem<C>, y: &DVector<f64>, margin: f64) -> bool {
    let n = y.len();
    let sum = |column: &dyn Fn(usize) -> f64| {
        (0..n).fold(BigRational::zero(), |sum, i| sum + exact(column(i)) * exact(y[i]))
    };
    let (w, q) = (problem.matrix(), problem.vector());
    sum(&|i| q[C * i]).is_negative()
        && (0..n).all(|j| {
            let a: Vec<BigRational> = (0..C).map(|k| sum(&|i| w[(C * i, C * j + k)])).collect();
            let slip: BigRational = a[1..].iter().map(|a| a * a).sum();
            let mu = exact(problem.friction()[j]);
            !a[0].is_positive() && &mu * &mu * slip * exact(1.0 + margin) <= &a[0] * &a[0]
        })
}

fn a_vector_proves_what_rationals_say<const C: usize>(seed: u64) {
    let mut random = seeded(seed);
    let mut proofs = 0;
    for trial in 0..samples(1000) {
        let decades = [0, 1, 30, 140][trial % 4];
        let wild = |random: &mut Random| {
            let exponent = i32::try_from(random.integer(-decades, decades)).expect("small");
            let x = if random.integer(0, 3) == 0 { random.integer(-2, 2) as f64 } else { random.normal() };
            x * 10f64.powi(exponent)
        };
        let n = random.index(1, 3);
        let mut w = DMatrix::from_fn(C * n, C * n, |_, _| wild(&mut random));
        for i in 0..n {
            for j in 0..n {
                w[(C * i, C * j)] = -w[(C * i, C * j)].abs();
            }
        }
        let mut q = DVector::from_fn(C * n, |_, _| wild(&mut random));
        q[0] = -q[0].abs();
        let mu = (0..n).map(|_| (0.3 * wild(&mut random)).abs()).collect();
        let y = DVector::from_fn(n, |_, _| wild(&mut random).abs());
        let problem = FrictionProblem::<C>::new(w, q, mu).expect("finite");
        let told = problem.proves_infeasible(&y);
        assert!(!told || proves(&problem, &y, 0.0), "{problem:?} {y}");
        let extreme = y.iter().chain(problem.friction()).any(|x| *x != 0.0 && !(1e-130..1e130).contains(x));
        assert!(told || extreme || !proves(&problem, &y, 1e-12), "{problem:?} {y}");
        proofs += usize::from(told);
    }
    assert_met(&[(proofs, 50)]);
}

#[test]
fn a_vector_proves_in_the_plane_what_rationals_say() {
    a_vector_proves_what_rationals_say::<2>(83);
}

#[test]
fn a_vector_proves_in_space_what_rationals_say() {
    a_vector_proves_what_rationals_say::<3>(84);
}
