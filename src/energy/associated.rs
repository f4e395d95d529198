//! The associated friction law: what a grasp does under the convex contact law of many simulators.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SVector};

use super::cone_rows::{FrictionRow, cone_rows};
use super::springs::{Spring, Springs};
use crate::Settings;
use crate::contact::Polygon;
use crate::error::Error;
use crate::grasp::{Grasp, Hold, Site, Twist, Wrench};
use crate::lcp::{self, Lcp, Outcome};
use crate::object::{Load, Problem, largest_force};
use crate::proofs::separating_motion;

/// Conditions are satisfied up to this part of the forces that they compare.
const ROUNDING: f64 = 1e-12;
/// What is left of a direction after the binding rows were taken out of it, when it depends on them.
const DEPENDENT: f64 = 1e-10;

/// What the associated law says of a load.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum AssociatedOutcome<const D: usize, const C: usize> {
    /// A state of rest, with dilation where something slides; each of its conditions holds to 1e-12 of the forces that it compares.
    Rest(Box<AssociatedState<D, C>>),
    /// No forces of the cones balance the load.
    NoBalance,
    /// Rounding or a limit on pivots kept the solver from an answer.
    Unsolved,
}

impl<const D: usize, const C: usize> AssociatedOutcome<D, C> {
    /// The state of rest, if there is one.
    #[must_use]
    pub fn rest(&self) -> Option<&AssociatedState<D, C>> {
        match self {
            Self::Rest(state) => Some(state),
            _ => None,
        }
    }
}

/// A state of rest under the associated law. The forces are unique; the twist may not be.
///
/// Contact forces are the point of the friction cones, in equilibrium with the load, of least complementary energy,
///
/// ```text
/// minimise Σ ½ F_iᵀK_i⁻¹F_i - a_i·F_i     subject to  F_i in its cone,  Σ G_i F_i + W = 0
/// ```
///
/// or, object by object displacement, each contact force is the point of its cone nearest to the trial force K (a - Gᵀq) in the
/// norm of K⁻¹. The optimality conditions have the jumps of the contact normal to the **cone** instead of the slip
/// alone along the surface: with the rows L of the cone (e_n; μ e_n - h_j)
///
/// ```text
/// F = K (a - Gᵀq + Lᵀz),   0 <= z  ⟂  L F >= 0:        gap = Σ μ z_j,  slip = Σ z_j h_j
/// ```
///
/// a contact that slides by s opens by μ|s| while it still presses. The matrix is symmetric and semidefinite, there is one
/// force answer, and it exists for every load in the friction wrench cone: convenient, and not Coulomb's law. This is the law
/// of complementary-energy contact models (MuJoCo's cone constraints, Drake's SAP) without their regularisation.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct AssociatedState<const D: usize, const C: usize> {
    /// The load of the question.
    pub load: Wrench<D>,
    /// Motion of the object about the origin, m and rad.
    pub twist: Twist<D>,
    /// One a contact, in the order of the grasp.
    pub contacts: Vec<AssociatedContact<C>>,
    /// Energy stored in the springs, `Σ ½ F²/k`, J.
    pub stored_energy: f64,
}

/// One contact of an [`AssociatedState`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct AssociatedContact<const C: usize> {
    /// Force on the object in the contact frame, N; the first entry is F_n >= 0 unless the contact is bonded or kept closed.
    pub force: SVector<f64, C>,
    /// How far the surfaces stand apart, m, never negative. Where F_n > 0 this is the law's dilation μ|s|, which Coulomb's law does not have.
    pub gap: f64,
    /// Slip of the finger over the body in the contact frame, m; zero normal component.
    pub slip: SVector<f64, C>,
}

