//! The quadratic program without the displacements of the surfaces, which its equalities eliminate.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::program::QuadraticProgram;
use super::program_rows::ProgramRows;
use crate::contact::{LocalLaw, PolygonCone};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::unit;
use crate::prelude::*;

/// The unknowns that a reduced program keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Unknowns {
    /// The twist, and the gaps of contacts that may open. Contacts with infinite friction have the row F_n >= 0 instead of a gap. The minimum is that
    /// of the printed program, unless the printed program opens a contact with infinite friction.
    #[default]
    TwistAndGaps,
    /// The twist alone: contacts cannot open.
    Twist,
}

/// The meaning of an inequality row of a reduced program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReducedRow {
    /// g >= 0 (m).
    NoPenetration {
        /// The contact.
        contact: usize,
    },
    /// F_n >= 0 (N).
    Pushes {
        /// The contact.
        contact: usize,
    },
    /// μ F_n - h·F_t >= 0 (N).
    Friction {
        /// The contact.
        contact: usize,
        /// The facet: in the plane 0 for F_t <= μ F_n, 1 for -F_t <= μ F_n. In space the normal of facet j is at the angle (2j - 1) π/m from the
        /// first tangent towards the second, where m is the number of facets. Over the unit circle the facet of the cone is h·x = 1.
        facet: usize,
    },
}

/// A reduced program with the meaning of its unknowns and rows. It has no equalities.
///
/// The equalities of the [printed program](super::PrintedQp) give u_c from the twist, and u_d and u_e from u_c and the gap. With the series stiffness
/// K_i, the drive a_i (command less clearance) and the gaps g of the contacts that may open
///
/// ```text
/// minimise  Σ ½ F_iᵀK_i⁻¹F_i - W·q,      F_i = K_i (a_i - G_iᵀq + e_n g_i)
/// subject to  g_i >= 0,   μ F_n - h·F_t >= 0 for every facet of the cone
/// ```
///
/// Without the gaps only the twist is unknown, which is the most obvious program. It must then demand F_n >= 0, and that constraint can hold the
/// object back where a finger is about to leave. With its gap among the unknowns a frictionless contact simply opens.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReducedQp<const C: usize> {
    /// The program: unknowns are the twist (d entries, about the origin of the coordinates, m and rad), then the gaps (m). Its cost is in J.
    pub program: QuadraticProgram,
    /// The contacts whose gaps follow the twist among the unknowns, in this order.
    pub gaps: Vec<usize>,
    /// The meaning of each row of B, a quantity that must not be negative.
    pub rows: Vec<ReducedRow>,
    /// `Σ ½ aᵀK a`, J, which the cost omits: with it the cost is stored energy less the work of the load.
    pub constant: f64,
}

impl Engine {
    /// [`Energy::reduced_qp`](crate::ask::Energy::reduced_qp).
    pub(crate) fn reduced_qp(
        &self,
        load: &Wrench<3>,
        cone: &PolygonCone,
        unknowns: Unknowns,
    ) -> Result<ReducedQp<3>, Error> {
        self.refuse_hands("reduced_qp")?;
        let problem = self.on_polygons(load, cone)?;
        let may_open = |local: &LocalLaw<'_>| {
            unknowns == Unknowns::TwistAndGaps && local.may_open() && !local.never_slides()
        };
        let gaps = problem.locals().enumerate().filter(|(_, local)| may_open(local));
        let gaps: Vec<usize> = gaps.map(|(i, _)| i).collect();
        let (size, count) = (self.size(), self.size().count());
        let n = count + gaps.len();
        let (mut g, mut h) = (DVector::zeros(n), DMatrix::zeros(n, n));
        for (g, load) in g.iter_mut().zip(load.coordinates(self.space()).iter()) {
            *g = -load;
        }
        let mut rows = ProgramRows::new(n);
        let mut constant = 0.0;
        for (i, (local, drive)) in problem.locals().zip(&problem.drives).enumerate() {
            // Stretch of the springs: a - S x, with S = [G_iᵀ, -e_n at the gap].
            let mut s = DMatrix::zeros(3, n);
            let map = self.space().grasp_map(size, &self.contacts()[i].point, &self.sites()[i].frame);
            for k in 0..count {
                s.set_column(k, &map.row(k));
            }
            let gap = gaps.iter().position(|j| *j == i).map(|place| count + place);
            if let Some(gap) = gap {
                s[(0, gap)] = -1.0;
            }
            let pushed = local.springs.force(drive);
            h += s.transpose() * SMatrix::from_diagonal(&local.springs.diagonal()) * &s;
            g -= s.tr_mul(&pushed);
            constant += 0.5 * drive.dot(&pushed);
            let mut push = |says: ReducedRow, law: &SVector<f64, 3>| {
                rows.push(says, -s.tr_mul(&local.springs.force(law)), -law.dot(&pushed));
            };
            if local.may_open() && gap.is_none() {
                push(ReducedRow::Pushes { contact: i }, &unit(0));
            }
            for (facet, normal) in local.facets().iter().enumerate() {
                push(ReducedRow::Friction { contact: i, facet }, &local.cone().facet_row(normal));
            }
            if let Some(gap) = gap {
                rows.push_terms(ReducedRow::NoPenetration { contact: i }, [(gap, 1.0)], 0.0);
            }
        }
        let (rows, b, d) = rows.finish();
        let program = QuadraticProgram { g, h, a: DMatrix::zeros(0, n), c: DVector::zeros(0), b, d };
        Ok(ReducedQp { program, gaps, rows, constant })
    }
}
