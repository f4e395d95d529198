//! If the object starts to slide without resistance, it moves until a gap closes, and the path continues with this gap closed. Closed forms and the
//! balance of work confirm this.
//!
//! A block of weight W slides on feet (total tangential stiffness K, friction μ) towards a stop at the distance g. P is the pull:
//!
//! ```text
//! lost for good without a stop at μ W,   springs have taken up μ W / K then   so it slides g - μ W / K
//! beyond                                 stop carries P - μ W
//! ```

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Settings};
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Change, Event, Leg, LossKind, PathEnd};
use nalgebra::SVector;
use support::samples::{assert_met, samples, seeded};

const W: f64 = 100.0;
const MU: f64 = 0.5;
const K: f64 = 1e6;
const GAP: f64 = 1e-3;

/// Feet at these places under the block. The last axis is normal.
fn feet<const C: usize>(places: &[[f64; C]], scale: f64) -> Vec<Contact<C>> {
    let mut up = [0.0; C];
    up[C - 1] = 1.0;
    let stiffness = K / places.len() as f64 * scale;
    let foot = |at: &[f64; C]| Contact::new(*at, up).series_stiffness(stiffness, stiffness).friction(MU);
    places.iter().map(foot).collect()
}

fn stop<const C: usize>(normal: [f64; C], gap: f64) -> Contact<C> {
    Contact::new([0.0; C], normal).series_stiffness(K, K).clearance(gap)
}

fn load<const C: usize>(force: [f64; C]) -> Wrench<C> {
    Wrench::from_components(&padded(&force))
}

fn padded<const C: usize>(force: &[f64; C]) -> Vec<f64> {
    let mut components = vec![0.0; if C == 2 { 3 } else { 6 }];
    components[..C].copy_from_slice(force);
    components
}

fn weight<const C: usize>() -> Wrench<C> {
    let mut down = [0.0; C];
    down[C - 1] = -W;
    load(down)
}

/// Events under the weight and a growing pull along x, and the forces at the end.
fn pulled<const C: usize>(grasp: &Grasp<C>, pull: f64) -> (Vec<Event<C>>, Vec<SVector<f64, C>>) {
    let mut along = [0.0; C];
    along[0] = pull;
    let mut path = grasp.follow(weight(), &[Leg::load_by(load(along))]).unwrap();
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let balance = path.energies()[0].residual();
    assert!(balance < 1e-12, "{balance}");
    (events, path.forces())
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * b.abs(), "{a} is not {b}");
}

/// A block that is pulled to a stop along x.
fn slides_to_a_stop<const C: usize>(places: &[[f64; C]], settings: &Settings, exact: f64) {
    let mut back = [0.0; C];
    back[0] = -1.0;
    let contacts = feet(places, 1.0).into_iter().chain([stop(back, GAP)]);
    let grasp = Grasp::new(contacts).unwrap().with(settings);
    let (events, forces) = pulled(&grasp, 80.0);
    let slides = events.iter().find(|event| event.jump.is_some()).expect("it slides");
    near(slides.fraction, MU * W / 80.0);
    let feet = 0..places.len();
    let starts = slides.changes.iter().filter(|change| matches!(change.what, Change::Slides { .. }));
    assert_eq!(
        starts.map(|change| change.contact.index).collect::<Vec<_>>(),
        feet.clone().collect::<Vec<_>>()
    );
    let jump = slides.jump.as_ref().unwrap();
    assert_eq!(jump.reaches.len(), 1);
    assert_eq!(jump.reaches[0].index, places.len());
    let way = GAP - MU * W / K;
    near(jump.moved[0].twist.components()[0], way);
    jump.slips.iter().for_each(|slip| near(slip.slip.norm(), way));
    near(jump.energy_lost, MU * W * way);
    assert!(jump.state.residuals.worst() < 1e-12);
    let stop = forces[places.len()];
    assert!((stop[0] - (80.0 - MU * W)).abs() < exact, "{stop}");
    assert!(stop.rows(1, C - 1).norm() == 0.0);
    let friction: f64 = feet.map(|i| forces[i].rows(1, C - 1).norm()).sum();
    assert!((friction - MU * W).abs() < exact, "{friction}");
}

