//! What a user asks of a grasp, one folder a question, and [`ask::Grasp`], at which all of them are asked.

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
