//! From the question to complementarity: contact-law rows, the polygonal cone, the two forms, what is left out.
//!
//! The symbols are those of the [crate page](crate#the-problem); K is the diagonal matrix of all series stiffnesses, G = [G_1 G_2 …], and the friction
//! cone a polygon with facet normals h_j and corners d_j ([`PolygonCone`]).
//!
//! **Kinematic form** ([`Grasp::kinematic_form`]). Everything sticks at first, F⁰ = K (a - Gᵀq⁰) with Σ G_i F⁰_i + W = 0: one d x d solve. On top of it
//! come jumps z, gaps and slips `s = Σ σ_j h_j`, that change the forces by what the object does not follow:
//!
//! ```text
//! F = F⁰ + P B z,   w = L F,   0 <= z ⟂ w = L F⁰ + (L P B) z >= 0
//! rows of L: e_n and μ e_n - h_j;   columns of B: e_n and -h_j;   P = K - K Gᵀ (G K Gᵀ)⁻¹ G K
//! ```
//!
//! Small, and solved by z = 0 exactly when everything rolls. Its matrix is not copositive: with strong friction Lemke's method can end on a ray
//! although an equilibrium exists, so that a ray proves nothing.
//!
//! **Force form** ([`Grasp::force_form`]). Forces are the unknowns, compliances stand on the diagonal, the twist is free:
//!
//! ```text
//! 0 <= F_n ⟂ g      =  F_n/k_n - a_n + n·u_c                          >= 0
//! 0 <= β_j ⟂ λ - d_j·s,   s = a_t - t·u_c - K_t⁻¹ F_t,  F_t = Σ β_j d_j  >= 0
//! 0 <= λ   ⟂ μ F_n - Σ β_j                                            >= 0
//! q free:   Σ G_i F_i + W = 0
//! ```
//!
//! About twice the size, and copositive: Lemke's method finds a solution whenever no motion q with n·u_c >= 0 at all contacts has W·q > 0.
//!
//! A row that a contact does not need is never made ([`Why`]). [`Form`] says which row is what ([`Row`]) and in which units.

mod cone;
mod correction;
mod excess;
mod force_form;
mod kinematic;
mod piece;
mod problem;
mod return_map;
mod rows;
mod spring;
mod tangent;

pub use cone::{Fit, PolygonCone};
pub use rows::{Form, LeftOut, Row, Why};

pub(crate) use cone::Polygon;
pub(crate) use excess::PreciseTwist;
pub(crate) use force_form::{force_form, force_states};
pub(crate) use kinematic::{kinematic_form, kinematic_states};
pub(crate) use piece::{Piece, PieceState, least_combination, least_forces};
pub(crate) use problem::{Law, Problem, State, whole_law};
pub(crate) use return_map::{Returned, Slide, respond, slide_on};
pub(crate) use spring::{contact_stiffness, corner, edge_direction};
pub(crate) use tangent::{Springs, balance, tangent_stiffness};

use std::sync::Arc;

use crate::error::Error;
use crate::grasp::{Grasp, Wrench};

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The [kinematic form](self) under a load: jumps (gaps and slips) on top of the elastic trial state in which everything
    /// sticks. `None` if no contact needs a row, if the load works on a motion that no contact resists, or if a number overflows. When
    /// `lcp.vector() >= 0` everything rolls and z = 0 is the answer. In the plane `cone` is not looked at.
    ///
    /// ```
    /// use grasp_lcp::formulation::Row;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{PolygonCone, lcp::Outcome};
    ///
    /// // A body on a spring of 100 N/m that rests on a floor just so, and is pulled up by 1 N: it lifts off by 10 mm.
    /// let spring = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).bonded();
    /// let floor = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0);
    /// let grasp = Grasp::new([spring, floor])?;
    ///
    /// let form = grasp.kinematic_form(&Wrench::force([0.0, 1.0]), &PolygonCone::default())?.expect("the floor has a row");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it lifts off") };
    /// let row = form.position(Row::Gap { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.01).abs() < 1e-17);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn kinematic_form(&self, load: &Wrench<D>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let polygon = Arc::new(Polygon::new(cone));
        let problem = Problem::at_rest(self.sites(), polygon, self.drives(), self.inside(load, "load")?);
        let states: Vec<State> = (0..self.len()).map(|i| problem.unjumped(i)).collect();
        let trial = Piece::new(&problem, &states);
        let Ok(state) = trial.solve(problem.sites, &problem.drives, problem.load()) else { return Ok(None) };
        Ok(kinematic_form(&problem, &trial, &state))
    }

    /// The [force form](self) under a load: forces as unknowns, the twist free and split in two halves ([`Row::Balance`]). Contacts that act
    /// both ways (bonded, kept closed, infinite friction) have springs in the rows of the balance and no rows of their own. `None` if a
    /// number overflows. In the plane `cone` is not looked at.
    ///
    /// ```
    /// use grasp_lcp::formulation::Row;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{PolygonCone, lcp::Outcome};
    ///
    /// // A body of 1 N on a spring and a floor of 100 N/m each: the floor carries half.
    /// let spring = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).bonded();
    /// let floor = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0);
    /// let grasp = Grasp::new([spring, floor])?;
    ///
    /// let form = grasp.force_form(&Wrench::force([0.0, -1.0]), &PolygonCone::default())?.expect("moderate numbers");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it rests") };
    /// let row = form.position(Row::NormalForce { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn force_form(&self, load: &Wrench<D>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let polygon = Arc::new(Polygon::new(cone));
        let problem = Problem::at_rest(self.sites(), polygon, self.drives(), self.inside(load, "load")?);
        Ok(force_form(&problem))
    }
}
