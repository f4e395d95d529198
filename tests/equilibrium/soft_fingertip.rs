//! Stiffness and edges of soft fingertips agree with closed forms, in space and in the plane.
//!
//! The numbers are integrals over a ring, a disc or a line, computed by hand in the comments.

use std::f64::consts::TAU;

use crate::pinch::{KN, KT, MU, N, R, finger, pinch, spin, tips};
use grasp_lcp::planar;
use grasp_lcp::spatial::{Contact, ContactState, Departure, Grasp, Pressure, Ramp, Wrench};
use nalgebra::Vector3;
use support::assert_relatively_close;

/// The points lie in the tangent plane around the contact, have its frame and its other data, and their springs add up to
/// its springs. A rigid side stays rigid.
#[test]
fn the_points_share_one_contact() {
    let parent = Contact::new([0.1, -0.2, 0.3], [1.0, 2.0, -0.5])
        .name("thumb")
        .tangent([0.3, -1.0, 0.2])
        .body_stiffness(f64::INFINITY, 3e4)
        .finger_stiffness_axes([KN, KT, 0.4 * KT])
        .friction(MU)
        .command([1e-3, 2e-4, -1e-4])
        .clearance(1e-4)
        .kept_closed();
    let alone = Grasp::new([parent.clone()]).unwrap();
    let frame = *alone.frames().next().unwrap();
    for (tip, ..) in tips() {
        let patch = Grasp::new(tip.contacts(&parent).unwrap()).unwrap();
        let mut stiffness = Vector3::zeros();
        let mut centre = Vector3::zeros();
        for (i, ((contact, axes), (at, share))) in
            patch.contacts().iter().zip(patch.frames()).zip(tip.points()).enumerate()
        {
            assert!((axes - frame).amax() < 1e-15, "the same frame");
            assert_eq!(contact.label_text(0), format!("thumb {i}"));
            assert_eq!((contact.friction_coefficient(), contact.commanded()), (MU, parent.commanded()));
            assert!((frame.tr_mul(&(contact.point() - parent.point())) - at).amax() < 1e-16);
            assert!(at[0] == 0.0 && share > 0.0 && at.norm() <= R * (1.0 + 1e-15));
            stiffness += contact.series_stiffness_of_axes();
            centre += share * at;
            let text = format!("{contact:?}");
            assert!(
                text.contains("KeptClosed") && text.contains("clearance: 0.0001") && text.contains("inf")
            );
        }
        assert!(
            (stiffness.component_div(&parent.series_stiffness_of_axes()) - Vector3::repeat(1.0)).amax()
                < 1e-13
        );
        assert!(centre.norm() < 1e-15 * R);
    }
}

#[test]
fn numbers_are_those_of_the_continuum() {
    for (tip, mean, square) in tips() {
        let finger = finger(1.0);
        assert_eq!(tip.radius(), R);
        assert_relatively_close!(tip.torsional_stiffness(&finger), KT * square * R * R);
        assert_relatively_close!(tip.torsional_limit(&finger, N), MU * N * mean * R);
        assert_relatively_close!(tip.first_sliding(&finger, N), MU * N * square * R);
        assert_relatively_close!(tip.tilting_stiffness(&finger), KN * square * R * R / 2.0);
        assert_relatively_close!(tip.first_opening(N), N * square * R / 2.0);
        let uneven = finger.series_stiffness_axes([KN, KT, 0.3 * KT]);
        assert_relatively_close!(tip.torsional_stiffness(&uneven), 0.65 * KT * square * R * R);
    }
}

/// A single tip under a body that presses with N. A moment M about a tangent tilts the body by M/k_tilt, until the farthest point on one side of the
/// tip opens. The force is then at the edge of the core of the tip, M = N ⟨r²⟩/2R; for the uniform disc this is the R/4 of the middle-quarter rule.
#[test]
fn a_tip_tilts_until_it_opens() {
    for (tip, _, square) in tips() {
        let table = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
            .tangent([1.0, 0.0, 0.0])
            .series_stiffness(KN, KT)
            .friction(MU);
        let grasp = Grasp::new(tip.contacts(&table).unwrap()).unwrap();
        let press = Wrench::force([0.0, 0.0, -N]);
        // A negative rotation about y lifts the body at x > 0, and the rim has a point on the +x axis.
        let tilt = Wrench::new([0.0; 3], [0.0, -1.0, 0.0]);
        let onset = grasp.onset(Ramp::load(press, tilt)).unwrap();
        let event = onset.event().expect("it opens");
        assert_relatively_close!(event.factor, N * square * R / 2.0);
        assert!(event.leaving.iter().any(|l| l.how == Departure::Opens), "{:?}", event.leaving);
        let state = grasp.solve(press + tilt * (0.5 * event.factor)).unwrap();
        let state = state.equilibrium().expect("pressed all over");
        assert_relatively_close!(
            state.twist.rotation()[1],
            -0.5 * event.factor / tip.tilting_stiffness(&table)
        );
        assert_relatively_close!(tip.first_opening(N), event.factor);
    }
}

