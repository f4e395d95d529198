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
mod near_singular;
mod p_matrix;
mod parametric;
mod plain_proofs;
mod proof_on_request;
mod published;
mod scaling;
mod settings;
