//! Stability of an equilibrium, from the second derivative of the potential energy.

use core::ops::Range;

use nalgebra::{DMatrix, SVector};

use crate::equilibrium::{ContactState, Equilibrium};
use crate::grasp::{Engine, Motion, Space};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Size, Square, Vector, mapped, matrix_of, symmetric_eigen};
use crate::prelude::*;

/// The second derivative of the potential energy at an equilibrium.
///
/// The contact springs keep their directions in space (fingers do not turn with the object). Let the object move from the equilibrium by a
/// translation δ of its point at the origin and a rotation θ. A contact at r moves by
///
/// ```text
/// u = δ + θ × r + ½ θ × (θ × r)        in the plane (equation 4.1): ½ θ×(θ×r) = -½ θ² r
/// ```
///
/// and the energy of springs that already carry F is `Σ ½ (a-u)·K (a-u) - W·q`. Its second derivative has two parts,
///
/// ```text
/// Hessian = Σ G_i K_i G_iᵀ  -  Σ F_i · ∂²u_i/∂q²
///           elastic            geometric: in the plane + Σ F_i·r_i on the rotation,
///                              in space  (F·r) 1 - ½ (F rᵀ + r Fᵀ), summed, on the rotations
/// ```
///
/// In the geometric part the arms turn while the forces do not: relative to the object, the contact forces turn. Fingers that press against each
/// other (F·r < 0) make it negative: a grasp squeezed hard between soft tangential springs tips over (Hanafusa & Asada 1977; Nguyen 1989). The load's
/// force acts at the object's point at the origin and keeps its direction, and the moment keeps its components. A sticking contact counts with all
/// its springs, an open contact with none. Where a contact slides, friction is not conservative and no energy decides.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Stability<const C: usize> {
    /// `Σ G_i K_i G_iᵀ` over the active springs, about the origin of the coordinates, N/m, N and N m: the elastic stiffness of the object. Springs of
    /// joints are included, with rows and columns for their displacements.
    pub elastic: DMatrix<f64>,
    /// Contribution of the contact forces as their arms turn, non-zero for rotations alone, in the same units.
    pub geometric: DMatrix<f64>,
    /// Curvature of the energy along the softest motion, N/m: the least eigenvalue of the Hessian, with rotations measured as in `softest`.
    pub least_curvature: f64,
    /// The largest eigenvalue, N/m.
    pub most_curvature: f64,
    /// The unit motion along which the energy rises least, as a twist about the origin; its sign is arbitrary. A rotation is measured in radians
    /// times the root mean square distance of the contacts from their centroid, a translation by that of the centroid.
    pub softest: Motion<C>,
    /// The conclusion from the least curvature.
    pub verdict: StabilityVerdict,
}

/// Whether an equilibrium is stable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StabilityVerdict {
    /// The energy rises along every motion.
    Stable,
    /// The energy does not change along the softest motion to second order, up to rounding: its curvature is at most 1e-12 of the curvature with the
    /// largest absolute value.
    Neutral,
    /// The energy falls along the softest motion.
    Unstable,
    /// A contact slides, so that energy does not decide. The matrices include sliding contacts with their normal springs alone.
    Sliding,
}

impl<const C: usize> Stability<C> {
    /// Elastic and geometric stiffness together: the restoring wrench about the origin is `-H q` for a small twist q.
    #[must_use]
    pub fn hessian(&self) -> DMatrix<f64> {
        &self.elastic + &self.geometric
    }
}

impl Engine {
    /// Implements [`Energy::stability`](crate::ask::Energy::stability).
    pub(crate) fn stability(&self, equilibrium: &Equilibrium<3>) -> Stability<3> {
        let arms = self.contacts().iter().map(|contact| contact.point);
        let forces = equilibrium.contacts.iter().map(|c| c.force_world);
        let states: Vec<_> = mapped(&equilibrium.contacts, &|c| c.state);
        let drives = self.drives_that_hold(equilibrium);
        self.stability_with(&arms.list(), &forces.list(), &states, drives)
    }

    /// The elastic stiffness of those drives of a hand that do not slip, and whether one of them slips.
    fn drives_that_hold(&self, equilibrium: &Equilibrium<3>) -> (Square, bool) {
        let (mut elastic, mut slips) = (Square::zeros(self.size()), false);
        let Some(linkage) = self.linkage() else { return (elastic, slips) };
        if !equilibrium.knows_all_of(self.sites().len()) {
            // A drive whose state is not known counts as slipping: the verdict is then that energy does not decide.
            return (elastic, true);
        }
        let states = equilibrium.local.states.iter().zip(self.sites()).skip(self.len());
        for (state, site) in states {
            slips |= state.slides();
            if state.is_open() || state.slides() {
                continue;
            }
            for a in 0..site.springs.axes() {
                let column = site.map.column(a).component_mul(&linkage.lengths);
                add_spring(&mut elastic, &column, site.springs.force_along(a, 1.0));
            }
        }
        (elastic, slips)
    }

