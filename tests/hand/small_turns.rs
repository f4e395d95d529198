//! Motions are no longer small once a joint behind a closed contact turns too far, however little the object itself turns.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::planar::{Contact, Wrench};
use support::assert_close;

/// A finger of this length that hangs from a soft joint at (x, length), and presses along x with 6 N.
fn finger(x: f64, length: f64, stiffness: f64) -> Finger {
    let tip =
        Contact::new([x, 0.0], [-x.signum(), 0.0]).series_stiffness(1e4, 8e3).friction(0.8).pressed_with(6.0);
    Finger::new([Joint::revolute([x, length]).name("base").stiffness(stiffness)]).contact(tip)
}

/// Both joints turn by the angle θ, so that a load F along x ends small motions at `F = 2 k θ / L`.
#[test]
fn a_joint_that_turns_too_far_ends_the_verdict() {
    for (length, stiffness) in [(0.06, 0.2), (0.06, 0.4), (0.1, 0.5)] {
        let hand =
            Hand::new([finger(-0.02, length, stiffness), finger(0.02, length, stiffness)]).grasp().unwrap();
        let verdict = hand.hold(Wrench::force([10.0, 0.0])).unwrap();
        assert_eq!(verdict.holds(), Some(false));
        let lost = verdict.lost.unwrap();
        assert_close!(lost.factor, 2.0 * stiffness * 0.1 / length / 10.0);
        assert!(matches!(lost.too_far, Some(TooFar::JointTurns { .. })), "{lost:?}");
    }
}

/// A finger that opens turns with its command, and changes nothing for the object, which two other fingers hold.
#[test]
fn a_joint_of_an_open_finger_does_not_count() {
    let away = Joint::revolute([0.0, 0.06]).stiffness(1.0).command(0.5);
    let open = Contact::new([0.0, 0.02], [1.0, 0.0]).series_stiffness(1e4, 8e3).friction(0.8).clearance(0.05);
    let stiff = [finger(-0.02, 0.06, 50.0), finger(0.02, 0.06, 50.0), Finger::new([away]).contact(open)];
    let hand = Hand::new(stiff).grasp().unwrap();
    let verdict = hand.hold(Wrench::force([1.0, 0.0])).unwrap();
    assert_eq!(verdict.holds(), Some(true), "{verdict}");
}
