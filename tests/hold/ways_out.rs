//! How an object leaves, where that is known by hand.

use grasp_lcp::hold::WayOut;
use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
use grasp_lcp::spatial;

type Tested = Result<(), grasp_lcp::Error>;

fn foot(x: f64, name: &str) -> Contact {
    Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e4, 8e3).friction(0.6)
}

fn box_on_feet() -> Result<Grasp, grasp_lcp::Error> {
    Grasp::new([foot(-0.05, "left"), foot(0.05, "right")])
}

fn names(parts: &[grasp_lcp::grasp::WholeContact]) -> Vec<&str> {
    parts.iter().map(|part| part.label.as_str()).collect()
}

/// 10 N at x = 0, pushed at a height of 0.2 m: it tips at 10 · 0.05 / 0.2 N, long before it slides.
#[test]
fn a_box_tips_over_its_foot() -> Tested {
    let push = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force_at([5.0, 0.0], [0.0, 0.2]));
    let verdict = box_on_feet()?.hold(push)?;
    let lost = verdict.lost.as_ref().expect("tips");
    assert!((5.0 * lost.factor - 2.5).abs() < 1e-12, "{}", lost.factor);
    let WayOut::TipsOver { about, opens } = &lost.way_out else { panic!("{verdict}") };
    assert_eq!((names(about), names(opens)), (vec!["right"], vec!["left"]));
    assert!(!lost.is_gross_slip);
    let said = verdict.to_string();
    assert!(
        said.starts_with(
            "TIPS OVER at 2.5 N of 5 N beside the load at rest: the object tips over about right, left opens"
        ),
        "{said}"
    );
    Ok(())
}

/// Pushed low it slides at μ W, whatever the feet.
#[test]
fn a_box_slides_when_pushed_low() -> Tested {
    let push = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force_at([-9.0, 0.0], [0.0, 0.0]));
    let lost = box_on_feet()?.hold(push)?.lost.expect("slides");
    assert!((9.0 * lost.factor - 6.0).abs() < 1e-12);
    assert!(lost.is_gross_slip);
    assert!(matches!(&lost.way_out, WayOut::SlidesOut { direction } if (direction[0] + 1.0).abs() < 1e-9));
    Ok(())
}

#[test]
fn a_box_lifts_off() -> Tested {
    let lift = Ramp::load(Wrench::force([0.0, -10.0]), Wrench::force([0.0, 12.0]));
    let verdict = box_on_feet()?.hold(lift)?;
    let lost = verdict.lost.as_ref().expect("lifts off");
    assert!((12.0 * lost.factor - 10.0).abs() < 1e-12);
    assert!(matches!(&lost.way_out, WayOut::LiftsOff { direction } if direction[1] > 0.99), "{verdict}");
    assert!(lost.nothing_near.is_some_and(|near| near.translation.is_infinite()), "{verdict}");
    Ok(())
}

/// Two points carry no moment about the line through them.
#[test]
fn a_pinch_spins_about_its_line() -> Tested {
    let tip = |x: f64, name: &str| {
        spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0])
            .name(name)
            .series_stiffness(1e3, 8e2)
            .friction(0.5)
            .pressed_with(10.0)
    };
    let pinch = spatial::Grasp::new([tip(-0.03, "thumb"), tip(0.03, "index")])?;
    let verdict = pinch.hold(spatial::Wrench::new([0.0, 0.0, -1.0], [1e-3, 0.0, 0.0]))?;
    let lost = verdict.lost.as_ref().expect("turns");
    assert_eq!(lost.factor, 0.0);
    assert!(
        matches!(&lost.way_out, WayOut::TurnsAbout { about } if names(about) == ["thumb", "index"]),
        "{verdict}"
    );
    assert!(verdict.to_string().contains("spins about the line thumb–index"), "{verdict}");
    Ok(())
}
