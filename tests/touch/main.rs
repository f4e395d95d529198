//! Contacts from surfaces: pads that close on parts.

mod bracket;
mod edges;
mod files;
mod line_contact;
mod mistakes;
mod moved;
mod scenes;
mod shapes;
mod sloped;
mod volume;
