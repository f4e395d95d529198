//! An observation: a load or an angle at which the first contact, or the whole object, was observed to slip. A turning load turns by a growing angle.
//! A layout is one arrangement of the contact points, with a grasp of its own. The squeeze is everything by which contacts press at rest without a
//! load. The scatter of an observation is its relative standard deviation. The base load acts before the load of the observation grows. At first slip
//! the first contact ceases to stick, at gross slip every contact that presses slides.

use nalgebra::SVector;

use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Contact, Hold, Space, Wrench};
use crate::load_path::Turn;
use crate::numerics::tolerances::NEGLIGIBLE;

/// The kind of slip that was observed: of the first contact, or of the whole object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum SlipKind {
    /// The first contact ceased to stick.
    First,
    /// The object was lost: every contact that pressed slid, or the object tipped over.
    #[default]
    Gross,
}

/// The load that grew, or that turned, until slip was observed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SlipLoad {
    Load(Wrench<3>),
    Turn(Turn<3>),
}

/// An observation: a load, or an angle of a turning load, at which slip was observed.
///
/// ```
/// use grasp_lcp::identify::Slip;
/// use grasp_lcp::planar::{Turn, Wrench};
///
/// // 3.2 N, give or take 4 %, dragged the object out of its jaws. Tilted, it slid at 24°.
/// let dragged = Slip::gross(Wrench::force([0.0, -3.2])).scattering_by(0.04);
/// let tilted = Slip::first_on_turn(Turn::tilting([0.0, -2.0], [0.0, 0.01]).up_to(24_f64.to_radians()));
/// # let _ = (dragged, tilted);
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[must_use]
pub struct Slip<const C: usize> {
    /// First or gross slip; gross if left out.
    #[cfg_attr(feature = "serde", serde(default, rename = "slip"))]
    pub(super) kind: SlipKind,
    /// The load at which slip was observed, grown from zero.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) load: Option<Wrench<C>>,
    /// A turn of a load up to the angle at which slip was observed, instead of a growing load.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) turn: Option<Turn<C>>,
    /// The constant load that acts before the growing load, and together with it; zero if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) base: Option<Wrench<C>>,
    /// Factor on the squeeze of the scene; 1 if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) squeeze: Option<f64>,
    /// The layout in which slip was observed; 0, the scene itself, if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) layout: Option<usize>,
    /// Relative standard deviation of load or angle; given for every observation, or for none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) scatter: Option<f64>,
    /// The number of a group of observations that may share an error, such as those in one direction or of one specimen; given for all, or for none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) group: Option<usize>,
}

impl<const C: usize> Slip<C> {
    fn of(kind: SlipKind, load: Option<Wrench<C>>) -> Self {
        Self { kind, load, turn: None, base: None, squeeze: None, layout: None, scatter: None, group: None }
    }

    /// First slip was observed under this load, which had grown from zero.
    pub fn first(load: Wrench<C>) -> Self {
        Self::of(SlipKind::First, Some(load))
    }

    /// Gross slip was observed under this load, which had grown from zero.
    pub fn gross(load: Wrench<C>) -> Self {
        Self::of(SlipKind::Gross, Some(load))
    }

    /// First slip was observed at the [end](Turn::up_to) of this turn.
    pub fn first_on_turn(turn: Turn<C>) -> Self {
        Self { turn: Some(turn), ..Self::of(SlipKind::First, None) }
    }

    /// Gross slip was observed at the [end](Turn::up_to) of this turn.
    pub fn gross_on_turn(turn: Turn<C>) -> Self {
        Self { turn: Some(turn), ..Self::of(SlipKind::Gross, None) }
    }

    setters! {
        /// This observation with a base load, such as a weight. It acted before the observed load grew, and stayed constant.
        pub fn on_top_of(mut self, base: Wrench<C>) { self.base = Some(base); }

        /// This observation with a factor on the squeeze of the grasp. If the squeeze was loosened until the object slipped, `factor` is the part of
        /// the squeeze that was left at slip. The scatter of the observation is then the scatter of this factor.
        pub fn squeezed(mut self, factor: f64) { self.squeeze = Some(factor); }

        /// This observation in another layout (arrangement of the contact points): 0 is the grasp of the question. Then come the layouts of
        /// [`Identify::with_points`](super::Identify::with_points), numbered from 1, and after them those of
        /// [`Identify::and_layouts`](super::Identify::and_layouts).
        pub fn in_layout(mut self, layout: usize) { self.layout = Some(layout); }

        /// This observation with a relative standard deviation of its load or angle: 0.05 for five percent. It must be given for every observation,
        /// or for none.
        pub fn scattering_by(mut self, part: f64) { self.scatter = Some(part); }

        /// This observation as one of a group that may share errors: those in one direction, of one specimen, or of one day. The number of the group
        /// is arbitrary. A group must be given for every observation, or for none. [Errors](crate::identify#errors) describes how groups count.
        pub fn in_group(mut self, group: usize) { self.group = Some(group); }
    }
}

