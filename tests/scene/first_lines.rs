//! The first line of an answer says whether it holds, what slips, where, and how much, as a pinch by hand has it.

use grasp_lcp::scene::Setup;
use grasp_lcp::words::Words;

type Failure = Box<dyn std::error::Error>;

/// The first lines of the answers of two fingers that press with 10 N each on springs of 1000 and 800 N/m, μ = 0.5: they hold 10 N.
fn lines(questions: &str) -> Result<Vec<String>, Failure> {
    let setup: Setup<2> = serde_json::from_str(&format!(
        r#"{{
            "contacts": [
                {{ "name": "left", "point": [-0.3, 0], "normal": [1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 }},
                {{ "name": "right", "point": [0.3, 0], "normal": [-1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 }}
            ],
            "questions": {questions}
        }}"#
    ))?;
    let answers = setup.answers()?;
    Ok(setup
        .questions
        .iter()
        .zip(&answers)
        .map(|(asked, told)| asked.first_line(told, Words::default()))
        .collect())
}

#[test]
fn the_equilibrium_under_a_load() -> Result<(), Failure> {
    let asked =
        r#"[{ "solve": { "load": { "force": [0, -4] } } }, { "solve": { "load": { "force": [0, -11] } } }]"#;
    assert_eq!(
        lines(asked)?,
        [
            "EQUILIBRIUM under (0, -4) N: everything sticks",
            "NO EQUILIBRIUM under (0, -11) N: all 16 combinations of contact states fail",
        ]
    );
    Ok(())
}

#[test]
fn first_slip() -> Result<(), Failure> {
    // From 4 N the same 10 N; along x one finger is relieved by half of the pull and opens at 20 N.
    let asked = r#"[
        { "onset": { "direction": { "force": [0, -2] } } },
        { "onset": { "base": { "force": [0, -4] }, "direction": { "force": [0, -1] } } },
        { "onset": { "direction": { "force": [1, 0] } } }
    ]"#;
    let said = lines(asked)?;
    let limit = "left and right slide; beyond: no equilibrium; it is the limit load";
    assert_eq!(said[0], format!("FIRST SLIP at 10 N: {limit}"));
    assert_eq!(said[1], format!("FIRST SLIP at factor 6: {limit}"));
    assert_eq!(said[2], "FIRST OPENING at 20 N: left opens; beyond: the grasp holds on");
    Ok(())
}

#[test]
fn a_load_that_turns() -> Result<(), Failure> {
    // 9 N along x, turned to y: F_t = 4.5 sin θ = 0.5 (10 - 4.5 cos θ) of the finger that is relieved.
    let said = lines(
        r#"[{ "onset_of_turn": { "weight": [9, 0] } }, { "onset_of_turn": { "weight": [2, 0], "angle_deg": 180 } }]"#,
    )?;
    let closed = (5.0 / 4.5 / 1.25_f64.sqrt()).asin() - 0.5_f64.atan();
    let angle: f64 = said[0]
        .strip_prefix("FIRST SLIP at ")
        .and_then(|rest| rest.split_once("°: "))
        .ok_or_else(|| said[0].clone())?
        .0
        .parse()?;
    assert!((angle - closed.to_degrees()).abs() < 1e-4, "{angle} {}", closed.to_degrees());
    assert_eq!(said[1], "NOTHING SLIDES while the load turns by 180°");
    Ok(())
}

#[test]
fn a_program() -> Result<(), Failure> {
    let asked = r#"[
        { "follow": { "legs": [{ "load_to": { "force": [0, -8] } }] } },
        { "follow": { "legs": [{ "load_to": { "force": [0, -20] } }] } }
    ]"#;
    assert_eq!(
        lines(asked)?,
        [
            "HELD to the end: no contact begins to slide on the way",
            "LOST at 0.5 of leg 0, (0, -10) N: no contact states carry more; no contact begins to slide on the way",
        ]
    );
    Ok(())
}
