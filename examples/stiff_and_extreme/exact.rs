//! Exact arithmetic from the tests: the contact states of an answer solved again with every number taken for what it is.
#![allow(dead_code, reason = "the tests need more of it")]

#[path = "../../tests/common/dyadic.rs"]
pub(crate) mod dyadic;
#[path = "../../tests/common/scene.rs"]
pub(crate) mod scene;
#[path = "../../tests/common/truth.rs"]
pub(crate) mod truth;
