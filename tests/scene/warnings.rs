//! A scene that is probably a mistake has a warning, and a normal scene has none.

use grasp_lcp::planar::Contact;
use grasp_lcp::scene::{Scene, Setup, Warning};
use support::facts;

const JAWS: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
    {"name": "left", "point": [-0.04, 0], "normal": [1, 0], "friction": 0.35, "pressed_with": 8, "stiffness": 10000},
    {"name": "right", "point": [0.04, 0], "normal": [-1, 0], "friction": 0.35, "pressed_with": 8, "stiffness": 10000}],
    "questions": [{"hold": {"load": {"force": [0, -1]}}}]}}"#;

fn warnings(text: &str) -> Vec<Warning> {
    let scene = Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{text}: {fault}"));
    scene.warnings().expect("well posed")
}

/// The only warning about the scene `JAWS` after these replacements.
fn one(changes: &[(&str, &str)]) -> Warning {
    let text = changes.iter().fold(JAWS.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let mut stated = warnings(&text);
    assert_eq!(stated.len(), 1, "{changes:?}: {stated:?}");
    stated.remove(0)
}

fn both() -> ([usize; 2], [String; 2]) {
    ([0, 1], ["left", "right"].map(str::to_owned))
}

#[test]
fn nothing_is_odd_about_two_jaws() {
    assert_eq!(warnings(JAWS), []);
}

/// Three fingers on one side push the object away.
#[test]
fn a_contact_that_loses_its_object_presses_with_nothing() {
    let finger = |point: &str, normal: &str| {
        format!(
            r#"{{"point": {point}, "normal": {normal}, "friction": 0.5, "pressed_with": 40, "stiffness": [4e5, 1.3e5]}}"#
        )
    };
    let fingers =
        [("[0, 0.03]", "[0.8, 0.6]"), ("[0.01, 0.03]", "[-0.8, 0.6]"), ("[0.01, 0.03]", "[0.1, 0.6]")];
    let contacts = fingers.map(|(point, normal)| finger(point, normal)).join(", ");
    let found = warnings(&format!(r#"{{"format": "grasp-lcp/1", "planar": {{"contacts": [{contacts}]}}}}"#));
    let lost =
        |warning: &Warning| matches!(warning, Warning::PressesOtherwise { force, .. } if *force == 0.0);
    assert!(found.iter().filter(|warning| lost(warning)).count() >= 2, "{found:?}");
}

#[test]
fn numbers_in_another_unit() {
    let (contacts, names) = (both().0.to_vec(), both().1.to_vec());
    let friction = Warning::MuchFriction { contacts: contacts.clone(), names: names.clone(), friction: 35.0 };
    assert_eq!(one(&[("0.35", "35")]), friction);
    let metres = |changes: &[(&str, &str)], begins: &str, is: f64, apart: Option<f64>| {
        let stated = one(changes);
        let Warning::ManyMetres { what, length, beside } = &stated else { panic!("{stated}") };
        assert!(what.starts_with(begins) && (length - is).abs() < 1e-12 && *beside == apart, "{stated}");
    };
    metres(&[("0.04", "40")], "the contacts", 80.0, None);
    let pad = r#""stiffness": 10000, "soft": {"pair": {"width": 20}}"#;
    metres(&[(r#""stiffness": 10000"#, pad)], "the patch", 20.0, Some(0.08));
    let low = r#""force": [0, -1], "at": [25, 0]"#;
    metres(&[(r#""force": [0, -1]"#, low)], "a load", 25.0, Some(0.08));
    for (from, to, is_stiffness, value) in [
        (r#""stiffness": 10000"#, r#""stiffness": 210e9"#, true, 2.1e11),
        (r#""pressed_with": 8"#, r#""pressed_with": 1e12"#, false, 1e12),
    ] {
        let (contacts, names) = (contacts.clone(), names.clone());
        assert_eq!(one(&[(from, to)]), Warning::OutOfProportion { contacts, names, is_stiffness, value });
    }
    let stated = one(&[(r#""force": [0, -1]"#, r#""mass": 1800"#)]);
    let Warning::HeavyLoad { force, pressed } = stated else { panic!("{stated}") };
    assert!((force / 17658.0 - 1.0).abs() < 1e-12 && (pressed - 16.0).abs() < 1e-9, "{force} {pressed}");
    // Cases without this warning: an infinite coefficient is not meant in percent, and the size of a load direction has no meaning.
    let more = [
        ("0.35", r#""infinite""#),
        (r#"{"hold": {"load": {"force": [0, -1]}}}"#, r#"{"onset": {"direction": {"force": [0, -1e6]}}}"#),
    ];
    let text = more.iter().fold(JAWS.to_owned(), |text, (from, to)| text.replace(from, to));
    assert_eq!(warnings(&text), []);
}

#[test]
fn normals_the_wrong_way_round() {
    let (contacts, names) = (both().0.to_vec(), both().1.to_vec());
    let same = Warning::SameSide { contacts: contacts.clone(), names: names.clone() };
    assert_eq!(one(&[(r#""normal": [1, 0]"#, r#""normal": [-1, 0]"#)]), same);
    let out = [
        (r#""normal": [1, 0]"#, r#""normal": [-1, 0.001]"#),
        (r#""normal": [-1, 0]"#, r#""normal": [1, 0]"#),
    ];
    assert_eq!(one(&out), Warning::Outwards { contacts, names });
    // If an outline is given, it shows on which side of the contacts the object is. So this warning is not given.
    let hole = r#""outline": [[-0.04, -1], [-0.04, 1], [-1, 1], [-1, -1]], "questions""#;
    let text =
        out.iter().fold(JAWS.replace(r#""questions""#, hole), |text, (from, to)| text.replace(from, to));
    assert!(
        !warnings(&text).iter().any(|stated| matches!(stated, Warning::Outwards { .. })),
        "{:?}",
        warnings(&text)
    );
}

/// Two feet have normals that point up and given forces that agree with the weight. They have no warning, although contacts with one normal direction
/// usually have one.
#[test]
fn feet_under_a_weight_are_told_apart_from_it() {
    let feet = JAWS.replace("[1, 0]", "[0, 1]").replace("[-1, 0]", "[0, 1]").replace("0.35", "0.5");
    assert!(
        warnings(&feet).iter().any(|stated| matches!(stated, Warning::SameSide { .. })),
        "{:?}",
        warnings(&feet)
    );
    let stand = feet.replace(
        r#""load": {"force": [0, -1]}"#,
        r#""base": {"force": [0, -16]}, "load": {"force": [1, 0]}"#,
    );
    assert_eq!(warnings(&stand), []);
}

#[test]
fn friction_that_is_missing_everywhere() {
    assert_eq!(one(&[(r#""friction": 0.35, "#, "")]), Warning::NoFriction);
    assert_eq!(warnings(&JAWS.replacen(r#""friction": 0.35, "#, "", 1)), []);
}

/// Four frictionless locators around a rectangle in form closure need no friction.
#[test]
fn locators_need_no_friction() {
    let at =
        |x: f64, y: f64, n: [f64; 2]| Contact::new([x, y], n).series_stiffness(1e4, 1e4).pressed_with(1.0);
    let around = [
        at(-1.0, 0.5, [1.0, 0.0]),
        at(1.0, -0.5, [-1.0, 0.0]),
        at(0.5, -1.0, [0.0, 1.0]),
        at(-0.5, 1.0, [0.0, -1.0]),
        at(0.5, 1.0, [0.0, -1.0]),
        at(-0.5, -1.0, [0.0, 1.0]),
    ];
    let stated = Setup::new(around.map(Into::into)).warnings().expect("well posed");
    assert!(!stated.iter().any(|stated| stated.to_string().contains("friction")), "{stated:?}");
}

#[test]
fn contacts_that_stand_there_twice() {
    let twice =
        JAWS.replace("0.04, 0], \"normal\": [-1, 0]", "-0.04, 0], \"normal\": [-1, 0]").replace("--", "-");
    for opposite in [true, false] {
        let (contacts, names) = (both().0.to_vec(), both().1.to_vec());
        let given = if opposite { twice.clone() } else { twice.replace("[-1, 0]", "[1, 0]") };
        let stated = warnings(&given);
        assert!(stated.contains(&Warning::OnePlace { contacts, names, opposite }), "{stated:?}");
    }
}

/// A bracket on a round post that its load jams needs no pressing finger. A pinch without a squeeze has a warning.
#[test]
fn a_load_that_jams_needs_no_finger() {
    let bracket = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
        {"name": "upper", "point": [0.02, 0.1], "normal": [-1, 0], "friction": 0.2, "stiffness": 1e6},
        {"name": "lower", "point": [-0.02, 0], "normal": [1, 0], "friction": 0.2, "stiffness": 1e6}],
        "questions": [{"hold": {"load": {"force": [0, -100], "at": [0.2, 0]}}}]}}"#;
    assert_eq!(warnings(bracket), []);
    let idle = JAWS.replace(r#""pressed_with": 8, "#, "");
    assert_eq!(warnings(&idle), [Warning::NothingPresses]);
}

/// A belt and a floor of equal stiffness share a pretension, so that the tension at rest is smaller.
#[test]
fn a_pull_that_gives_way() {
    let belted = |pull: &str| {
        format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{
            "contacts": [{{"name": "floor", "point": [0, 0], "normal": [0, 1], "friction": 0.5, "stiffness": 1e4}}],
            "links": [{{"name": "belt", "cable": {{"from": [0, 1], "to": [0, 0]}}, "stiffness": 1e4, {pull}}}],
            "questions": [{{"hold": {{"load": {{"force": [40, 0]}}}}}}]}}}}"#
        )
    };
    let stated = warnings(&belted(r#""pretension": 100"#));
    let [Warning::PullsOtherwise { name, stated: 100.0, force, .. }] = &stated[..] else {
        panic!("{stated:?}")
    };
    assert!(name == "belt" && (force - 50.0).abs() < 1e-9, "{stated:?}");
    // A finger presses the part down by 10 mm and leaves the belt slack: it pulls with nothing, not with rounding.
    let finger = r#"1e4}, {"name": "finger", "point": [0, 1], "normal": [0, -1], "friction": 0.5, "stiffness": 1e4, "force": 100}],"#;
    let slack = warnings(
        &belted(r#""pretension": 1"#).replace("1e4}],\n            \"links", &format!("{finger} \"links")),
    );
    assert!(slack.iter().any(|one| matches!(one, Warning::PullsOtherwise { force: 0.0, .. })), "{slack:?}");
    let installed = belted(r#""tension": 100"#);
    assert_eq!(warnings(&installed), []);
    let scene: Scene = serde_json::from_str(&installed).expect("a scene");
    assert_eq!(scene, serde_json::from_value(serde_json::to_value(&scene).expect("written")).expect("read"));
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let held = &answers[0]["hold"];
    assert_eq!(held["holding"], "sticks", "{held}");
    assert!((held["lost"]["factor"].as_f64().expect("a number") - 1.25).abs() < 1e-9, "{held}");
    let both = belted(r#""tension": 100, "pretension": 100"#);
    let stated = Scene::from_json(both.as_bytes()).expect_err("both").to_string();
    assert!(stated.contains("belt: pretension and") && stated.contains("tension: "), "{stated}");
    // If the rope pulls the object off the floor, nothing holds, and the error names the rope.
    let away = installed.replace(r#""to": [0, 0]"#, r#""to": [0, 2]"#);
    let scene = Scene::from_json(away.as_bytes()).expect("a scene");
    assert_eq!(facts(&scene.answers().expect_err("it flies off")), ["belt", "tension", "100"]);
}

/// A spring presses an object onto a floor of the same stiffness, so that half of its force is lost. The warning does not propose `tension`, which
/// would pull.
#[test]
fn a_push_that_gives_way() {
    let pressed = r#"{"format": "grasp-lcp/1", "planar": {
        "contacts": [{"name": "floor", "point": [0, 0], "normal": [0, 1], "friction": 0.5, "stiffness": 1e4}],
        "links": [{"name": "plunger", "spring": {"from": [0, 1], "to": [0, 2]}, "stiffness": 1e4, "pretension": -100}],
        "questions": [{"hold": {"load": {"force": [20, 0]}}}]}}"#;
    let [warning] = &warnings(pressed)[..] else { panic!("one warning") };
    let text = warning.to_string();
    assert!(
        text.starts_with("plunger pushes with 50 N at rest, not with 100 N") && !text.contains("`tension"),
        "{text}"
    );
}

/// Two blocks have masses, and the scene has no gravity.
#[test]
fn masses_without_gravity() {
    let stack = |gravity: &str| {
        format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{ {gravity} "bodies": [{{"name": "box", "mass": 2, "centre_of_mass": [0, 0.1]}}],
            "contacts": [{{"point": [-0.1, 0], "normal": [0, 1], "on": "box", "friction": 0.5, "stiffness": 1e4}},
                {{"point": [0.1, 0], "normal": [0, 1], "on": "box", "friction": 0.5, "stiffness": 1e4}}],
            "questions": [{{"hold": {{"load": {{"force": [4, 0], "at": [0, 0.05]}}}}}}]}}}}"#
        )
    };
    assert_eq!(warnings(&stack("")), [Warning::NoGravity]);
    assert_eq!(warnings(&stack(r#""gravity": [0, -9.81],"#)), []);
}

/// A cup of 40 mm pulls with at most 127 N: an atmosphere on its area.
#[test]
fn a_vacuum_beyond_an_atmosphere() {
    let cup = |pull: &str| {
        format!(
            r#"{{"format": "grasp-lcp/1", "spatial": {{"contacts": [{{"name": "cup", "point": [0, 0, 0], "normal": [0, 0, -1],
            "friction": 0.5, "stiffness": 1e4, "suction": {{"radius": 0.02, {pull}}}}}],
            "questions": [{{"hold": {{"load": {{"mass": 1}}}}}}, {{"need": {{"quantity": "squeeze", "load": {{"mass": 20}}}}}}]}}}}"#
        )
    };
    assert_eq!([r#""force": 127"#, r#""pressure": 101325"#].map(|pull| warnings(&cup(pull))), [[], []]);
    for (pull, is) in
        [(r#""force": 128"#, 128.0 / (4e-4 * std::f64::consts::PI)), (r#""pressure": 3e5"#, 3e5)]
    {
        let stated = warnings(&cup(pull));
        let [Warning::BeyondVacuum { names, pressure, .. }] = &stated[..] else { panic!("{stated:?}") };
        assert!(*names == ["cup"] && (pressure / is - 1.0).abs() < 1e-12, "{stated:?}");
    }
    let scene = Scene::from_json(cup(r#""pressure": 6e4"#).as_bytes()).expect("a scene");
    // 20 kg need a vacuum of 156 kPa below the atmosphere, which is impossible.
    let needs = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let says = needs[1]["need"]["says"].as_str().expect("a text").to_owned();
    assert!(says.starts_with("NEEDS 156.131 kPa (196.2 N; more than an atmosphere"), "{says}");
}

/// Pads of 40 mm and angles in degrees, read as m and rad.
#[test]
fn a_patch_alone_and_a_load_that_turns_too_often() {
    let cup = r#"{"format": "grasp-lcp/1", "spatial": {"contacts": [{"name": "cup", "point": [0, 0, 0], "normal": [0, 0, -1],
        "friction": 0.5, "stiffness": 1e4, "suction": {"radius": 40, "pressure": 6e4}}]}}"#;
    let stated = warnings(cup);
    let [Warning::ManyMetres { what, length, beside: None }] = &stated[..] else { panic!("{stated:?}") };
    assert!(what.contains("cup") && *length > 60.0, "{stated:?}");
    assert_eq!(warnings(&cup.replace("40,", "0.04,")), []);
    let turn = r#"{"weight": [0, -1], "angle_rad": 90}"#;
    let hold = r#"{"hold": {"load": {"force": [0, -1]}}}"#;
    for question in [
        format!(r#"{{"onset_of_turn": {turn}}}"#),
        format!(r#"{{"need": {{"quantity": "angle", "turn": {turn}}}}}"#),
        format!(r#"{{"follow": {{"start": {{"force": [0, -1]}}, "legs": [{{"turn": {turn}}}]}}}}"#),
    ] {
        let text = JAWS.replace(hold, &question);
        assert_eq!(warnings(&text), [Warning::ManyTurns { angle: 90.0 }], "{question}");
        assert_eq!(warnings(&text.replace("rad\": 90", "deg\": 720")), [], "{question}");
    }
}

/// Flat goods are wider than high.
#[test]
fn a_stack_that_is_wider_than_high() {
    let on = |width: f64| {
        format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{"gravity": [0, -9.81], "bodies": [{{"name": "pallet", "mass": 25, "centre_of_mass": [0, 0.07]}},
            {{"name": "goods", "mass": 500, "centre_of_mass": [0, 0.6]}}], "contacts": [
            {{"on": "pallet", "point": [0, 0], "normal": [0, 1], "friction": 0.5, "stiffness": 1e7, "soft": {{"pair": {{"width": {width}}}}}}},
            {{"on": "goods", "against": "pallet", "point": [0, 0.144], "normal": [0, 1], "friction": 0.5, "stiffness": 1e7, "soft": {{"pair": {{"width": {width}}}}}}}
            ], "questions": [{{"hold": {{"load": {{"force": [1, 0]}}}}}}]}}}}"#
        )
    };
    assert_eq!(warnings(&on(1.5)), []);
    assert!(matches!(warnings(&on(1200.0))[..], [Warning::ManyMetres { length: 1200.0, .. }]));
}

/// Springs of 10 kN/m on arms of 0.04 m resist turning with 32 N m, of which the jaws take 0.08 m times the force with which they press: from 400 N on
/// they buckle, whatever load acts then. A question that says so itself needs no warning.
#[test]
fn jaws_that_buckle_at_rest() {
    let onset =
        (r#"{"hold": {"load": {"force": [0, -1]}}}"#, r#"{"onset": {"direction": {"force": [0, -1]}}}"#);
    let pressed = |force: &str| (r#""pressed_with": 8"#, format!(r#""pressed_with": {force}"#));
    let [(from, light), (_, hard)] = ["396", "404"].map(pressed);
    assert_eq!(one(&[(from, &hard), onset]), Warning::BucklesAtRest);
    let text = |to: &str| JAWS.replace(from, to);
    assert_eq!(warnings(&text(&light).replace(onset.0, onset.1)), []);
    assert_eq!(warnings(&text(&hard)), []);
}
