//! The motion with which the object leaves at a loss, the end of equilibrium under a growing load. It has an everyday name: the object lifts off,
//! slides out, tips over or turns, or several bodies move apart.

use nalgebra::SVector;

use crate::grasp::{BodyMotion, Contact, Engine, Hold, Motion, Twist, WholeContact};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, chosen, keep, largest, mapped, summed};
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::Words;

/// A contact or body that moves by less than this fraction of the fastest one is taken as fixed. A rotation that moves contacts by less than this
/// fraction of the displacement of the object is taken as zero. The fraction only chooses the name of a motion. If it were larger, slow contacts
/// would count as fixed. If it were smaller, no contact would count as fixed, so that nothing would tip over.
const STANDS: f64 = 0.05;

/// The kind of motion with which an object leaves at a loss, in everyday words.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "way", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum WayOut<const C: usize> {
    /// Every contact that touches opens: its point moves away from the finger, in a direction more than 45° above the finger's surface.
    LiftsOff {
        /// Unit direction in which the centroid of the contacts moves.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// The object moves and hardly turns: the rotation moves no contact by more than a twentieth of the displacement of their centroid.
    SlidesOut {
        /// Unit direction in which the centroid of the contacts moves.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// The object turns about contacts that stay in place, and other contacts open.
    TipsOver {
        /// The contacts that stay in place; of a soft fingertip the points that stay.
        about: Vec<WholeContact>,
        /// The contacts that open, including contacts that were open already and move away.
        opens: Vec<WholeContact>,
    },
    /// The object turns about contacts that stay in place. No contact opens, though a cable may go slack; all others that touch slide.
    TurnsAbout {
        /// The contacts that stay in place; in space two of them define the axis.
        about: Vec<WholeContact>,
    },
    /// The object turns about a point, in space about an axis through it.
    Turns {
        /// Point of the axis nearest to the contacts that touch, m. In the plane it is fixed; in space it moves at most along the axis.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        centre: SVector<f64, C>,
        /// Unit vector along the axis of rotation; zero in the plane.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        axis: SVector<f64, C>,
        /// Displacement along the axis for one radian of rotation, m: the motion is a screw. Zero in the plane, and if this displacement is at most a
        /// twentieth of the displacement of the farthest contact due to the rotation.
        #[cfg_attr(feature = "serde", serde(default, with = "AsComputed::<f64>"))]
        advance: f64,
    },
    /// One or several of the bodies of a grasp with several bodies move.
    Apart {
        /// The bodies that move at the loss, each with its own motion.
        bodies: Vec<BodyWay<C>>,
    },
    /// The lips of suction cups are open all around, so that their vacuum is lost.
    LetsGo {
        /// The cups that have lost their vacuum.
        cups: Vec<WholeContact>,
    },
    /// The motion of the object at the loss is not determined.
    NotKnown,
}

/// One of several bodies and its motion: [`WayOut::SlidesOut`], [`WayOut::Turns`] or [`WayOut::NotKnown`]. If all moving bodies move as one rigid
/// body, they may also tip over or turn about contacts.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BodyWay<const C: usize> {
    /// Name of the body that moves.
    pub body: String,
    /// Kind of this body's motion at the loss, with its direction, axis or contacts.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub way: WayOut<C>,
}

impl BodyWay<3> {
    fn of(motion: &BodyMotion<3>) -> Self {
        let middle = motion.middle_moves();
        let way = slides_out(&middle, motion.turning_moves())
            .unwrap_or_else(|| turns(&motion.twist, (&motion.centre, &middle), motion.reach));
        Self { body: motion.body.to_string(), way }
    }
}

/// [`WayOut::SlidesOut`] if the object hardly turns: the rotation moves contacts by at most [`STANDS`] times the displacement `along`. `spin` is the
/// motion of contacts due to the rotation, m. Else `None`.
fn slides_out(along: &SVector<f64, 3>, spin: f64) -> Option<WayOut<3>> {
    let direction = || along.try_normalize(0.0);
    (spin <= STANDS * along.norm())
        .then(|| direction().map_or(WayOut::NotKnown, |direction| WayOut::SlidesOut { direction }))
}

