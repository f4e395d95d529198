//! Screening (the fast test of many small grasps) finds the factor of first slip as `Grasp::onset` does, which solves the equilibrium at factor zero
//! and walks along the ramp.
//!
//! Scenes have contacts of every kind: with zero, finite and infinite friction, kept closed, bonded, and with a clearance. They are planar and
//! spatial, with and without a base load, with stiffnesses and coefficients of friction over many decades. If screening gives a factor, it is the
//! factor of `Grasp::onset`. If it gives no factor, `Grasp::onset` states why. Every grasp of a batch has the answer of the single grasp to the last
//! bit.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Onset, Ramp};
use grasp_lcp::screening::{Batch, Fingers, Pull, Screened, ScreeningVerdict};
use grasp_lcp::sweep::onsets_of_batch;
use grasp_lcp::{planar, spatial};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{Spread, datum, for_all};

use crate::screened_scenes::{Tally, contacts, count};
use support::facts;
use support::jaws::jaw;
use support::samples::{assert_met, samples};

/// Compares screening with `Grasp::onset`, with a relative tolerance for factors.
fn check<const C: usize, const N: usize>(
    contacts: &[Contact<C>; N],
    [base, direction]: [Wrench<C>; 2],
    close: f64,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let screened = Fingers::<C, N>::new(contacts).unwrap().onset(&Pull::new(&base, &direction).unwrap());
    let grasp = Grasp::new(contacts.iter().cloned()).unwrap();
    let onset = grasp.onset(Ramp::load(base, direction)).unwrap();
    count(tally, &format!("{:?}", screened.verdict()));
    if matches!(onset, Onset::Undecided(_)) {
        count(tally, "whole undecided");
    }
    match (screened.verdict(), &onset) {
        (ScreeningVerdict::Leaves, Onset::At(event)) => {
            let factor = screened.factor().unwrap();
            prop_assert!((factor - event.factor).abs() <= close * event.factor, "{factor} {}", event.factor);
            prop_assert!(screened.holds_up_to(0.999 * factor) && !screened.holds_up_to(1.001 * factor));
            // Screening also names every contact that `Grasp::onset` names. If several contacts reach their limit together, some that it names may
            // still stick.
            for leaving in &event.leaving {
                prop_assert!(
                    screened.leaving().any(|i| i == leaving.contact.index),
                    "{leaving:?} {screened:?}"
                );
            }
        }
        (ScreeningVerdict::Never, Onset::Never) => prop_assert!(screened.holds_up_to(1e300)),
        (ScreeningVerdict::GivesWay, Onset::GivesWay { .. } | Onset::NoBase(_))
        | (ScreeningVerdict::NotSticking, Onset::AlreadySliding(_) | Onset::NoBase(_))
        | (ScreeningVerdict::NotSticking | ScreeningVerdict::Unclear, Onset::Undecided(_)) => {}
        // A contact that is open under the base load may close along the ramp.
        (ScreeningVerdict::NotSticking, onset) => {
            let state = grasp.solve(base).unwrap();
            let open = state
                .equilibrium()
                .is_some_and(|e| e.contacts.iter().any(|contact| contact.state == ContactState::Separated));
            prop_assert!(open, "{onset:?}");
        }
        // Some contact is on the edge of its cone, or numbers are extreme. Callers limit the number of such scenes.
        (ScreeningVerdict::Unclear, _) => prop_assert_eq!(screened.factor(), None),
        (verdict, onset) => prop_assert!(false, "{verdict:?} {onset:?}"),
    }
    Ok(())
}

