//! The paper's principle of minimum potential energy, beside complementarity.
//!
//! While nothing slides the springs are conservative and the object goes where the energy is least. The paper poses that as a
//! quadratic program with the friction cones as constraints ([`PrintedQp`], [`ReducedQp`]; solved as the linear complementarity
//! problem of its optimality conditions, [`QuadraticProgram`], and on orthogonal factors,
//! [`Grasp::minimum_energy`](crate::grasp::Grasp::minimum_energy)). As long as no friction constraint binds, its minimum is the equilibrium. Once one
//! binds, its multiplier acts on the object like a hand from outside: the program still returns numbers, but they are not in
//! equilibrium. [`Comparison`] says which case a load is, [`Agreement`] up to which load factor all is well,
//! [`ThreeLaws`] puts Coulomb's law, the program and the associated law of many simulators in one table.
//!
//! With everything stuck in x⁰ = K^{1/2} F⁰, Π the projector on the motions of the object, N the rows of the cones and S those of the slips
//! alone, all in the coordinates x = K^{-1/2} F, the three laws differ in one factor:
//!
//! ```text
//! Coulomb             x = x⁰ + (1 - Π) Sᵀz       0 <= z ⟂ N x >= 0      surfaces slip
//! associated          x = x⁰ + (1 - Π) Nᵀz                              surfaces slip and stand apart while they press
//! minimum energy      x = x⁰ +    Π    Nᵀz                              the object is held from outside
//! ```
//!
//! [`Stability`] and [`SecondOrder`] are about what first order leaves out: the second-order term of the paper's equation 4.1.

mod agreement;
mod associated;
mod comparison;
mod conditions;
mod cone_rows;
mod minimum;
mod printed;
mod program;
mod reduced;
mod second_order;
mod springs;
mod stability;
mod three_laws;

pub use agreement::Agreement;
pub use associated::{AssociatedContact, AssociatedOutcome, AssociatedState};
pub use comparison::{Comparison, Difference, Verdict};
pub use minimum::{Binding, MinimumContact, MinimumEnergy, MinimumOutcome};
pub use printed::{Displacements, Equality, Inequality, PrintedQp};
pub use program::{QpMinimum, QpOutcome, QuadraticProgram};
pub use reduced::{ReducedQp, ReducedRow, Unknowns};
pub use second_order::{SecondOrder, SecondOrderOutcome};
pub use stability::{Stability, StabilityVerdict};
pub use three_laws::ThreeLaws;