/// The everyday name of the motion with which the object leaves. `touches` is true for contacts that still touch. Only such contacts can lift off,
/// and the object can tip over such contacts only.
pub(super) fn way_out(
    engine: &Engine,
    motion: Option<&Motion<3>>,
    touches: &dyn Fn(usize) -> bool,
) -> WayOut<3> {
    let Some(motion) = motion else { return WayOut::NotKnown };
    let Some(bodies) = engine.bodies() else {
        return seen_from(engine, &motion.object, &|_| 1.0, touches);
    };
    let sides = &bodies.sides;
    let fastest = largest(&motion.bodies, &BodyMotion::speed);
    let moves = |body: &BodyMotion<3>| body.speed() > STANDS * fastest;
    let mut bodies: Vec<_> = motion.bodies.iter().filter(|body| moves(body)).map(BodyWay::of).list();
    let Some(first) = motion.bodies.iter().find(|body| moves(body)) else { return WayOut::Apart { bodies } };
    let as_the_first = |body: &BodyMotion<3>| {
        let other = BodyMotion { twist: difference(&body.twist, &first.twist), ..body.clone() };
        other.speed() <= STANDS * fastest
    };
    if motion.bodies.iter().filter(|body| moves(body)).all(as_the_first) {
        // The moving bodies move as one rigid body, so contacts between two of them do not matter. Only their contacts with the ground, fingers and
        // bodies at rest determine the name of the motion.
        let is_one_of_them = |body: usize| moves(&motion.bodies[body]);
        let sign = |i: usize| {
            let (on, against) = (is_one_of_them(sides[i].0), sides[i].1.is_some_and(is_one_of_them));
            f64::from(i8::from(on) - i8::from(against))
        };
        let way = seen_from(engine, &first.twist, &sign, touches);
        if matches!(way, WayOut::TipsOver { .. } | WayOut::TurnsAbout { .. }) {
            for body in &mut bodies {
                body.way = way.clone();
            }
        }
    }
    WayOut::Apart { bodies }
}

/// Whether the two surfaces of a contact move relative to each other at its point, faster than [`STANDS`] times the fastest body.
pub(super) fn comes_apart(
    contact: &Contact<3>,
    (on, against): (usize, Option<usize>),
    motion: &Motion<3>,
) -> bool {
    let fastest = largest(&motion.bodies, &BodyMotion::speed);
    let at_the_point = |body: usize| motion.bodies[body].twist.moves(&contact.point);
    let other = against.map_or_else(SVector::zeros, at_the_point);
    (at_the_point(on) - other).norm() > STANDS * fastest
}

fn difference(a: &Twist<3>, b: &Twist<3>) -> Twist<3> {
    let components: Vec<_> = a.components().iter().zip(b.components()).map(|(a, b)| a - b).list();
    Twist::from_components(&components)
}

