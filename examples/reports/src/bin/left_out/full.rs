//! The full kinematic formulation, assembled by its formulas from the contacts of a grasp.
//!
//! Let G be the grasp maps of all contacts, K the stiffnesses, a the commands, W the load, and h_j the normals of the facets. While
//! everything sticks, the object has the twist q⁰ and the contacts have the forces F⁰. The unknowns z are the gaps and the slips
//! along the facet normals.
//!
//! ```text
//! q⁰ = (G K Gᵀ)⁻¹ (W + G K a),   F⁰ = K (a - Gᵀq⁰),   P = K - K Gᵀ (G K Gᵀ)⁻¹ G K
//! rows of L: e_n and μ e_n - h_j,   columns of B: e_n and -h_j     for every contact and every facet
//! 0 <= z  ⟂  L F⁰ + (L P B) z >= 0,   F = F⁰ + P B z
//! ```

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Hold, Wrench};
use grasp_lcp::lcp::Lcp;
use nalgebra::{DMatrix, DVector, SVector};

use crate::scene::{Failure, Scene};

/// Coefficient that replaces infinite friction, and the friction of bonded contacts; valid if these contacts neither slide nor pull.
const NEVER_SLIDES: f64 = 1e3;
/// Number of facets of the friction cone in space, as in the crate's default polygon, whose corners lie on the circle.
const FACETS: u32 = 8;

/// The complementarity problem. Its solution z gives the contact forces `sticking + jumps z`.
pub struct Full {
    pub lcp: Lcp,
    sticking: DVector<f64>,
    jumps: DMatrix<f64>,
}

/// Facet normals h of the cone `h·F_t <= μ F_n`.
fn facets<const C: usize>() -> Vec<SVector<f64, C>> {
    if C == 2 {
        return [1.0, -1.0].map(|side| SVector::from_fn(|a, _| if a == 1 { side } else { 0.0 })).to_vec();
    }
    let half = std::f64::consts::PI / f64::from(FACETS);
    let normal = |j: u32| {
        let (sin, cos) = (half * f64::from(2 * j + 1)).sin_cos();
        SVector::from_fn(|a, _| [0.0, cos / half.cos(), sin / half.cos()][a])
    };
    (0..FACETS).map(normal).collect()
}

/// The wrench of a force at a point about the origin.
fn wrench<const C: usize>(p: &SVector<f64, C>, f: &SVector<f64, C>) -> DVector<f64> {
    let cross = |i: usize, j: usize| p[i] * f[j] - p[j] * f[i];
    DVector::from_fn(C * (C + 1) / 2, |row, _| match row {
        row if row < C => f[row],
        _ if C == 2 => cross(0, 1),
        row => cross((row - C + 1) % C, (row - C + 2) % C),
    })
}

impl Full {
    /// Assembles the problem.
    pub fn new<const C: usize>(scene: &Scene<C>) -> Result<Self, Failure> {
        let d = C * (C + 1) / 2;
        let (grasp, load): (&Grasp<C>, &Wrench<C>) = (&scene.grasp, &scene.load);
        let (n, normals) = (grasp.len(), facets::<C>());
        let (mut g, mut k, mut a) = (DMatrix::zeros(d, C * n), DVector::zeros(C * n), DVector::zeros(C * n));
        let pairs = 1 + normals.len();
        let (mut l, mut b) = (DMatrix::zeros(pairs * n, C * n), DMatrix::zeros(C * n, pairs * n));
        for (i, (contact, frame)) in grasp.contacts().iter().zip(grasp.frames()).enumerate() {
            let (stiffness, command) = (contact.series_stiffness_of_axes(), contact.commanded());
            let (at, row) = (C * i, pairs * i);
            for axis in 0..C {
                g.column_mut(at + axis).copy_from(&wrench::<C>(&contact.point(), &frame.column(axis).into()));
                (k[at + axis], a[at + axis]) = (stiffness[axis], command[axis]);
            }
            let mu = if scene.holds[i] == Hold::Bonded {
                NEVER_SLIDES
            } else {
                contact.friction_coefficient().min(NEVER_SLIDES)
            };
            (l[(row, at)], b[(at, row)]) = (1.0, 1.0);
            for (j, h) in normals.iter().enumerate() {
                l[(row + 1 + j, at)] = mu;
                for axis in 1..C {
                    l[(row + 1 + j, at + axis)] = -h[axis];
                    b[(at + axis, row + 1 + j)] = -h[axis];
                }
            }
        }
        let gk = DMatrix::from_fn(d, C * n, |row, j| g[(row, j)] * k[j]);
        let object = (&gk * g.transpose()).cholesky().ok_or("a motion is free")?;
        let twist = object.solve(&(DVector::from_column_slice(load.components()) + &gk * &a));
        let sticking = k.component_mul(&a) - gk.tr_mul(&twist);
        let jumps = DMatrix::from_fn(C * n, pairs * n, |i, j| k[i] * b[(i, j)])
            - gk.tr_mul(&object.solve(&(&gk * &b)));
        let lcp = Lcp::new(&l * &jumps, &l * &sticking)?;
        Ok(Self { lcp, sticking, jumps })
    }

    /// Forces in the contact frames, and the number of pivots; `None` if Lemke's method ends on a ray.
    pub fn solve<const C: usize>(&self) -> Option<(Vec<SVector<f64, C>>, usize)> {
        let outcome = self.lcp.solve();
        let solution = outcome.solution()?;
        let forces = &self.sticking + &self.jumps * &solution.z;
        let forces = forces.as_slice().chunks(C).map(SVector::from_column_slice).collect();
        Some((forces, solution.pivots))
    }
}
