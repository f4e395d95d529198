//! A contact that is pressed with a constant force carries this force wherever the object moves. A position command to the same place gives the same
//! forces.

use grasp_lcp::equilibrium::ContactAnswer;
use grasp_lcp::grasp::{Contact, HandPart, JointKind};
use grasp_lcp::load_path::{Leg, PathEnd};
use grasp_lcp::{Error, planar, spatial};
use support::facts;
use support::jaws::jaw;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Soft tips whose position is commanded to where a constant force moves them have the same contact forces as tips with this constant force.
#[test]
fn a_position_at_the_place_of_the_slide_carries_the_same() -> Tested {
    let jaw = |x: f64| {
        let jaw = Contact::<3>::new([x, 0.0, 0.0], [-x, 0.1 * x, 0.0]);
        jaw.name(if x < 0.0 { "left" } else { "right" }).series_stiffness(2e3, 1.5e3).friction(0.7)
    };
    let tip = spatial::SoftFingertip::ring(0.01, 7)?;
    let rest = || {
        [jaw(0.03)]
            .into_iter()
            .chain([Contact::new([0.0, 0.0, -0.02], [0.0, 0.0, 1.0]).series_stiffness(4e3, 1e3)])
    };
    let weight = spatial::Wrench::force_at([0.3, -0.2, -2.0], [0.002, 0.001, 0.0]);

    let by_force = spatial::Grasp::new(tip.contacts(&jaw(-0.03).force(12.0))?.into_iter().chain(rest()))?;
    let outcome = by_force.solve(weight)?;
    let held = outcome.equilibrium().ok_or("holds")?;
    let total: f64 = held.contacts[..7].iter().map(ContactAnswer::normal_force).sum();
    assert!((total / 12.0 - 1.0).abs() < 1e-13, "{total}");
    let [slide] = &held.joints[..] else { return Err("several slides".into()) };
    assert_eq!(slide.joint.text(), "slide of left");
    assert!(slide.to_string().starts_with("left presses with a constant 12 N"), "{slide}");
    assert!(slide.kind == JointKind::Slides && (slide.torque / 12.0 - 1.0).abs() < 1e-13);

    let moved = jaw(-0.03).command([slide.displacement, 0.0, 0.0]);
    let by_position = spatial::Grasp::new(tip.contacts(&moved)?.into_iter().chain(rest()))?;
    let outcome = by_position.solve(weight)?;
    let same = outcome.equilibrium().ok_or("holds")?;
    for (a, b) in held.contacts.iter().zip(&same.contacts) {
        assert!((a.force - b.force).norm() < 1e-11, "{}: {} {}", a.contact, a.force, b.force);
    }
    Ok(())
}

/// A planar pad is pressed with a constant 10 N against a fixed jaw. The limit load is 0.5 times the sum of both normal forces.
#[test]
fn a_soft_pad_slides_at_what_its_force_rubs_with() -> Tested {
    let jaw = |x: f64| jaw::<2>(x, [2e3, 1e3], 0.5);
    let pad = planar::SoftFingertip::pad(0.01, 3, planar::Pressure::Hertz)?;
    let points = pad.contacts(&jaw(-0.03).name("pad").force(10.0))?;
    let grasp = planar::Grasp::new(points.into_iter().chain([jaw(0.03)]))?;
    let push = planar::Wrench::force([-2.0, 0.0]);
    for (base, most) in [(planar::Wrench::ZERO, 10.0), (push, 9.0)] {
        let mut path = grasp.follow(base, &[Leg::load_by(planar::Wrench::force([0.0, -20.0]))])?;
        path.run();
        let Some(PathEnd::Lost(loss)) = path.end() else { return Err("slides out".into()) };
        assert!((20.0 * loss.fraction / most - 1.0).abs() < 1e-12, "{}", loss.fraction);
        let pressed: f64 = path.forces()[..grasp.len() - 1].iter().map(|force| force[0]).sum();
        assert!((pressed / 10.0 - 1.0).abs() < 1e-12, "{pressed}");
    }
    Ok(())
}

/// Slides of constant forces come after the joints of fingers, so that a force does not change the index of a joint.
#[test]
fn slides_come_behind_all_joints() -> Tested {
    use planar::hand::{Finger, Hand, Joint, Tendon};
    let pad =
        |x: f64, y: f64| planar::Contact::new([x, y], [-x, 0.0]).series_stiffness(1e4, 1e4).friction(0.5);
    let hand = Hand::new([
        Finger::fixed(pad(-1.0, 0.0).force(5.0)),
        Finger::new([Joint::prismatic([-1.0, 0.0]).name("jaw")]).contact(pad(1.0, 0.0)),
    ]);
    assert_eq!((hand.joints(), hand.coordinates()), (2, 5));
    // The tendon names an arm for the first joint alone. The slide behind the contact with a constant force needs none.
    let grasp = hand.tendon(Tendon::new([1.0]).tension(5.0)).grasp()?;
    let outcome = grasp.solve(planar::Wrench::ZERO)?;
    let held = outcome.equilibrium().ok_or("holds")?;
    assert_eq!(held.joints[0].joint.text(), "jaw");
    let slide = &held.joints[1];
    assert_eq!((slide.joint.part, slide.joint.text()), (HandPart::Joint(1), "slide of contact 0".into()));
    assert!(held.contacts.iter().all(|contact| (contact.normal_force() - 5.0).abs() < 1e-13));
    Ok(())
}

/// A constant force together with a position command is refused with an error that names both.
#[test]
fn a_force_beside_a_position_is_refused() {
    use planar::hand::{Finger, Hand, Joint};
    let pad = |x: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e4, 1e4).name("pad");
    let moved = Finger::new([Joint::prismatic([1.0, 0.0])]);
    for (finger, field, value, allowed) in [
        (Finger::fixed(pad(1.0).force(-3.0)), "force", "-3", "from 0"),
        (Finger::fixed(pad(1.0).force(3.0).command([0.1, 0.0])), "command", "0.1", "zero along"),
        (moved.contact(pad(1.0).force(3.0)), "force", "3", "left out"),
    ] {
        let error = Hand::new([finger]).grasp().map(drop).expect_err("refused");
        let [place, datum, given] = facts(&error);
        assert!(place.ends_with("0 (pad)") && datum == field && given == value, "{error}");
        let (Error::Contact { allowed: is, .. } | Error::Hand { allowed: is, .. }) = error else {
            panic!("{error}")
        };
        assert!(is.starts_with(allowed), "{is}");
    }
}
