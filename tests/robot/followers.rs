//! Contacts move with the joints of their links, including joints that mimic others.

use grasp_lcp::grasp::JointKind;
use grasp_lcp::nalgebra::{DMatrix, Point3};
use grasp_lcp::robot::Robot;
use grasp_lcp::spatial::hand::{Finger, Hand, Joint};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};

use crate::robots::{joint, robot, wrist_and_fingers};

const AT: [f64; 3] = [0.0, 0.0, 0.06];

fn tip(point: [f64; 3], inward: f64) -> Contact {
    // Bonded, so that forces are linear in the load for every pose of the links.
    Contact::new(point, [inward, 0.1, 0.0]).series_stiffness(5e3, 4e3).bonded().pressed_with(6.0)
}

fn posed(knuckle: f64, bend: f64, wrist: f64) -> Robot {
    let robot = Robot::from_urdf(&wrist_and_fingers()).expect("a robot").stiffness(4.0);
    let robot = robot.posed("knuckle", knuckle).and_then(|r| r.posed("bend", bend));
    let robot = robot.and_then(|r| r.posed("wrist", wrist)).and_then(|r| r.joint_stiffness("wrist", 30.0));
    robot.expect("joints")
}

/// Under a load the robot's hand has the forces and motion of a hand whose Jacobians are differences of poses.
#[test]
fn contacts_move_as_differences_of_poses_say() {
    let (knuckle, bend, wrist) = (0.2, 0.1, 0.3);
    let robot = posed(knuckle, bend, wrist);
    let places = [
        ("one_tip", [0.004, 0.001, 0.0], 1.0),
        ("two_end", [-0.004, 0.0, 0.01], -1.0),
        ("palm", [0.0, 0.02, 0.04], 1.0),
    ];
    let contacts: Vec<_> = places
        .iter()
        .map(|(link, place, inward)| robot.on_link(link, &tip(*place, *inward)).expect("a contact"))
        .collect();
    let step = 1e-5;
    let at = |index: usize, by: [f64; 3]| {
        let moved = posed(knuckle + by[1], bend + by[2], wrist + by[0]);
        moved.pose(places[index].0).expect("a link") * Point3::from(places[index].1)
    };
    let joints = ["wrist", "knuckle", "bend"].map(|name| {
        let stiffness = if name == "wrist" { 30.0 } else { 4.0 };
        Joint::given().name(name).stiffness(stiffness)
    });
    let mut finger = Finger::new(joints);
    for (index, (_, contact)) in contacts.iter().enumerate() {
        let column = |j: usize| {
            let mut by = [0.0; 3];
            by[j] = step;
            (at(index, by) - at(index, by.map(|x| -x))) / (2.0 * step)
        };
        let columns = [column(0), column(1), column(2)];
        let jacobian = DMatrix::from_fn(3, 3, |a, j| columns[j][a]);
        finger = finger.contact_moved_by(jacobian, contact.clone());
    }
    let expected = Hand::new([finger]).grasp().expect("a grasp");
    let grasp = robot.hand(&contacts).expect("a hand").grasp().expect("a grasp");
    for load in [[0.5, 0.2, -0.4], [0.0, 0.8, 0.3]] {
        let load = Wrench::force_at(load, AT);
        let state =
            |grasp: &Grasp| grasp.solve(load).expect("answered").equilibrium().cloned().expect("holds");
        let (one, other) = (state(&grasp), state(&expected));
        for (one, other) in one.contacts.iter().zip(&other.contacts) {
            assert!((one.force_world - other.force_world).norm() < 1e-8, "{one:?} {other:?}");
        }
    }
    let joints = &grasp.solve(Wrench::ZERO).expect("answered").equilibrium().cloned().expect("holds").joints;
    assert_eq!(joints.len(), 3);
    assert!(joints.iter().all(|joint| joint.kind == JointKind::Turns));
}

/// Two jaws that slide towards each other on a sliding carriage. The second jaw mimics the first.
fn jaws() -> Robot {
    let slide = |xyz: &str, axis: &str, more: &str| {
        format!(
            r#"<origin xyz="{xyz}"/><axis xyz="{axis}"/><limit lower="0" upper="1" effort="9" velocity="1"/>{more}"#
        )
    };
    let text = robot(
        &["ground", "carriage", "left", "right"],
        &[
            joint("carry", "prismatic", ["ground", "carriage"], &slide("0 0 0", "1 0 0", "")),
            joint("close", "prismatic", ["carriage", "left"], &slide("-0.03 0 0", "1 0 0", "")),
            joint(
                "follow",
                "prismatic",
                ["carriage", "right"],
                &slide("0.03 0 0", "-1 0 0", r#"<mimic joint="close"/>"#),
            ),
        ],
    );
    Robot::from_urdf(&text).expect("a robot")
}

/// A pull along the motion of coupled jaws does not open or close them. The carriage (stiffness K) and both pads (k each) are in series, with the
/// compliance `1/K + 1/2k`. Independent jaws would also give way by the springs of their drives.
#[test]
fn jaws_that_close_together_hold_their_middle() {
    let (carriage, pad) = (2e3, 5e3);
    let robot = jaws().stiffness(100.0).joint_stiffness("carry", carriage).expect("a joint");
    let jaw = |side: f64| {
        Contact::new([0.0; 3], [side, 0.0, 0.0]).series_stiffness(pad, pad).friction(0.5).pressed_with(8.0)
    };
    let contacts =
        [robot.on_link("left", &jaw(1.0)), robot.on_link("right", &jaw(-1.0))].map(|c| c.expect("on a link"));
    let grasp = robot.hand(&contacts).expect("a hand").grasp().expect("a grasp");
    let rest = grasp.solve(Wrench::ZERO).expect("answered").equilibrium().cloned().expect("holds");
    assert!(rest.contacts.iter().all(|contact| (contact.normal_force() - 8.0).abs() < 1e-12));
    let pulled =
        grasp.solve(Wrench::force([3.0, 0.0, 0.0])).expect("answered").equilibrium().cloned().expect("holds");
    let expected = 3.0 * (1.0 / carriage + 1.0 / (2.0 * pad));
    assert!(
        (pulled.twist.translation()[0] / expected - 1.0).abs() < 1e-12,
        "{} {expected}",
        pulled.twist.translation()[0]
    );
}

/// A contact on the root link, which no joint moves, comes first in the list of contacts.
#[test]
fn a_contact_on_the_root_comes_first() {
    let robot = jaws().stiffness(100.0);
    let jaw = |side: f64, name: &str| {
        Contact::new([0.0, 0.0, 0.0], [side, 0.0, 0.0])
            .series_stiffness(1e4, 1e4)
            .friction(0.5)
            .pressed_with(8.0)
            .name(name)
    };
    let wall = jaw(-1.0, "wall");
    let contacts = [robot.on_link("left", &jaw(1.0, "jaw")), robot.on_link("ground", &wall)]
        .map(|c| c.expect("on a link"));
    let grasp = robot.hand(&contacts).expect("a hand").grasp().expect("a grasp");
    assert_eq!(grasp.contacts()[0].label_text(0), "wall");
    assert_eq!(grasp.joint_commands().len(), 2);
}
