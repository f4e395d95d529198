//! If a body is wedged between two contacts on the edges of their cones, the forces are unique but the twist is only known up to an interval. The
//! answer reports this interval.
//!
//! Scenes are made by hand: forces on the edges of both cones, and the load that balances them. A twist is an equilibrium if it presses the surfaces
//! as deep as these forces need, and both slips point along friction. These twists form a segment of a line.

use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// The part of the line on which both contacts slip along their friction: (point, direction, from, to).
type Stretch = ([f64; 3], [f64; 3], f64, f64);

struct Wedged {
    grasp: Grasp,
    load: Wrench,
    forces: [[f64; 2]; 2],
    stretch: Option<Stretch>,
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn wedged(random: &mut Random) -> Wedged {
    let (mut contacts, mut total, mut forces) = (Vec::new(), [0.0; 3], [[0.0; 2]; 2]);
    // For each contact: the rows that map a motion (x, y, θ) to displacements along n and t; the depth by which its normal force presses the
    // surfaces; the tangential command less the spring deflection; and the sign of its slip.
    let (mut rows, mut deep, mut beside, mut ways) = ([[[0.0; 3]; 2]; 2], [0.0; 2], [0.0; 2], [0.0; 2]);
    for i in 0..2 {
        let side = if i == 0 { 1.0 } else { -1.0 };
        let (sin, cos) = random.between(-0.6, 0.9).sin_cos();
        let (n, p) = ([-side * cos, sin], [side * random.between(0.5, 1.0), random.between(-0.3, 0.3)]);
        let t = [n[1], -n[0]];
        let [k, kt, mu, f] = [
            random.between(500.0, 5e3),
            random.between(300.0, 3e3),
            random.between(0.2, 0.9),
            random.between(1.0, 8.0),
        ];
        let way = if random.between(-1.0, 1.0) > 0.0 { 1.0 } else { -1.0 };
        forces[i] = [f, way * mu * f];
        let command = [f / k + random.between(-1e-3, 1e-3), random.between(-4e-3, 4e-3)];
        let row = |e: [f64; 2]| [e[0], e[1], p[0] * e[1] - p[1] * e[0]];
        for (force, row) in forces[i].iter().zip([row(n), row(t)]) {
            (0..3).for_each(|k| total[k] -= force * row[k]);
        }
        (rows[i], ways[i]) = ([row(n), row(t)], way);
        (deep[i], beside[i]) = (command[0] - f / k, command[1] - forces[i][1] / kt);
        contacts.push(Contact::new(p, n).series_stiffness(k, kt).friction(mu).command(command));
    }
    // The twists u that press both surfaces by the required depth, n_i·u = deep_i, form a line. It has the direction n_0 × n_1, and `point` is on it.
    let line = cross(rows[0][0], rows[1][0]);
    let square = dot(line, line);
    let [a, b] = [cross(rows[1][0], line), cross(line, rows[0][0])];
    let point: [f64; 3] = std::array::from_fn(|k| (deep[0] * a[k] + deep[1] * b[k]) / square);
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for i in 0..2 {
        // The slip of the contact must point along its friction force: way (beside - t·(point + z line)) >= 0, with z the coordinate along the line.
        let (c, g) = (ways[i] * (beside[i] - dot(rows[i][1], point)), -ways[i] * dot(rows[i][1], line));
        if g > 0.0 {
            from = from.max(-c / g);
        } else {
            to = to.min(-c / g);
        }
    }
    let stretch = (from < to).then_some((point, line, from, to));
    Wedged {
        grasp: Grasp::new(contacts).unwrap(),
        load: Wrench::new([total[0], total[1]], total[2]),
        forces,
        stretch,
    }
}

#[test]
fn a_twist_that_friction_leaves_open_is_told_with_its_line() {
    let mut random = seeded(3);
    let mut told = 0;
    for number in 0..samples(200) {
        let Wedged { grasp, load, forces, stretch } = wedged(&mut random);
        let outcome = grasp.solve(load).unwrap();
        let Some((point, line, from, to)) = stretch else { continue };
        let Some(found) = outcome.equilibrium() else { panic!("{number}: {outcome:?}") };
        let apart = |i: usize| (found.contacts[i].force - nalgebra::Vector2::from(forces[i])).norm();
        if apart(0).max(apart(1)) > 1e-9 {
            // Several equilibria may exist; here the solver found one that is not on the line.
            continue;
        }
        told += 1;
        let motion = found.free_motions.first().unwrap_or_else(|| panic!("{number} {:?}", found.twist));
        let [v, q] = [motion.object.to_vector(), found.twist.to_vector()].map(<[f64; 3]>::from);
        let size = dot(v, v).sqrt() * dot(line, line).sqrt();
        assert!(dot(cross(v, line), cross(v, line)).sqrt() < 1e-9 * size, "{number} {v:?} {line:?}");
        let along: [f64; 3] = std::array::from_fn(|k| q[k] - point[k]);
        let z = dot(along, line) / dot(line, line);
        let room = 1e-9 * (1.0 + to.min(1e3) - from.max(-1e3));
        assert!(z > from - room && z < to + room, "{number} {z} {from} {to}");
    }
    assert_met(&[(told, 13)]);
}
