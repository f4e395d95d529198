//! A scene can ask for better finger places. The answer reads back as it was written, even if nothing ever slides.

use grasp_lcp::scene::{Answer, Answers, Scene};

type Tested = Result<(), Box<dyn std::error::Error>>;

/// The answer for two jaws on a box. Only the left jaw may move. `hold` is a field of both jaws. `beside` are further fields of the question.
fn answered(hold: &str, beside: &str) -> Result<Answers, Box<dyn std::error::Error>> {
    let scene: Scene = serde_json::from_str(&format!(
        r#"{{
            "format": "grasp-lcp/1",
            "planar": {{
                "contacts": [
                    {{ "name": "left", "point": [-0.03, 0], "normal": [1, 0], "stiffness": 1e3, {hold},
                       "surface": {{ "segment": [[-0.03, -0.02], [-0.03, 0.02]] }} }},
                    {{ "name": "right", "point": [0.03, 0.01], "normal": [-1, 0], "stiffness": 1e3, {hold} }}
                ],
                "questions": [{{ "improve": {{ "load": {{ "force": [0, -1] }}{beside} }} }}]
            }}
        }}"#
    ))?;
    Ok(scene.answers()?)
}

fn comes_back(answers: &Answers) -> Result<(Option<f64>, Option<f64>), Box<dyn std::error::Error>> {
    let back: Vec<Answer<2>> = serde_json::from_str(&serde_json::to_string(answers)?)?;
    let Some(answers) = answers.clone().planar() else { panic!("in the plane") };
    assert_eq!(back, answers);
    let [Answer::Improve(told)] = &back[..] else { panic!("{back:?}") };
    Ok((told.improved.before, told.improved.after))
}

#[test]
fn an_answer_comes_back() -> Tested {
    let (before, after) = comes_back(&answered(r#""friction": 0.5, "pressed_with": 8"#, "")?)?;
    let [before, after] = [before, after].map(|factor| factor.expect("sticks at rest"));
    // If the jaws are level, the load of first slip is largest: 2 μ N = 8 N, of which each jaw carries half.
    assert!(before < after && (after - 8.0).abs() < 1e-9, "{before} {after}");
    Ok(())
}

#[test]
fn what_never_slides_is_told_as_infinite() -> Tested {
    let infinite = Some(f64::INFINITY);
    assert_eq!(comes_back(&answered(r#""hold": "bonded""#, "")?)?, (infinite, infinite));
    Ok(())
}

#[test]
fn a_reserve_is_asked_for_and_told_to_be_one() -> Tested {
    let answers = answered(r#""friction": 0.5, "pressed_with": 8"#, r#", "goal": "reserve""#)?;
    // Each jaw carries 0.5 N, half of the load, and has a friction limit of 4 N. The reserve of friction is 3.5 N.
    let (before, after) = comes_back(&answers)?;
    assert!(before < after && (after.expect("sticks") - 3.5).abs() < 1e-9, "{before:?} {after:?}");
    let told = serde_json::to_value(&answers)?;
    assert_eq!(told[0]["improve"]["goal"], "reserve");
    assert_eq!(told[0]["improve"]["in_the_way"][0]["what"], "reserve");
    Ok(())
}
