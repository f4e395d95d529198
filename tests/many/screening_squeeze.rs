//! Screening for the least squeeze agrees with `Grasp::least_squeeze`, which finds it by cutting planes, and with closed forms.
//!
//! Scenes have two to five contacts of every kind, in the plane and in space, with and without clearances, under one to four loads. If screening
//! gives a factor, `Grasp::least_squeeze` gives the same. If screening gives no factor, the search states why. Every grasp of a batch has the answer
//! of the single grasp to the last bit.

use std::cell::RefCell;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::screening::{Batch, Fingers, LoadCases, ScreenedSqueeze, SqueezeVerdict};
use grasp_lcp::squeeze::{LeastSqueeze, Loads};
use grasp_lcp::sweep::least_squeezes_of_batch;
use grasp_lcp::{planar, spatial};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::{Spread, datum, for_all};

use crate::screened_scenes::{Tally, agrees, contacts, count, firmer, of, shaken};
use support::facts;
use support::jaws::jaw;
use support::samples::assert_met;

/// Compares screening with the search. `contacts` gives the scene after relative changes of its data of the given size.
fn check<const C: usize, const N: usize>(
    contacts: impl Fn(f64) -> [Contact<C>; N],
    loads: &[Wrench<C>],
    close: f64,
    tally: &Tally,
) -> Result<(), TestCaseError> {
    let cases = LoadCases::new(loads).unwrap();
    let screened = Fingers::<C, N>::new(&contacts(0.0)).unwrap().least_squeeze(&cases);
    let needed = |part: f64, loads: &[Wrench<C>]| {
        Grasp::new(contacts(part)).unwrap().least_squeeze(&Loads::Each(loads.to_vec())).unwrap()
    };
    let factor_of = |answer: LeastSqueeze<C>| match answer {
        LeastSqueeze::Factor { factor, .. } => factor,
        _ => f64::INFINITY,
    };
    let shaken = |part: f64| factor_of(needed(part, loads));
    let whole = needed(0.0, loads);
    count(tally, &format!("{:?}", screened.verdict()));
    match (screened.verdict(), &whole) {
        // If the object moves away from contacts with clearances, no contact forces remain. The search then mistakes rounding errors for forces.
        (
            SqueezeVerdict::Suffices,
            LeastSqueeze::NoFactor { load, factor, .. }
            | LeastSqueeze::Factor { factor, binding: Some((_, load)), .. },
        ) if *factor < 1e-12 && screened.factor() == Some(0.0) => {
            let idle = contacts(0.0).map(|contact| contact.command([0.0; C]));
            let rest = Grasp::new(idle).unwrap().solve(load).unwrap();
            let forces: Vec<_> =
                rest.equilibrium().unwrap().contacts.iter().map(|contact| contact.force).collect();
            prop_assert!(forces.into_iter().all(|force| force.norm() < 1e-9), "{screened:?} {whole:?}");
            count(tally, "nothing but rounding");
        }
        (SqueezeVerdict::Suffices, LeastSqueeze::Factor { factor, binding, .. }) => {
            let found = screened.factor().unwrap();
            prop_assert!(agrees([found, *factor], close, shaken, tally), "{found} {factor}");
            match (screened.binding(), binding) {
                (Some((contact, load)), Some((other, wrench))) => {
                    // Several contacts may need the same squeeze, like both of a pair. Each of them is a right answer.
                    count(
                        tally,
                        if contact == *other && loads[load] == *wrench { "binding" } else { "tied" },
                    );
                    let alone = factor_of(needed(0.0, &loads[load..=load]));
                    prop_assert!((found - alone).abs() <= 1e-8 * factor, "{screened:?} {alone}");
                }
                (None, None) => count(tally, "none needed"),
                _ => prop_assert!(false, "{screened:?} {whole:?}"),
            }
        }
        (SqueezeVerdict::NoFactor, LeastSqueeze::NoFactor { .. })
        | (SqueezeVerdict::GivesWay, LeastSqueeze::GivesWay { .. }) => {}
        (SqueezeVerdict::Unclear, _) => prop_assert_eq!(screened.factor(), None),
        // If commands do not help, the last step of the search may be too small to be told from rounding.
        (_, LeastSqueeze::Undecided) => count(tally, "search undecided"),
        _ => prop_assert!(false, "{screened:?} {whole:?}"),
    }
    Ok(())
}

