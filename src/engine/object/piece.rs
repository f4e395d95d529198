//! With every contact in a known state the law is linear: one `d x d` system gives twist and forces.
//!
//! A contact in a known state is a few springs, each stretched along one direction and pushing along another:
//! `F_i = Σ_r left_r (right_r · v_i)` with `v_i = a_i - G_iᵀq`.
//!
//! With x_r = right_r · v the rows of A = right Gᵀ, B = left Gᵀ and α = right·a give `x = α - A q`, `Bᵀx = -W`: an
//! oblique projection (an orthogonal one when nothing slides). Both factors are orthogonalised.

use crate::numerics::{IntoList, Map, Size, Square, Vector, mapped};
use core::ops::Range;

use nalgebra::SVector;

use super::band_piece::BandPiece;
use super::free_motions::motion_of_work;
use super::null_motions::NullMotions;
use super::problem::Problem;
use crate::contact::{Spring, State};
use crate::grasp::{Site, size_of};
use crate::numerics::{CompletePivoting, Once, Orthogonal, orthonormalise_against, without};
use crate::prelude::*;

/// The linear problem in which every contact keeps one known state.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub(super) springs: Vec<Spring>,
    /// Index of the first spring of each contact; the last entry is the number of springs.
    first: Vec<usize>,
    /// Orthonormal motions that stretch no spring.
    pub(super) free: Vec<Vector>,
    /// Orthonormal motions in the null space of B, whose rows are the directions in which springs push: a load that does work along one of them
    /// cannot be balanced.
    pub(super) unbalanced: Vec<Vector>,
    /// Factors of the tangent stiffness T = BᵀA in a band, with many coordinates. `None` if T is nearly, but not exactly, singular.
    pub(super) band: Option<(BandPiece, NullMotions)>,
    /// Orthogonal factors of A and B; with many coordinates they are computed on first use.
    orthogonal: Once<OrthogonalPiece>,
    size: Size,
}

/// Orthogonal factors of A (stretches of springs under a motion), and of B (directions in which springs push) if a contact slides.
#[derive(Debug, Clone)]
pub(super) struct OrthogonalPiece {
    pub(super) right: Orthogonal,
    /// Factors of B, and of the product `Q_BᵀQ_A` of both orthogonal factors; `None` if nothing slides, since then B = A.
    pub(super) left: Option<(Orthogonal, CompletePivoting)>,
}

impl Piece {
    pub(crate) fn new(problem: &Problem, states: &[State]) -> Self {
        Self::of_springs(problem.sites, &|contact, springs| {
            problem.local(contact).for_each_spring(&states[contact], |spring| springs.push(spring));
        })
    }

    /// The linear problem of given springs: `add(contact, list)` appends the springs of a contact, at most one per axis.
    pub(crate) fn of_springs(sites: &[Site], add: &dyn Fn(usize, &mut Vec<Spring>)) -> Self {
        let mut springs = Vec::with_capacity(3 * sites.len());
        let mut first = Vec::with_capacity(sites.len() + 1);
        first.push(0);
        for contact in 0..sites.len() {
            add(contact, &mut springs);
            first.push(springs.len());
        }
        let size = size_of(sites);
        if let Some(band) = BandPiece::new(sites, &springs, &first)
            && let Some(null) = NullMotions::of(&band)
        {
            let (free, unbalanced) = (null.free.clone(), null.unbalanced.clone());
            let (band, orthogonal) = (Some((band, null)), Once::new());
            return Self { springs, first, free, unbalanced, band, orthogonal, size };
        }
        let rows = |side: fn(&Spring) -> &SVector<f64, 3>| {
            let mut rows = Vec::with_capacity(springs.len());
            for (site, range) in sites.iter().zip(first.windows(2)) {
                for spring in &springs[range[0]..range[1]] {
                    rows.push(&site.map * side(spring));
                }
            }
            rows
        };
        let right = rows(|spring| &spring.right);
        let straight = springs.iter().all(|spring| spring.left == spring.right);
        let left = (!straight).then(|| rows(|spring| &spring.left));
        let factors = OrthogonalPiece::new(size, &right, left.as_deref());
        let free = factors.right.null_space();
        let unbalanced = factors.left.as_ref().map_or_else(|| free.clone(), |(left, _)| left.null_space());
        Self { springs, first, free, unbalanced, band: None, orthogonal: Once::from(factors), size }
    }

    /// The orthogonal factors, computed on first use.
    pub(super) fn orthogonal(&self) -> &OrthogonalPiece {
        self.orthogonal.get_or_init(|| {
            let [right, left] = self.band.as_ref().map_or_else(|| [None, None], |(band, _)| band.rows());
            OrthogonalPiece::new(self.size, &right.unwrap_or_default(), left.as_deref())
        })
    }

    /// Number of coordinates.
    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// Orthogonal factors of A, whose rows are the springs in the order of contacts; while everything sticks A = K^{1/2}Gᵀ.
    pub(crate) fn factor(&self) -> &Orthogonal {
        &self.orthogonal().right
    }

