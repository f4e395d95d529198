//! The first sentence of a verdict is right.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::hold::{Holding, WayOut};
use grasp_lcp::planar::{Contact, Grasp, Pressure, Ramp, SoftFingertip, Wrench};
use support::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn jaw(x: f64, name: &str, press: f64, friction: f64) -> Contact {
    jaws::jaw::<2>(x, [2000.0, 1000.0], friction).name(name).pressed_with(press)
}

fn down(newtons: f64) -> Wrench {
    Wrench::force([0.0, -newtons])
}

#[test]
fn everything_sticks() -> Tested {
    let gripper = Grasp::new([jaw(-0.04, "left", 25.0, 0.3), jaw(0.04, "right", 25.0, 0.3)])?;
    let verdict = gripper.hold(down(10.0))?;
    let lost = verdict.lost.as_ref().expect("further on");
    assert!((10.0 * lost.factor - 15.0).abs() < 1e-12, "{verdict}");
    assert_eq!(lost.slide.iter().map(|part| part.label.as_str()).collect::<Vec<_>>(), ["left", "right"]);
    assert_eq!((verdict.holds(), verdict.sticks()), (Some(true), Some(true)), "{verdict}");
    Ok(())
}

/// Two parallel feet under a guide: the rough foot still sticks after the smooth one slides.
#[test]
fn one_slides_and_the_other_holds() -> Tested {
    let foot = |x: f64, name: &str, friction: f64| {
        Contact::new([x, 0.0], [0.0, 1.0])
            .name(name)
            .series_stiffness(10.0, 10.0)
            .friction(friction)
            .command([0.1, 0.0])
    };
    let guide = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0);
    let block = Grasp::new([foot(-1.0, "rough", 0.5), foot(1.0, "smooth", 0.25), guide])?;
    // The guide is compressed, so that each foot presses with 50/51 N. Each foot carries half of the pull, up to 0.25 of this force at the smooth
    // foot; both together carry at most 0.75 of it.
    for (pull, sticks) in [(0.6, false), (0.4, true)] {
        let verdict = block.hold(Wrench::force([pull, 0.0]))?;
        assert_eq!((verdict.holds(), verdict.sticks()), (Some(true), Some(sticks)));
        let first = verdict.first_slip.as_ref().expect("smooth slides");
        assert!((pull * first.factor - 0.5 * 50.0 / 51.0).abs() < 1e-12, "{verdict}");
        assert_eq!(first.slide.iter().map(|part| part.label.as_str()).collect::<Vec<_>>(), ["smooth"]);
        let lost = verdict.lost.as_ref().expect("further on");
        assert!((pull * lost.factor - 0.75 * 50.0 / 51.0).abs() < 1e-12, "{verdict}");
    }
    Ok(())
}

/// A soft pad is reported as one contact with its own name.
#[test]
fn a_soft_pad_is_one_contact() -> Tested {
    let pad = SoftFingertip::pad(0.02, 2, Pressure::Uniform)?;
    let tips = [jaw(-0.04, "left", 25.0, 0.3), jaw(0.04, "right", 25.0, 0.3)];
    let gripper = Grasp::new([pad.contacts(&tips[0])?, pad.contacts(&tips[1])?].concat())?;
    let verdict = gripper.hold(down(20.0))?;
    let lost = verdict.lost.as_ref().expect("slips out");
    assert!((20.0 * lost.factor - 15.0).abs() < 1e-12 && lost.is_gross_slip, "{verdict}");
    assert_eq!(lost.slide.iter().map(|part| part.label.as_str()).collect::<Vec<_>>(), ["left", "right"]);
    assert!(lost.slide.iter().all(|part| part.of == 8 && part.is_whole()));
    let WayOut::SlidesOut { direction } = &lost.way_out else { panic!("{verdict}") };
    assert!(direction[1] < -1.0 + 1e-9 && lost.nothing_near.is_some(), "{verdict}");
    Ok(())
}

