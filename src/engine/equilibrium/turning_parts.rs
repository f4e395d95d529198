//! The bodies, contacts and drives of a grasp in a position with finite rotations, and the forces out of balance there.
//!
//! With an exact rotation R of its body the arm r of a force becomes R r, and cables and springs between two points turn with their ends. The
//! displacement u of a contact is then no longer linear in the coordinates q of the bodies. Its force is `F = F_0 - K u`, with the stiffness matrix K
//! of the contact in its state and the force F_0 without a motion. A closed contact opens if it has to pull; an open one stays open.
//! Joints of a hand move their contacts to first order. Positions between those of small motions and those with exact rotations have a share m of
//! exact rotations, with `u = (1 - m) Gᵀq + m u(R)` and the grasp map G.

use nalgebra::{SMatrix, SVector};

use super::left_out::{add_to_free_motions, positive_factors, sticking_springs};
use super::too_far::MotionData;
use crate::grasp::{Engine, Hold, PointsOfAction, Site, Wrench, size_of};
use crate::numerics::{IntoList, Square, Vector, indexed, mapped};
use crate::object::tangent_stiffness;
use crate::prelude::*;

/// The rotation of a body, and where its coordinates are.
#[derive(Debug, Clone)]
pub(super) struct TurningBody {
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
pub(super) struct TurningParts<'e> {
    pub(super) engine: &'e Engine,
    pub(super) bodies: Vec<TurningBody>,
    /// All coordinates: displacements of the centres of bodies, m, sums of small rotations times their lengths, and coordinates of joints.
    pub(super) displaced: Vector,
    /// The stiffness matrix K of each contact and drive in its state.
    pub(super) springs: Vec<SMatrix<f64, 3, 3>>,
    /// The force F_0 of each contact and drive without a motion, N, in its frame.
    forces: Vec<SVector<f64, 3>>,
    /// The load, as generalised forces in all coordinates.
    load: Vector,
    /// The projection on the motions that springs resist, and the stiffness that all other motions get, N/m; `None` if springs resist all motions.
    pub(super) resisted: Option<(Square, f64)>,
}

/// A contact or drive in a displaced position.
pub(super) struct DisplacedSite {
    /// The generalised forces in all coordinates due to a unit force along each axis of its frame.
    columns: [Vector; 3],
    /// The displacement u along each axis of its frame, m.
    pub(super) moved: SVector<f64, 3>,
    /// The axes of the frame.
    frame: SMatrix<f64, 3, 3>,
    /// For a cable or spring between two points its length, m.
    length: Option<f64>,
}

impl<'e> TurningParts<'e> {
    pub(super) fn new(engine: &'e Engine, standing: &MotionData<'_>, load: &Wrench<3>) -> Self {
        let sites = engine.sites();
        let springs = indexed(sites, &|(i, site)| {
            if standing.states[i].is_open() { SMatrix::zeros() } else { sticking_springs(site) }
        });
        let forces =
            indexed(sites, &|(i, site)| standing.forces[i] + springs[i] * site.map.tr_mul(standing.twist));
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
        let mut parts = Self {
            engine,
            bodies: bodies.list(),
            displaced,
            springs,
            forces,
            load: carried_load(sites, standing.forces),
            resisted,
        };
        parts.move_by(standing.twist);
        parts
    }

    /// The generalised forces out of balance with this share of exact rotations, and the tangent stiffness, both on the motions that springs resist.
    pub(super) fn imbalance(&self, share: f64) -> (Vector, Square) {
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
            // A contact that may open does so, and a cable goes slack, if it has to pull or push.
            if force[0] < 0.0 && self.engine.sites()[i].hold == Hold::Unilateral {
                continue;
            }
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
            for k in 0..planes.len() {
                for l in 0..planes.len() {
                    stiffness[(body.first + axes + k, body.first + axes + l)] +=
                        share * of_body[(axis(k), axis(l))] / (body.lengths[k] * body.lengths[l]);
                }
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
    pub(super) fn site(&self, i: usize, share: f64) -> DisplacedSite {
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
    pub(super) fn move_by(&mut self, step: &Vector) {
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

/// The load that these forces of contacts and drives carry, as generalised forces in all coordinates.
pub(super) fn carried_load(sites: &[Site], forces: &[SVector<f64, 3>]) -> Vector {
    let mut load = Vector::all_zero(size_of(sites));
    for (site, force) in sites.iter().zip(forces) {
        load -= &site.map * *force;
    }
    load
}

/// A rotation matrix less the unit matrix by Cayley's formula, for the rotation vector of which `half` is one half.
fn rotation_less_one(half: &SVector<f64, 3>) -> SMatrix<f64, 3, 3> {
    let angle = half.norm();
    let tangent = if angle > 0.0 { half * (angle.tan() / angle) } else { *half };
    let cross = tangent.cross_matrix();
    (cross + cross * cross) * (2.0 / (1.0 + tangent.norm_squared()))
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
