//! A scene may have a robot in place of fingers. Its hand equals the hand built in Rust.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use grasp_lcp::Limit;
use grasp_lcp::grasp::SoftFingertip;
use grasp_lcp::nalgebra::{Isometry3, Translation3, UnitQuaternion};
use grasp_lcp::robot::Robot;
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use serde_json::{Value, json};

use crate::robots::wrist_and_fingers;

/// The folder with the robot file, written at first use.
fn folder() -> &'static Path {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("robot");
        fs::create_dir_all(&folder).expect("a folder");
        fs::write(folder.join("hand.urdf"), wrist_and_fingers()).expect("a file");
        folder
    });
    &FOLDER
}

fn tip(inward: f64) -> Value {
    json!({ "point": [0.004 * inward, 0.001, 0], "normal": [inward, 0.1, 0], "series_stiffness": [5e3, 4e3], "hold": "bonded",
        "pressed_with": 6, "soft": { "ring": { "radius": 0.003, "points": 4 } } })
}

fn scene() -> Value {
    json!({ "format": "grasp-lcp/1", "spatial": {
        "robot": { "urdf": "hand.urdf", "at": [0.01, 0, 0], "turned_deg": [0, 30, 10],
            "joints": { "knuckle": 10, "bend": 5, "wrist": 20 }, "commanded": { "bend": 7 },
            "stiffness": { "others": 4, "wrist": 30 }, "effort": "from file",
            "contacts": { "one_tip": [tip(1.0)], "two_end": [tip(-1.0)] } },
        "questions": [{ "solve": { "load": { "force": [0, 1, 0] } } }] } })
}

fn read(scene: &Value) -> Result<Scene, String> {
    Scene::from_json(scene.to_string().as_bytes()).map_err(|fault| fault.to_string())
}

fn grasp_of(scene: &Scene) -> Grasp {
    let Some(setup) = scene.spatial() else { panic!("in space") };
    setup.grasp().expect("a grasp")
}

/// The hand of the scene, built in Rust from its points.
fn hand() -> Grasp {
    let turned = UnitQuaternion::from_euler_angles(0.0, 30_f64.to_radians(), 10_f64.to_radians());
    let robot = Robot::read(folder().join("hand.urdf")).expect("a robot").stiffness(4.0).limited_by_effort();
    let robot = robot.placed(Isometry3::from_parts(Translation3::new(0.01, 0.0, 0.0), turned));
    let mut robot = robot.joint_stiffness("wrist", 30.0).expect("a joint");
    for (name, degrees) in [("knuckle", 10.0_f64), ("bend", 5.0), ("wrist", 20.0)] {
        robot = robot.posed(name, degrees.to_radians()).expect("a joint");
    }
    let robot = robot.commanded("bend", 7_f64.to_radians()).expect("a joint");
    let mut contacts = Vec::new();
    for (link, inward) in [("one_tip", 1.0), ("two_end", -1.0)] {
        let contact = Contact::new([0.004 * inward, 0.001, 0.0], [inward, 0.1, 0.0])
            .series_stiffness(5e3, 4e3)
            .bonded()
            .pressed_with(6.0);
        for point in SoftFingertip::<3>::ring(0.003, 4).expect("a ring").contacts(&contact).expect("points") {
            contacts.push(robot.on_link(link, &point).expect("on a link"));
        }
    }
    robot.hand(&contacts).expect("a hand").grasp().expect("a grasp")
}

#[test]
fn a_scene_has_the_hand_of_its_robot() {
    let scene = read(&scene()).expect("a scene").with_files_from(folder()).expect("its robot");
    let (one, other) = (grasp_of(&scene), hand());
    for pull in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]] {
        let state = |grasp: &Grasp| {
            let outcome = grasp.solve(Wrench::force_at(pull, [0.0, 0.0, 0.06])).expect("answered");
            outcome.equilibrium().cloned().expect("holds")
        };
        let (one, other) = (state(&one), state(&other));
        assert_eq!(one.contacts.len(), 8);
        for (one, other) in one.contacts.iter().zip(&other.contacts) {
            assert!((one.force_world - other.force_world).norm() < 1e-12, "{one:?} {other:?}");
        }
        let torques =
            one.joints.iter().zip(&other.joints).map(|(one, other)| (one.torque - other.torque).abs());
        assert!(torques.fold(0.0, f64::max) < 1e-12);
    }
    let Some(setup) = scene.spatial() else { panic!("in space") };
    let joints = &setup.fingers[0].joints;
    assert_eq!(joints.len(), 3);
    let written = serde_json::to_value(joints).expect("written");
    assert_eq!(written[0]["name"], "wrist");
    assert_eq!(written[1]["limit"], json!(Limit::Saturates(2.0)));
    assert!((written[2]["command"].as_f64().expect("a number") - 2_f64.to_radians()).abs() < 1e-16);
}

/// A scene that is written before its file is read keeps the robot. Afterwards it has fingers and needs no file.
#[test]
fn a_scene_is_written_and_read_again() {
    let before = read(&scene()).expect("a scene");
    let again = read(&serde_json::to_value(&before).expect("written")).expect("read");
    assert_eq!(again, before);
    let scene = before.with_files_from(folder()).expect("its robot");
    let again = read(&serde_json::to_value(&scene).expect("written")).expect("read");
    assert_eq!(grasp_of(&again).contacts(), grasp_of(&scene).contacts());
    assert!(again.answers().is_ok());
}

#[test]
fn mistakes_in_a_robot_are_named() {
    let with = |change: &dyn Fn(&mut Value)| {
        let mut scene = scene();
        change(&mut scene["spatial"]["robot"]);
        read(&scene).and_then(|scene| scene.with_files_from(folder()).map_err(|error| error.to_string()))
    };
    for (said, change) in [
        ("contacts: none given", &(|robot: &mut Value| robot["contacts"] = json!({})) as &dyn Fn(&mut Value)),
        ("joint thumb: is", &|robot| robot["joints"] = json!({ "thumb": 4 })),
        // The joint "knuckle" has the limits -1 and 1 rad.
        ("knuckle: position is 58, must be from -57.2", &|robot| robot["joints"] = json!({ "knuckle": 58 })),
        // A command beyond these limits is no force: the controller stops there.
        ("knuckle: command is -60, must be from -57.2", &|robot| {
            robot["commanded"] = json!({ "knuckle": -60 });
        }),
        ("bend: is commanded without", &|robot| robot["stiffness"] = json!({ "wrist": 30, "knuckle": 4 })),
        ("joint thumb: is", &|robot| robot["stiffness"] = json!({ "thumb": 4 })),
        ("link thumb: is", &|robot| robot["contacts"] = json!({ "thumb": [tip(1.0)] })),
        ("nowhere.urdf", &|robot| robot["urdf"] = json!("nowhere.urdf")),
        ("from file", &|robot| robot["effort"] = json!("by hand")),
    ] {
        let error = with(change).expect_err("is refused");
        assert!(error.contains(said), "{error}");
    }
}
