//! Attempts to refute the proof that no equilibrium exists near the lost state: at motions within its radius, contact forces of any slip history are
//! sought that balance the load.

use grasp_lcp::Settings;
use grasp_lcp::planar::{Contact, Grasp, Pressure, SoftFingertip, Wrench};
use nalgebra::{Vector2, Vector3};
use support::friction_alone::least_unbalance;
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Two soft jaws, slightly misaligned, with an excessive load.
fn jaws(random: &mut Random) -> Result<(Grasp, Wrench), grasp_lcp::Error> {
    let pad = SoftFingertip::pad(random.between(0.005, 0.03), 2, Pressure::Uniform)?;
    let friction = random.between(0.2, 0.8);
    let press = random.between(5.0, 40.0);
    let mut jaw = |x: f64| {
        Contact::new([x, random.between(-0.004, 0.004)], [-x, random.between(-0.004, 0.004)])
            .series_stiffness(random.between(500.0, 2e4), random.between(500.0, 2e4))
            .friction(friction)
            .pressed_with(press)
    };
    let tips = [jaw(-0.04), jaw(0.04)];
    let grasp = Grasp::new([pad.contacts(&tips[0])?, pad.contacts(&tips[1])?].concat())?;
    let over = random.between(1.05, 3.0) * 2.0 * friction * press;
    let lean = random.between(-0.5, 0.5);
    Ok((grasp, Wrench::new([over * lean.sin(), -over * lean.cos()], random.between(-0.02, 0.02) * over)))
}

#[test]
fn no_forces_balance_the_load_within_the_radius() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(11);
    let (mut lost_ones, mut proofs, mut closest) = (0, 0, f64::INFINITY);
    for _ in 0..samples(140) {
        let (grasp, load) = jaws(&mut random)?;
        // No motion is too large for this verdict, so that it ends with the loss of equilibrium alone.
        let grasp = grasp.with(&Settings::default().with_small_motions(1e50, 1e50));
        let verdict = grasp.hold(load)?;
        let Some(lost) = &verdict.lost else { continue };
        if verdict.holds() != Some(false) {
            continue;
        }
        lost_ones += 1;
        let Some(near) = lost.nothing_near else { continue };
        proofs += 1;
        let state = lost.state.as_ref().unwrap();
        let centroid = grasp.contacts().iter().map(Contact::point).sum::<Vector2<f64>>() / grasp.len() as f64;
        let size = load.to_vector().norm();
        for trial in 0..40 {
            // Motions in all directions, on the boundary and inside. If the radius is infinite, motions are very large.
            let part = if trial % 2 == 0 { 1.0 } else { random.uniform() };
            let [reach, angle] = [near.translation.min(10.0), near.rotation.min(10.0)];
            let way = std::f64::consts::TAU * random.uniform();
            let turn = angle * part * (random.signed());
            let moved = Vector2::new(way.cos(), way.sin()) * (reach * part);
            let q = state.twist.to_vector();
            let q = Vector3::new(q[0], q[1], q[2])
                + Vector3::new(moved[0] + turn * centroid[1], moved[1] - turn * centroid[0], turn);
            let left = least_unbalance(&grasp, &load, &q) / size;
            closest = closest.min(left);
            assert!(left > 1e-9, "{left} {q}");
        }
        // An independent search finds no equilibrium within the radius either.
        if let Some(found) = grasp.solve(load)?.equilibrium() {
            let (q, at) = (found.twist.to_vector(), state.twist.to_vector());
            let by = q - at;
            let moved = Vector2::new(by[0] - by[2] * centroid[1], by[1] + by[2] * centroid[0]);
            assert!(moved.norm() > near.translation || by[2].abs() > near.rotation, "{found:?}");
        }
    }
    assert_met(&[(proofs * 40, 1666)]);
    assert!(proofs * 10 >= lost_ones * 9, "{proofs} {lost_ones}");
    assert!(closest < 0.1, "{closest}");
    Ok(())
}

/// No equilibrium under 20 N exists within 12 mm, because all points of one jaw would have to open first.
#[test]
fn opposed_jaws_have_a_radius_of_millimetres() -> Result<(), grasp_lcp::Error> {
    let pad = SoftFingertip::pad(0.02, 2, Pressure::Uniform)?;
    let jaw = |x: f64| jaw::<2>(x, [2000.0, 1000.0], 0.3).pressed_with(25.0);
    let grasp = Grasp::new([pad.contacts(&jaw(-0.04))?, pad.contacts(&jaw(0.04))?].concat())?;
    let near = grasp.hold(Wrench::force([0.0, -20.0]))?.lost.and_then(|lost| lost.nothing_near);
    let near = near.expect("a proof");
    assert!(near.translation > 0.012 && near.translation < 0.02, "{near:?}");
    Ok(())
}
