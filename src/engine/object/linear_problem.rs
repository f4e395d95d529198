//! With every contact in a known state all laws are linear: one linear `d x d` system gives the twist of the object and the contact forces.
//!
//! A contact in a known state is a few springs r, each stretched along a vector s_r and pushing along p_r:
//! `F_i = Σ_r p_r (s_r · v_i)`. Each vector contains the square root of the spring's stiffness. The stretch `v_i = a_i - G_iᵀq` follows from offset
//! a_i (commanded displacement minus clearance and slip), grasp map G_i and twist q.
//!
//! With a row for each spring, let A = s Gᵀ, B = p Gᵀ and α = s·a. The scaled spring forces x_r = s_r · v_i then satisfy
//! `x = α - A q`, and balance the load W if `Bᵀx = -W`. Thus x is an oblique projection of α (an orthogonal projection if nothing slides). A and B
//! are factorised by orthogonal transformations.

use crate::numerics::{
    CompletePivoting, IntoList, Map, Once, Orthogonal, Size, Square, Vector, mapped, orthonormalise_against,
    without,
};
use core::ops::Range;

use nalgebra::SVector;

use super::banded_tangent::BandedTangent;
use super::free_motions::motion_of_work;
use super::null_motions::NullMotions;
use super::problem::Problem;
use crate::contact::{Spring, State};
use crate::grasp::{Site, size_of};
use crate::prelude::*;

/// The linear problem in which every contact keeps one known state, factorised. Offsets and load are not part of it.
#[derive(Debug, Clone)]
pub(crate) struct LinearProblem {
    pub(super) springs: Vec<Spring>,
    /// For each contact the index of its first spring in `springs`; a last entry is the number of springs.
    first: Vec<usize>,
    /// An orthonormal basis of the motions q that stretch no spring (A q = 0 with the matrix A of spring stretches).
    pub(super) free: Vec<Vector>,
    /// An orthonormal basis of the motions q along which no spring pushes (B q = 0 with the matrix B of push directions). A load that does work
    /// along such a motion cannot be balanced.
    pub(super) unbalanced: Vec<Vector>,
    /// LU factors of the tangent stiffness T = BᵀA as a band matrix, with its null vectors. `None` with fewer than 36 coordinates, for which
    /// orthogonal factors are as fast, or if T is nearly, but not exactly, singular.
    pub(super) band: Option<(BandedTangent, NullMotions)>,
    /// Orthogonal factors of the matrices A (spring stretches under a motion) and B (push directions). If `band` is given, they are computed on first
    /// use.
    orthogonal: Once<OrthogonalFactors>,
    size: Size,
}

/// Orthogonal factors of [`LinearProblem`]'s matrices: Q_A R_A of A (spring stretches under a motion), and Q_B R_B of B (push directions) if a
/// contact slides.
#[derive(Debug, Clone)]
pub(super) struct OrthogonalFactors {
    pub(super) stretches: Orthogonal,
    /// Orthogonal factors Q_B R_B of the push directions B, and LU factors of `Q_BᵀQ_A`, where Q_A is the orthogonal factor of A. `None` if nothing
    /// slides, since then B = A.
    pub(super) pushes: Option<(Orthogonal, CompletePivoting)>,
}

impl LinearProblem {
    pub(crate) fn new(problem: &Problem, states: &[State]) -> Self {
        Self::of_springs(problem.sites, &|contact, springs| {
            problem.local(contact).for_each_spring(&states[contact], |spring| springs.push(spring));
        })
    }

    /// The linear problem of given springs: `add(contact, list)` appends the springs of one contact to the list, at most one for each axis.
    pub(crate) fn of_springs(sites: &[Site], add: &dyn Fn(usize, &mut Vec<Spring>)) -> Self {
        let mut springs = Vec::with_capacity(3 * sites.len());
        let mut first = Vec::with_capacity(sites.len() + 1);
        first.push(0);
        for contact in 0..sites.len() {
            add(contact, &mut springs);
            first.push(springs.len());
        }
        let size = size_of(sites);
        if let Some(band) = BandedTangent::new(sites, &springs, &first)
            && let Some(null) = NullMotions::of(&band)
        {
            let (free, unbalanced) = (null.free.clone(), null.unbalanced.clone());
            let (band, orthogonal) = (Some((band, null)), Once::new());
            return Self { springs, first, free, unbalanced, band, orthogonal, size };
        }
        let rows = |side: fn(&Spring) -> &SVector<f64, 3>| {
            let mut rows = Vec::with_capacity(springs.len());
            for (site, range) in sites.iter().zip(first.windows(2)) {
                rows.extend(mapped(&springs[range[0]..range[1]], &|spring| &site.map * side(spring)));
            }
            rows
        };
        let stretches = rows(|spring| &spring.stretch_direction);
        let straight = springs.iter().all(|spring| spring.push_direction == spring.stretch_direction);
        let pushes = (!straight).then(|| rows(|spring| &spring.push_direction));
        let factors = OrthogonalFactors::new(size, &stretches, pushes.as_deref());
        let free = factors.stretches.null_space();
        let unbalanced =
            factors.pushes.as_ref().map_or_else(|| free.clone(), |(pushes, _)| pushes.null_space());
        Self { springs, first, free, unbalanced, band: None, orthogonal: Once::from(factors), size }
    }