impl Slip<3> {
    /// Whether both observations are of one kind, under the same loads, squeeze and layout. Predictions for them are then equal; scatter and group
    /// may differ.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.load, self.kind, self.layout, self.squeeze)
            == (other.load, other.kind, other.layout, other.squeeze)
            && self.base == other.base
            && self.turn == other.turn
    }

    /// Returns this observation with its load split in two, if nothing but this load presses on the contacts. The component of the load against the
    /// mean of the contact normals, as a rule a weight, becomes the base load. Only the component across that mean grows. If both components grew
    /// together, friction and normal forces would grow in the same proportion, so that the object would slide at once, or never.
    pub(super) fn with_weight_at_rest(mut self, grasp: &Grasp<3>) -> Self {
        let SlipLoad::Load(load) = self.growing_load() else { return self };
        let is_plain = |contact: &Contact<3>| contact.hold == Hold::Unilateral;
        if self.base() != Wrench::ZERO || grasp.presses() || !grasp.contacts().iter().all(is_plain) {
            return self;
        }
        let count = grasp.len() as f64;
        let (mut along, mut centre) = (SVector::<f64, 3>::zeros(), SVector::<f64, 3>::zeros());
        for contact in grasp.contacts() {
            along += contact.normal.normalize();
            centre += contact.point / count;
        }
        let force = load.force_part();
        let pressed = -along.dot(&force) / along.norm_squared();
        if pressed.is_nan()
            // If the mean of the unit normals is not longer than 1e-6, contacts oppose each other, as two jaws do. Then no load presses on all of
            // them.
            || along.norm() <= 1e-6 * count
            || pressed * along.norm() <= NEGLIGIBLE * force.norm()
        {
            return self;
        }
        // The force of the load is split into `weight`, which becomes the force of the base load, and the rest, which grows. The moment of the load
        // about the centroid of the contacts is split in the ratio of the components of these two forces along the whole force. In the plane both
        // forces then act through the point of the load's line of action that is nearest to the centroid.
        let weight = along * -pressed;
        let about = load - Wrench::force_through(&centre, &force);
        let share = weight.dot(&force) / force.norm_squared();
        let pressing = Wrench::force_through(&centre, &weight) + about * share;
        let pulling = load - pressing;
        if pulling.force_part().iter().all(|x| x.abs() <= NEGLIGIBLE * force.norm()) {
            return self;
        }
        (self.base, self.load) = (Some(pressing), Some(pulling));
        self
    }

    /// The load that grew, or else the turn of a load, until slip was observed.
    pub(super) fn growing_load(&self) -> SlipLoad {
        self.turn.map_or_else(|| SlipLoad::Load(self.load.unwrap_or(Wrench::ZERO)), SlipLoad::Turn)
    }

    /// The base load, which acted before the observed load grew; zero if not given.
    pub(super) fn base(&self) -> Wrench<3> {
        self.base.unwrap_or(Wrench::ZERO)
    }

    /// The load before the observed load grows: the base load plus the load of a turn at angle zero.
    pub(super) fn at_rest(&self) -> Wrench<3> {
        self.base() + self.turn.map_or(Wrench::ZERO, |turn| turn.load_at(0.0))
    }

    /// The factor on the squeeze of the grasp during this observation; 1 if not given.
    pub(super) fn squeeze(&self) -> f64 {
        self.squeeze.unwrap_or(1.0)
    }

    /// The layout in which slip was observed; 0 is the given grasp.
    pub(super) fn layout(&self) -> usize {
        self.layout.unwrap_or(0)
    }

    /// The observed value to compare with a predicted one: load factor 1 (a multiple of the observed load), or the angle of a turning load in rad.
    pub(super) fn observed_at(&self) -> f64 {
        match self.growing_load() {
            SlipLoad::Load(_) => 1.0,
            SlipLoad::Turn(turn) => turn.angle(),
        }
    }

    /// Returns an error if a value of this observation is out of range, or if it has not exactly one of load and turn. The message names the
    /// observation by its index `number`, from 0; `layouts` is the number of layouts.
    pub(super) fn check(&self, number: usize, space: Space, layouts: usize) -> Result<(), Error> {
        let wrong = |field, value, allowed| {
            Err(Error::Identify { what: format!("slip {number}"), field, value, allowed })
        };
        let fault = match (self.load, self.turn) {
            (None, None) => Some("have one without load and turn, each must have one of them"),
            (Some(_), Some(_)) => Some("have one with load and turn, each must have one of them"),
            _ => None,
        };
        if let Some(fault) = fault {
            return Err(Error::Question { question: "identify", field: "slips", fault });
        }
        self.base().check_in(space, "base load of a slip")?;
        match self.growing_load() {
            SlipLoad::Load(load) if load == Wrench::ZERO => {
                return wrong("size of the load", 0.0, "more than 0");
            }
            SlipLoad::Load(load) => load.check_in(space, "load of a slip")?,
            SlipLoad::Turn(turn) => turn.check_in(space)?,
        }
        if !(self.squeeze() > 0.0 && self.squeeze() <= 1e6) {
            return wrong("squeeze", self.squeeze(), "more than 0 and at most 1e6 times the one given");
        }
        if self.layout() >= layouts {
            return wrong("layout", self.layout() as f64, "less than the number of layouts");
        }
        match self.scatter {
            Some(part) if !(part > 0.0 && part <= 10.0) => {
                wrong("scatter", part, "more than 0 and at most 10: 0.05 is five percent")
            }
            _ => Ok(()),
        }
    }
}
