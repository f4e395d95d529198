//! Load paths do not depend on the description of the scene: on units of length and force, on the frame and its handedness, on the order of contacts,
//! or on a contact split into two of half the stiffness. Events have the same fractions, contacts and directions, and the end is the same. Random
//! programs in the plane and in space confirm this.

use std::mem::discriminant;

use grasp_lcp::equilibrium::{ContactAnswer, Outcome};
use grasp_lcp::load_path::{Beyond, Event, LoadPath, PathEnd};
use nalgebra::SVector;
use proptest::prelude::*;
use support::programs::draw::{over, planar_scenes, spatial_scenes};
use support::programs::tally::Tally;
use support::programs::views::View;
use support::programs::{Scene, direction};
use support::programs::{changes, numbers};
use support::samples::assert_met;

/// Tolerance of the fractions of legs at which events occur.
const FRACTION: f64 = 1e-12;

fn told<const C: usize>(events: &[Event<C>], path: &LoadPath<'_, C>) -> String {
    let all: Vec<_> = events.iter().map(|e| (e.leg, e.fraction, &e.changes)).collect();
    format!("{all:?} {:?}", path.end())
}

/// Checks that another description of the scene has the same events: contact i of the scene corresponds to the contacts `contacts[i]`, and
/// directions are transformed by the view.
fn tells_the_same<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    other: &Scene<D, C>,
    contacts: &[Vec<usize>],
    view: &View<C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let (grasp, there) = (scene.grasp(), other.grasp());
    let asked = grasp.with(&support::programs::polygon());
    let mut path = asked.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let asked = there.with(&support::programs::polygon());
    let mut path_there = asked.follow(other.start(), &other.legs()).unwrap();
    let events_there = path_there.run();
    let both = format!("{}\nagainst\n{}", told(&events, &path), told(&events_there, &path_there));
    // If several starting equilibria or continuations exist, the choice may depend on the description.
    let starts = [grasp.solve(scene.start()).unwrap(), there.solve(other.start()).unwrap()];
    if let [Some(a), Some(b)] = starts.each_ref().map(Outcome::equilibrium) {
        let same = |(i, c): (usize, &ContactAnswer<C>)| {
            let force = contacts[i].iter().fold(SVector::zeros(), |sum, &j| sum + b.contacts[j].force_world);
            let kinds =
                contacts[i].iter().all(|&j| discriminant(&b.contacts[j].state) == discriminant(&c.state));
            kinds && (view.direction(&c.force_world) - force / view.force).norm() <= 1e-9 * scene.press()
        };
        if !a.contacts.iter().enumerate().all(same) {
            return Ok(());
        }
    }
    // In space, the solver may find the equilibrium at the start for one order of contacts and leave it undecided for another.
    let undecided = |end: Option<&PathEnd<C>>| matches!(end, Some(PathEnd::NoStart(why)) if matches!(**why, Outcome::Undecided(_)));
    if C == 3 && (undecided(path.end()) || undecided(path_there.end())) {
        return Ok(());
    }
    if events.iter().any(|e| e.other_continuations != Some(0)) {
        return Ok(());
    }
    prop_assert_eq!(events.len(), events_there.len(), "{}", both);
    for (a, b) in events.iter().zip(&events_there) {
        prop_assert!(
            a.leg == b.leg && (a.fraction - b.fraction).abs() <= FRACTION,
            "{:e} {both}",
            a.fraction - b.fraction
        );
        let known = changes(a);
        let mut expected: Vec<_> =
            known.iter().flat_map(|(i, change)| contacts[*i].iter().map(move |j| (*j, change))).collect();
        expected.sort_by_key(|(j, _)| *j);
        prop_assert_eq!(expected.len(), b.changes.len(), "{}", both);
        for ((j, x), (i, y)) in expected.iter().zip(&changes(b)) {
            prop_assert!(j == i && discriminant(*x) == discriminant(y), "{both}");
            if let (Some(x), Some(y)) = (direction(x), direction(y)) {
                let apart = (view.direction(&x) - y).norm();
                prop_assert!(apart <= 1e-9, "{apart:e} {both}");
            }
        }
        prop_assert_eq!(a.free_motions.len(), b.free_motions.len(), "{}", both);
    }
    let ends = [path.end(), path_there.end()];
    prop_assert!(ends[0].map(discriminant) == ends[1].map(discriminant), "{both}");
    // With too many contacts the library seeks no equilibrium beyond a loss.
    let beyond = [path.beyond(), path_there.beyond()];
    let unsearched = beyond.iter().any(|beyond| matches!(beyond, Some(Beyond::Ends { .. })));
    let alike = beyond[0].as_ref().map(discriminant) == beyond[1].as_ref().map(discriminant);
    prop_assert!(alike || unsearched, "{beyond:?} {both}");
    if let [Some(a), Some(b)] = ends.map(|end| end.and_then(PathEnd::loss)) {
        prop_assert_eq!(a.kind, b.kind, "{}", both);
        prop_assert!(a.leg == b.leg && (a.fraction - b.fraction).abs() <= FRACTION, "{both}");
        let mut expected: Vec<_> = a.contacts.iter().flat_map(|i| contacts[i.index].clone()).collect();
        expected.sort_unstable();
        prop_assert_eq!(expected, numbers(&b.contacts), "{}", both);
        prop_assert_eq!(a.motion.is_some(), b.motion.is_some(), "{}", both);
    }
    tally.checked += events.len();
    Ok(())
}

