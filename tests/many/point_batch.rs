//! Batches of grasps with any number of contact points. For up to five contacts their factors of first slip are those of single grasps to the last
//! bit. For larger grasps and pads they are those of `Grasp::onset` to 1e-9.

use grasp_lcp::screening::{Fingers, PointBatch, Pull, Screened, ScreeningVerdict};
use grasp_lcp::spatial::{Contact, Grasp, Pressure, Ramp, SoftFingertip, Wrench};
use support::samples::{samples, seeded};
use support::splitmix::Random;

fn fingers(random: &mut Random, count: usize) -> Vec<Contact> {
    (0..count)
        .map(|k| {
            let (sin, cos) =
                (std::f64::consts::TAU * k as f64 / count as f64 + 0.2 * random.signed()).sin_cos();
            Contact::new(
                [0.04 * cos, 0.04 * sin, 0.01 * random.signed()],
                [-cos, -sin, 0.05 * random.signed()],
            )
            .series_stiffness(1e3 * random.between(0.5, 2.0), 8e2)
            .friction(random.between(0.3, 0.9))
            .pressed_with(random.between(5.0, 10.0))
        })
        .collect()
}

fn pull(random: &mut Random) -> (Ramp, Pull<3>) {
    let mut force = || random.vector::<3>();
    let (base, load) = (Wrench::force(force()) * 0.1, Wrench::force(force()));
    (Ramp::load(base, load), Pull::new(&base, &load).unwrap())
}

fn bits(screened: &Screened) -> (Option<u64>, Vec<usize>) {
    (screened.factor().map(f64::to_bits), screened.leaving().collect())
}

#[test]
fn few_contacts_have_the_bits_of_single_grasps() {
    let mut random = seeded(41);
    let grasps: Vec<_> = (0..samples(200)).map(|_| fingers(&mut random, 3)).collect();
    let (mut batch, mut pulls, mut alone) = (PointBatch::with_capacity(3, 0), Vec::new(), Vec::new());
    for contacts in &grasps {
        let (_, pull) = pull(&mut random);
        let three: [Contact; 3] = contacts.clone().try_into().unwrap();
        alone.push(Fingers::new(&three).unwrap().onset(&pull));
        assert!(batch.push(contacts));
        pulls.push(pull);
    }
    let own = batch.own_onsets(pulls.clone());
    assert!(own.iter().map(bits).eq(alone.iter().map(bits)));
    assert!(alone.iter().filter(|onset| onset.factor().is_some()).count() > samples(100));
    // Loads common to all grasps give the same factors. If each grasp has its own load, there must be as many loads as grasps.
    let mut common = Vec::new();
    batch.onsets_into(&pulls[..2], &mut common);
    assert_eq!(
        (common.len(), bits(&common[0]), bits(&common[3])),
        (2 * grasps.len(), bits(&own[0]), bits(&own[1]))
    );
    assert!(batch.own_onsets(pulls[1..].to_vec()).is_empty());
}

#[test]
fn pads_and_many_contacts_slide_where_the_grasp_does() {
    let mut random = seeded(42);
    let tip = SoftFingertip::disc(0.005, 1, 5, Pressure::Hertz).unwrap();
    for (count, is_soft) in [(6, false), (12, false), (52, false), (2, true), (3, true), (6, true)] {
        let mut grasps = Vec::new();
        for _ in 0..samples(9) {
            let hard = fingers(&mut random, count);
            let soft = || hard.iter().flat_map(|finger| tip.contacts(finger).unwrap()).collect();
            grasps.push(if is_soft { soft() } else { hard });
        }
        let points = grasps[0].len();
        let mut batch = PointBatch::with_capacity(points, grasps.len());
        let (mut ramps, mut pulls) = (Vec::new(), Vec::new());
        for grasp in &grasps {
            let (ramp, pull) = pull(&mut random);
            assert!(batch.push(grasp));
            ramps.push(ramp);
            pulls.push(pull);
        }
        let mut leave = 0;
        for ((onset, grasp), ramp) in batch.own_onsets(pulls).iter().zip(grasps).zip(ramps) {
            let whole = Grasp::new(grasp).unwrap().onset(ramp).unwrap();
            let Some(event) = whole.event() else {
                assert_ne!(onset.verdict(), ScreeningVerdict::Leaves);
                continue;
            };
            let factor = onset.factor().expect("it leaves");
            assert!((factor / event.factor - 1.0).abs() < 1e-9, "{factor} {}", event.factor);
            let per_finger = if is_soft { tip.points().len() } else { 1 };
            for leaving in &event.leaving {
                assert!(onset.leaving().any(|finger| finger == leaving.contact.index / per_finger));
            }
            leave += 1;
        }
        assert!(leave > samples(4), "{count} {leave}");
    }
}

/// A batch refuses grasps with another number of points than the first one, too many points or fingers, and contacts that screening does not support.
#[test]
fn what_does_not_fit_is_left_out() {
    let mut random = seeded(43);
    let tip = SoftFingertip::ring(0.005, 3).unwrap();
    let two = fingers(&mut random, 2);
    let mixed = |soft: usize| -> Vec<Contact> {
        let spread =
            |(k, finger)| if k == soft { tip.contacts(finger).unwrap() } else { vec![finger.clone()] };
        two.iter().enumerate().flat_map(spread).collect()
    };
    let mut batch = PointBatch::with_capacity(4, 3);
    assert!(batch.push(&mixed(0)) && batch.push(&mixed(0)));
    assert!(!batch.push(&mixed(1)));
    assert!(!batch.push(&two) && !batch.push(&[]));
    let mut held = mixed(0);
    held[3] = held[3].clone().suction(1.0);
    assert!(!batch.push(&held));
    assert_eq!(batch.len(), 2);
    assert!(!PointBatch::with_capacity(53, 1).push(&fingers(&mut random, 53)));
    assert!(!PointBatch::with_capacity(65, 1).push(&fingers(&mut random, 65)));
}
