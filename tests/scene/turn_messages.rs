//! Invalid turns are refused with a message that gives the place, the fault and what is allowed.

use grasp_lcp::load_path::Leg;
use grasp_lcp::planar::Turn;
use grasp_lcp::scene::Scene;
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::{Error, planar, spatial};
use support::jaws::jaw;

/// A valid scene, which the tests change at one place. Contacts are on lines 2 and 3, a question about first slip on line 4, a load path on line 5.
const PLANE: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
{"point": [1, 0], "normal": [-1, 0], "series_stiffness": [10, 20], "friction": 0.5, "pressed_with": 2},
{"point": [-1, 0], "normal": [1, 0], "series_stiffness": [10, 20], "friction": 0.5, "pressed_with": 2}], "questions": [
{"onset_of_turn": {"weight": [0, -1], "at": [0, 0.1], "angle_rad": 3}},
{"follow": {"start": {"force": [0, -1]}, "legs": [{"turn": {"weight": [0, -1]}}]}}
]}}"#;

/// A valid scene in space on lines 1 and 2.
const SPACE: &str = r#"{"format": "grasp-lcp/1", "spatial": {"contacts": [{"point": [0, 0, 0], "normal": [0, 0, 1], "series_stiffness": [10, 20]}],
"questions": [{"onset_of_turn": {"weight": [0, 0, -1], "axis": [1, 0, 0]}}]}}"#;

/// A case: the text to replace, its replacement, the column of the fault, the field after `planar.` or `spatial.`, and the text of the message.
type Case<'a> = (&'a str, &'a str, usize, &'a str, &'a str);

fn expect(scene: &str, line: usize, cases: &[Case]) {
    assert!(Scene::from_json(scene.as_bytes()).unwrap().answers().is_ok());
    for (from, to, column, field, said) in cases {
        assert!(scene.contains(from), "{from}");
        let fault = Scene::from_json(scene.replacen(from, to, 1).as_bytes()).expect_err(to);
        assert_eq!(fault.at.map(|at| [at.line, at.column]), Some([line, *column]), "{fault}");
        assert_eq!(
            fault.field.as_deref().and_then(|f| f.split_once('.')).map(|f| f.1),
            Some(*field),
            "{fault}"
        );
        assert!(fault.message.contains(said), "{fault}");
    }
}

const TURN: &str = "questions[0].onset_of_turn";

#[test]
fn an_axis_is_needed_in_space_and_has_a_length() {
    let axis = "\"axis\": [1, 0, 0]";
    expect(
        SPACE,
        2,
        &[
            (axis, "\"axis\": [0, 0, 0]", 73, TURN, "axis is 0"),
            (axis, "\"axis\": [0, 1]", 70, TURN, "axis: 2 numbers"),
            (axis, "\"at\": [0, 0, 0]", 71, TURN, "missing field `axis`"),
        ],
    );
}

#[test]
fn an_axis_is_refused_in_the_plane() {
    expect(PLANE, 4, &[("\"angle_rad\": 3", "\"axis\": [0, 1]", 69, TURN, "axis: ")]);
}

#[test]
fn an_angle_is_a_number_above_zero() {
    let angle = "\"angle_rad\": 3";
    expect(
        PLANE,
        4,
        &[
            (angle, "\"angle_rad\": 0", 69, TURN, "turn is 0"),
            (angle, "\"angle_deg\": -9", 70, TURN, "angle_deg is -9"),
            (angle, r#""angle_rad": 3, "angle_deg": 9"#, 85, TURN, "angle_rad: a turn"),
            (angle, "\"angle_rad\": -3e7", 72, TURN, "turn is -30000000"),
            (angle, r#""angle_rad": "none""#, 73, "questions[0].onset_of_turn.angle_rad", "\"none\" given"),
        ],
    );
}

#[test]
fn a_turn_is_said_in_one_way() {
    let (angle, weight) = ("\"angle_rad\": 3", "\"weight\": [0, -1]");
    expect(
        PLANE,
        4,
        &[
            (angle, "\"force\": [1, 0]", 70, TURN, "weight and force"),
            (angle, "\"sine\": {}", 65, TURN, "weight and sine"),
            (angle, "\"constant\": {}", 69, TURN, "weight and constant"),
            (weight, "\"sine\": {}", 62, TURN, "at: "),
            (weight, "\"beside\": {}, \"cosine\": {}", 78, TURN, "at: "),
        ],
    );
}

#[test]
fn something_must_turn() {
    let weight = "\"weight\": [0, -1], \"at\": [0, 0.1]";
    expect(PLANE, 4, &[(weight, "\"constant\": {\"force\": [1, 0]}", 65, TURN, "nothing turns")]);
}

#[test]
fn a_leg_turns_or_goes_straight() {
    let (turn, leg) = ("\"weight\": [0, -1]}}]", "questions[1].follow.legs[0]");
    expect(PLANE, 5, &[(turn, "\"weight\": [0, -1]}, \"load_by\": {}}]", 94, leg, "load_by and")]);
}

#[test]
fn commands_stay_along_a_leg_that_turns() {
    let (turn, leg) = ("\"weight\": [0, -1]}}]", "questions[1].follow.legs[0]");
    let moved = "\"weight\": [0, -1]}, \"commands_by\": [[0, 0], [0, 0]]}]";
    expect(PLANE, 5, &[(turn, moved, 112, leg, &Error::CommandsWhileTurning.to_string())]);
}

/// Setups built in Rust are validated when they are asked.
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
        assert!(matches!(error, Error::Argument { what, .. } if what.starts_with("angle")), "{error}");
    }
    let leg = Leg::turn(&turn).and_commands_by([[0.001, 0.0]; 2]);
    let error = asked(Question::Follow { start: planar::Wrench::ZERO, legs: vec![leg], in_steps: None });
    assert_eq!(error, Error::CommandsWhileTurning);
    assert!(spatial::Turn::tilting([0.0, 0.0, -1.0], [0.0; 3], [0.0; 3]).is_err());
}