fn random<const D: usize, const C: usize, const N: usize>(cases: usize, spread: Spread, tally: &Tally) {
    let wrench = prop::collection::vec(-1.0..1.0_f64, D).prop_map(SVector::<f64, D>::from_vec);
    let question = (
        prop::collection::vec(datum::<C>(spread), N),
        prop::collection::vec(0..12_u8, N),
        prop::collection::vec(prop_oneof![1 => Just(SVector::zeros()), 6 => wrench], 1..5),
        0.02..1.0_f64,
    );
    let close = if spread == Spread::Narrow { 1e-12 } else { 1e-8 };
    for_all(file!(), cases, &question, |(data, holds, loads, size)| {
        let loads: Vec<_> =
            loads.iter().map(|load| Wrench::from_components((load * size).as_slice())).collect();
        let data = firmer(data);
        check::<C, N>(|part| contacts(&shaken(&data, part), &holds), &loads, close, tally)
    });
}

#[test]
fn agrees_in_the_plane() {
    let tally = Tally::default();
    random::<3, 2, 2>(600, Spread::Narrow, &tally);
    random::<3, 2, 3>(400, Spread::Narrow, &tally);
    random::<3, 2, 4>(200, Spread::Narrow, &tally);
    random::<3, 2, 5>(200, Spread::Narrow, &tally);
    println!("{:?}", tally.borrow());
    let factors = of(&tally, "Suffices") - of(&tally, "none needed");
    assert_met(&[(factors, 160), (of(&tally, "NoFactor"), 200)]);
    assert!(100 * of(&tally, "Unclear") < of(&tally, "Suffices") + of(&tally, "NoFactor"), "{tally:?}");
    assert!(20 * of(&tally, "as the question") < of(&tally, "close"), "{tally:?}");
    assert!(of(&tally, "tied") < of(&tally, "binding"), "{tally:?}");
}

#[test]
fn agrees_in_space() {
    let tally = Tally::default();
    random::<6, 3, 2>(40, Spread::Narrow, &tally);
    random::<6, 3, 3>(400, Spread::Narrow, &tally);
    random::<6, 3, 4>(300, Spread::Narrow, &tally);
    random::<6, 3, 5>(200, Spread::Narrow, &tally);
    println!("{:?}", tally.borrow());
    let factors = of(&tally, "Suffices") - of(&tally, "none needed");
    assert_met(&[(factors, 60), (of(&tally, "NoFactor"), 60), (of(&tally, "GivesWay"), 10)]);
    assert!(100 * of(&tally, "Unclear") < of(&tally, "Suffices") + of(&tally, "NoFactor"), "{tally:?}");
    assert!(20 * of(&tally, "as the question") < of(&tally, "close"), "{tally:?}");
    assert!(of(&tally, "tied") < of(&tally, "binding"), "{tally:?}");
}

/// Stiffness from 1 to 1e6, friction zero, tiny, huge and infinite.
#[test]
fn agrees_on_wide_ranges() {
    let tally = Tally::default();
    random::<3, 2, 2>(400, Spread::Wide, &tally);
    random::<3, 2, 3>(200, Spread::Wide, &tally);
    random::<6, 3, 3>(100, Spread::Wide, &tally);
    random::<6, 3, 5>(40, Spread::Wide, &tally);
    println!("{:?}", tally.borrow());
    assert_met(&[(of(&tally, "Suffices"), 30)]);
    assert!(2 * of(&tally, "Unclear") < of(&tally, "Suffices") + of(&tally, "NoFactor"), "{tally:?}");
}

