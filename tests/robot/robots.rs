//! Shared by tests: robot files as texts.

use std::fmt::Write;

/// A joint from its name, kind, parent and child, and further elements.
pub(crate) fn joint(name: &str, kind: &str, between: [&str; 2], more: &str) -> String {
    let [parent, child] = between;
    format!(
        r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{more}</joint>"#
    )
}

/// A robot of these links and joints.
pub(crate) fn robot(links: &[&str], joints: &[String]) -> String {
    let mut text = r#"<?xml version="1.0"?><robot name="of a test">"#.to_owned();
    for link in links {
        write!(text, r#"<link name="{link}"/>"#).expect("a text");
    }
    text + &joints.concat() + "</robot>"
}

/// A wrist with two fingers of two joints each, with skew axes. The second finger mimics the first, and has a prismatic joint at its end.
pub(crate) fn wrist_and_fingers() -> String {
    let limit = r#"<limit lower="-1" upper="1" effort="2" velocity="1"/>"#;
    let placed = |xyz: &str, rpy: &str, axis: &str| {
        format!(r#"<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{limit}"#)
    };
    let follows =
        |joint: &str, factor: f64| format!(r#"<mimic joint="{joint}" multiplier="{factor}" offset="0.1"/>"#);
    robot(
        &["arm", "palm", "one", "one_end", "one_tip", "two", "two_end"],
        &[
            joint("wrist", "continuous", ["arm", "palm"], &placed("0 0 0.02", "0.1 -0.2 0.3", "0 0.6 0.8")),
            joint("knuckle", "revolute", ["palm", "one"], &placed("-0.04 0 0.03", "0.4 0.2 -0.1", "0 1 0")),
            joint("bend", "revolute", ["one", "one_end"], &placed("0 0 0.03", "0 0.3 0", "0.6 0.8 0")),
            joint("end", "fixed", ["one_end", "one_tip"], &placed("0.002 0 0.025", "0 0 0.5", "1 0 0")),
            joint(
                "opposite",
                "revolute",
                ["palm", "two"],
                &(placed("0.04 0 0.03", "0.2 0 0", "0 -1 0") + &follows("knuckle", 0.75)),
            ),
            joint(
                "reach",
                "prismatic",
                ["two", "two_end"],
                &(placed("0 0 0.03", "0 -0.2 0", "0 0.28 0.96") + &follows("bend", 0.02)),
            ),
        ],
    )
}
