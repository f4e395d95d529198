//! Equilibria of one grasp are compared with exact arithmetic and with proofs whose cases are all checked, for numbers of any size.

mod any_numbers;
mod branch_and_bound;
mod exact_equilibria;
mod exact_states;
