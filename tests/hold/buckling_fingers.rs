//! A finger in line with its push folds at its joints: the push takes from their stiffness.

use grasp_lcp::Error;
use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::hold::Verdict;
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::planar::{Contact, Wrench};
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial;

const INNER: f64 = 0.05;
const OUTER: f64 = 0.03;
const TANGENTIAL: f64 = 400.0;

/// A part between two guides without friction, pushed with `force` against the tip of a finger at the origin that points along x.
fn pushed(joints: Vec<Joint>, friction: f64, force: f64) -> Result<Verdict<2>, Error> {
    let tip = Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1e6, TANGENTIAL).friction(friction);
    let guide = |x: f64, side: f64| {
        let guide = Contact::new([x, 0.01 * side], [0.0, -side]).series_stiffness(1e9, 1e9);
        Finger::fixed(guide.friction(0.0).pressed_with(1e-3))
    };
    let guides = [0.02, 0.06].into_iter().flat_map(|x| [guide(x, 1.0), guide(x, -1.0)]);
    let hand = Hand::new([Finger::new(joints).contact(tip)].into_iter().chain(guides));
    hand.grasp()?.hold(Wrench::force_at([-force, 0.0], [0.0, 0.0]))
}

fn critical(verdict: &Verdict<2>, force: f64) -> f64 {
    let lost = verdict.lost.as_ref().unwrap_or_else(|| panic!("{verdict}"));
    assert_eq!(lost.too_far, Some(TooFar::Buckles), "{verdict}");
    lost.factor * force
}

/// One joint of stiffness c at the distance L behind the tip: the push F turns the finger by φ against c φ with F L φ. A tip that sticks with k shears
/// its pad, which adds k L².
#[test]
fn a_finger_with_one_joint() -> Result<(), Error> {
    let (stiffness, long) = (2.0, INNER + OUTER);
    for (friction, expected) in [(0.0, stiffness / long), (50.0, stiffness / long + TANGENTIAL * long)] {
        let joint = || vec![Joint::revolute([-long, 0.0]).stiffness(stiffness)];
        for part in [0.6, 1.5] {
            let verdict = pushed(joint(), friction, part * expected)?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            let force = critical(&verdict, part * expected);
            assert!((force / expected - 1.0).abs() < 1e-5, "{force} {expected}");
        }
    }
    Ok(())
}

/// Two joints with stiffnesses a and b, links L and l, a tip without friction. With the rotations φ and ψ of the joints the energy is
/// `½ a φ² + ½ b ψ² - ½ F (L φ² + l (φ + ψ)²)`. The least F at which its determinant is zero:
#[test]
fn a_finger_with_two_joints() -> Result<(), Error> {
    let (a, b) = (2.0, 1.2);
    let joints = || {
        vec![Joint::revolute([-INNER - OUTER, 0.0]).stiffness(a), Joint::revolute([-OUTER, 0.0]).stiffness(b)]
    };
    // (a - F (L + l)) (b - F l) = F² l²
    let (square, linear): (f64, f64) = (INNER * OUTER, -(a * OUTER + b * (INNER + OUTER)));
    let expected = (-linear - (linear * linear - 4.0 * square * a * b).sqrt()) / (2.0 * square);
    let verdict = pushed(joints(), 0.0, 2.0 * expected)?;
    let force = critical(&verdict, 2.0 * expected);
    assert!((force / expected - 1.0).abs() < 1e-5, "{force} {expected}");
    Ok(())
}

/// In space, a joint about any axis across the finger.
#[test]
fn a_finger_in_space() -> Result<(), Error> {
    use spatial::hand::{Finger, Hand, Joint};
    let (stiffness, long) = (2.0, 0.08);
    for axis in [[0.0, 0.0, 1.0], [0.0, 3.0, 4.0]] {
        let tip = spatial::Contact::new([0.0; 3], [1.0, 0.0, 0.0]).series_stiffness(1e6, 1e4).friction(0.0);
        let joint = Joint::revolute([-long, 0.0, 0.0], axis).stiffness(stiffness);
        let sides = [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        // Guides at both ends, beside the middle, also keep the part from turning about x.
        let guides = [0.02, 0.06].into_iter().flat_map(|x| {
            sides.map(|n| {
                let at = [x, -0.01 * n[1] + 0.005 * n[2], -0.01 * n[2] - 0.005 * n[1]];
                let guide = spatial::Contact::new(at, n).series_stiffness(1e9, 1e9).friction(0.0);
                Finger::fixed(guide.pressed_with(1e-3))
            })
        });
        let grasp = Hand::new([Finger::new([joint]).contact(tip)].into_iter().chain(guides)).grasp()?;
        let expected = stiffness / long;
        for part in [0.7, 1.3] {
            let load = spatial::Wrench::force_at([-part * expected, 0.0, 0.0], [0.0; 3]);
            let verdict = grasp.hold(load)?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            let lost = verdict.lost.as_ref().unwrap();
            assert_eq!(lost.too_far, Some(TooFar::Buckles), "{verdict}");
            assert!((lost.factor * part - 1.0).abs() < 1e-5, "{verdict}");
        }
    }
    Ok(())
}

/// Once the motor of a joint yields, its torque is constant and resists no longer. The Hessian of the energy of the scene `three_joint_pinch` under 3.5 N,
/// by finite differences of its nine coordinates, has the least eigenvalue 0.060 N m with the spring of this joint, and -0.054 N m without it.
#[test]
fn a_joint_that_yields_no_longer_resists() -> Result<(), Error> {
    let text = include_bytes!("../../examples/scenes/three_joint_pinch.json");
    let grasp = Scene::from_json(text).unwrap().planar().unwrap().grasp()?;
    for force in [3.0, 3.5] {
        let verdict = grasp.hold(Wrench::force_at([0.0, force], [0.0, 0.0]))?;
        let yields = verdict.first_slip.as_ref().unwrap();
        let lost = verdict.lost.as_ref().unwrap();
        assert_eq!(yields.give_way, ["right base"], "{verdict}");
        assert_eq!(lost.too_far, Some(TooFar::Buckles), "{verdict}");
        assert!((lost.factor / yields.factor - 1.0).abs() < 1e-6, "{verdict}");
    }
    Ok(())
}
