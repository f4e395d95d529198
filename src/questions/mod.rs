//! The questions that a user can ask about a grasp, one folder for each question, and [`ask::Grasp`], which has a method for each of them.

pub mod ask;
pub mod energy;
pub mod hold;
pub mod identify;
pub mod improve;
pub mod need;
pub mod screening;
pub mod shake;
pub mod squeeze;
pub mod statics;
pub mod sweep;
