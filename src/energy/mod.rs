//! The paper's principle of minimum potential energy, beside complementarity.
//!
//! While nothing slides the springs are conservative and the object goes where the energy is least. The paper poses that as a
//! quadratic program with the friction cones as constraints ([`PrintedQp`], [`ReducedQp`]; solved as the linear complementarity
//! problem of its optimality conditions, [`QuadraticProgram`], and on orthogonal factors,
//! [`Grasp::minimum_energy`](crate::grasp::Grasp::minimum_energy)). As long as no friction constraint binds, its minimum is the equilibrium. Once one
//! binds, its multiplier acts on the object like a hand from outside: the program still returns numbers, but they are not in
//! equilibrium. [`Comparison`] says which case a load is, [`Agreement`] up to which load factor all is well.

mod agreement;
mod comparison;
mod conditions;
mod cone_rows;
mod minimum;
mod printed;
mod program;
mod reduced;
mod springs;

pub use agreement::Agreement;
pub use comparison::{Comparison, Difference, Verdict};
pub use minimum::{Binding, MinimumContact, MinimumEnergy, MinimumOutcome};
pub use printed::{Displacements, Equality, Inequality, PrintedQp};
pub use program::{QpMinimum, QpOutcome, QuadraticProgram};
pub use reduced::{ReducedQp, ReducedRow, Unknowns};