/// The correspondence of contacts if each contact of the scene is a single contact of the other description.
fn each<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Vec<Vec<usize>> {
    (0..scene.spots.len()).map(|i| vec![i]).collect()
}

fn seen<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    view: &View<C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    tells_the_same(scene, &view.scene(scene), &each(scene), view, tally)
}

/// A view of the scene in other units of length and force: powers of 4, whose roots are exact, or powers of ten.
fn units<const C: usize>(ten: bool, [length, force]: [i32; 2]) -> View<C> {
    let base = if ten { 10.0_f64 } else { 4.0 };
    View::in_units(base.powi(length), base.powi(force))
}

fn order(keys: &[f64], contacts: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..contacts).collect();
    order.sort_by(|&i, &j| keys[i].total_cmp(&keys[j]));
    order
}

fn reordered<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    keys: &[f64],
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let order = order(keys, scene.spots.len());
    let contacts = (0..order.len()).map(|i| order.iter().position(|&j| j == i).into_iter().collect());
    let contacts: Vec<_> = contacts.collect();
    tells_the_same(scene, &scene.reordered(&order), &contacts, &View::in_units(1.0, 1.0), tally)
}

fn halved<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    which: usize,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let which = which % scene.spots.len();
    let mut contacts = each(scene);
    contacts[which].push(scene.spots.len());
    tells_the_same(scene, &scene.halved(which), &contacts, &View::in_units(1.0, 1.0), tally)
}

/// Tests each description on planar and on spatial scenes.
macro_rules! in_plane_and_space {
    ($($name:ident: $other:expr, $property:expr;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn in_the_plane() {
                let t = over(75, &(planar_scenes(), $other), |(scene, other), tally| $property(&scene, other, tally));
                println!("{t:?}");
                assert_met(&[(t.checked, 87)]);
            }

            #[test]
            fn in_space() {
                let t = over(18, &(spatial_scenes(), $other), |(scene, other), tally| $property(&scene, other, tally));
                println!("{t:?}");
                assert_met(&[(t.checked, 8)]);
            }
        }
    )*};
}

in_plane_and_space! {
    binary_units: [-8..8_i32, -8..8_i32], |scene: &Scene<_, _>, by, tally: &mut _| seen(scene, &units(false, by), tally);
    decimal_units: [-6..7_i32, -6..7_i32], |scene: &Scene<_, _>, by, tally: &mut _| seen(scene, &units(true, by), tally);
    frames: ([-3.0..3.0_f64, -3.0..3.0, -3.0..3.0], [-2.0..2.0_f64, -2.0..2.0, -2.0..2.0]),
        |scene: &Scene<_, _>, (angles, shift), tally: &mut _| seen(scene, &View::moved(angles, shift), tally);
    mirrors: Just(()), |scene: &Scene<_, _>, (), tally: &mut _| seen(scene, &View::mirrored(), tally);
    order_of_contacts: prop::collection::vec(0.0..1.0_f64, 8),
        |scene: &Scene<_, _>, keys: Vec<f64>, tally: &mut _| reordered(scene, &keys, tally);
    halved_contacts: 0..60_usize, |scene: &Scene<_, _>, which, tally: &mut _| halved(scene, which, tally);
}
