//! Random grasps in the plane and in space, with loads that they can often carry.

use nalgebra::SVector;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, FileFailurePersistence};

use super::samples::{config, runner, samples};
use super::scene::{Datum, Scene, displacement, wrench};

/// How stiffnesses and friction coefficients are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// Stiffness 1 to 20, friction 0.2 to 1.5: most contacts stick.
    Narrow,
    /// Stiffness 1 to 1e6; friction zero, tiny, ordinary, huge or infinite.
    Wide,
    /// Stiffness 1 to 1e14, independent for each axis; friction zero, 1e-8 to 1e6, or infinite.
    Stiff,
}

/// A vector with components in [-1, 1].
fn vector<const N: usize>() -> impl Strategy<Value = SVector<f64, N>> {
    prop::collection::vec(-1.0..1.0_f64, N).prop_map(SVector::from_vec)
}

fn stiffness<const C: usize>(spread: Spread) -> impl Strategy<Value = SVector<f64, C>> {
    let decades = match spread {
        Spread::Narrow => 1.3,
        Spread::Wide => 6.0,
        Spread::Stiff => 14.0,
    };
    prop::collection::vec((0.0..decades).prop_map(|e| 10_f64.powf(e)), C).prop_map(SVector::from_vec)
}

fn friction(spread: Spread) -> BoxedStrategy<f64> {
    match spread {
        Spread::Narrow => (0.2..1.5).boxed(),
        Spread::Wide => prop_oneof![
            1 => Just(0.0),
            1 => Just(1e-7),
            5 => 0.05..2.0,
            1 => Just(1e6),
            1 => Just(f64::INFINITY),
        ]
        .boxed(),
        Spread::Stiff => prop_oneof![
            1 => Just(0.0),
            6 => 0.05..2.0,
            4 => (-8.0..6.0_f64).prop_map(|e| 10_f64.powf(e)),
            1 => Just(f64::INFINITY),
        ]
        .boxed(),
    }
}

/// A contact at a distance of 0.5 to 1.4 from the origin. Its normal points inward within some 40 degrees, and its command pushes.
pub fn datum<const C: usize>(spread: Spread) -> impl Strategy<Value = Datum<C>> {
    let clearance = prop_oneof![6 => Just(0.0), 1 => 0.0..0.3];
    (
        vector::<C>(),
        vector::<C>(),
        vector::<C>(),
        stiffness(spread),
        friction(spread),
        vector::<C>(),
        clearance,
    )
        .prop_filter("a direction needs a length", |(point, ..)| point.norm() > 0.1)
        .prop_map(|(point, tilt, tangent, stiffness, friction, command, clearance)| {
            let point = point * (0.5 + 0.5 / point.norm());
            let normal = tilt * 0.7 - point.normalize();
            // The tangent must not be nearly parallel to the normal: its projection would lose digits in the oracle, too.
            let across = normal.map_with_location(|a, _, x| if a == normal.iamin() { x + 1.0 } else { x });
            let tangent =
                if tangent.normalize().dot(&normal.normalize()).abs() < 0.9 { tangent } else { across };
            let mut command = command * 0.2;
            command[0] += 0.2;
            Datum { point, normal, tangent, stiffness, friction, command, clearance }
        })
}

/// The load that is balanced at this twist if each contact has its elastic force, with friction reduced to its limit.
fn balancing_load<const D: usize, const C: usize>(
    contacts: &[Datum<C>],
    twist: &SVector<f64, D>,
) -> SVector<f64, D> {
    contacts.iter().fold(SVector::zeros(), |load, datum| {
        let frame = datum.frame();
        let stretch = datum.drive() - frame.tr_mul(&displacement(&datum.point, twist));
        let mut force = datum.stiffness.component_mul(&stretch);
        force[0] = force[0].max(0.0);
        let used = force.rows_range(1..).norm();
        let limit = if force[0] > 0.0 { datum.friction * force[0] } else { 0.0 };
        if used > limit {
            for a in 1..C {
                force[a] *= limit / used;
            }
        }
        load - wrench::<D, C>(&datum.point, &(frame * force))
    })
}

/// Scenes of `count` contacts, under a load of the order of the forces that a twist of size `motion` causes.
pub fn scene<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    spread: Spread,
    motion: f64,
) -> impl Strategy<Value = Scene<D, C>> {
    let contacts = prop::collection::vec(datum::<C>(spread), count);
    (contacts, vector::<D>(), 0.2..1.5_f64).prop_map(move |(contacts, twist, factor)| {
        let load = balancing_load(&contacts, &(twist * motion)) * factor;
        Scene { contacts, load }
    })
}

/// Draws scenes of a strategy, `default` of them unless more samples are requested. The scenes are the same in every run.
pub fn drawn<S: Strategy>(default: usize, strategy: &S) -> Vec<S::Value> {
    let mut runner = runner(config(default));
    let draw = |_| strategy.new_tree(&mut runner).expect("a scene").current();
    (0..samples(default)).map(draw).collect()
}

/// Tests a property on random scenes, by default on this many, the same in every run.
pub fn for_all<S: Strategy>(
    source_file: &'static str,
    default: usize,
    strategy: &S,
    property: impl Fn(S::Value) -> Result<(), TestCaseError>,
) where
    S::Value: std::fmt::Debug,
{
    let persistence = FileFailurePersistence::WithSource("regressions");
    let config = Config {
        failure_persistence: Some(Box::new(persistence)),
        source_file: Some(source_file),
        ..config(default)
    };
    runner(config).run(strategy, property).unwrap_or_else(|failure| panic!("{failure}"));
}