/// In the plane, a pad of width w = 2b: ⟨x²⟩ = b² for two points, else `∫ ρ² p / ∫ p` = 1/3, (2/15)/(2/3) and (π/16)/(π/4) of b². It turns by M/(k_n
/// ⟨x²⟩) and opens at N ⟨x²⟩/b. For uniform pressure this is N w/6, the middle-third rule. A pad of two points opens when one point carries all
/// the force.
#[test]
fn planar_pads() {
    use planar::{Departure, Grasp, SoftFingertip, Wrench};
    let (width, half) = (0.012, 0.006);
    let pad = |strips, pressure| SoftFingertip::pad(width, strips, pressure).unwrap();
    let mut pads = vec![(SoftFingertip::pair(width).unwrap(), 1.0)];
    for strips in [1, 2, 7] {
        pads.push((pad(strips, Pressure::Uniform), 1.0 / 3.0));
        pads.push((pad(strips, Pressure::Parabolic), 0.2));
        pads.push((pad(strips, Pressure::Hertz), 0.25));
    }
    for (tip, square) in pads {
        let one =
            planar::Contact::new([0.2, 0.1], [-0.6, 0.8]).name("pad").series_stiffness(KN, KT).friction(MU);
        let grasp = Grasp::new(tip.contacts(&one).unwrap()).unwrap();
        assert_relatively_close!(
            grasp.contacts().iter().map(|c| c.series_stiffness_of_axes()[1]).sum::<f64>(),
            KT
        );
        assert_relatively_close!(tip.tilting_stiffness(&one), KN * square * half * half);
        assert_relatively_close!(tip.first_opening(N), N * square * half);
        let press = Wrench::force_at([0.6 * N, -0.8 * N], [0.2, 0.1]);
        for side in [-1.0, 1.0] {
            let onset = grasp.onset(planar::Ramp::load(press, Wrench::new([0.0; 2], side))).unwrap();
            let event = onset.event().expect("it opens");
            assert_relatively_close!(event.factor, N * square * half);
            let [leaving] = &event.leaving[..] else { panic!("{:?}", event.leaving) };
            assert_eq!(leaving.how, Departure::Opens);
            assert!(leaving.contact.index == 0 || leaving.contact.index == grasp.len() - 1);
            let state = grasp.solve(press + Wrench::new([0.0; 2], 0.5 * side * event.factor)).unwrap();
            let state = state.equilibrium().expect("pressed all over");
            assert_relatively_close!(
                state.twist.rotation(),
                0.5 * side * event.factor / tip.tilting_stiffness(&one)
            );
        }
    }
}

/// The tangent determines the first point of a ring. While everything sticks, and under torsion, it has no effect.
#[test]
fn the_choice_of_tangents_changes_nothing() {
    for (tip, _, square) in tips() {
        let with_tangent =
            |angle: f64| pinch(&tip, |side| finger(side).tangent([0.0, angle.cos(), angle.sin()]));
        let load = Wrench::new([0.4, -0.3, 0.5], [0.3 * MU * N * square * R, 0.002, -0.004]);
        let twist = |grasp: &Grasp| {
            let outcome = grasp.solve(load).unwrap();
            let state = outcome.equilibrium().expect("within friction").clone();
            assert!(state.contacts.iter().all(|c| c.state == ContactState::Sticking));
            state.twist.to_vector()
        };
        let grasp = with_tangent(0.0);
        let first = twist(&grasp);
        for step in 1..10 {
            let other = with_tangent(TAU * f64::from(step) / 10.0 + 0.1);
            assert!((twist(&other) - first).amax() < 1e-12 * first.amax());
            let onset = other.onset(spin(1.0)).unwrap();
            assert_relatively_close!(onset.factor().expect("a sticking base"), 2.0 * MU * N * square * R);
        }
    }
}
