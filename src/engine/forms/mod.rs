//! The two complementarity problems of a grasp, the meaning of their rows (complementary pairs), and the rows that a contact does not need.
//!
//! The symbols are those of the [crate page](crate#the-problem); K is the diagonal matrix of all series stiffnesses, G = [G_1 G_2 …], and the
//! friction cone a polygon with facet normals h_j and corners d_j ([`PolygonCone`](crate::PolygonCone)).
//!
//! **Kinematic form** ([`Grasp::kinematic_form`](crate::ask::Grasp::kinematic_form)). In the trial state every contact sticks, F⁰ = K (a - Gᵀq⁰) with
//! Σ G_i F⁰_i + W = 0: one d x d solve. The unknowns z are jumps from this state: gaps, and parts σ_j of slips `s = Σ σ_j h_j`. The object gives way
//! to a jump, and P gives the force that the jump then causes, per unit of displacement:
//!
//! ```text
//! F = F⁰ + P B z,   w = L F,   0 <= z ⟂ w = L F⁰ + (L P B) z >= 0
//! rows of L: e_n and μ e_n - h_j;   columns of B: e_n and -h_j;   P = K - K Gᵀ (G K Gᵀ)⁻¹ G K
//! ```
//!
//! It is small, and z = 0 solves it exactly when every contact sticks. Its matrix is not copositive: with strong friction Lemke's method can end on a
//! ray although an equilibrium exists, so a ray does not prove that no equilibrium exists.
//!
//! **Force form** ([`Grasp::force_form`](crate::ask::Grasp::force_form)). Forces are the unknowns, compliances are on the diagonal, the twist may
//! have any sign. The coefficient of corner d_j in the friction force `F_t = Σ β_j d_j` is β_j, and the size of the slip is λ:
//!
//! ```text
//! 0 <= F_n ⟂ g      =  F_n/k_n - a_n + n·u_c                          >= 0
//! 0 <= β_j ⟂ λ - d_j·s,   s = a_t - t·u_c - K_t⁻¹ F_t,  F_t = Σ β_j d_j  >= 0
//! 0 <= λ   ⟂ μ F_n - Σ β_j                                            >= 0
//! q free:   Σ G_i F_i + W = 0
//! ```
//!
//! It is about twice as large as the kinematic form. Its matrix is copositive: Lemke's method finds a solution whenever no motion q with n·u_c >= 0
//! at all contacts has W·q > 0.
//!
//! The forms have no rows that a contact does not need ([`OmissionReason`]). [`Form`] gives the meaning of each row ([`Row`]) and its units.

mod force_form;
mod kinematic;
mod questions;
mod rows;
mod ruled_out;

pub use rows::{Form, OmissionReason, OmittedPairs, Row};

pub(crate) use force_form::{force_form, force_states};
pub(crate) use kinematic::{UnitDisplacements, kinematic_form, kinematic_form_among, kinematic_states};
pub(crate) use ruled_out::clearly_breaks;