impl<const C: usize> AssociatedContact<C> {
    /// The gap if the contact presses, else 0: an artefact of the law, m.
    #[must_use]
    pub fn dilation(&self) -> f64 {
        if self.force[0] > 0.0 { self.gap } else { 0.0 }
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// What the associated friction law says under a load ([`AssociatedState`] has the law). In space on the polygonal cone of the settings.
    ///
    /// ```
    /// use grasp_lcp::Settings;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Coulomb's law has no equilibrium under 12 N. The associated law lets the contacts slide and open until they press with 12 N,
    /// // which takes 12 mm of spring: 2 mm more than the command, and μ times the slip.
    /// let law = grasp.associated_friction(&Wrench::force([0.0, -12.0]), &Settings::default())?;
    /// let contact = law.rest().expect("in the friction wrench cone").contacts[0];
    /// assert!((contact.force[0] - 12.0).abs() < 1e-13);
    /// assert!((contact.dilation() - 0.002).abs() < 1e-16);
    /// assert!((contact.slip.norm() - 0.004).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn associated_friction(
        &self,
        load: &Wrench<D>,
        settings: &Settings,
    ) -> Result<AssociatedOutcome<D, C>, Error> {
        let law = Law {
            sites: self.sites(),
            wrench: self.inside(load, "load")?,
            drives: self.drives(),
            rows: cone_rows(self.sites(), &settings.cone, |_| true),
            corners: Polygon::new(&settings.cone).corners,
        };
        let stuck = Springs::along_axes(self.sites(), |_, _| true);
        if stuck.worked_on(&law.wrench).is_some() {
            return Ok(AssociatedOutcome::NoBalance);
        }
        let found = law.binding(&stuck, settings);
        let first = found.and_then(|(binding, near)| Some((law.on_faces(&binding, &near)?, binding, near)));
        let Some((first, binding, near)) = first else {
            // There is a state of rest for every load in the friction wrench cone; is this one outside?
            let polygon = Arc::new(Polygon::new(&settings.cone));
            let problem =
                Problem::at_rest(self.sites(), polygon, false, law.drives, &Load::from(&law.wrench));
            return Ok(match separating_motion(&problem) {
                Some(_) => AssociatedOutcome::NoBalance,
                None => AssociatedOutcome::Unsolved,
            });
        };
        // Rows on their edge that the pivots left out: forces are the same, but the object has more room.
        let edge = law.on_edge(&first);
        let roomier = law.on_faces(&edge, &near).filter(|r| law.jumps_outwards(&r.forces, &r.twist));
        let (state, binding) = roomier.map_or((first, binding), |state| (state, edge));
        Ok(AssociatedOutcome::Rest(Box::new(self.at_rest(load, &law, &state, &binding))))
    }

    fn at_rest(
        &self,
        load: &Wrench<D>,
        law: &Law<D, C>,
        state: &Faces<D, C>,
        binding: &[usize],
    ) -> AssociatedState<D, C> {
        let mut stored_energy = 0.0;
        let mut contacts = Vec::with_capacity(self.len());
        for (i, site) in self.sites().iter().enumerate() {
            let force = state.forces[i];
            let jump = law.jump(i, &force, &state.twist);
            stored_energy += site.springs.stored(&force);
            let binds = binding.iter().any(|r| law.rows[*r].contact == i);
            let mut slip = -jump;
            slip[0] = 0.0;
            if !binds && site.springs.resists_tangentially() {
                slip.fill(0.0);
            }
            let gap = if binds { jump[0].max(0.0) } else { 0.0 };
            contacts.push(AssociatedContact { force, gap, slip });
        }
        AssociatedState { load: *load, twist: self.outside(&state.twist), contacts, stored_energy }
    }
}

/// The law and the question in inside coordinates.
struct Law<'g, const D: usize, const C: usize> {
    sites: &'g [Site<D, C>],
    wrench: SVector<f64, D>,
    drives: Vec<SVector<f64, C>>,
    rows: Vec<FrictionRow<C>>,
    corners: Vec<SVector<f64, C>>,
}

/// Forces and a twist when every contact keeps the springs along its face of the cone.
struct Faces<const D: usize, const C: usize> {
    forces: Vec<SVector<f64, C>>,
    twist: SVector<f64, D>,
}

