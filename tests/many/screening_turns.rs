//! Screening of loads that turn agrees with `Grasp::onset_of_turn`, which solves again at every event, and with closed forms.
//!
//! Scenes have two to five contacts of every kind, in the plane and in space, with ordinary and extreme stiffnesses and friction, for full and
//! partial turns. If screening gives an angle, it is that of the onset. If it gives none, the onset states why. Every lane of a batch gives the
//! answer of the single grasp to the last bit.

use std::cell::RefCell;
use std::f64::consts::{FRAC_PI_2, TAU};

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Onset, Turn};
use grasp_lcp::screening::{Batch, Fingers, ScreenedTurn, ScreeningVerdict, TurningPull};
use grasp_lcp::sweep::turn_onsets_of_batch;
use grasp_lcp::{planar, spatial};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{Spread, datum, for_all};

use crate::screened_scenes::{Tally, agrees, contacts, count, firmer, of, shaken};
use support::facts;
use support::jaws::jaw;
use support::samples::assert_met;

/// Checks screening against the onset. `contacts` gives the scene with relative changes of its data of the given size.
fn check<const C: usize, const N: usize>(
    contacts: impl Fn(f64) -> [Contact<C>; N],
    turn: &Turn<C>,
    close: f64,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let pull = TurningPull::new(turn).unwrap();
    let screened = Fingers::<C, N>::new(&contacts(0.0)).unwrap().onset_of_turn(&pull);
    let grasp = Grasp::new(contacts(0.0)).unwrap();
    let whole = grasp.onset_of_turn(turn).unwrap();
    let shaken = |part: f64| {
        let onset = Grasp::new(contacts(part)).unwrap().onset_of_turn(turn).unwrap().onset;
        onset.factor().unwrap_or(f64::INFINITY)
    };
    count(tally, &format!("{:?}", screened.verdict()));
    match (screened.verdict(), &whole.onset) {
        (ScreeningVerdict::Leaves, Onset::At(event)) => {
            let angle = screened.angle().unwrap();
            count(tally, if angle > FRAC_PI_2 { "late" } else { "early" });
            prop_assert!(agrees([angle, event.factor], close, shaken, tally), "{angle} {}", event.factor);
            prop_assert!(screened.holds_up_to(0.999 * angle) && !screened.holds_up_to(1.001 * angle));
            for leaving in &event.leaving {
                prop_assert!(
                    screened.leaving().any(|i| i == leaving.contact.index),
                    "{leaving:?} {screened:?}"
                );
            }
        }
        (ScreeningVerdict::Never, Onset::Never) => {
            prop_assert!(screened.holds_up_to(turn.angle()));
            prop_assert_eq!(screened.holds_up_to(7.0), turn.angle() >= TAU);
        }
        (
            ScreeningVerdict::GivesWay,
            Onset::GivesWay { .. } | Onset::NoBase(_) | Onset::AlreadySliding(_),
        )
        | (ScreeningVerdict::NotSticking, Onset::AlreadySliding(_) | Onset::NoBase(_))
        | (ScreeningVerdict::NotSticking | ScreeningVerdict::Unclear, Onset::Undecided(_)) => {}
        // A contact that is open at the beginning may close during the turn.
        (ScreeningVerdict::NotSticking, onset) => {
            let state = grasp.solve(turn.load_at(0.0)).unwrap();
            let open = state
                .equilibrium()
                .is_some_and(|e| e.contacts.iter().any(|contact| contact.state == ContactState::Separated));
            prop_assert!(open, "{onset:?}");
        }
        (ScreeningVerdict::Unclear, _) => prop_assert_eq!(screened.angle(), None),
        (verdict, onset) => prop_assert!(false, "{verdict:?} {onset:?}"),
    }
    Ok(())
}

