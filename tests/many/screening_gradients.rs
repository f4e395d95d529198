//! Gradients of screening agree to nine digits with `Grasp::sensitivity`, which solves once more for every datum.
//!
//! Grasps are planar and spatial, with two to five contacts of every kind, with and without a base load, and with a reference point off the origin.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{DepartingPart, Parameter, Ramp};
use grasp_lcp::screening::{Batch, Fingers, Pull, ScreenedGradient, ScreenedGradients, ScreeningVerdict};
use grasp_lcp::sweep::onset_gradients_of_batch;
use grasp_lcp::{planar, spatial};
use nalgebra::{SMatrix, SVector};
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Tolerance of derivatives, relative to the largest derivative with respect to the same kind of data, for example all points.
const CLOSE: f64 = 1e-9;

fn vector<const N: usize>(random: &mut Random) -> SVector<f64, N> {
    SVector::from_fn(|_, _| random.signed())
}

/// Fingers around a point, most of them with ordinary data.
fn contacts<const C: usize, const N: usize>(random: &mut Random, place: f64) -> [Contact<C>; N] {
    std::array::from_fn(|_| {
        let out = vector::<C>(random).normalize();
        let mut stiffness = vector::<C>(random).map(|x| 10_f64.powf(1.0 + 0.5 * x));
        stiffness[C - 1] = stiffness[1];
        let mut command = vector::<C>(random) * 0.02;
        command[0] = 0.1;
        let contact = Contact::new(out + SVector::repeat(place), -out + vector::<C>(random) * 0.3)
            .tangent(vector::<C>(random))
            .series_stiffness_axes(stiffness)
            .command(command);
        let contact = match random.index(0, 15) {
            0 => contact.friction(0.0),
            1 => contact.friction(f64::INFINITY),
            _ => contact.friction(0.3 + 0.6 * random.uniform()),
        };
        match random.index(0, 15) {
            0 => contact.kept_closed(),
            1 => contact.bonded(),
            2 => contact.clearance(0.01),
            _ => contact,
        }
    })
}

fn load<const D: usize, const C: usize>(random: &mut Random, size: f64, place: f64) -> Wrench<C> {
    let mut load = vector::<D>(random) * size;
    // The drawn moments are about the point at `place`. The moments of a wrench are about the origin.
    if C == 2 {
        load[2] += place * (load[1] - load[0]);
    } else {
        for (k, [a, b]) in [[2, 1], [0, 2], [1, 0]].into_iter().enumerate() {
            load[C + k] += place * (load[a] - load[b]);
        }
    }
    Wrench::from_components(load.as_slice())
}

/// The largest difference of two fields, relative to their largest number. Fields with NaN in screening are left out and counted.
struct Compared {
    off: f64,
    /// Fields with smaller numbers are rounding errors alone. For example, statically determinate forces do not depend on springs.
    least: f64,
    left_out: usize,
    numbers: usize,
}

impl Compared {
    fn field(&mut self, pairs: impl IntoIterator<Item = (f64, f64)>) {
        let pairs: Vec<_> = pairs.into_iter().collect();
        let known = pairs.iter().filter(|(ours, _)| ours.is_finite());
        let size = known.clone().map(|(a, b)| a.abs().max(b.abs())).fold(self.least, f64::max);
        let off = known.map(|(a, b)| (a - b).abs() / size);
        self.off = off.fold(self.off, |most, off| if off > most || off.is_nan() { off } else { most });
        self.left_out += pairs.iter().filter(|(ours, _)| !ours.is_finite()).count();
        self.numbers += pairs.len();
    }
}

fn along<const C: usize>(frame: &SMatrix<f64, C, C>, ours: [f64; C]) -> SVector<f64, C> {
    frame.tr_mul(&SVector::from(ours))
}

