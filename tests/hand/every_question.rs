//! Every question about a hand is answered or refused with a typed error. None panics.

use grasp_lcp::energy::MinimumOutcome;
use grasp_lcp::load_path::Parameter;
use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use grasp_lcp::planar::{Grasp, Leg, Ramp, Turn, Wrench};
use grasp_lcp::squeeze::Loads;
use grasp_lcp::sweep::Uncertainty;
use grasp_lcp::{Error, Limit, PolygonCone};

fn hand(limit: Option<Limit>) -> Grasp {
    let finger = |x: f64| {
        let joint = |p: [f64; 2]| {
            let joint = Joint::revolute(p).stiffness(30.0);
            if let Some(limit) = limit { joint.limit(limit) } else { joint }
        };
        let pad =
            Contact::new([x, 0.0], [-x, 0.1]).series_stiffness(2e3, 1.5e3).friction(0.6).pressed_with(3.0);
        Finger::new([joint([1.3 * x, -1.0]), joint([1.2 * x, 0.4])]).contact(pad)
    };
    let coupled = finger(1.0).coupled(DMatrix::from_row_slice(2, 2, &[9.0, 3.0, 3.0, 1.0]));
    let tendon = Tendon::new([0.0, 0.0, 0.02, 0.02]).stiffness(500.0).pull(1e-3);
    Hand::new([finger(-1.0), coupled]).tendon(tendon).grasp().expect("well posed")
}

#[test]
fn nothing_panics_and_what_agrees_agrees() {
    for limit in [None, Some(Limit::Saturates(50.0)), Some(Limit::Slips(50.0))] {
        let grasp = hand(limit);
        let load = Wrench::new([0.3, -0.5], 0.05);
        let outcome = grasp.solve(load).expect("a load");
        let held = outcome.equilibrium().expect("holds");
        assert!(held.residuals.worst() < 1e-14, "{:?}", held.residuals);
        let ramp = Ramp::load(Wrench::ZERO, load);

        // While everything sticks, the paper's minimum of energy is the equilibrium, including joints.
        let MinimumOutcome::Minimum(minimum) = grasp.energy().minimum(load).expect("a load") else {
            panic!()
        };
        for (a, b) in minimum.contacts.iter().zip(&held.contacts) {
            assert!((a.force - b.force).norm() < 1e-12);
        }
        assert!(
            (minimum.stored_energy - held.stored_energy).abs() < 1e-12 * held.stored_energy,
            "{} {}",
            minimum.stored_energy,
            held.stored_energy
        );
        grasp.energy().compare(load).expect("a load");
        grasp.energy().agreement(&ramp).expect("a ramp");
        let refused = |error: Option<Error>| {
            assert!(matches!(error, None | Some(Error::NotForHands { .. })), "{error:?}");
        };

        let split = grasp.statics().decompose(held);
        let sum = |forces: &[grasp_lcp::nalgebra::Vector2<f64>]| {
            forces.iter().sum::<grasp_lcp::nalgebra::Vector2<f64>>()
        };
        assert!((sum(&split.equilibrating) + grasp_lcp::nalgebra::Vector2::new(0.3, -0.5)).norm() < 1e-13);
        assert!(sum(&split.interaction).norm() < 1e-13);
        let accuracy = grasp.accuracy(held).expect("its own");
        assert!(accuracy.force < 1e-13);
        assert_eq!(grasp.distinct(held).expect("its own").len(), 2);
        assert!(grasp.equilibria(load).expect("few").len() == 1);
        grasp.refutation(load).expect("a load");
        grasp.kinematic_form(load, &PolygonCone::default()).expect("a load");
        grasp.force_form(load, &PolygonCone::default()).expect("a load");
        let onset = grasp.onset(&ramp).expect("a ramp");
        let event = onset.event().expect("slides");
        assert!(grasp.state_at_onset(event).expect("its own").residuals.worst() < 1e-13);
        grasp.beyond(event).expect("its own");
        assert!(grasp.sensitivity().onset(event).is_some());
        // A turning load whose wrench stays on a line has its first slip at the same load as a ramp along this line.
        let straight = grasp.onset(load).expect("loads").factor().expect("sticks");
        let most = 1.5 * straight;
        let turn = Turn::new(load * most, load * -most, Wrench::ZERO);
        let angle = grasp.onset_of_turn(turn).expect("a turn").onset.factor().expect("sticks");
        assert!((angle - (1.0_f64 / 3.0).acos()).abs() < 1e-12, "{angle}");
        refused(grasp.least_squeeze(&Loads::Each(vec![load])).err());
        assert!(grasp.hold(&ramp).expect("a ramp").holds().is_some());
        let mut path = grasp
            .follow(Wrench::ZERO, &[Leg::load_to(load * 30.0), Leg::load_to(Wrench::ZERO)])
            .expect("loads");
        path.run();
        let _ = path.beyond();
        refused(grasp.follow_in_steps(Wrench::ZERO, &[], 1e-4).err());
        let by_joint = grasp.sensitivity().of(held, Parameter::JointCommand { joint: 0 }).expect("regular");
        assert_eq!(by_joint.forces.len(), 2);
        let uncertainty = Uncertainty::seeded(3).with_friction(0.1).with_stiffness(0.2).with_squeeze(0.1);
        for outcome in grasp.onset_of_samples(&ramp, &uncertainty, 5) {
            outcome.expect("a sample");
        }
        let onset = grasp.onset(&ramp).expect("a ramp").factor().expect("slides");
        let reserve = grasp.reserve(Wrench::ZERO, &uncertainty, 0.5).expect("a base load");
        assert!(reserve.along(&load) < onset);
    }
}
