//! Answers for hands agree with closed forms.

use grasp_lcp::Limit;
use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{DriveChange, DriveState, Finger, Hand, HandPart, Joint, Tendon};
use grasp_lcp::planar::{Grasp, Leg, Wrench};
use support::jaws::jaw;
use support::programs::parts;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// A pinch by two fingers with mirrored compliance matrices C = [[c_nn, ±c_nt], [±c_nt, c_tt]].
fn pinch(c_nn: f64, c_nt: f64, c_tt: f64, mu: f64, force: f64) -> Result<Grasp, grasp_lcp::Error> {
    // The default tangent t = (n_y, -n_x) points down on the left and up on the right. In this test both tangents point down.
    let finger = |x: f64| {
        let contact = Contact::new([x, 0.0], [-x, 0.0])
            .tangent([0.0, -1.0])
            .friction(mu)
            .command([c_nn * force, c_nt * force]);
        Finger::compliant([contact], DMatrix::from_row_slice(2, 2, &[c_nn, c_nt, c_nt, c_tt]))
    };
    Hand::new([finger(-1.0), finger(1.0)]).grasp()
}

/// A pinch carries a load W: each tangential force is W/2. By symmetry the normal displacement does not change, so the normal force is N ±
/// (c_nt/c_nn) W/2. First slip is at W = 2 μ N / (1 ∓ μ c_nt/c_nn).
#[test]
fn a_symmetric_pinch_slides_at_different_loads_up_and_down() -> Tested {
    for (c_nn, c_nt, c_tt) in [(2e-3, 1e-3, 2e-3), (1e-3, -4e-4, 5e-3), (3e-6, 1e-6, 1.0)] {
        let (mu, force) = (0.4, 12.0);
        let grasp = pinch(c_nn, c_nt, c_tt, mu, force)?;
        for side in [-1.0, 1.0] {
            let onset = grasp.onset(Wrench::force([0.0, side]))?;
            // A load upwards is carried by friction downwards, along t: F_t = +W/2, which pulls the finger back by c_nt F_t.
            let expected = 2.0 * mu * force / (1.0 + side * mu * c_nt / c_nn);
            let factor = onset.factor().ok_or("slides")?;
            assert!((factor / expected - 1.0).abs() < 1e-12, "{factor} {expected}");
        }
    }
    Ok(())
}

/// If the load increases the squeeze, the pinch never slides for μ |c_nt| >= c_nn.
#[test]
fn a_side_that_tightens_itself_never_slides() -> Tested {
    let (c_nn, c_nt, force) = (1e-3, 0.8e-3, 10.0);
    for (mu, tightens) in [(1.25 + 1e-9, true), (1.25 - 1e-9, false)] {
        let grasp = pinch(c_nn, c_nt, 1e-3, mu, force)?;
        let onset = |side: f64| grasp.onset(Wrench::force([0.0, side]));
        let factor = onset(1.0)?.factor().ok_or("slides")?;
        let expected = 2.0 * mu * force / (1.0 + mu * c_nt / c_nn);
        assert!((factor / expected - 1.0).abs() < 1e-12, "{factor} {expected}");
        // With μ just below the threshold c_nn / |c_nt| = 1.25, the load of first slip is about 1e10 N.
        let factor = onset(-1.0)?.factor().ok_or("has an answer")?;
        assert_eq!(factor.is_infinite(), tightens, "{factor}");
    }
    Ok(())
}

