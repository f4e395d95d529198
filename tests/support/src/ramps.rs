//! Random ramps of load and finger commands, and an oracle for the factor of first slip: the slack of all sticking conditions, without the library.

use std::cell::Cell;
use std::f64::consts::TAU;

use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Departure, Onset, Ramp};
use nalgebra::SVector;
use proptest::prelude::*;

use super::random::{Spread, for_all, scene};
use super::samples::samples;
use super::scene::{Datum, Scene};
use super::sticking;

/// Number of corners of the friction polygon in space, as by default in the library.
pub const FACETS: usize = 8;

/// The change of load and commands per unit of the factor. The scene itself is the base.
#[derive(Debug, Clone)]
pub struct Change<const D: usize, const C: usize> {
    /// Change of the load per unit of the factor.
    pub load: SVector<f64, D>,
    /// Change of the commands per unit of the factor, contact by contact.
    pub commands: Vec<SVector<f64, C>>,
}

impl<const D: usize, const C: usize> Change<D, C> {
    /// The ramp that begins at the scene.
    pub fn ramp(&self, scene: &Scene<D, C>) -> Ramp<C> {
        Ramp::load(scene.wrench(), Wrench::from_components(self.load.as_slice()))
            .with_commands(self.commands.clone())
    }

    /// Whether the change of load does work along a motion that no contact resists. If so, no equilibrium exists beyond factor 0.
    pub fn works_on_free_motion(&self, scene: &Scene<D, C>) -> bool {
        sticking::forces(&Scene { load: self.load, ..scene.clone() }).is_none()
    }

    /// The scene at a factor.
    pub fn at(&self, scene: &Scene<D, C>, factor: f64) -> Scene<D, C> {
        let mut there = scene.clone();
        there.load += self.load * factor;
        for (datum, change) in there.contacts.iter_mut().zip(&self.commands) {
            datum.command += change * factor;
        }
        there
    }
}

/// The friction cone of an oracle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Friction {
    /// The round cone. In the plane this is Coulomb's cone of two edges.
    Round,
    /// The polygon with [`FACETS`] corners on the circle.
    Polygon,
}

/// The least slack of all sticking conditions, relative to the largest force of the scene. It is negative if some contact cannot stick.
/// `None` if the load works on a free motion.
pub fn slack<const D: usize, const C: usize>(scene: &Scene<D, C>, friction: Friction) -> Option<f64> {
    let forces = sticking::forces(scene)?;
    // If all forces vanish, the force of the softest spring under the largest command is the scale.
    let softest = scene.contacts.iter().map(Datum::softest).fold(f64::INFINITY, f64::min);
    let command = scene.contacts.iter().map(|datum| datum.command.norm()).fold(0.0, f64::max);
    let size = forces.iter().map(SVector::norm).fold(softest * command, f64::max);
    let each = scene.contacts.iter().zip(&forces).map(|(datum, f)| {
        if datum.friction == 0.0 || datum.friction.is_infinite() {
            return f[0];
        }
        let used = if C == 2 || friction == Friction::Round {
            f.rows_range(1..).norm()
        } else {
            // A facet normal lies half way between two corners.
            let half = TAU / (2.0 * FACETS as f64);
            let along = |j: usize| {
                let angle = half * (2 * j + 1) as f64;
                (f[1] * angle.cos() + f[2] * angle.sin()) / half.cos()
            };
            (0..FACETS).map(along).fold(0.0, f64::max)
        };
        f[0].min((datum.friction * f[0] - used) / (1.0 + datum.friction))
    });
    Some(each.fold(f64::INFINITY, f64::min) / size)
}

/// Counts of answers about the first slip along a ramp, by kind.
#[derive(Debug, Default)]
pub struct Tally {
    /// A contact slides.
    pub slides: Cell<usize>,
    /// Contacts open, and none slides.
    pub opens: Cell<usize>,
    /// All contacts stick at every factor.
    pub never: Cell<usize>,
}

impl Tally {
    /// Counts an answer about first slip by its kind.
    pub fn count<const C: usize>(&self, onset: &Onset<C>) {
        let add = |cell: &Cell<usize>, yes: bool| cell.set(cell.get() + usize::from(yes));
        add(&self.never, matches!(onset, Onset::Never));
        if let Onset::At(event) = onset {
            let slides = event.leaving.iter().any(|l| matches!(l.how, Departure::Slides { .. }));
            add(&self.slides, slides);
            add(&self.opens, !slides);
        }
    }

    /// Asserts that at least these numbers of answers of each kind were counted, times the factor `GRASP_LCP_SAMPLES`.
    pub fn assert_at_least(&self, slides: usize, opens: usize, never: usize) {
        println!("{self:?}");
        let met = [self.slides.get(), self.opens.get(), self.never.get()];
        let enough = met.into_iter().zip([slides, opens, never]).all(|(met, least)| met >= samples(least));
        assert!(enough, "{self:?}");
    }
}

/// Whether a and b are equal within 1e-9 of the larger.
pub fn close(a: f64, b: f64) -> bool {
    a == b || (a.is_finite() && b.is_finite() && (a - b).abs() <= 1e-9 * a.abs().max(b.abs()))
}

/// The quantity that changes along the ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Driven {
    Load,
    Commands,
    Both,
}

/// Random scenes in which all contacts touch, with a change of load or commands.
pub fn ramps<const D: usize, const C: usize>(
    counts: std::ops::Range<usize>,
    spread: Spread,
) -> impl Strategy<Value = (Scene<D, C>, Change<D, C>)> {
    let vector = |n: usize| prop::collection::vec(-1.0..1.0_f64, n);
    let driven = prop::sample::select(vec![Driven::Load, Driven::Commands, Driven::Both]);
    (scene::<D, C>(counts, spread, 0.05), vector(D), vector(5 * C), driven).prop_map(
        |(mut scene, load, commands, driven)| {
            // All contacts touch at the base.
            scene.contacts.iter_mut().for_each(|datum| datum.clearance = 0.0);
            // The change of load is as large as the base load, so that neither is negligible compared with the other.
            let size = scene.load.norm();
            let (load_part, command_part) = match driven {
                Driven::Load => (size, 0.0),
                Driven::Commands => (0.0, 0.1),
                Driven::Both => (size, 0.1),
            };
            let commands = commands.chunks(C).take(scene.contacts.len());
            let change = Change {
                load: SVector::from_vec(load) * load_part,
                commands: commands.map(|c| SVector::from_column_slice(c) * command_part).collect(),
            };
            (scene, change)
        },
    )
}

/// Number of random ramps for each spread of stiffness.
pub const CASES: usize = 500;

/// Runs a property on ramps of grasps with similar springs and with very different springs.
pub fn for_both<const D: usize, const C: usize>(
    source_file: &'static str,
    counts: &std::ops::Range<usize>,
    property: impl Fn(&Scene<D, C>, &Change<D, C>, &Tally) -> Result<(), TestCaseError>,
) -> Tally {
    let tally = Tally::default();
    for spread in [Spread::Narrow, Spread::Wide] {
        for_all(source_file, CASES, &ramps::<D, C>(counts.clone(), spread), |(s, change)| {
            property(&s, &change, &tally)
        });
    }
    tally
}
