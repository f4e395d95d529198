//! A question reads back from its own text form. It counts contacts as a scene does: a soft fingertip is one contact.

use grasp_lcp::Error;
use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::improve::{Improve, ImproveGoal};
use grasp_lcp::need::Need;
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Leg, Ramp, Turn, Wrench};
use grasp_lcp::scene::{Answer, Fingertip, FingertipPatch, PathOutcome, Scene, Setup};
use grasp_lcp::squeeze::Loads;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Checks that the text is read as the value, and the value written as the text.
macro_rules! is_written {
    ($text:expr, $value:expr) => {{
        let value = $value;
        let mut all = vec![value.clone()];
        all.push(serde_json::from_str($text)?);
        all.push(serde_json::from_str(&serde_json::to_string(value)?)?);
        assert!(all.iter().all(|other| other == value), "{all:?}");
    }};
}

fn down(newtons: f64) -> Wrench {
    Wrench::force([0.0, -newtons])
}

#[test]
fn needs_are_written_by_their_fields() -> Tested {
    let load = r#""load": {"force": [0, -12]}"#;
    is_written!(&format!(r#"{{"quantity": "squeeze", {load}}}"#), &Need::squeeze(down(12.0)));
    let need = Need::friction_of([1], down(12.0)).if_friction_lower_by(0.2).to_stick();
    let text = format!(
        r#"{{"quantity": "friction", "contact": 1, {load}, "friction_less": 0.2, "demand": "sticks"}}"#
    );
    is_written!(&text, &need);
    let two = Need::friction_of([0, 2], vec![down(1.0), down(2.0)]).with_safety(1.5);
    let text = r#"{"quantity": "friction", "contacts": [0, 2], "loads": [{"force": [0, -1]}, {"force": [0, -2]}], "safety": 1.5}"#;
    is_written!(text, &two);
    let arm = Need::arm(down(2.0), Wrench::new([0.0, 0.0], -2.0)).on_top_of(down(1.0));
    let text = r#"{"quantity": "arm", "load": {"force": [0, -2]}, "per_metre": {"moment": -2}, "base": {"force": [0, -1]}}"#;
    is_written!(text, &arm);
    let turn = Turn::tilting([0.0, -2.0], [0.0, 0.1]);
    is_written!(r#"{"quantity": "angle", "turn": {"weight": [0, -2], "at": [0, 0.1]}}"#, &Need::angle(turn));
    let any = Loads::AnyForce { base: down(3.0), size: 2.0, point: [0.1, 0.0] };
    let text = r#"{"quantity": "load", "load": {"force": [0, -3]}, "any_force": 2, "at": [0.1, 0]}"#;
    is_written!(text, &Need::load(any));
    Ok(())
}

#[test]
fn other_questions_are_written_by_their_fields() -> Tested {
    let improve =
        Improve::new(down(1.0)).pressing_at_most(10.0).with_goal(ImproveGoal::Reserve).with_starts(3);
    is_written!(r#"{"load": {"force": [0, -1]}, "at_most": 10, "goal": "reserve", "starts": 3}"#, &improve);
    let slips = [Slip::first(down(3.0)).squeezed(0.5), Slip::gross(down(4.0)).in_layout(1)];
    let unknowns = [Unknown::friction(), Unknown::carried().of_contacts([1]).named("right")];
    let identify =
        Identify::new(unknowns, slips).with_points([[-1.0, 0.0], [1.0, 0.0]]).knowing([1], 2.0, 0.1);
    let text = r#"{
        "unknowns": [{"quantity": "friction", "contacts": []}, {"quantity": "carried", "contacts": [1], "name": "right"}],
        "slips": [{"slip": "first", "load": {"force": [0, -3]}, "squeeze": 0.5}, {"load": {"force": [0, -4]}, "layout": 1}],
        "layouts": [[[-1, 0], [1, 0]]],
        "known": [{"unknowns": [1], "value": 2, "scatter": 0.1}]
    }"#;
    is_written!(text, &identify);
    let leg = Leg::load_to(down(1.0)).and_commands_by([[0.002, 0.0]; 2]).and_body_load_by("lid", down(2.0));
    let text = r#"{"load_to": {"force": [0, -1]}, "commands_by": [[0.002, 0], [0.002, 0]], "body_loads_by": {"lid": {"force": [0, -2]}}}"#;
    is_written!(text, &leg);
    let turn = Turn::tilting([0.0, -2.0], [0.0, 0.0]).up_to(std::f64::consts::FRAC_PI_2);
    is_written!(r#"{"turn": {"weight": [0, -2], "angle_deg": 90}}"#, &Leg::turn(&turn));
    Ok(())
}

/// A soft jaw of two points and a hard one.
fn jaws(half: f64) -> Result<Grasp, Error> {
    let jaw = |x: f64| {
        Fingertip::from(
            Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0),
        )
    };
    Setup::new([jaw(-half).soft(FingertipPatch::Pair { width: 0.01 }), jaw(half)]).grasp()
}

#[test]
fn all_points_of_a_soft_fingertip_follow_its_command() -> Tested {
    let grasp = jaws(0.03)?;
    assert_eq!(grasp.len(), 3);
    let end = |leg: Leg| -> Result<_, Error> {
        let mut path = grasp.follow(Wrench::ZERO, &[leg])?;
        path.run();
        Ok(path.state())
    };
    let change = [0.001, 0.0002];
    let by = end(Leg::commands_by([change; 2]))?.expect("holds");
    assert_eq!(Some(by), end(Leg::commands_by([change; 3]))?);
    assert_eq!(end(Leg::commands_to([change; 2]))?, end(Leg::commands_to([change; 3]))?);
    let onset =
        |rows| grasp.onset(Ramp::load(Wrench::ZERO, down(1.0)).with_commands(vec![[-0.0001, 0.0]; rows]));
    assert_eq!(onset(2)?.factor().ok_or("slides")?, onset(3)?.factor().ok_or("slides")?);
    let refused = Error::Size { what: "command changes", given: 1, expected: 2 };
    assert_eq!(onset(1).expect_err("one row"), refused);
    assert!(matches!(end(Leg::commands_to([change; 4])), Err(Error::Size { given: 4, expected: 2, .. })));
    Ok(())
}

#[test]
fn friction_of_a_soft_fingertip_is_that_of_all_its_points() -> Tested {
    let grasp = jaws(0.03)?;
    let all = grasp.need(&Need::friction(down(12.0)))?;
    assert!((all.amount.bound().ok_or("some does")? - 0.6).abs() < 1e-9);
    assert_eq!(grasp.need(&Need::friction_of([0, 1], down(12.0)))?.amount, all.amount);
    let error = grasp.need(&Need::friction_of([2], down(12.0))).expect_err("two contacts");
    assert!(matches!(error, Error::NoSuchContact { contact: 2, contacts: 2, .. }));
    let error = grasp.need(&Need::friction_of([], down(12.0))).expect_err("none");
    assert!(matches!(error, Error::Argument { what: "number of contacts", value: 0.0, .. }));
    let slips = [6.1, 5.8, 6.4].map(|newtons| Slip::gross(down(newtons)));
    let [both, each] = [Unknown::friction(), Unknown::friction().of_contacts([0, 1])]
        .map(|unknown| Identify::new([unknown.named("rubber")], slips.clone()));
    assert_eq!(grasp.identify(&both)?, grasp.identify(&each)?);
    Ok(())
}

/// A layout by points equals a grasp built at these points, also for the points of a soft fingertip.
#[test]
fn contacts_of_a_layout_are_moved() -> Tested {
    let grasp = jaws(0.03)?;
    let slips =
        [Slip::gross(down(6.1)), Slip::gross(Wrench::force_at([0.0, -5.0], [0.01, 0.0])).in_layout(1)];
    let asked = Identify::new([Unknown::friction()], slips);
    let by_points = grasp.identify(&asked.clone().with_points([[-0.05, 0.0], [0.05, 0.0]]))?;
    let by_grasps = grasp.identify(&asked.clone().and_layouts([jaws(0.05)?]))?;
    let [a, b] = [by_points, by_grasps].map(|found| found.estimates[0].value);
    assert!((a - b).abs() < 1e-12 * b, "{a} and {b}");
    let error = grasp.identify(&asked.with_points([[-0.05, 0.0]])).expect_err("one point");
    assert_eq!(error, Error::Size { what: "points of a layout", given: 1, expected: 2 });
    Ok(())
}

/// Commands of fingers do not change the pretension of a spring.
#[test]
fn commands_leave_springs_alone() -> Tested {
    let scene: Scene = serde_json::from_str(
        r#"{"format": "grasp-lcp/1", "planar": {
            "contacts": [
                {"point": [-0.03, 0], "normal": [1, 0], "stiffness": 1e3, "friction": 0.5, "command": [0.01, 0]},
                {"point": [0.03, 0], "normal": [-1, 0], "stiffness": 1e3, "friction": 0.5, "command": [0.01, 0]}
            ],
            "links": [{"spring": {"from": [0, 0], "to": [0, 0.1]}, "stiffness": 100, "pretension": 2}],
            "questions": [
                {"solve": {}},
                {"follow": {"legs": [{"commands_to": [[0.01, 0], [0.01, 0]]}]}}
            ]
        }}"#,
    )?;
    let Some(answers) = scene.answers()?.planar() else { panic!("in the plane") };
    let [Answer::Solve(rest), Answer::Follow(path)] = &answers[..] else { panic!("{answers:?}") };
    let rest = rest.outcome.equilibrium().ok_or("at rest")?;
    let PathOutcome::Completed { state } = &path.end else { panic!("{:?}", path.end) };
    let state = state.as_ref().ok_or("at its end")?;
    for (before, after) in rest.contacts.iter().zip(&state.contacts) {
        assert!((before.force - after.force).norm() < 1e-12, "{} and {}", before.force, after.force);
    }
    assert!((rest.contacts[2].force[0].abs() - 2.0).abs() < 0.2, "{}", rest.contacts[2].force);
    Ok(())
}

/// A box of 10 N lies on a box of 20 N on a table. Both slide on the table at 0.5 · 30 N, and the upper box alone slides at 0.3 · 10 N.
#[test]
fn a_need_has_loads_that_grow_together() -> Tested {
    let face = |y: f64, mu: f64| {
        [-0.2, 0.2].map(|x| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu))
    };
    let boxes = Bodies::new([
        Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
        Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
    ])
    .contacts(face(0.0, 0.5).map(|contact| contact.on("lower")))
    .contacts(face(0.2, 0.3).map(|contact| contact.on("upper").against("lower")))
    .grasp()?;
    let pull = |newtons: f64, y: f64| Wrench::force_at([newtons, 0.0], [0.0, y]);
    let need = Need::load(pull(1.0, 0.01));
    let together = need.clone().together_with("upper", pull(0.5, 0.21));
    for (need, most) in [(&need, 15.0), (&together, 6.0)] {
        let found = boxes.need(need)?.amount.bound().ok_or("it is lost")?;
        assert!((found - most).abs() < 1e-8, "{found}");
    }
    let error = boxes.need(&together.on_top_of(pull(1.0, 0.0))).expect_err("a base");
    assert!(matches!(error, Error::Question { question: "need", field: "together_with", .. }), "{error}");
    Ok(())
}
