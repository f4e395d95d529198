//! Hands in scenes read back as they were written, give the answers of the same hand built in Rust, and report their faults.

use grasp_lcp::Limit;
use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::load_path::Onset;
use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use grasp_lcp::planar::{Leg, Wrench};
use grasp_lcp::scene::{Answer, Fingertip, Scene, Setup, SolveAnswer};
use grasp_lcp::{planar, scene, spatial};
use serde_json::{Value, json};
use support::jaws::jaw;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// A scene with all fields of a planar finger.
fn planar_scene() -> Value {
    let pad = |point: Value, normal: Value| json!({ "point": point, "normal": normal, "series_stiffness": [2000.0, 1500.0], "friction": 0.6 });
    let mut first = pad(json!([-1.0, 0.3]), json!([1.0, 0.1]));
    first["moved_by"] = json!({ "link": 1 });
    first["pressed_with"] = json!(3.0);
    let mut second = pad(json!([-1.0, -0.2]), json!([1.0, 0.0]));
    second["moved_by"] = json!({ "jacobian": [[0.5, 0.1], [0.0, 0.7]] });
    second["pressed_with"] = json!(2.0);
    let mut by_force = pad(json!([1.0, -0.4]), json!([-1.0, 0.05]));
    by_force["force"] = json!(2.5);
    json!({
        "format": "grasp-lcp/1",
        "planar": {
            "contacts": [pad(json!([0.0, -1.0]), json!([0.0, 1.0]))],
            "fingers": [
                {
                    "comment": "two coupled joints",
                    "joints": [
                        { "name": "base", "revolute": { "point": [-2.0, -1.0] }, "stiffness": 40.0, "torque": 0.25 },
                        { "revolute": { "point": [-1.8, 0.5] }, "stiffness": 30.0, "command": 0.01, "limit": { "slips": 9.0 } }
                    ],
                    "stiffness_matrix": [[9.0, 3.0], [3.0, 1.0]],
                    "contacts": [first, second]
                },
                {
                    "joints": [{ "prismatic": [-1.0, 0.0], "limit": { "saturates": 4.0 }, "stiffness": 900.0, "command": 0.003 }],
                    "contacts": [pad(json!([1.0, 0.5]), json!([-1.0, 0.0]))]
                },
                { "contacts": [by_force] },
                {
                    "compliance": [[2e-3, 5e-4], [5e-4, 1e-3]],
                    "contacts": [{ "point": [1.0, 0.0], "normal": [-1.0, 0.0], "friction": 0.4, "pressed_with": 1.0 }]
                }
            ],
            "tendons": [{ "name": "flexor", "arms": [0.02, 0.01, 0.0, 0.0], "stiffness": 500.0, "pull": 1e-3, "tension": 0.5 }],
            "questions": [
                { "solve": { "load": { "force": [0.25, -0.5], "moment": 0.125 } } },
                { "onset": { "direction": { "force": [0.0, 1.0] } } },
                { "follow": { "legs": [{ "joints_by": [0.0, 0.0, 0.004, 0.0, 0.0] }, { "load_to": { "force": [0.0, 6.0] } }, { "torques_by": [0.05, 0.0, 0.0, 0.5], "load_by": { "force": [0.0, -1.0] } }] } }
            ]
        }
    })
}

/// The same hand, built in Rust.
fn by_calls() -> Result<planar::Grasp, grasp_lcp::Error> {
    let pad = |point: [f64; 2], normal: [f64; 2]| {
        Contact::new(point, normal).series_stiffness(2000.0, 1500.0).friction(0.6)
    };
    let first = Finger::new([
        Joint::revolute([-2.0, -1.0]).name("base").stiffness(40.0).torque(0.25),
        Joint::revolute([-1.8, 0.5]).stiffness(30.0).command(0.01).limit(Limit::Slips(9.0)),
    ])
    .coupled(DMatrix::from_row_slice(2, 2, &[9.0, 3.0, 3.0, 1.0]))
    .contact_on(1, pad([-1.0, 0.3], [1.0, 0.1]).pressed_with(3.0))
    .contact_moved_by(
        DMatrix::from_row_slice(2, 2, &[0.5, 0.1, 0.0, 0.7]),
        pad([-1.0, -0.2], [1.0, 0.0]).pressed_with(2.0),
    );
    let slide = Joint::prismatic([-1.0, 0.0]).stiffness(900.0).command(0.003).limit(Limit::Saturates(4.0));
    let bare = Contact::new([1.0, 0.0], [-1.0, 0.0]).friction(0.4).pressed_with(1.0);
    Hand::new([
        Finger::fixed(pad([0.0, -1.0], [0.0, 1.0])),
        first,
        Finger::new([slide]).contact(pad([1.0, 0.5], [-1.0, 0.0])),
        Finger::fixed(pad([1.0, -0.4], [-1.0, 0.05]).force(2.5)),
        Finger::compliant([bare], DMatrix::from_row_slice(2, 2, &[2e-3, 5e-4, 5e-4, 1e-3])),
    ])
    .tendon(Tendon::new([0.02, 0.01, 0.0, 0.0]).name("flexor").stiffness(500.0).pull(1e-3).tension(0.5))
    .grasp()
}

