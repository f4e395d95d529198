//! A box that jumps on the way is said to come to rest, or to be held, counting no momentum.

use grasp_lcp::Error;
use grasp_lcp::need::Need;
use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};

/// Two feet that carry 10 N each. The foot of plastic has stiffer springs and slides from 7.5 N on; what it then gives up, the foot of rubber takes over
/// in a jump.
fn feet(kinetic: f64) -> Result<Grasp, Error> {
    let foot = |x: f64, stiffness: f64, mu: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, stiffness).friction(mu)
    };
    Grasp::new([foot(-0.1, 5e3, 0.5).kinetic(kinetic), foot(0.1, 2.5e3, 0.55)])
}

const WEIGHT: [f64; 2] = [0.0, -20.0];

#[test]
fn a_box_whose_foot_slips_in_a_jump() -> Result<(), Error> {
    let push = Wrench::force([7.6, 0.0]);
    for (kinetic, jumps) in [(0.25, true), (0.5, false)] {
        let grasp = feet(kinetic)?;
        let shaken = grasp.shake(Wrench::force(WEIGHT), &Leg::there_and_back(push))?;
        assert_eq!((shaken.rests(), shaken.jumps), (Some(true), jumps), "{shaken}");
        assert_eq!(
            shaken.to_string().contains("it jumps and is caught, counting no momentum"),
            jumps,
            "{shaken}"
        );
        let needed = grasp.need(&Need::load(push * 0.1).on_top_of(Wrench::force(WEIGHT)))?;
        let words = needed.to_string();
        let first = words.lines().next().unwrap_or_default();
        assert_eq!((needed.jumps, first.contains("holds, counting no momentum")), (jumps, jumps), "{needed}");
    }
    Ok(())
}
