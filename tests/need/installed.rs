//! Straps with a given tension, and tendons, are scaled as they are installed, whatever the stiffness of the rest. Coulomb's law gives all amounts.

use grasp_lcp::need::{Amount, Need, Needed};
use grasp_lcp::planar::{Grasp, Wrench};
use grasp_lcp::scene::Scene;

type Tested = Result<(), Box<dyn std::error::Error>>;

fn grasp(planar: &str) -> Result<Grasp, Box<dyn std::error::Error>> {
    let text = format!(r#"{{ "format": "grasp-lcp/1", "planar": {{ {planar} }} }}"#);
    Ok(Scene::from_json(text.as_bytes())?.planar().ok_or("a planar scene")?.grasp()?)
}

fn is(found: Option<f64>, amount: f64, accuracy: f64) {
    assert!(found.is_some_and(|found| (found / amount - 1.0).abs() < accuracy), "{found:?} {amount}");
}

fn safe(needed: &Needed) -> Option<f64> {
    needed.safe.as_ref().and_then(Amount::bound)
}

/// A box at a wall, friction 0.5, under a strap that is installed with 300 N: 98.1 N need a tension of 98.1 N / 0.5.
#[test]
fn a_strap_at_a_wall() -> Tested {
    for wall in [1e6, 5e4, 2e4] {
        let contact = |y: f64| {
            format!(r#"{{ "point": [0, {y}], "normal": [1, 0], "friction": 0.5, "stiffness": {wall} }}"#)
        };
        let strapped = grasp(&format!(
            r#""contacts": [{}, {}], "links": [{{ "name": "strap", "cable": {{ "from": [0.2, 0], "to": [-0.05, 0] }}, "stiffness": 5e4, "tension": 300 }}]"#,
            contact(-0.1),
            contact(0.1)
        ))?;
        let weight = Wrench::force_at([0.0, -98.1], [0.1, 0.0]);
        for need in [Need::force("strap", weight), Need::squeeze(weight)] {
            is(strapped.need(&need.to_hold())?.amount.bound(), 196.2 / 300.0, 1e-9);
        }
    }
    Ok(())
}

/// A box of 98.1 N hangs on a strap that presses it up against pads, μ = 0.4: a side load of 20 N needs `98.1 N + 20 N / μ` of tension. With 30 % less squeeze
/// left, 1 / 0.7 times as much is safe.
#[test]
fn a_strap_beside_a_weight() -> Tested {
    let strapped = grasp(
        r#""bodies": [{ "name": "box", "mass": 10, "centre_of_mass": [0, 0] }], "gravity": [0, -9.81],
        "contacts": [{ "point": [-0.1, 0], "normal": [0, -1], "friction": 0.4, "stiffness": 5e4, "on": "box" },
            { "point": [0.1, 0], "normal": [0, -1], "friction": 0.4, "stiffness": 5e4, "on": "box" }],
        "links": [{ "name": "strap", "cable": { "from": [0, 0], "to": [0, 0.3] }, "stiffness": 1e5, "tension": 300, "on": "box" }]"#,
    )?;
    let needed = strapped.need(&Need::squeeze(Wrench::force([20.0, 0.0])).to_hold().if_lower_by(0.0, 0.3))?;
    is(needed.amount.bound(), 148.1 / 300.0, 1e-9);
    is(safe(&needed), 148.1 / 0.7 / 300.0, 1e-8);
    Ok(())
}

/// An oblique strap presses a box against a wall and pulls it along the wall, unless μ is at least the tangent of the strap's angle, 0.041 / 0.25.
/// This condition determines the needed friction, also if 10 % less friction has to suffice.
#[test]
fn friction_with_which_a_strap_does_not_pull_the_part_off() -> Tested {
    let strapped = grasp(
        r#""contacts": [{ "point": [0, -0.1], "normal": [1, 0], "friction": 0.24, "stiffness": 508474 },
            { "point": [0, 0.1], "normal": [1, 0], "friction": 0.55, "stiffness": 242240 }],
        "links": [{ "name": "strap", "cable": { "from": [0.2, -0.041], "to": [-0.05, 0] }, "stiffness": 5e4, "tension": 98 }]"#,
    )?;
    let load = Wrench::force_at([-120.29, -50.75], [0.024, 0.076]);
    let needed = strapped.need(&Need::friction(load).to_hold().if_lower_by(0.1, 0.05))?;
    is(needed.amount.bound(), 0.164, 1e-6);
    is(safe(&needed), 0.164 / 0.9, 1e-6);
    Ok(())
}

/// A tendon of 40 N on a lever arm of 10 mm closes two fingers of length 80 mm. Each fingertip presses with 5 N, μ = 0.5. So a weight of 5.886 N
/// needs 47.088 N in the tendon.
#[test]
fn a_tendon_that_closes_a_hand() -> Tested {
    let finger = |x: f64| {
        format!(
            r#"{{ "joints": [{{ "revolute": {{ "point": [{x}, 0.08] }} }}],
            "contacts": [{{ "point": [{x}, 0], "normal": [{}, 0], "friction": 0.5, "stiffness": 1e4 }}] }}"#,
            -x.signum()
        )
    };
    let hand = grasp(&format!(
        r#""fingers": [{}, {}], "tendons": [{{ "name": "closer", "arms": [0.01, -0.01], "tension": 40 }}]"#,
        finger(-0.03),
        finger(0.03)
    ))?;
    let weight = Wrench::force([0.0, -5.886]);
    for need in [Need::force("closer", weight), Need::squeeze(weight)] {
        is(hand.need(&need.to_hold())?.amount.bound(), 47.088 / 40.0, 1e-9);
    }
    Ok(())
}
