//! At a pull of 7.5 N, two feet carry 5 and 2.5 N. One of them slips, and then they carry 4 and 3.5 N. The result is the same for compliant fingers
//! of a hand and for feet between two bodies.

use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::hand::{Finger, Hand};
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp, Leg, Link, PathEnd, Wrench};

fn foot(x: f64) -> Contact {
    Contact::new([x, 0.0], [0.0, 1.0]).friction(0.5).kinetic(0.4)
}

fn rail(x: f64) -> Contact {
    Contact::new([x, 0.1], [0.0, -1.0]).series_stiffness(1000.0, 1.0).pressed_with(10.0)
}

fn jumps(grasp: &Grasp, close: f64) {
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([12.0, 0.0]))]).unwrap();
    let events = path.run();
    let event = events.iter().find(|event| event.jump.is_some()).unwrap();
    assert!((12.0 * event.fraction - 7.5).abs() < close, "{}", event.fraction);
    let carried = |i: usize| event.jump.as_ref().unwrap().state.contacts[i].force[1].abs();
    assert!(
        (carried(0) - 4.0).abs() < close && (carried(1) - 3.5).abs() < close,
        "{} {}",
        carried(0),
        carried(1)
    );
    assert!(matches!(path.end(), Some(PathEnd::Lost(_))) && (12.0 * path.place().1 - 9.0).abs() < close);
    let residual = path.energies()[0].residual();
    assert!(residual.abs() < 1e-12, "{residual:e}");
}

#[test]
fn as_compliant_fingers_of_a_hand() {
    let finger = |x: f64, k: f64| {
        let compliance = DMatrix::from_row_slice(2, 2, &[1e-3, 0.0, 0.0, 1.0 / k]);
        Finger::compliant([foot(x).command([0.01, 0.0])], compliance)
    };
    let fixed = [rail(-0.1), rail(0.1)].map(Finger::fixed);
    let grasp =
        Hand::new([finger(-0.1, 1000.0), finger(0.1, 500.0)].into_iter().chain(fixed)).grasp().unwrap();
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([8.0, 0.0]))]).unwrap();
    let events = path.run();
    let jump = events[0].jump.as_deref().unwrap();
    assert!((8.0 * events[0].fraction - 7.5).abs() < 1e-11);
    for (i, after) in [(0, 4.0), (1, 3.5)] {
        assert!((jump.state.contacts[i].force[1].abs() - after).abs() < 1e-11);
    }
    assert!(matches!(path.end(), Some(PathEnd::Completed)));
}

/// The plate below the feet is held with a compliance of 1e-9 m/N, so that forces differ slightly.
#[test]
fn as_feet_between_two_bodies() {
    let between =
        |x: f64, k: f64| foot(x).series_stiffness(1000.0, k).pressed_with(10.0).on("box").against("plate");
    let grasp = Bodies::new([Body::new("box"), Body::new("plate")])
        .contacts([between(-0.1, 1000.0), between(0.1, 500.0), rail(-0.1).on("box"), rail(0.1).on("box")])
        .links([Link::rigid([0.0, -0.1], 0.1).to_ground("plate")])
        .grasp()
        .unwrap();
    jumps(&grasp, 1e-4);
}
