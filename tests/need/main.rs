//! The amount that is needed: closed forms, and verdicts on both sides of the answer.

mod between_margins;
mod both_sides;
mod brute_force;
mod buckling;
mod closed_forms;
mod installed;
mod once_misleading;
mod reasons;
mod repeated;
mod safety;
mod said_in_full;
mod several_loads;
mod windows;
