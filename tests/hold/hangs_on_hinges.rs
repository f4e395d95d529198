//! Bodies whose only contact is a hinge: what hangs on it swings, what stands on it turns over, and sentences name the body that turns.

use grasp_lcp::hold::{LossVerb, ShortVerdict};
use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};

type Tested = Result<(), grasp_lcp::Error>;

/// A pendulum of 9.81 N, 0.1 m long, swings under a force F to the side by the angle with the tangent F / 9.81. All its points lie at the hinge.
#[test]
fn a_pendulum_swings() -> Tested {
    let pendulum = Bodies::new([Body::new("bob").load(Wrench::force_at([0.0, -9.81], [0.0, -0.1]))])
        .links([Link::hinge([0.0, 0.0]).to_ground("bob")])
        .grasp()?;
    let verdict = pendulum.hold(Wrench::force_at([0.5, 0.0], [0.0, -0.1]))?;
    let swing = verdict.swing.as_ref().expect("it swings");
    assert!((swing.bodies[0].twist.rotation() - 0.5 / 9.81).abs() < 1e-9, "{verdict}");
    assert!(verdict.to_string().contains("bob turns 2.92"), "{verdict}");
    let lost = pendulum.hold(Wrench::force_at([1.0, 0.0], [0.0, -0.1]))?;
    assert_eq!(ShortVerdict::from(&lost).motion, Some(LossVerb::GivesWay), "{lost}");
    assert!(lost.to_string().contains("bob turns about (0, 0)"), "{lost}");
    Ok(())
}

/// Pliers on a hinge hold a part with 30 N at handles of 0.1 m. The handles lie 20 mm to either side of the line through the pin, on the side towards
/// which they are pushed. So they drive a turn about the pin, until a pull of 60 N at the part steadies it: no swing, but a loss at rest.
#[test]
fn pliers_turn_over_at_rest() -> Tested {
    let jaw = |y: f64, against: &str| {
        let contact = Contact::new([0.03, y], [0.0, -y.signum()]).series_stiffness(1e6, 1e6).friction(0.4);
        contact.on("part").against(against)
    };
    let handle =
        |name: &str, y: f64| Body::new(name).load(Wrench::force_at([0.0, -30.0 * y.signum()], [-0.1, y]));
    let pliers = Bodies::new([Body::new("part"), handle("upper", 0.02), handle("lower", -0.02)])
        .contacts([jaw(0.005, "lower"), jaw(-0.005, "upper")])
        .links([
            Link::hinge([0.0, 0.0]).between("upper", "lower"),
            Link::hinge([0.0, 0.0]).to_ground("upper"),
        ])
        .grasp()?;
    let verdict = pliers.hold(Wrench::force_at([60.0, 0.0], [0.03, 0.0]))?;
    assert!(verdict.swing.is_none() && verdict.holds() == Some(false), "{verdict}");
    assert_eq!(ShortVerdict::from(&verdict).motion, Some(LossVerb::TurnsOver), "{verdict}");
    Ok(())
}
