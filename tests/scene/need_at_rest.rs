//! A question `need` without a load asks what the loads at rest need. It is refused if nothing acts at rest.

use grasp_lcp::scene::Scene;

/// A block between two jaws that press with 10 N, μ = 0.5.
fn block(fields: &str, question: &str) -> String {
    let jaw = |x: f64| {
        format!(
            r#"{{"on": "block", "point": [{x}, 0], "normal": [{}, 0], "friction": 0.5, "stiffness": 1e4, "pressed_with": 10}}"#,
            -x
        )
    };
    format!(
        r#"{{"format": "grasp-lcp/1", "planar": {{{fields}, "contacts": [{}, {}], "questions": [{{"need": {{{question}}}}}]}}}}"#,
        jaw(-0.03),
        jaw(0.03)
    )
}

const FRICTION: &str = r#""quantity": "friction""#;

/// The load at rest is 6 N down. The jaws carry it from μ = 6 N / (2 · 10 N) on.
#[test]
fn what_acts_at_rest_is_held() {
    for (fields, question) in [
        (r#""bodies": [{"name": "block", "load": {"force": [0, -6]}}]"#, FRICTION),
        (r#""gravity": [0, -10], "bodies": [{"name": "block", "mass": 0.6}]"#, FRICTION),
        (r#""bodies": [{"name": "block"}]"#, r#""quantity": "friction", "base": {"force": [0, -6]}"#),
    ] {
        let scene =
            Scene::from_json(block(fields, question).as_bytes()).unwrap_or_else(|fault| panic!("{fault}"));
        let answer = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
        let least = answer[0]["need"]["amount"]["bound"]["sufficient"].as_f64();
        assert!(least.is_some_and(|least| (least - 0.3).abs() < 1e-9), "{answer}");
    }
}

#[test]
fn nothing_at_rest_is_refused() {
    for (fields, quantity) in [
        (r#""bodies": [{"name": "block"}]"#, "friction"),
        (r#""bodies": [{"name": "block", "load": {"force": [0, -6]}}]"#, "load"),
    ] {
        let text = block(fields, &format!(r#""quantity": "{quantity}""#));
        let fault = Scene::from_json(text.as_bytes()).expect_err("no load");
        assert!(fault.at.is_some() && fault.message.contains("need: load is missing"), "{fault}");
    }
}
