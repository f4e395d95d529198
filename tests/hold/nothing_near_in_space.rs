//! Attempts to refute, in space, the proof that no equilibrium exists near the lost state. From random motions within its radius, Newton's method
//! seeks a motion at which contact forces of any slip history balance the load.

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Contact, Grasp, SoftFingertip, Wrench};
use nalgebra::{Matrix6, SMatrix, SVector, Vector2, Vector3, Vector6};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// The length that converts moments to forces, m.
const ARM: f64 = 0.04;
/// Sweeps of the search for forces at one motion, and number of Newton steps of the motion.
const SWEEPS: usize = 20;
const STEPS: usize = 10;

/// The data of a contact for the search for forces that balance the load at a given motion.
struct Touch {
    /// Wrenches of one newton along normal and tangents.
    axes: SMatrix<f64, 6, 3>,
    stiffness: f64,
    command: f64,
    friction: f64,
}

/// Three or four fingers around an object, or two opposed rings, with an excessive load.
fn drawn(random: &mut Random, rings: bool) -> Result<(Grasp, Wrench), grasp_lcp::Error> {
    let (friction, press, four) =
        (random.between(0.2, 0.8), random.between(5.0, 40.0), random.between(0.0, 1.0) < 0.5);
    let mut finger = |angle: f64| {
        let out = Vector3::new(angle.cos(), angle.sin(), random.between(-0.1, 0.1));
        let askew =
            Vector3::new(random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(-0.1, 0.1));
        let [normal, tangential] = [random.between(500.0, 2e4), random.between(500.0, 2e4)];
        Contact::new(out * ARM, askew - out)
            .series_stiffness(normal, tangential)
            .friction(friction)
            .pressed_with(press)
    };
    let turn = std::f64::consts::TAU;
    let (contacts, fingers) = if rings {
        let ring = SoftFingertip::ring(0.008, 6)?;
        ([ring.contacts(&finger(0.0))?, ring.contacts(&finger(0.5 * turn))?].concat(), 2.0)
    } else {
        let fingers = if four { 4 } else { 3 };
        ((0..fingers).map(|i| finger(turn * f64::from(i) / f64::from(fingers))).collect(), f64::from(fingers))
    };
    let over = random.between(1.05, 3.0) * fingers * friction * press;
    let aside = [random.between(-0.4, 0.4), random.between(-0.4, 0.4)];
    let load =
        Wrench::force_at([over * aside[0], over * aside[1], -over], [0.0, random.between(-0.01, 0.01), 0.0]);
    Ok((Grasp::new(contacts)?, load))
}

fn touches(grasp: &Grasp) -> Vec<Touch> {
    let touch = |(contact, frame): (&Contact, &SMatrix<f64, 3, 3>)| {
        let axes = SMatrix::<f64, 6, 3>::from_fn(|k, a| {
            let axis = frame.column(a).into_owned();
            if k < 3 { axis[k] } else { contact.point().cross(&axis)[k - 3] }
        });
        Touch {
            axes,
            stiffness: contact.series_stiffness_of_axes()[0],
            command: contact.commanded()[0],
            friction: contact.friction_coefficient(),
        }
    };
    grasp.contacts().iter().zip(grasp.frames()).map(touch).collect()
}

/// The wrench with moments divided by [`ARM`].
fn scaled(mut w: Vector6<f64>) -> Vector6<f64> {
    w.rows_mut(3, 3).apply(|m| *m /= ARM);
    w
}