/// A finger that touches without force has no margin. Nevertheless screening finds that another finger slides.
#[test]
fn a_finger_without_force_does_not_hide_one_that_slides() {
    let finger = |point: [f64; 3], normal: [f64; 3], command: [f64; 3]| {
        Contact::<3>::new(point, normal).series_stiffness(1e3, 1e3).friction(0.5).command_world(command)
    };
    // Two jaws press with 10 N each, and commands drag them with 10 N each along the same tangent. The finger above balances both drags.
    let fingers = [
        finger([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.01, 0.01, 0.0]),
        finger([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [-0.01, 0.01, 0.0]),
        finger([0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, -0.02, 0.0]),
        finger([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0; 3]),
    ];
    let screened = Fingers::<3, 4>::new(&fingers).unwrap();
    let pull = |force: [f64; 3]| Pull::new(&Wrench::ZERO, &spatial::Wrench::force(force)).unwrap();
    let watched = Grasp::new(fingers.clone()).unwrap().solve(spatial::Wrench::ZERO).unwrap();
    assert!(!watched.equilibrium().is_some_and(|rest| rest.contacts[0].state == ContactState::Sticking));
    assert_eq!(screened.onset(&pull([1.0, 0.2, 0.3])).verdict(), ScreeningVerdict::NotSticking);
}

fn random<const D: usize, const C: usize, const N: usize>(cases: usize, spread: Spread, tally: &Tally) {
    let wrench = || prop::collection::vec(-1.0..1.0_f64, D).prop_map(SVector::<f64, D>::from_vec);
    let question = (
        prop::collection::vec(datum::<C>(spread), N),
        prop::collection::vec(0..12_u8, N),
        prop_oneof![Just(SVector::zeros()), wrench()],
        wrench(),
    );
    let close = if spread == Spread::Narrow { 1e-10 } else { 1e-8 };
    for_all(file!(), cases, &question, |(data, holds, base, direction)| {
        check::<C, N>(
            &contacts(&data, &holds),
            [base, direction].map(|w| Wrench::from_components(w.as_slice())),
            close,
            tally,
        )
    });
}

#[test]
fn agrees_in_the_plane() {
    let tally = Tally::default();
    random::<3, 2, 2>(1000, Spread::Narrow, &tally);
    random::<3, 2, 3>(375, Spread::Narrow, &tally);
    random::<3, 2, 4>(125, Spread::Narrow, &tally);
    random::<3, 2, 5>(125, Spread::Narrow, &tally);
    let counts = tally.borrow();
    assert_met(&[(counts["Leaves"], 150), (counts["Never"], 5), (counts["NotSticking"], 250)]);
    assert!(counts.get("Unclear").is_none_or(|&n| n <= samples(2)), "{counts:?}");
}

#[test]
fn agrees_in_space() {
    let tally = Tally::default();
    random::<6, 3, 2>(25, Spread::Narrow, &tally);
    random::<6, 3, 3>(75, Spread::Narrow, &tally);
    random::<6, 3, 4>(50, Spread::Narrow, &tally);
    random::<6, 3, 5>(25, Spread::Narrow, &tally);
    let counts = tally.borrow();
    assert_met(&[(counts["Leaves"], 25), (counts["GivesWay"], 5)]);
    assert!(counts.get("Unclear").is_none_or(|&n| n <= samples(2)), "{counts:?}");
}

/// Stiffness from 1 to 1e6, friction zero, tiny, huge and infinite.
#[test]
fn agrees_on_wide_ranges() {
    let tally = Tally::default();
    random::<3, 2, 2>(500, Spread::Wide, &tally);
    random::<3, 2, 3>(250, Spread::Wide, &tally);
    random::<6, 3, 3>(38, Spread::Wide, &tally);
    random::<6, 3, 5>(12, Spread::Wide, &tally);
    let counts = tally.borrow();
    assert_met(&[(counts["Leaves"], 50)]);
    assert!(counts.get("Unclear").is_none_or(|&n| 2 * n < counts["Leaves"]), "{counts:?}");
}

/// A pair presses with N along its line and holds a perpendicular load w = 2 μ N, for all stiffnesses. A load w along the line reduces
/// one normal force by w/2, and opens this contact at w = 2 N if the springs are equal.
#[test]
fn a_pinched_pair() {
    for (k, kt) in [(1e3, 8e2), (1e12, 1.0), (1e-6, 1e9)] {
        let jaw = |side: f64| jaw::<2>(side, [k, kt], 0.3).command([5.0 / k, 0.0]);
        let fingers = planar::Fingers::new(&[jaw(-1.0), jaw(1.0)]).unwrap();
        let pull = |x, y| planar::Pull::new(&planar::Wrench::ZERO, &planar::Wrench::force([x, y])).unwrap();
        let across = fingers.onset(&pull(0.0, -1.0));
        assert!((across.factor().unwrap() - 3.0).abs() < 1e-14, "{across:?}");
        assert!(across.leaving().eq([0, 1]));
        let along = fingers.onset(&pull(1.0, 0.0));
        assert!((along.factor().unwrap() - 10.0).abs() < 1e-14, "{along:?}");
        assert!(along.leaving().eq([0]));
    }
}

/// A finger with a large command through a soft normal spring, and tangential springs ten decades stiffer. The command along an inclined normal must not
/// become a tangential force by rounding, because forces of another finger may be five decades smaller.
#[test]
fn far_pressed_fingers_with_stiff_tangents() {
    let tally = Tally::default();
    for angle in [0.0_f64, 0.3, 1.0, 2.0] {
        let contacts: [planar::Contact; 5] = std::array::from_fn(|i| {
            let (sin, cos) = (angle + std::f64::consts::TAU * i as f64 / 5.0).sin_cos();
            let press = if i == 2 { 5e-4 } else { 116.8 };
            let contact = planar::Contact::new([2e-3 * cos, 2e-3 * sin], [-cos, -sin])
                .series_stiffness(2.7e-3, 8.6e7)
                .friction(0.64)
                .command([press, 0.0]);
            if i == 0 { contact.bonded() } else { contact }
        });
        let direction = planar::Wrench::new([0.53, -0.46], -7e-4);
        check::<2, 5>(&contacts, [Wrench::ZERO, direction], 1e-8, &tally).unwrap();
    }
    assert_eq!(tally.borrow()["Leaves"], 4);
}

/// One of two contacts is frictionless, with its normal along the line through both. The object turns about the other contact, even if the normal is
/// off the line by rounding. The nearly singular balance must not be accepted.
#[test]
fn a_pair_with_a_slippery_jaw_opposite() {
    for turn in [0.0, 1.3e-16, -1e-14, 1e-10] {
        let jaw = |side: f64, turn: f64| {
            planar::Contact::new([side, 0.0], [-side, turn]).series_stiffness(1.0, 1.0).command([0.4, 0.0])
        };
        let contacts = [jaw(1.0, 0.0).bonded(), jaw(-1.0, turn)];
        let pull = Pull::new(&Wrench::ZERO, &planar::Wrench::new([0.2, 1.0], 0.5)).unwrap();
        let screened = planar::Fingers::new(&contacts).unwrap().onset(&pull);
        assert_eq!(screened.verdict(), ScreeningVerdict::Unclear, "{turn:e}");
    }
}

/// In space screening computes the factor at which a force leaves its cone from squares of forces times rates. If these underflow in some units,
/// screening gives no factor. In all other units the factor is the same.
#[test]
fn units_in_space() {
    let onset = |exponent: i32| {
        let unit = 2.0_f64.powi(exponent);
        let fingers: [spatial::Contact; 3] = std::array::from_fn(|i| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / 3.0 + 0.1).sin_cos();
            spatial::Contact::new([unit * cos, unit * sin, 0.1 * unit * sin], [-cos, -sin, 0.05])
                .series_stiffness(900.0 * unit, 600.0 * unit)
                .friction(0.6)
                .command([6e-3 * unit, 0.0, 0.0])
        });
        let force = unit * unit;
        let direction = spatial::Wrench::new(
            [0.3, -0.2, -1.0].map(|f| f * force),
            [0.1, 0.0, 0.2].map(|m| m * force * unit),
        );
        let pull = Pull::new(&Wrench::ZERO, &direction).unwrap();
        spatial::Fingers::new(&fingers).unwrap().onset(&pull)
    };
    let factor = onset(0).factor().unwrap();
    for exponent in [-100, -30, 30, 50] {
        assert!((onset(exponent).factor().unwrap() / factor - 1.0).abs() < 1e-12, "{exponent}");
    }
    for exponent in [-130, -140, -150] {
        assert_eq!(onset(exponent).verdict(), ScreeningVerdict::Unclear, "{exponent}");
    }
}