/// Palms press with s newtons each, for all stiffnesses. A perpendicular load w needs `s = w / 2μ`, and a load w along the line of the palms `s =
/// w/2`. Both loads together need an s with `μ (s - w/2) = w/2`.
#[test]
fn palms_of_any_stiffness() {
    for (k, kt) in [(1e3, 8e2), (1e12, 1.0), (1e-6, 1e9), (1e9, 1e-12)] {
        let palm = |x: f64| jaw::<2>(x, [k, kt], 0.3).command([1.0 / k, 0.0]);
        let palms = planar::Fingers::new(&[palm(-1.0), palm(1.0)]).unwrap();
        let needed = |loads: &[[f64; 2]]| {
            let loads: Vec<_> = loads.iter().map(|load| planar::Wrench::force(*load)).collect();
            palms.least_squeeze(&LoadCases::new(&loads).unwrap())
        };
        let is = |screened: ScreenedSqueeze, factor: f64, load: usize| {
            let found = screened.factor().unwrap();
            assert!((found - factor).abs() <= 1e-13 * factor, "{k} {kt}: {screened:?} {factor}");
            assert_eq!(screened.binding().unwrap().1, load);
        };
        is(needed(&[[0.0, -3.0]]), 5.0, 0);
        is(needed(&[[3.0, 0.0]]), 1.5, 0);
        is(needed(&[[3.0, -3.0]]), 6.5, 0);
        is(needed(&[[0.0, 0.0], [3.0, 0.0], [0.0, -3.0], [0.0, 1.0]]), 5.0, 2);
        let none = needed(&[[0.0, 0.0]]);
        assert_eq!((none.factor(), none.binding()), (Some(0.0), None));
    }
}

/// One palm has the clearance c, and commands a₁ and a₂ close the palms. Both touch from the factor s on with `s (a₁ + a₂) = c`, and hold a weight w
/// from the factor on with `μ k (s (a₁ + a₂) - c) / 2 = w / 2`.
#[test]
fn clearances_stay() {
    let palm =
        |x: f64, clearance: f64| jaw::<2>(x, [1e3, 1e3], 0.5).clearance(clearance).command([0.01, 0.0]);
    let fingers = planar::Fingers::new(&[palm(-1.0, 0.0), palm(1.0, 0.03)]).unwrap();
    let needed = |y: f64| {
        let cases = LoadCases::new(&[planar::Wrench::force([0.0, y])]).unwrap();
        fingers.least_squeeze(&cases).factor().unwrap()
    };
    assert!((needed(0.0) - 1.5).abs() < 1e-13, "{}", needed(0.0));
    assert!((needed(-4.0) - 1.9).abs() < 1e-13, "{}", needed(-4.0));
}