/// The smallest residual of the balance over all friction forces, and its derivative with respect to the motion.
fn least(
    touches: &[Touch],
    load: &Vector6<f64>,
    q: &Vector6<f64>,
    sweeps: usize,
) -> (Vector6<f64>, Matrix6<f64>) {
    let mut rest = scaled(*load);
    let mut slope = Matrix6::zeros();
    let mut rubs = Vec::new();
    for touch in touches {
        let n = touch.axes.column(0).into_owned();
        let press = (touch.stiffness * (touch.command - n.dot(q))).max(0.0);
        rest += scaled(n) * press;
        if press > 0.0 {
            slope -= scaled(n) * n.transpose() * touch.stiffness;
        }
        let plane = SMatrix::<f64, 6, 2>::from_columns(&[
            scaled(touch.axes.column(1).into()),
            scaled(touch.axes.column(2).into()),
        ]);
        rubs.push((plane, touch.friction * press, Vector2::zeros(), n));
    }
    // Coordinate descent over contacts converges, because the sum is convex and each bound concerns one contact.
    for _ in 0..sweeps {
        for (plane, most, force, _) in &mut rubs {
            let mut better: Vector2<f64> = *force - plane.tr_mul(&rest) / plane.norm_squared();
            if better.norm() > *most {
                better *= *most / better.norm();
            }
            rest += *plane * (better - *force);
            *force = better;
        }
    }
    for ((plane, most, force, n), touch) in rubs.iter().zip(touches) {
        if *most > 0.0 && force.norm() >= 0.999 * most {
            slope -= *plane * force.normalize() * n.transpose() * (touch.friction * touch.stiffness);
        }
    }
    (rest, slope)
}

/// The motion from `at`, scaled back to the radius of the proof if it is larger.
fn within(by: Vector6<f64>, centroid: &Vector3<f64>, reach: f64, angle: f64) -> Vector6<f64> {
    let (origin, turning) = (Vector3::new(by[0], by[1], by[2]), Vector3::new(by[3], by[4], by[5]));
    let turn = turning;
    let turn = if turn.norm() > angle { turn * (angle / turn.norm()) } else { turn };
    let moved = origin + turning.cross(centroid);
    let moved = if moved.norm() > reach { moved * (reach / moved.norm()) } else { moved };
    let origin = moved - turn.cross(centroid);
    Vector6::new(origin.x, origin.y, origin.z, turn.x, turn.y, turn.z)
}

#[test]
fn newton_finds_no_balance_within_the_radius() -> Result<(), grasp_lcp::Error> {
    let (mut random, grasps) = (seeded(5), samples(12));
    let (mut proofs, mut attacks, mut closest) = ([0, 0], 0, f64::INFINITY);
    for number in 0..grasps {
        let rings = number % 2 == 1;
        let (grasp, load) = drawn(&mut random, rings)?;
        // No motion is too large for this verdict, so that it ends with the loss of equilibrium alone.
        let verdict = grasp.with(&Settings::default().with_small_motions(1e50, 1e50)).hold(load)?;
        let Some(lost) = verdict.lost.as_ref().filter(|_| verdict.holds() == Some(false)) else { continue };
        let (Some(near), Some(state)) = (lost.nothing_near, &lost.state) else { continue };
        proofs[usize::from(rings)] += 1;
        let points = grasp.contacts().iter().map(Contact::point);
        let centroid = points.sum::<Vector3<f64>>() / grasp.len() as f64;
        let (touches, w) = (touches(&grasp), load.to_vector());
        let at = state.twist.to_vector();
        let [reach, angle] = [near.translation.min(10.0), near.rotation.min(10.0)];
        for _ in 0..6 {
            attacks += 1;
            let start =
                SVector::<f64, 6>::from_fn(|k, _| random.signed() * if k < 3 { reach } else { angle });
            let mut by = within(start, &centroid, reach, angle);
            for _ in 0..STEPS {
                let (rest, slope) = least(&touches, &w, &(at + by), SWEEPS);
                let Ok(step) = slope.svd(true, true).solve(&rest, 1e-9 * slope.norm()) else { break };
                by = within(by - step, &centroid, reach, angle);
            }
            let left = least(&touches, &w, &(at + by), 10 * SWEEPS).0.norm() / scaled(w).norm();
            closest = closest.min(left);
            assert!(left > 1e-9, "{left} {by}");
        }
    }
    assert!(proofs.iter().all(|count| *count >= grasps / 5), "{proofs:?} proofs");
    println!("{attacks} attacks on {proofs:?} proofs come as near as {closest}");
    // A search that never comes close to balance would not test the proof.
    assert!(closest < 0.5, "{closest}");
    Ok(())
}
