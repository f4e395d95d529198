//! Several bodies in contact with each other.

mod arches;
mod at_rest;
mod cards;
mod closed_forms;
mod closure;
mod enumerated;
mod everyday;
mod faces;
mod falling;
mod growing;
mod invariance;
mod law;
mod links;
mod loads;
mod malformed;
mod many;
mod pointed_arches;
mod programs;
mod rigid_limit;
mod wedges;
mod weightless_rests;
