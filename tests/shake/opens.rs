//! What opens or yields in the cycles is named: a box that is thrown to a ceiling and back, a cup whose lip lets air in, and motors that slip.

use grasp_lcp::Error;
use grasp_lcp::grasp::PartLabel;
use grasp_lcp::planar;
use grasp_lcp::shake::Repeats;
use grasp_lcp::spatial;

/// A box of 10 N on two feet, 3 mm below two stops. A cyclic force of 15 N lifts it to the stops and lets it fall back. A force below its weight
/// leaves it on the feet.
#[test]
fn a_box_that_is_thrown_to_and_fro() -> Result<(), Error> {
    use planar::{Contact, Grasp, Leg, Need, Wrench};
    let spring = |at, normal| Contact::new(at, normal).series_stiffness(1e6, 7e5).friction(0.3);
    let stop = |x| spring([x, 0.1], [0.0, -1.0]).clearance(3e-3);
    let feet = [-0.1, 0.1].map(|x| spring([x, 0.0], [0.0, 1.0]));
    let grasp = Grasp::new(feet.into_iter().chain([-0.1, 0.1].map(stop)))?;
    let weight = Wrench::force([0.0, -10.0]);
    let lifted = |by: f64| grasp.shake(weight, &Leg::there_and_back(Wrench::force([0.0, by])));
    let thrown = lifted(15.0)?;
    let Repeats::Alternates { slides, jumps: 2, .. } = &thrown.repeats else { panic!("{thrown}") };
    assert!(slides.is_empty() && thrown.opens.len() == 4, "{thrown}");
    assert_eq!((thrown.rests(), thrown.stays()), (Some(false), Some(true)));
    assert!(thrown.to_string().starts_with("JUMPS TO AND FRO: twice in every cycle"), "{thrown}");
    let still = lifted(9.0)?;
    assert!(still.rests() == Some(true) && still.opens.is_empty(), "{still}");
    let needed = grasp.need(&Need::load(Wrench::force([0.0, 1.0])).on_top_of(weight).to_rest())?;
    let most = needed.amount.bound().expect("a bound");
    assert!((most - 10.0).abs() < 1e-6, "{most}");
    Ok(())
}

/// A cup with vacuum V on a ring of radius R, pulled by F at the arm a. The point of the lip with the least force is on the side of the load, and it
/// opens where `(V - F) R / 2 = F a`.
#[test]
fn a_lip_that_opens_in_every_cycle() -> Result<(), Error> {
    use spatial::{Contact, Grasp, Leg, Need, SuctionCup, Wrench};
    const RADIUS: f64 = 0.03;
    const VACUUM: f64 = 170.0;
    const ARM: f64 = 0.05;
    let lip = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).series_stiffness(1e6, 5e5).friction(0.6);
    let grasp = Grasp::new(SuctionCup::of_force(RADIUS, 12, VACUUM)?.contacts(&lip)?)?;
    let pull = |force: f64| Wrench::force_at([0.0, 0.0, -force], [ARM, 0.0, 0.0]);
    let opens_at = VACUUM * RADIUS / (RADIUS + 2.0 * ARM);
    for (part, opens) in [(0.99, false), (1.01, true)] {
        let shaken = grasp.shake(Wrench::ZERO, &Leg::there_and_back(pull(part * opens_at)))?;
        assert_eq!((shaken.leaks.len(), shaken.rests()), (usize::from(opens), Some(!opens)), "{shaken}");
        assert_eq!(shaken.to_string().starts_with("LEAKS: "), opens, "{shaken}");
    }
    let needed = grasp.need(&Need::load(pull(1.0)).to_rest())?;
    let most = needed.amount.bound().expect("a bound");
    assert!((most / opens_at - 1.0).abs() < 1e-6, "{most} {opens_at}");
    Ok(())
}

/// Two motors press on an object by fingers 60 mm long. Their torque is limited to 0.4 N m, where they slip. A push of 4 N to one side and then to
/// the other makes one motor slip in the first cycle.
#[test]
fn a_motor_that_slips() -> Result<(), Error> {
    use grasp_lcp::Limit;
    use planar::hand::{Finger, Hand, Joint};
    use planar::{Contact, Leg, Wrench};
    let finger = |side: f64, name: &str| {
        let motor = Joint::revolute([0.02 * side, 0.06]).name(name).stiffness(3.5).command(-0.09 * side);
        let tip = Contact::new([0.02 * side, 0.0], [-side, 0.0]).series_stiffness(1e4, 8e3).friction(0.5);
        Finger::new([motor.limit(Limit::Slips(0.4))]).contact(tip)
    };
    let grasp = Hand::new([finger(-1.0, "left motor"), finger(1.0, "right motor")]).grasp()?;
    let cycle = [4.0, -4.0].map(|push| Leg::there_and_back(Wrench::force([push, 0.0]))).concat();
    let shaken = grasp.shake(Wrench::ZERO, &cycle)?;
    let names: Vec<_> = shaken.yields.iter().map(PartLabel::text).collect();
    assert!(shaken.rests() == Some(true) && names == ["right motor"], "{shaken}");
    assert!(
        shaken.to_string().starts_with("RESTS after a cycle: until then right motor yields; "),
        "{shaken}"
    );
    // Motors with the limit `Saturates` hold their largest torque and do not slip. Once the push is gone, the springs of both motors carry their
    // torques again.
    let stalling = |side: f64, name: &str| {
        let motor = Joint::revolute([0.02 * side, 0.06]).name(name).stiffness(3.5).command(-0.09 * side);
        let tip = Contact::new([0.02 * side, 0.0], [-side, 0.0]).series_stiffness(1e4, 8e3).friction(0.5);
        Finger::new([motor.limit(Limit::Saturates(0.5))]).contact(tip)
    };
    let grasp = Hand::new([stalling(-1.0, "left motor"), stalling(1.0, "right motor")]).grasp()?;
    let says = |push: f64| -> Result<String, Error> {
        Ok(grasp.shake(Wrench::ZERO, &Leg::there_and_back(Wrench::force([push, 0.0])))?.to_string())
    };
    // Both motors have a torque of 0.287 N m. A push changes each torque by less than 0.03 m times the push, so that 7.1 N are needed for 0.5 N m.
    assert_eq!(says(7.0)?, "RESTS: nothing slides as the load repeats");
    assert_eq!(says(8.0)?, "RESTS: no contact slides as the load repeats, but right motor yields");
    Ok(())
}
