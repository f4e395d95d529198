//! A load on the command line.

use clap::Args;

use crate::numbers::{BodyPush, Numbers, kilograms};

/// A load that replaces the loads of the scene's questions.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub(crate) struct LoadArguments {
    /// The force, N: components separated by commas. Without force and moment, the scene's own questions are asked.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) force: Option<Numbers>,
    /// The moment, N m: one number in the plane, three in space.
    #[arg(long, allow_hyphen_values = true, value_name = "M")]
    pub(crate) moment: Option<Numbers>,
    /// The point where force and weight act, m; the origin if left out, or the centre of mass if the bodies share loads by mass.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) at: Option<Numbers>,
    /// With several bodies: a force on one of them that grows with the load, and its point; give one for each body.
    #[arg(long, allow_hyphen_values = true, value_name = "BODY=X,Y[,Z][@X,Y[,Z]]")]
    pub(crate) together_with: Vec<BodyPush>,
    /// A mass, kg, whose weight is added to the load.
    #[arg(long, allow_hyphen_values = true, value_parser = kilograms, value_name = "KG")]
    pub(crate) mass: Option<f64>,
    /// The acceleration of gravity, m/s²; if left out, the gravity of the scene, or 9.81 down along the last axis.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]", requires = "mass")]
    pub(crate) gravity: Option<Numbers>,
    /// The acceleration of the arm, m/s²; the inertial force of the mass is added to the load. Without --mass, the masses of the scene's bodies are
    /// accelerated. For `need`, one number is the magnitude of accelerations to and fro along every axis in turn; the weight acts as well.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]")]
    pub(crate) acceleration: Option<Numbers>,
    /// A point on the axis about which the arm turns, m; the origin if left out.
    #[arg(long, allow_hyphen_values = true, value_name = "X,Y[,Z]", requires = "mass")]
    pub(crate) about: Option<Numbers>,
    /// The angular velocity of the arm, degrees/s: one number in the plane, three along the axis in space.
    #[arg(long, allow_hyphen_values = true, value_name = "W", requires = "mass")]
    pub(crate) angular_velocity: Option<Numbers>,
    /// The angular acceleration of the arm, degrees/s²: as many numbers as for the angular velocity.
    #[arg(long, allow_hyphen_values = true, value_name = "A", requires = "mass")]
    pub(crate) angular_acceleration: Option<Numbers>,
    /// The moment of inertia about the centre of mass, kg m²: one number in the plane; three in space, about axes along the coordinates.
    #[arg(long, allow_hyphen_values = true, value_name = "I", requires = "mass")]
    pub(crate) inertia: Option<Numbers>,
}