/// A pinch in space turns freely about its line. A moment about it is not resisted, a perpendicular moment is.
#[test]
fn a_pinch_in_space_gives_way() {
    let jaw = |side: f64| {
        spatial::Contact::new([side, 0.3, 0.0], [-side, 0.0, 0.0])
            .series_stiffness(1e3, 8e2)
            .friction(0.3)
            .command([0.01, 0.0, 0.0])
    };
    let fingers = spatial::Fingers::new(&[jaw(-1.0), jaw(1.0)]).unwrap();
    let onset = |force, moment| {
        let direction = spatial::Wrench::new(force, moment);
        fingers.onset(&spatial::Pull::new(&spatial::Wrench::ZERO, &direction).unwrap())
    };
    assert_eq!(onset([0.0; 3], [1.0, 0.0, 0.0]).verdict(), ScreeningVerdict::GivesWay);
    // A force through the line of the pinch is held. The same force through the origin turns the object.
    let held = onset([0.0, 0.0, -1.0], [-0.3, 0.0, 0.0]);
    assert!((held.factor().unwrap() - 6.0).abs() < 1e-13, "{held:?}");
    assert_eq!(onset([0.0, 0.0, -1.0], [0.0; 3]).verdict(), ScreeningVerdict::GivesWay);
}

/// Every lane of a batch, also in a last block that is not full, gives the bits of the single grasp, for any number of threads.
#[test]
fn a_batch_gives_the_same_bits() {
    fn bits(screened: &Screened) -> (Option<u64>, ScreeningVerdict, Vec<usize>) {
        (screened.factor().map(f64::to_bits), screened.verdict(), screened.leaving().collect())
    }
    fn grasps<const D: usize, const C: usize, const N: usize>(spread: Spread) {
        let pull = {
            let direction = SVector::<f64, D>::from_fn(|k, _| [0.3, -1.0, 0.2, 0.1, 0.05, -0.2][k]);
            Pull::new(
                &Wrench::from_components((direction * 0.01).as_slice()),
                &Wrench::from_components(direction.as_slice()),
            )
            .unwrap()
        };
        let alone = std::cell::RefCell::new(Vec::new());
        let batch = std::cell::RefCell::new(Batch::<C, N>::default());
        for_all(file!(), 331, &prop::collection::vec(datum::<C>(spread), N), |data| {
            let fingers = Fingers::new(&contacts(&data, &[9; N])).unwrap();
            alone.borrow_mut().push(fingers.onset(&pull));
            batch.borrow_mut().push(&fingers);
            Ok(())
        });
        let (alone, batch) = (alone.into_inner(), batch.into_inner());
        let mut together = vec![];
        batch.onsets_into(&[pull], &mut together);
        let other = Pull::new(&Wrench::ZERO, &Wrench::from_components(&[-1.0; D])).unwrap();
        let mut of_both = vec![];
        batch.onsets_into(&[other, pull], &mut of_both);
        let mut in_parallel = vec![];
        onsets_of_batch(&batch, &[pull], &mut in_parallel);
        assert_eq!(batch.len(), samples(331));
        let alone: Vec<_> = alone.iter().map(bits).collect();
        assert_eq!(together.iter().map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(in_parallel.iter().map(bits).collect::<Vec<_>>(), alone);
        let second = of_both.iter().skip(1).step_by(2);
        assert_eq!(second.map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(of_both.len(), 2 * alone.len());
        assert_met(&[(alone.iter().filter(|(factor, ..)| factor.is_some()).count(), 10)]);
    }
    grasps::<3, 2, 2>(Spread::Narrow);
    grasps::<3, 2, 4>(Spread::Narrow);
    grasps::<6, 3, 3>(Spread::Narrow);
    grasps::<6, 3, 5>(Spread::Narrow);
}

#[test]
fn malformed_questions_are_refused() {
    let jaw = planar::Contact::new([1.0, 0.0], [-1.0, 0.0]).series_stiffness(1.0, 1.0).name("thumb");
    let bad = planar::Fingers::new(&[jaw.clone(), jaw.clone().friction(-1.0)]).unwrap_err();
    assert_eq!(facts(&bad), ["1 (thumb)", "friction coefficient", "-1"]);
    let nan = planar::Wrench::new([0.0, f64::NAN], 0.0);
    let bad = planar::Pull::new(&planar::Wrench::ZERO, &nan).unwrap_err();
    assert_eq!(facts(&bad), ["load direction", "1", "NaN"]);
    let uneven = spatial::Contact::new([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0])
        .series_stiffness_axes([1.0, 2.0, 3.0])
        .friction(1.0);
    let bad = spatial::Fingers::new(&[uneven.clone(), uneven]).unwrap_err();
    assert_eq!(facts(&bad), ["0", "series stiffness", "3"]);
}

#[test]
fn nothing_is_allocated() {
    let jaw = |side: f64| {
        spatial::Contact::new([side, 0.3, 0.0], [-side, 0.1, 0.2]).series_stiffness(1e3, 8e2).friction(0.3)
    };
    let pull =
        Pull::new(&Wrench::ZERO, &Wrench::from_components(([0.0, 0.0, -1.0, 0.0, 0.0, 0.0]).as_slice()))
            .unwrap();
    let fingers = spatial::Fingers::new(&[jaw(-1.0), jaw(1.0), jaw(0.5)]).unwrap();
    let mut batch = Batch::with_capacity(100);
    let mut answers = Vec::with_capacity(100);
    let counted = allocation_counter::measure(|| {
        for _ in 0..100 {
            batch.push(&fingers);
        }
        batch.onsets_into(&[pull], &mut answers);
        batch.clear();
        assert_eq!(fingers.onset(&pull).factor(), answers[99].factor());
    });
    assert_eq!(counted.count_total, 0);
}

/// A contact with reversed tangent and reversed tangential command has the same factor.
#[test]
fn tangents_turned_round() {
    let pull = Pull::new(&Wrench::ZERO, &Wrench::from_components(([0.3, -1.0, 0.1]).as_slice())).unwrap();
    let jaw = |side: f64, slant: f64| {
        planar::Contact::new([side, 0.1], [-side, slant]).series_stiffness(1e3, 8e2).friction(0.7)
    };
    let plain = [jaw(-1.0, 0.1).command([0.01, 0.002]), jaw(1.0, 0.2).command([0.01, -0.001])];
    // The second jaw's tangent t = (n_y, -n_x) is (0.2, 1) apart from its length. Here it is reversed.
    let turned = [plain[0].clone(), jaw(1.0, 0.2).tangent([-0.2, -1.0]).command([0.01, 0.001])];
    let factor = |contacts: &[planar::Contact; 2]| {
        Fingers::<2, 2>::new(contacts).unwrap().onset(&pull).factor().unwrap()
    };
    assert_eq!(factor(&plain), factor(&turned));
    let grasp = Grasp::new(turned.clone()).unwrap();
    let ramp = Ramp::load(Wrench::ZERO, Wrench::from_components(([0.3, -1.0, 0.1]).as_slice()));
    let whole = grasp.onset(&ramp).unwrap().factor().unwrap();
    assert!((factor(&plain) / whole - 1.0).abs() < 1e-13);
}
