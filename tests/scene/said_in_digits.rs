//! Sentences of answers in JSON have the requested number of digits. If the equilibrium of a load is undecided, the answer adds what happens if the
//! load grows from zero.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::hold::Holding;
use grasp_lcp::need::Amount;
use grasp_lcp::planar::Wrench;
use grasp_lcp::scene::{Answer, Fingertip, Question, Scene, Setup, SolveAnswer};
use grasp_lcp::words::Words;
use serde_json::json;
use support::jaws::jaw;

/// Two jaws press with 7.123456789 N each, μ = 0.5, so that they hold a load of the same size together.
fn jaws() -> Setup<2> {
    let jaw = |x: f64, name| jaw::<2>(x, [1e3, 8e2], 0.5).name(name).pressed_with(7.123_456_789);
    Setup::new([jaw(-0.03, "left").into(), jaw(0.03, "right").into()])
}

fn in_digits(question: serde_json::Value, digits: usize) -> Answer<2> {
    let question: Question<2> = serde_json::from_value(question).expect("a question");
    let answers = jaws().ask(question).answers_in(Words::with_digits(digits)).expect("answered");
    answers.into_iter().next().expect("one")
}

#[test]
fn hold_and_need_obey_the_digits() {
    for (digits, force) in [(3, "7.12 N of 9 N"), (6, "7.12345 N of 9 N"), (10, "7.123456789 N of 9 N")] {
        let Answer::Hold(held) = in_digits(json!({ "hold": { "load": { "force": [0, -9] } } }), digits)
        else {
            panic!("hold was asked")
        };
        assert!(held.says.contains(&format!(" at {force}: ")), "{}", held.says);
        assert_eq!(held.says, format!("{:.digits$}", held.verdict));
        let need = json!({ "need": { "quantity": "squeeze", "demand": "held", "load": { "force": [0, -9.123_456_789] } } });
        let Answer::Need(needed) = in_digits(need, digits) else { panic!("need was asked") };
        assert_eq!(needed.says, format!("{:.digits$}", needed.needed));
        // The sentence about an amount that is too small has these digits too.
        let Amount::Bound { otherwise, .. } = &needed.needed.amount else { panic!("some squeeze does") };
        let load = Words::with_digits(digits).number(9.123_456_789);
        assert!(otherwise.contains(&format!(" N of {load} N")), "{otherwise}");
    }
}

#[test]
fn six_unless_said() {
    let question =
        || serde_json::from_value(json!({ "hold": { "load": { "force": [0, -9] } } })).expect("a question");
    let setup = jaws().ask(question());
    assert_eq!(setup.answers().expect("answered"), setup.answers_in(Words::default()).expect("answered"));
    let scene = Scene::from(setup);
    let Some(list) = scene.answers_in(Words::with_digits(2)).expect("answered").planar() else {
        panic!("planar")
    };
    assert!(matches!(&list[..], [Answer::Hold(held)] if held.says.contains(" 7.1 N of 9 N")));
}

/// Soft jaws of 25 N and μ = 0.3 hold 15 N by statics. Whether an equilibrium with the object wedged at another position holds 20 N is not decided.
#[test]
fn undecided_comes_with_what_happens_from_rest() {
    let jaw = |x: f64| -> Fingertip<2> {
        let jaw = json!({
            "point": [x, 0], "normal": [-x, 0], "series_stiffness": [2000, 1000], "friction": 0.3, "pressed_with": 25,
            "soft": { "pad": { "width": 0.02, "strips": 2 } }
        });
        serde_json::from_value(jaw).expect("a jaw")
    };
    let setup = Setup::new([jaw(-0.04), jaw(0.04)]);
    for (weight, decided) in [(14.9, true), (20.0, false)] {
        let answers = setup.clone().ask(Question::solve(Wrench::force([0.0, -weight]))).answers();
        let Ok([Answer::Solve(SolveAnswer { outcome, from_rest, .. })]) = answers.as_deref() else {
            panic!("one answer")
        };
        assert_eq!(matches!(outcome, Outcome::Undecided(_)), !decided, "{outcome}");
        assert_eq!(from_rest.is_none(), decided);
        if let Some(told) = from_rest {
            let lost = told.verdict.lost.as_ref().unwrap();
            assert!(
                (lost.factor * weight - 15.0).abs() < 1e-9 && matches!(told.verdict.holding, Holding::Lost)
            );
        }
        // The answers read back as they were written.
        let written = serde_json::to_string(&answers.as_ref().expect("one answer")).expect("written");
        let read: Vec<Answer<2>> = serde_json::from_str(&written).expect("read");
        assert_eq!(serde_json::to_string(&read).expect("written"), written);
    }
}
