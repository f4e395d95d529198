//! A verdict ends where motions are no longer small. The limits of rotation, slip and gap agree with closed forms, also for loads that turn.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::planar::{Contact, Grasp, Leg, SoftFingertip, Turn, Wrench};
use grasp_lcp::{Error, Settings, spatial};

type Tested = Result<(), Error>;

/// Stiffness of each spring, N/m, and half their distance, m.
const SPRING: f64 = 1000.0;
const ARM: f64 = 0.05;

fn beam() -> Result<Grasp, Error> {
    Grasp::new(
        [-ARM, ARM].map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(SPRING, SPRING).bonded()),
    )
}

fn moment(newton_metres: f64) -> Wrench {
    Wrench::new([0.0, 0.0], newton_metres)
}

/// Two pads of 0.1 mm hold a moment of 80 N m by friction, μ 2 N a. For a larger moment they would wedge only after a rotation of 85°.
#[test]
fn narrow_pads_do_not_hold_by_wedging() -> Tested {
    let pair = SoftFingertip::pair(1e-4)?;
    let pad = |x: f64, name: &str| {
        let tip = Contact::new([x, 0.0], [-x, 0.0]).name(name);
        pair.contacts(&tip.series_stiffness(1e8, 1e8).friction(0.2).pressed_with(5000.0))
    };
    let chuck = Grasp::new([pad(-0.04, "a")?, pad(0.04, "b")?].concat())?;
    let verdict = chuck.hold(moment(100.0))?;
    assert_eq!(verdict.holds(), Some(false));
    assert!(verdict.held_to > 0.8 && verdict.held_to < 0.801, "{}", verdict.held_to);
    assert!((verdict.everything_slides.expect("both pads slide") - 0.8).abs() < 1e-5);
    // The verdict names gross slip instead of the large rotation.
    let lost = verdict.lost.as_ref().expect("it turns");
    assert!(matches!(lost.too_far, Some(TooFar::Turns { .. })), "{verdict}");
    assert!(verdict.to_string().starts_with("SLIPS OUT at 80.0001"), "{verdict}");
    let held = chuck.hold(moment(60.0))?;
    assert_eq!(held.holds(), Some(true));
    assert!((held.lost.expect("at 80 N m").factor * 60.0 - 100.0 * verdict.held_to).abs() < 1e-6);
    Ok(())
}

/// `M = 2 k a² θ` in the plane, and twice as much about each axis of six springs in space.
#[test]
fn a_rotation_ends_at_its_angle() -> Tested {
    let turned = 2.0 * SPRING * ARM * ARM * 0.1;
    let verdict = beam()?.hold(moment(1.0))?;
    let lost = verdict.lost.as_ref().expect("turns");
    assert!((verdict.held_to - turned).abs() < 1e-13 && lost.factor == verdict.held_to);
    assert!(matches!(lost.too_far, Some(TooFar::Turns { body: None, limit: 0.1 })), "{lost:?}");
    let ends =
        [0, 1, 2].map(|axis| [ARM, -ARM].map(|x| core::array::from_fn(|k| if k == axis { x } else { 0.0 })));
    let contacts = ends.into_iter().flatten().map(|end: [f64; 3]| {
        spatial::Contact::new(end, end.map(|x| -x)).series_stiffness(SPRING, SPRING).bonded()
    });
    let about = [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0];
    let verdict = spatial::Grasp::new(contacts)?.hold(spatial::Wrench::new([1.0, 0.0, 0.0], about))?;
    assert!((verdict.held_to - 2.0 * turned).abs() < 1e-13, "{}", verdict.held_to);
    Ok(())
}

/// A common translation of all springs has no limit.
#[test]
fn a_translation_does_not_count() -> Tested {
    let verdict = beam()?.hold(Wrench::force([300.0, -200.0]))?;
    let moved = verdict.state.as_ref().expect("held").twist.translation()[0];
    assert!(moved > 2.9 * ARM && verdict.held_to == 100.0 && verdict.lost.is_none(), "{verdict}");
    Ok(())
}

/// After two jaws at ±10 mm slide, only a spring K holds: `u = (F − 2 μ N) / K`, and the slip is `u − μ N / k`.
#[test]
fn a_slip_ends_at_a_tenth_of_the_size() -> Tested {
    let (spring, tangential, press, friction) = (100.0, 1000.0, 10.0, 0.5);
    let jaw = |y: f64, name: &str| {
        Contact::new([ARM, y], [0.0, -y])
            .name(name)
            .series_stiffness(1e4, tangential)
            .friction(friction)
            .pressed_with(press)
    };
    let spring_at =
        Contact::new([-ARM, 0.0], [1.0, 0.0]).name("spring").series_stiffness(spring, spring).bonded();
    let grasp = Grasp::new([spring_at, jaw(0.01, "upper"), jaw(-0.01, "lower")])?;
    let points = [[-ARM, 0.0], [ARM, 0.01], [ARM, -0.01]];
    let middle = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / 3.0);
    let square = |p: &[f64; 2]| (p[0] - middle[0]).powi(2) + (p[1] - middle[1]).powi(2);
    let size = (points.iter().map(square).sum::<f64>() / 3.0).sqrt();
    let moved = 0.1 * size + friction * press / tangential;
    let force = spring * moved + 2.0 * friction * press;
    let verdict = grasp.hold(Wrench::force([2.0 * force, 0.0]))?;
    assert!((2.0 * verdict.held_to - 1.0).abs() < 1e-12, "{}", verdict.held_to);
    let lost = verdict.lost.as_ref().expect("slips far");
    let Some(TooFar::Slips { contact, limit }) = &lost.too_far else { panic!("{lost:?}") };
    assert!(["upper", "lower"].contains(&contact.label.as_str()) && (limit - 0.1 * size).abs() < 1e-15);
    assert!(verdict.to_string().starts_with("GOES TOO FAR"), "{verdict}");
    Ok(())
}

