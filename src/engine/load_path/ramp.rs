//! A ramp: a load, commands, or both, that change in proportion to one load factor τ, in addition to a constant base load. A command is a prescribed
//! displacement of a finger, or of a drive (the spring of a joint or tendon, with its force limit).

use crate::numerics::{IntoList, mapped};
use alloc::borrow::Cow;

use nalgebra::SVector;

#[cfg(feature = "serde")]
use super::written_leg::{check_drives, check_rows};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::prelude::*;

/// A load and commands that change in proportion to a load factor τ >= 0. The load is `base + τ direction`; commands are those of the grasp plus τ
/// times their given change. τ has no unit: if `direction` is a force of 1 N, τ is the magnitude of this force in newtons.
///
/// ```
/// use grasp_lcp::planar::{Ramp, Wrench};
///
/// // The weight grows by 2 N while two fingers each press 1 mm further, for each unit of τ.
/// let ramp = Ramp::load(Wrench::force([1.0, 0.0]), Wrench::force([0.0, -2.0])).with_commands([[1e-3, 0.0]; 2]);
/// assert_eq!(ramp.load_at(3.0), Wrench::force([1.0, -6.0]));
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Ramp<const C: usize> {
    pub(crate) base: Wrench<C>,
    pub(crate) direction: Wrench<C>,
    pub(crate) command_change: Option<Vec<SVector<f64, C>>>,
    pub(crate) joint_change: Option<Vec<f64>>,
}

impl<const C: usize> Ramp<C> {
    /// A ramp of the load, with constant finger commands. `base` is in N and N m, `direction` in N and N m per unit of the load factor.
    pub fn load(base: Wrench<C>, direction: Wrench<C>) -> Self {
        Self { base, direction, command_change: None, joint_change: None }
    }

    /// A ramp of the finger commands, with a constant load. `change` has one displacement for each contact per unit of the load factor, in its
    /// contact frame (m), the normal part positive into the object. All points of a soft fingertip follow one displacement, unless there is one for
    /// each point.
    pub fn commands(load: Wrench<C>, change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self::load(load, Wrench::ZERO).with_commands(change)
    }

    setters! {
        /// This ramp, along which the finger commands also change: `change` has one displacement for each contact per unit of the load factor, in its
        /// contact frame (m). The normal part is positive into the object.
        pub fn with_commands(mut self, change: impl IntoIterator<Item = impl Into<[f64; C]>>) {
            self.command_change = Some(vectors(change));
        }

        /// This ramp, along which the joint commands of a hand also change: one displacement for each joint and then each tendon, rad or m per unit
        /// of the load factor.
        pub fn with_joint_commands(mut self, change: impl IntoIterator<Item = f64>) {
            self.joint_change = Some(change.into_iter().list());
        }

        /// Multiplies the base load and the change of the load per unit of τ by a factor; the changes of commands are not multiplied.
        ///
        /// ```
        /// use grasp_lcp::planar::{Ramp, Wrench};
        ///
        /// // A weight of 1 N that turns out to be 10 % heavier, and grows as much faster.
        /// let weight = Wrench::force([0.0, -1.0]);
        /// let heavier = Ramp::load(weight, weight).with_load_times(1.1);
        /// assert_eq!(heavier.load_at(1.0), Wrench::force([0.0, -2.2]));
        /// ```
        pub fn with_load_times(mut self, factor: f64) {
            (self.base, self.direction) = (self.base * factor, self.direction * factor);
        }
    }

    /// This ramp with the changes of load and commands per unit of τ multiplied by a factor. The base load stays the same; a negative factor reverses
    /// the changes.
    pub(crate) fn times(&self, factor: f64) -> Self {
        let times = |change: &Vec<SVector<f64, C>>| mapped(change, &|a| a * factor);
        Self {
            base: self.base,
            direction: self.direction * factor,
            command_change: self.command_change.as_ref().map(times),
            joint_change: self.joint_change.as_ref().map(|change| mapped(change, &|a| a * factor)),
        }
    }

    /// Returns an error if a list of changes does not have one entry for each contact, or for each joint and tendon. Also returns an error for a ramp
    /// along which nothing changes.
    #[cfg(feature = "serde")]
    pub(crate) fn check_changes(&self, [contacts, drives, _]: [usize; 3]) -> Result<(), Error> {
        if let Some(change) = &self.command_change {
            check_rows(change.len(), "command changes", contacts)?;
        }
        if let Some(change) = &self.joint_change {
            check_drives(change.len(), "changes of joint commands", drives)?;
        }
        let mut changes = self.direction != Wrench::ZERO;
        for change in self.command_change.iter().flatten() {
            changes |= *change != SVector::<f64, C>::zeros();
        }
        for change in self.joint_change.iter().flatten() {
            changes |= *change != 0.0;
        }
        if changes { Ok(()) } else { Err(Error::NothingChanges) }
    }
}

impl Ramp<3> {
    /// For each contact and drive of a grasp the rate of its spring's offset (command minus clearance), m per unit of the load factor. Returns an
    /// error if the changes do not fit the grasp.
    pub(crate) fn offset_changes(&self, grasp: &Engine) -> Result<Vec<SVector<f64, 3>>, Error> {
        let mut changes = Vec::new();
        self.offset_changes_into(grasp, &mut changes)?;
        Ok(changes)
    }

    /// Writes the rates of the offsets of springs (command minus clearance), m per unit of the load factor, into the caller's list `changes`.
    pub(super) fn offset_changes_into(
        &self,
        grasp: &Engine,
        changes: &mut Vec<SVector<f64, 3>>,
    ) -> Result<(), Error> {
        let mut commands = Cow::Borrowed(&[][..]);
        if let Some(change) = &self.command_change {
            commands = grasp.commands_of_points(change, &|_| SVector::zeros(), "command changes")?;
        }
        if let Some(change) = &self.joint_change {
            grasp.check_joint_commands(change, "changes of joint commands")?;
        }
        grasp.changed_by(commands.iter().copied(), self.joint_change.as_deref(), changes);
        Ok(())
    }
}

impl<const C: usize> Ramp<C> {
    /// The load at a load factor, `base + τ direction`.
    pub fn load_at(&self, factor: f64) -> Wrench<C> {
        self.base + self.direction * factor
    }
}

/// A ramp of the load alone, from zero to this load at factor 1.
impl<const C: usize> From<Wrench<C>> for Ramp<C> {
    fn from(load: Wrench<C>) -> Self {
        Self::load(Wrench::ZERO, load)
    }
}

impl<const C: usize> From<&Wrench<C>> for Ramp<C> {
    fn from(load: &Wrench<C>) -> Self {
        Self::from(*load)
    }
}

impl<const C: usize> From<&Self> for Ramp<C> {
    fn from(ramp: &Self) -> Self {
        ramp.clone()
    }
}

pub(super) fn vectors<const C: usize>(
    list: impl IntoIterator<Item = impl Into<[f64; C]>>,
) -> Vec<SVector<f64, C>> {
    list.into_iter().map(|vector| SVector::from(vector.into())).list()
}
