//! Turns that are none are refused with a message that says where, what, and what is allowed.

use grasp_lcp::load_path::Leg;
use grasp_lcp::planar::Turn;
use grasp_lcp::scene::Scene;
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::{Error, planar, spatial};
use support::jaws::jaw;

/// Contacts stand on lines 2 and 3, an onset on line 4, a path on line 5.
const PLANE: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
{"point": [1, 0], "normal": [-1, 0], "series_stiffness": [10, 20], "friction": 0.5, "pressed_with": 2},
{"point": [-1, 0], "normal": [1, 0], "series_stiffness": [10, 20], "friction": 0.5, "pressed_with": 2}], "questions": [
{"onset_of_turn": {"weight": [0, -1], "at": [0, 0.1], "angle_rad": 3}},
{"follow": {"start": {"force": [0, -1]}, "legs": [{"turn": {"weight": [0, -1]}}]}}
]}}"#;

/// The same on lines 1 and 2.
const SPACE: &str = r#"{"format": "grasp-lcp/1", "spatial": {"contacts": [{"point": [0, 0, 0], "normal": [0, 0, 1], "series_stiffness": [10, 20]}],
"questions": [{"onset_of_turn": {"weight": [0, 0, -1], "axis": [1, 0, 0]}}]}}"#;

/// Every case has the message that is expected of it.
fn expect(scene: &str, cases: &[(&str, &str, &str)]) {
    assert!(Scene::from_json(scene.as_bytes()).unwrap().answers().is_ok());
    for (from, to, expected) in cases {
        assert!(scene.contains(from), "{from}");
        let told = Scene::from_json(scene.replacen(from, to, 1).as_bytes()).expect_err(to).to_string();
        assert_eq!(told, *expected);
    }
}

#[test]
fn an_axis_is_needed_in_space_and_has_a_length() {
    let turn = "spatial.questions[0].onset_of_turn";
    let case = |to: &'static str, column: usize, told: &str| {
        (to, format!("line 2, column {column}: {turn}: {told}"))
    };
    for (to, expected) in [
        ("\"axis\": [0, 0, 0]", 73, "length of the axis is 0, must be more than 0 and at most 1e50"),
        ("\"axis\": [0, 1]", 70, "axis: 2 numbers given, must be 3 in space"),
        ("\"at\": [0, 0, 0]", 71, "missing field `axis` of a turn in space"),
    ]
    .map(|(to, column, told)| case(to, column, told))
    {
        expect(SPACE, &[("\"axis\": [1, 0, 0]", to, &expected)]);
    }
}

#[test]
fn an_axis_is_refused_in_the_plane() {
    expect(
        PLANE,
        &[(
            "\"angle_rad\": 3",
            "\"axis\": [0, 1]",
            "line 4, column 69: planar.questions[0].onset_of_turn: axis: a turn of the plane has none, it goes from x to y",
        )],
    );
}

#[test]
fn an_angle_is_a_number_above_zero() {
    expect(
        PLANE,
        &[
            (
                "\"angle_rad\": 3",
                "\"angle_rad\": 0",
                "line 4, column 69: planar.questions[0].onset_of_turn: angle of the turn is 0, must be more than 0 and at most 1e6 rad",
            ),
            (
                "\"angle_rad\": 3",
                "\"angle_deg\": -9",
                "line 4, column 70: planar.questions[0].onset_of_turn: angle_deg is -9, must be more than 0 and at most 5.7e7",
            ),
            (
                "\"angle_rad\": 3",
                "\"angle_rad\": 3, \"angle_deg\": 9",
                "line 4, column 85: planar.questions[0].onset_of_turn: angle_deg and angle_rad: a turn has one of them",
            ),
            (
                "\"angle_rad\": 3",
                "\"angle_rad\": -3e7",
                "line 4, column 72: planar.questions[0].onset_of_turn: angle of the turn is -30000000, must be more than 0 and at most 1e6 rad",
            ),
            (
                "\"angle_rad\": 3",
                "\"angle_rad\": \"not a number\"",
                "line 4, column 81: planar.questions[0].onset_of_turn.angle_rad: \"not a number\" given, must be a number",
            ),
        ],
    );
}

#[test]
fn a_turn_is_said_in_one_way() {
    let place = "planar.questions[0].onset_of_turn";
    for (to, column, told) in [
        ("\"force\": [1, 0]", 70, "weight and force: a turn has one of them"),
        ("\"sine\": {}", 65, "weight and sine: a turn has one of them"),
        ("\"constant\": {}", 69, "weight and constant: a turn has one of them"),
    ] {
        let expected = format!("line 4, column {column}: {place}: {told}");
        expect(PLANE, &[("\"angle_rad\": 3", to, &expected)]);
    }
    for (to, column, told) in [
        ("\"sine\": {}", 62, "at: of a weight or a force that turns alone"),
        ("\"beside\": {}, \"cosine\": {}", 78, "at: of a weight or a force that turns alone"),
    ] {
        let expected = format!("line 4, column {column}: {place}: {told}");
        expect(PLANE, &[("\"weight\": [0, -1]", to, &expected)]);
    }
}

#[test]
fn something_must_turn() {
    expect(
        PLANE,
        &[(
            "\"weight\": [0, -1], \"at\": [0, 0.1]",
            "\"constant\": {\"force\": [1, 0]}",
            "line 4, column 65: planar.questions[0].onset_of_turn: nothing turns: give weight, or force, or cosine and sine",
        )],
    );
}

#[test]
fn a_leg_turns_or_goes_straight() {
    expect(
        PLANE,
        &[(
            "\"weight\": [0, -1]}}]",
            "\"weight\": [0, -1]}, \"load_by\": {}}]",
            "line 5, column 94: planar.questions[1].follow.legs[0]: load_by and turn: a leg has one of them",
        )],
    );
}

#[test]
fn commands_stay_along_a_leg_that_turns() {
    expect(
        PLANE,
        &[(
            "\"weight\": [0, -1]}}]",
            "\"weight\": [0, -1]}, \"commands_by\": [[0, 0], [0, 0]]}]",
            "line 5, column 112: planar.questions[1].follow.legs[0]: commands or torques of a leg: change while the load turns, must stay",
        )],
    );
}

/// What a program puts together is checked when it is asked.
#[test]
fn turns_that_were_not_read_are_checked_as_well() {
    let palm = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(9.0);
    let asked = |question| {
        let setup = Setup::<2>::new([palm(-1.0).into(), palm(1.0).into()]).ask(question);
        setup.answers().unwrap_err()
    };
    let turn = Turn::tilting([0.0, -1.0], [0.0, 0.0]);
    for angle in [f64::NAN, 0.0] {
        let error = asked(Question::OnsetOfTurn(turn.up_to(angle)));
        assert!(matches!(error, Error::Argument { what: "angle of the turn", .. }), "{error}");
    }
    let leg = Leg::turn(&turn).and_commands_by([[0.001, 0.0]; 2]);
    let error = asked(Question::Follow { start: planar::Wrench::ZERO, legs: vec![leg], in_steps: None });
    assert_eq!(error, Error::CommandsWhileTurning);
    assert!(spatial::Turn::tilting([0.0, 0.0, -1.0], [0.0; 3], [0.0; 3]).is_err());
}
