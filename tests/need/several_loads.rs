//! A squeeze for several loads is the largest of the squeezes for single loads.

use grasp_lcp::Error;
use grasp_lcp::need::{Need, Needed};
use grasp_lcp::spatial::{Contact, Grasp, Loads, Wrench};

/// A block on three pins, against two pins at its side and one at its end, under two straps.
fn fixture() -> Result<Grasp, Error> {
    let pin = |point: [f64; 3], normal: [f64; 3]| {
        Contact::new(point, normal).series_stiffness(2e7, 2e7).friction(0.2)
    };
    let (up, along) = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
    let strap = |x: f64| {
        let strap = Contact::new([x, 0.0, 0.04], [0.0, 0.0, -1.0]).series_stiffness(1e7, 1e7);
        strap.friction(0.2).force(1000.0)
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
fn a_pull_and_a_lift() -> Result<(), Error> {
    let at = |force: [f64; 3]| Wrench::force_at(force, [0.0, 0.0, 0.02]);
    let (pull, lift) = (at([800.0, 0.0, 0.0]), at([0.0, 0.0, 400.0]));
    let grasp = fixture()?;
    let bound = |needed: &Needed| needed.amount.bound().unwrap_or(f64::NAN);
    let alone = grasp.need(&Need::squeeze(pull))?;
    let both = grasp.need(&Need::squeeze(Loads::Each(vec![pull, lift])))?;
    assert!((bound(&both) / bound(&alone) - 1.0).abs() < 1e-9, "{both} {alone}");
    Ok(())
}
