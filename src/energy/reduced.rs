//! The quadratic program that is left when the displacements of the surfaces are eliminated.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::program::QuadraticProgram;
use crate::contact::{Polygon, PolygonCone};
use crate::error::Error;
use crate::grasp::{Grasp, Hold, Wrench, displacement_of};

/// Which unknowns a reduced program keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Unknowns {
    /// The twist, and the gaps of contacts that may open, but not of those with infinite friction, which have F_n >= 0 instead: the same minimum
    /// as the printed program as long as that opens none of these.
    #[default]
    TwistAndGaps,
    /// The twist alone: contacts cannot open.
    Twist,
}

/// What an inequality row of a reduced program says.
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
        /// The facet: in the plane 0 for F_t <= μ F_n, 1 for -F_t <= μ F_n. In space the normal of facet j stands at the angle (2j - 1) π/m from
        /// the first tangent towards the second, m being the number of facets, and h·x = 1 is the facet of the cone over the unit circle.
        facet: usize,
    },
}

/// A reduced program with the meaning of its unknowns and rows. It has no equalities.
///
/// The equalities of the [printed program](super::PrintedQp) give u_c from the twist, and u_d and u_e from u_c and the gap.
/// With the series stiffness K_i, the drive a_i (command less clearance) and the gaps g of the contacts that may open
///
/// ```text
/// minimise  Σ ½ F_iᵀK_i⁻¹F_i - W·q,      F_i = K_i (a_i - G_iᵀq + e_n g_i)
/// subject to  g_i >= 0,   μ F_n - h·F_t >= 0 for every facet of the cone
/// ```
///
/// Without the gaps the twist alone is unknown: the problem that one would write down first. Then F_n >= 0 must be
/// demanded, and a finger can hold the object back by being about to leave it; with its gap among the unknowns a
/// frictionless contact just opens.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReducedQp<const D: usize, const C: usize> {
    /// The program: unknowns are the twist (d entries, about the origin of the coordinates, m and rad), then the gaps (m). Its cost is in J.
    pub program: QuadraticProgram,
    /// The contacts whose gaps follow the twist among the unknowns, in this order.
    pub gaps: Vec<usize>,
    /// What each row of B says, that it is not negative.
    pub rows: Vec<ReducedRow>,
    /// `Σ ½ aᵀK a`, J, which the cost leaves out: with it the cost is stored energy less the work of the load.
    pub constant: f64,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The reduced quadratic program under a load; `cone` stands for the round cone in space.
    ///
    /// ```
    /// use grasp_lcp::PolygonCone;
    /// use grasp_lcp::energy::Unknowns;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Rows F_n >= 0 and ±F_t <= μ F_n of each contact, unknowns x, y and the angle.
    /// let reduced = grasp.reduced_qp(&Wrench::force([0.0, -6.0]), &PolygonCone::default(), Unknowns::Twist)?;
    /// let outcome = reduced.program.solve()?;
    /// let minimum = outcome.minimum().ok_or("the program is strictly convex")?;
    /// assert!((minimum.x[1] + 6.0 / (2.0 * 800.0)).abs() < 1e-16);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn reduced_qp(
        &self,
        load: &Wrench<D>,
        cone: &PolygonCone,
        unknowns: Unknowns,
    ) -> Result<ReducedQp<D, C>, Error> {
        self.inside(load, "load")?;
        let polygon = Polygon::<C>::new(cone);
        let may_open = |i: &usize| {
            let site = &self.sites()[*i];
            unknowns == Unknowns::TwistAndGaps
                && site.hold == Hold::Unilateral
                && !site.friction.is_infinite()
        };
        let gaps: Vec<usize> = (0..self.len()).filter(may_open).collect();
        let n = D + gaps.len();
        let (mut g, mut h) = (DVector::zeros(n), DMatrix::zeros(n, n));
        let (mut rows, mut b, mut d) = (Vec::new(), Vec::new(), Vec::new());
        let mut constant = 0.0;
        for k in 0..D {
            g[k] = -load.as_vector()[k];
        }
        for (i, (site, drive)) in self.sites().iter().zip(self.drives()).enumerate() {
            // Stretch of the springs: a - S x, with S = [G_iᵀ, -e_n at the gap].
            let mut s = DMatrix::zeros(C, n);
            s.view_mut((0, 0), (C, D)).copy_from(&self.motion_at(i));
            let gap = gaps.iter().position(|j| *j == i).map(|place| D + place);
            if let Some(gap) = gap {
                s[(0, gap)] = -1.0;
            }
            let k = site.springs.stiffness();
            h += s.transpose() * k * &s;
            g -= s.transpose() * (k * drive);
            constant += 0.5 * drive.dot(&(k * drive));
            let mut push = |says: ReducedRow, row: &SVector<f64, C>| {
                let row = site.springs.force(row);
                rows.push(says);
                b.push(-s.tr_mul(&row));
                d.push(-row.dot(&drive));
            };
            let push_normal = SVector::from_fn(|a, _| if a == 0 { 1.0 } else { 0.0 });
            if site.hold == Hold::Unilateral && gap.is_none() {
                push(ReducedRow::Pushes { contact: i }, &push_normal);
            }
            if site.hold != Hold::Bonded && site.friction.has_edges() {
                for (facet, normal) in polygon.normals.iter().enumerate() {
                    push(ReducedRow::Friction { contact: i, facet }, &site.friction.facet_row(normal));
                }
            }
            if let Some(gap) = gap {
                rows.push(ReducedRow::NoPenetration { contact: i });
                b.push(DVector::from_fn(n, |j, _| if j == gap { 1.0 } else { 0.0 }));
                d.push(0.0);
            }
        }
        let b = DMatrix::from_fn(b.len(), n, |i, j| b[i][j]);
        let program = QuadraticProgram {
            g,
            h,
            a: DMatrix::zeros(0, n),
            c: DVector::zeros(0),
            b,
            d: DVector::from_vec(d),
        };
        Ok(ReducedQp { program, gaps, rows, constant })
    }

    /// G_iᵀ about the origin of the user's coordinates: twist → displacement in the contact frame.
    fn motion_at(&self, i: usize) -> SMatrix<f64, C, D> {
        let mut motion = SMatrix::<f64, C, D>::zeros();
        for k in 0..D {
            let unit = SVector::<f64, D>::from_fn(|j, _| if j == k { 1.0 } else { 0.0 });
            let moved = displacement_of::<D, C>(&self.contacts()[i].point, &unit);
            motion.set_column(k, &self.sites()[i].frame.tr_mul(&moved));
        }
        motion
    }
}
