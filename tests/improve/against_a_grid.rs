//! From random starts the answer of `improve` is never below the best point of a grid.

use std::f64::consts::TAU;

use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::planar::{Contact, Grasp, Wrench};

const STEPS: usize = 36;

fn grasp(angles: [f64; 3]) -> Grasp {
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([0.05 * cos, 0.05 * sin], [-cos, -sin]).series_stiffness(1e3, 7e2);
        contact.friction(0.5).pressed_with(10.0)
    };
    Grasp::new(angles.map(finger)).expect("three fingers")
}

fn loads() -> Vec<Wrench> {
    vec![Wrench::force([0.0, -1.0]), Wrench::new([0.5, 0.0], 0.01)]
}

fn first_slip(grasp: &Grasp) -> f64 {
    let factor = |load: &Wrench| grasp.onset(load).expect("a load").factor();
    loads().iter().map(|load| factor(load).unwrap_or(0.0)).fold(f64::INFINITY, f64::min)
}

#[test]
fn starts_from_anywhere_reach_the_best_of_a_grid() {
    let angle = |k: usize| TAU * k as f64 / STEPS as f64;
    let mut best = 0.0_f64;
    for a in 0..STEPS {
        for b in a + 1..STEPS {
            for c in b + 1..STEPS {
                best = best.max(first_slip(&grasp([angle(a), angle(b), angle(c)])));
            }
        }
    }
    let disc = || Surface::circle([0.0, 0.0], 0.05);
    for start in 0..8_usize {
        let golden = |k: usize| TAU * (0.618_033_988_749_895 * (3 * start + k + 1) as f64).fract();
        let given = grasp([golden(0), golden(1), golden(2)]);
        let question = Improve::new(loads()).along(0, disc()).along(1, disc()).along(2, disc());
        let improved = given.improve(&question.with_seed(start as u64)).expect("asked well");
        let reached = improved.after.expect("some start sticks");
        assert!(reached >= best - 1e-6, "{start}: {reached} {best}");
        let again = first_slip(&improved.placed(&given).expect("three contacts"));
        assert!((again - reached).abs() < 1e-12 * reached, "{again} {reached}");
    }
}
