//! The verdict on a load that grows from zero in addition to the base load. The load factor is the multiple of the growing load that acts; 1 is the
//! whole load. At first slip the first contact ceases to stick, at gross slip every contact that presses slides. A jump is a sudden motion under
//! constant load. Motions are small within the limits of rotation, slip and opening up to which the linear theory is trusted. A drive is the spring
//! of a joint or tendon of a hand, with its force limit.

use crate::equilibrium::{Equilibrium, NoEquilibrium, TooFar};
use crate::grasp::{Motion, PartLabel, WholeContact, Wrench};
use crate::load_path::LossKind;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

use super::caught_jump::CaughtJump;
use super::way_out::WayOut;
use crate::prelude::*;

/// The answer to "does it hold?"; its [`Display`](std::fmt::Display) is a sentence.
///
/// Load factors are multiples of `load`: at factor τ the loads are `base + τ load`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Verdict<const C: usize> {
    /// The base load, N and N m: it acts at load factor 0 already, before `load` grows.
    pub base: Wrench<C>,
    /// The load that grows from 0 in addition to `base`, N and N m.
    pub load: Wrench<C>,
    /// The conclusion: whether and how the whole load, factor 1, is held.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub holding: Holding<C>,
    /// First slip: the first contacts that slide, open or would have to pull, and drives that give way. `None` if all contacts stick as far as the
    /// load was followed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub first_slip: Option<FirstSlip>,
    /// The jumps (motions under constant load) up to the whole load or the loss, in each of which the object is caught. In a jump contacts begin to
    /// slide with lower [kinetic friction](crate::grasp::Contact::kinetic), gaps close after a motion without resistance, or the object snaps over to
    /// another equilibrium.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub caught: Vec<CaughtJump>,
    /// Largest load factor that is reached with the load held and motions [small](crate::Settings::small_motions); 0 if the grasp does not hold the
    /// base load.
    ///
    /// The load is followed only up to [`Settings::most_load`](crate::Settings::most_load), so this factor is no upper bound of the load that is
    /// held.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub held_to: f64,
    /// Load factor from which on every contact with friction and a normal force slides without interruption up to factor 1. If a contact sticks at
    /// factor 1, or the path ends before factor 1, this is the factor from which on all of them slide up to the end of the path. At larger factors
    /// friction is exhausted, and normal forces must carry any further load. `None` if a contact sticks at factor 1 and at the end of the path.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub everything_slides: Option<f64>,
    /// Geometric stiffness, which small motions neglect, divided by the resistance to the motion from the equilibrium under the base load to the
    /// equilibrium under the whole load, or at the loss.
    ///
    /// Let F be the contact forces under the base load, r their arms, θ the rotation, and ΔW the change of the load along the motion q. The fraction
    /// is `Σ [(F·r) |θ|² - (F·θ)(r·θ)]` divided by the work `ΔW·q`. If it is below 0, these forces lower the resistance, because their arms turn with
    /// the object; at -1 or less no resistance is left. This fraction is not computed for several bodies, nor if commands or joints change with the
    /// load.
    ///
    /// A second number replaces this fraction if it is lower and at most -0.5. It is minus the largest fraction of the springs' resistance to any
    /// motion that the forces under the whole load take away. At -1 the grasp buckles. If the points of action of the load are known, the verdict
    /// ends there, with [`TooFar::Buckles`]. A third number replaces both if it is lower: `ΔW·q / ΔW·q' - 1`, with the motion q from rest to
    /// the whole load, and q' this motion with finite rotations of all parts, as those of a toggle near its dead centre. `None` if all are small, and if the
    /// grasp buckles before the whole load acts.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub left_out: Option<f64>,
    /// The small motion from rest to where the object hangs under the whole load, if nothing resists this motion. The other fields of this verdict
    /// hold for the undeformed geometry, in which the object is lost at once. The forces where it hangs are not computed, so friction may be exceeded
    /// there. `None` if the object is held, if it hangs only beyond small motions, or if the points of action of the load are not known.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub swing: Option<Motion<C>>,
    /// The loss of equilibrium, or the end of [small motions](crate::Settings::small_motions), whichever comes first; its factor may exceed 1. `None`
    /// if neither comes before the load factor up to which the load was followed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub lost: Option<Lost<C>>,
    /// The equilibrium under the whole load, with the slips up to it; `None` if the whole load is not reached with small motions.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
}

impl<const C: usize> Verdict<C> {
    /// Whether the whole load is held; `None` if that is undecided, or if [`Self::left_out`] is -1 or less, so that the grasp may buckle.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        match self.holding {
            _ if self.leaves_buckling_open() => None,
            Holding::Sticks | Holding::Slides { .. } => Some(true),
            Holding::TurnsOver { .. }
            | Holding::Loose
            | Holding::Lost
            | Holding::NoRest { .. }
            | Holding::LostAtRest { .. } => Some(false),
            Holding::Undecided { .. } => None,
        }
    }

    /// Whether the whole load is held and every contact sticks up to the whole load; `None` if it is undecided whether the load is held.
    #[must_use]
    pub fn sticks(&self) -> Option<bool> {
        self.holds().map(|_| matches!(self.holding, Holding::Sticks))
    }
}