#[test]
fn a_written_hand_reads_back_and_answers_as_the_one_that_is_built() -> Tested {
    let scene: Scene = serde_json::from_value(planar_scene())?;
    let written = serde_json::to_value(&scene)?;
    for part in ["contacts", "fingers", "tendons"] {
        assert_eq!(written["planar"][part], planar_scene()["planar"][part]);
    }
    assert_eq!(serde_json::from_value::<Scene>(written)?, scene);
    let Some(answers) = scene.answers()?.planar() else { return Err("planar".into()) };
    let back: Vec<Answer<2>> = serde_json::from_value(serde_json::to_value(&answers)?)?;
    assert_eq!(format!("{back:?}"), format!("{answers:?}"));

    let grasp = by_calls()?;
    let [Answer::Solve(SolveAnswer { outcome: Outcome::Equilibrium(told), .. }), onset, path] = &answers[..]
    else {
        return Err(format!("{answers:?}").into());
    };
    let outcome = grasp.solve(Wrench::new([0.25, -0.5], 0.125))?;
    let state = outcome.equilibrium().ok_or("holds")?;
    assert!(told.residuals.equilibrium < 1e-14);
    for (a, b) in told.contacts.iter().zip(&state.contacts) {
        assert!((a.force - b.force).norm() < 1e-12, "{} {}", a.force, b.force);
    }
    assert_eq!(told.joints.len(), 4);
    for (a, b) in told.joints.iter().zip(&state.joints) {
        assert!((a.torque - b.torque).abs() < 1e-12 && a.state == b.state);
        assert!(
            (a.displacement - b.displacement).abs() < 1e-13
                && (a.margin == b.margin || (a.margin - b.margin).abs() < 1e-12)
        );
    }
    assert!((told.tendons[0].tension - state.tendons[0].tension).abs() < 1e-12);
    assert_eq!(told.joints[0].joint.name.as_deref(), Some("base"));
    assert_eq!(told.tendons[0].tendon.name.as_deref(), Some("flexor"));

    let Answer::Onset(scene::OnsetAnswer::At(told)) = onset else { return Err(format!("{onset:?}").into()) };
    let Onset::At(event) = grasp.onset(Wrench::force([0.0, 1.0]))? else {
        return Err("slides".into());
    };
    assert!((told.at.factor - event.factor).abs() < 1e-12);
    assert_eq!((told.leaving.len(), told.drives.len()), (event.leaving.len(), event.drives.len()));

    let Answer::Follow(told) = path else { return Err(format!("{path:?}").into()) };
    let legs = [
        Leg::joints_by([0.0, 0.0, 0.004, 0.0, 0.0]),
        Leg::load_to(Wrench::force([0.0, 6.0])),
        Leg::torques_by([0.05, 0.0, 0.0, 0.5]).and_load_by(Wrench::force([0.0, -1.0])),
    ];
    let mut path = grasp.follow(Wrench::ZERO, &legs)?;
    let events = path.run();
    assert_eq!(told.events.len(), events.len());
    assert!(events.iter().any(|event| !event.drives.is_empty()));
    for (a, b) in told.events.iter().zip(&events) {
        assert_eq!(a.leg, b.leg);
        assert!((a.fraction - b.fraction).abs() < 1e-11, "{} {}", a.fraction, b.fraction);
        assert_eq!(a.drives.len(), b.drives.len());
    }
    Ok(())
}

