//! Collision shapes of links give the same contacts on a part as pads of the same shape.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use grasp_lcp::robot::Robot;
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use grasp_lcp::touch::{Pad, Part, Touch};
use serde_json::{Value, json};

/// A robot with two jaws that slide towards each other, 60 mm apart, each with this collision element.
fn gripper(collision: &str) -> String {
    let jaw = |name: &str, x: f64, axis: f64| {
        format!(
            r#"<link name="{name}">{collision}</link><joint name="{name} slide" type="prismatic"><parent link="base"/><child link="{name}"/>
            <origin xyz="{x} 0 0"/><axis xyz="{axis} 0 0"/><limit lower="0" upper="0.02" effort="40" velocity="1"/></joint>"#
        )
    };
    format!(
        r#"<robot name="gripper"><link name="base"/>{}{}</robot>"#,
        jaw("left", -0.03, 1.0),
        jaw("right", 0.03, -1.0)
    )
}

fn shape(geometry: &str) -> String {
    format!(r#"<collision><origin xyz="0 0.001 0"/><geometry>{geometry}</geometry></collision>"#)
}

const BOX: &str = r#"<box size="0.008 0.01 0.02"/>"#;
const CYLINDER: &str = r#"<cylinder radius="0.005" length="0.02"/>"#;

/// Corners and faces of a box about the origin.
fn cuboid(half: [f64; 3]) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let sign = |bit: usize, k: usize| if k >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let corners = (0..8).map(|k| [0, 1, 2].map(|a| half[a] * sign(a, k))).collect();
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (corners, sides.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect())
}

/// A folder with grippers of each kind, and next to the folder a package with a mesh.
fn folder() -> &'static Path {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("shapes");
        fs::create_dir_all(folder.join("urdf")).expect("a folder");
        fs::create_dir_all(folder.join("meshes")).expect("a folder");
        let (corners, faces) = cuboid([4.0, 5.0, 10.0]);
        let line = |[x, y, z]: &[f64; 3]| format!("v {x} {y} {z}\n");
        let face = |face: &[usize; 3]| format!("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
        let obj: String = corners.iter().map(line).chain(faces.iter().map(face)).collect();
        fs::write(folder.join("meshes/jaw.obj"), obj).expect("a file");
        let mesh = r#"<mesh filename="package://gripper/meshes/jaw.obj" scale="0.001 0.001 0.001"/>"#;
        for (name, geometry) in [("box", BOX), ("cylinder", CYLINDER), ("mesh", mesh)] {
            fs::write(folder.join(format!("urdf/{name}.urdf")), gripper(&shape(geometry))).expect("a file");
        }
        folder.join("urdf")
    });
    &FOLDER
}

/// The grasp of a block of 40 mm by the jaws of this file, with these fields of `touches`.
fn grasp(urdf: &str, touches: &[(&str, Value)]) -> Grasp {
    let (vertices, faces) = cuboid([0.02, 0.02, 0.02]);
    let jaw = |closing: f64| {
        let mut given = json!({ "from": [0.005 * closing, 0.001, 0], "closing": [closing, 0, 0] });
        for (name, value) in touches {
            given[*name] = value.clone();
        }
        json!([{ "touches": given, "tangent": [0, 1, 0], "friction": 0.5, "pressed_with": 30, "series_stiffness": [1e5, 5e4] }])
    };
    let scene = json!({ "format": "grasp-lcp/1", "spatial": { "part": { "vertices": vertices, "faces": faces },
        "robot": { "urdf": urdf, "stiffness": { "others": 2e4 }, "contacts": { "left": jaw(1.0), "right": jaw(-1.0) } } } });
    let scene = Scene::from_json(scene.to_string().as_bytes())
        .expect("a scene")
        .with_files_from(folder())
        .expect("files");
    let Some(setup) = scene.spatial() else { panic!("in space") };
    setup.grasp().expect("a grasp")
}