/// Three-joint fingers squeeze with 4.5 N at μ = 0.4. With springs along the contact axes instead of joints, first slip would be at 2 μ N = 3.6 N in
/// both directions.
#[test]
fn joints_say_what_springs_along_the_axes_cannot() -> Tested {
    let mu = 0.4;
    let finger = |x: f64| {
        let joints = [[1.5, -1.0], [2.0, 0.75], [1.0, 1.5]].map(|[px, py]| [x * px, py]);
        let stiffness = [0.8, 0.8, 0.5];
        let joints = joints.iter().zip(stiffness).map(|(p, k)| Joint::revolute(*p).stiffness(k));
        let pad = Contact::new([x * 0.25, 0.0], [-x, 0.0])
            .series_stiffness(1e9, 1e9)
            .friction(mu)
            .pressed_with(4.5);
        Finger::new(joints).contact(pad)
    };
    // Compliance at the contact: C = Σ J Jᵀ / k over the joints, with the arms from joint to contact; the normal points towards the middle, the
    // tangent down.
    let (mut c_nn, mut c_nt) = (1e-9, 0.0);
    for ([px, py], k) in [[1.5, -1.0], [2.0, 0.75], [1.0, 1.5]].into_iter().zip([0.8, 0.8, 0.5]) {
        let (arm_x, arm_y): (f64, f64) = (0.25 - px, -py);
        let (n, t) = (arm_y, -arm_x); // motion of the right contact (-arm_y, arm_x) along (-1, 0) and (0, -1)
        c_nn += n * n / k;
        c_nt += n * t / k;
    }
    let grasp: Grasp = Hand::new([finger(-1.0), finger(1.0)]).grasp()?;
    let outcome = grasp.solve(Wrench::ZERO)?;
    let squeezed = outcome.equilibrium().ok_or("holds")?;
    let force = squeezed.contacts[0].normal_force();
    assert!((force - 4.5).abs() < 1e-12 && squeezed.contacts[0].friction_force() < 1e-12);
    for side in [-1.0, 1.0] {
        let onset = grasp.onset(Wrench::force([0.0, side]))?;
        let expected = 2.0 * mu * force / (1.0 + side * mu * c_nt / c_nn);
        let factor = onset.factor().ok_or("slides")?;
        assert!((factor / expected - 1.0).abs() < 1e-12, "{factor} {expected}");
    }
    Ok(())
}

fn pad(x: f64, y: f64) -> Contact {
    Contact::new([x, y], [-x, 0.0]).series_stiffness(1e4, 8e3).friction(0.5)
}

/// A stalled motor squeezes with its force limit, however far it is commanded. The answer reports the missing displacement.
#[test]
fn a_motor_that_stalls_squeezes_with_its_limit() -> Tested {
    for limit in [Limit::Saturates(6.0), Limit::Slips(6.0)] {
        let jaw = Joint::prismatic([1.0, 0.0]).stiffness(1e3).command(0.02).limit(limit);
        let hand = Hand::new([Finger::new([jaw]).contact(pad(-1.0, 0.0)), Finger::fixed(pad(1.0, 0.0))]);
        let grasp: Grasp = hand.grasp()?;
        let outcome = grasp.solve(Wrench::ZERO)?;
        let held = outcome.equilibrium().ok_or("holds")?;
        assert!((held.contacts[1].normal_force() - 6.0).abs() < 1e-12);
        let joint = &held.joints[0];
        assert_eq!(joint.state, DriveState::Yields);
        assert!((joint.torque - 6.0).abs() < 1e-12 && (joint.drive - 6.0).abs() < 1e-12);
        assert!((joint.displacement - 2.0 * 6.0 / 1e4).abs() < 1e-15); // two pads of 1e4 N/m
        assert!((joint.yielded - (0.02 - joint.displacement - 6.0 / 1e3)).abs() < 1e-15);
        // A command of 5 mm needs less than 6 N, so the motor holds.
        let outcome = grasp.with_joint_commands(&[0.005])?.solve(Wrench::ZERO)?;
        let joint = &outcome.equilibrium().ok_or("holds")?.joints[0];
        assert_eq!((joint.state, joint.yielded), (DriveState::Holds, 0.0));
        assert!((joint.torque - 0.005 / (1e-3 + 2e-4)).abs() < 1e-12);
    }
    Ok(())
}

