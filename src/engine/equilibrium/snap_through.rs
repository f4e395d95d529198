//! Snap-through: parts turn under a load until nothing resists it any more, like a toggle near its dead centre. The theory of small motions keeps the
//! arms of all forces, and does not see it.
//!
//! With an exact rotation R of its body the arm r of a force becomes R r, and cables and springs between two points turn with their ends. The
//! displacement u of a contact is then no longer linear in the coordinates q of the bodies. Its force is `F = F_0 - K u`, with the stiffness matrix K
//! of the contact in its state and the force F_0 without a motion. Joints of a hand move their contacts to first order.
//!
//! The equilibrium of small motions is known. From it Newton's method leads, under the same load, to the equilibrium with exact rotations: the share m
//! of exact rotations grows from 0 to 1, with `u = (1 - m) Gᵀq + m u(R)` and the grasp map G. If the tangent stiffness is no longer positive definite
//! on the way, the load is lost. This stiffness contains the turning forces, as in `left_out`.

use nalgebra::{SMatrix, SVector};

use super::answer::Equilibrium;
use super::left_out::{LEAST_FRACTION, add_to_free_motions, positive_factors, sticking_springs};
use super::too_far::MotionData;
use crate::contact::State;
use crate::grasp::{Engine, PointsOfAction, Wrench, size_of};
use crate::numerics::{IntoList, Square, Vector, indexed, mapped};
use crate::object::tangent_stiffness;
use crate::prelude::*;

impl Engine {
    /// Whether the load of an equilibrium is lost if its parts turn by finite rotations. Also false if a contact slides, if the points of action of the
    /// load are not known, or if arms change so little that no contact does a hundredth of the elastic work along their change.
    pub(super) fn snaps_through(&self, standing: &MotionData<'_>, load: &Wrench<3>) -> bool {
        matches!(self.with_turned_parts(standing, load), Some(WithTurnedParts::Lost))
    }

    /// The change of the resistance to the load of an equilibrium by finite rotations of its parts, as a fraction of the resistance without
    /// them: `W·q / W·q' - 1`, with the load W and the motions q without and q' with finite rotations. Negative if the resistance
    /// becomes lower. `None` if the fraction is at most [`LEAST_FRACTION`], if the load is lost, or if arms hardly change.
    pub(crate) fn lost_resistance(&self, there: &Equilibrium<3>) -> Option<f64> {
        let local = &there.local;
        let mut forces: Vec<SVector<f64, 3>> = mapped(&there.contacts, &|contact| contact.force);
        forces.extend(&local.drive_forces);
        let twist = local.twist.to();
        let (offsets, slips, states) = (&local.offsets[..], &local.slips[..], &local.states[..]);
        let standing = MotionData { offsets, slips, states, forces: &forces, twist: &twist };
        match self.with_turned_parts(&standing, &there.load) {
            Some(WithTurnedParts::Held(fraction)) => fraction.filter(|part| part.abs() > LEAST_FRACTION),
            _ => None,
        }
    }

    /// The fate of an equilibrium's load if its parts turn by finite rotations. `None` if a contact slides, if the points of action of the load are not
    /// known, or if arms hardly change.
    fn with_turned_parts(&self, standing: &MotionData<'_>, load: &Wrench<3>) -> Option<WithTurnedParts> {
        // The tangent stiffness of a contact that slides is not symmetric: its friction changes with its normal force alone.
        if standing.states.iter().any(State::slides) || !self.may_buckle(load) {
            return None;
        }
        let parts = TurningParts::new(self, standing, load);
        parts.arms_matter(standing.twist).then(|| parts.follow(standing.twist))
    }
}

/// The fate of a load, if the parts that carry it turn by finite rotations.
enum WithTurnedParts {
    /// The equilibrium of small motions does not lead to one with finite rotations.
    Lost,
    /// The load is held, and the resistance to it changes by this fraction; `None` if springs do not resist some motion.
    Held(Option<f64>),
}

/// The rotation of a body, and where its coordinates are.
#[derive(Debug, Clone)]
struct TurningBody {
    /// Index of the first coordinate of the body.
    first: usize,
    /// The point to which the coordinates of the body refer, m.
    centre: SVector<f64, 3>,
    /// The lengths by which the rotations about x, y and z are multiplied in the coordinates, m; in the plane the first is that of the only rotation.
    lengths: [f64; 3],
    /// The rotation R of the body, less the unit matrix: for small rotations R itself would have lost digits.
    turned: SMatrix<f64, 3, 3>,
    /// The sum `Σ F rᵀ` of the load's forces F and arms r about the centre.
    load: PointsOfAction,
}