/// At the factor s, two palms press with `10 s` newtons and lift the object by `2 mm · s`. A support below carries a part of the weight w until it
/// opens at `s = w/4`. All springs are equal. The palms need `s = w / (30 μ - 2)`, so some factor is large enough if μ > 0.2.
#[test]
fn a_range_that_closes() {
    let plane = |mu: f64| {
        let palm = |x: f64| jaw::<2>(x, [1e3, 1e3], mu).command_world([-0.01 * x, 0.002]);
        let below = planar::Contact::new([0.0, -1.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(mu);
        let cases = LoadCases::new(&[planar::Wrench::force([0.0, -2.0])]).unwrap();
        planar::Fingers::new(&[palm(-1.0), palm(1.0), below]).unwrap().least_squeeze(&cases)
    };
    let space = |mu: f64| {
        let palm = |x: f64| jaw::<3>(x, [1e3, 1e3], mu).command_world([-0.01 * x, 0.002, 0.0]);
        let below =
            spatial::Contact::new([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]).series_stiffness(1e3, 1e3).friction(mu);
        let cases = LoadCases::new(&[spatial::Wrench::force([0.0, -2.0, 0.0])]).unwrap();
        spatial::Fingers::new(&[palm(-1.0), palm(1.0), below]).unwrap().least_squeeze(&cases)
    };
    for screened in [plane as fn(f64) -> ScreenedSqueeze, space] {
        for mu in [0.201, 0.3, 1.0] {
            let found = screened(mu).factor().unwrap();
            assert!((found - 2.0 / (30.0 * mu - 2.0)).abs() < 1e-13, "{mu}: {found}");
        }
        for mu in [0.02, 0.1, 0.199] {
            assert_eq!(screened(mu).verdict(), SqueezeVerdict::NoFactor, "{mu}");
        }
        assert_eq!(screened(0.2).verdict(), SqueezeVerdict::Unclear);
    }
}

/// Every grasp of a batch, also in a last block that is not full, has the bits of the single grasp, for any number of threads. Scenes with and
/// without clearances are mixed.
#[test]
fn a_batch_gives_the_same_bits() {
    fn bits(screened: &ScreenedSqueeze) -> (Option<u64>, SqueezeVerdict, Option<(usize, usize)>) {
        (screened.factor().map(f64::to_bits), screened.verdict(), screened.binding())
    }
    fn grasps<const D: usize, const C: usize, const N: usize>(spread: Spread) {
        let load = |times: f64, shift: usize| {
            let of = SVector::<f64, D>::from_fn(|k, _| [0.3, -1.0, 0.2, 0.1, 0.05, -0.2][(k + shift) % 6]);
            Wrench::from_components((of * times).as_slice())
        };
        let cases = LoadCases::new(&[load(0.1, 0), load(0.05, 1), load(-0.1, 2)]).unwrap();
        let other = LoadCases::new(&[load(0.3, 3)]).unwrap();
        let alone = RefCell::new(Vec::new());
        let batch = RefCell::new(Batch::<C, N>::default());
        for_all(file!(), 331, &prop::collection::vec(datum::<C>(spread), N), |data| {
            let fingers = Fingers::new(&contacts(&firmer(data), &[9; N])).unwrap();
            alone.borrow_mut().push(fingers.least_squeeze(&cases));
            batch.borrow_mut().push(&fingers);
            Ok(())
        });
        let batch = batch.into_inner();
        let alone: Vec<_> = alone.borrow().iter().map(bits).collect();
        let (mut together, mut of_both, mut in_parallel) = (vec![], vec![], vec![]);
        batch.least_squeezes_into(std::slice::from_ref(&cases), &mut together);
        batch.least_squeezes_into(&[other, cases.clone()], &mut of_both);
        least_squeezes_of_batch(&batch, &[cases], &mut in_parallel);
        assert_eq!(together.iter().map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(in_parallel.iter().map(bits).collect::<Vec<_>>(), alone);
        assert_eq!(of_both.iter().skip(1).step_by(2).map(bits).collect::<Vec<_>>(), alone);
        assert_met(&[(alone.iter().filter(|(factor, ..)| factor.is_some()).count(), 10)]);
    }
    grasps::<3, 2, 2>(Spread::Narrow);
    grasps::<3, 2, 4>(Spread::Wide);
    grasps::<6, 3, 3>(Spread::Narrow);
    grasps::<6, 3, 5>(Spread::Narrow);
}

#[test]
fn malformed_loads_are_refused() {
    let none: [planar::Wrench; 0] = [];
    let bad = LoadCases::new(&none).unwrap_err();
    assert_eq!(facts(&bad), ["", "number of loads", "0"]);
    let bad = LoadCases::new(&[planar::Wrench::ZERO, planar::Wrench::new([0.0, f64::NAN], 0.0)]).unwrap_err();
    assert_eq!(facts(&bad), ["load", "1", "NaN"]);
}