#[test]
fn contacts_without_names_have_numbers() -> Tested {
    let jaw = |x: f64| jaws::jaw::<2>(x, [1e3, 1e3], 0.5).pressed_with(10.0);
    let verdict = Grasp::new([jaw(-1.0), jaw(1.0)])?.hold(down(5.0))?;
    let lost = verdict.lost.as_ref().expect("further on");
    let names: Vec<_> = lost.slide.iter().map(|part| part.label.as_str()).collect();
    assert_eq!(names, ["contact 0", "contact 1"]);
    Ok(())
}

/// The weight of a box on a table acts before the push.
#[test]
fn the_load_at_rest_is_named() -> Tested {
    let foot = |x: f64, name: &str| {
        Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e4, 1e4).friction(0.4)
    };
    let table = Grasp::new([foot(-0.5, "left foot"), foot(0.5, "right foot")])?;
    let push = Ramp::load(down(10.0), Wrench::force([8.0, 0.0]));
    let verdict = table.hold(&push)?;
    assert!((8.0 * verdict.held_to - 4.0).abs() < 1e-12, "{verdict}");
    assert!(verdict.to_string().contains("load at rest"), "{verdict}");
    let nothing_at_rest = table.hold(Ramp::load(Wrench::force([0.0, 1.0]), Wrench::force([1.0, 0.0])))?;
    assert_eq!(nothing_at_rest.holds(), Some(false));
    assert!(nothing_at_rest.to_string().contains("even at rest"), "{nothing_at_rest}");
    Ok(())
}

/// A pinch that a moment turns by more than a small angle is not reported as held. Equal springs k at x = ±a and the squeeze P balance the moment
/// `M = (2 k a² - 2 a P) sin θ` after the rotation θ.
#[test]
fn large_motions_are_labelled() -> Tested {
    let jaw = |x: f64| jaws::jaw::<2>(x, [20.0, 20.0], 0.5).pressed_with(10.0);
    let verdict = Grasp::new([jaw(-1.0), jaw(1.0)])?.hold(Wrench::new([0.0, 0.0], 5.0))?;
    assert!((5.0 * verdict.held_to - 20.0 * f64::sin(0.1)).abs() < 1e-7, "{verdict}");
    let lost = verdict.lost.as_ref().expect("turns");
    assert!(matches!(lost.too_far, Some(TooFar::Turns { .. })), "{verdict}");
    assert!(verdict.to_string().starts_with("GOES TOO FAR"), "{verdict}");
    Ok(())
}

/// A wedge that is squeezed out may end loose between the faces. This is not a grasp.
#[test]
fn what_lies_loose_is_not_held() -> Tested {
    let jaw = |x: f64| jaws::jaw::<2>(x, [1e3, 1e3], 0.5);
    let verdict = Grasp::new([jaw(-1.0), jaw(1.0)])?.hold(Wrench::ZERO)?;
    assert_eq!(verdict.holds(), Some(false));
    assert!(matches!(verdict.holding, Holding::Loose), "{verdict}");
    Ok(())
}

/// Before a stop is reached, the object moves along its surface. This is not reported as sliding.
#[test]
fn what_closes_on_the_way_does_not_slide() -> Tested {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.9);
    let stop = Contact::new([0.1, 0.05], [-1.0, 0.0])
        .name("stop")
        .series_stiffness(1e4, 1e4)
        .friction(0.9)
        .clearance(1e-4);
    let table = Grasp::new([foot(-0.1), foot(0.1), stop])?;
    let push = Ramp::load(Wrench::force([0.0, -20.0]), Wrench::new([4.0, -4.0], 0.0));
    let verdict = table.hold(push)?;
    let stopped = &verdict.state.as_ref().expect("held").contacts[2];
    assert!(stopped.normal_force() > 0.1 && stopped.slip.norm() > 1e-4, "{stopped:?}");
    assert_eq!(verdict.sticks(), Some(true), "{verdict}");
    Ok(())
}