/// The conclusion of a verdict. A load is held only while motions are [small](crate::Settings::small_motions).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "holding", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Holding<const C: usize> {
    /// The load is held, and every contact sticks up to the whole load.
    Sticks,
    /// The load is held, but contacts slide under it, or have slid, slipped in a jump, opened or given way before.
    Slides {
        /// The contacts that slide under the whole load or have slid before; contacts that only opened are not listed.
        contacts: Vec<WholeContact>,
    },
    /// Contacts stick and carry the load, but nothing resists a rotation along which the load drives the object on, for example a part held below its
    /// centre of mass. Only loads whose points of action are known ([`Wrench::force_at`](crate::planar::Wrench::force_at)) are checked.
    TurnsOver {
        /// The unit motion that nothing resists and along which the load drives the object on.
        motion: Motion<C>,
    },
    /// No contact carries a force under the whole load: the object lies loose between the fingers.
    Loose,
    /// Equilibrium is lost before the whole load is applied, or motions cease to be small.
    Lost,
    /// The grasp has no equilibrium even under the base load, and this is proved.
    NoRest {
        /// The proof that no equilibrium exists under the base load.
        #[cfg_attr(feature = "serde", serde(flatten))]
        none: NoEquilibrium<C>,
        /// The loss of equilibrium as the base load grows from zero together with the commands, if the proof names no motion. Its load factor is the
        /// fraction of the base load and of the commands that acts at the loss.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        at_rest: Option<Box<Lost<C>>>,
    },
    /// The grasp loses the base load as the base load grows from zero together with the commands. A load path shows this loss. It does not prove that
    /// no equilibrium under the base load exists; [`Self::NoRest`] has such a proof.
    LostAtRest {
        /// The loss of equilibrium. Its load factor is the fraction of the base load and of the commands that acts at the loss.
        at_rest: Box<Lost<C>>,
    },
    /// The path could not be followed up to the whole load, because of rounding or limits of the search.
    Undecided {
        /// The reason why the path could not be followed to the whole load.
        doubt: Doubt,
    },
}

/// The first contacts that cease to stick, and the first drives that give way, as the load grows, and the load factor at which they do.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FirstSlip {
    /// The load factor of first slip; 0 if a contact slides under the base load.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// Contacts that begin to slide; at factor 0 the contacts that slide under the base load.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub slide: Vec<WholeContact>,
    /// Contacts that begin to open at this load factor.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub open: Vec<WholeContact>,
    /// Contacts that are kept closed by assumption, and need a tensile normal force from this factor on.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub would_pull: Vec<WholeContact>,
    /// Names of joints and tendons that reach their limit and give way.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub give_way: Vec<String>,
}

/// The loss of equilibrium as the load grows, or the end of [small motions](crate::Settings::small_motions).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Lost<const C: usize> {
    /// The load factor at the loss.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// The kind of loss: which condition of equilibrium fails.
    pub kind: LossKind,
    /// The motion with which the object leaves; [`WayOut::NotKnown`] at the end of small motions.
    pub way_out: WayOut<C>,
    /// The rotation, slip or opening that exceeds the limit of small motions; `None` if equilibrium is lost.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
    /// Contacts that slide at the loss; in a grasp of several bodies only contacts whose two surfaces move relative to each other.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub slide: Vec<WholeContact>,
    /// Whether all contacts that press slide: gross slip. At the end of small motions it is true if [`Verdict::everything_slides`] is at least 0.99
    /// times `factor` and no link, such as a cable or hinge, carries a force.
    pub is_gross_slip: bool,
    /// Whether the object is lost at first slip, because some contact has a [kinetic friction](crate::grasp::Contact::kinetic) that is lower than its
    /// static friction.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub falls_at_once: bool,
    /// The load factor up to which the grasp would hold if it had kinetic friction from the start. `None` unless it is below `factor`, and some
    /// contact has a kinetic friction that is lower than its static friction.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub then_takes: Option<f64>,
    /// Joints and tendons of a hand that have reached their limit at the loss.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartLabel>,
    /// The unit motion of all bodies with which the object leaves. `None` if it is not determined, if suction cups let go, or if motions cease to be
    /// small.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion<C>>,
    /// The last equilibrium, at the loss; `None` if it could not be computed, for a loss of the base load, and if the verdict was computed without
    /// equilibria to save time.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
    /// Proof that no equilibrium under the whole load exists near the loss. `None` if the whole load is held, suction cups let go, the object swings
    /// until it hangs, or no proof was found.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub nothing_near: Option<NoEquilibriumNear>,
}

/// Proof that no equilibrium under the whole load exists near the loss, whatever contacts have slipped.
///
/// The proof covers equilibria in which the centroid of the contact points is displaced by up to `translation` from its position at the loss, and the
/// object is rotated by up to `rotation`. The joints of a hand may move their contacts by up to `translation`, too. Both numbers include the rounding
/// of the sums in the proof.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NoEquilibriumNear {
    /// Largest displacement from the position at the loss that is covered, m; infinite if no equilibrium exists at all.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub translation: f64,
    /// Largest rotation from the position at the loss that is covered, rad.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub rotation: f64,
}