impl<const D: usize, const C: usize> Law<'_, D, C> {
    /// Which rows bind, and a twist with it, by Lemke's method on `0 <= z ⟂ N x⁰ + N (1 - Π) Nᵀ z >= 0`.
    fn binding(&self, stuck: &Springs<D, C>, settings: &Settings) -> Option<(Vec<usize>, SVector<f64, D>)> {
        let rows = &self.rows;
        let trial = stuck.rest(&self.drives, &self.wrench);
        // Springs along the axes stand contact by contact.
        let first =
            |contact: usize| self.sites[..contact].iter().map(|site| site.springs.axes()).sum::<usize>();
        let axes = |row: &FrictionRow<C>| {
            let start = first(row.contact);
            (0..self.sites[row.contact].springs.axes()).map(move |a| (a, start + a))
        };
        let q = rows.iter().map(|row| axes(row).map(|(a, s)| row.normal[a] * trial.x[s]).sum());
        let q = DVector::from_vec(q.collect());
        if q.iter().all(|q| *q >= 0.0) {
            return Some((Vec::new(), stuck.twist(&trial.travelled)));
        }
        let seen: Vec<SVector<f64, D>> = rows
            .iter()
            .map(|row| {
                axes(row).fold(SVector::zeros(), |sum, (a, s)| sum + stuck.factor.row(s) * row.normal[a])
            })
            .collect();
        let matrix = DMatrix::from_fn(rows.len(), rows.len(), |i, j| {
            let same = rows[i].contact == rows[j].contact;
            let together = if same { rows[i].normal.dot(&rows[j].normal) } else { 0.0 };
            together - seen[i].dot(&seen[j])
        });
        let lcp = Lcp::new(matrix, q).ok()?;
        let lcp_settings =
            lcp::Settings { max_pivots: settings.max_pivots, enumerate_up_to: 0, ..lcp::Settings::default() };
        match lcp.solve_with(&lcp_settings) {
            Outcome::Solved(solution) => {
                let travelled = seen
                    .iter()
                    .zip(solution.z.iter())
                    .fold(trial.travelled, |sum, (seen, z)| sum + seen * *z);
                Some((solution.basis.iter().collect(), stuck.twist(&travelled)))
            }
            _ => None,
        }
    }

    /// The springs along the faces where these rows bind; `None` if they do not satisfy the law. The twist is the least one,
    /// or one near that of the pivots where the least would let something slip the wrong way.
    fn on_faces(&self, binding: &[usize], near: &SVector<f64, D>) -> Option<Faces<D, C>> {
        let mut list = Vec::new();
        for (contact, site) in self.sites.iter().enumerate() {
            let own = binding.iter().map(|r| &self.rows[*r]).filter(|row| row.contact == contact);
            let normals: Vec<_> = own.map(|row| row.normal).collect();
            for t in face(&normals, site.springs.axes()) {
                list.push(Spring { contact, along: t.component_mul(&site.springs.root()) });
            }
        }
        let springs = Springs::new(self.sites, list);
        if springs.worked_on(&self.wrench).is_some() {
            return None;
        }
        let state = springs.rest(&self.drives, &self.wrench);
        let forces = springs.forces(&state.x, self.sites.len());
        let mut twist = springs.twist(&state.travelled);
        if !self.jumps_outwards(&forces, &twist) {
            for v in &springs.free {
                twist += v * v.dot(near);
            }
        }
        let faces = Faces { forces, twist };
        let most = self.largest_force(&faces);
        let inside = |row: &FrictionRow<C>| self.value(row, &faces) >= -ROUNDING * most * row.weight;
        self.rows.iter().all(inside).then_some(faces)
    }

    /// The rows that stand on their edge.
    fn on_edge(&self, faces: &Faces<D, C>) -> Vec<usize> {
        let most = self.largest_force(faces);
        let edge = |r: &usize| {
            let row = &self.rows[*r];
            self.value(row, faces) <= ROUNDING * most * row.weight
        };
        (0..self.rows.len()).filter(edge).collect()
    }

    fn value(&self, row: &FrictionRow<C>, faces: &Faces<D, C>) -> f64 {
        row.value(&self.sites[row.contact], &faces.forces[row.contact])
    }

    fn largest_force(&self, faces: &Faces<D, C>) -> f64 {
        let sizes = faces.forces.iter().map(SVector::norm);
        largest_force(self.sites, &self.drives, &faces.twist, self.wrench.norm(), sizes)
    }

    /// How far the surfaces of a contact have parted: (gap, -slip).
    fn jump(&self, contact: usize, force: &SVector<f64, C>, twist: &SVector<f64, D>) -> SVector<f64, C> {
        let site = &self.sites[contact];
        site.springs.give(force) - site.stretch(&self.drives[contact], twist)
    }

    /// Whether every jump lies in the cone of the outward normals: it works against no force of the friction cone.
    fn jumps_outwards(&self, forces: &[SVector<f64, C>], twist: &SVector<f64, D>) -> bool {
        self.sites.iter().enumerate().filter(|(_, site)| site.hold != Hold::Bonded).all(|(i, site)| {
            let jump = self.jump(i, &forces[i], twist);
            let slack = -ROUNDING * site.span(&self.drives[i], twist);
            let cone = site.friction;
            if !site.springs.resists_tangentially() || cone.is_infinite() {
                return site.hold == Hold::KeptClosed || jump[0] >= slack;
            }
            self.corners.iter().all(|d| cone.generator(d).dot(&jump) >= slack * cone.round_weight())
        })
    }
}

/// An orthonormal basis of the vectors of the first `axes` components at right angles to all of these.
fn face<const C: usize>(normals: &[SVector<f64, C>], axes: usize) -> Vec<SVector<f64, C>> {
    let mut taken: Vec<SVector<f64, C>> = Vec::new();
    let rest = |v: &SVector<f64, C>, taken: &[SVector<f64, C>]| {
        let mut v = *v;
        for _ in 0..2 {
            for t in taken {
                v -= t * t.dot(&v);
            }
        }
        v
    };
    for normal in normals {
        let left = rest(normal, &taken);
        if left.norm() > DEPENDENT {
            taken.push(left.normalize());
        }
    }
    let bound = taken.len();
    while taken.len() < axes {
        // The axis that is farthest from what is there already.
        let units = (0..axes).map(|a| {
            let mut e = SVector::<f64, C>::zeros();
            e[a] = 1.0;
            rest(&e, &taken)
        });
        let Some(next) = units.max_by(|a, b| a.norm().total_cmp(&b.norm())) else { break };
        taken.push(next.normalize());
    }
    taken.split_off(bound)
}
