//! What slips that were seen tell: numbers that are known by hand, their errors, and what is not fixed.

mod closed_forms;
mod coverage;
mod derivatives;
mod further_assignments;
mod measured_pushes;
mod mistakes;
mod not_fixed;
mod other_starts;
mod scattered;
mod standard_errors;
mod which_slips_first;
