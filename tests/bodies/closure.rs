//! Force closure of several bodies agrees with a second-order cone program on the wrenches of all of them.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Bodies, Body, Contact};
use grasp_lcp::statics::Closure;
use grasp_lcp::{Error, planar};
use nalgebra::{DMatrix, SVector};
use support::closure_margin::closure_margin;
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// A contact: point, normal, the body into which the normal points, the body on the other side, and the coefficient of friction.
type Touch<const C: usize> = ([f64; C], [f64; C], usize, Option<usize>, f64);

fn grasp<const C: usize>(count: usize, touches: &[Touch<C>]) -> Grasp<C> {
    let name = |body: usize| format!("body {body}");
    let contacts = touches.iter().map(|(point, normal, on, against, friction)| {
        let contact =
            Contact::new(*point, *normal).series_stiffness(1e3, 8e2).friction(*friction).on(name(*on));
        against.map_or(contact.clone(), |body| contact.against(name(body)))
    });
    Bodies::new((0..count).map(|body| Body::new(name(body)))).contacts(contacts).grasp().expect("well posed")
}

/// The wrench of a force at a point.
fn wrench<const C: usize>(point: &[f64; C], force: &SVector<f64, C>) -> Vec<f64> {
    let planes: &[(usize, usize)] = if C == 2 { &[(0, 1)] } else { &[(1, 2), (2, 0), (0, 1)] };
    let moment = |&(i, j): &(usize, usize)| point[i] * force[j] - point[j] * force[i];
    force.iter().copied().chain(planes.iter().map(moment)).collect()
}

/// Columns are the wrenches of a contact's unit forces along its axes; the rows of all bodies are stacked.
fn map<const C: usize>(count: usize, touch: &Touch<C>, frame: &nalgebra::SMatrix<f64, C, C>) -> DMatrix<f64> {
    let each = C * (C + 1) / 2;
    let mut map = DMatrix::zeros(count * each, C);
    for axis in 0..C {
        let own = wrench(&touch.0, &frame.column(axis).into_owned());
        for (k, x) in own.iter().enumerate() {
            map[(touch.2 * each + k, axis)] = *x;
            if let Some(against) = touch.3 {
                map[(against * each + k, axis)] = -x;
            }
        }
    }
    map
}

/// Checks the answer to the question of force closure: balance of its forces, or no negative work along its motion. Returns whether the bodies are in
/// force closure, if the answer decides this.
fn is_closed<const C: usize>(grasp: &Grasp<C>, count: usize, touches: &[Touch<C>]) -> Option<bool> {
    let maps: Vec<_> =
        touches.iter().zip(grasp.frames()).map(|(touch, frame)| map(count, touch, frame)).collect();
    match grasp.statics().force_closure().expect("no hand") {
        Closure::Closed { internal, .. } => {
            let mut sum = nalgebra::DVector::zeros(maps[0].nrows());
            for ((force, map), touch) in internal.iter().zip(&maps).zip(touches) {
                sum += map * nalgebra::DVector::from_column_slice(force.as_slice());
                assert!(force.rows(1, C - 1).norm() < touch.4 * force[0] * (1.0 - 1e-9), "inside: {force:?}");
            }
            assert!(sum.amax() < 1e-13, "{sum}");
            Some(true)
        }
        Closure::Open { bodies, .. } => {
            let moves: Vec<f64> = bodies.iter().flat_map(|body| body.twist.components().to_vec()).collect();
            let moves = nalgebra::DVector::from_vec(moves);
            assert!(moves.norm() > 1e-3, "{moves}");
            for (map, touch) in maps.iter().zip(touches) {
                let local = map.tr_mul(&moves);
                let most = touch.4 * local.rows(1, C - 1).norm();
                assert!(local[0] - most > -1e-8 * moves.norm(), "works against {local}");
            }
            Some(false)
        }
        _ => None,
    }
}

