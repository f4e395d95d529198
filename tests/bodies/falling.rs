//! A wall that cannot stand is refuted by a motion on which the weights do work and no contact force within its cone does negative work. Work is
//! summed here over all bodies.

use grasp_lcp::equilibrium::{Outcome, Proof};
use grasp_lcp::grasp::{Bodies, Contact, Wrench};
use nalgebra::{DVector, SVector};
use support::piles::wall;
use support::spatial_piles::spatial_wall;

/// The work of a unit force at a point along an axis, for a twist of the body.
fn work<const C: usize>(point: &[f64], along: &SVector<f64, C>, twist: &[f64]) -> f64 {
    let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
    let moments = planes.iter().map(|&(i, j)| point[i] * along[j] - point[j] * along[i]);
    along.iter().copied().chain(moments).zip(twist).map(|(w, v)| w * v).sum()
}

/// Checks that the motion is a proof: weights of 2 kg do positive work on it, and contact forces with μ = 0.6 do no negative work.
fn is_proof<const C: usize>(
    bodies: Bodies<C>,
    gravity: [f64; C],
    name: impl Fn(&Contact<C>) -> [Option<usize>; 2],
    centres: &[[f64; C]],
) {
    let grasp = bodies.gravity(gravity).grasp().expect("well posed");
    let Outcome::NoEquilibrium(none) = grasp.solve(Wrench::ZERO).expect("well posed") else {
        panic!("cannot stand")
    };
    let Proof::SeparatingMotion { motion, .. } = &none.proof else { panic!("{none}") };
    let twist = |body: usize| motion.bodies[body].twist.components();
    let size = motion.bodies.iter().map(|body| DVector::from_column_slice(body.twist.components()).norm());
    let size = size.fold(0.0, f64::max);
    for (contact, frame) in grasp.contacts().iter().zip(grasp.frames()) {
        let [on, against] = name(contact);
        let of = |axis: usize| {
            let along = frame.column(axis).into_owned();
            let on_body = |body: Option<usize>| {
                body.map_or(0.0, |body| work(contact.point().as_slice(), &along, twist(body)))
            };
            on_body(on) - on_body(against)
        };
        let across = (1..C).map(|axis| of(axis).powi(2)).sum::<f64>().sqrt();
        let least = of(0) - 0.6 * across;
        assert!(least > -1e-7 * size, "{least} of {size}");
    }
    let down = SVector::<f64, C>::from(gravity) * 2.0;
    let gained: f64 = centres.iter().enumerate().map(|(body, at)| work(at, &down, twist(body))).sum();
    assert!(gained > 0.1 * size, "{gained}");
}

/// The brick above a contact of a wall and the brick below it, from its position. Rows are half a metre high, bricks a metre long.
fn sides(x: f64, height: f64, rows: usize) -> [Option<usize>; 2] {
    // The index of the half metre, from the left or from the ground, that contains a coordinate.
    let halves =
        |at: f64| (0..1000_u32).rfind(|k| f64::from(*k) <= 2.0 * at + 0.01).map_or(0, |k| k as usize);
    let (row, half) = (halves(height), halves(x));
    let brick = |row: usize| {
        let column = half.checked_sub(row % 2)? / 2;
        (column < rows).then_some(row * rows + column)
    };
    [brick(row), row.checked_sub(1).and_then(brick)]
}

fn centres(rows: usize) -> impl Iterator<Item = [f64; 2]> {
    let centre = move |row: usize, column: usize| {
        [column as f64 + 0.5 + 0.5 * (row % 2) as f64, 0.5 * row as f64 + 0.25]
    };
    (0..rows).flat_map(move |row| (0..rows).map(move |column| centre(row, column)))
}

/// The walls are tilted by 45°; friction holds only up to 31°.
#[test]
fn tilted_walls_fall() {
    for rows in [3, 6, 10, 14] {
        let name = |contact: &Contact<2>| sides(contact.point()[0], contact.point()[1], rows);
        is_proof(wall(rows), [7.0, -7.0], name, &centres(rows).collect::<Vec<_>>());
    }
}

#[test]
fn tilted_walls_in_space_fall() {
    for rows in [3, 6] {
        let name = |contact: &Contact<3>| sides(contact.point()[0], contact.point()[2], rows);
        let centres: Vec<_> = centres(rows).map(|[x, z]| [x, 0.0, z]).collect();
        is_proof(spatial_wall(rows), [7.0, 0.0, -7.0], name, &centres);
    }
}
