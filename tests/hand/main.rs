//! Grasps by hands with joints.

mod bad_input;
mod closed_forms;
mod every_question;
mod exact;
mod held_by_force;
mod in_space;
mod many_joints;
mod paths;
mod pressed;
mod sensitivity;
mod small_turns;
mod theory;
mod uncertain_squeeze;
mod weakest;
