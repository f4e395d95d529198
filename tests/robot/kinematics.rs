//! Poses of links agree with products of homogeneous matrices.

use grasp_lcp::nalgebra::{Isometry3, Matrix4, Vector3};
use grasp_lcp::robot::Robot;

use crate::robots::{joint, robot, wrist_and_fingers};

/// The pose of a URDF `origin`: roll about x, then pitch about y, then yaw about z, then the translation.
fn origin(place: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Matrix4<f64> {
    let at = Matrix4::new_translation(&Vector3::from(place));
    at * about([0.0, 0.0, 1.0], yaw) * about([0.0, 1.0, 0.0], pitch) * about([1.0, 0.0, 0.0], roll)
}

/// The rotation about an axis by Rodrigues' formula.
fn about(axis: [f64; 3], angle: f64) -> Matrix4<f64> {
    let cross = Vector3::from(axis).cross_matrix();
    let turned = cross * angle.sin() + cross * cross * (1.0 - angle.cos());
    Matrix4::identity() + turned.to_homogeneous() - Matrix4::from_diagonal(&[0.0, 0.0, 0.0, 1.0].into())
}

fn near(pose: Isometry3<f64>, expected: Matrix4<f64>) {
    let off = (pose.to_homogeneous() - expected).amax();
    assert!(off < 1e-15, "{off}");
}

#[test]
fn links_are_where_homogeneous_matrices_have_them() {
    let (wrist, knuckle, bend) = (0.7, -0.4, 0.55);
    let base = Isometry3::new(Vector3::new(0.1, -0.2, 0.3), Vector3::new(0.0, 0.0, 0.5));
    let robot = Robot::from_urdf(&wrist_and_fingers()).expect("a robot").placed(base);
    let robot = robot.posed("wrist", wrist).and_then(|r| r.posed("knuckle", knuckle));
    let robot = robot.and_then(|r| r.posed("bend", bend)).expect("joints");

    let palm =
        base.to_homogeneous() * origin([0.0, 0.0, 0.02], [0.1, -0.2, 0.3]) * about([0.0, 0.6, 0.8], wrist);
    let one = palm * origin([-0.04, 0.0, 0.03], [0.4, 0.2, -0.1]) * about([0.0, 1.0, 0.0], knuckle);
    let one_end = one * origin([0.0, 0.0, 0.03], [0.0, 0.3, 0.0]) * about([0.6, 0.8, 0.0], bend);
    let two =
        palm * origin([0.04, 0.0, 0.03], [0.2, 0.0, 0.0]) * about([0.0, -1.0, 0.0], 0.75 * knuckle + 0.1);
    let reach = 0.02 * bend + 0.1;
    let two_end = two
        * origin([0.0, 0.0, 0.03], [0.0, -0.2, 0.0])
        * Matrix4::new_translation(&(Vector3::new(0.0, 0.28, 0.96) * reach));

    near(robot.pose("palm").expect("a link"), palm);
    near(robot.pose("one_end").expect("a link"), one_end);
    near(robot.pose("one_tip").expect("a link"), one_end * origin([0.002, 0.0, 0.025], [0.0, 0.0, 0.5]));
    near(robot.pose("two_end").expect("a link"), two_end);
}

#[test]
fn joints_are_listed_from_the_root_outwards() {
    let robot = Robot::from_urdf(&wrist_and_fingers()).expect("a robot");
    let names = |link: &str| {
        robot.joints_of(link).expect("a link").iter().map(|joint| joint.name().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(names("one_tip"), ["wrist", "knuckle", "bend"]);
    assert_eq!(names("two_end"), ["wrist", "opposite", "reach"]);
    assert!(names("arm").is_empty());
    let knuckle = robot.joints_of("one").expect("a link")[1];
    assert_eq!((knuckle.range(), knuckle.effort()), ([-1.0, 1.0], 2.0));
}

#[test]
fn newer_versions_have_quaternions_and_joints_without_limits() {
    let more = r#"<origin xyz="1 2 3" quat_xyzw="0.5 0.5 0.5 0.5"/><limit effort="3"/>"#;
    let text = robot(&["a", "b"], &[joint("one", "revolute", ["a", "b"], more)]);
    let read = |version: &str| {
        Robot::from_urdf(&text.replace("<robot", &format!(r#"<robot version="{version}""#))).expect("a robot")
    };
    near(read("1.0").pose("b").expect("a link"), origin([1.0, 2.0, 3.0], [0.0; 3]));
    let quarter = std::f64::consts::FRAC_PI_2;
    near(read("1.1").pose("b").expect("a link"), origin([1.0, 2.0, 3.0], [quarter, 0.0, quarter]));
    let ranges = ["1.1", "1.2"].map(|version| read(version).joints()[0].range());
    assert_eq!(ranges, [[0.0; 2], [f64::NEG_INFINITY, f64::INFINITY]]);
}