    /// Adds the geometric stiffness that the force of this contact gives to bodies other than the object.
    fn turning_bodies(&self, contact: usize, force: &SVector<f64, 3>, geometric: &mut Square) {
        let Some(bodies) = self.bodies() else { return };
        let object = self.space().of_the_object();
        for (body, place) in bodies.places.iter().enumerate() {
            let sign = bodies.sign(contact, body);
            if sign == 0.0 || body == bodies.object {
                continue;
            }
            let arm = self.contacts()[contact].point - place.centre;
            let part = turning_arm(self.space(), Size::of(object), &arm, force);
            for (row, column) in (0..object).flat_map(|row| (0..object).map(move |column| (row, column))) {
                geometric[(place.first + row, place.first + column)] += sign * part[(row, column)];
            }
        }
    }

    /// The stability with these arms of the contacts, measured from the object's point at the origin.
    pub(super) fn stability_with(
        &self,
        arms: &[SVector<f64, 3>],
        forces: &[SVector<f64, 3>],
        states: &[ContactState<3>],
        (mut elastic, mut slides): (Square, bool),
    ) -> Stability<3> {
        let size = self.size();
        let mut geometric = Square::zeros(size);
        let contacts = arms.iter().zip(forces).zip(states);
        for (i, (site, ((arm, force), state))) in self.sites().iter().zip(contacts).enumerate() {
            let holds = match state {
                ContactState::Separated => 0,
                ContactState::Sliding { .. } => {
                    slides = true;
                    1
                }
                _ => site.springs.axes(),
            };
            let on_object = self.sign_on_object(i);
            let mut map = self.space().grasp_map(size, arm, &(site.frame * on_object));
            for (k, motion) in self.linkage().map_or(&[][..], |linkage| &linkage.motions[i]) {
                map.set_row(self.space().of_the_object() + k, &-site.frame.tr_mul(motion));
            }
            for a in 0..holds {
                add_spring(&mut elastic, &map.column(a), site.springs.force_along(a, 1.0));
            }
            geometric += &turning_arm(self.space(), size, arm, &(force * on_object));
            self.turning_bodies(i, force, &mut geometric);
        }
        // Column k is the k-th unit motion of the engine's coordinates, as a twist about the origin.
        let units = Square::from_columns(size, |k| self.outside_coordinates(&Vector::unit(size, k)));
        let hessian = &(&units.transpose() * &(elastic.clone() + &geometric)) * &units;
        let (least, most, motion) = extremes(&hessian);
        let size = least.abs().max(most.abs());
        let verdict = if slides {
            StabilityVerdict::Sliding
        } else if least.abs() <= SOLVED_ROUNDING * size {
            StabilityVerdict::Neutral
        } else if least > 0.0 {
            StabilityVerdict::Stable
        } else {
            StabilityVerdict::Unstable
        };
        let retained =
            self.space().of_the_object() + self.linkage().map_or(0, |linkage| linkage.joints.len());
        Stability {
            elastic: condensed(&elastic, retained),
            geometric: matrix_of(retained, retained, &|i, j| geometric[(i, j)]),
            least_curvature: least,
            most_curvature: most,
            softest: self.motion_outside(&motion),
            verdict,
        }
    }
}

/// The stiffness for the first `retained` coordinates if no force acts on all others (a Schur complement).
fn condensed(stiffness: &Square, retained: usize) -> DMatrix<f64> {
    let part = |rows: Range<usize>, columns: Range<usize>| {
        matrix_of(rows.len(), columns.len(), &|i, j| stiffness[(rows.start + i, columns.start + j)])
    };
    let (own, count) = (part(0..retained, 0..retained), stiffness.size().count());
    if retained == count {
        return own;
    }
    let across = part(retained..count, 0..retained);
    match part(retained..count, retained..count).lu().solve(&across) {
        Some(moved) => own - across.transpose() * moved,
        None => own,
    }
}

/// Adds `k g gᵀ`.
fn add_spring(stiffness: &mut Square, g: &Vector, k: f64) {
    for i in 0..stiffness.size().count() {
        for j in 0..stiffness.size().count() {
            stiffness[(i, j)] += g[i] * g[j] * k;
        }
    }
}

/// The geometric stiffness `-F · ∂²u/∂q²` of one contact, whose arm turns with the object.
fn turning_arm(space: Space, size: Size, arm: &SVector<f64, 3>, force: &SVector<f64, 3>) -> Square {
    let mut part = Square::zeros(size);
    let along = arm.dot(force);
    if space == Space::Planar {
        part[(2, 2)] = along;
        return part;
    }
    for a in 0..3 {
        for b in 0..3 {
            let mixed = 0.5 * (force[a] * arm[b] + arm[a] * force[b]);
            part[(3 + a, 3 + b)] = if a == b { along - mixed } else { -mixed };
        }
    }
    part
}

/// Least and largest eigenvalue of a symmetric matrix, and a unit eigenvector of the least.
fn extremes(matrix: &Square) -> (f64, f64, Vector) {
    let count = matrix.size().count();
    let dynamic = matrix_of(count, count, &|i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]));
    let (values, vectors) = symmetric_eigen(&dynamic);
    let vector = Vector::from_fn(matrix.size(), |k| vectors[(k, count - 1)]);
    (values[count - 1], values[0], vector)
}
