//! For bodies with masses, the command line turns or accelerates the scene's gravity, and counts no weight twice.

use crate::{folder, run_on, text};

const ON_A_TRAY: &str = r#"{"format": "grasp-lcp/1", "planar": {"gravity": [0, -10],
    "bodies": [{"name": "box", "mass": 1, "centre_of_mass": [0, 0.05]}],
    "contacts": [{"name": "tray", "on": "box", "point": [0, 0], "normal": [0, 1], "friction": 0.4, "stiffness": 1e6, "soft": {"pair": {"width": 0.2}}}]}}"#;

fn told(arguments: &[&str]) -> String {
    let output = run_on(ON_A_TRAY.as_bytes(), arguments);
    assert!(output.stderr.is_empty(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

fn refused(arguments: &[&str]) -> String {
    let output = run_on(ON_A_TRAY.as_bytes(), arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    text(&output.stderr)
}

/// A box on a tray slides if the tangent of the tilt angle, or the acceleration divided by g, exceeds the coefficient of friction.
#[test]
fn of_their_own_weight() {
    let tilted = told(&["need", "-", "angle", "--may-slide"]);
    assert!(tilted.contains("TAKES 21.8014° anticlockwise and holds, 18.4349° "), "{tilted}");
    let turned = told(&["turn", "-"]);
    assert!(turned.starts_with("FIRST SLIP at 18.4349°: ") && turned.contains("from (0, -10) N"), "{turned}");
    let accelerated = told(&["hold", "-", "--acceleration", "2,0"]);
    assert!(accelerated.contains("4 N (2 times) until"), "{accelerated}");
    let shaken = told(&["need", "-", "load", "--acceleration", "1", "--may-slide"]);
    assert!(shaken.contains("TAKES 4 times") && shaken.contains(" 3.33333 times the load"), "{shaken}");
    assert!(told(&["shake", "-", "--acceleration", "1"]).starts_with("RESTS"));
    let output = folder("own_masses").display().to_string();
    let map = told(&["map", "-", "--base", "1,0", "-o", &output]);
    assert!(map.contains("on top of (1, 0) N and the loads of the bodies"), "{map}");
}

#[test]
fn a_weight_twice_is_refused() {
    let commands: [&[&str]; 4] = [
        &["hold", "-", "--mass", "1"],
        &["turn", "-", "--mass", "1"],
        &["shake", "-", "--mass", "1", "--acceleration", "1"],
        &["need", "-", "angle", "--mass", "1"],
    ];
    for command in commands {
        let told = refused(command);
        assert!(told.contains("--mass: ") && told.contains(" at box, "), "{command:?}: {told}");
    }
    let beside = refused(&["hold", "-", "--acceleration", "2,0", "--force", "1,0"]);
    assert!(beside.contains("--acceleration: accelerates"), "{beside}");
    // An additional load is given as a force.
    assert!(told(&["hold", "-", "--force", "0,-5"]).starts_with("HOLDS"));
    let jaws = ON_A_TRAY.replace(r#""gravity": [0, -10],"#, "");
    let output = run_on(jaws.as_bytes(), &["hold", "-", "--acceleration", "1,0"]);
    assert!(text(&output.stderr).contains("--acceleration without --mass"), "{}", text(&output.stderr));
}

/// Two boxes of 1 kg on each other, 0.2 m wide. A horizontal force that both share by mass acts at their centre of mass, 0.2 m up. It tips them at
/// 0.1/0.2 of their weight of 20 N.
#[test]
fn a_force_that_is_shared_acts_at_the_centre_of_mass() {
    let boxes = r#"{"format": "grasp-lcp/1", "planar": {"gravity": [0, -10], "shared_by_mass": true,
        "bodies": [{"name": "lower", "mass": 1, "centre_of_mass": [0, 0.1]}, {"name": "upper", "mass": 1, "centre_of_mass": [0, 0.3]}],
        "contacts": [{"on": "lower", "point": [0, 0], "normal": [0, 1], "friction": 0.8, "stiffness": 1e6, "soft": {"pair": {"width": 0.2}}},
            {"on": "upper", "against": "lower", "point": [0, 0.2], "normal": [0, 1], "friction": 0.8, "stiffness": 1e6, "soft": {"pair": {"width": 0.2}}}]}}"#;
    for (more, says) in [
        (&[][..], "TIPS OVER at 10 N of 20 N"),
        (&["--at", "0,0.2"], "TIPS OVER at 10 N of 20 N"),
        (&["--at", "0,0"], "SLIPS OUT at 16 N of 20 N"),
    ] {
        let output = run_on(boxes.as_bytes(), &[&["hold", "-", "--force", "20,0"], more].concat());
        assert!(text(&output.stdout).starts_with(says), "{more:?}: {}", text(&output.stdout));
    }
    // Each body of an arm that turns has an acceleration of its own.
    let output = run_on(boxes.as_bytes(), &["hold", "-", "--mass", "2", "--angular-velocity", "90"]);
    let message = text(&output.stderr);
    assert!(
        output.status.code() == Some(2) && message.contains("must be left out where bodies share loads"),
        "{message}"
    );
}

/// A mass on the command line has the weight that the gravity of the scene gives it, 10 m/s² here, if no body has a mass of its own.
#[test]
fn a_mass_weighs_as_the_scene_says() {
    let without = ON_A_TRAY.replace(r#", "mass": 1, "centre_of_mass": [0, 0.05]"#, "");
    let [mass, force] = [["--mass", "2"], ["--force", "0,-20"]].map(|load| {
        let output = run_on(without.as_bytes(), &[&["hold", "-", "--at", "0,0.05"], &load[..]].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    });
    assert_eq!(mass, force);
}

/// Each body is turned and accelerated at its own centre of mass, so that another point is refused, not ignored.
#[test]
fn a_point_beside_own_masses_is_refused() {
    let commands: [&[&str]; 2] =
        [&["turn", "-", "--at", "1,0"], &["shake", "-", "--acceleration", "1", "--at", "1,0"]];
    for arguments in commands {
        let said = refused(arguments);
        assert!(said.contains("--at"), "{said}");
    }
}

/// Beside gravity that turns, a constant force acts at the centre of mass, 0.05 m above the tray of 0.2 m. A force of -1 N on the box of 10 N slides it
/// where `1 + 10 sin θ = 4 cos θ`; the point that the moment unloads slides first, where `0.6 (1 + 10 sin θ) = 2 cos θ`. An acceleration along with the
/// tray is not such a force, and is refused.
#[test]
fn a_constant_force_beside_gravity_that_turns() {
    let slides = |times: f64| {
        let size = f64::hypot(10.0, times);
        (f64::asin(times / size) - f64::asin(1.0 / size)).to_degrees()
    };
    let words = told(&["turn", "-", "--base=-1,0"]);
    assert!(words.starts_with(&format!("FIRST SLIP at {:.4}°", slides(2.0 / 0.6))), "{words}");
    let words = told(&["need", "-", "angle", "--base=-1,0"]);
    assert!(words.starts_with(&format!("TAKES {:.2}", slides(4.0) - 0.004)), "{} {words}", slides(4.0));
    assert!(refused(&["need", "-", "angle", "--acceleration", "1,0"]).contains("`--base`"));
}

/// A crate of 98.1 N hangs below a rail, against which a rope pulls it with 150 N. Rail and rope take half of the weight's part along the normal each,
/// so that the crate slides at `98.1 sin θ = 0.4 (51.9 + 49.05 (1 - cos θ))`.
#[test]
fn a_tension_under_gravity_that_turns() {
    let scene = r#"{"format": "grasp-lcp/1", "planar": {"gravity": [0, -9.81],
        "bodies": [{"name": "crate", "mass": 10, "centre_of_mass": [0, 0.2]}],
        "contacts": [{"name": "rail", "on": "crate", "point": [0, 0.2], "normal": [0, -1], "stiffness": 1e6, "friction": 0.4, "soft": {"pair": {"width": 0.4}}}],
        "links": [{"name": "rope", "cable": {"from": [0, 0.2], "to": [0, 0.6]}, "tension": 150, "stiffness": 1e6, "on": "crate"}]}}"#;
    let slides = |angle: f64| 98.1 * angle.sin() - 0.4 * (51.9 + 49.05 * (1.0 - angle.cos()));
    let (mut from, mut to) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (from + to);
        if slides(middle) < 0.0 { from = middle } else { to = middle }
    }
    let output = run_on(scene.as_bytes(), &["need", "-", "angle", "--digits", "9"]);
    let words = text(&output.stdout);
    let angle: f64 = words["TAKES ".len()..].split('°').next().expect("an angle").parse().expect("a number");
    assert!(output.stderr.is_empty() && (angle - from.to_degrees()).abs() < 1e-3, "{from}: {words}");
}
