//! Samples of uncertain data have their stated distributions, and so has a load of first slip with a closed form.

use std::f64::consts::PI;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::sweep::Uncertainty;
use grasp_lcp::{Error, Field, planar, spatial};
use support::jaws::jaw;

const SAMPLES: u64 = 4000;

/// A grasp in which one contact slides clearly before the others.
fn in_the_plane() -> (planar::Grasp, planar::Ramp) {
    let finger = |x: f64, y: f64, mu: f64| {
        planar::Contact::new([x, y], [-x, 0.2 * y])
            .series_stiffness(1000.0, 800.0)
            .friction(mu)
            .command([0.01, 0.001])
    };
    let grasp = planar::Grasp::new([finger(1.0, 0.1, 0.4), finger(-1.0, -0.2, 0.7), finger(-0.9, 0.4, 0.8)]);
    let load = planar::Wrench::new([0.3, -0.5], 0.1);
    (grasp.unwrap(), planar::Ramp::load(load, planar::Wrench::force([0.1, -1.0])))
}

fn in_space() -> (spatial::Grasp, spatial::Ramp) {
    let finger = |angle: f64, mu: f64| {
        let point = [angle.cos(), angle.sin(), 0.1 * angle.sin()];
        spatial::Contact::new(point, point.map(|x| -x))
            .series_stiffness_axes([1000.0, 700.0, 500.0])
            .friction(mu)
            .command([0.01, 0.001, -0.002])
    };
    let grasp = spatial::Grasp::new([finger(0.3, 0.4), finger(2.1, 0.7), finger(4.4, 0.8)]).unwrap();
    let load = spatial::Wrench::new([0.3, -0.5, 0.2], [0.1, 0.0, 0.1]);
    (grasp, spatial::Ramp::load(load, spatial::Wrench::force([0.1, 0.2, -1.0])))
}

/// Mean and standard deviation.
fn moments(factors: &[f64]) -> [f64; 2] {
    let mean = factors.iter().sum::<f64>() / factors.len() as f64;
    let variance = factors.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / factors.len() as f64;
    [mean, variance.sqrt()]
}

fn sampled<const C: usize>(grasp: &Grasp<C>, ramp: &Ramp<C>, off: &Uncertainty) -> [f64; 2] {
    let onsets = grasp.onset_of_samples(ramp, off, SAMPLES);
    let factors: Vec<f64> = onsets.into_iter().map(|onset| onset.unwrap().factor().unwrap()).collect();
    moments(&factors)
}

/// The load of first slip is 2 P min(μ₁, μ₂), with the squeeze P. The minimum of two equal normal variables has the mean μ (1 - σ/√π) and the
/// variance σ² μ² (1 - 1/π).
#[test]
fn the_lesser_of_two_that_leave_together() {
    let finger = |x: f64| jaw::<2>(x, [1000.0, 800.0], 0.4).pressed_with(10.0);
    let grasp = planar::Grasp::new([finger(1.0), finger(-1.0)]).unwrap();
    let ramp = planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -1.0]));
    let sigma = 0.02;
    let off = Uncertainty::seeded(5).with_friction(sigma);
    let mean = 8.0 * (1.0 - sigma / PI.sqrt());
    let deviation = 8.0 * sigma * (1.0 - 1.0 / PI).sqrt();
    let [found, off_by] = sampled(&grasp, &ramp, &off);
    assert!((found - mean).abs() < 0.1 * deviation && (off_by / deviation - 1.0).abs() < 0.05);
}

/// The standard deviations of other data do not change the samples of friction, stiffness and squeeze.
#[test]
fn other_uncertainties_do_not_change_a_sample() {
    let (grasp, _) = in_space();
    let old = Uncertainty::seeded(9).with_friction(0.2).with_stiffness(0.1).with_squeeze(0.05);
    let new = old.with_position(0.01).with_normal(0.02).with_load(0.1);
    for number in 0..50 {
        let (old, new) = (grasp.sample(&old, number).unwrap(), grasp.sample(&new, number).unwrap());
        for ((old, new), given) in old.contacts().iter().zip(new.contacts()).zip(grasp.contacts()) {
            assert_eq!(old.friction_coefficient().to_bits(), new.friction_coefficient().to_bits());
            assert_eq!(old.series_stiffness_of_axes(), new.series_stiffness_of_axes());
            assert_eq!(old.commanded(), new.commanded());
            assert_eq!(old.point(), given.point());
            assert_ne!(new.point(), given.point());
        }
        for (frame, given) in old.frames().zip(grasp.frames()) {
            assert_eq!(frame, given);
        }
    }
}

/// Points and normals have their stated distributions, and frames tilt without a rotation about their normals.
#[test]
fn positions_and_normals_have_their_deviations() {
    let contact = Contact::new([0.3, -0.2, 0.1], [0.0, 0.6, 0.8]).series_stiffness(1.0, 1.0).friction(0.5);
    let grasp = spatial::Grasp::new([contact]).unwrap();
    let frame = *grasp.frames().next().unwrap();
    let off = Uncertainty::seeded(2).with_position(0.02).with_normal(0.01);
    let (mut moved, mut tilted, mut spun) = (Vec::new(), Vec::new(), 0.0_f64);
    for number in 0..SAMPLES {
        let sample = grasp.sample(&off, number).unwrap();
        let seen = frame.transpose() * sample.frames().next().unwrap();
        moved.extend((sample.contacts()[0].point() - grasp.contacts()[0].point()).iter());
        tilted.extend([seen[(1, 0)], seen[(2, 0)]]);
        spun = spun.max((seen[(2, 1)] - seen[(1, 2)]).abs());
    }
    for (list, sigma) in [(moved, 0.02), (tilted, 0.01)] {
        let [mean, deviation] = moments(&list);
        assert!(mean.abs() < 0.06 * sigma && (deviation / sigma - 1.0).abs() < 0.05, "{mean} {deviation}");
    }
    assert!(spun < 1e-15, "{spun}");
}

#[test]
fn the_load_of_a_sample_is_its_factor_times_the_load() {
    let (grasp, ramp) = in_the_plane();
    let off = Uncertainty::seeded(8).with_load(0.2);
    for (number, onset) in (0..).zip(grasp.onset_of_samples(&ramp, &off, 20)) {
        let heavier = ramp.clone().with_load_times(off.load_factor(number));
        let known = grasp.onset(&heavier).unwrap().factor().unwrap();
        assert_eq!(onset.unwrap().factor().unwrap().to_bits(), known.to_bits());
    }
}

#[test]
fn a_deviation_that_is_no_number_is_refused() {
    let (grasp, ramp) = in_the_plane();
    let refused = grasp.sample(&Uncertainty::seeded(1).with_position(f64::NAN), 0).unwrap_err();
    assert!(matches!(refused, Error::Contact { field: Field::Point, .. }), "{refused}");
    let refused = grasp.sample(&Uncertainty::seeded(1).with_normal(f64::INFINITY), 0).unwrap_err();
    assert!(matches!(refused, Error::Contact { field: Field::Normal, .. }), "{refused}");
    let onsets = grasp.onset_of_samples(&ramp, &Uncertainty::seeded(1).with_load(f64::NAN), 1);
    assert!(matches!(onsets[0], Err(Error::Wrench { what: "base load", .. })), "{onsets:?}");
    let refused =
        grasp.reserve(planar::Wrench::ZERO, &Uncertainty::seeded(1).with_normal(f64::NAN), 3.0).unwrap_err();
    assert!(matches!(refused, Error::Contact { field: Field::Normal, .. }), "{refused}");
}
