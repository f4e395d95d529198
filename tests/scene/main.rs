//! Reading, writing and drawing of scenes.

mod bodies;
mod carried;
mod compared;
mod direction_pictures;
mod field_paths;
mod first_lines;
mod followed_in_steps;
mod format;
mod friction_charts;
mod golden;
mod hands;
mod identified;
mod improved;
mod left_out;
mod lines;
mod links;
mod load_arrows;
mod messages;
mod names_apart;
mod need_at_rest;
mod own_weight;
mod pads_in_pictures;
mod picture_paper;
mod planar_page;
mod planar_still;
mod questions;
mod rounding_in_pictures;
mod said_in_digits;
mod shared_by_mass;
mod soft_still;
mod spatial_page;
mod spatial_still;
mod stiffness_left_out;
mod stiffness_matters;
mod suction;
mod turn_charts;
mod turn_messages;
mod turns;
mod units;
mod warnings;

/// A name that is too long to be written whole in any table or picture.
const LONG: &str =
    "a finger whose name goes on and on, as if nobody were ever to write it on a sheet of paper";
