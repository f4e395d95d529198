//! Second derivatives of the energy agree with finite differences of the exact energy. A grasp that is squeezed too hard tips over.

use grasp_lcp::energy::StabilityVerdict;
use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::{Error, spatial};
use nalgebra::{DMatrix, DVector, SVector};
use proptest::prelude::*;

use support::jaws::jaw;
use support::random::{Spread, for_all, scene};
use support::scene::{Scene, wrench};

/// Displacement of a point under a translation and a finite rotation: exact in the plane and in space (Rodrigues).
fn exact_displacement<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    q: &SVector<f64, D>,
) -> SVector<f64, C> {
    let mut u = SVector::<f64, C>::from_fn(|a, _| q[a]);
    if C == 2 {
        let (sin, half) = (q[2].sin(), (0.5 * q[2]).sin());
        u[0] += -2.0 * half * half * point[0] - sin * point[1];
        u[1] += sin * point[0] - 2.0 * half * half * point[1];
        return u;
    }
    let theta = nalgebra::Vector3::new(q[3], q[4], q[5]);
    let r = nalgebra::Vector3::new(point[0], point[1], point[2]);
    let turned = nalgebra::Rotation3::new(theta) * r - r;
    for a in 0..C {
        u[a] += turned[a];
    }
    u
}

/// Energy of springs that carry `force` at q = 0, less the work of the load.
fn energy<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    forces: &[SVector<f64, C>],
    q: &SVector<f64, D>,
) -> f64 {
    let springs = scene.contacts.iter().zip(forces).map(|(datum, force)| {
        let u = datum.frame().tr_mul(&exact_displacement(&datum.point, q));
        let stretch = force.component_div(&datum.stiffness) - u;
        0.5 * datum.stiffness.component_mul(&stretch).dot(&stretch)
    });
    springs.sum::<f64>() - scene.load.dot(q)
}

/// Central differences of fourth order: 8-point stencils of a polynomial-like function, error about h⁴.
fn second_derivative<const D: usize>(f: impl Fn(&SVector<f64, D>) -> f64, i: usize, j: usize) -> f64 {
    let at = |h: f64| {
        let unit = |k: usize| SVector::<f64, D>::from_fn(|a, _| if a == k { h } else { 0.0 });
        if i == j {
            let e = unit(i);
            return (f(&e) - 2.0 * f(&SVector::zeros()) + f(&-e)) / (h * h);
        }
        let (a, b) = (unit(i), unit(j));
        (f(&(a + b)) - f(&(a - b)) - f(&(b - a)) + f(&-(a + b))) / (4.0 * h * h)
    };
    // Richardson: the error of each is c h² + O(h⁴).
    let h = 4e-3;
    (4.0 * at(h) - at(2.0 * h)) / 3.0
}

fn hessian_is_that_of_the_exact_energy<const D: usize, const C: usize>(counts: std::ops::Range<usize>) {
    for_all(file!(), 38, &scene::<D, C>(counts, Spread::Narrow, 0.03), |mut scene| {
        for datum in &mut scene.contacts {
            datum.clearance = 0.0;
            datum.friction = 100.0;
        }
        let grasp = scene.grasp();
        let outcome = grasp.solve(scene.wrench()).unwrap();
        let Some(state) = outcome.equilibrium() else { return Ok(()) };
        if state.contacts.iter().any(|c| c.state != ContactState::Sticking) {
            return Ok(());
        }
        let stability = grasp.energy().stability(state);
        let hessian = stability.hessian();
        let forces: Vec<_> = state.contacts.iter().map(|c| c.force).collect();
        let size = hessian.amax();
        for i in 0..D {
            for j in 0..D {
                let difference = second_derivative(|q| energy(&scene, &forces, q), i, j);
                let apart = (difference - hessian[(i, j)]).abs();
                prop_assert!(apart <= 1e-6 * size, "({i}, {j}): {difference} {}", hessian[(i, j)]);
            }
        }
        // The elastic stiffness: first-order forces against a small motion, without the geometric part.
        let mut elastic = DMatrix::<f64>::zeros(D, D);
        for datum in &scene.contacts {
            for a in 0..C {
                let w = wrench::<D, C>(&datum.point, &datum.frame().column(a).into_owned());
                elastic += DMatrix::from_fn(D, D, |i, j| datum.stiffness[a] * w[i] * w[j]);
            }
        }
        prop_assert!((stability.elastic - elastic).amax() <= 1e-13 * size);
        // The softest motion is an eigenvector. The metric is that of the motion of the contacts' centroid, with rotations times their spread.
        let q = DVector::from_column_slice(stability.softest.object.components());
        let curvature = q.dot(&(hessian * &q));
        prop_assert!((curvature - stability.least_curvature).abs() <= 1e-10 * size);
        Ok(())
    });
}

