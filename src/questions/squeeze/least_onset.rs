//! The least load factor at which a contact stops sticking, over all commands and loads within bounds, exactly.
//!
//! While all contacts stick, forces are linear in commands and loads. Data within their bounds form a box. For all load factors τ >= 0 the margin
//! `a·F` of a sticking condition `a·F >= 0` is least at the same corner of this box. The sign of each datum's contribution to `a·F` determines the
//! corner:
//!
//! ```text
//! F(τ) = F⁰ + Σ δ_p c_p + τ (F¹ + Σ ε_q c_q),   |δ_p| <= b_p,   |ε_q| <= b_q:       δ_p = -b_p sign(a·c_p),   ε_q alike
//! ```
//!
//! [`Edges::in_a_box`] returns a few conditions of a contact, among which is the one with the least margin over all corners.

use nalgebra::SVector;

use super::bounds::Bounds;
#[cfg(doc)]
use crate::contact::Edges;
use crate::contact::Line;
use crate::equilibrium::{ContactForces, StickingResponse};
use crate::error::Error;
use crate::grasp::{Contact, Engine, Motion, Wrench};
use crate::load_path::Ramp;
use crate::numerics::{Vector, mapped};
use crate::prelude::*;
use crate::search::Settings;

/// The answer to "at which load factor does a contact first stop sticking, in the worst case of commands and loads within these bounds?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LeastOnset<const C: usize> {
    /// At this load factor a contact stops sticking in the worst case; at smaller ones all contacts stick for all data within the bounds.
    #[non_exhaustive]
    At {
        /// The load factor, exact up to rounding. All loads are the base load plus this multiple of the load direction.
        factor: f64,
        /// The contact that stops sticking, counted from 0.
        contact: usize,
        /// The finger commands of the worst case, in the contact frames, m.
        commands: Vec<SVector<f64, C>>,
        /// The base load and the load direction of the worst case, errors included.
        ramp: Ramp<C>,
    },
    /// All contacts keep sticking for all data within the bounds, at every load factor.
    Never,
    /// For some data within the bounds this contact is open, slides or is on the edge of sticking at load factor 0 already.
    NotSticking {
        /// The contact that does not stick, counted from 0.
        contact: usize,
    },
    /// Nothing resists this motion, and the base load, the load direction or an error within its bound does work on it.
    GivesWay {
        /// This motion, of unit size.
        motion: Motion<C>,
    },
}

/// A command component (contact, axis) or a component of a load that has an error bound.
#[derive(Clone, Copy)]
enum Datum {
    Command(usize, usize),
    Base(usize),
    Direction(usize),
}

/// The changes of all contact forces if the error of `datum` equals its bound.
struct Share {
    datum: Datum,
    bound: f64,
    forces: ContactForces,
}

impl Engine {
    /// Implements [`Grasp::least_onset_within`](crate::ask::Grasp::least_onset_within).
    pub(crate) fn least_onset_within(
        &self,
        ramp: &Ramp<3>,
        bounds: &Bounds<3>,
        settings: &Settings,
    ) -> Result<LeastOnset<3>, Error> {
        self.refuse_hands("least_onset_within")?;
        bounds.check(self)?;
        let base = self.load_alone(&ramp.base, "base load")?;
        ramp.direction.check_in(self.space(), "load direction")?;
        let (direction, changes) = (self.inside_unchecked(&ramp.direction), ramp.offset_changes(self)?);
        let sticking = StickingResponse::new(self, settings);
        let known = || -> Result<_, Motion<3>> {
            let base = sticking.forces(&self.offsets(), &base)?;
            Ok((base, sticking.forces(&changes, &direction)?, shares(&sticking, bounds)?))
        };
        let (base, rate, shares) = match known() {
            Ok(known) => known,
            Err(motion) => return Ok(LeastOnset::GivesWay { motion }),
        };
        let mut least: Option<(f64, usize, Vec<f64>)> = None;
        for (contact, edges) in sticking.edges.iter().enumerate() {
            let sides: Vec<_> = mapped(&shares, &|share| share.forces.of[contact]);
            for row in edges.in_a_box(&sides) {
                let signs: Vec<f64> = mapped(&sides, &|side| -row.dot(side).signum());
                let line = corner([&base, &rate], &shares, &signs, contact);
                if !edges.hold(&line.force, line.force_size) {
                    return Ok(LeastOnset::NotSticking { contact });
                }
                let Some((exit, _)) = sticking.law(contact).first_exit(&line) else { continue };
                if least.as_ref().is_none_or(|(factor, ..)| exit.step < *factor) {
                    least = Some((exit.step, contact, signs));
                }
            }
        }
        Ok(match least {
            None => LeastOnset::Never,
            Some((factor, contact, signs)) => {
                let (commands, ramp) = self.case(ramp, &shares, &signs);
                LeastOnset::At { factor, contact, commands, ramp }
            }
        })
    }