/// Hands in space with many joints are answered too.
#[test]
fn hands_of_every_size_are_answered() -> Tested {
    for joints in [1, 3, 8] {
        let finger = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let joint = |k: u32| {
                let height = -0.5 - 0.1 * f64::from(k);
                json!({ "revolute": { "point": [1.2 * cos, 1.2 * sin, height], "axis": [sin, -cos, 0.0] }, "stiffness": 30.0, "limit": { "saturates": 50.0 } })
            };
            let pad = json!({ "point": [cos, sin, 0.0], "normal": [-cos, -sin, 0.0], "series_stiffness": [2000.0, 1500.0], "friction": 0.5, "pressed_with": 4.0 });
            json!({ "joints": (0..joints).map(joint).collect::<Vec<_>>(), "contacts": [pad] })
        };
        let turn = std::f64::consts::TAU / 3.0;
        let scene: Scene = serde_json::from_value(json!({
            "format": "grasp-lcp/1",
            "spatial": {
                "fingers": [finger(0.1), finger(0.1 + turn), finger(0.1 + 2.0 * turn)],
                "questions": [{ "solve": { "load": { "force": [0.1, 0.2, -1.0] } } }]
            }
        }))?;
        let Some(setup) = scene.spatial() else { return Err("spatial".into()) };
        let coordinates = setup.hand()?.coordinates();
        let direct = setup.hand()?.grasp()?;
        let direct = direct.solve(spatial::Wrench::force([0.1, 0.2, -1.0]))?;
        let direct = direct.equilibrium().ok_or("holds")?;
        let Some(answers) = scene.answers()?.spatial() else { return Err("spatial".into()) };
        let [Answer::Solve(SolveAnswer { outcome: Outcome::Equilibrium(told), .. })] = &answers[..] else {
            return Err(format!("{coordinates}: {answers:?}").into());
        };
        for (a, b) in told.contacts.iter().zip(&direct.contacts) {
            assert!((a.force - b.force).norm() < 1e-11, "{coordinates}: {} {}", a.force, b.force);
        }
    }
    Ok(())
}

/// The points of a soft fingertip on a link move with the joints of this link, and have the name of their contact.
#[test]
fn a_finger_has_soft_tips() -> Tested {
    let jaw = |side: f64| {
        let pad = jaw::<2>(side, [1e4, 8e3], 0.5);
        let slide = Joint::prismatic([-side, 0.0]).stiffness(1e3).command(0.01);
        scene::FingerSetup::new([slide])
            .contact(Fingertip::from(pad).soft(scene::FingertipPatch::Pair { width: 0.1 }))
    };
    let setup = Setup::<2>::new([]).finger(jaw(-1.0)).finger(jaw(1.0));
    let setup = setup.ask(serde_json::from_value(json!({ "solve": { "load": { "moment": 0.2 } } }))?);
    let [Answer::Solve(SolveAnswer { outcome: Outcome::Equilibrium(told), .. })] = &setup.answers()?[..]
    else {
        return Err("holds".into());
    };
    let places: Vec<_> =
        told.contacts.iter().map(|touch| (touch.contact.index, touch.contact.point)).collect();
    assert_eq!(places, [(0, Some(0)), (0, Some(1)), (1, Some(0)), (1, Some(1))]);
    // The points of each soft jaw have 1e4 N/m together, in series with the joint. The joint carries the sum of their forces.
    let force = 0.01 / (1e-3 + 1e-4);
    assert!((told.joints[0].torque - force).abs() < 1e-12);
    Ok(())
}

/// A free motion includes the motion of joints.
#[test]
fn free_motions_tell_what_joints_do() -> Tested {
    let jaw = |side: f64| {
        let pad = jaw::<2>(side, [1e4, 8e3], 0.5);
        scene::FingerSetup::new([Joint::prismatic([-side, 0.0])]).contact(pad)
    };
    let setup = Setup::<2>::new([]).finger(jaw(-1.0)).finger(jaw(1.0));
    let setup = setup.tendon(Tendon::new([0.5, 0.5]).tension(20.0));
    let setup = setup.ask(serde_json::from_value(json!({ "solve": { "load": { "force": [0.1, 0.0] } } }))?);
    let answers = serde_json::to_value(setup.answers()?)?;
    let motion = &answers[0]["solve"]["motion"];
    let (moves, joints) = (motion["translation"][0].as_f64().ok_or("x")?, &motion["joints"]);
    assert!(moves > 0.0);
    assert!((joints[0].as_f64().ok_or("left")? - moves).abs() < 1e-12);
    assert!((joints[1].as_f64().ok_or("right")? + moves).abs() < 1e-12);
    Ok(())
}

type Change<'a> = &'a dyn Fn(&mut Value);