#[test]
fn planar_hessian() {
    hessian_is_that_of_the_exact_energy::<3, 2>(2..6);
}

#[test]
fn spatial_hessian() {
    hessian_is_that_of_the_exact_energy::<6, 3>(3..6);
}

/// Two fingers at ±r press with N = k_n a. A rotation by θ stores k_t r² θ² in the tangential springs and releases N r θ² from the
/// normal forces. The grasp is stable up to N = k_t r, then the object tips over.
fn squeezed(command: f64) -> Result<Grasp, Error> {
    Grasp::new([-0.5, 0.5].map(|x: f64| jaw::<2>(x, [1000.0, 10.0], 0.5).command([command, 0.0])))
}

#[test]
fn a_grasp_squeezed_between_soft_tangential_springs_tips_over() {
    // k_t r = 5 N: 0.005 m of command.
    for (command, verdict) in [
        (0.001, StabilityVerdict::Stable),
        (0.00499, StabilityVerdict::Stable),
        (0.005, StabilityVerdict::Neutral),
        (0.00501, StabilityVerdict::Unstable),
        (0.02, StabilityVerdict::Unstable),
    ] {
        let grasp = squeezed(command).unwrap();
        let state = grasp.solve(Wrench::ZERO).unwrap();
        let stability = grasp.energy().stability(state.equilibrium().expect("holds"));
        assert_eq!(stability.verdict, verdict, "{command}: {stability:?}");
        // The curvature is 2 k_t r² - 2 N r about the centre, with rotations multiplied by r.
        let curvature = 2.0 * 10.0 - 2.0 * (1000.0 * command) / 0.5;
        let rotation = stability.hessian()[(2, 2)] / 0.25;
        assert!((rotation - curvature).abs() < 1e-10, "{rotation} {curvature}");
        assert!(stability.geometric[(2, 2)] < 0.0);
        if verdict == StabilityVerdict::Unstable {
            assert!((stability.least_curvature - curvature).abs() < 1e-10);
            let motion = stability.softest;
            assert!(motion.object.translation().iter().all(|x| x.abs() < 1e-12));
            assert!((motion.object.rotation().abs() - 2.0).abs() < 1e-12, "1 / r");
        }
    }
}

/// In space a grasp squeezed along x tips about every perpendicular axis, and turns freely about x.
#[test]
fn the_same_grasp_in_space() {
    let grasp = |command: f64| {
        spatial::Grasp::new(
            [-0.5, 0.5].map(|x: f64| jaw::<3>(x, [1000.0, 10.0], 0.5).command([command, 0.0, 0.0])),
        )
        .unwrap()
    };
    let look = |command: f64| {
        let grasp = grasp(command);
        let state = grasp.solve(spatial::Wrench::ZERO).unwrap();
        grasp.energy().stability(state.equilibrium().expect("holds"))
    };
    assert_eq!(look(0.001).verdict, StabilityVerdict::Neutral, "turns about x");
    let stability = look(0.02);
    assert_eq!(stability.verdict, StabilityVerdict::Unstable);
    assert!(stability.softest.object.rotation()[0].abs() < 1e-9);
}

#[test]
fn where_something_slides_energy_does_not_decide() {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(100.0, 50.0).friction(0.2);
    let stop = Contact::new([-2.0, 0.0], [1.0, 0.0]).series_stiffness(10.0, 10.0);
    let grasp = Grasp::new([foot(-1.0), foot(1.0), stop]).unwrap();
    let state = grasp.solve(Wrench::force([-1.0, -1.0])).unwrap();
    let stability = grasp.energy().stability(state.equilibrium().expect("slides and holds"));
    assert_eq!(stability.verdict, StabilityVerdict::Sliding);
}

/// To first order a small moment m turns the object by m / (2 k_t r²). The squeeze reduces this stiffness to 2 (k_t r² - N r), and to zero at N = k_t r.
#[test]
fn squeezing_softens_the_grasp() {
    let load = Wrench::new([0.0, 0.0], 1e-4);
    for (depth, verdict) in [(0.002, StabilityVerdict::Stable), (0.02, StabilityVerdict::Unstable)] {
        let grasp = squeezed(depth).unwrap();
        let outcome = grasp.solve(load).unwrap();
        let state = outcome.equilibrium().unwrap();
        let stability = grasp.energy().stability(state);
        assert!((state.twist.rotation() * stability.elastic[(2, 2)] - 1e-4).abs() < 1e-15);
        let turning = stability.hessian()[(2, 2)];
        assert!((turning - 2.0 * (10.0 * 0.25 - 1000.0 * depth * 0.5)).abs() < 1e-9, "{turning}");
        assert_eq!(stability.verdict, verdict);
    }
}
