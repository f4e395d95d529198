//! Jumps along the load path under constant load. The object slips because kinetic friction is lower, or snaps over from an unstable equilibrium,
//! until other contacts catch it. The load factor is the multiple of the growing load that acts; 1 is the whole load.

use core::fmt;

use super::words::amount_of;
use crate::grasp::{Engine, WholeContact, WholeContacts};
use crate::load_path::{Event, Jump, JumpSlip, Leg, PathEnd, Ramp};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, highest, largest, moved, picked};
use crate::prelude::*;
use crate::search::Settings;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::{Words, listed, printable};

/// Last words of a clause that reports jumps. They are a caveat, because an object with momentum may move past the equilibrium in which a jump ends.
pub(crate) const NO_MOMENTUM: &str = "counting no momentum";

/// A jump under constant load that ends in another equilibrium: the object slips or snaps over, and contacts catch it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CaughtJump {
    /// The load factor at which the jump takes place, under constant load.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// The contacts that slip in the jump, each with the length of its slip.
    pub slips: Vec<CaughtSlip>,
    /// The motion in the jump of the body that moves farthest, if the jump closes gaps, or if motors yield in it and nothing slips. `None` otherwise:
    /// contacts that are closed already catch the object as they slip.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub moves: Option<CaughtMotion>,
    /// True if the path of equilibria ends at this load, so that the object snaps over to another equilibrium ([`Jump::snaps`]).
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub snaps: bool,
    /// Energy dissipated in the jump, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub energy_lost: f64,
}

/// A contact that slips in a jump, and the length of its slip.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CaughtSlip {
    /// The contact that slips in the jump.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: WholeContact,
    /// Length of the slip in the jump, m; for a soft fingertip the slip of its point that slips farthest.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub distance: f64,
}

/// The motion in a jump of the body that moves farthest.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CaughtMotion {
    /// The contacts whose gaps close at the end of the motion; empty if motors yield and none closes.
    pub contacts: Vec<WholeContact>,
    /// The name of the body that moves farthest.
    pub body: String,
    /// Displacement in the jump of the centroid of this body's contact points, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub distance: f64,
    /// Rotation of this body in the jump, rad.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub angle: f64,
    /// Root mean square displacement of the body's contact points due to the rotation, m: the angle times their root mean square distance from the
    /// centroid.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub turning: f64,
    /// Whether any contact slips in the jump.
    pub slides: bool,
}

impl CaughtMotion {
    fn of(parts: &WholeContacts, jump: &Jump<3>) -> Option<Self> {
        let contacts = parts.with(&|i| jump.reaches.iter().any(|contact| contact.index == i));
        let farthest = highest(&jump.moved, &|part| part.speed())?;
        let (distance, angle) = (farthest.middle_moves().norm(), farthest.twist.parts().1.size());
        let (turning, slides) = (farthest.turning_moves(), !jump.slips.is_empty());
        let body = farthest.body.to_string();
        let nothing_slips = jump.slips.is_empty() && !jump.snaps;
        (nothing_slips || !contacts.is_empty()).then_some(Self {
            contacts,
            body,
            distance,
            angle,
            turning,
            slides,
        })
    }
}

/// Writes the motion: "the object slides 0.4 mm to stop", "lid turns 0.1° to hinge".
impl fmt::Display for CaughtMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let goes = match (self.turning > self.distance, self.slides) {
            (true, _) => format!("turns {}", words.angle(self.angle)),
            (false, true) => format!("slides {}", words.length(self.distance)),
            (false, false) => format!("moves {}", words.length(self.distance)),
        };
        write!(f, "{} {goes}", printable(&self.body))?;
        if self.contacts.is_empty() { Ok(()) } else { write!(f, " to {}", listed(&self.contacts)) }
    }
}

