//! Robots from URDF files.

mod followers;
mod kinematics;
mod mistakes;
mod robots;
mod scenes;
mod shapes;
