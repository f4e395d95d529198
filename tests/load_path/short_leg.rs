//! A leg along which the load changes by a tiny part of itself is decided like a long leg: rounding of the whole load presses no contact.

use grasp_lcp::Error;
use grasp_lcp::load_path::PathEnd;
use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};

/// A plate under two straps. The end pin touches it without force, and no load along z presses it.
fn plate() -> Result<Grasp, Error> {
    let pin = |point: [f64; 3], normal: [f64; 3]| {
        Contact::new(point, normal).series_stiffness(2e7, 2e7).friction(0.2)
    };
    let (up, along) = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
    let strap = |x: f64| {
        let strap = Contact::new([x, 0.0, 0.04], [0.0, 0.0, -1.0]).series_stiffness(1e7, 1e7);
        strap.friction(0.2).force(997.139_257_360_728_2)
    };
    Grasp::new([
        pin([-0.08, -0.05, 0.0], up),
        pin([0.08, -0.05, 0.0], up),
        pin([0.0, 0.06, 0.0], up),
        pin([-0.07, -0.075, 0.02], along),
        pin([0.07, -0.075, 0.02], along),
        pin([-0.1, 0.0, 0.02], [1.0, 0.0, 0.0]),
        strap(-0.06),
        strap(0.06),
    ])
}

#[test]
fn nothing_slides_on_a_short_leg() -> Result<(), Error> {
    let grasp = plate()?;
    let load = Wrench::new([0.0, 0.0, 400.0], [0.0, 0.0, 0.0]);
    for part in [1.2885e-11, 1e-10, 1e-8, 1.0] {
        let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(load), Leg::load_by(load * part)])?;
        let events = path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{part}: {:?}", path.end());
        assert!(events.iter().all(|event| event.leg == 0), "{part}");
    }
    Ok(())
}