    /// The orthogonal factors of the matrices A (spring stretches) and B (push directions). If the band matrix is factorised already, these
    /// factors are computed on first use.
    pub(super) fn orthogonal(&self) -> &OrthogonalFactors {
        self.orthogonal.get_or_init(|| {
            let [stretches, pushes] =
                self.band.as_ref().map_or_else(|| [None, None], |(band, _)| band.rows());
            OrthogonalFactors::new(self.size, &stretches.unwrap_or_default(), pushes.as_deref())
        })
    }

    /// Number of coordinates of the twist: the coordinates of the object, of all joints and of further bodies.
    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// Orthogonal factors of the matrix A of spring stretches under a motion, with a row for each spring in the order of contacts. While everything
    /// sticks A = K^{1/2}Gᵀ, with the stiffnesses K and the grasp maps G.
    pub(crate) fn factor(&self) -> &Orthogonal {
        &self.orthogonal().stretches
    }

    /// The rows of a contact's springs in the orthogonal factor Q of the stretch matrix A = Q R. Each spring lies along an axis of the contact.
    /// Column a of the result is the row of the spring along axis a; it is zero without a spring.
    pub(crate) fn factor_rows(&self, contact: usize) -> Map {
        let mut rows = Map::zeros(self.size);
        for spring in self.first[contact]..self.first[contact + 1] {
            rows.set_column(self.springs[spring].stretch_direction.iamax(), self.factor().row(spring));
        }
        rows
    }

    /// True if the tangent stiffness BᵀA is factorised as a band matrix, false if A and B have orthogonal factors.
    pub(crate) fn is_banded(&self) -> bool {
        self.band.is_some()
    }

    /// The change of every coordinate if a sticking contact pushes with given forces along its axes. The coordinates are in the order in which the
    /// tangent stiffness is a narrow band. The entries of `pushes` are the forces divided by the square roots of the stiffnesses. `None` if there is
    /// no band matrix.
    pub(crate) fn displacements_under(&self, contact: usize, pushes: &SVector<f64, 3>) -> Option<Vec<f64>> {
        Some(self.band.as_ref()?.0.displacements_under(contact, &self.along_springs(contact, pushes)[..]))
    }

    /// The weighted sum of the scaled stretches of a contact's springs under the changes `displacements` of the coordinates. The coordinates are in
    /// the order in which the tangent stiffness is a narrow band. The weight of a stretch is the entry of `times` for the spring's axis. Only
    /// a problem with a band matrix has this sum; otherwise 0 is returned, without a meaning.
    pub(crate) fn weighted_stretch(
        &self,
        contact: usize,
        times: &SVector<f64, 3>,
        displacements: &[f64],
    ) -> f64 {
        self.band.as_ref().map_or(0.0, |(band, _)| {
            band.weighted_stretch(contact, &self.along_springs(contact, times)[..], displacements)
        })
    }

    /// The components of the vector `axes` in the contact frame, in the order of the contact's springs, each of which lies along an axis.
    fn along_springs(&self, contact: usize, axes: &SVector<f64, 3>) -> Vec<f64> {
        mapped(&self.springs[self.first[contact]..self.first[contact + 1]], &|spring| {
            axes[spring.stretch_direction.iamax()]
        })
    }

    /// The motion q of least norm with `R q = coordinates`. Here R is the triangular factor of the matrix A = Q R, which maps motions to spring
    /// stretches.
    pub(crate) fn motion(&self, coordinates: &Vector) -> Vector {
        without(self.factor().preimage(coordinates), self.free_motions())
    }

    /// An orthonormal basis of the motions that stretch no spring: the twist is determined up to them, and forces do not depend on them.
    pub(crate) fn free_motions(&self) -> &[Vector] {
        &self.free
    }

    /// An orthonormal basis of the motions along which contact forces change but stay in balance, orthogonal to the free motions. If there is
    /// such a motion, the forces in these contact states are not unique.
    pub(crate) fn neutral_motions(&self) -> Vec<Vector> {
        if let Some((_, null)) = &self.band {
            return null.neutral.clone();
        }
        let OrthogonalFactors { stretches, pushes } = self.orthogonal();
        let Some((_, coupling)) = pushes else { return Vec::new() };
        let mut motions: Vec<Vector> = Vec::new();
        for c in coupling.kernel() {
            let mut v = stretches.preimage(&c);
            let found: Vec<_> = self.free.iter().chain(&motions).cloned().list();
            orthonormalise_against(&mut v, &found);
            motions.push(v);
        }
        motions
    }

