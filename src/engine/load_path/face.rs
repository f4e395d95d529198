//! Conversion of onsets, load programs (sequences of changes of loads and commands) and load paths (the equilibria along a program). The engine uses
//! vectors of three components, callers in the plane of two. A ramp is a load, or commands of fingers, that change in proportion to one load factor;
//! the onset is the load factor at which the first contact ceases to stick.

use super::beyond::{Beyond, Continuation};
use super::drive_change::PartChange;
use super::event::{Change, ContactChange, Event, Loss, LossKind, PathEnd};
use super::jump::{Jump, JumpSlip};
use super::leg::{Leg, LegGoal, LegLoad};
use super::onset::{DepartingContact, Departure, Onset, OnsetEvent, StickingState};
use super::onset_margins::DepartingPart;
use super::ramp::Ramp;
use super::sensitivity::Derivative;
use super::stepped::Step;
use super::turn::{EdgeTouch, Turn};
use super::turn_questions::TurnOnset;
use crate::grasp::{Coordinates, Face, face_of_enum, face_of_struct, same_on_both_sides};

same_on_both_sides! { Coordinates, DepartingPart, LossKind, PartChange, StickingState, EdgeTouch }

face_of_struct! {
    Continuation { states, force_rates, twist_rate, rule }
    Event { leg, fraction, load, changes, drives, free_motions, other_continuations, state, jump }
    ContactChange { contact, what }
    Loss { leg, fraction, load, kind, contacts, drives, motion, jumped, against, leaves }
    Jump { changes, slips, reaches, snaps, moved, energy_lost, state }
    JumpSlip { contact, slip }
    Leg { load, commands, joints, torques, bodies }
    OnsetEvent { factor, load, leaving, drives, cone, local }
    DepartingContact { contact, how }
    Ramp { base, direction, command_change, joint_change }
    Derivative { twist, joints, forces }
    Step { leg, fraction, load, sliding, open, error }
    Turn { load, angle, tilts_bodies_about }
    TurnOnset { onset, touches, turn }
}

face_of_enum! {
    Beyond {
        Continues { 0: on },
        LimitLoad {},
        Snap {},
        Ends { reason: reason },
        WithoutVacuum { cups: cups },
        Undecided { doubt: doubt },
    }
    Change {
        Slides { direction: direction },
        Sticks {},
        Reverses { direction: direction },
        Turns { direction: direction },
        Opens {},
        Closes {},
        ClosesSliding { direction: direction },
    }
    PathEnd {
        Completed {},
        Lost { 0: loss },
        NoStart { 0: outcome },
        Undecided { leg: leg, fraction: fraction, doubt: doubt },
    }
    Onset {
        At { 0: event },
        Never {},
        AlreadySliding { 0: equilibrium },
        NoBase { 0: none },
        GivesWay { factor: factor, reason: reason },
        Undecided { 0: doubt },
    }
    Departure { Slides { direction: direction }, Opens {}, WouldPull {} }
    LegLoad { Straight { 0: goal }, Turn { 0: turn } }
}

impl<T: Face> Face for LegGoal<T> {
    type Inside = LegGoal<T::Inside>;
    const SAME: bool = T::SAME;

    fn widen(&self) -> Self::Inside {
        match self {
            Self::Stay => LegGoal::Stay,
            Self::By(change) => LegGoal::By(change.to_inside()),
            Self::To(goal) => LegGoal::To(goal.to_inside()),
        }
    }

    fn narrow(inside: Self::Inside) -> Self {
        match inside {
            LegGoal::Stay => Self::Stay,
            LegGoal::By(change) => Self::By(T::from_inside(change)),
            LegGoal::To(goal) => Self::To(T::from_inside(goal)),
        }
    }
}

impl<const C: usize> OnsetEvent<C> {
    /// Swaps the fields `local` and `drives` with those of `inside`, an onset of the engine. These fields have the same type in the engine and
    /// for the caller.
    pub(crate) fn exchange(&mut self, inside: &mut OnsetEvent<3>) {
        core::mem::swap(&mut self.local, &mut inside.local);
        core::mem::swap(&mut self.drives, &mut inside.drives);
    }

    /// Takes over all values of `inside`, an onset of the engine, and reuses the storage of its own list `leaving`.
    pub(crate) fn replace_with(&mut self, inside: &mut OnsetEvent<3>) {
        self.exchange(inside);
        (self.factor, self.load, self.cone) = (inside.factor, Face::from_inside(inside.load), inside.cone);
        self.leaving.clear();
        self.leaving.extend(inside.leaving.iter().cloned().map(DepartingContact::from_inside));
    }
}

impl<const C: usize> Ramp<C> {
    /// Writes this ramp, with vectors of three components, into `inside`, whose lists are reused.
    pub(crate) fn enter_into(&self, inside: &mut Ramp<3>) {
        (inside.base, inside.direction) = (self.base.into_inside(), self.direction.into_inside());
        inside.joint_change.clone_from(&self.joint_change);
        match (&self.command_change, &mut inside.command_change) {
            (None, kept) => *kept = None,
            (Some(given), kept) => {
                let kept = kept.get_or_insert_default();
                kept.clear();
                kept.extend(given.iter().map(|command| command.into_inside()));
            }
        }
    }
}