impl Engine {
    /// The load factor up to which the grasp holds if all contacts have kinetic friction from the start. `None` if the load path with this friction
    /// does not end in a loss of equilibrium up to the whole load.
    pub(super) fn carried_while_it_slides(&self, ramp: &Ramp<3>, settings: &Settings) -> Option<f64> {
        let sliding = self.with_friction_of_sliding().ok()?;
        let mut path = sliding.follow(&ramp.base, &[Leg::along(ramp)], settings).ok()?;
        path.run();
        matches!(path.end(), Some(PathEnd::Lost(_))).then(|| path.place().1)
    }
}

impl CaughtJump {
    /// Writes the clause about all jumps, with the load and the motion of the last jump. An example is ", caught at 7.5 N after slipping 0.4 mm at
    /// left, counting no momentum". `size` is the magnitude and unit of the whole load, if one number describes it; `is_held` tells whether the whole
    /// load is held.
    pub(super) fn write_clause(
        all: &[Self],
        size: Option<(f64, &str)>,
        is_held: bool,
        f: &mut fmt::Formatter<'_>,
    ) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        let Some(last) = all.last() else { return Ok(()) };
        let amount = amount_of(size, last.factor, words);
        let at = if last.factor <= NEGLIGIBLE { "at once".to_owned() } else { format!("at {amount}") };
        match (all.len(), &last.moves) {
            (1, Some(moves)) if is_held => write!(f, "; {at} {moves:.digits$}, then holds"),
            (1, Some(moves)) => write!(f, ", after {moves:.digits$} {at}"),
            (1, None) if is_held && last.snaps => write!(f, "; {at} it {last:.digits$}, and holds"),
            (1, None) if last.snaps => write!(f, ", after it {last:.digits$} {at}"),
            (1, None) if is_held => write!(f, ", caught {last:.digits$}"),
            (1, None) => write!(f, ", caught {at} {last:.digits$}"),
            (times, Some(moves)) => {
                write!(f, ", caught {times} times, the last time {at} as {moves:.digits$}")
            }
            (times, None) => write!(f, ", caught {times} times, the last time {at} {last:.digits$}"),
        }?;
        write!(f, ", {NO_MOMENTUM}")
    }

    /// The jumps among the events of the leg (section of the load program) that applies the whole load. On this leg the fraction of the leg that is
    /// done is the load factor.
    pub(super) fn among(parts: &WholeContacts, events: &[Event<3>]) -> Vec<Self> {
        let caught = |(factor, jump): (f64, &Jump<3>)| {
            let whole = parts.with(&|i| jump.slips.iter().any(|slip| slip.contact.index == i));
            let far = |contact: WholeContact| {
                let range = &parts[contact.contact].range;
                let of_it = |slip: &JumpSlip<3>| range.contains(&slip.contact.index);
                let far = |slip: &JumpSlip<3>| if of_it(slip) { slip.slip.norm() } else { 0.0 };
                CaughtSlip { distance: largest(&jump.slips, &far), contact }
            };
            let (slips, moves) = (moved(whole, &far), CaughtMotion::of(parts, jump));
            Self { factor, slips, moves, snaps: jump.snaps, energy_lost: jump.energy_lost }
        };
        picked(events, &|event| Some(caught((event.fraction, event.jump.as_deref()?))))
    }
}

/// Writes the slips of the jump: "after slipping 0.4 mm at left", "snaps over, slipping 0.4 mm at left".
impl fmt::Display for CaughtJump {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let longest = largest(&self.slips, &|slip| slip.distance);
        // Slips below this fraction of the longest slip of the jump are taken as rounding. If the fraction were larger, contacts that matter would
        // not be named.
        let slips = self.slips.iter().filter(|slip| slip.distance > 1e-6 * longest);
        let slips = slips.map(|slip| format!("{} at {}", words.length(slip.distance), slip.contact.text()));
        let slips: Vec<_> = slips.list();
        let (none, slips) = (slips.is_empty(), listed(&slips));
        match (self.snaps, none) {
            (true, true) => f.write_str("snaps over"),
            (true, false) => write!(f, "snaps over, slipping {slips}"),
            (false, _) => write!(f, "after slipping {slips}"),
        }
    }
}
