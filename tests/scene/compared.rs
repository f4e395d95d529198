//! A scene can compare the equilibrium with the minimum of energy, and the answer reads back as it was written.

use grasp_lcp::energy::ComparisonVerdict;
use grasp_lcp::scene::{Answer, CompareAnswer, Scene};
use serde_json::json;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// A block of 20 N on two points is pushed along the floor. The left point, twice as stiff as the right one, slides from 7.5 N on.
fn pushed(newtons: f64) -> Result<CompareAnswer<2>, Box<dyn std::error::Error>> {
    let foot = |name: &str, x: f64, shear: f64| {
        json!({
            "name": name, "point": [x, 0], "normal": [0, 1], "series_stiffness": [1000, shear], "friction": 0.5, "pressed_with": 10
        })
    };
    let compare = json!({ "base": { "force": [0, -20] }, "load": { "force": [newtons, 0] } });
    let contacts = [foot("left", -0.1, 800.0), foot("right", 0.1, 400.0)];
    let scene = json!({
        "format": "grasp-lcp/1", "planar": { "contacts": contacts, "questions": [{ "compare": compare }] }
    });
    let scene: Scene = serde_json::from_value(scene)?;
    let Some(answers) = scene.answers()?.planar() else { return Err("in the plane".into()) };
    let [Answer::Compare(answer)] = &answers[..] else { return Err("one comparison".into()) };
    assert_eq!(*answer, serde_json::from_value(serde_json::to_value(answer)?)?);
    Ok(answer.clone())
}

#[test]
fn it_says_up_to_which_part_of_the_load_both_agree() -> Tested {
    let answer = pushed(9.0)?;
    assert!((answer.agrees_up_to.ok_or("a factor")? * 9.0 - 7.5).abs() < 1e-13);
    assert!(matches!(answer.comparison.verdict, ComparisonVerdict::OutOfEquilibrium { .. }));
    assert!(answer.says.ends_with(" 7.5 N"), "{}", answer.says);
    Ok(())
}

#[test]
fn while_everything_sticks_forces_are_the_same() -> Tested {
    let answer = pushed(6.0)?;
    assert_eq!(answer.comparison.verdict, ComparisonVerdict::Agree);
    let says = answer.comparison.to_string();
    assert!(answer.says.starts_with(&says) && answer.says.ends_with(" 7.5 N"), "{}", answer.says);
    Ok(())
}
