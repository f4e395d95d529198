//! Scenes and pictures: what is read, what is written, what is drawn.

mod bodies;
mod carried;
mod direction_pictures;
mod format;
mod friction_charts;
mod hands;
mod identified;
mod improved;
mod lines;
mod links;
mod load_arrows;
mod messages;
mod names_apart;
mod picture_paper;
mod planar_page;
mod planar_still;
mod rounding_in_pictures;
mod said_in_digits;
mod soft_still;
mod spatial_page;
mod spatial_still;
mod stiffness_left_out;
mod suction;
mod turn_charts;
mod turn_messages;
mod turns;
