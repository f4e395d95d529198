//! An uncertain squeeze applies to every part that presses: commands, constant forces, torques and tensions, vacuums, and straps with a given
//! tension.

use grasp_lcp::planar::{Grasp, Wrench};
use grasp_lcp::scene::Scene;
use grasp_lcp::sweep::Uncertainty;

type Tested = Result<(), Box<dyn std::error::Error>>;
/// A scene as text, as a function of the factor on its only squeeze.
type PressedScene = Box<dyn Fn(f64) -> String>;

fn grasp(planar: &str) -> Result<Grasp, Box<dyn std::error::Error>> {
    let text = format!(r#"{{ "format": "grasp-lcp/1", "planar": {{ {planar} }} }}"#);
    Ok(Scene::from_json(text.as_bytes())?.planar().ok_or("a planar scene")?.grasp()?)
}

/// Two pads: one that slides first, and one that sticks longer.
fn pads(y: [f64; 2], more: &str) -> String {
    let pad = |y: f64, friction: f64| {
        format!(
            r#"{{ "point": [0, {y}], "normal": [1, 0], "friction": {friction}, "stiffness": 1e5 {more} }}"#
        )
    };
    format!("{}, {}", pad(y[0], 0.3), pad(y[1], 0.9))
}

/// A finger on the right of the pads, on a joint 80 mm above, with the data `drive`.
fn finger(drive: &str, tendon: &str) -> String {
    format!(
        r#""contacts": [{}], "fingers": [{{ "joints": [{{ "revolute": {{ "point": [0.05, 0.08] }} {drive} }}],
        "contacts": [{{ "point": [0.05, 0], "normal": [-1, 0], "friction": 2, "stiffness": 1e4 }}] }}] {tendon}"#,
        pads([-0.02, 0.02], "")
    )
}

/// Scenes with one kind of squeeze each, multiplied by a number. With each come a load at rest, and a load that makes the first pad slide.
fn scenes() -> Vec<(&'static str, PressedScene, Wrench, Wrench)> {
    let down = Wrench::force([0.0, -1.0]);
    let strap = |x: f64, more: &str| {
        format!(
            r#""links": [{{ "name": "strap", "cable": {{ "from": [0.2, 0], "to": [-0.05, 0] }}, "stiffness": 5e4, "tension": {} {more} }}]"#,
            300.0 * x
        )
    };
    let strapped = strap;
    vec![
        (
            "the tension of a tendon",
            Box::new(|x| {
                finger("", &format!(r#", "tendons": [{{ "arms": [-0.01], "tension": {} }}]"#, 40.0 * x))
            }),
            Wrench::ZERO,
            down,
        ),
        (
            "the pull of a tendon",
            Box::new(|x| {
                let pull = format!(
                    r#", "tendons": [{{ "arms": [-0.01], "stiffness": 2e4, "pull": {} }}]"#,
                    2e-3 * x
                );
                finger("", &pull)
            }),
            Wrench::ZERO,
            down,
        ),
        (
            "the command of a joint",
            Box::new(|x| finger(&format!(r#", "stiffness": 5, "command": {}"#, -0.1 * x), "")),
            Wrench::ZERO,
            down,
        ),
        (
            "the torque of a joint",
            Box::new(|x| finger(&format!(r#", "torque": {}"#, -0.4 * x), "")),
            Wrench::ZERO,
            down,
        ),
        (
            "the force of a contact",
            Box::new(|x| {
                let held = format!(
                    r#"{{ "point": [0.05, 0], "normal": [-1, 0], "friction": 2, "stiffness": 1e4, "force": {} }}"#,
                    20.0 * x
                );
                format!(r#""contacts": [{}, {held}]"#, pads([-0.02, 0.02], ""))
            }),
            Wrench::ZERO,
            down,
        ),
        (
            "the tension of a strap",
            Box::new(move |x| format!(r#""contacts": [{}], {}"#, pads([-0.1, 0.1], ""), strap(x, ""))),
            Wrench::ZERO,
            down,
        ),
        (
            "the tension of a strap beside a weight",
            Box::new(move |x| {
                let pads = pads([-0.1, 0.1], r#", "on": "box""#);
                let strap = strapped(x, r#", "on": "box""#);
                format!(
                    r#""bodies": [{{ "name": "box", "mass": 10, "centre_of_mass": [0, 0] }}], "gravity": [9.81, 0], "contacts": [{pads}], {strap}"#
                )
            }),
            Wrench::ZERO,
            down,
        ),
    ]
}

/// If only the squeeze is uncertain, the load with s deviations in reserve is the load of first slip with the squeeze smaller by s deviations.
#[test]
fn the_reserve_is_that_of_a_scene_that_presses_less() -> Tested {
    for (name, scene, base, load) in scenes() {
        let sigma = 0.05;
        let first = |x: f64| -> Result<f64, Box<dyn std::error::Error>> {
            let ramp = grasp_lcp::planar::Ramp::load(base, load);
            Ok(grasp(&scene(x))?.onset(&ramp)?.factor().ok_or(name)?)
        };
        let off = Uncertainty::seeded(1).with_squeeze(sigma);
        let held = grasp(&scene(1.0))?.reserve(base, &off, 3.0)?.along(&load);
        // A part of the allowed failure probability is kept back for neglected effects, so that slightly more than three deviations are in reserve.
        let [least, most] = [3.2, 2.99].map(|sigmas: f64| first((-sigmas * sigma).exp()));
        let (least, most) = (least?, most?);
        assert!(least < held && held < most, "{name}: {least} {held} {most} of {}", first(1.0)?);
    }
    Ok(())
}

/// The first slip of each sample lies between those with three deviations less and more squeeze, and two samples differ.
#[test]
fn samples_press_more_or_less() -> Tested {
    for (name, scene, base, load) in scenes() {
        let sigma = 0.02;
        let ramp = grasp_lcp::planar::Ramp::load(base, load);
        let off = Uncertainty::seeded(3).with_squeeze(sigma);
        let onsets = grasp(&scene(1.0))?.onset_of_samples(&ramp, &off, 400);
        let first = |x: f64| -> Result<f64, Box<dyn std::error::Error>> {
            Ok(grasp(&scene(x))?.onset(&ramp)?.factor().ok_or(name)?)
        };
        // To first order the load of first slip is affine in the squeeze, so that its scatter, divided by the slope, is the scatter of the squeeze.
        let slope = (first(1.01)? - first(0.99)?) / 0.02;
        let mut sum = 0.0;
        for onset in onsets {
            sum += ((onset?.factor().ok_or(name)? - first(1.0)?) / slope).powi(2);
        }
        let spread = (sum / 400.0).sqrt();
        assert!((spread / sigma - 1.0).abs() < 0.12, "{name}: {spread}");
    }
    Ok(())
}
