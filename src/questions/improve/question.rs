//! The question of finger placement: its loads, the contacts that may move and along which surfaces, and upper limits of the commanded normal forces.
//! The commanded normal force of a contact is that which its command causes with the object held in place. The command is the displacement that the
//! finger would make if there were no object. The load factor is the multiple of a load; at first slip the first contact ceases to stick. The base
//! load acts before the other loads grow.

use nalgebra::SVector;

use super::goal::ImproveGoal;
use super::surface::{Shape, Surface};
use crate::ask::Grasp;
use crate::error::{Error, Field, MODERATE, check_contact, is_moderate};
use crate::grasp::{Hold, Wrench};
use crate::load_path::Turn;
use crate::numerics::mapped;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsGiven;
use crate::squeeze::{LoadFields, Loads};

/// The question of finger placement: the loads, the goal, the contacts that may move along a surface, and the upper limits of the forces with which
/// fingers press. Invalid values are refused when the question is asked. In a scene file the surface along which a contact may move is a field of the
/// contact, not of this question.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[must_use]
pub struct Improve<const C: usize> {
    /// The load that acts before the other loads and stays constant.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) base: Option<Wrench<C>>,
    /// A load that grows in proportion to the load factor. Together with `any_force` it is a constant load.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) load: Option<Wrench<C>>,
    /// Loads that grow in proportion to the load factor, one at a time.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub(crate) loads: Vec<Wrench<C>>,
    /// The magnitude, N, of a force of any direction that acts at `at` in addition to the constant `load`. At load factor 1 the force has this
    /// magnitude.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) any_force: Option<f64>,
    /// The point where the force of any direction acts, m; the origin if not given.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub(super) at: Option<SVector<f64, C>>,
    /// The upper limit of the normal force with which a contact may press, N; if it is not given, commands keep their values.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub(super) at_most: Option<f64>,
    /// The quantity to maximise; the load factor of first slip if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) goal: Option<ImproveGoal>,
    /// Number of random starts in addition to the grasp of the scene; 8 if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) starts: Option<usize>,
    /// Upper limit of the number of steps from each start; 200 if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) steps: Option<usize>,
    /// The seed of the random starts; 0 if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) seed: Option<u64>,
    /// A load that turns. It has a field so that [`Grasp::improve`] can refuse it with an explanation.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) turn: Option<Turn<C>>,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) surfaces: Vec<(usize, Surface<C>)>,
    /// Contacts with an upper limit of their own for the normal force, and this limit, N.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) most: Vec<(usize, f64)>,
}

/// The position of a contact in a list sorted by contact index. If the list lacks the contact, the error holds the position at which to insert it.
fn place_of<T>(list: &[(usize, T)], contact: usize) -> Result<usize, usize> {
    list.binary_search_by_key(&contact, |(of, _)| *of)
}

impl<const C: usize> Improve<C> {
    /// Asks for the largest load factor of first slip under these loads. Each load grows from zero on its own, or a force of any direction grows.
    pub fn new(loads: impl Into<Loads<C>>) -> Self {
        let LoadFields { load, loads, any_force, at, turn } = loads.into().into();
        let (base, at_most, goal, starts, steps, seed) = (None, None, None, None, None, None);
        let (surfaces, most) = (Vec::new(), Vec::new());
        Self { base, load, loads, any_force, at, at_most, goal, starts, steps, seed, turn, surfaces, most }
    }

    /// The loads of this question, or an error unless the fields give them in exactly one way.
    pub(crate) fn given_loads(&self) -> Result<Loads<C>, Error> {
        Loads::of_fields("improve", (self.load, &self.loads), (self.any_force, self.at))
    }

    /// The base load, which acts before the other loads grow; zero if not given.
    pub fn base(&self) -> Wrench<C> {
        self.base.unwrap_or(Wrench::ZERO)
    }

    /// The load that grows, if the question has a single load; `None` for a list or a force of any direction.
    #[must_use]
    pub fn load(&self) -> Option<Wrench<C>> {
        self.load.filter(|_| self.any_force.is_none())
    }

    /// The value to maximise, by default the load factor of first slip.
    #[must_use]
    pub fn goal(&self) -> ImproveGoal {
        self.goal.unwrap_or_default()
    }

