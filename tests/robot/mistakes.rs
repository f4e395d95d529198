//! What a description file must not be, and names that it does not have.

use grasp_lcp::robot::Robot;

use crate::robots::{joint, robot, wrist_and_fingers};

fn fault(text: &str) -> String {
    Robot::from_urdf(text).expect_err("is refused").to_string()
}

#[test]
fn a_text_that_is_no_robot_is_refused() {
    for text in ["", "<robot", "<scene/>"] {
        assert!(fault(text).starts_with("robot: "), "{}", fault(text));
    }
    let error = Robot::read("nowhere.urdf").expect_err("no file").to_string();
    assert!(error.starts_with("robot: nowhere.urdf: "), "{error}");
}

#[test]
fn joints_that_form_no_tree_are_named() {
    let axis = r#"<axis xyz="1 0 0"/>"#;
    let turns = |name: &str, between| joint(name, "continuous", between, axis);
    let looped = robot(&["a", "b"], &[turns("there", ["a", "b"]), turns("back", ["b", "a"])]);
    assert_eq!(fault(&looped), "robot: joint there: is in a loop, joints must form a tree");
    let twice = robot(&["a", "b", "c"], &[turns("one", ["a", "b"]), turns("two", ["c", "b"])]);
    assert_eq!(fault(&twice), "robot: link b: two joints carry it, must be one");
    let nowhere = robot(&["a", "b"], &[turns("one", ["a", "c"])]);
    assert_eq!(fault(&nowhere), "robot: link c: is not there, there are a, b");
    let floats = robot(&["a", "b"], &[joint("free", "floating", ["a", "b"], axis)]);
    assert!(
        fault(&floats).starts_with("robot: joint free: is Floating, must be revolute"),
        "{}",
        fault(&floats)
    );
    let flat = robot(&["a", "b"], &[joint("flat", "continuous", ["a", "b"], r#"<axis xyz="0 0 0"/>"#)]);
    assert_eq!(fault(&flat), "robot: joint flat: axis has no direction");
    let itself = robot(
        &["a", "b"],
        &[joint("self", "continuous", ["a", "b"], &format!("{axis}<mimic joint=\"self\"/>"))],
    );
    assert_eq!(fault(&itself), "robot: joint self: mimics self, must be a joint that moves by itself");
}

#[test]
fn numbers_belong_to_joints_that_move_by_themselves() {
    let robot = || Robot::from_urdf(&wrist_and_fingers()).expect("a robot");
    let refused = |error: Result<Robot, grasp_lcp::Error>| error.expect_err("is refused").to_string();
    assert_eq!(refused(robot().posed("end", 0.1)), "robot: joint end: is fixed");
    assert_eq!(
        refused(robot().commanded("opposite", 0.1)),
        "robot: joint opposite: mimics knuckle: set that of the joint it follows"
    );
    assert_eq!(
        refused(robot().joint_stiffness("knuckle", f64::NAN)),
        "robot: joint knuckle: stiffness is NaN, must be finite and at most 1e50 in size"
    );
    assert!(
        refused(robot().posed("thumb", 0.1))
            .starts_with("robot: joint thumb: is not there, there are wrist, ")
    );
    let error = robot().pose("thumb").expect_err("no link").to_string();
    assert!(error.starts_with("robot: link thumb: is not there, there are arm, palm"), "{error}");
}