    /// The rows of the orthogonal factor Q that belong to a contact whose springs lie along its axes. Column a belongs to axis a, and is zero without
    /// a spring.
    pub(crate) fn factor_rows(&self, contact: usize) -> Map {
        let mut rows = Map::zeros(self.size);
        for spring in self.first[contact]..self.first[contact + 1] {
            rows.set_column(self.springs[spring].right.iamax(), self.factor().row(spring));
        }
        rows
    }

    /// Whether the tangent stiffness is factored in a band, as with many coordinates.
    pub(crate) fn is_banded(&self) -> bool {
        self.band.is_some()
    }

    /// Displacements of the coordinates if a sticking contact pushes along its axes, with pushes divided by the square roots of the stiffnesses;
    /// `None` without a band.
    pub(crate) fn displacements_under(&self, contact: usize, pushes: &SVector<f64, 3>) -> Option<Vec<f64>> {
        Some(self.band.as_ref()?.0.displacements_under(contact, &self.along_springs(contact, pushes)[..]))
    }

    /// The sum of the stretches of a contact's springs under displacements of the coordinates, weighted by `times` along each axis.
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

    /// The components of a vector in the contact frame, in the order of the contact's springs along the axes.
    fn along_springs(&self, contact: usize, axes: &SVector<f64, 3>) -> Vec<f64> {
        mapped(&self.springs[self.first[contact]..self.first[contact + 1]], &|spring| {
            axes[spring.right.iamax()]
        })
    }

    /// The motion q of least norm with given coordinates `R q`, where A = Q R.
    pub(crate) fn motion(&self, coordinates: &Vector) -> Vector {
        without(self.factor().preimage(coordinates), self.free_motions())
    }

    /// Motions that stretch no spring: the twist is determined up to them, and forces do not depend on them.
    pub(crate) fn free_motions(&self) -> &[Vector] {
        &self.free
    }

    /// Motions along which forces change but stay in balance: the solution in these contact states is then not unique.
    pub(crate) fn neutral_motions(&self) -> Vec<Vector> {
        if let Some((_, null)) = &self.band {
            return null.neutral.clone();
        }
        let OrthogonalPiece { right, left } = self.orthogonal();
        let Some((_, coupling)) = left else { return Vec::new() };
        let mut motions: Vec<Vector> = Vec::new();
        for c in coupling.kernel() {
            let mut v = right.preimage(&c);
            let found: Vec<_> = self.free.iter().chain(&motions).cloned().list();
            orthonormalise_against(&mut v, &found);
            motions.push(v);
        }
        motions
    }

    /// The virtual motion y in the left null space of the tangent stiffness, `Σ G_i C_iᵀG_iᵀ y = 0`, on which offsets and load do the most work.
    /// `None` if they do no work on any.
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
            return null.motion_of_work(&self.stretched(|contact| offsets[contact]), load);
        }
        let (left, coupling) = self.orthogonal().left.as_ref()?;
        let mut kernel: Vec<Vector> = Vec::new();
        for mut z in coupling.left_kernel() {
            orthonormalise_against(&mut z, &kernel);
            kernel.push(z);
        }
        let pushed = left.coordinates(&self.stretched(|contact| offsets[contact]));
        Some(left.preimage(&work_part(&kernel, &(pushed + left.load_coordinates(load)))?))
    }

    /// Factor by which the solution in these contact states amplifies relative rounding errors, at least 1.
    pub(crate) fn growth(&self) -> f64 {
        match &self.band {
            Some((band, _)) => band.growth(),
            None => self.orthogonal().left.as_ref().map_or(1.0, |(_, coupling)| coupling.growth()),
        }
    }

    /// Whether the springs can balance the load: it does no work on any motion along which no spring pushes.
    pub(crate) fn resists(&self, wrench: &Vector) -> bool {
        motion_of_work(&self.unbalanced, wrench).is_none()
    }

    /// The springs of every contact that has any, with their index range in the list of springs.
    pub(super) fn of_each_contact(&self) -> impl Iterator<Item = (usize, &[Spring], Range<usize>)> {
        self.first.windows(2).enumerate().filter(|(_, range)| range[0] < range[1]).map(|(contact, range)| {
            let range = range[0]..range[1];
            (contact, &self.springs[range.clone()], range)
        })
    }
}

impl OrthogonalPiece {
    /// Orthogonal factors from the rows of A and, if a contact slides, of B.
    fn new(size: Size, right: &[Vector], left: Option<&[Vector]>) -> Self {
        let right = Orthogonal::new(size, right);
        let Some(left) = left else { return Self { right, left: None } };
        let count = left.len();
        let left = Orthogonal::new(size, left);
        let mut coupling = Square::zeros(size);
        for i in 0..count {
            coupling.add_product(left.row(i), right.row(i));
        }
        let coupling = CompletePivoting::new(coupling, left.rank(), right.rank());
        Self { right, left: Some((left, coupling)) }
    }

    /// The factor whose rows balance loads: B, or A where nothing slides.
    pub(super) fn balance(&self) -> &Orthogonal {
        self.left.as_ref().map_or(&self.right, |(left, _)| left)
    }
}

/// The forces of least norm on the contacts in `carries` that balance a load, in the contact frames.
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