    setters! {
        /// Adds a base load, which acts at load factor 0 and stays constant. If the load is a push, the base load may be the weight of the object.
        pub fn on_top_of(mut self, base: Wrench<C>) { self.base = Some(base); }

        /// Sets the value to maximise, by default the load factor of first slip.
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
        /// let improved = gripper.improve(&question.with_goal(ImproveGoal::Reserve))?;
        /// assert!((improved.after.expect("sticks") - 3.0).abs() < 1e-9);
        /// assert!(improved.to_string().starts_with("RESERVE of 3 N instead of"), "{improved}");
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        pub fn with_goal(mut self, goal: ImproveGoal) { self.goal = Some(goal); }
    }

    /// Lets contact `contact` (from 0) move along a curve or surface, on which the given contact point has to lie. The contact normal follows the
    /// surface.
    pub fn along(mut self, contact: usize, surface: Surface<C>) -> Self {
        match place_of(&self.surfaces, contact) {
            Ok(place) => self.surfaces[place].1 = surface,
            Err(place) => self.surfaces.insert(place, (contact, surface)),
        }
        self
    }

    /// Lets the search change the normal command of all contacts, up to a force of `force`, N. The limit applies to the force that contacts are
    /// [commanded to press with](crate::grasp::Contact::pressed_with) and to the normal force under the base load. Without this limit commands stay
    /// as given.
    pub fn pressing_at_most(mut self, force: f64) -> Self {
        self.at_most = Some(force);
        self
    }

    /// Lets the search change the normal command of one contact (from 0), up to a force of `force`, N. The limit applies to the force that the
    /// contact is [commanded to press with](crate::grasp::Contact::pressed_with) and to its normal force under the base load.
    pub fn contact_pressing_at_most(mut self, contact: usize, force: f64) -> Self {
        match place_of(&self.most, contact) {
            Ok(place) => self.most[place].1 = force,
            Err(place) => self.most.insert(place, (contact, force)),
        }
        self
    }

    setters! {
        /// Sets the number of random starts in addition to the given grasp (default 8). They are the best of 24 times as many random choices of
        /// places on the surfaces.
        pub fn with_starts(mut self, starts: usize) { self.starts = Some(starts); }

        /// Sets the upper limit of the number of steps from each start, including refused steps (default 200).
        pub fn with_steps(mut self, steps: usize) { self.steps = Some(steps); }

        /// Sets the seed of the random starts (default 0): with the same seed a question has the same starts.
        pub fn with_seed(mut self, seed: u64) { self.seed = Some(seed); }
    }
}

impl Improve<3> {
    pub(super) fn starts(&self) -> usize {
        self.starts.unwrap_or(8)
    }

    pub(super) fn steps(&self) -> usize {
        self.steps.unwrap_or(200)
    }

    /// The surface along which this contact may move; `None` if it has to stay in place.
    pub(super) fn surface_of(&self, contact: usize) -> Option<&Shape> {
        place_of(&self.surfaces, contact).ok().map(|place| &self.surfaces[place].1.0)
    }

    /// The greatest allowed normal force of a contact, N; `None` if its command may not change.
    pub(super) fn most_of(&self, contact: usize) -> Option<f64> {
        place_of(&self.most, contact).ok().map(|place| self.most[place].1).or(self.at_most)
    }

    /// Returns an error for numbers out of range, loads that turn, soft fingertips with a surface or greatest force, suction, hands, and questions in
    /// which nothing may change.
    pub(super) fn check(&self, grasp: &Grasp<3>) -> Result<(), Error> {
        grasp.refuse_hands("improve")?;
        let space = grasp.engine.space();
        self.base().check_in(space, "base load")?;
        // A search from more starting grasps takes minutes and hardly finds a better grasp.
        if self.starts() > 1_000 {
            let (what, allowed) = ("number of starts", "at most 1000");
            return Err(Error::Argument { what, value: self.starts() as f64, allowed });
        }
        let wrong = |field, fault| Err(Error::Question { question: "improve", field, fault });
        if self.turn.is_some() {
            return wrong("turn", "is given, must be loads that grow or a force of any direction");
        }
        let loads = self.given_loads()?;
        loads.check_size()?;
        match &loads {
            Loads::Each(list) => list.iter().try_for_each(|load| load.check_in(space, "load"))?,
            Loads::AnyForce { base, size, point } => {
                base.check_in(space, "base load")?;
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
            Loads::Turn(_) => {}
        }
        let contacts = grasp.contacts();
        let mut named = mapped(&self.surfaces, &|(contact, _)| *contact);
        named.extend(mapped(&self.most, &|(contact, _)| *contact));
        for contact in named {
            check_contact(contact, contacts.len())?;
        }
        if self.surfaces.is_empty() && self.most.is_empty() && self.at_most.is_none() {
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
            if let Some(surface) = self.surface_of(i) {
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
