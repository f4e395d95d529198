//! One grasp with all that screening computes before a load is known: its data, the numbers that follow from its springs alone, and the contact
//! forces due to its commands. Screening computes, for many grasps, the load factor of first slip, at which the first contact ceases to stick. A
//! command is the displacement that a finger would make if there were no object.

use nalgebra::SMatrix;

use super::answer_slots::AnswerSlots;
use super::block::{AnyGraspData, GraspData, Layout};
use super::cone::{OPENS_ONLY, STAYS};
use super::forces::Forces;
use super::method::{self, Method, is_a_pair, is_a_triangle};
use super::pair;
use super::question::{PreparedBlock, ScreeningQuestion};
use super::springs::StickingSprings;
use super::watch::{Measured, Watched};
use crate::error::{Error, Field};
use crate::grasp::{Contact, Hold};
use crate::numerics::{Compiled, by_axis, dot};

/// The data of one grasp, the numbers that follow from its springs alone (`ready`), and the contact forces due to its commands (`squeezed`), computed
/// once for all loads.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneGrasp<const C: usize> {
    pub(super) data: GraspData<C>,
    ready: StickingSprings<C, f64>,
    squeezed: Forces<C, f64>,
}

impl<const C: usize> OneGrasp<C> {
    /// Checks two to five contacts, and computes all that does not depend on a load. Returns an error for a malformed contact, or a contact that
    /// screening does not support.
    pub(super) fn new(contacts: &[Contact<C>]) -> Result<Self, Error> {
        let (data, ready) = (GraspData::new(contacts.len()), StickingSprings::none(Method::Edges));
        let mut grasp = Self { data, ready, squeezed: Forces::none() };
        let Self { data, ready, squeezed } = &mut grasp;
        write_all(data, contacts)?;
        let block = AnyGraspData::block(data);
        if Method::Motions.of(&block) == [true] {
            *ready = StickingSprings::none(Method::Motions);
        }
        ready.prepare(Compiled, &block);
        ready.squeeze(Compiled, &block, None, squeezed);
        Ok(grasp)
    }

    /// Answers a question about this grasp. A question may have several answers, for example one for each load; `answers` has one entry for each.
    pub(super) fn ask<Q: ScreeningQuestion<C>>(&self, question: &Q, answers: &mut [Q::Answer]) {
        let block = AnyGraspData::block(&self.data);
        let (ready, squeezed) = (&self.ready, &self.squeezed);
        // Three arrays of forces suffice for every question of screening; the compiler removes those that this question does not use.
        let [mut a, mut b, mut c] = [Forces::<C, f64>::none(); 3];
        let mut slots = AnswerSlots::new(answers, [true], [0, 1], Q::answers(block.contacts));
        let prepared = PreparedBlock { vectors: Compiled, block, ready, first: 0, squeezed };
        question.ask(&prepared, [&mut a, &mut b, &mut c], &mut slots);
    }

    /// The distances of measured contact forces of this grasp from the boundaries of their friction cones, and the load factor of first slip as a
    /// further load grows. `measured` holds these forces and the load.
    pub(super) fn watch(&self, measured: &Measured<'_, C>) -> Watched {
        let mut watched = [Watched::UNKNOWN];
        self.ask(measured, &mut watched);
        watched[0]
    }
}

/// Checks contacts and stores them in `data`. Stiffnesses are replaced by compliances if [`Method::Edges`] is used, i.e. if the unknowns are forces
/// along the lines between contacts. Returns an error for a malformed contact, or a contact that screening does not support.
pub(super) fn write_all<const C: usize>(
    data: &mut AnyGraspData<C>,
    contacts: &[Contact<C>],
) -> Result<(), Error> {
    let mut before: Option<(&Contact<C>, SMatrix<f64, C, C>)> = None;
    for (index, contact) in contacts.iter().enumerate() {
        contact.check(index)?;
        // Neighbouring points of a soft fingertip often have the same frame, which is then computed once.
        let same =
            before.filter(|(other, _)| other.normal == contact.normal && other.tangent == contact.tangent);
        let frame = same.map_or_else(|| contact.frame(index), |(_, frame)| Ok(frame))?;
        before = Some((contact, frame));
        write(data, index, contact, &frame)?;
        if contact.point_of_pad.is_some_and(|point| point > 0) && index > 0 {
            data.join_to_next(index - 1);
        }
    }
    if const { C == 2 } && is_a_pair(&data.block()) {
        pair::to_compliances(data);
    } else if const { C == 3 } && is_a_triangle(&data.block()) {
        method::to_compliances(data);
    }
    Ok(())
}

/// Stores the data of one contact with this frame. Returns an error for a contact held by a force or suction, or with unequal tangential stiffness in
/// space.
fn write<const C: usize>(
    data: &mut AnyGraspData<C>,
    index: usize,
    contact: &Contact<C>,
    frame: &SMatrix<f64, C, C>,
) -> Result<(), Error> {
    let suction = Some(contact.suction).filter(|suction| *suction != 0.0);
    for (field, value) in [(Field::Force, contact.force), (Field::Suction, suction)] {
        if let Some(value) = value {
            let allowed = "left out: screening knows fingers that hold positions";
            return Err(Error::Contact { contact: contact.label(index), field, value, allowed });
        }
    }
    let frictionless = contact.springs() == 1;
    let k = contact.series_stiffness_of_axes();
    let tangential = if frictionless { 0.0 } else { k[1] };
    if C == 3 && !frictionless && k[1] != k[C - 1] {
        return Err(Error::Contact {
            contact: contact.label(index),
            field: Field::SeriesStiffness,
            value: k[C - 1],
            allowed: "the same along both tangents",
        });
    }
    let mut a = contact.commanded();
    *data.at(Layout::<C>::PRESSED, index) = a[0] - contact.clearance;
    data.set_command_and_clearance(index, [a[0], contact.clearance]);
    a[0] = 0.0;
    if C == 3 {
        // If the command was given along the coordinate axes, it is not rotated into the frame and back, which would round it.
        a = if let Some(u) = contact.commanded_in_world() {
            let normal = &frame.as_slice()[..C];
            let along = dot(normal, u.as_slice());
            by_axis(|axis| u[axis] - normal[axis] * along)
        } else {
            by_axis(|axis| (1..C).fold(frame[(axis, 0)] * a[0], |sum, k| sum + frame[(axis, k)] * a[k]))
        };
    } else {
        // The tangent here is always (n_y, -n_x), whichever of the two tangents the caller's frame has.
        let turned = frame[(0, 1)] * frame[(1, 0)] - frame[(1, 1)] * frame[(0, 0)];
        a.swap_rows(0, 1);
        a[0] *= turned.signum();
    }
    for axis in 0..C {
        *data.at(Layout::<C>::POINT + axis, index) = contact.point[axis];
        *data.at(Layout::<C>::NORMAL + axis, index) = frame[(axis, 0)];
        *data.at(Layout::<C>::SHEARED + axis, index) = a[axis];
    }
    *data.at(Layout::<C>::SPRINGS, index) = k[0];
    *data.at(Layout::<C>::SPRINGS + 1, index) = tangential;
    let slides = contact.friction > 0.0 && contact.friction.is_finite();
    *data.at(Layout::<C>::FRICTION, index) = match contact.hold {
        Hold::Bonded => STAYS,
        _ if slides => contact.friction,
        Hold::Unilateral => OPENS_ONLY,
        Hold::KeptClosed => STAYS,
    };
    Ok(())
}
