//! The best balance that friction can give at a prescribed motion of the object, whose springs fix the normal forces.

use grasp_lcp::planar::{Grasp, Wrench};
use nalgebra::{Vector2, Vector3};

/// The least `|Σ G F + W|` over all friction forces within μ times the normal forces at twist `q`. A moment counts as a force at an arm of 4 cm.
#[must_use]
pub fn least_unbalance(grasp: &Grasp, load: &Wrench, q: &Vector3<f64>) -> f64 {
    let w = load.to_vector();
    let mut forces = Vec::new();
    let mut columns = Vec::new();
    let mut rest = Vector3::new(w[0], w[1], w[2]);
    for (contact, frame) in grasp.contacts().iter().zip(grasp.frames()) {
        let p = contact.point();
        let wrench = |f: Vector2<f64>| Vector3::new(f[0], f[1], p[0] * f[1] - p[1] * f[0]);
        let [n, t] = [0, 1].map(|a| wrench(frame.column(a).into_owned()));
        let normal = contact.series_stiffness_of_axes()[0] * (contact.commanded()[0] - n.dot(q)).max(0.0);
        rest += n * normal;
        // A moment is converted to a force at an arm of 4 cm.
        columns.push(Vector3::new(t[0], t[1], t[2] / 0.04));
        forces.push((0.0, contact.friction_coefficient() * normal));
    }
    let mut rest = Vector3::new(rest[0], rest[1], rest[2] / 0.04);
    // Coordinate descent converges because the problem is convex and each bound concerns one force.
    for _ in 0..400 {
        for (column, (force, most)) in columns.iter().zip(&mut forces) {
            let better = (*force - column.dot(&rest) / column.norm_squared()).clamp(-*most, *most);
            rest += column * (better - *force);
            *force = better;
        }
    }
    rest.norm()
}