/// Compares every field of one gradient; `None` if `sensitivity` has no gradient.
fn compare<const C: usize>(
    grasp: &Grasp<C>,
    pull: [Wrench<C>; 2],
    ours: &ScreenedGradient<'_, C>,
    compared: &mut Compared,
) -> Option<()> {
    let onset = grasp.onset(Ramp::load(pull[0], pull[1])).unwrap();
    let event = onset.event()?;
    let contact = DepartingPart::Contact(ours.contact()?);
    let margins = grasp.sensitivity().onset(event)?;
    let leaving = margins.leavers().into_iter().position(|leaver| leaver == contact)?;
    let by = |parameter| margins.by(parameter).map_or(f64::NAN, |by| by[leaving]);
    let frames: Vec<_> = grasp.frames().collect();
    let all = 0..frames.len();
    compared.field(all.clone().map(|i| (ours.friction(i), by(Parameter::Friction { contact: i }))));
    compared.field(all.clone().flat_map(|i| {
        let [normal, tangential] = ours.stiffness(i);
        let of = |axis| by(Parameter::Stiffness { contact: i, axis });
        [(normal, of(0)), (tangential, (1..C).map(of).sum())]
    }));
    let pairs = |ours: SVector<f64, C>, theirs: &dyn Fn(usize) -> Parameter, from: usize| {
        (from..C).map(|axis| (ours[axis], by(theirs(axis)))).collect::<Vec<_>>()
    };
    compared.field(all.clone().flat_map(|i| {
        pairs(along(frames[i], ours.command(i)), &|axis| Parameter::Command { contact: i, axis }, 0)
    }));
    compared.field(
        all.clone().flat_map(|i| {
            pairs(SVector::from(ours.point(i)), &|axis| Parameter::Point { contact: i, axis }, 0)
        }),
    );
    compared.field(all.clone().flat_map(|i| {
        pairs(along(frames[i], ours.normal(i)), &|axis| Parameter::Normal { contact: i, axis }, 1)
    }));
    let loads = ours.base_load().iter().enumerate();
    compared.field(loads.map(|(component, ours)| (*ours, by(Parameter::Load { component }))));
    for i in all {
        // The derivative with respect to a change of the normal along itself is zero.
        let normal = along(frames[i], ours.normal(i));
        assert!(normal[0].is_nan() || normal[0].abs() <= 1e-9 * normal.norm(), "{normal}");
    }
    Some(())
}

/// Compares gradients and returns their number. Those of a batch must have the bits of single grasps.
fn agree<const D: usize, const C: usize, const N: usize>(scenes: usize) -> (usize, Compared) {
    let mut random = seeded(100 * N as u64 + C as u64);
    let (mut count, mut compared) = (0, Compared { off: 0.0, least: 0.0, left_out: 0, numbers: 0 });
    for scene in 0..samples(scenes) {
        let place = 0.7 * f64::from(u8::from(scene % 2 == 1));
        let contacts = contacts::<C, N>(&mut random, place);
        let base = if scene % 3 == 0 { 0.0 } else { 0.03 };
        let pull = [load::<D, C>(&mut random, base, place), load::<D, C>(&mut random, 0.5, place)];
        let fingers = Fingers::<C, N>::new(&contacts).unwrap();
        let asked = Pull::new(&pull[0], &pull[1]).unwrap();
        let each = fingers.onset_gradients(&asked);
        assert_eq!(each.len(), fingers.onset(&asked).leaving().count());
        let grasp = Grasp::new(contacts.iter().cloned()).unwrap();
        for gradient in each.iter() {
            assert_eq!(gradient.screened(), fingers.onset(&asked));
            compared.least = 1e-3 * gradient.screened().factor().unwrap();
            count += usize::from(compare(&grasp, pull, &gradient, &mut compared).is_some());
        }
    }
    (count, compared)
}

#[test]
fn those_of_the_whole_method_in_the_plane() {
    for (count, compared) in
        [agree::<3, 2, 2>(100), agree::<3, 2, 3>(100), agree::<3, 2, 4>(70), agree::<3, 2, 5>(70)]
    {
        assert!(compared.off < CLOSE, "{}", compared.off);
        assert_met(&[(count, 10)]);
        assert!(20 * compared.left_out < compared.numbers, "{count} {}", compared.left_out);
    }
}

#[test]
fn those_of_the_whole_method_in_space() {
    for (count, compared) in [agree::<6, 3, 3>(130), agree::<6, 3, 4>(70), agree::<6, 3, 5>(70)] {
        assert!(compared.off < CLOSE, "{}", compared.off);
        assert_met(&[(count, 10)]);
        assert!(20 * compared.left_out < compared.numbers, "{count} {}", compared.left_out);
    }
}

