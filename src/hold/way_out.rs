//! How an object leaves: it slides out, tips over, lifts off or turns.

use nalgebra::SVector;

use crate::grasp::{BodyMotion, Contact, Hold, Motion, Twist, WholeContact, WholeContacts, displacement_of};
use crate::numerics::Fixed;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// What moves by less than this part of the fastest stays where it is, and who turns by less does not turn. People round so; nothing is decided by
/// it.
const STAYS: f64 = 0.05;

/// The kind of motion with which an object leaves, as people call it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "way", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum WayOut<const C: usize> {
    /// All contacts that touch open.
    LiftsOff {
        /// Unit direction of the contacts' centroid.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// It moves without turning to speak of.
    SlidesOut {
        /// Unit direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// It turns about contacts that stay, and others open.
    TipsOver {
        /// The contacts that stay.
        about: Vec<WholeContact>,
        /// Those that open.
        opens: Vec<WholeContact>,
    },
    /// It turns about contacts that stay, and others slide.
    TurnsAbout {
        /// The contacts that stay: in space a line goes through two of them.
        about: Vec<WholeContact>,
    },
    /// It turns about a point, in space about a line through it.
    Turns {
        /// A point that moves along the axis at most, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        centre: SVector<f64, C>,
        /// Unit vector along the axis; zero in the plane.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        axis: SVector<f64, C>,
    },
    /// Several bodies move.
    Apart {
        /// Those that do, each with its own way.
        bodies: Vec<BodyWay<C>>,
    },
    /// The lips of suction cups are open all around: their vacuum is gone.
    LetsGo {
        /// The cups.
        cups: Vec<WholeContact>,
    },
    /// The motion is not determined by what gives way.
    NotKnown,
}

/// One of several bodies, and how it moves: [`WayOut::SlidesOut`] or [`WayOut::Turns`].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BodyWay<const C: usize> {
    /// Its name.
    pub body: String,
    /// How it moves.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub way: WayOut<C>,
}

impl<const C: usize> BodyWay<C> {
    fn of(motion: &BodyMotion<C>) -> Self {
        let middle = motion.middle_moves();
        let way = slides_out(&middle, motion.turning_moves())
            .unwrap_or_else(|| turns(&motion.twist, &motion.centre, &middle));
        Self { body: motion.body.to_string(), way }
    }
}

/// A motion along which turning moves nothing to speak of beside this.
fn slides_out<const C: usize>(along: &SVector<f64, C>, spin: f64) -> Option<WayOut<C>> {
    let direction = || along.try_normalize(0.0);
    (spin <= STAYS * along.norm())
        .then(|| direction().map_or(WayOut::NotKnown, |direction| WayOut::SlidesOut { direction }))
}

/// How the object leaves with a motion, seen from the contacts that touch.
pub(super) fn way_out<const C: usize>(
    contacts: &[Contact<C>],
    motion: Option<&Motion<C>>,
    touches: impl Fn(usize) -> bool,
) -> WayOut<C> {
    let Some(motion) = motion else { return WayOut::NotKnown };
    if !motion.bodies.is_empty() {
        let fastest = motion.bodies.iter().map(BodyMotion::speed).fold(0.0, f64::max);
        let moves = motion.bodies.iter().filter(|body| body.speed() > STAYS * fastest);
        return WayOut::Apart { bodies: moves.map(BodyWay::of).collect() };
    }
    let twist = motion.object.coordinates::<Fixed<6>>();
    let velocity = |point: &SVector<f64, C>| displacement_of::<Fixed<6>, C>(point, &twist);
    let parts = WholeContacts::of(contacts);
    let touching = parts.with(&touches);
    let places = parts.mean(&|i| contacts[i].point);
    let moves: Vec<_> = places.iter().map(velocity).collect();
    let part_holds = parts.first(|i| contacts[i].hold);
    let normals = parts.mean(&|i| contacts[i].normal.normalize());
    let count = touching.len().max(1) as f64;
    let centre = touching.iter().fold(SVector::zeros(), |sum, part| sum + places[part.contact] / count);
    let along = velocity(&centre);
    let reach = contacts.iter().map(|contact| (contact.point - centre).norm()).fold(0.0, f64::max);
    let spin = twist.iter().skip(C).map(|x| x * x).sum::<f64>().sqrt() * reach;
    let fastest = touching.iter().map(|part| moves[part.contact].norm()).fold(spin, f64::max);
    let stays = |part: &WholeContact| moves[part.contact].norm() <= STAYS * fastest;
    let opens = |part: &WholeContact| {
        // Away from the finger at more than half a right angle to its surface.
        let (v, n) = (&moves[part.contact], &normals[part.contact]);
        let may_open = part_holds[part.contact] == Hold::Unilateral;
        may_open && !stays(part) && v.dot(n) > 0.5f64.sqrt() * v.norm() * n.norm()
    };
    if !touching.is_empty() && touching.iter().all(opens) {
        return WayOut::LiftsOff { direction: along.try_normalize(0.0).unwrap_or_else(SVector::zeros) };
    }
    if let Some(way) = slides_out(&along, spin) {
        return way;
    }
    let about: Vec<_> = touching.into_iter().filter(stays).collect();
    if about.is_empty() {
        return turns(&motion.object, &centre, &along);
    }
    // What was open before moves on.
    let opens: Vec<_> = parts.with(&|_| true).into_iter().filter(opens).collect();
    if opens.is_empty() { WayOut::TurnsAbout { about } } else { WayOut::TipsOver { about, opens } }
}

/// A turn about the point of its axis that is nearest to another one, which moves like this.
fn turns<const C: usize>(twist: &Twist<C>, near: &SVector<f64, C>, moves: &SVector<f64, C>) -> WayOut<C> {
    let (_, rotation) = twist.parts();
    let (centre, axis) = (near + rotation.way_to_axis(moves), rotation.axis());
    let is_there = centre.iter().chain(axis.iter()).all(|x: &f64| x.is_finite());
    if is_there { WayOut::Turns { centre, axis } } else { WayOut::NotKnown }
}
