//! The two complementarity problems of a grasp, the meaning of their rows (complementary pairs), and the rows that a contact does not need.
//!
//! The symbols are those of the [crate page](crate#the-problem). The load W acts on the object, and q is its twist. Contact i has the grasp map G_i,
//! so that u_c = G_iᵀq is the object's displacement at the contact. It has the normal n = e_n into the object and the tangents t. Its stiffnesses are
//! k_n and K_t, its friction coefficient is μ, and its commanded displacement a_i. Its force F_i has the parts F_n and F_t; g is its gap and s its
//! slip. K is the diagonal matrix of all stiffnesses, and G = [G_1 G_2 …]. The friction cone is a polygon with facet normals h_j and corners d_j
//! ([`PolygonCone`](crate::PolygonCone)).
//!
//! **Kinematic form** ([`Grasp::kinematic_form`](crate::ask::Grasp::kinematic_form)). The elastic trial is the solution in which every contact
//! sticks. One linear solve gives its twist q⁰ and its forces F⁰ = K (a - Gᵀq⁰), with Σ G_i F⁰_i + W = 0. The unknowns z are jumps: gaps g, and the
//! coefficients σ_j >= 0 of slips `s = Σ σ_j h_j`. The slacks w are normal forces and friction margins μ F_n - h_j·F_t. The matrix P gives the change
//! of all contact forces per unit of a displacement at one contact, while the object gives way:
//!
//! ```text
//! F = F⁰ + P B z,   w = L F,   0 <= z ⟂ w = L F⁰ + (L P B) z >= 0
//! rows of L: e_n and μ e_n - h_j;   columns of B: e_n and -h_j;   P = K - K Gᵀ (G K Gᵀ)⁻¹ G K
//! ```
//!
//! The kinematic form is small, and z = 0 solves it exactly when every contact sticks. Its matrix is not copositive (zᵀMz may be negative for some
//! vector z >= 0). With strong friction Lemke's method can therefore end on a ray although an equilibrium exists: a ray proves nothing.
//!
//! **Force form** ([`Grasp::force_form`](crate::ask::Grasp::force_form)). Forces are the unknowns, compliances are on the diagonal of the matrix, and
//! the twist may have any sign. The friction force is `F_t = Σ β_j d_j` with coefficients β_j >= 0, and λ is the magnitude of the slip:
//!
//! ```text
//! 0 <= F_n ⟂ g      =  F_n/k_n - a_n + n·u_c                          >= 0
//! 0 <= β_j ⟂ λ - d_j·s,   s = a_t - t·u_c - K_t⁻¹ F_t,  F_t = Σ β_j d_j  >= 0
//! 0 <= λ   ⟂ μ F_n - Σ β_j                                            >= 0
//! q free:   Σ G_i F_i + W = 0
//! ```
//!
//! The force form is about twice as large as the kinematic form. Its matrix is copositive: Lemke's method finds a solution whenever no motion q with
//! n·u_c >= 0 at all contacts has W·q > 0.
//!
//! Rows that a contact does not need are left out ([`OmissionReason`]). [`Form`] gives the meaning of each row ([`Row`]) and its units.

mod force_form;
mod kinematic;
mod questions;
mod rows;
mod ruled_out;

pub use rows::{Form, OmissionReason, OmittedPairs, Row};

pub(crate) use force_form::{force_form, force_states};
pub(crate) use kinematic::{UnitDisplacements, kinematic_form, kinematic_form_among, kinematic_states};
pub(crate) use ruled_out::clearly_breaks;
