//! A watch over measured contact forces agrees with the first slip and the least squeeze of the grasp whose springs produced these forces.

use allocation_counter::measure;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::planar;
use grasp_lcp::screening::{Fingers, LoadCases, Pull, ScreeningVerdict, SqueezeVerdict};
use nalgebra::SVector;
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

fn vector<const N: usize>(random: &mut Random) -> SVector<f64, N> {
    SVector::from_fn(|_, _| random.signed())
}

fn contacts<const C: usize, const N: usize>(random: &mut Random) -> [Contact<C>; N] {
    std::array::from_fn(|_| {
        let out = vector::<C>(random).normalize();
        let contact = Contact::new(out, -out + vector::<C>(random) * 0.3);
        let contact = contact.series_stiffness(20.0 + 5.0 * random.normal().abs(), 15.0).pressed_with(2.0);
        match random.index(0, 9) {
            0 => contact.friction(0.0),
            1 => contact.bonded(),
            _ => contact.friction(0.5 + random.uniform()),
        }
    })
}

/// Compares a watch over measured forces with `Grasp::onset` and the least squeeze. Returns the number of sticking grasps, and how many of them need
/// more squeeze.
fn compare<const D: usize, const C: usize, const N: usize>(grasps: usize) -> [usize; 2] {
    let (mut random, mut counts) = (seeded(3 * N as u64 + C as u64), [0, 0]);
    for _ in 0..samples(grasps) {
        let contacts = contacts::<C, N>(&mut random);
        let [base, more] =
            [0.1, 0.6].map(|size| Wrench::<C>::from_components((vector::<D>(&mut random) * size).as_slice()));
        let fingers = Fingers::<C, N>::new(&contacts).unwrap();
        let onset = fingers.onset(&Pull::new(&base, &more).unwrap());
        let grasp = Grasp::new(contacts.iter().cloned()).unwrap();
        let Some(state) = grasp.solve(base).unwrap().equilibrium().cloned() else { continue };
        if !matches!(onset.verdict(), ScreeningVerdict::Leaves | ScreeningVerdict::Never) {
            continue;
        }
        let frames: Vec<_> = grasp.frames().collect();
        let forces: [[f64; C]; N] = std::array::from_fn(|i| (frames[i] * state.contacts[i].force).into());
        let watched = fingers.watch(&forces, &more).unwrap();
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs().max(1e-3);
        match onset.factor() {
            Some(factor) => {
                assert!(close(watched.first_slip().factor().unwrap(), factor), "{watched:?} {onset:?}");
            }
            None => assert_eq!(watched.first_slip().verdict(), ScreeningVerdict::Never),
        }
        assert!(watched.first_slip().leaving().eq(onset.leaving()));
        // The least squeeze, as a factor of the commands, under the base load and the further load together.
        let least = fingers.least_squeeze(&LoadCases::new(&[base + more]).unwrap());
        match (least.factor(), watched.extra_squeeze().factor()) {
            (Some(all), Some(extra)) => {
                // The measured forces already contain the squeeze with the factor one, so the extra squeeze is the rest.
                assert!(close(extra, (all - 1.0).max(0.0)) || all < 1.0 && extra == 0.0, "{all} {extra}");
                counts[1] += usize::from(extra > 0.0);
            }
            (None, extra) => assert!(extra.is_none_or(|extra| extra == 0.0), "{least:?} {extra:?}"),
            (Some(all), None) => assert!(
                watched.extra_squeeze().verdict() == SqueezeVerdict::Unclear && close(all, 1.0),
                "{all} {watched:?}"
            ),
        }
        assert!(watched.margin() > 0.0);
        counts[0] += 1;
    }
    counts
}

#[test]
fn forces_of_the_springs_in_the_plane() {
    for [stuck, weak] in [compare::<3, 2, 2>(300), compare::<3, 2, 4>(300)] {
        assert_met(&[(stuck, 50), (weak, 10)]);
    }
}

#[test]
fn forces_of_the_springs_in_space() {
    for [stuck, weak] in [compare::<6, 3, 3>(400), compare::<6, 3, 5>(300)] {
        assert_met(&[(stuck, 50), (weak, 10)]);
    }
}

/// The watch uses measured forces, not the forces of the springs: a jaw with half of its normal force slides at half of the load.
#[test]
fn forces_are_taken_as_they_are_measured() {
    let jaw = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(10.0);
    let fingers = planar::Fingers::new(&[jaw(-1.0), jaw(1.0)]).unwrap();
    let watched = fingers.watch(&[[5.0, 1.0], [-10.0, 1.0]], &planar::Wrench::force([0.0, -1.0])).unwrap();
    // The left margin is 0.5 · 5 N - 1 N, and each newton of load reduces it by half a newton. The right margin is 4 N.
    assert!((watched.margin() - 1.5).abs() < 1e-14 && watched.tightest() == 0);
    assert!((watched.first_slip().factor().unwrap() - 3.0).abs() < 1e-13);
    assert_eq!(watched.extra_squeeze().factor(), Some(0.0));
    // The left force is outside its cone. An extra squeeze of 0.1, 1 N, brings it back inside.
    let watched = fingers.watch(&[[5.0, 3.0], [-10.0, 1.0]], &planar::Wrench::ZERO).unwrap();
    assert!((watched.margin() + 0.5).abs() < 1e-14);
    assert_eq!(watched.first_slip().verdict(), ScreeningVerdict::NotSticking);
    assert!((watched.extra_squeeze().factor().unwrap() - 0.1).abs() < 1e-13);
}

#[test]
fn what_is_not_a_force_is_named() {
    let jaw = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5);
    let fingers = planar::Fingers::new(&[jaw(-1.0), jaw(1.0)]).unwrap();
    let told = fingers.watch(&[[1.0, 0.0], [f64::NAN, 0.0]], &planar::Wrench::ZERO).unwrap_err().to_string();
    assert!(told.contains("contact 1") && told.contains("force") && told.contains("NaN"), "{told}");
    let told = fingers.watch(&[[1.0, 0.0]; 2], &planar::Wrench::force([f64::INFINITY, 0.0])).unwrap_err();
    assert!(told.to_string().contains("load to come"), "{told}");
}

#[test]
fn nothing_is_allocated() {
    let mut random = seeded(9);
    let grasps: Vec<_> = (0..100).map(|_| Fingers::<3, 5>::new(&contacts(&mut random)).unwrap()).collect();
    let loads: Vec<Wrench<3>> =
        (0..100).map(|_| Wrench::from_components(vector::<6>(&mut random).as_slice())).collect();
    let forces: Vec<[[f64; 3]; 5]> =
        (0..100).map(|_| std::array::from_fn(|_| vector::<3>(&mut random).into())).collect();
    let mut told = 0;
    let counted = measure(|| {
        for ((fingers, load), forces) in grasps.iter().zip(&loads).zip(&forces) {
            told +=
                usize::from(fingers.watch(forces, load).is_ok_and(|watched| watched.margin().is_finite()));
        }
    });
    assert_eq!((told, counted.count_total), (100, 0));
}
