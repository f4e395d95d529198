//! Shared by tests: flat faces in contact, and the load factor at which equilibrium is lost.

use grasp_lcp::planar::{Bodies, Contact, Wrench};

/// Two contact points on a flat face from `a` to `b`, with the normal to the left of this direction.
pub(crate) fn face(a: [f64; 2], b: [f64; 2], friction: f64) -> impl Iterator<Item = Contact> {
    let along = [b[0] - a[0], b[1] - a[1]];
    let normal = [-along[1], along[0]];
    [0.1, 0.9].into_iter().map(move |s| {
        Contact::new([a[0] + s * along[0], a[1] + s * along[1]], normal)
            .series_stiffness(3e6, 2e6)
            .friction(friction)
    })
}

/// The load factor at which equilibrium is lost.
pub(crate) fn lost_at(bodies: Bodies, load: Wrench) -> f64 {
    let verdict = bodies.grasp().expect("well posed").hold(load).expect("well posed");
    let Some(lost) = &verdict.lost else { panic!("{verdict}") };
    lost.factor
}

/// Checks that the numbers agree to a relative error of 1e-12.
pub(crate) fn assert_close(x: f64, exact: f64) {
    assert!((x / exact - 1.0).abs() < 1e-12, "{x} {exact}");
}