/// The bodies, contacts and drives of a grasp in a displaced position.
struct TurningParts<'e> {
    engine: &'e Engine,
    bodies: Vec<TurningBody>,
    /// All coordinates: displacements of the centres of bodies, m, sums of small rotations times their lengths, and coordinates of joints.
    displaced: Vector,
    /// The stiffness matrix K of each contact and drive in its state.
    springs: Vec<SMatrix<f64, 3, 3>>,
    /// The force F_0 of each contact and drive without a motion, N, in its frame.
    forces: Vec<SVector<f64, 3>>,
    /// The load, as generalised forces in all coordinates.
    load: Vector,
    /// The projection on the motions that springs resist, and the stiffness that all other motions get, N/m; `None` if springs resist all motions.
    resisted: Option<(Square, f64)>,
}

/// A contact or drive in a displaced position.
struct DisplacedSite {
    /// The generalised forces in all coordinates due to a unit force along each axis of its frame.
    columns: [Vector; 3],
    /// The displacement u along each axis of its frame, m.
    moved: SVector<f64, 3>,
    /// The axes of the frame.
    frame: SMatrix<f64, 3, 3>,
    /// For a cable or spring between two points its length, m.
    length: Option<f64>,
}

impl<'e> TurningParts<'e> {
    fn new(engine: &'e Engine, standing: &MotionData<'_>, load: &Wrench<3>) -> Self {
        let sites = engine.sites();
        let springs = indexed(sites, &|(i, site)| {
            if standing.states[i].is_open() { SMatrix::zeros() } else { sticking_springs(site) }
        });
        let forces =
            indexed(sites, &|(i, site)| standing.forces[i] + springs[i] * site.map.tr_mul(standing.twist));
        let mut whole = Vector::all_zero(size_of(sites));
        for (site, force) in sites.iter().zip(standing.forces) {
            whole -= &site.map * *force;
        }
        let (axes, of_body) = (engine.space().axes(), engine.space().of_the_object());
        let loads = engine.loads_of_bodies(load);
        let bodies = loads.iter().enumerate().map(|(body, load)| {
            let (first, centre) = engine.reference_of(body);
            let mut lengths = [1.0; 3];
            (0..of_body - axes).for_each(|k| lengths[k] = engine.rotation_length(first, k));
            let load = load.points_of_action().moved(&load.force_part(), &-centre);
            TurningBody { first, centre, lengths, turned: SMatrix::zeros(), load }
        });
        let elastic = tangent_stiffness(sites, &|i| springs[i]);
        let is_resisted = positive_factors(elastic.size().count(), &|i, j| elastic[(i, j)]).is_some();
        let resisted = (!is_resisted).then(|| engine.resisted_motions(&elastic));
        let displaced = Vector::all_zero(size_of(sites));
        let mut parts =
            Self { engine, bodies: bodies.list(), displaced, springs, forces, load: whole, resisted };
        parts.move_by(standing.twist);
        parts
    }

    /// Whether the change of arms makes some contact do more than the fraction [`LEAST_WORK`] of the elastic work of all contacts, in the motion
    /// `twist` of small motions.
    fn arms_matter(&self, twist: &Vector) -> bool {
        let (mut elastic, mut largest) = (0.0, 0.0_f64);
        for (i, site) in self.engine.sites().iter().enumerate() {
            let linear = site.map.tr_mul(twist);
            let force = self.springs[i] * linear;
            elastic += force.dot(&linear).abs();
            largest = largest.max(force.dot(&(self.site(i, 1.0).moved - linear)).abs());
        }
        largest > LEAST_WORK * elastic
    }

    /// Follows the equilibrium from small motions to finite rotations. `twist` is the motion of the equilibrium of small motions.
    fn follow(mut self, twist: &Vector) -> WithTurnedParts {
        let (mut share, mut step) = (0.0, FIRST_STEP);
        for _ in 0..MOST_TRIALS {
            if share >= 1.0 || step < LEAST_STEP {
                break;
            }
            let before = (self.bodies.clone(), self.displaced.clone());
            let next = f64::min(share + step, 1.0);
            if self.balance(next, twist.norm()) {
                (share, step) = (next, 2.0 * step);
            } else {
                (self.bodies, self.displaced) = before;
                step *= 0.25;
            }
        }
        if share < 1.0 {
            return WithTurnedParts::Lost;
        }
        let fraction = self.load.dot(twist) / self.load.dot(&self.displaced) - 1.0;
        WithTurnedParts::Held(self.resisted.is_none().then_some(fraction))
    }

