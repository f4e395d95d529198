//! The complementarity problem by itself.

mod adversarial;
mod allocation;
mod common;
mod exact;
mod farkas;
mod fuzz;
mod given;
mod guaranteed;
mod matrix_class;
mod mixed;
mod near_singular;
mod parametric;
mod published;
mod scaling;
mod settings;
mod verified;
