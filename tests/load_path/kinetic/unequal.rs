//! Jumps are followed if several contacts start to slide at one load and their friction falls by different amounts. The scenes are symmetric grasps.

use std::panic::{AssertUnwindSafe, catch_unwind};

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Change, Leg, PathEnd};
use grasp_lcp::{ask, planar, spatial};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// Small integers, which are often zero or equal.
fn grid<const N: usize>(random: &mut Random, most: i64) -> [f64; N] {
    std::array::from_fn(|_| random.integer(-most, most) as f64)
}

/// A contact on a face of the square, or of the cube, of edge 2, with static and kinetic friction.
fn contact<const C: usize>(random: &mut Random) -> grasp_lcp::grasp::Contact<C> {
    let (axis, side) = (random.index(0, C - 1), random.integer(0, 1) as f64 * 2.0 - 1.0);
    let (mut point, mut normal) = (grid(random, 1), [0.0; C]);
    (point[axis], normal[axis]) = (side, -side);
    let stiffness = [1000.0, 1000.0, 500.0, 2000.0][random.index(0, 3)];
    let rest = [0.6, 0.6, 0.4][random.index(0, 2)];
    let contact = grasp_lcp::grasp::Contact::new(point, normal)
        .series_stiffness(stiffness, stiffness)
        .friction(rest)
        .pressed_with([10.0, 10.0, 5.0, 0.0][random.index(0, 3)]);
    let kinetic = [1.0, 5.0 / 6.0, 2.0 / 3.0, 0.5, 0.0][random.index(0, 4)];
    if kinetic == 1.0 { contact } else { contact.kinetic(rest * kinetic) }
}

/// Forces below this value are treated as zero, for fingers that press with a few newtons (N).
const NOTHING: f64 = 1e-12;

/// Whether every force is in the cone of static friction and forces balance. Without normal forces the remaining forces are rounding.
fn obeys<const C: usize>(grasp: &ask::Grasp<C>, state: &Equilibrium<C>) -> bool {
    let largest = state.largest_force();
    let inside = grasp.contacts().iter().zip(&state.contacts).all(|(contact, answer)| {
        let most = contact.friction_coefficient() * answer.normal_force();
        answer.normal_force() >= -1e-12 * largest && answer.friction_force() - most <= 1e-9 * largest
    });
    largest <= NOTHING || inside && state.residuals.worst() <= 1e-10
}

/// Counts of jumps in which several contacts begin to slide, and of undecided paths.
#[derive(Debug, Default)]
struct Tally {
    together: usize,
    undecided: usize,
}

fn followed<const C: usize>(
    tally: &mut Tally,
    contacts: Vec<grasp_lcp::grasp::Contact<C>>,
    [start, more]: [Wrench<C>; 2],
) {
    let Ok(grasp) = ask::Grasp::new(contacts) else { return };
    let legs = Leg::there_and_back(more);
    let mut path = grasp.follow(start, &legs).unwrap();
    for event in path.run() {
        let slides =
            |change: &Change<C>| matches!(change, Change::Slides { .. } | Change::ClosesSliding { .. });
        let Some(jump) = &event.jump else { continue };
        let begin = event.changes.iter().chain(&jump.changes).filter(|change| slides(&change.what)).count();
        tally.together += usize::from(begin > 1);
        assert!(obeys(&grasp, &jump.state), "{jump:?}");
    }
    tally.undecided += usize::from(matches!(path.end(), Some(PathEnd::Undecided { .. })));
    grasp.hold(grasp_lcp::load_path::Ramp::load(start, more)).unwrap();
}

fn all<const C: usize>(count: usize, mut scene: impl FnMut(&mut Tally, &mut Random)) {
    let (mut tally, mut panicked) = (Tally::default(), Vec::new());
    for number in 0..samples(count) {
        let mut random = seeded(62 << 16 ^ number as u64);
        random.bits();
        if catch_unwind(AssertUnwindSafe(|| scene(&mut tally, &mut random))).is_err() {
            panicked.push(number);
        }
    }
    println!("in {C} dimensions: {tally:?}");
    assert!(panicked.is_empty(), "scenes {panicked:?} panic");
    assert!(tally.together > samples(count) / 100, "{tally:?}");
}

#[test]
fn unequal_friction_of_sliding_is_followed_in_the_plane() {
    all::<2>(150, |tally, random| {
        let contacts = (0..random.index(2, 5)).map(|_| contact::<2>(random)).collect();
        let loads =
            [0, 6].map(|most| planar::Wrench::new(grid(random, most), random.integer(-most, most) as f64));
        followed(tally, contacts, loads.map(|load| load * 5.0));
    });
}

#[test]
fn unequal_friction_of_sliding_is_followed_in_space() {
    all::<3>(50, |tally, random| {
        let contacts = (0..random.index(3, 6)).map(|_| contact::<3>(random)).collect();
        let loads = [0, 6].map(|most| spatial::Wrench::new(grid(random, most), grid(random, most)));
        followed(tally, contacts, loads.map(|load| load * 5.0));
    });
}

/// Two fingers on the left, whose kinetic coefficient is 0.5, and one on the right, with 0.4, hold a plate under a moment M. The plate turns by θ and
/// moves by y = θ/3, with `16 θ/3 = M/1000 - 0.04/3`. The first finger slides where `2θ/3 = 0.6 (0.02/3 - 2θ/3)`, at M = 100/3 N m.
#[test]
fn a_turned_plate_slips_and_is_caught() {
    let finger = |x: f64, y: f64, kinetic: f64| {
        planar::Contact::new([x, y], [-x, 0.0])
            .series_stiffness(1000.0, 1000.0)
            .friction(0.6)
            .kinetic(kinetic)
            .pressed_with(10.0)
    };
    let grasp = planar::Grasp::new([finger(-1.0, -1.0, 0.5), finger(-1.0, 1.0, 0.5), finger(1.0, -1.0, 0.4)]);
    let grasp = grasp.unwrap();
    let turned = planar::Wrench::new([0.0; 2], 40.0);
    let events = grasp.follow(planar::Wrench::ZERO, &[Leg::load_by(turned)]).unwrap().run();
    let jump = events[0].jump.as_ref().unwrap();
    assert!(obeys(&grasp, &jump.state), "{jump:?}");
    assert!((events[0].fraction * 40.0 - 100.0 / 3.0).abs() < 1e-12, "{}", events[0].fraction);
}