/// On a closing squeeze the joint reaches its limit at the exact command. On opening the two laws differ: a saturating drive returns along its spring, and a
/// slipping clutch keeps its slip.
#[test]
fn a_clutch_remembers_and_a_stalled_motor_does_not() -> Tested {
    for (limit, remembers) in [(Limit::Saturates(6.0), false), (Limit::Slips(6.0), true)] {
        let jaw = Joint::prismatic([1.0, 0.0]).stiffness(1e3).limit(limit);
        let hand = Hand::new([Finger::new([jaw]).contact(pad(-1.0, 0.0)), Finger::fixed(pad(1.0, 0.0))]);
        let grasp: Grasp = hand.grasp()?;
        let compliance = 1e-3 + 2e-4;
        let mut path = grasp.follow(Wrench::ZERO, &[Leg::joints_to([0.012]), Leg::joints_to([-0.002])])?;
        let events = path.run();
        let yields = events
            .iter()
            .find(|e| parts(&e.drives).contains(&(HandPart::Joint(0), DriveChange::Yields)))
            .ok_or("yields")?;
        assert_eq!(yields.leg, 0);
        assert!((yields.fraction * 0.012 - 6.0 * compliance).abs() < 1e-15, "{limit:?} {}", yields.fraction);
        let holds = events
            .iter()
            .find(|e| parts(&e.drives).contains(&(HandPart::Joint(0), DriveChange::Holds)))
            .ok_or("holds")?;
        // On opening the clutch sticks at once; the motor must first return to the command at which it stalled.
        let back = 0.012 - holds.fraction * 0.014;
        assert_eq!(holds.leg, 1);
        assert!((back - if remembers { 0.012 } else { 6.0 * compliance }).abs() < 1e-14, "{limit:?} {back}");
        let opens = events
            .iter()
            .filter(|e| !e.changes.is_empty())
            .map(|e| (e.leg, 0.012 - e.fraction * 0.014))
            .next_back();
        let (leg, at) = opens.ok_or("opens")?;
        // The force is zero when the spring has released 6 N.
        let open = if remembers { 0.012 - 6.0 * compliance } else { 0.0 };
        assert!(leg == 1 && (at - open).abs() < 1e-14, "{limit:?} {at} {open}");
    }
    Ok(())
}

/// A joint yields at an exact load, where its drive is at its limit. The object is lost at the limit load of this drive.
#[test]
fn a_joint_yields_under_the_load_at_its_limit() -> Tested {
    for limit in [Limit::Saturates(6.0), Limit::Slips(6.0)] {
        let jaw = |x: f64| {
            Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3).command(0.004).limit(limit)])
                .contact(pad(x, 0.0))
        };
        let hand = Hand::new([jaw(-1.0), jaw(1.0)]);
        let grasp: Grasp = hand.grasp()?;
        // 4 mm of command with 1.1 mm/N on each side give F = 4 / 1.1 N. Under a pull W to the right the right jaw carries F + W/2.
        let force = 0.004 / (1e-3 + 1e-4);
        let onset = grasp.onset(Wrench::force([1.0, 0.0]))?;
        let event = onset.event().ok_or("yields")?;
        assert!((event.factor - 2.0 * (6.0 - force)).abs() < 1e-12, "{}", event.factor);
        assert_eq!(parts(&event.drives), [(HandPart::Joint(1), DriveChange::Yields)]);
        assert!(event.leaving.is_empty());
        // Beyond this load only the left jaw unloads, until it opens. The limit load is the force limit of the right jaw, 6 N.
        let lost = grasp.hold(Wrench::force([1.0, 0.0]))?.lost.ok_or("has a limit")?;
        assert!((lost.factor - 6.0).abs() < 1e-12, "{lost:?}");
        let outcome = grasp.solve(Wrench::force([6.1, 0.0]))?;
        assert!(outcome.equilibrium().is_none(), "{outcome:?}");
    }
    Ok(())
}

/// A whiffletree: one actuator drives two jaws on one side, which share its force equally for every shape of the object.
#[test]
fn a_whiffletree_shares_its_force() -> Tested {
    let jaw =
        |y: f64, gap: f64| Finger::new([Joint::prismatic([1.0, 0.0])]).contact(pad(-1.0, y).clearance(gap));
    let fixed = |y: f64| Finger::fixed(pad(1.0, y));
    // The upper jaw must move 3 mm farther.
    let hand = Hand::new([jaw(0.5, 0.003), jaw(-0.5, 0.0), fixed(0.5), fixed(-0.5)]);
    let grasp: Grasp = hand.tendon(Tendon::new([0.5, 0.5]).stiffness(2e3).pull(0.01)).grasp()?;
    let outcome = grasp.solve(Wrench::ZERO)?;
    let held = outcome.equilibrium().ok_or("holds")?;
    // With the pull x of the tendon, its tension T and the displacements φ of the jaws: x - (φ₁ + φ₂)/2 = T/k, φ = clearance + 2 F/k_pad, F = T/2.
    let tension = (0.01 - 0.0015) / (1.0 / 2e3 + 0.5 * 2.0 / 1e4);
    assert!((held.tendons[0].tension - tension).abs() < 1e-11);
    for (contact, joint) in held.contacts.iter().zip(&held.joints) {
        assert!((contact.normal_force() - tension / 2.0).abs() < 1e-11);
        assert!((joint.torque - tension / 2.0).abs() < 1e-11);
    }
    assert!((held.joints[0].displacement - held.joints[1].displacement - 0.003).abs() < 1e-15);
    Ok(())
}

