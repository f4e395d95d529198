//! Invalid robot files, and names that a robot file does not have, are refused.

use grasp_lcp::Error;
use grasp_lcp::robot::Robot;

use crate::robots::{joint, robot, wrist_and_fingers};

fn fault(text: &str) -> String {
    told(&Robot::from_urdf(text).expect_err("is refused"))
}

fn told(error: &Error) -> String {
    let Error::Robot { fault } = error else { panic!("{error}") };
    fault.clone()
}

#[test]
fn a_text_that_is_no_robot_is_refused() {
    for text in ["", "<robot", "<scene/>"] {
        assert!(!fault(text).is_empty());
    }
    let error = told(&Robot::read("nowhere.urdf").expect_err("no file"));
    assert!(error.starts_with("nowhere.urdf: "), "{error}");
}

#[test]
fn joints_that_form_no_tree_are_named() {
    let axis = r#"<axis xyz="1 0 0"/>"#;
    let turns = |name: &str, between| joint(name, "continuous", between, axis);
    let looped = robot(&["a", "b"], &[turns("there", ["a", "b"]), turns("back", ["b", "a"])]);
    is(&fault(&looped), "joint there: ", "loop");
    let twice = robot(&["a", "b", "c"], &[turns("one", ["a", "b"]), turns("two", ["c", "b"])]);
    is(&fault(&twice), "link b: ", "two joints");
    let nowhere = robot(&["a", "b"], &[turns("one", ["a", "c"])]);
    is(&fault(&nowhere), "link c: ", "are a, b");
    let floats = robot(&["a", "b"], &[joint("free", "floating", ["a", "b"], axis)]);
    is(&fault(&floats), "joint free: ", "floating");
    let flat = robot(&["a", "b"], &[joint("flat", "continuous", ["a", "b"], r#"<axis xyz="0 0 0"/>"#)]);
    is(&fault(&flat), "joint flat: ", "axis");
    let itself = robot(
        &["a", "b"],
        &[joint("self", "continuous", ["a", "b"], &format!("{axis}<mimic joint=\"self\"/>"))],
    );
    is(&fault(&itself), "joint self: ", "mimics self");
}

#[test]
fn what_cannot_be_read_is_named() {
    let of = |more: &str| fault(&robot(&["a", "b"], &[joint("one", "revolute", ["a", "b"], more)]));
    is(&of(r#"<origin xyz="0 0"/>"#), "joint one: origin has xyz \"0 0\"", "must be 3 numbers");
    is(&of(r#"<limit lower="low"/>"#), "joint one: limit has lower \"low\"", "must be a number");
    is(&of("<mimic/>"), "joint one: mimic has no joint", "");
    let link = |shape: &str| {
        fault(&format!(r#"<robot><link name="a"><collision>{shape}</collision></link></robot>"#))
    };
    is(&link("<geometry/>"), "link a: collision has no geometry", "");
    is(&link("<geometry><cone/></geometry>"), "link a: cone is no shape", "must be box, ");
    is(&link("<geometry><box/></geometry>"), "link a: box has no size", "");
    let newer = |more: &str| {
        let text = robot(&["a", "b"], &[joint("one", "revolute", ["a", "b"], more)]);
        fault(&text.replace("<robot", r#"<robot version="1.2""#))
    };
    is(&newer(r#"<limit lower="1" upper="0"/>"#), "joint one: limits", "lower ≤ upper");
    is(&newer(r#"<origin rpy="0 0 0" quat_xyzw="0 0 0 1"/>"#), "joint one: origin has rpy", "one of them");
}

#[test]
fn numbers_belong_to_joints_that_move_by_themselves() {
    let robot = || Robot::from_urdf(&wrist_and_fingers()).expect("a robot");
    let refused = |error: Result<Robot, Error>| told(&error.expect_err("is refused"));
    is(&refused(robot().posed("end", 0.1)), "joint end: ", "is fixed");
    is(&refused(robot().commanded("opposite", 0.1)), "joint opposite: ", "mimics knuckle");
    is(&refused(robot().joint_stiffness("knuckle", f64::NAN)), "joint knuckle: ", "stiffness is NaN");
    is(&refused(robot().posed("thumb", 0.1)), "joint thumb: ", "are wrist, ");
    is(&told(&robot().pose("thumb").expect_err("no link")), "link thumb: ", "arm, palm");
}

/// Checks that the error names this link or joint, and contains this text.
fn is(fault: &str, of: &str, said: &str) {
    assert!(fault.starts_with(of) && fault.contains(said), "{fault}");
}
