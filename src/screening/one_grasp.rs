//! One grasp prepared for screening.

use super::balance::RigidBody;
use super::block::{Block, Layout, OneScene};
use super::cone::{OPENS_ONLY, STAYS};
use super::forces::Forces;
use super::method::{self, Method};
use super::pair::{self, Pair};
use super::question::{Scenes, ScreeningQuestion};
use super::springs::StickingSprings;
use super::told::Told;
use super::triangle::Triangle;
use super::watch::{Measured, Watched};
use crate::error::{Error, Field};
use crate::grasp::{Contact, Hold};
use crate::numerics::Compiled;

/// The data of one grasp that do not depend on the load.
#[derive(Debug, Clone, Copy)]
pub(super) struct OneGrasp<const D: usize, const C: usize, const N: usize> {
    pub(super) scene: OneScene<C, N>,
    ready: Ready<D, C, N>,
    squeezed: Forces<C, N, f64>,
}

#[derive(Debug, Clone, Copy)]
#[allow(clippy::large_enum_variant)] // none is ever moved about alone
enum Ready<const D: usize, const C: usize, const N: usize> {
    /// Closed form for a pair in the plane.
    Pair(Pair<f64>),
    /// Forces along the edges of a triangle.
    Triangle(Triangle<C, f64>),
    /// Factorised stiffness of the object.
    RigidBody(RigidBody<D, C, N, f64>),
}

impl<const D: usize, const C: usize, const N: usize> OneGrasp<D, C, N> {
    /// Checks and prepares the contacts.
    pub(super) fn new(contacts: &[Contact<C>; N]) -> Result<Self, Error> {
        let pair = C == 2 && N == 2;
        let ready = if pair {
            Ready::Pair(StickingSprings::<C, N, f64>::none())
        } else {
            Ready::RigidBody(RigidBody::none())
        };
        let mut grasp = Self { scene: OneScene::EMPTY, ready, squeezed: Forces::none() };
        let Self { scene, ready, squeezed } = &mut grasp;
        for (index, contact) in contacts.iter().enumerate() {
            write(scene, index, contact)?;
        }
        if pair {
            pair::to_compliances(scene);
        } else if C == 3 && N == 3 {
            method::to_compliances(scene);
            if Method::Edges.of(&scene.block()) == [true] {
                *ready = Ready::Triangle(StickingSprings::<C, N, f64>::none());
            }
        }
        let block = scene.block();
        match ready {
            Ready::Pair(pair) => prepare(pair, &block, squeezed),
            Ready::Triangle(triangle) => prepare(triangle, &block, squeezed),
            Ready::RigidBody(body) => prepare(body, &block, squeezed),
        }
        Ok(grasp)
    }

    /// Answers a question; `answers` has as many slots as the question has answers.
    pub(super) fn ask<Q: ScreeningQuestion<C>>(&self, question: &Q, answers: &mut [Q::Answer]) {
        let (block, squeezed) = (self.scene.block(), &self.squeezed);
        match &self.ready {
            Ready::Pair(pair) => answer(block, pair, squeezed, question, answers),
            Ready::Triangle(triangle) => answer(block, triangle, squeezed, question, answers),
            Ready::RigidBody(body) => answer(block, body, squeezed, question, answers),
        }
    }

    /// Evaluates the margins of measured forces.
    pub(super) fn watch(&self, measured: &Measured<'_, C>) -> Watched {
        let mut watched = [Watched::UNKNOWN];
        self.ask(measured, &mut watched);
        watched[0]
    }
}

fn answer<P: StickingSprings<C, N, f64>, const C: usize, const N: usize, Q: ScreeningQuestion<C>>(
    mut block: Block<'_, C, f64>,
    ready: &P,
    squeezed: &Forces<C, N, f64>,
    question: &Q,
    answers: &mut [Q::Answer],
) {
    block.contacts = P::CONTACTS.unwrap_or(block.contacts);
    // Forces that a question does not use are optimised away.
    let (mut a, mut b, mut c) = (Forces::none(), Forces::none(), Forces::none());
    let scenes = Scenes { vectors: Compiled, block, ready, squeezed };
    let mut told = Told::new(answers, [true], [0, 1], Q::answers(N));
    question.ask(&scenes, [&mut a, &mut b, &mut c], &mut told);
}

/// Prepares a scene, and computes the forces of its commands.
fn prepare<P: StickingSprings<C, N, f64>, const C: usize, const N: usize>(
    ready: &mut P,
    block: &Block<'_, C, f64>,
    squeezed: &mut Forces<C, N, f64>,
) {
    ready.prepare(Compiled, block);
    ready.squeeze(Compiled, block, None, squeezed);
}

/// Checks a contact and stores its numbers.
fn write<const C: usize, const N: usize>(
    scene: &mut OneScene<C, N>,
    index: usize,
    contact: &Contact<C>,
) -> Result<(), Error> {
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
