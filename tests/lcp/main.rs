//! The linear complementarity problem alone, without grasps.

mod adversarial;
mod allocation;
mod common;
mod exact;
mod faint_rows;
mod farkas;
mod fuzz;
mod given;
mod guaranteed;
mod matrix_class;
mod mixed;
mod near_singular;
mod parametric;
mod plain_proofs;
mod proof_on_request;
mod published;
mod scaling;
mod settings;
mod verified;