    /// Finds the equilibrium with this share of exact rotations by Newton's method, from the present position. False if the tangent stiffness is not
    /// positive definite on the way, or if the position moves by more than [`FARTHEST_STEP`] times `whole`, the length of the motion of small motions.
    fn balance(&mut self, share: f64, whole: f64) -> bool {
        let mut moved = 0.0;
        for _ in 0..NEWTON_STEPS {
            let (mut step, stiffness) = self.imbalance(share);
            let count = stiffness.size().count();
            let Some(factors) = positive_factors(count, &|i, j| stiffness[(i, j)]) else { return false };
            factors.solve(step.as_mut_slice());
            moved += step.norm();
            if moved > FARTHEST_STEP * whole || moved.is_nan() {
                return false;
            }
            self.move_by(&step);
            if step.norm() <= CONVERGED * whole {
                return true;
            }
        }
        false
    }

    /// The generalised forces out of balance with this share of exact rotations, and the tangent stiffness, both on the motions that springs resist.
    fn imbalance(&self, share: f64) -> (Vector, Square) {
        let size = size_of(self.engine.sites());
        let (axes, planes) = (self.engine.space().axes(), self.engine.space().planes());
        let (mut out, mut stiffness) = (self.load.clone(), Square::zeros(size));
        let mut arms = mapped(&self.bodies, &|body| body.load.turned(&(SMatrix::identity() + body.turned)));
        for (body, turned) in self.bodies.iter().zip(&arms) {
            for (k, (i, j)) in planes.iter().enumerate() {
                let moment = |sum: &PointsOfAction| sum.product(*j, *i) - sum.product(*i, *j);
                out[body.first + axes + k] += share * (moment(turned) - moment(&body.load)) / body.lengths[k];
            }
        }
        for i in 0..self.engine.sites().len() {
            let site = self.site(i, share);
            let force = self.forces[i] - self.springs[i] * site.moved;
            let mut springs = self.springs[i];
            if let Some(length) = site.length {
                (1..3).for_each(|across| springs[(across, across)] = share * force[0] / length);
            }
            for a in 0..3 {
                out.add_times(&site.columns[a], force[a]);
                for b in (0..3).filter(|b| springs[(a, *b)] != 0.0) {
                    let column = site.columns[b].map(|x| x * springs[(a, b)]);
                    stiffness.add_product(site.columns[a].as_slice(), column.as_slice());
                }
            }
            for (body, sign, [arm, change]) in self.arms(i) {
                arms[body] = arms[body].moved(&(site.frame * force * sign), &(arm + change));
            }
        }
        for (body, arms) in self.bodies.iter().zip(arms) {
            let of_body = arms.stiffness().unwrap_or_default();
            let axis = |k: usize| if axes == 3 { k } else { 2 };
            for (k, l) in (0..planes.len()).flat_map(|k| (0..planes.len()).map(move |l| (k, l))) {
                stiffness[(body.first + axes + k, body.first + axes + l)] +=
                    share * of_body[(axis(k), axis(l))] / (body.lengths[k] * body.lengths[l]);
            }
        }
        if let Some((resisted, largest)) = &self.resisted {
            out = resisted * &out;
            stiffness = &(resisted * &stiffness) * resisted;
            add_to_free_motions(&mut stiffness, (resisted, *largest));
        }
        (out, stiffness)
    }