/// The name of the motion of an object with this twist, from the motion of the contacts that touch it. `sign` is 1 for a contact whose normal points
/// into the object, -1 if it points out of the object. It is 0 for a contact of other bodies, and for a contact between two bodies that move as one
/// object.
fn seen_from(
    engine: &Engine,
    twist: &Twist<3>,
    sign: &dyn Fn(usize) -> f64,
    touches: &dyn Fn(usize) -> bool,
) -> WayOut<3> {
    let velocity = |point: &SVector<f64, 3>| twist.moves(point);
    let (contacts, parts) = (engine.contacts(), engine.wholes());
    let touches = |i: usize| sign(i) != 0.0 && touches(i);
    let touching = chosen(parts.len(), &|part| parts[*part].range.clone().any(touches));
    let places = parts.mean(&|i| contacts[i].point);
    let moves: Vec<_> = mapped(&places, &velocity);
    let normals = parts.mean(&|i| contacts[i].normal.normalize() * sign(i));
    let count = touching.len().max(1) as f64;
    let mut centre = SVector::zeros();
    for part in &touching {
        centre += places[*part] / count;
    }
    let along = velocity(&centre);
    let reach = largest(contacts, &|contact| (contact.point - centre).norm());
    let spin = summed(&twist.components()[3..], &|x| x * x).sqrt() * reach;
    let fastest = spin.max(largest(&touching, &|part| moves[*part].norm()));
    let stays = |part: &WholeContact| moves[part.contact].norm() <= STANDS * fastest;
    // A velocity v leads away from the finger if it is more than 45° above the finger's surface, whose normal n points into the object.
    let goes_away = |v: &SVector<f64, 3>, n: &SVector<f64, 3>| v.dot(n) > 0.5f64.sqrt() * v.norm() * n.norm();
    let opens = |part: &WholeContact| {
        let may_open = contacts[parts[part.contact].range.start].hold == Hold::Unilateral;
        may_open && !stays(part) && goes_away(&moves[part.contact], &normals[part.contact])
    };
    let point_stays = |i: usize| velocity(&contacts[i].point).norm() <= STANDS * fastest;
    let point_opens = |i: usize| {
        let (v, normal) = (velocity(&contacts[i].point), contacts[i].normal * sign(i));
        contacts[i].hold == Hold::Unilateral && !point_stays(i) && goes_away(&v, &normal)
    };
    let points = chosen(contacts.len(), &|i| touches(*i));
    if !points.is_empty() && points.iter().all(|i| point_opens(*i)) {
        return WayOut::LiftsOff { direction: along.try_normalize(0.0).unwrap_or_else(SVector::zeros) };
    }
    if let Some(way) = slides_out(&along, spin) {
        return way;
    }
    let mut about = parts.with(&touches);
    keep(&mut about, &stays);
    if about.is_empty() {
        // An object that tips on a soft fingertip turns about some points of that fingertip, while all other points open.
        let about = parts.with(&|i| touches(i) && point_stays(i));
        let either = points.iter().all(|i| point_stays(*i) || point_opens(*i));
        if either && !about.is_empty() {
            let opens = parts.with(&|i| sign(i) != 0.0 && point_opens(i));
            return WayOut::TipsOver { about, opens };
        }
        return turns(twist, (&centre, &along), reach);
    }
    // Contacts that do not touch but move away from their finger are listed as opening, too.
    let mut opening = parts.with(&|i| sign(i) != 0.0);
    keep(&mut opening, &opens);
    let opens = opening;
    // The object tips over only if a contact opens that is no link. A door whose cable goes slack turns about its hinge instead.
    let tips = opens.iter().any(|part| part.link.is_none());
    if tips { WayOut::TipsOver { about, opens } } else { WayOut::TurnsAbout { about } }
}

/// [`WayOut::Turns`] for a twist. Its centre is the point of the axis nearest to `near`; `moves` is the displacement of `near`, m. All contacts are
/// within the distance `reach` of `near`, m. Coordinates that are only rounding of these lengths become zero. `NotKnown` if the axis is not finite.
fn turns(twist: &Twist<3>, (near, moves): (&SVector<f64, 3>, &SVector<f64, 3>), reach: f64) -> WayOut<3> {
    let (_, rotation) = twist.parts();
    let rounding = SOLVED_ROUNDING * (reach + near.norm());
    let centre = (near + rotation.way_to_axis(moves)).map(|x| if x.abs() <= rounding { 0.0 } else { x });
    let axis = rotation.axis();
    let advance = axis.dot(moves) / rotation.size();
    let advance = if advance.abs() > STANDS * reach { advance } else { 0.0 };
    let is_there = centre.iter().chain(axis.iter()).chain([&advance]).all(|x: &f64| x.is_finite());
    if is_there { WayOut::Turns { centre, axis, advance } } else { WayOut::NotKnown }
}

impl<const C: usize> WayOut<C> {
    /// Whether the motion is called a fall, because its direction is within 26° of the negative last axis, which is down, and no contact slides.
    pub(super) fn falls(&self, slide: &[WholeContact], words: Words) -> bool {
        let (Self::LiftsOff { direction } | Self::SlidesOut { direction }) = self else { return false };
        // A unit direction with a last component below -0.9 is within 26° of the vertical and is called a fall.
        slide.is_empty() && direction[words.space::<C>().axes() - 1] < -0.9
    }
}
