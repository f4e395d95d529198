//! Parameters from observed slips: values known by hand, their errors, and combinations that slips do not determine.

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
