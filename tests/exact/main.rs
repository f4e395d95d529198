//! The equilibrium of one grasp against exact arithmetic, against proofs whose every case is checked, and for numbers of any size.

mod any_numbers;
mod branch_and_bound;
mod exact_equilibria;
mod exact_states;
