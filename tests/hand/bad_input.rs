//! Malformed hands get an error that names joint, field, value and what is allowed.

use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::Wrench;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use grasp_lcp::spatial::hand as spatial;
use grasp_lcp::{Error, Limit};

fn pad() -> Contact {
    Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1e3, 1e3).friction(0.5)
}

fn jaw() -> Joint {
    Joint::prismatic([1.0, 0.0]).stiffness(1e3)
}

fn refused(hand: Hand) -> String {
    hand.grasp().expect_err("malformed").to_string()
}

fn of_joint(joint: Joint) -> String {
    refused(Hand::new([Finger::new([joint]).contact(pad())]))
}

#[test]
fn numbers_of_joints_are_named() {
    assert_eq!(
        of_joint(jaw().stiffness(-1.0)),
        "joint 0: stiffness is -1, must be zero, or from 1e-50 to 1e50"
    );
    assert_eq!(
        of_joint(jaw().name("tip").command(f64::NAN)),
        "joint 0 (tip): command is NaN, must be finite and at most 1e50 in size"
    );
    assert!(of_joint(jaw().torque(f64::INFINITY)).starts_with("joint 0: torque is inf"));
    assert_eq!(
        of_joint(jaw().limit(Limit::Saturates(0.0))),
        "joint 0: limit is 0, must be from 1e-50 to 1e50"
    );
    assert!(
        of_joint(jaw().stiffness(0.0).limit(Limit::Slips(1.0)))
            .starts_with("joint 0: stiffness is 0, must be positive where there is a limit")
    );
    assert_eq!(
        of_joint(Joint::prismatic([0.0, 0.0]).stiffness(1.0)),
        "joint 0: axis is 0, must be of positive, finite length"
    );
    let moves_nothing = Finger::new([jaw(), jaw()]).contact_on(1, pad());
    assert_eq!(
        refused(Hand::new([moves_nothing])),
        "joint 1: motion of all contacts is 0, must be more than nothing"
    );
    let through_the_contact = Joint::revolute([0.0, 0.0]).stiffness(1.0);
    assert_eq!(
        of_joint(through_the_contact),
        "joint 0: motion of all contacts is 0, must be more than nothing"
    );
    let axis = spatial::Joint::revolute([0.0; 3], [0.0, f64::NAN, 0.0]).stiffness(1.0);
    let contact =
        grasp_lcp::spatial::Contact::new([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]).series_stiffness(1.0, 1.0);
    let error = spatial::Hand::new([spatial::Finger::new([axis]).contact(contact)]).grasp().unwrap_err();
    assert_eq!(error.to_string(), "joint 0: axis is NaN, must be of positive, finite length");
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
    assert_eq!(
        coupled([1.0, 0.5, 0.25, 1.0]).to_string(),
        "finger 0: stiffness matrix differs across its diagonal by 0.25, must be symmetric, with no eigenvalue below zero (a compliance: all above)"
    );
    let compliant = |entries: [f64; 4]| Finger::compliant([pad()], DMatrix::from_row_slice(2, 2, &entries));
    let Err(Error::Matrix { field: "compliance", value, .. }) =
        Hand::new([compliant([1.0, 1.0, 1.0, 1.0])]).grasp()
    else {
        panic!()
    };
    assert!(value.abs() < 1e-15);
    let three = Finger::compliant([pad()], DMatrix::identity(3, 3));
    assert_eq!(refused(Hand::new([three])), "compliance of finger 0: 3 x 3 given, must be 2 x 2");
    let jacobian = Finger::new([jaw()]).contact_moved_by(DMatrix::identity(2, 2), pad().name("thumb"));
    assert_eq!(refused(Hand::new([jacobian])), "jacobian of contact 0 (thumb): 2 x 2 given, must be 2 x 1");
}

#[test]
fn tendons_commands_and_coordinates_are_named() {
    let hand = || Hand::new([Finger::new([jaw()]).contact(pad())]);
    assert_eq!(
        refused(hand().tendon(Tendon::new([0.0]))),
        "tendon 0: arm over every joint is 0, must be more than nothing over one of them"
    );
    assert_eq!(
        refused(hand().tendon(Tendon::new([1.0, 1.0]))),
        "tendon 0: number of arms is 2, must be at most the number of joints"
    );
    let slips = Tendon::new([1.0]).name("flexor").stiffness(1.0).limit(Limit::Slips(1.0));
    assert!(refused(hand().tendon(slips)).starts_with("tendon 0 (flexor): limit is"));
    let grasp = hand().grasp().unwrap();
    assert_eq!(
        grasp.clone().with_joint_commands(&[0.0, 1.0]).unwrap_err().to_string(),
        "joint commands: 2 given, must be 1, one a joint and one a tendon"
    );
    assert!(matches!(grasp.clone().with_joint_commands(&[f64::NAN]), Err(Error::Hand { .. })));
    assert!(matches!(
        grasp.follow_in_steps(Wrench::ZERO, &[], 1e-4),
        Err(Error::NotForHands { question: "follow_in_steps" })
    ));
    assert!(matches!(Hand::new([]).grasp() as Result<grasp_lcp::planar::Grasp, _>, Err(Error::EmptyGrasp)));
    let link = Finger::new([jaw()]).contact_on(2, pad());
    assert_eq!(
        refused(Hand::new([link])),
        "contact 0: link is 2, must be at most the number of joints of its finger"
    );
}

#[test]
fn presses_are_checked_and_need_springs() {
    let message =
        |press: f64| grasp_lcp::planar::Grasp::new([pad().pressed_with(press)]).unwrap_err().to_string();
    assert_eq!(message(-1.0), "contact 0: pressing force is -1, must be from 0 to 1e50");
    assert!(message(f64::NAN).contains("pressing force is NaN"));
    let loose = Finger::new([jaw().stiffness(0.0)]).contact(pad().pressed_with(3.0));
    assert!(
        refused(Hand::new([loose])).starts_with("joint 0: stiffness is 0, must be positive where a contact")
    );
}
