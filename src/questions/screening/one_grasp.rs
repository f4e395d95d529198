//! One grasp prepared for screening.

use super::answer_slots::AnswerSlots;
use super::block::{Layout, OneScene};
use super::cone::{OPENS_ONLY, STAYS};
use super::forces::Forces;
use super::method::{self, Method, is_a_pair, is_a_triangle};
use super::pair;
use super::question::{Scenes, ScreeningQuestion};
use super::springs::StickingSprings;
use super::watch::{Measured, Watched};
use crate::error::{Error, Field};
use crate::grasp::{Contact, Hold};
use crate::numerics::Compiled;

/// The data of one grasp that do not depend on the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneGrasp<const C: usize> {
    pub(super) scene: OneScene<C>,
    ready: StickingSprings<C, f64>,
    squeezed: Forces<C, f64>,
}

impl<const C: usize> OneGrasp<C> {
    /// Checks and prepares the contacts, two to five.
    pub(super) fn new(contacts: &[Contact<C>]) -> Result<Self, Error> {
        let (scene, ready) = (OneScene::new(contacts.len()), StickingSprings::none(Method::Edges));
        let mut grasp = Self { scene, ready, squeezed: Forces::none() };
        let Self { scene, ready, squeezed } = &mut grasp;
        for (index, contact) in contacts.iter().enumerate() {
            write(scene, index, contact)?;
        }
        if const { C == 2 } && is_a_pair(&scene.block()) {
            pair::to_compliances(scene);
        } else if const { C == 3 } && is_a_triangle(&scene.block()) {
            method::to_compliances(scene);
        }
        let block = scene.block();
        if Method::Motions.of(&block) == [true] {
            *ready = StickingSprings::none(Method::Motions);
        }
        ready.prepare(Compiled, &block);
        ready.squeeze(Compiled, &block, None, squeezed);
        Ok(grasp)
    }

    /// Answers a question; `answers` has as many slots as the question has answers.
    pub(super) fn ask<Q: ScreeningQuestion<C>>(&self, question: &Q, answers: &mut [Q::Answer]) {
        let (block, ready, squeezed) = (self.scene.block(), &self.ready, &self.squeezed);
        // Forces that a question does not use are optimised away.
        let (mut a, mut b, mut c) = (Forces::none(), Forces::none(), Forces::none());
        let mut told = AnswerSlots::new(answers, [true], [0, 1], Q::answers(block.contacts));
        let scenes = Scenes { vectors: Compiled, block, ready, squeezed };
        question.ask(&scenes, [&mut a, &mut b, &mut c], &mut told);
    }

    /// Evaluates the margins of measured forces.
    pub(super) fn watch(&self, measured: &Measured<'_, C>) -> Watched {
        let mut watched = [Watched::UNKNOWN];
        self.ask(measured, &mut watched);
        watched[0]
    }
}

/// Checks a contact and stores its numbers.
fn write<const C: usize>(scene: &mut OneScene<C>, index: usize, contact: &Contact<C>) -> Result<(), Error> {
    contact.check(index)?;
    let suction = Some(contact.suction).filter(|suction| *suction != 0.0);
    for (field, value) in [(Field::Force, contact.force), (Field::Suction, suction)] {
        if let Some(value) = value {
            let allowed = "left out: screening knows fingers that hold positions";
            return Err(Error::Contact { contact: contact.label(index), field, value, allowed });
        }
    }
    let frame = contact.frame(index)?;
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
    *scene.at(Layout::<C>::PRESSED, index) = a[0] - contact.clearance;
    scene.part(index, [a[0], contact.clearance]);
    a[0] = 0.0;
    if C == 3 {
        a = frame * a;
    } else {
        // Across the normal, the direction is (n_y, -n_x), whichever way the caller's tangent points.
        let turned = frame[(0, 1)] * frame[(1, 0)] - frame[(1, 1)] * frame[(0, 0)];
        a.swap_rows(0, 1);
        a[0] *= turned.signum();
    }
    for axis in 0..C {
        *scene.at(Layout::<C>::POINT + axis, index) = contact.point[axis];
        *scene.at(Layout::<C>::NORMAL + axis, index) = frame[(axis, 0)];
        *scene.at(Layout::<C>::SHEARED + axis, index) = a[axis];
    }
    *scene.at(Layout::<C>::SPRINGS, index) = k[0];
    *scene.at(Layout::<C>::SPRINGS + 1, index) = tangential;
    let slides = contact.friction > 0.0 && contact.friction.is_finite();
    *scene.at(Layout::<C>::FRICTION, index) = match contact.hold {
        Hold::Bonded => STAYS,
        _ if slides => contact.friction,
        Hold::Unilateral => OPENS_ONLY,
        Hold::KeptClosed => STAYS,
    };
    Ok(())
}
