//! A squeeze in newtons is the normal force while the object does not move, for every kind of finger behind the contact.

use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Wrench;
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::planar::{Contact, Grasp};
use support::jaws::jaw;

fn pad(x: f64) -> Contact {
    Contact::new([x, 0.0], [-x, 0.25]).series_stiffness(3e3, 2e3).friction(0.5).pressed_with(8.0)
}

/// A bonded contact far stiffer than the fingers, which keeps the object in place.
fn still() -> Contact {
    Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e15, 1e15).bonded()
}

#[test]
fn every_kind_of_finger_presses_as_it_is_told() {
    let joints = |x: f64| {
        [[2.0, -1.0], [1.5, 0.5]].map(|[px, py]| Joint::revolute([x * px, py]).stiffness(900.0 + 100.0 * px))
    };
    let stiffness = DMatrix::from_row_slice(2, 2, &[500.0, 200.0, 200.0, 300.0]);
    let compliance = DMatrix::from_row_slice(2, 2, &[2e-3, -5e-4, -5e-4, 1e-3]);
    let fingers = [
        Finger::fixed(pad(-1.0).clearance(0.003)),
        Finger::new(joints(1.0)).contact(pad(1.0)),
        Finger::new(joints(-1.0)).coupled(stiffness).contact(pad(-1.0)).contact_on(1, pad(-0.5)),
        Finger::compliant([pad(1.0), pad(0.5)], DMatrix::identity(4, 4) * 1e-3),
        Finger::compliant([pad(1.0)], compliance),
    ];
    let supports = [[-0.5, 0.0], [0.5, 0.0]]
        .map(|p| Finger::fixed(Contact::new(p, [0.0, 1.0]).series_stiffness(1e15, 1e15).bonded()));
    let grasp =
        Hand::new(fingers.into_iter().chain(supports).chain([Finger::fixed(still())])).grasp().unwrap();
    let outcome = grasp.solve(Wrench::ZERO).unwrap();
    let held = outcome.equilibrium().expect("holds");
    for (i, contact) in held.contacts.iter().take(7).enumerate() {
        assert!((contact.normal_force() - 8.0).abs() < 1e-9, "{i}: {}", contact.normal_force());
        assert!(contact.friction_force() < 1e-9, "{i}: {}", contact.friction_force());
    }
}

#[test]
fn a_soft_fingertip_presses_as_its_contact() {
    let tip =
        grasp_lcp::grasp::SoftFingertip::<2>::pad(0.2, 5, grasp_lcp::planar::Pressure::Uniform).unwrap();
    let contact = |x: f64| jaw::<2>(x, [3e3, 2e3], 0.5).pressed_with(8.0);
    let points: Vec<_> = [-1.0, 1.0].iter().flat_map(|x| tip.contacts(&contact(*x)).unwrap()).collect();
    let half = points.len() / 2;
    let outcome = Grasp::new(points).unwrap().solve(grasp_lcp::planar::Wrench::ZERO).unwrap();
    let held = outcome.equilibrium().unwrap();
    let sum: f64 = held.contacts.iter().take(half).map(grasp_lcp::planar::ContactAnswer::normal_force).sum();
    assert!((sum - 8.0).abs() < 1e-13, "{sum}");
}
