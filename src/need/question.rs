//! What is sought, and for which loads.

use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::prelude::*;
use crate::squeeze::Loads;
use crate::words::Words;

/// What is to be kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Demand {
    /// The object is held; contacts may slide. The amount with which nothing slides is told beside it.
    #[default]
    Held,
    /// Nothing slides, on the way either.
    Sticks,
    /// The loads are put on and taken off in turn, again and again, and it comes to rest; see [`Grasp::shake`](crate::ask::Grasp::shake).
    Rests,
    /// The same, and contacts may slide to and fro for ever, as long as the object does not walk.
    Stays,
}

impl Demand {
    /// Whether loads are put on again and again.
    pub(super) fn repeats(self) -> bool {
        matches!(self, Self::Rests | Self::Stays)
    }
}

/// A quantity that is sought, with the loads that it is sought for. Checked when it is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Need<const C: usize> {
    pub(super) sought: Sought<C>,
    /// What acts besides, whatever the amount.
    pub(super) base: Wrench<C>,
    pub(super) demand: Demand,
    /// What the safe amount is safe against.
    pub(super) safety: Safety,
    pub(super) scan: usize,
    /// In which what becomes of other amounts is told.
    pub(super) words: Words,
}

/// The quantity.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Sought<const C: usize> {
    Squeeze {
        loads: Loads<C>,
    },
    Friction {
        loads: Loads<C>,
        contacts: Option<Vec<usize>>,
    },
    Load {
        loads: Loads<C>,
    },
    Arm {
        at: Wrench<C>,
        per_metre: Wrench<C>,
    },
    Angle {
        turn: Turn<C>,
    },
    /// Of a part by its name, or of the load at rest.
    Force {
        of: Option<String>,
        loads: Loads<C>,
    },
}

/// What is worse than said, for a safe amount.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Safety {
    /// The parts by which friction and squeeze are less.
    pub(super) lower: [f64; 2],
    /// How many times as large the loads are.
    pub(super) load: f64,
}

impl Safety {
    /// Everything is as it is said to be.
    pub(super) const NONE: Self = Self { lower: [0.0; 2], load: 1.0 };
}

impl<const C: usize> Need<C> {
    fn of(sought: Sought<C>) -> Self {
        let (words, safety) = (Words::default(), Safety { lower: [0.1, 0.05], load: 1.0 });
        Self { sought, base: Wrench::ZERO, demand: Demand::default(), safety, scan: 6, words }
    }