/// Checks that the load factors of first slip of two grasps agree to a relative error.
fn assert_alike(one: &Grasp, other: &Grasp, error: f64) {
    for load in [[0.0, 0.0, -1.0], [0.0, 1.0, 0.3]] {
        let load = Wrench::force_at(load, [0.0, 0.0, 0.004]);
        let onset = |grasp: &Grasp| grasp.onset(load).expect("an onset").factor().expect("held");
        let (first, second) = (onset(one), onset(other));
        assert!((first / second - 1.0).abs() < error, "{first} {second}");
    }
}

#[test]
fn a_box_is_a_rectangle() {
    let strips = ("strips", json!([1, 1]));
    let found = grasp("box.urdf", &[("collision_shapes", json!(true)), strips.clone()]);
    assert_alike(&found, &grasp("box.urdf", &[("rectangle", json!([0.01, 0.02])), strips.clone()]), 1e-9);
    // A mesh in the package of the robot, in mm.
    assert_alike(&found, &grasp("mesh.urdf", &[("collision_shapes", json!(true)), strips]), 1e-9);
}

#[test]
fn a_cylinder_is_a_round_finger() {
    let window = [("strips", json!([2, 1])), ("rectangle", json!([0.004, 0.02]))];
    let [strips, sides] = window.clone();
    let found = grasp("cylinder.urdf", &[("collision_shapes", json!(true)), strips, sides]);
    let [strips, sides] = window;
    assert_alike(&found, &grasp("cylinder.urdf", &[("round", json!(0.005)), strips, sides]), 1e-3);
}

/// A ball on an elastic foundation of modulus K has F = π K R δ² at the depth δ.
#[test]
fn a_ball_presses_with_the_square_of_its_depth() -> Result<(), grasp_lcp::Error> {
    let (radius, depth, modulus, thickness) = (0.01_f64, 1e-4, 1e6, 0.002);
    let robot = Robot::from_urdf(&gripper(&shape(&format!(r#"<sphere radius="{radius}"/>"#))))?;
    let ahead = Contact::new([0.0, 0.001, 0.0], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
    let width = 2.2 * (2.0 * radius * depth).sqrt();
    let (pad, place) = Pad::of_surface(&robot.surface("left")?, &ahead, Some([width; 2]), [15, 15])?;
    assert!((place.point() - ahead.point()).norm() > 0.99 * radius);
    let (corners, faces) = cuboid([0.02; 3]);
    let ahead = Contact::new([-0.05, 0.0, 0.0], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
    let wall = Part::new(&corners, &faces)?;
    let touched = Touch::new(pad.of_layer(modulus, thickness), ahead.command([depth, 0.0, 0.0])).on(&wall)?;
    let grasp = Grasp::new(touched.contacts().to_vec())?;
    // The block does not move: contacts on its other side are rigid compared with the layer.
    let rests = [[0.0, 0.0], [0.01, 0.0], [0.0, 0.01]].map(|[y, z]| {
        Contact::new([0.02, y, z], [-1.0, 0.0, 0.0]).series_stiffness(1e12, 1e12).friction(1.0)
    });
    let both = Grasp::new(grasp.contacts().iter().cloned().chain(rests))?;
    let outcome = both.solve(Wrench::ZERO)?;
    let state = outcome.equilibrium().expect("at rest");
    let force: f64 = state.contacts[..grasp.len()].iter().map(|contact| contact.force[0]).sum();
    let expected = std::f64::consts::PI * modulus / thickness * radius * depth * depth;
    assert!((force / expected - 1.0).abs() < 0.02, "{force} {expected}");
    Ok(())
}

#[test]
fn what_cannot_touch_is_named() {
    let fault = |collision: &str| {
        Robot::from_urdf(&gripper(collision)).expect("a robot").surface("left").unwrap_err().to_string()
    };
    assert!(fault("").contains("link left: has no collision shape"), "{}", fault(""));
    let mesh = fault(&shape(r#"<mesh filename="package://gripper/no.stl"/>"#));
    assert!(mesh.contains("link left: mesh package://gripper/no.stl is not found"), "{mesh}");
}
