//! Sweeps can be watched and stopped, and one bad question does not affect the others. Samples of an uncertain grasp have the right distribution, and
//! are the same for any number of threads.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use grasp_lcp::planar::{Contact, Grasp, Onset, Ramp, Wrench};
use grasp_lcp::sweep::{Uncertainty, map_in_order, map_watched};
use grasp_lcp::{Error, Field, Settings};
use support::jaws::jaw;

const MU: f64 = 0.4;
const K: f64 = 1000.0;
const A: f64 = 0.01;

/// A pinch of two equal opposed fingers, of which each carries half of a weight. The finger with less friction slides first, at the weight 2 μ K A.
fn pinch(k: f64) -> Grasp {
    let finger = |x: f64| jaw::<2>(x, [k, 0.8 * k], MU).command([A, 0.0]);
    Grasp::new([finger(1.0), finger(-1.0)]).unwrap()
}

fn weight() -> Ramp {
    Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]))
}

fn factor(onset: &Result<Onset, Error>) -> f64 {
    onset.as_ref().unwrap().factor().unwrap()
}

#[test]
fn every_count_comes_once() {
    let counts = Mutex::new(Vec::new());
    let items: Vec<u32> = (0..500).collect();
    let answers = map_watched(
        &items,
        |x| x * 2,
        |progress| {
            assert_eq!(progress.of, 500);
            counts.lock().unwrap().push(progress.answered);
            ControlFlow::Continue(())
        },
    );
    assert!(answers.iter().zip(&items).all(|(answer, x)| *answer == Some(x * 2)));
    let mut counts = counts.into_inner().unwrap();
    counts.sort_unstable();
    assert_eq!(counts, (1..=500).collect::<Vec<_>>());
}

#[test]
fn a_sweep_that_is_stopped_answers_no_more() {
    let begun = AtomicUsize::new(0);
    let items = [(); 10_000];
    let answers = map_watched(
        &items,
        |()| begun.fetch_add(1, Ordering::Relaxed),
        |progress| if progress.answered >= 20 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) },
    );
    let answered = answers.iter().flatten().count();
    assert_eq!(answered, begun.into_inner());
    // Questions that other threads had started before the break are still answered.
    assert!((20..1000).contains(&answered), "{answered}");
}

#[test]
fn one_bad_question_does_not_stop_the_rest() {
    let grasps = [pinch(K), pinch(2.0 * K), pinch(3.0 * K)];
    for (k, onset) in map_in_order(&grasps, |grasp| grasp.onset(weight())).iter().enumerate() {
        let expected = 2.0 * MU * K * A * (k + 1) as f64;
        assert!((factor(onset) / expected - 1.0).abs() < 1e-14);
    }
    // With a very large standard deviation the friction of some samples overflows, and the friction of others does not.
    let wild = Uncertainty::seeded(1).with_friction(500.0);
    let onsets = pinch(K).onset_of_samples(weight(), &wild, 300);
    let errors = onsets.iter().filter(|o| matches!(o, Err(Error::Contact { .. }))).count();
    assert!(errors > 10 && errors < 290, "{errors}");
    let nan = Uncertainty::seeded(1).with_stiffness(f64::NAN);
    assert!(matches!(pinch(K).sample(&nan, 0), Err(Error::Contact { .. })));
}

/// The load of first slip is 2 K A min(μ₁, μ₂) with two independent coefficients. It exceeds c times its nominal value with the probability Φ(-ln c /
/// σ)².
#[test]
fn samples_are_distributed_as_they_should_be() {
    let (grasp, settings, count) = (pinch(K), Settings::default(), 4000_u64);
    let off = Uncertainty::seeded(42).with_friction(0.2);
    let onsets = grasp.with(&settings).onset_of_samples(weight(), &off, count);
    let nominal = 2.0 * MU * K * A;
    // Pairs of c and the normal distribution Φ(-ln c / 0.2).
    for (c, phi) in
        [(1.0_f64, 0.5), ((-0.2_f64).exp(), 0.841_344_746_068_543), (0.2_f64.exp(), 0.158_655_253_931_457)]
    {
        let expected: f64 = phi * phi;
        let share = onsets.iter().filter(|o| factor(o) > c * nominal).count() as f64 / count as f64;
        let deviation = (expected * (1.0 - expected) / count as f64).sqrt();
        assert!((share - expected).abs() < 4.0 * deviation, "{c}: {share} {expected}");
    }
    // Now only stiffness is uncertain. By moments each finger carries half of the weight, and the squeeze is that of two springs in series.
    let off = Uncertainty::seeded(5).with_stiffness(0.3);
    for number in 0..200 {
        let sample = grasp.sample(&off, number).unwrap();
        let k: Vec<f64> = sample.contacts().iter().map(|c| c.series_stiffness_of_axes()[0]).collect();
        let press = k[0] * k[1] / (k[0] + k[1]) * 2.0 * A;
        let expected = 2.0 * MU * press;
        let found = factor(&sample.with(&settings).onset(weight()));
        assert!((found / expected - 1.0).abs() < 1e-13, "{found} {expected}");
    }
}

#[test]
fn samples_depend_on_seed_and_number_alone() {
    let (grasp, settings) = (pinch(K), Settings::default());
    let seeded = |seed| Uncertainty::seeded(seed).with_friction(0.2).with_stiffness(0.1).with_squeeze(0.05);
    let off = seeded(9);
    let sweep = || -> Vec<u64> {
        let onsets = grasp.with(&settings).onset_of_samples(weight(), &off, 300);
        onsets.iter().map(|o| factor(o).to_bits()).collect()
    };
    let one_by_one: Vec<u64> = (0..300)
        .map(|i| factor(&grasp.sample(&off, i).unwrap().with(&settings).onset(weight())).to_bits())
        .collect();
    assert_eq!(sweep(), one_by_one);
    #[cfg(feature = "parallel")]
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert_eq!(pool.install(sweep), one_by_one);
    }
    let other = seeded(10);
    let others = grasp.with(&settings).onset_of_samples(weight(), &other, 300);
    assert!(others.iter().zip(&one_by_one).all(|(o, bits)| factor(o).to_bits() != *bits));
    let mut distinct = one_by_one.clone();
    distinct.sort_unstable();
    distinct.dedup();
    assert_eq!(distinct.len(), 300);
}

/// Infinite and zero friction are separate laws. No sample of a finite coefficient may become one of them.
#[test]
fn friction_of_samples_stays_finite_and_positive_or_is_refused() -> Result<(), Error> {
    let contact = |mu| Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(K, 0.8 * K).friction(mu);
    let off = Uncertainty::seeded(3).with_friction(2000.0);
    let (mut refused, mut accepted) = (0, 0);
    for number in 0..200 {
        match Grasp::new([contact(MU)])?.sample(&off, number) {
            Ok(sample) => {
                let mu = sample.contacts()[0].friction_coefficient();
                assert!(mu > 0.0 && mu.is_finite(), "{mu}");
                accepted += 1;
            }
            Err(Error::Contact { field: Field::Friction, .. }) => refused += 1,
            Err(other) => return Err(other),
        }
    }
    assert!(refused > 50 && accepted > 50, "{refused} {accepted}");
    for mu in [0.0, f64::INFINITY] {
        let sample = Grasp::new([contact(mu)])?.sample(&off, 0)?;
        assert_eq!(sample.contacts()[0].friction_coefficient(), mu);
    }
    Ok(())
}