    /// The least squeeze for these loads: all commands in proportion, those of joints and torques that hold joints by force included.
    #[doc(alias = "grip force")]
    #[doc(alias = "clamping force")]
    #[must_use]
    pub fn squeeze(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Squeeze { loads: loads.into() })
    }

    /// The least coefficient of friction for these loads: one for all contacts that rub. Those of contacts that [slide](crate::grasp::Contact::kinetic) keep
    /// their proportion to it.
    #[must_use]
    pub fn friction(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Friction { loads: loads.into(), contacts: None })
    }

    /// The least coefficient of friction of some contacts, from 0, while the others keep theirs.
    #[must_use]
    pub fn friction_of(contacts: impl IntoIterator<Item = usize>, loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Friction { loads: loads.into(), contacts: Some(contacts.into_iter().collect()) })
    }

    /// How many times these loads may act: the greatest mass, or acceleration.
    #[doc(alias = "payload")]
    #[must_use]
    pub fn load(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Load { loads: loads.into() })
    }

    /// The greatest distance, m, that a force may be moved by: its wrench where it is, and how that changes for a metre.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::Wrench;
    ///
    /// // How far out along x may 20 N hang?
    /// let [here, a_metre_on] = [0.0, 1.0].map(|x| Wrench::force_at([0.0, -20.0], [x, 0.0]));
    /// let arm = Need::arm(here, a_metre_on - here);
    /// # let _ = arm;
    /// ```
    #[doc(alias = "overhang")]
    #[doc(alias = "lever")]
    #[must_use]
    pub fn arm(at: Wrench<C>, per_metre: Wrench<C>) -> Self {
        Self::of(Sought::Arm { at, per_metre })
    }

    /// The least load of a body, a lever or a screw for these loads, or the least command or force of a contact, a cable or a joint: that of the part of
    /// this name alone, as a multiple of what it has. Where more of it is too much the greatest is told, too.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
    ///
    /// // A screw drives the jaw of a vice with 500 N; the part is pulled across with 250 N, μ = 0.3 at both jaws.
    /// let jaw = |x: f64, way: f64| Contact::new([x, 0.0], [way, 0.0]).series_stiffness(1e7, 1e7).friction(0.3).on("part");
    /// let vice = Bodies::new([Body::new("part"), Body::new("jaw").load(Wrench::force([-500.0, 0.0]))])
    ///     .contacts([jaw(0.0, 1.0), jaw(0.06, -1.0).against("jaw")])
    ///     .links([Link::slide([0.08, 0.0], [1.0, 0.0], 0.03).to_ground("jaw")])
    ///     .grasp()?;
    /// let needed = vice.need(&Need::force("jaw", Wrench::force_at([0.0, 250.0], [0.03, 0.0])))?;
    /// assert!((needed.amount.bound().expect("some does") * 500.0 - 250.0 / 0.6).abs() < 1e-8);
    /// assert!(needed.to_string().starts_with("NEEDS 416.667 N on jaw so that it holds"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[doc(alias = "screw force", alias = "clamping force")]
    #[must_use]
    pub fn force(part: impl Into<String>, loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Force { of: Some(part.into()), loads: loads.into() })
    }

    /// The least load at rest for these loads, as a multiple of that [on top of which](Self::on_top_of) they come: a weight that presses an object on.
    #[must_use]
    pub fn load_at_rest(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Sought::Force { of: None, loads: loads.into() })
    }

    /// The greatest angle by which a load may turn.
    #[doc(alias = "tilt")]
    #[must_use]
    pub fn angle(turn: Turn<C>) -> Self {
        Self::of(Sought::Angle { turn })
    }

    /// This need on top of a load that is there at rest, whatever the amount: the weight of the object, when a push is sought.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that hold 10 N carry 6 N. How much more along the same line?
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03), jaw(0.03)])?;
    /// let [weight, push] = [6.0, 1.0].map(|newtons| Wrench::force([0.0, -newtons]));
    /// let most = gripper.need(&Need::load(push).on_top_of(weight))?.amount.bound().expect("4 N");
    /// assert!((most - 4.0).abs() < 1e-11);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn on_top_of(mut self, base: Wrench<C>) -> Self {
        self.base = base;
        self
    }

    /// This need where nothing may slide.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Of two jaws of unequal friction one slides before both do.
    /// let jaw = |x: f64, mu: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(mu).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, 0.4), jaw(0.03, 0.6)])?;
    /// let need = Need::squeeze(Wrench::force([0.0, -10.0])).if_lower_by(0.0, 0.0);
    /// let sticks = gripper.need(&need.to_stick())?.amount.bound().expect("some does");
    /// assert!((sticks - 5.0 / 4.0).abs() < 1e-11);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn to_stick(mut self) -> Self {
        self.demand = Demand::Sticks;
        self
    }

    /// This need where contacts may slide, as long as the object is held: the default.
    #[must_use]
    pub fn to_hold(mut self) -> Self {
        self.demand = Demand::Held;
        self
    }

    /// This need where the loads are put on and taken off in turn, again and again, until it [rests](Demand::Rests). A load that turns goes to the end
    /// of its turn and back, or round and round in full turns. Forces of any direction come in no order, and are refused.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // A block of 10 N on two feet, pulled by 1.5 N and rocked by 3 N m to and fro: what one foot leaves the other has to hold.
    /// let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(3e3, 1e3).friction(0.5);
    /// let block = Grasp::new([foot(-1.0), foot(1.0)])?;
    /// let rocked = [3.0, -3.0].map(|moment| Wrench::new([0.0, 0.0], moment));
    /// let need = Need::friction(rocked.to_vec()).on_top_of(Wrench::force([1.5, -10.0]));
    /// let least = |need: Need<2>| Ok::<_, grasp_lcp::Error>(block.need(&need)?.amount.bound().expect("some does"));
    /// assert!((least(need.clone().to_hold())? - 0.15).abs() < 1e-9);
    /// assert!((least(need.to_rest())? - 1.5 / (10.0 - 3.0)).abs() < 1e-9);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[doc(alias = "shakedown", alias = "vibration", alias = "cyclic load")]
    #[must_use]
    pub fn to_rest(mut self) -> Self {
        self.demand = Demand::Rests;
        self
    }

    /// As [`Self::to_rest`], but contacts may slide to and fro for ever: the object only must not [walk](Demand::Stays).
    #[must_use]
    pub fn to_stay(mut self) -> Self {
        self.demand = Demand::Stays;
        self
    }

    /// This need with a safe amount for friction and squeeze that are by these parts less than said (default 0.1 and 0.05; none for zeros).
    #[must_use]
    pub fn if_lower_by(mut self, friction: f64, squeeze: f64) -> Self {
        self.safety.lower = [friction, squeeze];
        self
    }

    /// This need with a safe amount for loads so many times as large as said, in place of less friction and squeeze; [`Self::if_lower_by`] after it
    /// asks for both.
    #[doc(alias = "factor of safety")]
    #[must_use]
    pub fn with_safety(mut self, factor: f64) -> Self {
        self.safety = Safety { lower: [0.0; 2], load: factor };
        self
    }

    /// This need whose answer tells numbers of other amounts in these words: with more digits than six, or fewer.
    #[must_use]
    pub fn told_in(mut self, words: Words) -> Self {
        self.words = words;
        self
    }

    /// This need with so many amounts looked at beside the search (default 6), to see whether more than one change of verdict lies among them.
    #[must_use]
    pub fn with_scan(mut self, amounts: usize) -> Self {
        self.scan = amounts;
        self
    }
}
