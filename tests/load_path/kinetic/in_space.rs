//! A planar grasp placed in space in any orientation jumps at the same load to the same forces, on the round cone and on a polygon.

use grasp_lcp::{planar, spatial};
use nalgebra::{Rotation3, Vector3};
use support::kinetic::{Datum, Scene};
use support::samples::{assert_met, samples, seeded};

/// The planar contact, in space in a rotated plane.
fn turned(datum: &Datum, turn: &Rotation3<f64>) -> spatial::Contact {
    let [[x, y], [n_x, n_y], [k_n, k_t]] = [datum.point, datum.normal, datum.stiffness];
    let there = |x: f64, y: f64| <[f64; 3]>::from(turn * Vector3::new(x, y, 0.0));
    spatial::Contact::new(there(x, y), there(n_x, n_y))
        .tangent(there(n_y, -n_x))
        .series_stiffness_axes([k_n, k_t, k_t])
        .friction(datum.friction[0])
        .kinetic(datum.friction[1])
        .command([datum.press, 0.0, 0.0])
}

#[test]
fn a_planar_jump_in_space_is_the_same() {
    let mut random = seeded(0x0072_6f75_6e64);
    let (mut jumps, mut losses) = (0, 0);
    for number in 0..samples(150) {
        let Scene { contacts: data, base, mut more } = Scene::random(&mut random);
        more = more.map(|w| 4.0 * w);
        if data.len() < 3 {
            continue;
        }
        let turn = Rotation3::from_euler_angles(random.normal(), random.normal(), random.normal());
        let flat = planar::Grasp::new(data.iter().map(Datum::contact)).unwrap();
        let round = spatial::Grasp::new(data.iter().map(|datum| turned(datum, &turn))).unwrap();
        let wrench = |[x, y, spin]: [f64; 3]| {
            let [force, moment] =
                [Vector3::new(x, y, 0.0), Vector3::new(0.0, 0.0, spin)].map(|v| <[f64; 3]>::from(turn * v));
            (planar::Wrench::new([x, y], spin), spatial::Wrench::new(force, moment))
        };
        let ([from, there], [to, beyond]) = {
            let ((a, b), (c, d)) = (wrench(base), wrench(more));
            ([a, c], [b, d])
        };
        let mut path = flat.follow(from, &[planar::Leg::load_by(there)]).unwrap();
        let first = path.next();
        let lost = path.end().and_then(|end| end.loss()).map(|loss| loss.jumped.len());
        // The polygon with eight facets has corners in the plane of the grasp, so it is exact here.
        for cone in [*round.settings(), round.settings().on_the_polygon()] {
            let in_space = round.with(&cone);
            let mut in_space = in_space.follow(to, &[spatial::Leg::load_by(beyond)]).unwrap();
            let second = in_space.next();
            let is_lost = in_space.end().and_then(|end| end.loss()).map(|loss| loss.jumped.len());
            assert_eq!(lost, is_lost, "{number}: {:?} {:?}", path.end(), in_space.end());
            losses += usize::from(lost.is_some_and(|jumped| jumped > 0));
            let (Some(a), Some(b)) = (&first, &second) else {
                assert_eq!(first.is_some(), second.is_some(), "{number}");
                continue;
            };
            assert!((a.fraction - b.fraction).abs() < 1e-9 * a.fraction.max(1e-3), "{number}");
            assert_eq!(a.jump.is_some(), b.jump.is_some(), "{number}");
            let (Some(a), Some(b)) = (&a.jump, &b.jump) else { continue };
            let largest = a.state.largest_force();
            for (flat, round) in a.state.contacts.iter().zip(&b.state.contacts) {
                let apart = (round.force[0] - flat.force[0]).hypot(round.force[1] - flat.force[1]);
                assert!(apart.hypot(round.force[2]) < 1e-8 * largest, "{number}: {flat:?} {round:?}");
            }
            jumps += 1;
        }
    }
    println!("{jumps} {losses}");
    assert_met(&[(jumps, 150), (losses, 1)]);
}