    /// A virtual motion y along which the work of the springs does not depend on where the object is. It is a left null vector of the tangent
    /// stiffness, `Σ G_i C_iᵀG_iᵀ y = 0`, with the tangent stiffness C_i and the grasp map G_i of contact i. Along some left null
    /// vectors no spring pushes. If the load does work along such vectors, y is the direction among them with the most work of the load. Otherwise
    /// springs push along y, and y is the direction with the most work of the load and the spring forces at zero motion together. `None` if this work
    /// is zero, too.
    pub(crate) fn motion_without_response(
        &self,
        offsets: &[SVector<f64, 3>],
        load: &Vector,
    ) -> Option<Vector> {
        let work_part = |basis: &[Vector], work: &Vector| {
            let part = basis.iter().fold(Vector::zeros(), |sum: Vector, v| sum + v * v.dot(work));
            (part.norm() > 0.0).then_some(part)
        };
        if let Some(motion) = work_part(&self.unbalanced, load) {
            return Some(motion);
        }
        if let Some((_, null)) = &self.band {
            return null.motion_of_work(&self.stretched(&|contact| offsets[contact]), load);
        }
        let (pushes, coupling) = self.orthogonal().pushes.as_ref()?;
        let mut kernel: Vec<Vector> = Vec::new();
        for mut z in coupling.left_kernel() {
            orthonormalise_against(&mut z, &kernel);
            kernel.push(z);
        }
        let pushed = pushes.coordinates(&self.stretched(&|contact| offsets[contact]));
        Some(pushes.preimage(&work_part(&kernel, &(pushed + pushes.load_coordinates(load)))?))
    }

    /// Factor by which the solution in these contact states amplifies relative rounding errors, at least 1; exactly 1 if nothing slides.
    pub(crate) fn growth(&self) -> f64 {
        match &self.band {
            Some((band, _)) => band.growth(),
            None => self.orthogonal().pushes.as_ref().map_or(1.0, |(_, coupling)| coupling.growth()),
        }
    }

    /// Whether the springs can balance the load. They can if the load does no work, up to rounding, along any motion along which no spring
    /// pushes.
    pub(crate) fn resists(&self, wrench: &Vector) -> bool {
        motion_of_work(&self.unbalanced, wrench).is_none()
    }

    /// For every contact that has springs: its index, its springs, and their index range in the list of all springs.
    pub(super) fn of_each_contact(&self) -> impl Iterator<Item = (usize, &[Spring], Range<usize>)> {
        self.first.windows(2).enumerate().filter(|(_, range)| range[0] < range[1]).map(|(contact, range)| {
            let range = range[0]..range[1];
            (contact, &self.springs[range.clone()], range)
        })
    }
}

impl OrthogonalFactors {
    /// Orthogonal factors from the rows of the matrices A (`stretches`: spring stretches) and, if a contact slides, B (`pushes`: push directions).
    fn new(size: Size, stretches: &[Vector], pushes: Option<&[Vector]>) -> Self {
        let stretches = Orthogonal::new(size, stretches);
        let Some(pushes) = pushes else { return Self { stretches, pushes: None } };
        let count = pushes.len();
        let pushes = Orthogonal::new(size, pushes);
        let mut coupling = Square::zeros(size);
        for i in 0..count {
            coupling.add_product(pushes.row(i), stretches.row(i));
        }
        let coupling = CompletePivoting::new(coupling, pushes.rank(), stretches.rank());
        Self { stretches, pushes: Some((pushes, coupling)) }
    }

    /// Orthogonal factors of the matrix B of push directions, which occurs in the balance `Bᵀx = -W` of spring forces x and load W. If nothing
    /// slides, B equals the matrix A of stretches, and the factors of A are returned.
    pub(super) fn balance(&self) -> &Orthogonal {
        self.pushes.as_ref().map_or(&self.stretches, |(pushes, _)| pushes)
    }
}

/// The contact forces of least norm that balance a load, in the contact frames; contacts for which `carries` is false have no force. Friction is not
/// checked.
pub(crate) fn least_forces(sites: &[Site], carries: &[bool], wrench: &Vector) -> Vec<SVector<f64, 3>> {
    let mut axes = Vec::new();
    for (i, site) in sites.iter().enumerate() {
        if carries[i] {
            for a in 0..site.springs.axes() {
                axes.push((i, a));
            }
        }
    }
    let columns: Vec<Vector> = mapped(&axes, &|&(i, a)| sites[i].map.column(a));
    let factor = Orthogonal::new(size_of(sites), &columns);
    let coordinates = factor.load_coordinates(wrench);
    let mut forces = vec![SVector::<f64, 3>::zeros(); sites.len()];
    for (k, &(i, a)) in axes.iter().enumerate() {
        forces[i][a] = -factor.along_row(k, &coordinates);
    }
    forces
}
