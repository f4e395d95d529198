//! A pinch of soft fingertips under shear and torsion is lost at the limit load of friction. The path from event to event and the path in steps
//! report the same kind of loss.

use grasp_lcp::load_path::{LossKind, PathEnd};
use grasp_lcp::spatial::{Leg, SoftFingertip, Wrench};
use support::samples::{samples, seeded};
use support::soft_tips::{TWO, draw, pinch};

/// Two rings of six springs, with a friction limit of 5/6 N each. Under a motion with velocity v and angular velocity ω, the spring at (y, z) moves
/// by (-z ω, v + y ω), and the load does the work `m ω - f v`. The limit factor is the least ratio of friction work to load work over all motions.
#[test]
fn a_pinch_spins_where_friction_works_no_more_than_the_load() {
    let tip = SoftFingertip::ring(0.006, 6).expect("valid");
    let grasp = pinch(&tip, TWO, [0.03, 0.5, 0.005]).expect("valid");
    let places: Vec<_> =
        grasp.contacts().iter().map(|contact| (contact.point()[1], contact.point()[2])).collect();
    for (f, m) in [(0.1, 0.01), (0.5, 0.01), (1.0, 0.002)] {
        let factor = |v: f64| {
            let works: f64 = places.iter().map(|(y, z)| 5.0 / 6.0 * z.hypot(v + y)).sum();
            works / (m - f * v)
        };
        // Among the motions on which the load does positive work, this ratio has one minimum.
        let (mut low, mut high) = (-1.0, m / f - 1e-9);
        for _ in 0..200 {
            let [a, b] = [2.0 / 3.0, 1.0 / 3.0].map(|part: f64| part * low + (1.0 - part) * high);
            if factor(a) < factor(b) { high = b } else { low = a }
        }
        let limit = factor(0.5 * (low + high));
        let far = 3.0 * limit;
        let leg = [Leg::load_to(Wrench::new([0.0, 0.0, -f], [m, 0.0, 0.0]) * far)];
        let mut events = grasp.follow(Wrench::ZERO, &leg).expect("valid");
        events.run();
        let mut steps = grasp.follow_in_steps(Wrench::ZERO, &leg, 1e-6).expect("valid");
        steps.by_ref().for_each(drop);
        for (end, near) in [(events.end(), 5e-14), (steps.end(), 1e-10)] {
            let Some(PathEnd::Lost(loss)) = end else { panic!("{end:?}") };
            let off = loss.fraction * far / limit - 1.0;
            println!("{f} N, {m} N m: {:?} at {limit}, off by {off:e}", loss.kind);
            assert!(loss.kind == LossKind::Asymptote && off.abs() < near, "{off:e}");
        }
    }
}

#[test]
fn both_ways_end_alike() {
    let mut random = seeded(7);
    let mut lost = Vec::new();
    for _ in 0..samples(12) {
        let (grasp, load) = draw(&mut random).expect("valid");
        let leg = [Leg::load_to(load * 100.0)];
        let mut events = grasp.follow(Wrench::ZERO, &leg).expect("valid");
        events.run();
        let mut steps = grasp.follow_in_steps(Wrench::ZERO, &leg, 1e-5).expect("valid");
        steps.by_ref().for_each(drop);
        match (events.end(), steps.end()) {
            (Some(PathEnd::Lost(a)), Some(PathEnd::Lost(b))) => {
                assert!(
                    a.kind == b.kind && (a.fraction - b.fraction).abs() < 1e-5 * a.fraction,
                    "{a:?} {b:?}"
                );
                lost.push(a.kind);
            }
            (Some(PathEnd::Completed), Some(PathEnd::Completed)) => {}
            ends => panic!("{ends:?}"),
        }
    }
    println!("{lost:?}");
    let kinds = [LossKind::Asymptote, LossKind::Corner, LossKind::Fold];
    assert!(kinds.iter().all(|kind| lost.contains(kind)), "{lost:?}");
}
