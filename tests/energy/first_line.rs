//! The first line of a comparison with the energy minimum is right. The minimum was computed by hand.

use grasp_lcp::energy::ComparisonVerdict;
use grasp_lcp::planar::{Contact, Grasp, Wrench};

/// A block of 20 N on two points, 0.2 m apart, each pressed with 10 N; μ = 0.5; the left point is twice as stiff along the floor.
fn block() -> Grasp {
    let foot = |name: &str, x: f64, k_t: f64| {
        Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1000.0, k_t)
            .friction(0.5)
            .pressed_with(10.0)
            .name(name)
    };
    Grasp::new([foot("left", -0.1, 800.0), foot("right", 0.1, 400.0)]).unwrap()
}

fn pushed(newtons: f64) -> Wrench {
    Wrench::force([newtons, -20.0])
}

#[test]
fn while_everything_sticks_it_is_the_equilibrium() {
    let comparison = block().energy().compare(pushed(6.0)).unwrap();
    assert_eq!(comparison.verdict, ComparisonVerdict::Agree);
    assert!(comparison.to_string().starts_with("AGREES: "), "{comparison}");
}

/// The left point slides from 7.5 N on and carries 5 N, the right point carries the rest. The program instead increases the normal force of the left
/// point by f: minimise ½ 1200 x² - 9 x + ½ f²/1000 where 800 x = ½ (10 + f), so f = 30/47, and 48/47 N of the push is not balanced.
#[test]
fn beyond_the_first_slip_it_misses_the_load() {
    let comparison = block().energy().compare(pushed(9.0)).unwrap();
    let ComparisonVerdict::OutOfEquilibrium { force, moment } = comparison.verdict else {
        panic!("{:?}", comparison.verdict);
    };
    assert!((force - 30f64.hypot(48.0) / 47.0).abs() < 1e-12, "{force}");
    assert!((moment - 3.0 / 47.0).abs() < 1e-12, "{moment}");
    assert!(comparison.to_string().starts_with("DIFFERS: left slides, "), "{comparison}");
}

#[test]
fn where_nothing_holds_the_program_still_returns_forces() {
    let comparison = block().energy().compare(pushed(11.0)).unwrap();
    assert!(comparison.to_string().starts_with("DIFFERS: no equilibrium"), "{comparison}");
}