/// Two point fingers in space leave the rotation about their line free. Only derivatives that do not move this line are known.
#[test]
fn pairs_in_space_know_what_leaves_their_line() {
    let finger = |x: f64, friction: f64| jaw::<3>(x, [1e3, 8e2], friction).pressed_with(10.0);
    let fingers = Fingers::<3, 2>::new(&[finger(-1.0, 0.5), finger(1.0, 0.4)]).unwrap();
    let pull = Pull::new(&Wrench::ZERO, &spatial::Wrench::force([0.0, 0.0, -1.0])).unwrap();
    let gradients = fingers.onset_gradients(&pull);
    let gradient = gradients.get(0).unwrap();
    assert_eq!((gradient.contact(), gradient.is_one_sided()), (Some(1), false));
    // The finger with less friction slides at 2 μ N = 8 N.
    assert!((gradient.screened().factor().unwrap() - 8.0).abs() < 1e-13);
    assert!((gradient.friction(1) - 20.0).abs() < 1e-12);
    // A larger command of one finger increases the normal force by half of the change times the stiffness.
    assert!((gradient.command(0)[0] - 400.0).abs() < 1e-10);
    assert!(gradient.point(0).iter().chain(gradient.base_load()).all(|number| number.is_nan()));
}

/// For every pair in space, screening finds that a load with a moment about its line gives way. A load without this moment has a factor, or none for
/// another reason. Derivatives with respect to loads are never finite.
#[test]
fn the_free_motion_of_a_pair_in_space_is_always_seen() {
    let mut random = seeded(68);
    let (mut gave_way, mut left) = (0, 0);
    for _ in 0..samples(2000) {
        let (middle, along) = (0.1 * vector::<3>(&mut random), vector::<3>(&mut random).normalize());
        let pair = [-1.0, 1.0].map(|side: f64| {
            let normal = -side * along + 0.05 * vector::<3>(&mut random);
            let stiffness = [0, 1].map(|_| 10_f64.powf(random.between(2.0, 5.0)));
            let finger = Contact::<3>::new(middle + side * 0.05 * along, normal);
            finger
                .series_stiffness(stiffness[0], stiffness[1])
                .friction(0.6)
                .pressed_with(random.between(1.0, 9.0))
        });
        let fingers = Fingers::<3, 2>::new(&pair).unwrap();
        let force = vector::<3>(&mut random);
        let through = middle.cross(&force);
        for moment in [through, through + 0.01 * along] {
            let pull = Pull::new(&Wrench::ZERO, &spatial::Wrench::new(force, moment)).unwrap();
            match fingers.onset(&pull).verdict() {
                ScreeningVerdict::NotSticking => {}
                // A force along the line may increase the squeeze without bound.
                ScreeningVerdict::Never => assert_eq!(moment, through),
                ScreeningVerdict::GivesWay => gave_way += usize::from(moment != through),
                ScreeningVerdict::Leaves => left += usize::from(moment == through),
                verdict => panic!("{verdict:?} {pair:?}"),
            }
            for gradient in fingers.onset_gradients(&pull).iter() {
                assert!(gradient.base_load().iter().chain(&gradient.point(0)).all(|number| number.is_nan()));
            }
        }
    }
    assert_met(&[(gave_way, 300), (left, 300)]);
}

/// Three fingers on a disc slide together under a load along its axis. Each has its own gradient.
#[test]
fn ties_are_told_and_each_has_its_gradient() {
    let finger = |turn: f64| {
        let (sin, cos) = (turn * std::f64::consts::TAU / 3.0).sin_cos();
        Contact::new([cos, sin, 0.0], [-cos, -sin, 0.0])
            .series_stiffness(1e3, 1e3)
            .friction(0.5)
            .pressed_with(6.0)
    };
    let fingers = Fingers::<3, 3>::new(&[finger(0.0), finger(1.0), finger(2.0)]).unwrap();
    let down = Pull::new(&Wrench::ZERO, &spatial::Wrench::force([0.0, 0.0, -1.0])).unwrap();
    let gradients = fingers.onset_gradients(&down);
    assert_eq!(gradients.len(), 3);
    for (i, gradient) in gradients.iter().enumerate() {
        assert!(gradient.is_one_sided() && gradient.contact() == Some(i));
        assert!(gradient.screened().leaving().eq([0, 1, 2]));
        for j in 0..3 {
            let exact = if i == j { 18.0 } else { 0.0 };
            assert!((gradient.friction(j) - exact).abs() < 1e-11);
        }
    }
    let mut batch = Batch::default();
    batch.push(&fingers);
    let mut first = ScreenedGradients::new();
    batch.onset_gradients_into(&[down], &mut first);
    assert_eq!(first.get(0), gradients.get(0));
    assert_eq!(first.get(1), None);
}