    /// The commands and the ramp if the error of each datum equals its bound times its entry in `signs`.
    fn case(&self, ramp: &Ramp<3>, shares: &[Share], signs: &[f64]) -> (Vec<SVector<f64, 3>>, Ramp<3>) {
        let space = self.space();
        let mut commands: Vec<_> = mapped(self.contacts(), &Contact::commanded);
        let (mut base, mut direction) = (ramp.base.coordinates(space), ramp.direction.coordinates(space));
        for (share, sign) in shares.iter().zip(signs) {
            let shift = sign * share.bound;
            match share.datum {
                Datum::Command(contact, axis) => commands[contact][axis] += shift,
                Datum::Base(component) => base[component] += shift,
                Datum::Direction(component) => direction[component] += shift,
            }
        }
        let (base, direction) = (Wrench::among(space, &base), Wrench::among(space, &direction));
        (commands, Ramp { base, direction, ..ramp.clone() })
    }
}

/// A [`Share`] for each datum whose error bound is above zero; an error with the motion if its load works on a motion without resistance.
fn shares(sticking: &StickingResponse, bounds: &Bounds<3>) -> Result<Vec<Share>, Motion<3>> {
    let space = sticking.grasp.space();
    let nothing = Vector::zeros();
    let mut shares = Vec::new();
    for (contact, bounds) in bounds.commands.iter().flatten().enumerate() {
        for (axis, &bound) in bounds.iter().enumerate().filter(|(_, bound)| **bound > 0.0) {
            let mut offsets = sticking.at_rest();
            offsets[contact][axis] = bound;
            let forces = sticking.forces(&offsets, &nothing)?;
            shares.push(Share { datum: Datum::Command(contact, axis), bound, forces });
        }
    }
    for (bounds, datum) in
        [(&bounds.base, Datum::Base as fn(usize) -> Datum), (&bounds.direction, Datum::Direction)]
    {
        for (k, &bound) in bounds.coordinates(space).iter().enumerate().filter(|(_, bound)| **bound > 0.0) {
            let mut load = Vector::zeros();
            load[k] = bound;
            let forces = sticking.by_load(&Wrench::among(space, &load))?;
            shares.push(Share { datum: datum(k), bound, forces });
        }
    }
    Ok(shares)
}

/// The force of a contact, as a linear function of the load factor, if the error of each datum equals its bound times its entry in `signs`.
fn corner([base, rate]: [&ContactForces; 2], shares: &[Share], signs: &[f64], contact: usize) -> Line {
    let mut line = Line {
        force: base.of[contact],
        rate: rate.of[contact],
        force_size: base.sizes[contact],
        rate_size: rate.sizes[contact],
    };
    for (share, sign) in shares.iter().zip(signs) {
        let (more, size) = (share.forces.of[contact] * *sign, share.forces.sizes[contact]);
        if matches!(share.datum, Datum::Direction(_)) {
            (line.rate, line.rate_size) = (line.rate + more, line.rate_size + size);
        } else {
            (line.force, line.force_size) = (line.force + more, line.force_size + size);
        }
    }
    line
}