#[test]
fn a_block_slides_to_a_stop_in_the_plane() {
    slides_to_a_stop(&[[-0.1, 0.0], [0.1, 0.0]], &Settings::default(), 1e-9);
    slides_to_a_stop(&[[-0.1, 0.0], [0.0, 0.0], [0.1, 0.0]], &Settings::default(), 1e-9);
}

#[test]
fn a_block_slides_to_a_stop_in_space() {
    let places = [[-0.1, -0.1, 0.0], [0.1, -0.1, 0.0], [-0.1, 0.1, 0.0], [0.1, 0.1, 0.0]];
    slides_to_a_stop(&places, &Settings::default(), 1e-6);
    slides_to_a_stop(&places, &Settings::default().on_the_polygon(), 1e-9);
}

/// Friction falls to the kinetic coefficient 0.3 when the feet slide. The stop carries the difference at once.
#[test]
fn a_stop_takes_what_friction_loses() {
    let feet = feet(&[[-0.1, 0.0], [0.1, 0.0]], 1.0).into_iter().map(|foot| foot.kinetic(0.3));
    let grasp = Grasp::new(feet.chain([stop([-1.0, 0.0], GAP)])).unwrap();
    let (events, _) = pulled(&grasp, 60.0);
    let slides = events.iter().find(|event| event.jump.is_some()).expect("it slides");
    near(slides.fraction, MU * W / 60.0);
    let jump = slides.jump.as_ref().unwrap();
    assert_eq!(jump.reaches[0].index, 2);
    near(jump.state.contacts[2].force[0], MU * W - 0.3 * W);
    // The springs of the feet relax by the lost friction, and the stop is compressed by its force.
    near(jump.moved[0].twist.components()[0], GAP - MU * W / K + (MU * W - 0.3 * W) / K);
}

/// Free motions that end at another gap: at a ceiling, at one wall and then at another, and at a stop for a body under another body.
#[test]
fn other_free_motions_end_at_a_gap_too() {
    let feet_of_two = || feet(&[[-0.1, 0.0], [0.1, 0.0]], 1.0).into_iter();
    let ceiling = |x: f64| Contact::new([x, 0.2], [0.0, -1.0]).series_stiffness(K, K).clearance(GAP);
    let lifted = Grasp::new(feet_of_two().chain([ceiling(-0.1), ceiling(0.1)])).unwrap();
    let mut path = lifted.follow(weight(), &[Leg::load_by(load([0.0, 150.0]))]).unwrap();
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)));
    let jump = events.iter().find_map(|event| event.jump.as_ref()).expect("it lifts off");
    assert_eq!(jump.reaches.len(), 2);
    near(jump.moved[0].twist.components()[1], GAP);
    path.forces()[2..].iter().for_each(|force| near(force[0], 25.0));

    // The block tips about its right foot at 25 N and then leans on the wall at height 0.5.
    let wall = Contact::new([0.1, 0.5], [-1.0, 0.0]).series_stiffness(K, K).clearance(GAP);
    let tipped = Grasp::new(feet_of_two().chain([wall])).unwrap();
    let high = Wrench::<2>::new([45.0, 0.0], -45.0 * 0.4);
    let mut path = tipped.follow(weight(), &[Leg::load_by(high)]).unwrap();
    let events = path.run();
    let tips = events.iter().find(|event| event.jump.is_some()).expect("it tips");
    near(tips.fraction * 45.0, 25.0);
    near(path.forces()[2][0], (45.0 * 0.4 - W * 0.1) / 0.5);
}

/// Stops that do not end the free motion: one behind the block, one too far away for small motions, and one that the motion does not approach.
#[test]
fn a_gap_that_does_not_close_on_a_small_way_holds_nothing() {
    for (normal, gap) in [([1.0, 0.0], GAP), ([-1.0, 0.0], 0.03), ([0.0, -1.0], GAP)] {
        let contacts = feet(&[[-0.1, 0.0], [0.1, 0.0]], 1.0).into_iter().chain([stop(normal, gap)]);
        let grasp = Grasp::new(contacts).unwrap();
        let mut path = grasp.follow(weight(), &[Leg::load_by(load([80.0, 0.0]))]).unwrap();
        assert!(path.run().iter().all(|event| event.jump.is_none()));
        let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{:?}", path.end()) };
        assert_ne!(loss.kind, LossKind::Fold);
        near(loss.load.components()[0], MU * W);
    }
}

