//! What may change, for which loads.

use alloc::collections::BTreeMap;

use super::goal::ImproveGoal;
use super::surface::Surface;
use crate::ask::Grasp;
use crate::error::{Error, Field, MODERATE, is_moderate};
use crate::grasp::{Hold, Wrench};
use crate::squeeze::Loads;

/// More starts take minutes for what a few tell.
const MOST_STARTS: usize = 1_000;

/// Which loads are to slide as late as possible, or to leave most friction, which contacts may move along what, and how hard they may press. Checked when
/// it is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Improve<const C: usize> {
    pub(super) loads: Loads<C>,
    /// What acts besides, however large the loads are.
    pub(super) base: Wrench<C>,
    pub(super) goal: ImproveGoal,
    pub(super) surfaces: BTreeMap<usize, Surface<C>>,
    /// The greatest force of contacts that have one of their own, and of all others.
    pub(super) most: BTreeMap<usize, f64>,
    pub(super) most_of_all: Option<f64>,
    pub(super) starts: usize,
    pub(super) steps: usize,
    pub(super) seed: u64,
}

impl<const C: usize> Improve<C> {
    /// So that the least first slip of these loads comes as late as possible: each grows in proportion, one at a time, or a force of any direction.
    #[must_use]
    pub fn new(loads: impl Into<Loads<C>>) -> Self {
        Self {
            loads: loads.into(),
            base: Wrench::ZERO,
            goal: ImproveGoal::default(),
            surfaces: BTreeMap::new(),
            most: BTreeMap::new(),
            most_of_all: None,
            starts: 8,
            steps: 200,
            seed: 0,
        }
    }

    /// Beside a load that is there at rest: the weight of the object, when a push is to slide late.
    #[must_use]
    pub fn on_top_of(mut self, base: Wrench<C>) -> Self {
        self.base = base;
        self
    }

    /// With another goal than a late first slip.
    ///
    /// ```
    /// use grasp_lcp::improve::{Improve, ImproveGoal, Surface};
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that press with 10 N carry 4 N that hang 10 mm aside. With one jaw 4 mm higher, where the couple of normal forces balances
    /// // that, each carries 2 N of the 5 N that its friction can do.
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03), jaw(0.03)])?;
    /// let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    /// let question = Improve::new(Wrench::force_at([0.0, -4.0], [0.01, 0.0])).along(0, edge(-0.03)).along(1, edge(0.03));
    /// let improved = question.with_goal(ImproveGoal::Reserve).answered_by(&gripper)?;
    /// assert!((improved.after.expect("sticks") - 3.0).abs() < 1e-9);
    /// assert!(improved.to_string().starts_with("RESERVE of 3 N instead of"), "{improved}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn with_goal(mut self, goal: ImproveGoal) -> Self {
        self.goal = goal;
        self
    }

    /// A contact, from 0, that may move along a curve or surface, on which it has to lie; its normal follows.
    #[must_use]
    pub fn along(mut self, contact: usize, surface: Surface<C>) -> Self {
        self.surfaces.insert(contact, surface);
        self
    }

    /// All contacts may press with another force than is given, up to this one, N: that which they are [told to press
    /// with](crate::grasp::Contact::pressed_with), and the normal force at rest that comes of it. Without it commands stay as they are.
    #[must_use]
    pub fn pressing_at_most(mut self, force: f64) -> Self {
        self.most_of_all = Some(force);
        self
    }

    /// One contact, from 0, that may press with another force than is given, up to this one, N.
    #[must_use]
    pub fn contact_pressing_at_most(mut self, contact: usize, force: f64) -> Self {
        self.most.insert(contact, force);
        self
    }

    /// From so many starts beside the grasp given (default 8): the best of many that are scattered over the surfaces.
    #[must_use]
    pub fn with_starts(mut self, starts: usize) -> Self {
        self.starts = starts;
        self
    }

    /// With so many steps from each start at most, those refused included (default 200).
    #[must_use]
    pub fn with_steps(mut self, steps: usize) -> Self {
        self.steps = steps;
        self
    }

    /// With other starts: they depend on nothing but this number (default 0).
    #[must_use]
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// The greatest force of a contact, if it may press with another one than is given.
    pub(super) fn most_of(&self, contact: usize) -> Option<f64> {
        self.most.get(&contact).copied().or(self.most_of_all)
    }

    /// Refuses numbers out of range, loads that turn, and what does not stick alone.
    pub(crate) fn check(&self, grasp: &Grasp<C>) -> Result<(), Error> {
        grasp.refuse_hands("improve")?;
        self.base.check("base load")?;
        if self.starts > MOST_STARTS {
            let (what, allowed) = ("number of starts", "at most 1000");
            return Err(Error::Argument { what, value: self.starts as f64, allowed });
        }
        self.loads.check_size()?;
        let wrong = |field, fault| Err(Error::Question { question: "improve", field, fault });
        match &self.loads {
            Loads::Each(list) => list.iter().try_for_each(|load| load.check("load"))?,
            Loads::AnyForce { base, size, point } => {
                base.check("base load")?;
                if *size <= 0.0 {
                    return wrong(
                        "any_force",
                        "is zero, must be above: it is what a force is told as a multiple of",
                    );
                }
                if let Some(&value) = point.iter().find(|x| !is_moderate(**x)) {
                    return Err(Error::Argument { what: "point of the force", value, allowed: MODERATE });
                }
            }
            Loads::Turn(_) => {
                return wrong("turn", "is given, must be loads that grow or a force of any direction");
            }
        }
        let contacts = grasp.contacts();
        for contact in self.surfaces.keys().chain(self.most.keys()) {
            if *contact >= contacts.len() {
                let (what, allowed) = ("number of the contact", "less than the number of contacts");
                return Err(Error::Argument { what, value: *contact as f64, allowed });
            }
        }
        if self.surfaces.is_empty() && self.most.is_empty() && self.most_of_all.is_none() {
            return wrong(
                "surface",
                "is given of no contact and no greatest force, must be one: nothing may change",
            );
        }
        for (i, contact) in contacts.iter().enumerate() {
            let refused = |field, value, allowed| {
                Err(Error::Contact { contact: contact.label(i), field, value, allowed })
            };
            if contact.suction > 0.0 {
                return refused(Field::Suction, contact.suction, "0 where fingers are improved");
            }
            if let Some(surface) = self.surfaces.get(&i) {
                surface.check(&contact.label(i))?;
                if contact.point_of_pad.is_some() {
                    return wrong(
                        "surface",
                        "is given of a soft fingertip, must be of contacts that are points",
                    );
                }
            }
            if contact.point_of_pad.is_some() && self.most_of(i).is_some() {
                return wrong("at_most", "is given of a soft fingertip, must be of contacts that are points");
            }
            let pressed = self.most_of(i).filter(|_| contact.hold != Hold::Bonded);
            if let Some(force) = pressed.filter(|force| !(*force > 0.0 && is_moderate(*force))) {
                return refused(Field::Press, force, "at most a force above 0 and up to 1e50 N");
            }
        }
        Ok(())
    }
}
