//! The stiffness that stability reports is the tangent stiffness of the equilibrium: `elastic · (change of twist) = change of load`.

use grasp_lcp::nalgebra::{DMatrix, SVector};
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use grasp_lcp::planar::{Grasp, Wrench};
use grasp_lcp::{Limit, planar};

/// Two fingers of two joints with gears and a tendon, below all limits.
fn hand() -> Result<Grasp, grasp_lcp::Error> {
    let finger = |x: f64| {
        let joint = |p| Joint::revolute(p).stiffness(30.0).limit(Limit::Saturates(50.0));
        let pad =
            Contact::new([x, 0.0], [-x, 0.1]).series_stiffness(2e3, 1.5e3).friction(0.9).pressed_with(6.0);
        Finger::new([joint([1.3 * x, -1.0]), joint([1.2 * x, 0.4])]).contact(pad)
    };
    let coupled = finger(1.0).coupled(DMatrix::from_row_slice(2, 2, &[9.0, 3.0, 3.0, 1.0]));
    let tendon = Tendon::new([0.0, 0.0, 0.02, 0.02]).stiffness(500.0).pull(1e-3);
    Hand::new([finger(-1.0), coupled]).tendon(tendon).grasp()
}

/// The twist of the object and the displacements of the joints.
fn coordinates(state: &planar::Equilibrium) -> SVector<f64, 7> {
    let joints = state.joints.iter().map(|joint| joint.displacement);
    SVector::from_iterator(state.twist.components().iter().copied().chain(joints))
}

#[test]
fn the_elastic_stiffness_is_the_one_that_loads_feel() -> Result<(), Box<dyn std::error::Error>> {
    let grasp = hand()?;
    let at = |load: &SVector<f64, 7>| -> Result<_, Box<dyn std::error::Error>> {
        let outcome = grasp
            .with_joint_torques(&load.as_slice()[3..])?
            .solve(Wrench::from_components(load.as_slice()))?;
        let planar::Outcome::Equilibrium(held) = outcome else { return Err("holds".into()) };
        if held.contacts.iter().any(|c| c.state != planar::ContactState::Sticking) {
            return Err("sticks".into());
        }
        Ok(held)
    };
    let rest = at(&SVector::zeros())?;
    let elastic = grasp.energy().stability(&rest).elastic;
    for k in 0..7 {
        // The change has joint torques as well as a force and a moment on the object.
        let change = SVector::from_fn(|i, _| if i == k { 0.1 } else { 0.0 });
        let moved = coordinates(&*at(&change)?) - coordinates(&rest);
        let felt = &elastic * moved;
        for i in 0..7 {
            assert!((felt[i] - change[i]).abs() < 1e-11, "{k} {i}: {} {}", felt[i], change[i]);
        }
    }
    Ok(())
}
