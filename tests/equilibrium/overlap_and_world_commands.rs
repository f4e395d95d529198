//! Contacts may be given as collision libraries and motion planners report them: with a penetration depth instead of a command, and with
//! displacements along the coordinate axes.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Leg, Ramp};
use grasp_lcp::nalgebra::{Isometry3, SVector, Vector3};
use grasp_lcp::{Settings, planar, screening, spatial};
use support::jaws::jaw;

fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{a}, expected {b}");
}

/// Two rails overlap the object by a and b at rest. Their springs p and q are squeezed by a - u and b + u, and balance
/// `p (a - u) = q (b + u)` leaves `u = (p a - q b) / (p + q)` and the force `p q (a + b) / (p + q)`.
#[test]
fn an_overlap_presses_in_the_plane() {
    let (p, q, a, b) = (30.0, 50.0, 0.02, 0.06);
    let finger = |x: f64, k: f64, overlap: f64| jaw::<2>(x, [k, 9.0], 0.4).clearance(-overlap);
    let grasp = planar::Grasp::new([finger(-1.0, p, a), finger(1.0, q, b)]).unwrap();
    let outcome = grasp.solve(planar::Wrench::ZERO).unwrap();
    let state = outcome.equilibrium().expect("holds");
    assert_close(state.twist.translation()[0], (p * a - q * b) / (p + q));
    for contact in &state.contacts {
        assert_close(contact.normal_force(), p * q * (a + b) / (p + q));
    }
}

/// Three fingers overlap a block by c each. It sinks by d into the palm under it, `3 k (c - d) = k_palm d`, so that each
/// finger presses with `F = k c / (1 + 3 k / k_palm)` and `d = 3 F / k_palm`.
#[test]
fn an_overlap_presses_in_space() {
    let (k, palm, c) = (200.0, 800.0, 0.003);
    let finger = |degrees: f64| {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        spatial::Contact::new([cos, sin, 0.1], [0.0, 0.0, -3.0]).series_stiffness(k, 70.0).clearance(-c)
    };
    let below = spatial::Contact::new([0.0, 0.0, -0.1], [0.0, 0.0, 1.0]).series_stiffness(palm, 100.0);
    let grasp = spatial::Grasp::new([below.bonded(), finger(0.0), finger(120.0), finger(240.0)]).unwrap();
    let outcome = grasp.solve(spatial::Wrench::ZERO).unwrap();
    let state = outcome.equilibrium().expect("holds");
    let each = k * c / (1.0 + 3.0 * k / palm);
    assert_close(state.contacts[0].normal_force(), 3.0 * each);
    state.contacts[1..].iter().for_each(|contact| assert_close(contact.normal_force(), each));
    assert_close(state.twist.translation()[2], -3.0 * each / palm);
}

/// All solvers use the command minus the clearance: an overlap has the answers of a command of this size, to the last bit.
fn an_overlap_is_a_command<const C: usize>(fingers: [Contact<C>; 3], down: Wrench<C>) {
    let depth = 0.004;
    let mut command = [0.0; C];
    command[0] = depth;
    let overlapping = fingers.clone().map(|finger| finger.clearance(-depth));
    let commanded = fingers.map(|finger| finger.command(command));
    let pull = screening::Pull::new(&Wrench::ZERO, &down).unwrap();
    let onset = |fingers| screening::Fingers::<C, 3>::new(fingers).unwrap().onset(&pull);
    assert!(onset(&commanded).factor().is_some());
    assert_eq!(onset(&commanded).factor(), onset(&overlapping).factor());
    let [a, b] = [overlapping, commanded].map(|fingers| Grasp::new(fingers).unwrap());
    let settings = Settings::default();
    let [x, y] = [&a, &b].map(|grasp| {
        let outcome = grasp.solve(down).unwrap();
        let state = outcome.equilibrium().expect("holds");
        let ramp = Ramp::load(Wrench::ZERO, down);
        let factor = grasp.with(&settings).onset(&ramp).unwrap().factor();
        let events = grasp.follow(Wrench::ZERO, &[Leg::load_by(down * 50.0)]).unwrap().run();
        let forces: Vec<_> = state.contacts.iter().map(|contact| contact.force).collect();
        let fractions: Vec<_> = events.iter().map(|event| event.fraction).collect();
        (state.twist, forces, factor, fractions)
    });
    assert!(x.2.is_some() && !x.3.is_empty());
    assert_eq!(x, y);
}

fn around(degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos, sin]
}

#[test]
fn an_overlap_is_a_command_in_the_plane() {
    let finger = |degrees: f64| {
        let [x, y] = around(degrees);
        planar::Contact::new([x, y], [-x, -y]).series_stiffness(1e3, 7e2).friction(0.5)
    };
    an_overlap_is_a_command([0.0, 100.0, 230.0].map(finger), planar::Wrench::force([0.1, -1.0]));
}

fn spatial_fingers() -> [spatial::Contact; 3] {
    [0.0, 100.0, 230.0].map(|degrees| {
        let [x, y] = around(degrees);
        spatial::Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 7e2).friction(0.5)
    })
}

#[test]
fn an_overlap_is_a_command_in_space() {
    an_overlap_is_a_command(spatial_fingers(), spatial::Wrench::force([0.1, 0.0, -1.0]));
}

/// A command along the coordinate axes, given before or after the tangent, is the same displacement. It transforms with frames, is
/// passed to the points of patches, and is accepted by screening.
#[test]
fn a_command_may_be_given_along_the_coordinate_axes() {
    let tangent = [0.3, -0.2, 1.0];
    let u = Vector3::new(1e-3, -2e-3, 3e-3);
    let pose = Isometry3::new(Vector3::new(0.1, 0.2, -0.3), Vector3::new(0.5, -0.4, 0.9));
    for finger in spatial_fingers() {
        let grasp = spatial::Grasp::new([finger.clone().command_world(u).tangent(tangent)]).unwrap();
        let frame = *grasp.frames().next().expect("one contact");
        let in_frame = finger.clone().tangent(tangent).command(frame.tr_mul(&u));
        assert_eq!(grasp.contacts(), std::slice::from_ref(&in_frame));
        // The last given command counts.
        assert_eq!(in_frame.clone().command_world([1.0; 3]).command(in_frame.commanded()), in_frame);

        let moved = finger.clone().command_world(u).tangent(tangent).transformed(&pose);
        assert!((moved.commanded() - in_frame.commanded()).norm() < 1e-17);
        let tip = spatial::SoftFingertip::ring(0.1, 4).unwrap();
        for point in tip.contacts(&moved).unwrap() {
            assert!((point.commanded() - in_frame.commanded()).norm() < 1e-17);
        }
    }
    // The planar tangent may be reversed.
    let finger =
        planar::Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1.0, 1.0).command_world([0.1, 0.2]);
    assert_eq!(finger.commanded(), SVector::from([-0.2, -0.1]));
    assert_eq!(finger.tangent([1.0, 0.0]).commanded(), SVector::from([-0.2, 0.1]));

    let pull = spatial::Pull::new(&Wrench::ZERO, &spatial::Wrench::force([0.0, 0.0, -1.0])).unwrap();
    let onset = |fingers| spatial::Fingers::<3>::new(fingers).unwrap().onset(&pull).factor().unwrap();
    let inwards = spatial_fingers().map(|finger| finger.clone().command_world(finger.point() * -0.004));
    let pressed = spatial_fingers().map(|finger| finger.command([0.004, 0.0, 0.0]));
    assert!((onset(&inwards) / onset(&pressed) - 1.0).abs() < 1e-12);
}
