//! Computes [`Lost`], the field of a verdict about the loss of equilibrium or the end of small motions. The load factor is the multiple of the
//! growing load that acts; 1 is the whole load. At gross slip every contact that presses slides. Motions are small within the limits of rotation,
//! slip and opening up to which the linear theory is trusted; at rest means at load factor 0.

use crate::contact::WEIGHTLESS;
use crate::equilibrium::{ContactState, Equilibrium, TooFar};
use crate::grasp::{Engine, WholeContact};
use crate::load_path::{EndOfSmallMotions, LoadPath, Loss, LossKind, PathEnd, Ramp};
use crate::numerics::{any_index, every_index};

use super::verdict::Lost;
use super::way_out::{WayOut, comes_apart, way_out};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl Engine {
    /// The point of the load path at which the theory of small motions ends: a motion becomes too large, or the grasp buckles. `None` unless it comes
    /// before a loss of equilibrium. Buckling is checked only if the points of action of the load at rest or of the whole load are known. It is not
    /// checked if the grasp is solved with band matrices ([`Self::may_buckle`]).
    pub(super) fn end_of_theory(&self, path: &LoadPath<'_, 3>, ramp: &Ramp<3>) -> Option<EndOfSmallMotions> {
        let far = end_before_loss(path);
        let may_buckle = |factor: f64| self.may_buckle(&ramp.load_at(factor));
        if may_buckle(0.0) || may_buckle(1.0) { path.end_of_theory_before(far) } else { far.cloned() }
    }

    /// The [`Lost`] of a verdict, for a loss of equilibrium at this load factor. `state` is the last equilibrium, if it is known. The caller fills in
    /// the fields about proofs and kinetic friction.
    pub(crate) fn lost(&self, factor: f64, loss: &Loss<3>, state: Option<Equilibrium<3>>) -> Lost<3> {
        let weightless = state.as_ref().map_or(0.0, |state| WEIGHTLESS * state.largest_force());
        let of = |i: usize| state.as_ref().map(|state| &state.contacts[i]);
        let presses = |i: usize| of(i).is_none_or(|contact| contact.force.norm() > weightless);
        let touches =
            |i: usize| presses(i) || of(i).is_some_and(|contact| contact.gap <= NEGLIGIBLE * self.length());
        let at_its_edge = |i: usize| loss.contacts.iter().any(|contact| contact.index == i);
        let sides = self.bodies().map(|bodies| &bodies.sides[..]);
        let slides = |i: usize| at_its_edge(i) && presses(i);
        let slides_out = |i: usize| {
            let leaving = sides.zip(loss.motion.as_ref());
            slides(i)
                && leaving.is_none_or(|(sides, motion)| comes_apart(&self.contacts()[i], sides[i], motion))
        };
        let cups = if loss.kind == LossKind::LetsGo { self.cups_open(at_its_edge) } else { Vec::new() };
        if !cups.is_empty() {
            return Lost::without_vacuum(factor, cups, state);
        }
        Lost {
            factor,
            kind: loss.kind,
            way_out: way_out(self, loss.motion.as_ref(), &touches),
            too_far: None,
            slide: self.wholes().with(&slides_out),
            falls_at_once: false,
            then_takes: None,
            is_gross_slip: any_index(self.len(), &slides)
                && every_index(self.len(), &|i| slides(i) || !presses(i)),
            drives: loss.drives.clone(),
            motion: loss.motion.clone(),
            state: state.map(Box::new),
            nothing_near: None,
        }
    }

    /// The [`Lost`] of a verdict if motions cease to be small at the load factor `factor`. `everything_slides` is the load factor at which gross slip
    /// began; `None` if it has not begun.
    pub(super) fn gone_too_far(
        &self,
        factor: f64,
        what: &TooFar,
        state: Option<Equilibrium<3>>,
        everything_slides: Option<f64>,
    ) -> Lost<3> {
        let contact = |i: usize| state.as_ref().map(|state| &state.contacts[i]);
        let slides = |i: usize| {
            contact(i).is_some_and(|contact| matches!(contact.state, ContactState::Sliding { .. }))
        };
        // A wire, a strap or a hinge that carries a force holds the object although every contact slides: no gross slip.
        let carries = |i: usize| {
            self.contacts()[i].link.is_some() && contact(i).is_some_and(|contact| contact.force.norm() > 0.0)
        };
        Lost {
            too_far: Some(what.clone()),
            slide: self.wholes().with(&slides),
            is_gross_slip: everything_slides.is_some_and(|from| from >= factor * (1.0 - SAME_EVENT))
                && !any_index(self.len(), &carries),
            ..Lost::alone(factor, LossKind::TooFar, WayOut::NotKnown, state)
        }
    }
}

/// If gross slip begins within this fraction of the load at which motions cease to be small, the verdict reports both as one. If the fraction were
/// larger, the verdict would hide how far the object is held after gross slip.
const SAME_EVENT: f64 = 0.01;

impl<const C: usize> Lost<C> {
    /// The [`Lost`] of a verdict if suction cups let go, because their lips are open all around at the load factor `factor`.
    fn without_vacuum(factor: f64, cups: Vec<WholeContact>, state: Option<Equilibrium<C>>) -> Self {
        Self::alone(factor, LossKind::LetsGo, WayOut::LetsGo { cups }, state)
    }

    /// A loss with these data; all lists are empty, all flags false, and all other data `None`.
    fn alone(factor: f64, kind: LossKind, way_out: WayOut<C>, state: Option<Equilibrium<C>>) -> Self {
        Self {
            factor,
            kind,
            way_out,
            too_far: None,
            slide: Vec::new(),
            is_gross_slip: false,
            falls_at_once: false,
            then_takes: None,
            drives: Vec::new(),
            motion: None,
            state: state.map(Box::new),
            nothing_near: None,
        }
    }
}

/// The end of small motions, if it comes before the loss of equilibrium by more than rounding, or if there is no loss; else `None`.
fn end_before_loss<'p>(path: &'p LoadPath<'_, 3>) -> Option<&'p EndOfSmallMotions> {
    let loss = path.end().and_then(PathEnd::loss);
    let before = |far: &&EndOfSmallMotions| {
        loss.is_none_or(|loss| (far.leg, far.fraction) < (loss.leg, loss.fraction * (1.0 - NEGLIGIBLE)))
    };
    path.end_of_small_motions().filter(before)
}
