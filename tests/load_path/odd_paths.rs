//! Irregular programs end with a stated cause, and a state is found at every fraction of every leg before the end. The grasps have fingers at unequal
//! heights and uneven stiffness and friction. The programs have a weight from the start, forces with moments, and fingers that are released and
//! pressed again.

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::load_path::PathEnd;
use nalgebra::SVector;
use support::odd_paths::{IN_SPACE, Odd, OddPath, in_space, in_the_plane};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// Number of requested fractions of each leg.
const ASKED: usize = 40;

fn is_decided<const C: usize>(end: Option<&PathEnd<C>>) -> bool {
    match end {
        Some(PathEnd::NoStart(why)) => !matches!(**why, Outcome::Undecided(_)),
        Some(PathEnd::Undecided { .. }) | None => false,
        _ => true,
    }
}

/// Follows a program and checks Coulomb's law and balance of every state, to the accuracy of the steps. The error is a description of the fault.
fn followed<const C: usize>(odd: &OddPath<C>) -> Result<(), String> {
    let mut path = odd.grasp.follow(odd.start, &odd.legs).unwrap();
    let events = path.run();
    if !is_decided(path.end()) {
        return Err(format!("undecided: {:?} at {:?}", path.end(), path.place()));
    }
    if matches!(path.end(), Some(PathEnd::NoStart(_))) {
        return Ok(());
    }
    // Between a snap and the larger load at which the object rests again, the path has no state. At every other place before the end it has one.
    let has_just_snapped = |place: (usize, f64), last: Option<(usize, f64)>| {
        let before = events.iter().rev().find(|event| (event.leg, event.fraction) < place);
        let snap = before.filter(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps));
        snap.is_some_and(|snap| last.is_none_or(|last| last <= (snap.leg, snap.fraction)))
    };
    let (last, end) = path.place();
    let mut told = Vec::new();
    for leg in 0..odd.legs.len().min(last + 1) {
        let most = if leg == last { end } else { 1.0 };
        for fraction in (0..=ASKED).map(|k| most * (k as f64 / ASKED as f64)) {
            let state = path.state_at(leg, fraction);
            let last = told.last().map(|(leg, fraction, _)| (*leg, *fraction));
            if state.is_some() || !has_just_snapped((leg, fraction), last) {
                told.push((leg, fraction, state.ok_or_else(|| format!("{leg}, {fraction}"))?));
            }
        }
    }
    // If nothing presses, the forces that remain are rounding errors of earlier forces, or of relaxed springs. So tolerances are relative to both.
    let springs = odd
        .grasp
        .contacts()
        .iter()
        .map(|contact| contact.series_stiffness_of_axes()[0] * contact.commanded().norm());
    let forces = told.iter().flat_map(|(.., state)| state.contacts.iter().map(|answer| answer.force.norm()));
    let largest = forces.chain(springs).fold(1e-9, f64::max);
    for (leg, fraction, state) in &told {
        let sum =
            state.contacts.iter().fold(SVector::<f64, C>::zeros(), |sum, answer| sum + answer.force_world);
        let load = SVector::<f64, C>::from_column_slice(&state.load.components()[..C]);
        if (sum + load).norm() > 1e-13 * largest {
            return Err(format!("{leg}, {fraction}: {}", sum + load));
        }
        for (contact, answer) in odd.grasp.contacts().iter().zip(&state.contacts) {
            let (normal, used) = (answer.normal_force(), answer.friction_used());
            let gap = answer.gap;
            if normal < -1e-12 * largest || gap < -1e-12 || used < 0.0 {
                return Err(format!("{leg}, {fraction}: {:?}", (normal, gap, used)));
            }
            let over = answer.friction_force() - contact.friction_coefficient() * normal;
            if over > 1e-10 * largest {
                return Err(format!("{leg}, {fraction}: {over}"));
            }
        }
    }
    Ok(())
}

fn all_are_followed<const C: usize>(name: &str, count: usize, mut draw: impl FnMut() -> OddPath<C>) {
    let mut wrong = 0;
    for number in 0..samples(count) {
        if let Err(fault) = followed(&draw()) {
            println!("{name} {number}: {fault}");
            wrong += 1;
        }
    }
    assert_eq!(wrong, 0, "{name}");
}

#[test]
fn regrasps_are_decided() {
    family_is_decided(IN_SPACE[0]);
}

#[test]
fn what_is_handled_is_decided() {
    family_is_decided(IN_SPACE[1]);
}

#[test]
fn what_is_pushed_is_decided() {
    family_is_decided(IN_SPACE[2]);
}