/// A gripper with a differential has no resistance along the motion of its jaws.
#[test]
fn a_differential_gripper_resists_across_and_not_along_its_jaws() -> Tested {
    let jaw = |x: f64| Finger::new([Joint::prismatic([-x, 0.0])]).contact(pad(x, 0.0));
    let grasp: Grasp =
        Hand::new([jaw(-1.0), jaw(1.0)]).tendon(Tendon::new([0.5, 0.5]).tension(20.0)).grasp()?;
    let onset = grasp.onset(Wrench::force([0.0, -1.0]))?;
    assert!((onset.factor().ok_or("slides")? - 10.0).abs() < 1e-12);
    let outcome = grasp.solve(Wrench::force([0.1, 0.0]))?;
    let grasp_lcp::planar::Outcome::NoEquilibrium(none) = &outcome else { panic!("{outcome:?}") };
    let grasp_lcp::planar::Proof::FreeMotion { motion, work } = &none.proof else { panic!("{none:?}") };
    assert!(*work > 0.0 && motion.object.translation()[0] > 0.0);
    // The jaws move with the object.
    let joints = &motion.joints;
    assert!(
        (joints[0] - motion.object.translation()[0]).abs() < 1e-12
            && (joints[1] + motion.object.translation()[0]).abs() < 1e-12
    );
    Ok(())
}

/// A plate with two pads on one spring: the pads carry moments, the spring only the sum of forces.
#[test]
fn a_plate_jaw_on_one_spring() -> Tested {
    let plate = Finger::new([Joint::prismatic([1.0, 0.0]).stiffness(1e3).command(0.012)])
        .contact(pad(-1.0, 0.5))
        .contact(pad(-1.0, -0.5));
    let grasp: Grasp =
        Hand::new([plate, Finger::fixed(pad(1.0, 0.5)), Finger::fixed(pad(1.0, -0.5))]).grasp()?;
    let outcome = grasp.solve(Wrench::new([0.0, 0.0], 1.0))?;
    let held = outcome.equilibrium().ok_or("holds")?;
    // The spring of 1e3 is in series with two pads on two pads of 1e4 each.
    let total = 0.012 / (1.0 / 1e3 + 1.0 / 2e4 + 1.0 / 2e4);
    assert!((held.joints[0].torque - total).abs() < 1e-11);
    assert!((held.contacts[0].normal_force() + held.contacts[1].normal_force() - total).abs() < 1e-11);
    // A rotation θ stretches the normal springs of all four pads by θ/2 and the tangential springs by θ: M = (4 · 1e4 / 4 + 4 · 8e3) θ.
    let turn = 1.0 / (1e4 + 3.2e4);
    assert!((held.twist.rotation() - turn).abs() < 1e-16);
    let difference = held.contacts[1].normal_force() - held.contacts[0].normal_force();
    assert!((difference.abs() - 1e4 * turn).abs() < 1e-11, "{difference}");
    Ok(())
}

/// One tendon through both fingers has the same tension at both, and becomes slack when released.
#[test]
fn a_tendon_over_two_fingers() -> Tested {
    // Each finger turns about a pivot 1 m below its contact; a rotation moves the contact inwards.
    let finger =
        |x: f64, arm: f64| Finger::new([Joint::revolute([x, -arm])]).contact(jaw::<2>(x, [1e4, 1e4], 0.6));
    // A unit rotation moves the contact by (-arm, 0), inwards on the right. So the tendon arm on the left is negative.
    let hand = Hand::new([finger(-1.0, 1.0), finger(1.0, 1.0)])
        .tendon(Tendon::new([-0.02, 0.02]).stiffness(5e4).pull(0.002));
    let grasp: Grasp = hand.grasp()?;
    let outcome = grasp.solve(Wrench::ZERO)?;
    let held = outcome.equilibrium().ok_or("holds")?;
    // With the tendon's arm r: T r = F · 1 m at both fingers, x = T/k + r (φ₁ + φ₂), and the sum of rotations is the compression of two pads, 2 F /
    // 1e4.
    let tension = 0.002 / (1.0 / 5e4 + 0.02 * 0.02 * 2.0 / 1e4);
    assert!((held.tendons[0].tension / tension - 1.0).abs() < 1e-12);
    assert!((held.contacts[0].normal_force() / (0.02 * tension) - 1.0).abs() < 1e-12);
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::joints_by([0.0, 0.0, -0.004])])?;
    let slackens = path
        .run()
        .into_iter()
        .find(|e| parts(&e.drives).contains(&(HandPart::Tendon(0), DriveChange::Slackens)));
    assert!((slackens.ok_or("slackens")?.fraction - 0.5).abs() < 1e-12);
    Ok(())
}