fn random<const D: usize, const C: usize, const N: usize>(cases: usize, spread: Spread, tally: &Tally) {
    let wrench = || prop::collection::vec(-1.0..1.0_f64, D).prop_map(SVector::<f64, D>::from_vec);
    let question = (
        prop::collection::vec(datum::<C>(spread), N),
        prop::collection::vec(0..12_u8, N),
        [wrench(), wrench(), wrench()],
        // The part of the load that turns, and the angle.
        (0.02..1.0_f64, prop_oneof![Just(TAU), 0.1..7.0_f64]),
    );
    let close = if spread == Spread::Narrow { 1e-12 } else { 1e-8 };
    for_all(file!(), cases, &question, |(data, holds, [constant, cosine, sine], (part, most))| {
        let [constant, cosine, sine] = [constant * part, cosine * (part * part), sine * part]
            .map(|w| Wrench::from_components(w.as_slice()));
        let turn = Turn::new(constant, cosine, sine).up_to(most);
        let data = firmer(data);
        check::<C, N>(|part| contacts(&shaken(&data, part), &holds), &turn, close, tally)
    });
}

#[test]
fn agrees_in_the_plane() {
    let tally = Tally::default();
    random::<3, 2, 2>(600, Spread::Narrow, &tally);
    random::<3, 2, 3>(300, Spread::Narrow, &tally);
    random::<3, 2, 4>(140, Spread::Narrow, &tally);
    random::<3, 2, 5>(140, Spread::Narrow, &tally);
    println!("{:?}", tally.borrow());
    assert_met(&[(of(&tally, "Leaves"), 100), (of(&tally, "Never"), 60), (of(&tally, "late"), 25)]);
    assert!(100 * of(&tally, "Unclear") < of(&tally, "Leaves") + of(&tally, "Never"), "{tally:?}");
    assert!(20 * of(&tally, "as the question") < of(&tally, "close"), "{tally:?}");
}

#[test]
fn agrees_in_space() {
    let tally = Tally::default();
    random::<6, 3, 2>(20, Spread::Narrow, &tally);
    random::<6, 3, 3>(300, Spread::Narrow, &tally);
    random::<6, 3, 4>(200, Spread::Narrow, &tally);
    random::<6, 3, 5>(140, Spread::Narrow, &tally);
    println!("{:?}", tally.borrow());
    assert_met(&[(of(&tally, "Leaves"), 60), (of(&tally, "Never"), 20), (of(&tally, "late"), 10)]);
    assert_met(&[(of(&tally, "GivesWay"), 4)]);
    assert!(100 * of(&tally, "Unclear") < of(&tally, "Leaves") + of(&tally, "Never"), "{tally:?}");
    assert!(20 * of(&tally, "as the question") < of(&tally, "close"), "{tally:?}");
}

/// Stiffness from 1 to 1e6, friction zero, tiny, huge and infinite.
#[test]
fn agrees_on_wide_ranges() {
    let tally = Tally::default();
    random::<3, 2, 2>(300, Spread::Wide, &tally);
    random::<3, 2, 3>(200, Spread::Wide, &tally);
    random::<6, 3, 3>(60, Spread::Wide, &tally);
    random::<6, 3, 5>(20, Spread::Wide, &tally);
    println!("{:?}", tally.borrow());
    assert_met(&[(of(&tally, "Leaves"), 20)]);
    assert!(2 * of(&tally, "Unclear") < of(&tally, "Leaves") + of(&tally, "Never"), "{tally:?}");
}

/// Palms with stiffness ratios of up to 1e21 and a weight w that begins upright. The palm above carries `F_n = p - (w/2) sin θ` and
/// `F_t = (w/2) cos θ`: it slides where `cos θ + μ sin θ = 2 μ p / w`.
#[test]
fn palms_of_any_stiffness() {
    for (k, kt) in [(1e3, 8e2), (1e12, 1.0), (1e-6, 1e9), (1e9, 1e-12)] {
        for w in [0.9, 1.9, 1.99] {
            let (mu, press) = (0.5, 2.0);
            let palm = |x: f64| jaw::<2>(x, [k, kt], mu).command([press / k, 0.0]);
            let palms = planar::Fingers::new(&[palm(-1.0), palm(1.0)]).unwrap();
            let turn = planar::Turn::tilting([0.0, -w], [0.0, 0.0]);
            let onset = palms.onset_of_turn(&TurningPull::new(&turn).unwrap());
            // The left-hand side is at most √(1 + μ²).
            let level = 2.0 * mu * press / w;
            if level > (1.0 + mu * mu).sqrt() {
                assert_eq!(onset.verdict(), ScreeningVerdict::Never);
                continue;
            }
            let closed = mu.atan() - (level / (1.0 + mu * mu).sqrt()).acos();
            assert!(
                (onset.angle().unwrap() / closed - 1.0).abs() < 1e-12,
                "{k} {kt} {w}: {onset:?} {closed}"
            );
            // For the reversed turn the other palm slides at the same angle.
            let back = palms.onset_of_turn(&TurningPull::new(&turn.reversed()).unwrap());
            assert!((back.angle().unwrap() / closed - 1.0).abs() < 1e-12, "{back:?}");
            assert!(back.leaving().ne(onset.leaving()) && onset.leaving().count() == 1);
        }
    }
}

