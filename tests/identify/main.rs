//! Identification of unknown data of a grasp from observed slips: values known by hand, their errors, and what the slips leave open.

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