#[test]
fn what_is_wrong_with_a_hand_is_named() {
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut scene = planar_scene();
        change(&mut scene["planar"]);
        serde_json::from_value::<Scene>(scene).expect_err("wrong").to_string()
    };
    let cases: [(Change, &str); 16] = [
        (&|s| s["fingers"][0]["joints"][0]["stiffness"] = json!(-1.0), "(base): stiffness is -1"),
        (&|s| s["fingers"][1]["joints"][0]["limit"] = json!({ "saturates": 0.0 }), "joint 2: limit is 0"),
        (&|s| s["fingers"][1]["joints"][0]["limit"] = json!({ "stalls": 1.0 }), "unknown variant `stalls`"),
        (&|s| s["fingers"][0]["joints"][0]["revolute"]["axis"] = json!([0.0, 1.0]), "axis: a revolute"),
        (&|s| s["fingers"][0]["joints"][0]["prismatic"] = json!([0.0, 1.0]), "revolute and prismatic: "),
        (&|s| s["fingers"][0]["stiffness_matrix"] = json!([[1.0, 2.0], [2.0, 1.0]]), "eigenvalue -1"),
        (&|s| s["fingers"][0]["stiffness_matrix"] = json!([[1.0, 2.0], [2.0]]), "row 1 has 1 numbers"),
        (
            &|s| s["fingers"][0]["contacts"][1]["moved_by"] = json!({ "jacobian": [[1.0], [2.0]] }),
            "2 x 1 given, must be 2 x 2",
        ),
        (&|s| s["fingers"][0]["contacts"][1]["moved_by"] = json!({ "joint": 1 }), "`joint`, expected `link`"),
        (&|s| s["contacts"][0]["moved_by"] = json!({ "link": 1 }), "moved_by: "),
        (&|s| s["fingers"][2]["joints"] = json!([{ "prismatic": [1.0, 0.0] }]), "force is 2.5, "),
        (&|s| s["fingers"][1]["contacts"] = json!([]), "contacts: none given"),
        (&|s| s["tendons"][0]["arms"] = json!([1.0, 1.0, 1.0, 1.0, 1.0]), "tendon 0 (flexor)"),
        (&|s| s["questions"][2]["follow"]["legs"][0]["joints_by"] = json!([0.0]), "1 given, must be 5"),
        (&|s| s["questions"][2]["follow"]["legs"][2]["torques_by"] = json!([0.0]), "1 given, must be 4"),
        (
            &|s| s["questions"][2]["follow"]["legs"][2]["torques_to"] = json!([0.0, 0.0, 0.0, 0.0]),
            "and torques_to: ",
        ),
    ];
    for (change, expected) in cases {
        let told = refused(change);
        assert!(told.contains(expected), "{expected}\n{told}");
    }
}

/// The error of an invalid contact of a finger gives the index of this contact in the scene, where each preceding soft fingertip counts once.
#[test]
fn a_wrong_contact_of_a_finger_is_named_by_its_place() {
    let pad = |x: f64| jaw::<2>(x, [1e4, 8e3], 0.5);
    let soft = Fingertip::from(pad(-1.0)).soft(scene::FingertipPatch::Pair { width: 0.1 });
    let setup = Setup::<2>::new([soft]).finger(
        scene::FingerSetup::new([Joint::prismatic([-1.0, 0.0]).stiffness(1e3)])
            .contact(pad(1.0).friction(-1.0).name("thumb")),
    );
    let told = setup.answers().expect_err("negative friction").to_string();
    assert!(told.contains("contact 1") && told.contains("thumb"), "{told}");
    // A finger without joints, with a valid contact, is accepted.
    let told = Setup::<2>::new([]).finger(scene::FingerSetup::new([]).contact(pad(1.0)));
    assert!(told.grasp().is_ok());
}

/// `presses_with` of a finger is the `force` of its contact, soft or not. With two contacts, or together with `pressed_with`, it is refused.
#[test]
fn a_finger_presses_with_the_force_of_its_contact() -> Tested {
    let read = |change: Change<'_>| {
        let mut scene = planar_scene();
        change(&mut scene["planar"]);
        serde_json::from_value::<Scene>(scene)
    };
    let of_the_finger = read(&|s| {
        let contact = s["fingers"][2]["contacts"][0].as_object_mut().expect("an object");
        let force = contact.remove("force");
        s["fingers"][2]["presses_with"] = force.expect("given");
    })?;
    assert_eq!(of_the_finger, serde_json::from_value(planar_scene())?);
    let soft =
        read(&|s| s["fingers"][2]["contacts"][0]["soft"] = json!({ "pad": { "width": 0.02, "strips": 2 } }))?;
    let Some(setup) = soft.planar() else { return Err("planar".into()) };
    let state = setup.grasp()?.solve(Wrench::ZERO)?;
    let state = state.equilibrium().ok_or("holds")?;
    // All points of this fingertip share one joint with the constant force.
    assert!(state.joints.len() == 4 && (state.joints[3].torque - 2.5).abs() < 1e-12);
    let told =
        read(&|s| s["fingers"][2]["contacts"][0]["pressed_with"] = json!(1)).expect_err("both").to_string();
    assert!(told.contains("pressed_with and"), "{told}");
    let told = read(&|s| s["fingers"][0]["presses_with"] = json!(1)).expect_err("two contacts").to_string();
    assert!(told.contains("presses_with: ") && told.contains("one contact"), "{told}");
    Ok(())
}