/// A pinch across which a load turns in space: palms along x, a force of size w about y at the middle, `F_t = (w/2) sin θ` along z and
/// `F_n = p ∓ (w/2) cos θ`. If the force just reaches the edge of a cone, the result is unclear.
#[test]
fn a_force_that_turns_in_space_touches_an_edge() {
    let (mu, press) = (0.75_f64, 1.0);
    let finger = |x: f64, y: f64| {
        spatial::Contact::new([x, y, 0.0], [-x, 0.0, 0.0]).series_stiffness(1e3, 1e3).friction(mu).command([
            press / 1e3,
            0.0,
            0.0,
        ])
    };
    let fingers = [finger(-1.0, 0.5), finger(-1.0, -0.5), finger(1.0, 0.5), finger(1.0, -0.5)];
    let fingers = spatial::Fingers::new(&fingers).unwrap();
    // |sin θ| + μ |cos θ| reaches √(1 + μ²); w/4 at each finger.
    let touching = 4.0 * mu * press / (1.0 + mu * mu).sqrt();
    let screened = |part: f64| {
        let w = part * touching;
        let turn = spatial::Turn::new(
            Wrench::ZERO,
            spatial::Wrench::force([w, 0.0, 0.0]),
            spatial::Wrench::force([0.0, 0.0, w]),
        );
        fingers.onset_of_turn(&TurningPull::new(&turn).unwrap())
    };
    assert_eq!(screened(0.999).verdict(), ScreeningVerdict::Never);
    assert_eq!(screened(1.0 - 1e-11).verdict(), ScreeningVerdict::Never);
    assert_eq!(screened(1.0).verdict(), ScreeningVerdict::Unclear);
    for over in [1e-9, 1e-6, 1e-3, 0.1] {
        let onset = screened(1.0 + over);
        // The fingers at -x are pressed more while cos θ > 0... and those at +x less.
        let closed = (1.0 / (1.0 + over)).acos();
        let closed = (1.0 / mu).atan() - closed;
        let angle = onset.angle().unwrap();
        // A nearly double root has only half of the digits.
        assert!((angle - closed).abs() < 1e-14 / over.sqrt(), "{over}: {angle} {closed}");
        assert!(onset.leaving().count() == 2, "{onset:?}");
    }
}

/// Turns that end before, at and beyond the onset.
#[test]
fn parts_of_a_turn() {
    let palm = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(10.0);
    let palms = planar::Fingers::new(&[palm(-1.0), palm(1.0)]).unwrap();
    let turn = planar::Turn::tilting([12.0, 0.0], [0.0, 0.0]).reversed();
    let screened = |most: f64| palms.onset_of_turn(&TurningPull::new(&turn.up_to(most)).unwrap());
    let closed = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    for most in [0.9 * closed, closed - 1e-9] {
        assert_eq!(screened(most).verdict(), ScreeningVerdict::Never);
        assert!(screened(most).holds_up_to(most) && !screened(most).holds_up_to(closed));
    }
    assert_eq!(screened(closed).verdict(), ScreeningVerdict::Unclear);
    for most in [closed + 1e-9, 1.0, TAU, 1e6] {
        assert!((screened(most).angle().unwrap() - closed).abs() < 1e-14);
    }
}

