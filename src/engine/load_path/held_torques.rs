//! Changes, along a load program, of the constant torques on torque-driven joints of a hand. Such a torque does not depend on the displacement of its
//! joint, as in a clamp whose screw is tightened. The program consists of legs (sections), along which loads, commands and torques change linearly.

use alloc::borrow::Cow;
use alloc::sync::Arc;

use super::leg::{Leg, LegGoal, LegLoad};
use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::Engine;
use crate::numerics::{Each, IntoList, Vector};
use crate::prelude::*;

impl<const C: usize> Leg<C> {
    /// A leg along which the constant torques on the joints of a hand change by `change`, one number for each joint: N m, or N for a prismatic joint.
    /// After the joints comes one number, N, for each contact with a given [constant force](crate::grasp::Contact::force): the change of this force.
    /// Inside the crate such a contact is moved by a prismatic joint of its own.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    /// use grasp_lcp::planar::{Contact, Leg, Wrench};
    ///
    /// // Two jaws on slides that are pressed with 10 N each; μ = 0.5.
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).torque(10.0)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 1e3).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?;
    /// // Both press with 20 N, and then a weight is hung on: it is lost at 2 · 0.5 · 20 N.
    /// let legs = [Leg::torques_by([10.0, 10.0]), Leg::load_to(Wrench::force([0.0, -40.0]))];
    /// let mut path = grasp.follow(Wrench::ZERO, &legs)?;
    /// path.run();
    /// let lost = path.end().and_then(|end| end.loss()).expect("both slide at last");
    /// assert!(lost.leg == 1 && (lost.fraction - 0.5).abs() < 1e-14);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn torques_by(change: impl IntoIterator<Item = f64>) -> Self {
        Self::STAY.and_torques_by(change)
    }

    /// A leg at whose end the constant torques on the joints are `torques`: one number for each joint, N m, or N for a prismatic joint. After the
    /// joints comes one number, N, for each contact with a given constant force: this force.
    pub fn torques_to(torques: impl IntoIterator<Item = f64>) -> Self {
        Self::STAY.and_torques_to(torques)
    }

    /// This leg with one more change: along it the constant torques on joints change by `change`, with the entries of [`Self::torques_by`]: joints,
    /// then contacts with a given constant force.
    pub fn and_torques_by(self, change: impl IntoIterator<Item = f64>) -> Self {
        Self { torques: LegGoal::By(change.into_iter().list()), ..self }
    }

    /// This leg with one more change: at its end the constant torques on joints are `torques`, with the entries of [`Self::torques_by`]: joints, then
    /// contacts with a given constant force.
    pub fn and_torques_to(self, torques: impl IntoIterator<Item = f64>) -> Self {
        Self { torques: LegGoal::To(torques.into_iter().list()), ..self }
    }

    /// Returns an error if this leg does not have one torque for each joint, or if a torque is not finite or too large. Also returns an error if the
    /// leg has torques while its load turns.
    pub(super) fn check_torques(&self, grasp: &Engine) -> Result<(), Error> {
        let (LegGoal::By(torques) | LegGoal::To(torques)) = &self.torques else { return Ok(()) };
        let what = "torques of a leg";
        let expected = grasp.held_torques().len();
        if torques.len() != expected {
            return Err(Error::JointCommands { what, given: torques.len(), expected });
        }
        if matches!(self.load, LegLoad::Turn(_)) {
            return Err(Error::CommandsWhileTurning);
        }
        match torques.iter().position(|x| !is_moderate(*x)) {
            Some(k) => Err(Error::Hand {
                what: format!("{what}, number {k}"),
                field: "torque",
                value: torques[k],
                allowed: MODERATE,
            }),
            None => Ok(()),
        }
    }
}

/// The constant torques on all joints at the beginning and at the end of the present leg. `None` if no leg so far changes them: the torques of the
/// hand then act.
#[derive(Debug, Clone, Default)]
pub(super) struct HeldTorques(Option<Arc<[Vec<f64>; 2]>>);

impl HeldTorques {
    /// Continues to the next leg. It begins with the torques at the end of the last leg or, if no leg has changed them, with `of_the_hand`. `goal`
    /// changes them along the new leg.
    pub(super) fn append(&mut self, of_the_hand: &[f64], goal: &LegGoal<Vec<f64>>) {
        if self.0.is_none() && *goal == LegGoal::Stay {
            return;
        }
        let from = self.0.as_ref().map_or(of_the_hand, |torques| &torques[1]).to_vec();
        let mut both = [Vec::new(), from];
        goal.append(&mut both);
        self.0 = Some(Arc::new(both));
    }

    /// The constant torques on the joints, minus the torques before the load program, as generalised forces on the coordinates of the grasp. One
    /// vector is for the beginning of the leg, one for its end. `None` if no leg so far changes them.
    pub(super) fn inside(&self, grasp: &Engine) -> Option<[Vector; 2]> {
        let (torques, linkage) = self.0.as_ref().zip(grasp.linkage())?;
        Some([0, 1].each(|end| {
            let mut inside = Vector::all_zero(grasp.size());
            for (j, torque) in torques[end].iter().enumerate() {
                let k = grasp.space().of_the_object() + j;
                inside[k] = (torque - linkage.joints[j].held_torque) / linkage.lengths[k];
            }
            inside
        }))
    }

    /// The constant torques on all joints: at the beginning of the leg if `end` is 0, at its end if `end` is 1. Empty if no leg so far changes them.
    pub(super) fn at_end(&self, end: usize) -> &[f64] {
        self.0.as_ref().map_or(&[], |torques| &torques[end])
    }

    /// The grasp `grasp` with the constant torques that act on its joints at the fraction `fraction` of the leg; `grasp` itself if no leg so far
    /// changes them.
    pub(super) fn apply<'g>(&self, grasp: Cow<'g, Engine>, fraction: f64) -> Cow<'g, Engine> {
        let Some(torques) = &self.0 else { return grasp };
        let [from, to] = &**torques;
        let now: Vec<f64> = from.iter().zip(to).map(|(from, to)| from + (to - from) * fraction).list();
        Cow::Owned(grasp.with_held_torques(&now))
    }
}
