//! The paper's principle of minimum potential energy, compared with complementarity.
//!
//! While no contact slides the springs are conservative, and the equilibrium is a minimum of the potential energy. The paper poses this minimum as a
//! quadratic program with the friction cones as constraints. [`Energy::minimum`](crate::ask::Energy::minimum) solves it as the linear complementarity
//! problem of its optimality conditions, on orthogonal factors.
//!
//! As long as no friction constraint binds, the minimum is the equilibrium. Once a constraint binds, its multiplier acts on the object like an
//! external force: the program still returns numbers, but they are not in equilibrium. [`Comparison`] classifies one load, [`Agreement`] gives the
//! load factor up to which the minimum is an equilibrium.
//!
//! Coulomb's law and the program differ in one factor. Let x = K^{-1/2} F be the forces in energy coordinates, x⁰ those if everything sticks, and Π
//! the projector on the motions of the object. N are the rows of the cones, S the rows of the slips alone:
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
//! | `minimum`, `agreement` | the minimum under a load, and the range of a ramp in which it is an equilibrium |
//! | `comparison`, `words` | both side by side, and the first line of a comparison |

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
