//! From the question to complementarity: contact-law rows, the polygonal cone, the two forms, what is left out.

mod cone;
mod correction;
mod excess;
mod force_form;
mod full_pivot;
mod kinematic;
mod orthogonal;
mod piece;
mod problem;
mod regular;
mod return_map;
mod rows;
mod spring;
mod tangent;

pub use cone::{Fit, PolygonCone};
pub use rows::{Form, LeftOut, Row, Why};

pub(crate) use cone::Polygon;
pub(crate) use excess::TwistInTwice;
pub(crate) use force_form::{force_form, force_states};
pub(crate) use full_pivot::FullPivot;
pub(crate) use kinematic::{kinematic_form, kinematic_states};
pub(crate) use orthogonal::{Orthogonal, orthonormalise_against};
pub(crate) use piece::{Piece, PieceState, least_combination, least_forces};
pub(crate) use problem::{Law, Problem, State, whole_law};
pub(crate) use regular::Regular;
pub(crate) use return_map::{Returned, Slide, respond, slide_on};
pub(crate) use spring::{contact_stiffness, corner, edge_direction};
pub(crate) use tangent::{Springs, balance, tangent_stiffness};

use std::sync::Arc;

use crate::error::Error;
use crate::grasp::{Grasp, Wrench};

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The kinematic form under a load: jumps (gaps and slips) on top of the elastic trial state in which everything
    /// sticks. `None` if no contact needs a row, or if the load works on a motion that no contact resists. When
    /// `lcp.vector() >= 0` everything rolls and z = 0 is the answer.
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite.
    pub fn kinematic_form(&self, load: &Wrench<D>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let polygon = Arc::new(Polygon::new(cone));
        let problem = Problem::at_rest(self.sites(), polygon, self.drives(), self.inside(load, "load")?);
        let states: Vec<State> = (0..self.len()).map(|i| problem.unjumped(i)).collect();
        let trial = Piece::new(&problem, &states);
        let Ok(state) = trial.solve(problem.sites, &problem.drives, problem.load()) else { return Ok(None) };
        Ok(kinematic_form(&problem, &trial, &state))
    }

    /// The force form under a load: forces as unknowns, the twist (about the centroid of the contact points) free and
    /// split in two halves. `None` if a number overflows.
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite.
    pub fn force_form(&self, load: &Wrench<D>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let polygon = Arc::new(Polygon::new(cone));
        let problem = Problem::at_rest(self.sites(), polygon, self.drives(), self.inside(load, "load")?);
        Ok(force_form(&problem))
    }
}
