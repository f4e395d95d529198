//! A quadratic program of minimum potential energy under friction constraints, compared with the complementarity problem of Coulomb's law of
//! friction.
//!
//! While no contact slides the springs are conservative, and the equilibrium is a minimum of the potential energy. The paper on which the crate is
//! based ("Position Control for Multifingered Robot Hand", notes in `paper-notes.md`) poses this minimum as a quadratic program with the friction
//! cones as constraints. [`Energy::minimum`](crate::ask::Energy::minimum) solves it as the linear complementarity problem of its optimality
//! conditions, set up with orthogonal factors of K^{1/2}Gᵀ (stiffness K, grasp map G).
//!
//! As long as no friction constraint binds, the minimum is the equilibrium. Once a constraint binds, its multiplier acts on the object like an
//! external force. The quadratic program still has a minimum, but the object is not in equilibrium at this minimum. [`Comparison`] classifies one
//! load, [`Agreement`] gives the load factor up to which the minimum is an equilibrium.
//!
//! Coulomb's law and the quadratic program differ in one factor. Let x = K^{-1/2} F be the contact forces F in energy coordinates, with the stiffness
//! K. Let x⁰ be these forces if everything sticks. Let Π be the orthogonal projector onto the range of K^{1/2}Gᵀ, i.e. onto the changes of x that
//! motions of the object cause. Each row of N x >= 0 is the condition of one facet of a friction cone, and S consists of the tangential components of
//! these rows. The unknowns z are slips in Coulomb's law, but multipliers in the quadratic program:
//!
//! ```text
//! Coulomb             x = x⁰ + (1 - Π) Sᵀz       0 <= z ⟂ N x >= 0      surfaces slip
//! minimum energy      x = x⁰ +    Π    Nᵀz                              the object is held from outside
//! ```
//!
//! | file | idea |
//! |---|---|
//! | `energy_rows` | gaps and friction cones in energy coordinates |
//! | `optimality` | the optimality conditions in energy coordinates, and their solution |
//! | `minimum`, `agreement` | the minimum under a load, and the load factors of a ramp up to which the minimum is an equilibrium |
//! | `comparison`, `words` | minimum and equilibrium side by side, and the first line of a comparison |

mod agreement;
mod comparison;
mod energy_rows;
mod face;
mod minimum;
mod optimality;
mod words;

pub use agreement::Agreement;
pub use comparison::{Comparison, ComparisonVerdict, Difference};
pub use minimum::{Binding, MinimumContact, MinimumEnergy, MinimumOutcome};
