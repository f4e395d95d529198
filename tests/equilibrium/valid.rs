//! Shared by tests: a valid grasp in the plane and one in space, and invalid numbers to put into them.

use grasp_lcp::{planar, spatial};

pub(crate) const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
/// Bad values of a number whose size is also limited.
pub(crate) const NOT_MODERATE: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.1e50, -f64::MAX];

pub(crate) fn planar_contacts() -> Vec<planar::Contact> {
    let at = |point: [f64; 2], normal: [f64; 2]| {
        planar::Contact::new(point, normal)
            .body_stiffness(100.0, 80.0)
            .finger_stiffness(50.0, 40.0)
            .friction(0.5)
            .command([0.1, 0.0])
            .clearance(0.01)
    };
    vec![at([-1.0, 0.0], [1.0, 0.0]), at([1.0, 0.5], [-1.0, 0.0]).name("thumb"), at([1.0, -0.5], [-1.0, 0.0])]
}

pub(crate) fn spatial_contacts() -> Vec<spatial::Contact> {
    let at = |point: [f64; 3], normal: [f64; 3]| {
        spatial::Contact::new(point, normal)
            .body_stiffness(100.0, 80.0)
            .finger_stiffness(50.0, 40.0)
            .tangent([0.0, 0.0, 1.0])
            .friction(0.5)
            .command([0.1, 0.0, 0.0])
            .clearance(0.01)
    };
    vec![
        at([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        at([0.5, 0.8, 0.0], [-0.5, -0.8, 0.0]).name("thumb"),
        at([0.5, -0.8, 0.0], [-0.5, 0.8, 0.0]),
    ]
}

pub(crate) fn equal_or_both_nan(a: f64, b: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan())
}