/// A finger with a constant force keeps this force under any load along the force, and the opposite finger carries the whole load.
#[test]
fn a_force_that_is_held_stays() -> Tested {
    let grasp: Grasp = Grasp::new([pad(-1.0, 0.0).force(8.0), pad(1.0, 0.0)])?;
    for load in [0.0, 3.0, -3.0] {
        let outcome = grasp.solve(Wrench::force([load, 0.0]))?;
        let held = outcome.equilibrium().ok_or("holds")?;
        assert!((held.contacts[0].normal_force() - 8.0).abs() < 1e-13);
        assert!((held.contacts[1].normal_force() - 8.0 - load).abs() < 1e-13);
        assert_eq!(held.joints[0].state, DriveState::Absent);
        assert_eq!(held.joints[0].torque, 8.0);
    }
    assert!(grasp.solve(Wrench::force([-8.1, 0.0]))?.equilibrium().is_none());
    Ok(())
}

/// A vice is tightened to 20 N, loaded with a weight, and opened. The jaws slide when 2 μ F equals the weight. States on the path have the right joint
/// torques.
#[test]
fn a_vice_is_tightened_and_opened() -> Tested {
    let jaw =
        |x: f64| Finger::new([Joint::prismatic([-x, 0.0]).torque(5.0)]).contact(jaw::<2>(x, [1e3, 1e3], 0.5));
    let grasp: Grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?;
    let legs = [
        Leg::torques_by([15.0, 15.0]),
        Leg::load_to(Wrench::force([0.0, -12.0])),
        Leg::torques_to([4.0, 4.0]),
    ];
    let mut path = grasp.follow(Wrench::ZERO, &legs)?;
    path.run();
    let lost = path.end().and_then(|end| end.loss()).ok_or("slides")?;
    assert!(lost.leg == 2 && (lost.fraction - 0.5).abs() < 1e-14, "{lost:?}");
    let half = path.state_at(0, 0.5).ok_or("has passed")?;
    assert!((half.joints[0].torque - 12.5).abs() < 1e-13 && half.residuals.worst() < 1e-14, "{half:?}");
    assert!((half.contacts[1].normal_force() - 12.5).abs() < 1e-13);
    let refused = grasp.follow(Wrench::ZERO, &[Leg::torques_by([1.0])]).unwrap_err();
    assert!(matches!(refused, grasp_lcp::Error::JointCommands { given: 1, expected: 2, .. }), "{refused}");
    Ok(())
}

/// Two motors of 100 N/m are commanded to meet half a metre beyond each other and stall at 20 N. A small push carries the object and both jaws to where
/// the spring of one motor needs less than 20 N, by 0.5 m - 20/100 m, and the answer says so.
#[test]
fn stalled_motors_that_run_away() -> Tested {
    let jaw = |x: f64| {
        let motor = Joint::prismatic([-x, 0.0]).stiffness(100.0).command(0.5).limit(Limit::Saturates(20.0));
        Finger::new([motor]).contact(jaw::<2>(x, [1e6; 2], 0.5))
    };
    let grasp: Grasp = Hand::new([jaw(-0.03), jaw(0.03)]).grasp()?;
    let verdict = grasp.hold(Wrench::force([5.0, 0.0]))?;
    let moves = verdict.caught[0].moves.as_ref().ok_or("moves")?;
    assert!((moves.distance - 0.3).abs() < 1e-4 && moves.contacts.is_empty(), "{verdict}");
    assert!(!verdict.to_string().contains("nothing"), "{verdict}");
    Ok(())
}
