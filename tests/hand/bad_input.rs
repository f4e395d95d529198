//! Malformed hands return an error with the joint, the field, the value and the allowed range.

use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::Wrench;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use grasp_lcp::spatial::hand as spatial;
use grasp_lcp::{Error, Limit};
use support::facts;

fn pad() -> Contact {
    Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1e3, 1e3).friction(0.5)
}

fn jaw() -> Joint {
    Joint::prismatic([1.0, 0.0]).stiffness(1e3)
}

/// The place, the datum and the value of the error.
fn refused(hand: Hand) -> [String; 3] {
    facts(&hand.grasp().expect_err("malformed"))
}

fn of_joint(joint: Joint) -> [String; 3] {
    refused(Hand::new([Finger::new([joint]).contact(pad())]))
}

#[test]
fn numbers_of_joints_are_named() {
    assert_eq!(of_joint(jaw().stiffness(-1.0)), ["joint 0", "stiffness", "-1"]);
    assert_eq!(of_joint(jaw().name("tip").command(f64::NAN)), ["joint 0 (tip)", "command", "NaN"]);
    assert_eq!(of_joint(jaw().torque(f64::INFINITY)), ["joint 0", "torque", "inf"]);
    assert_eq!(of_joint(jaw().limit(Limit::Saturates(0.0))), ["joint 0", "limit", "0"]);
    assert_eq!(of_joint(jaw().stiffness(0.0).limit(Limit::Slips(1.0))), ["joint 0", "stiffness", "0"]);
    assert_eq!(of_joint(Joint::prismatic([0.0, 0.0]).stiffness(1.0)), ["joint 0", "axis", "0"]);
    let moves_nothing = Finger::new([jaw(), jaw()]).contact_on(1, pad());
    let through_the_contact = Joint::revolute([0.0, 0.0]).stiffness(1.0);
    for ([place, datum, value], joint) in
        [(refused(Hand::new([moves_nothing])), "joint 1"), (of_joint(through_the_contact), "joint 0")]
    {
        assert!(place == joint && datum.starts_with("motion") && value == "0", "{place} {datum} {value}");
    }
    let axis = spatial::Joint::revolute([0.0; 3], [0.0, f64::NAN, 0.0]).stiffness(1.0);
    let contact =
        grasp_lcp::spatial::Contact::new([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]).series_stiffness(1.0, 1.0);
    let error = spatial::Hand::new([spatial::Finger::new([axis]).contact(contact)]).grasp().unwrap_err();
    assert_eq!(facts(&error), ["joint 0", "axis", "NaN"]);
}

#[test]
fn matrices_say_their_eigenvalue() {
    let coupled = |entries: [f64; 4]| {
        let finger =
            Finger::new([jaw(), jaw()]).coupled(DMatrix::from_row_slice(2, 2, &entries)).contact(pad());
        Hand::new([finger]).grasp().expect_err("malformed")
    };
    let Error::Matrix { value, .. } = coupled([1.0, 2.0, 2.0, 1.0]) else { panic!() };
    assert!((value + 1.0).abs() < 1e-14);
    let uneven = coupled([1.0, 0.5, 0.25, 1.0]);
    assert_eq!(facts(&uneven), ["finger 0", "stiffness matrix", "0.25"]);
    assert!(matches!(uneven, Error::Matrix { fault, .. } if fault.contains("diagonal")));
    let compliant = |entries: [f64; 4]| Finger::compliant([pad()], DMatrix::from_row_slice(2, 2, &entries));
    let Err(Error::Matrix { field: "compliance", value, .. }) =
        Hand::new([compliant([1.0, 1.0, 1.0, 1.0])]).grasp()
    else {
        panic!()
    };
    assert!(value.abs() < 1e-15);
    let three = Finger::compliant([pad()], DMatrix::identity(3, 3));
    assert_eq!(refused(Hand::new([three])), ["compliance of finger 0", "2 x 2", "3 x 3"]);
    let jacobian = Finger::new([jaw()]).contact_moved_by(DMatrix::identity(2, 2), pad().name("thumb"));
    let [matrix, needed, given] = refused(Hand::new([jacobian]));
    assert!(matrix.starts_with("jacobian") && matrix.ends_with("contact 0 (thumb)"), "{matrix}");
    assert_eq!([needed, given], ["2 x 1", "2 x 2"]);
}

#[test]
fn tendons_commands_and_coordinates_are_named() {
    let hand = || Hand::new([Finger::new([jaw()]).contact(pad())]);
    let [tendon, arm, value] = refused(hand().tendon(Tendon::new([0.0])));
    assert!(tendon == "tendon 0" && arm.starts_with("arm") && value == "0", "{tendon} {arm} {value}");
    assert_eq!(refused(hand().tendon(Tendon::new([1.0, 1.0]))), ["tendon 0", "number of arms", "2"]);
    assert_eq!(refused(hand().tendon(Tendon::new([]))), ["tendon 0", "number of arms", "0"]);
    let slips = Tendon::new([1.0]).name("flexor").stiffness(1.0).limit(Limit::Slips(1.0));
    assert_eq!(refused(hand().tendon(slips))[..2], ["tendon 0 (flexor)", "limit"]);
    let grasp = hand().grasp().unwrap();
    let refusal = grasp.clone().with_joint_commands(&[0.0, 1.0]).unwrap_err();
    assert_eq!(refusal, Error::JointCommands { what: "joint commands", given: 2, expected: 1 });
    assert!(matches!(grasp.clone().with_joint_commands(&[f64::NAN]), Err(Error::Hand { .. })));
    assert!(matches!(
        grasp.follow_in_steps(Wrench::ZERO, &[], 1e-4),
        Err(Error::NotForHands { question: "follow_in_steps" })
    ));
    assert!(matches!(Hand::new([]).grasp() as Result<grasp_lcp::planar::Grasp, _>, Err(Error::EmptyGrasp)));
    let link = Finger::new([jaw()]).contact_on(2, pad());
    assert_eq!(refused(Hand::new([link])), ["contact 0", "link", "2"]);
}

#[test]
fn presses_are_checked_and_need_springs() {
    let pressed =
        |press: f64| facts(&grasp_lcp::planar::Grasp::new([pad().pressed_with(press)]).unwrap_err());
    assert_eq!(pressed(-1.0), ["0", "pressing force", "-1"]);
    assert_eq!(pressed(f64::NAN), ["0", "pressing force", "NaN"]);
    let loose = Finger::new([jaw().stiffness(0.0)]).contact(pad().pressed_with(3.0));
    assert_eq!(refused(Hand::new([loose])), ["joint 0", "stiffness", "0"]);
}