/// Two or three bodies in a row between jaws. Each face has two or four contact points, and some faces are tilted.
fn row<const C: usize>(numbers: &mut Random, count: usize) -> Vec<Touch<C>> {
    let mut touches = Vec::new();
    for face in 0..=count {
        let corners: &[[f64; 2]] =
            if C == 2 { &[[-0.5, 0.0], [0.5, 0.0]] } else { &[[-0.5, -0.5], [0.5, -0.5], [0.0, 0.6]] };
        let friction = 0.05 + 0.6 * numbers.uniform();
        for corner in corners {
            let mut point = [0.0; C];
            point[0] = face as f64 + 0.1 * numbers.signed();
            (1..C).for_each(|a| point[a] = corner[a - 1] + 0.3 * numbers.signed());
            let mut normal = [0.0; C];
            normal[0] = 1.0;
            (1..C).for_each(|a| normal[a] = 0.5 * numbers.signed());
            let last = face == count;
            if last {
                normal = normal.map(|x| -x);
            }
            touches.push((
                point,
                normal,
                face.min(count - 1),
                if last { None } else { face.checked_sub(1) },
                friction,
            ));
        }
    }
    touches
}

fn rows_are_told<const C: usize>(seed: u64, scenes: usize) {
    let (mut numbers, scenes) = (seeded(seed), samples(scenes));
    let (mut counts, mut told) = ([0; 2], 0);
    for scene in 0..scenes {
        let count = 2 + scene % 2;
        let touches = row::<C>(&mut numbers, count);
        let grasp = grasp(count, &touches);
        let Some(closed) = is_closed(&grasp, count, &touches) else { continue };
        told += 1;
        let maps: Vec<_> = touches
            .iter()
            .zip(grasp.frames())
            .map(|(touch, frame)| (map(count, touch, frame), touch.4))
            .collect();
        let Some(margin) = closure_margin(&maps) else { continue };
        if margin.abs() > 1e-6 || !closed {
            assert_eq!(closed, margin > 1e-6, "{count} {margin} {touches:?}");
            counts[usize::from(closed)] += 1;
        }
    }
    assert!(
        told * 100 > 99 * scenes && counts[0] > scenes / 20 && counts[1] > scenes / 10,
        "{told} {counts:?}"
    );
}

#[test]
fn rows_in_the_plane() {
    rows_are_told::<2>(44, 150);
}

#[test]
fn rows_in_space() {
    rows_are_told::<3>(45, 60);
}

/// Free motions name the bodies that move: a wedge of 10° that friction does not hold, with the block that sinks on it, and a part without any contact
/// between two others.
#[test]
fn what_moves_is_named() {
    let face = |y: f64, normal: [f64; 2], on: &str, mu: f64| {
        [-0.5, 0.5]
            .map(|x| planar::Contact::new([x, y], normal).series_stiffness(1e4, 1e4).friction(mu).on(on))
    };
    let bodies = planar::Bodies::new([planar::Body::new("table top"), planar::Body::new("lid")])
        .contacts(face(0.0, [0.0, 1.0], "table top", 0.5))
        .contacts(face(1.0, [0.0, -1.0], "table top", 0.5))
        .contacts(face(2.0, [0.0, 1.0], "lid", 0.5));
    let Closure::Open { bodies, .. } =
        bodies.grasp().expect("well posed").statics().force_closure().expect("no hand")
    else {
        panic!("the lid rises")
    };
    let speed = |k: usize| bodies[k].twist.components().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    assert!(speed(0) < 1e-9 && speed(1) > 0.1 && &*bodies[1].body == "lid", "{bodies:?}");
}

#[test]
fn refused_where_a_force_presses() {
    let at = |x: f64, normal: f64, on: &str| {
        planar::Contact::new([x, 0.0], [normal, 0.0]).series_stiffness(1e4, 1e4).friction(0.5).on(on)
    };
    let pressed = planar::Bodies::new([planar::Body::new("left"), planar::Body::new("right")]).contacts([
        at(-1.0, 1.0, "left"),
        at(0.0, 1.0, "right").against("left"),
        at(1.0, -1.0, "right").force(10.0),
    ]);
    let statics = pressed.grasp().expect("well posed");
    let told = statics.statics().force_closure().expect_err("a slide is a joint");
    assert_eq!(told, Error::NotForJoints { question: "force_closure" });
    assert!(matches!(
        statics.statics().ferrari_canny(grasp_lcp::statics::Budget::Total(1.0)),
        Err(Error::NotForHands { .. })
    ));
}