/// A moment `M sin φ` exceeds the limit of rotations at `asin(0.1 · 2 k a² / M)`. Until then no contact changes its state.
#[test]
fn a_load_that_turns_leaves_within_its_piece() -> Tested {
    let most = 2.0 * SPRING * ARM * ARM * 0.1 / 0.8;
    let turn = Turn::new(Wrench::ZERO, Wrench::ZERO, moment(most)).up_to(core::f64::consts::PI);
    let grasp = beam()?;
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::turn(&turn)])?;
    path.run();
    let end = path.end_of_small_motions().unwrap();
    assert!((end.fraction * core::f64::consts::PI - 0.8_f64.asin()).abs() < 1e-12, "{end:?}");
    assert!(path.state().expect("there").too_far.is_none());
    Ok(())
}

/// The settings determine the limit, also for answers, and are validated.
#[test]
fn settings_say_what_is_small() -> Tested {
    let turned = 2.0 * SPRING * ARM * ARM * 0.3;
    let grasp = beam()?;
    let solved = |grasp: &Grasp| -> Result<bool, Error> {
        Ok(grasp.solve(moment(0.99 * turned))?.equilibrium().expect("springs").is_beyond_small_motions())
    };
    let wider = grasp.with(&Settings::default().with_small_motions(0.3, 0.1));
    assert!(solved(&grasp)? && !solved(&wider)?);
    assert!((wider.hold(moment(1.0))?.held_to - turned).abs() < 1e-13);
    for (rotation, slip) in [(0.0, 0.1), (f64::NAN, 0.1), (0.1, -1.0), (0.1, f64::INFINITY)] {
        let refused = grasp.with(&Settings::default().with_small_motions(rotation, slip));
        assert!(matches!(refused.hold(moment(1.0)), Err(Error::Argument { .. })), "{rotation} {slip}");
        assert!(matches!(refused.solve(moment(1.0)), Err(Error::Argument { .. })));
    }
    Ok(())
}

/// Frictionless fixtures and wedges are held if they move little.
#[test]
fn what_normal_forces_hold_is_held() -> Tested {
    let vee = |x: f64| Contact::new([x, 0.0], [-x, 1.0]).series_stiffness(1e6, 1e6);
    let verdict = Grasp::new([vee(-1.0), vee(1.0)])?.hold(Wrench::force_at([0.3, -1.0], [0.0, 1.0]))?;
    assert_eq!((verdict.holds(), verdict.everything_slides), (Some(true), None), "{verdict}");
    let wedge = |x: f64| vee(x).friction(0.2);
    let verdict = Grasp::new([wedge(-1.0), wedge(1.0)])?.hold(Wrench::force([0.0, -1.0]))?;
    assert_eq!((verdict.holds(), verdict.everything_slides), (Some(true), Some(0.0)), "{verdict}");
    let first = verdict.first_slip.as_ref().expect("both slide");
    assert!(first.factor == 0.0 && first.slide.len() == 2, "{verdict}");
    Ok(())
}

/// A picture hangs on a wire, and both of its contacts with the wall slide from the start. The wire still carries it, so that nothing slips out.
#[test]
fn what_a_wire_holds_does_not_slip_out() {
    let text = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
        {"point": [0, 0], "normal": [1, 0], "friction": 0.3, "stiffness": 1e6},
        {"point": [0, 0.5], "normal": [1, 0], "friction": 0.3, "stiffness": 1e6}],
        "links": [{"name": "wire", "cable": {"from": [0.02, 0.4], "to": [0, 0.7]}, "stiffness": 1e5}]}}"#;
    let scene = grasp_lcp::scene::Scene::from_json(text.as_bytes()).expect("well posed");
    let picture = scene.planar().expect("planar").grasp().expect("well posed");
    let verdict =
        picture.hold(grasp_lcp::planar::Wrench::force_at([0.0, -4000.0], [0.02, 0.25])).expect("well posed");
    let lost = verdict.lost.as_ref().expect("a limit of small motions");
    assert!(lost.too_far.is_some() && !lost.is_gross_slip, "{verdict}");
    assert!(verdict.to_string().starts_with("GOES TOO FAR"), "{verdict}");
}