    /// The bodies on which a contact acts, with the sign of its force, its arm without a rotation and the change of this arm, m. Cables and springs
    /// between two bodies act on the second at their other end.
    fn arms(&self, site: usize) -> impl Iterator<Item = (usize, f64, [SVector<f64, 3>; 2])> + '_ {
        let contact = self.engine.contacts().get(site);
        self.bodies.iter().enumerate().filter_map(move |(body, turned)| {
            let contact = contact?;
            let sign = self.engine.bodies().map_or(1.0, |bodies| bodies.sign(site, body));
            let point = if sign < 0.0 { self.engine.far_end(site) } else { contact.point };
            let arm = point - turned.centre;
            (sign != 0.0).then(|| (body, sign, [arm, turned.turned * arm]))
        })
    }

    /// A contact or drive in the present position, with this share of exact rotations.
    fn site(&self, i: usize, share: f64) -> DisplacedSite {
        let (engine, site) = (self.engine, &self.engine.sites()[i]);
        let (axes, of_body) = (engine.space().axes(), engine.space().of_the_object());
        let (mut columns, linear) = ([0, 1, 2].map(|a| site.map.column(a)), site.map.tr_mul(&self.displaced));
        let Some(contact) = engine.contacts().get(i) else {
            return DisplacedSite { columns, moved: linear, frame: site.frame, length: None };
        };
        let shift = |body: &TurningBody| {
            let mut shift = SVector::zeros();
            (0..axes).for_each(|k| shift[k] = self.displaced[body.first + k]);
            shift
        };
        let (mut relative, mut frame, mut length) = (SVector::zeros(), site.frame, None);
        for (body, sign, [_, change]) in self.arms(i) {
            relative += (shift(&self.bodies[body]) + change) * sign;
        }
        let mut moved = frame.tr_mul(&relative);
        if engine.rope(i).is_some() {
            let line = contact.normal - relative;
            frame = frame_along(&line, &frame);
            moved = SVector::zeros();
            // The difference of both lengths, without a loss of digits.
            let shorter = (contact.normal + line).dot(&relative) / (contact.normal.norm() + line.norm());
            (moved[0], length) = (shorter, Some(line.norm()));
        }
        // Joints of a hand move the contact to first order.
        let mut joints = self.displaced.clone();
        for body in &self.bodies {
            (0..of_body).for_each(|k| joints[body.first + k] = 0.0);
        }
        moved += site.map.tr_mul(&joints);
        for (body, sign, [arm, change]) in self.arms(i) {
            let (body, arm) = (&self.bodies[body], arm + change);
            for (a, column) in columns.iter_mut().enumerate() {
                let wrench = engine.space().wrench_of(&arm, &frame.column(a).into_owned());
                for k in 0..of_body {
                    let length = if k < axes { 1.0 } else { body.lengths[k - axes] };
                    let turned = sign * wrench[k] / length;
                    column[body.first + k] += share * (turned - column[body.first + k]);
                }
            }
        }
        DisplacedSite { columns, moved: linear + (moved - linear) * share, frame, length }
    }

    /// Moves all parts by a small motion, in the coordinates of the grasp.
    fn move_by(&mut self, step: &Vector) {
        let (axes, count) = (self.engine.space().axes(), self.engine.space().planes().len());
        self.displaced += step;
        for body in &mut self.bodies {
            let mut half = SVector::zeros();
            for k in 0..count {
                half[if axes == 3 { k } else { 2 }] = 0.5 * step[body.first + axes + k] / body.lengths[k];
            }
            let step = rotation_less_one(&half);
            body.turned += step + step * body.turned;
        }
    }
}

/// A rotation matrix less the unit matrix by Cayley's formula, for a small rotation vector of which `half` is one half. The angle agrees up to terms of
/// third order.
fn rotation_less_one(half: &SVector<f64, 3>) -> SMatrix<f64, 3, 3> {
    let cross = half.cross_matrix();
    (cross + cross * cross) * (2.0 / (1.0 + half.norm_squared()))
}

/// A frame with its first axis along `line`, and its other axes near those of `frame`, if `frame` has them.
fn frame_along(line: &SVector<f64, 3>, frame: &SMatrix<f64, 3, 3>) -> SMatrix<f64, 3, 3> {
    let mut axes = *frame;
    axes.set_column(0, &line.normalize());
    for a in 1..3 {
        let mut axis = axes.column(a).into_owned();
        for b in 0..a {
            let other = axes.column(b).into_owned();
            axis -= other * other.dot(&axis);
        }
        let norm = axis.norm();
        axes.set_column(a, &(if norm > 0.0 { axis / norm } else { axis }));
    }
    axes
}

/// Part of the elastic work below which the change of arms is neglected. At a snap-through it is near a fifth. If larger, a part that snaps through
/// beside much softer ones would be missed; if smaller, ordinary grasps would take longer.
const LEAST_WORK: f64 = 0.01;

/// The first step of the share of exact rotations. If larger, first steps often fail; if smaller, there are more steps than needed.
const FIRST_STEP: f64 = 0.25;

/// Least step of the share of exact rotations: if none as long succeeds, the load is lost. If larger, loads are called lost that are a little smaller
/// than those lost in truth; if smaller, the search takes longer.
const LEAST_STEP: f64 = 1e-4;

/// Number of steps that are tried, with or without success. Ten to forty are usual. If none leads to the end, the load counts as lost.
const MOST_TRIALS: usize = 200;

/// Length of the longest motion in a step, as a part of the whole motion. If larger, a step may pass over the loss, to an equilibrium beyond.
const FARTHEST_STEP: f64 = 0.1;

/// Number of Newton's steps in which an equilibrium has to be found. Three are usual.
const NEWTON_STEPS: usize = 12;

/// Length of the last of Newton's steps, as a part of the whole motion. The method converges quadratically, so that the next step is rounding.
const CONVERGED: f64 = 1e-9;
