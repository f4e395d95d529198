//! If a scene leaves a stiffness out, or gives one number for all directions, the default is used and reported where the answer depends on it.

use grasp_lcp::scene::{Fingertip, Scene, Warning};
use serde_json::{Value, json};

/// A scene with two feet on a table that is pushed at a height.
fn scene(stiffness: &[Value; 2], question: &Value) -> Scene {
    let foot = |x: f64, stiffness: &Value| {
        let mut foot = json!({ "point": [x, 0], "normal": [0, 1], "friction": 0.4 });
        foot.as_object_mut().unwrap().extend(stiffness.as_object().unwrap().clone());
        foot
    };
    let contacts = [foot(-0.05, &stiffness[0]), foot(0.05, &stiffness[1])];
    serde_json::from_value(
        json!({ "format": "grasp-lcp/1", "planar": { "contacts": contacts, "questions": [question] } }),
    )
    .unwrap()
}

fn told(scene: &Scene) -> Option<Warning> {
    let told = scene.setup.stiffness_left_out().unwrap();
    // All warnings are those that need no answers together with those that need some, each once.
    let all = scene.warnings().unwrap();
    assert_eq!([scene.warnings_at_once().unwrap(), told.clone()].concat(), all);
    assert_eq!(scene.stiffness_left_out().unwrap(), told);
    assert!(told.len() < 2, "{told:?}");
    told.into_iter().next()
}

fn push(height: f64) -> Value {
    json!({ "hold": { "base": { "force": [0, -20] }, "load": { "force": [8, 0], "at": [0, height] } } })
}

/// The load at which the object tips, 20 N · 50 mm / h, does not depend on the springs. The motion of the object under its weight does.
#[test]
fn it_is_told_where_an_answer_depends_on_it_and_nowhere_else() {
    let none = [json!({}), json!({})];
    assert_eq!(told(&scene(&none, &push(0.15))), None);
    let turn = json!({ "need": { "quantity": "angle", "demand": "held", "turn": { "weight": [0, -3], "at": [0, 0.2], "angle_rad": 1.5 } } });
    assert_eq!(told(&scene(&none, &turn)), None);
    // The limit load μ W does not depend on stiffness, but which foot slides first does.
    let first = told(&scene(&none, &push(0.05))).unwrap();
    let names = ["contact 0", "contact 1"].map(str::to_owned).to_vec();
    let expected =
        Warning::StiffnessLeftOut { contacts: vec![0, 1], names, stiffness: 1e4, questions: vec![0] };
    assert_eq!(first, expected);
    assert!(first.to_string().contains(" 10000 N/m "), "{first}");
    let solve = json!({ "solve": { "load": { "force": [0, -20] } } });
    assert!(told(&scene(&none, &solve)).is_some());
    let given = [json!({ "stiffness": 3e3 }), json!({ "series_stiffness": 3e3 })];
    assert_eq!(told(&scene(&given, &solve)), None);
    let one = told(&scene(&[json!({ "stiffness": 3e3 }), json!({})], &solve));
    assert!(matches!(one, Some(Warning::StiffnessLeftOut { contacts, .. }) if contacts == [1]));
}

/// Two feet at ±50 mm with the default stiffness resist a tilt with 50 N m for each radian. A load of 1 kN at the height of 0.1 m drives the tilt
/// twice as much, so the feet buckle. Stiffer feet would hold this load. A pinch of 30 N is far from buckling, but the squeeze at which it buckles
/// depends on the stiffness.
#[test]
fn what_buckles_on_default_springs_is_told() {
    let none = [json!({}), json!({})];
    let stands = json!({ "hold": { "load": { "force": [0, -1000], "at": [0, 0.1] } } });
    let told = told(&scene(&none, &stands)).unwrap();
    assert!(matches!(&told, Warning::StiffnessLeftOut { questions, .. } if questions == &[0]), "{told}");
    let jaw = |x: f64| json!({ "point": [x, 0], "normal": [-x, 0], "friction": 0.5, "pressed_with": 30 });
    let of = |question: Value| {
        let planar = json!({ "contacts": [jaw(-0.03), jaw(0.03)], "questions": [question] });
        let scene = json!({ "format": "grasp-lcp/1", "planar": planar });
        serde_json::from_value::<Scene>(scene).unwrap().setup.stiffness_left_out().unwrap().len()
    };
    let load = json!({ "force": [0, -1], "at": [0, 0] });
    assert_eq!(of(json!({ "hold": { "load": load } })), 0);
    assert_eq!(of(json!({ "need": { "quantity": "squeeze", "load": load } })), 1);
}

#[test]
fn one_number_is_that_of_all_directions() {
    let springs = |stiffness: Value| {
        let contact = json!({ "point": [0, 0, 0], "normal": [0, 0, 1], "stiffness": stiffness });
        serde_json::from_value::<Fingertip<3>>(contact).unwrap()
    };
    for given in [json!(2000), json!([2000]), json!([2000, 2000]), json!([2000, 2000, 2000])] {
        assert_eq!(springs(given).contact.series_stiffness_of_axes().as_slice(), [2000.0; 3]);
    }
    let default: Fingertip<3> =
        serde_json::from_value(json!({ "point": [0, 0, 0], "normal": [0, 0, 1] })).unwrap();
    assert_eq!(default.contact.series_stiffness_of_axes().as_slice(), [1e4; 3]);
    let written = serde_json::to_value(&default).unwrap();
    assert!(written.get("series_stiffness").is_none() && written.get("stiffness").is_none(), "{written}");
    assert_eq!(serde_json::from_value::<Fingertip<3>>(written).unwrap(), default);
}