/// Every lane of a batch, also in a last block that is not full, gives the bits of the single grasp, for any number of threads.
#[test]
fn a_batch_gives_the_same_bits() {
    fn bits(screened: &ScreenedTurn) -> (Option<u64>, ScreeningVerdict, Vec<usize>) {
        (screened.angle().map(f64::to_bits), screened.verdict(), screened.leaving().collect())
    }
    fn grasps<const D: usize, const C: usize, const N: usize>(spread: Spread) {
        let load = |times: f64, shift: usize| {
            let of = SVector::<f64, D>::from_fn(|k, _| [0.3, -1.0, 0.2, 0.1, 0.05, -0.2][(k + shift) % 6]);
            Wrench::from_components((of * times).as_slice())
        };
        let turn = Turn::new(load(0.003, 0), load(0.003, 1), load(1.5, 2));
        let [turn, other] = [turn, turn.reversed().up_to(1.0)].map(|turn| TurningPull::new(&turn).unwrap());
        let alone = RefCell::new(Vec::new());
        let batch = RefCell::new(Batch::<C, N>::default());
        for_all(file!(), 331, &prop::collection::vec(datum::<C>(spread), N), |data| {
            let fingers = Fingers::new(&contacts(&firmer(data), &[9; N])).unwrap();
            alone.borrow_mut().push(fingers.onset_of_turn(&turn));
            batch.borrow_mut().push(&fingers);
            Ok(())
        });
        let batch = batch.into_inner();
        let alone: Vec<_> = alone.borrow().iter().map(bits).collect();
        let (mut together, mut of_both, mut in_parallel) = (vec![], vec![], vec![]);
        batch.turn_onsets_into(&[turn], &mut together);
        batch.turn_onsets_into(&[other, turn], &mut of_both);
        turn_onsets_of_batch(&batch, &[turn], &mut in_parallel);
        assert_eq!(together.iter().map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(in_parallel.iter().map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(of_both.iter().skip(1).step_by(2).map(bits).collect::<Vec<_>>(), alone);
        assert_met(&[(alone.iter().filter(|(angle, ..)| angle.is_some()).count(), 5)]);
    }
    grasps::<3, 2, 2>(Spread::Narrow);
    grasps::<3, 2, 4>(Spread::Narrow);
    grasps::<6, 3, 3>(Spread::Narrow);
    grasps::<6, 3, 5>(Spread::Narrow);
}

/// If squares leave the range of doubles in some units, screening gives no angle; in all other units the angle is the same.
#[test]
fn units() {
    let onset = |exponent: i32| {
        let unit = 2.0_f64.powi(exponent);
        let fingers: [spatial::Contact; 3] = std::array::from_fn(|i| {
            let (sin, cos) = (TAU * i as f64 / 3.0 + 0.1).sin_cos();
            spatial::Contact::new([cos, sin, 0.1 * sin], [-cos, -sin, 0.05])
                .series_stiffness(900.0 * unit, 600.0 * unit)
                .friction(0.6)
                .command([6e-3 * unit, 0.0, 0.0])
        });
        let part = |force: [f64; 3]| spatial::Wrench::force(force.map(|f| f * unit * unit));
        let turn = Turn::new(Wrench::ZERO, part([0.5, 0.0, 0.2]), part([0.0, 1.0, -12.0]));
        spatial::Fingers::new(&fingers).unwrap().onset_of_turn(&TurningPull::new(&turn).unwrap())
    };
    let angle = onset(0).angle().unwrap();
    for exponent in [-100, -30, 30, 70] {
        assert!((onset(exponent).angle().unwrap() / angle - 1.0).abs() < 1e-12, "{exponent}");
    }
    for exponent in [-130, -150] {
        assert_eq!(onset(exponent).verdict(), ScreeningVerdict::Unclear, "{exponent}");
    }
}

#[test]
fn malformed_turns_are_refused() {
    let turn = planar::Turn::new(Wrench::ZERO, planar::Wrench::new([0.0, f64::NAN], 0.0), Wrench::ZERO);
    let bad = TurningPull::new(&turn).unwrap_err();
    let [cosine, component, value] = facts(&bad);
    assert!(cosine.starts_with("cosine") && component == "1" && value == "NaN", "{bad}");
    let bad = TurningPull::new(&planar::Turn::tilting([0.0, -1.0], [0.0, 0.0]).up_to(0.0)).unwrap_err();
    let [_, angle, value] = facts(&bad);
    assert!(angle.starts_with("angle") && value == "0", "{bad}");
}