/// For random blocks and stops, closed contacts keep their forces during a free motion, no gap becomes negative, and the work of the load equals the
/// friction heat. The motion is proportional to the gaps, and the mirror image has the mirrored motion.
#[test]
fn nothing_but_friction_works_on_the_way() {
    let mut random = seeded(7);
    let (mut ways, mut opened) = (0, 0);
    for _ in 0..samples(60) {
        let mut number = |from: f64, to: f64| from + (to - from) * random.uniform();
        let feet: Vec<(f64, f64, f64)> = (0..3)
            .map(|i| (0.1 * (f64::from(i) - 1.0) + number(-0.04, 0.04), number(1e5, 1e6), number(0.2, 0.6)))
            .collect();
        let stops: Vec<(f64, f64, f64, f64)> = (0..3)
            .map(|_| (number(-0.1, 0.1), number(0.0, 0.3), number(-1.5, 1.5), number(1e-4, 2e-3)))
            .collect();
        let (pull, height) = (number(40.0, 90.0), number(0.0, 0.3));
        let told = |mirror: f64, scale: f64| {
            let feet = feet.iter().map(|(x, k, mu)| {
                let (k, mu) = (*k / scale, *mu);
                Contact::new([mirror * x, 0.0], [0.0, 1.0]).series_stiffness(k, k).friction(mu)
            });
            let stops = stops.iter().map(|(x, y, angle, gap)| {
                let (sin, cos) = angle.sin_cos();
                let stop = Contact::new([mirror * x, *y], [-mirror * cos, sin])
                    .series_stiffness(K / scale, K / scale);
                stop.clearance(gap * scale)
            });
            let grasp = Grasp::new(feet.chain(stops)).unwrap();
            let pulled = Wrench::<2>::new([mirror * pull, 0.0], -mirror * pull * height);
            let mut path = grasp.follow(weight(), &[Leg::load_by(pulled)]).unwrap();
            path.run()
        };
        let events = told(1.0, 1.0);
        let others = [told(-1.0, 1.0), told(1.0, 0.5)];
        for (k, event) in events.iter().enumerate() {
            // If the object snaps over, the damping of the motion takes up work in addition to friction, so the balance is not checked.
            let Some(jump) = event.jump.as_ref().filter(|jump| !jump.snaps) else { continue };
            ways += 1;
            let heat: f64 = jump
                .slips
                .iter()
                .map(|slip| jump.state.contacts[slip.contact.index].force.dot(&slip.slip))
                .sum();
            assert!(
                (heat - jump.energy_lost).abs() <= 1e-9 * event.load.components()[0].abs() * 1e-3,
                "{heat} {}",
                jump.energy_lost
            );
            for (i, (before, after)) in event.state.contacts.iter().zip(&jump.state.contacts).enumerate() {
                assert!(
                    (before.force - after.force).norm() <= 1e-9 * W,
                    "{i}: {} {}",
                    before.force,
                    after.force
                );
                let closes = jump.reaches.iter().any(|reached| reached.index == i);
                assert!(
                    closes == (before.state == ContactState::Separated && after.gap <= 1e-15),
                    "{i}: {jump}"
                );
                opened += usize::from(after.gap > before.gap && before.gap == 0.0);
            }
            for (other, (mirror, scale)) in others.iter().zip([(-1.0, 1.0), (1.0, 0.5)]) {
                let there = other[k].jump.as_ref().expect("the same story");
                let ([x, y], [u, v]) =
                    (jump.moved[0].twist.translation(), there.moved[0].twist.translation());
                assert!((u - mirror * scale * x).abs() <= 1e-9 * GAP && (v - scale * y).abs() <= 1e-9 * GAP);
                assert_eq!(jump.reaches, there.reaches);
            }
        }
    }
    assert_met(&[(ways, 20), (opened, 3)]);
}
