//! A slip that was seen.

use nalgebra::SVector;

use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Contact, Hold, Wrench};
use crate::load_path::Turn;

/// Normals whose mean is shorter than this are opposed, as those of two jaws: no load presses on all contacts.
const OPPOSED: f64 = 1e-6;
/// Of a load whose part along or across the normals is less than this part, that part is rounding.
const ALONG: f64 = 1e-9;

/// Which slip was seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum SlipKind {
    /// The first contact stopped sticking.
    First,
    /// The object was lost: everything that pressed slid, or it tipped over.
    #[default]
    Gross,
}

/// What grew until it slid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Grown<const C: usize> {
    Load(Wrench<C>),
    Turn(Turn<C>),
}

/// A slip that was seen under a load, or at an angle.
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
pub struct Slip<const C: usize> {
    pub(super) kind: SlipKind,
    pub(super) grown: Grown<C>,
    /// What acted besides, from the first.
    pub(super) base: Wrench<C>,
    /// How many times the squeeze of the grasp.
    pub(super) squeeze: f64,
    /// Which grasp, where there are others.
    pub(super) layout: usize,
    /// Standard deviation over the load or the angle.
    pub(super) scatter: Option<f64>,
    /// Which slips share errors with it.
    pub(super) group: Option<usize>,
}

impl<const C: usize> Slip<C> {
    fn of(kind: SlipKind, grown: Grown<C>) -> Self {
        Self { kind, grown, base: Wrench::ZERO, squeeze: 1.0, layout: 0, scatter: None, group: None }
    }

    /// The first contact slid under this load, which had grown from nothing.
    #[must_use]
    pub fn first(load: Wrench<C>) -> Self {
        Self::of(SlipKind::First, Grown::Load(load))
    }

    /// The object was lost under this load, which had grown from nothing.
    #[must_use]
    pub fn gross(load: Wrench<C>) -> Self {
        Self::of(SlipKind::Gross, Grown::Load(load))
    }

    /// The first contact slid at the [end](Turn::up_to) of this turn.
    #[must_use]
    pub fn first_on_turn(turn: Turn<C>) -> Self {
        Self::of(SlipKind::First, Grown::Turn(turn))
    }

    /// The object was lost at the end of this turn.
    #[must_use]
    pub fn gross_on_turn(turn: Turn<C>) -> Self {
        Self::of(SlipKind::Gross, Grown::Turn(turn))
    }

    /// This slip beside a load that was there from the first, a weight for instance.
    #[must_use]
    pub fn on_top_of(mut self, base: Wrench<C>) -> Self {
        self.base = base;
        self
    }

    /// This slip while the grasp was squeezed so many times as much: where a squeeze is loosened until the load slips, the one at which it did. Its
    /// scatter is then counted as that of the load.
    #[must_use]
    pub fn squeezed(mut self, factor: f64) -> Self {
        self.squeeze = factor;
        self
    }

    /// This slip of another grasp: 1 for the first of [those beside](super::Identify::and_layouts), and so on.
    #[must_use]
    pub fn in_layout(mut self, layout: usize) -> Self {
        self.layout = layout;
        self
    }

    /// This slip with a standard deviation of its load or angle, as a part of it: 0.05 for five percent. Given for every slip, or for none.
    #[must_use]
    pub fn scattering_by(mut self, part: f64) -> Self {
        self.scatter = Some(part);
        self
    }

    /// This slip as one of a group that may share errors: slips in one direction, of one specimen, or of one day. Any number will do, the same for all slips of the
    /// group; given for every slip, or for none. See [errors](crate::identify#errors).
    #[must_use]
    pub fn in_group(mut self, group: usize) -> Self {
        self.group = Some(group);
        self
    }

    /// This slip with what presses the object onto its contacts there at rest, where nothing else presses: the part of its load along the mean of their
    /// normals, which is a weight as a rule. Grown together both parts would slide at once, or never.
    pub(super) fn with_weight_at_rest(mut self, grasp: &Grasp<C>) -> Self {
        let Grown::Load(load) = self.grown else { return self };
        let is_plain = |contact: &Contact<C>| contact.hold == Hold::Unilateral;
        if self.base != Wrench::ZERO || grasp.presses() || !grasp.contacts().iter().all(is_plain) {
            return self;
        }
        let count = grasp.len() as f64;
        let (mut along, mut centre) = (SVector::<f64, C>::zeros(), SVector::<f64, C>::zeros());
        for contact in grasp.contacts() {
            along += contact.normal.normalize();
            centre += contact.point / count;
        }
        let force = SVector::<f64, C>::from_column_slice(&load.components()[..C]);
        let pressed = -along.dot(&force) / along.norm_squared();
        if pressed.is_nan()
            || along.norm() <= OPPOSED * count
            || pressed * along.norm() <= ALONG * force.norm()
        {
            return self;
        }
        // The moment about the middle of the contacts goes with the forces: in the plane both parts then act on the line of the whole.
        let weight = along * -pressed;
        let about = load - Wrench::force_through(&centre, &force);
        let share = weight.dot(&force) / force.norm_squared();
        let pressing = Wrench::force_through(&centre, &weight) + about * share;
        let pulling = load - pressing;
        if pulling.components()[..C].iter().all(|x| x.abs() <= ALONG * force.norm()) {
            return self;
        }
        (self.base, self.grown) = (pressing, Grown::Load(pulling));
        self
    }

    /// Where it was seen, on the scale on which it is predicted: once the load, or the angle in rad.
    pub(super) fn seen_at(&self) -> f64 {
        match &self.grown {
            Grown::Load(_) => 1.0,
            Grown::Turn(turn) => turn.angle(),
        }
    }

    /// Refuses numbers that cannot have been seen.
    pub(super) fn check(&self, number: usize, layouts: usize) -> Result<(), Error> {
        let wrong = |field, value, allowed| {
            Err(Error::Identify { what: format!("slip {number}"), field, value, allowed })
        };
        self.base.check("base load of a slip")?;
        match &self.grown {
            Grown::Load(load) => load.check("load of a slip")?,
            Grown::Turn(turn) => turn.check()?,
        }
        if matches!(self.grown, Grown::Load(load) if load == Wrench::ZERO) {
            return wrong("size of the load", 0.0, "more than 0");
        }
        if !(self.squeeze > 0.0 && self.squeeze <= 1e6) {
            return wrong("squeeze", self.squeeze, "more than 0 and at most 1e6 times the one given");
        }
        if self.layout >= layouts {
            return wrong("layout", self.layout as f64, "less than the number of layouts");
        }
        match self.scatter {
            Some(part) if !(part > 0.0 && part <= 10.0) => {
                wrong("scatter", part, "more than 0 and at most 10: 0.05 is five percent")
            }
            _ => Ok(()),
        }
    }
}
