//! Contact forces and twist under a load that grows along a ramp, for `in_slips`. They are affine functions of the load factor and of the slips of
//! sliding contacts. From these functions follow the rates of load factor and slips with which sliding contacts stay on the boundaries of their
//! cones. The margin of a contact is μ F_n - |F_t|, the distance of its force from the boundary of its cone. A path point is the list of the weights
//! with which forces and twist are summed: 1, the load factor, and two tangential slips (m) of each sliding contact. Motions are small within limits
//! of rotation and slip up to which the linear theory is trusted.

use nalgebra::SVector;

use crate::contact::{Mode, State, tangential, tangential_norm};
use crate::equilibrium::{CountedMotion, MotionData};
use crate::grasp::Engine;
use crate::numerics::{Equation, MOST_UNKNOWNS, Reals, Vector, solved};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;
use crate::search::SmallMotions;

/// Upper limit of the number of sliding contacts whose slips `in_slips` takes as unknowns of its equations. With more sliding contacts, following an
/// [arc](super::arc), on which directions of sliding turn, takes less time: each stage of the integration along an arc solves one equation for each
/// coordinate, rather than for each sliding contact.
pub(super) const MOST_SLIDING: usize = MOST_UNKNOWNS - 1;

/// A vector for each sliding contact, in the order of [`Slips::sliding`], followed by zero vectors.
pub(super) type SlipVector = [SVector<f64, 3>; MOST_SLIDING];

/// Sliding contacts with the responses to their slips. Forces and twist are a sum of terms, whose weights are the entries of a path point.
pub(super) struct Slips<'g> {
    pub(super) grasp: &'g Engine,
    pub(super) problem: Problem<'g>,
    pub(super) linear_problem: alloc::sync::Arc<LinearProblem>,
    /// Contact forces of all terms, one term after the other. The first two terms are the forces at load factor 0 and their rates with respect to the
    /// load factor. Then follow the responses to a unit slip of each sliding contact along both tangents.
    pub(super) forces: Vec<SVector<f64, 3>>,
    /// Twists of the object in all terms: at load factor 0, per unit of the load factor, and per unit slip along each tangent.
    pub(super) twists: Vec<Vector>,
    /// Indices of the sliding contacts, in the order in which they began to slide.
    pub(super) sliding: Vec<usize>,
    /// The largest contact force, N, at the load at which the first contact begins to slide; other forces are compared with it.
    pub(super) largest: f64,
    /// The upper limit of the load factor, given by the caller, up to which the growing load is followed.
    pub(super) most: f64,
    /// The slip, m, that counts as much in the arclength as one unit of the load factor: arclength is measured along the curve (slips / unit, load
    /// factor).
    pub(super) unit: f64,
    pub(super) small: SmallMotions,
    /// The limit of small motions for slips, m.
    pub(super) slip_limit: f64,
}