/// A finger under a pure pull opens: its force leaves through the apex of the cone. With a small tangential force it would slide before.
#[test]
fn a_finger_pulled_off_leaves_through_the_apex() {
    let finger = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(10.0);
    let fingers = Fingers::<2, 2>::new(&[finger(-1.0), finger(1.0)]).unwrap();
    let off = Pull::new(&Wrench::ZERO, &planar::Wrench::force([1.0, 0.0])).unwrap();
    let gradients = fingers.onset_gradients(&off);
    let gradient = gradients.get(0).unwrap();
    assert!(gradient.is_one_sided() && gradients.len() == 1);
    assert!((gradient.screened().factor().unwrap() - 20.0).abs() < 1e-12);
    // At the load factor τ the normal force is F_n = 10 - τ/2. A command that is larger by d adds 500 d.
    assert!((gradient.command(0)[0] - 1000.0).abs() < 1e-9);
}

/// If screening gives no load factor of first slip, it gives no gradient either.
#[test]
fn without_a_factor_no_gradient() {
    let finger = |x: f64| jaw::<2>(x, [1e3, 8e2], 0.5).pressed_with(10.0);
    let fingers = Fingers::<2, 2>::new(&[finger(-1.0), finger(1.0)]).unwrap();
    let down = planar::Wrench::force([0.0, -1.0]);
    for pull in [[down * 30.0, down], [Wrench::ZERO, Wrench::ZERO]] {
        let pull = Pull::new(&pull[0], &pull[1]).unwrap();
        assert!(fingers.onset_gradients(&pull).is_empty());
        let mut batch = Batch::default();
        batch.push(&fingers);
        let mut gradients = ScreenedGradients::new();
        batch.onset_gradients_into(&[pull], &mut gradients);
        let gradient = gradients.get(0).unwrap();
        assert_eq!((gradient.contact(), gradient.is_one_sided()), (None, false));
        assert!(gradient.point(0).into_iter().chain([gradient.friction(1)]).all(f64::is_nan));
        assert_eq!(gradient.screened(), fingers.onset(&pull));
    }
}

/// Checks grasps of every kind in one batch under several loads: results have the same bits for any number of threads.
fn same_bits<const D: usize, const C: usize, const N: usize>() {
    let mut random = seeded(7 + N as u64);
    let fingers: Vec<_> =
        (0..3001).map(|k| Fingers::<C, N>::new(&contacts(&mut random, f64::from(k % 2))).unwrap()).collect();
    let mut batch = Batch::with_capacity(fingers.len());
    for fingers in &fingers {
        batch.push(fingers);
    }
    let pulls: Vec<_> = [0.0, 0.02]
        .map(|base| {
            Pull::new(&load::<D, C>(&mut random, base, 0.5), &load::<D, C>(&mut random, 0.5, 0.5)).unwrap()
        })
        .to_vec();
    let bits = |gradients: &ScreenedGradients<C>| -> Vec<u64> {
        let number = |x: &f64| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() };
        gradients.numbers().iter().map(number).collect()
    };
    let mut gradients = ScreenedGradients::new();
    batch.onset_gradients_into(&pulls, &mut gradients);
    let here = bits(&gradients);
    let swept = || {
        let mut gradients = ScreenedGradients::new();
        onset_gradients_of_batch(&batch, &pulls, &mut gradients);
        bits(&gradients)
    };
    assert!(swept() == here);
    #[cfg(feature = "parallel")]
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert!(pool.install(swept) == here, "{threads} threads");
    }
    let mut factors = 0;
    for (k, fingers) in fingers.iter().enumerate() {
        for (p, pull) in pulls.iter().enumerate() {
            let of_batch = gradients.get(k * pulls.len() + p).unwrap();
            // Unclear results may contain NaN.
            assert_eq!(format!("{:?}", of_batch.screened()), format!("{:?}", fingers.onset(pull)));
            let alone = fingers.onset_gradients(pull);
            let Some(alone) = alone.get(0) else { continue };
            assert_eq!(format!("{of_batch:?}"), format!("{alone:?}"));
            factors += 1;
        }
    }
    assert_met(&[(factors, 100)]);
}

#[test]
fn the_same_bits_whoever_asks() {
    same_bits::<3, 2, 2>();
    same_bits::<3, 2, 3>();
    same_bits::<6, 3, 3>();
    same_bits::<6, 3, 5>();
}