fn family_is_decided(odd: Odd) {
    let mut random = seeded(11);
    all_are_followed(&format!("{odd:?}"), 100, || in_space(odd, &mut random).unwrap());
}

#[test]
fn odd_paths_in_the_plane_are_decided() {
    let mut random = seeded(12);
    all_are_followed("in the plane", 400, || in_the_plane(&mut random).unwrap());
}

/// A finger pushes an object without normal forces past another finger. The contact of the other finger slides with zero force, so that its direction
/// is undefined.
#[test]
fn what_slides_without_force_is_followed() {
    let mut random = Random(1);
    let handled = (0..3786).map(|_| in_space(IN_SPACE[1], &mut random).unwrap()).last().unwrap();
    followed(&handled).unwrap();
}

/// When the last of three feet begins to slide, the block has almost no resistance. The correction of forces onto the cones then turns the sliding
/// directions so much that second-order terms matter, and it must be repeated.
#[test]
fn what_slides_away_is_on_its_cones() {
    for (seed, number) in [(0x12e, 1863), (912, 297)] {
        followed(&of_a_seed(IN_SPACE[2], seed, number)).unwrap();
    }
}

/// A path of random programs that was once lost or undecided. The seed is the value of `GRASP_LCP_SEED` at which it was found.
fn of_a_seed(odd: Odd, seed: u64, number: usize) -> OddPath<3> {
    let mut random = Random(0xb ^ (seed << 32));
    (0..=number).map(|_| in_space(odd, &mut random).unwrap()).last().unwrap()
}

/// Three fingers take up a load that grows from zero, and a fourth touches without force. The fourth opens, because its direction of friction would
/// be rounding.
#[test]
fn what_rubs_without_force_opens() {
    followed(&of_a_seed(IN_SPACE[1], 902, 749)).unwrap();
}

/// The normal force of a contact nearly vanishes, and the errors of the steps blur its direction of friction. The contact must open.
#[test]
fn what_has_almost_no_force_opens() {
    followed(&of_a_seed(IN_SPACE[0], 901, 589)).unwrap();
}

/// A finger closes and slides. Right after it another finger begins to slide, within the straight step that the first makes from the apex of its
/// cone.
#[test]
fn what_slides_right_after_a_contact_closes_is_seen() {
    for (seed, number) in [(923, 675), (928, 3500)] {
        followed(&of_a_seed(IN_SPACE[0], seed, number)).unwrap();
    }
}

/// Near an asymptote an object slides under a load that is constant up to rounding. The path has a state at its end.
#[test]
fn what_slides_away_has_a_state_at_its_end() {
    for (seed, number) in [(926, 3644), (929, 2710)] {
        followed(&of_a_seed(IN_SPACE[1], seed, number)).unwrap();
    }
}

/// Three fingers without force take up a load, stick and snap over until the end of the leg. Under the load at the end of the leg the object rests.
#[test]
fn what_snaps_over_up_to_the_end_of_a_leg_goes_on() {
    let handled = of_a_seed(IN_SPACE[1], 901, 549);
    let mut path = handled.grasp.follow(handled.start, &handled.legs).unwrap();
    path.run();
    assert!(is_decided(path.end()), "{:?} at {:?}", path.end(), path.place());
}

/// Fingers without force take up a load. Their first forces are larger than rounding of their displacements would cause.
#[test]
fn what_begins_without_force_is_followed() {
    for (seed, number) in [(902, 883), (906, 1380), (908, 510)] {
        let mut random = Random(0xc ^ (seed << 32));
        let loose = (0..=number).map(|_| in_the_plane(&mut random).unwrap()).last().unwrap();
        followed(&loose).unwrap();
    }
}

/// A contact sticks and snaps over again and again within a thousandth of the leg. The object is held far beyond this part of the leg.
#[test]
fn what_sticks_and_snaps_over_again_and_again_is_held() {
    let handled = of_a_seed(IN_SPACE[1], 909, 620);
    let mut path = handled.grasp.follow(handled.start, &handled.legs).unwrap();
    let snaps = path.run().iter().filter(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps)).count();
    let (leg, fraction) = path.place();
    assert!(snaps > 8 && (leg, fraction) > (0, 0.01), "{snaps} {leg} {fraction}");
}

/// No equilibrium exists. A motion is almost free, so that one case of contact states has an equilibrium thousands of kilometres away.
#[test]
fn what_is_nearly_free_is_decided() {
    let odd = of_a_seed(IN_SPACE[0], 2_027_108, 104);
    assert!(matches!(odd.grasp.solve(odd.start), Ok(Outcome::NoEquilibrium(_))));
    followed(&odd).unwrap();
}