impl Slips<'_> {
    /// Adds a term to the sum of forces and twists: their values at load factor 0, their rates with respect to the load factor, or their
    /// responses to a unit slip.
    pub(super) fn push(&mut self, ForcesAndTwist { forces, twist }: &ForcesAndTwist) {
        self.forces.extend_from_slice(forces);
        self.twists.push(twist.clone());
    }

    /// Number of contacts of the grasp, which has no drives.
    pub(super) fn contacts(&self) -> usize {
        self.problem.len()
    }

    pub(super) fn sticking(&self) -> impl Iterator<Item = usize> {
        (0..self.contacts()).filter(|i| !self.sliding.contains(i))
    }

    /// Writes to `rates` the rates of the path point `at`, per unit of arclength, with which the margins `μ F_n - |F_t|` of sliding contacts stay
    /// zero. Of the two opposite senses, the one with a positive inner product with the rates `along` is taken. `None` if the rates are not unique.
    pub(super) fn flow(&self, at: &[f64], along: &[f64], rates: &mut [f64]) -> Option<()> {
        let (directions, count) = (self.directions(at), self.sliding.len());
        let (mut equations, mut scale) = (self.margin_rates(&directions), 0.0_f64);
        equations[..count].as_flattened().iter().for_each(|x| scale = scale.max(x.abs()));
        let last = &mut equations[count];
        (last[0], last[MOST_UNKNOWNS]) = (along[1] * scale, 1.0);
        for ((x, p), slip) in last[1..].iter_mut().zip(&directions).zip(along[2..].chunks_exact(2)) {
            *x = (p[1] * slip[0] + p[2] * slip[1]) * (scale / self.unit);
        }
        let x = solved(&mut equations[..=count])?;
        let inverse = 1.0 / x.iter().map(|x| x * x).added().sqrt();
        (rates[0], rates[1]) = (0.0, x[0] * inverse);
        for ((p, slip), x) in directions.iter().zip(rates[2..].chunks_exact_mut(2)).zip(&x[1..]) {
            let slips = x * inverse * self.unit;
            (slip[0], slip[1]) = (p[1] * slips, p[2] * slips);
        }
        Some(())
    }

    /// For each sliding contact the unit direction of its friction force at the path point `at`.
    pub(super) fn directions(&self, at: &[f64]) -> SlipVector {
        let mut directions = SlipVector::default();
        for (direction, i) in directions.iter_mut().zip(&self.sliding) {
            let friction = tangential(&self.force(*i, at));
            *direction = friction / tangential_norm(&friction);
        }
        directions
    }

    /// For each sliding contact the derivatives of its margin `μ F_n - |F_t|`. The first derivative is with respect to the load factor. The others
    /// are with respect to the slip of each sliding contact along its friction force, in units of the length `unit`. They are the coefficients of the
    /// equations that keep these margins zero.
    pub(super) fn margin_rates(&self, directions: &SlipVector) -> [Equation; MOST_UNKNOWNS] {
        let mut rates = [[0.0; MOST_UNKNOWNS + 1]; MOST_UNKNOWNS];
        for ((row, i), p) in rates.iter_mut().zip(&self.sliding).zip(directions) {
            let margin = self.problem.cone(*i).facet_row(p);
            let felt = |part: usize| margin.dot(&self.forces[part * self.contacts() + i]);
            row[0] = felt(1);
            for (j, p) in directions.iter().enumerate().take(self.sliding.len()) {
                row[j + 1] = (felt(2 + 2 * j) * p[1] + felt(3 + 2 * j) * p[2]) * self.unit;
            }
        }
        rates
    }

    /// The force of a contact, N, at the path point `at`. If `at` lists rates of weights, the rate of the force.
    pub(super) fn force(&self, contact: usize, at: &[f64]) -> SVector<f64, 3> {
        let mut force = SVector::zeros();
        for (part, weight) in self.forces.chunks_exact(self.contacts()).zip(at) {
            force += part[contact] * *weight;
        }
        force
    }

    /// The twist (displacement and small rotation) of the object at the path point `at`. If `at` lists rates of weights, the rate of the twist.
    pub(super) fn twist(&self, at: &[f64]) -> Vector {
        let mut twist = Vector::zeros();
        self.twists.iter().zip(at).for_each(|(part, weight)| twist.add_times(part, *weight));
        twist
    }

    /// The rotation of the object and the slips of contacts at the path point `at`, for comparison with the limits of small motions.
    pub(super) fn motions(&self, at: &[f64]) -> Vec<CountedMotion> {
        let none = vec![SVector::zeros(); self.contacts()];
        let (offsets, forces, twist) = (&none[..], &none[..], &self.twist(at));
        let mut slips = none.clone();
        for (i, slip) in self.sliding.iter().zip(at[2..].chunks_exact(2)) {
            (slips[*i][1], slips[*i][2]) = (slip[0], slip[1]);
        }
        // The slips are known from the path point `at`. For sticking contacts `counted_motions` uses these slips alone; for sliding contacts it adds
        // a slip derived from the springs. All contacts are therefore given as sticking.
        let states: Vec<State> = vec![Mode::Sticking; slips.len()];
        let standing = MotionData { offsets, slips: &slips, states: &states, forces, twist };
        self.grasp.counted_motions(&self.small, &standing)
    }

    /// The largest ratio, at the path point `at`, of the object's rotation or a contact's slip to its limit of small motions. The grasp has only one
    /// object, so the last entries of the twist are its rotation times the engine's unit of length.
    pub(super) fn far(&self, at: &[f64]) -> f64 {
        let space = self.grasp.space();
        let mut turned = 0.0;
        for k in space.axes()..space.of_the_object() {
            let turns: f64 = self.twists.iter().zip(at).map(|(part, weight)| part[k] * weight).added();
            turned += turns * turns;
        }
        let mut far = turned.sqrt() / (self.grasp.length() * self.small.rotation);
        for slip in at[2..].chunks_exact(2) {
            far = far.max(slip[0].hypot(slip[1]) / self.slip_limit);
        }
        far
    }
}
