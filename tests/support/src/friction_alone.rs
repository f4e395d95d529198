//! What friction can do where normal forces are those of springs at a given motion of the object.

use grasp_lcp::planar::{Grasp, Wrench};
use nalgebra::{Vector2, Vector3};

/// The size of the least `Σ G F + W` over all friction forces that the normal forces at this motion allow.
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
        // Moments count as forces 4 cm away.
        columns.push(Vector3::new(t[0], t[1], t[2] / 0.04));
        forces.push((0.0, contact.friction_coefficient() * normal));
    }
    let mut rest = Vector3::new(rest[0], rest[1], rest[2] / 0.04);
    // One force after the other where it does best: the problem is convex and bounds are apart.
    for _ in 0..400 {
        for (column, (force, most)) in columns.iter().zip(&mut forces) {
            let better = (*force - column.dot(&rest) / column.norm_squared()).clamp(-*most, *most);
            rest += column * (better - *force);
            *force = better;
        }
    }
    rest.norm()
}
