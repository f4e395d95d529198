//! Estimates of a grasp's friction, squeeze, stiffness ratios and forces on supports from loads at which it was observed to slip, with their errors.
//!
//! An observation, [`Slip`], is a load, or an angle of a turning load, at which slip was observed. It is first slip, at which the first contact
//! ceases to stick, or gross slip, at which the object is lost. A parameter, [`Unknown`], is a number of the grasp that is sought, such as a
//! coefficient of friction. The squeeze is everything by which contacts press at rest without a load. [`Identify`] holds observations and parameters.
//! [`Grasp::identify`](crate::ask::Grasp::identify) returns [`Identified`]: every parameter with its standard error and its confidence interval of 95
//! %, and the combinations of parameters that the observations do not determine.
//!
//! | sought | meaning | unit |
//! |---|---|---|
//! | [`Unknown::friction`] | one coefficient of friction common to some contacts | |
//! | [`Unknown::carried`] | the normal force that a contact carries before the load grows, such as the load of a support | N |
//! | [`Unknown::squeeze`] | factor on the given squeeze of some contacts | |
//! | [`Unknown::stiffness`] | factor on the given tangential stiffness of some contacts; their normal stiffness and other contacts stay as given | |
//!
//! **Method.** All parameters are positive, so that the search is in their logarithms x. For slip observed at load factor λ (multiple of the growing
//! load) and predicted at λ(x), the residual is `ln λ - ln λ(x)`. Gauss-Newton steps with Levenberg's damping minimise the sum of [Huber's
//! loss](Identify::with_outliers_beyond). Exact derivatives of the load factor of first slip come from
//! [`OnsetMargins`](crate::load_path::OnsetMargins). At gross slip the object leaves with a motion m. If m opens no contact, λ is a root of the
//! equations below, with the constant load W₀ and the growing load W. The sum is over the contacts i that press, with friction μᵢ, normal stiffness
//! kᵢ and normal force Nᵢ. Here nᵢ is the wrench of a unit force along the normal of contact i, and the columns of Tᵢ are the wrenches of unit forces
//! along its tangents:
//!
//! ```text
//! W₀ + λ W + Σ (nᵢ − μᵢ Tᵢ vᵢ/|vᵢ|) Nᵢ = 0,   vᵢ = Tᵢᵀ m,   nᵢᵀ m = 0,   dNᵢ = −kᵢ nᵢᵀ dy
//! ```
//!
//! Sticking contacts carry arbitrary tangential forces in addition. The unknowns of these equations are λ, m and y, the displacement that has changed
//! the normal forces. The implicit function theorem gives their derivatives with respect to x. If the object wedges itself between contacts, or
//! kinetic friction is lower than static friction, these equations do not hold. Derivatives are then difference quotients of predictions.
//!
//! **Start.** The search starts at the given values of the parameters. With these values the model may predict no slip for some observation: the
//! object holds any load, or is lost at once. Then all coefficients of friction that are sought are multiplied by a common factor. At most twelve
//! factors are tried until slip is predicted for all observations. The same is tried if a predicted load differs from the observed one, but does not
//! depend on friction. An example is a box of which the model predicts that it tips, while in fact it slid. If nothing but the load of an observation
//! presses on the contacts, the component of this load along the normals acts from the start. Only the other components of the load grow. An example
//! is an object that is dragged over a table: its weight presses it on the table first.
//!
//! **Which contact slips first.** Between two jaws the weaker one slips first, so that the observed load depends on the friction of one jaw alone.
//! Which jaw this is may depend on the start of the search. Therefore pairs of parameters of one kind exchange their values at the solution. If
//! predicted loads then depend on other parameters, the search is repeated. An assignment says on which parameters the predicted load of each
//! observation depends. If several assignments fit equally well at 95 %, [`Identified::assignments`] has the estimates of each. A parameter on which
//! the assignments disagree has no unique estimate.
//!
//! # Errors
//!
//! The errors are those of the linearised problem at the solution. The scatter of an observation is its relative standard deviation. If it is not
//! given, it is estimated from the residuals, and confidence intervals use Student's distribution. If it is given, but the residuals exceed it at 95
//! %, only the ratios of the given standard deviations are used. Their common factor is then estimated, too ([`Identified::misfit`]), and intervals
//! use Student's distribution. The singular value decomposition of all derivatives shows the directions, in the logarithms of the parameters, along
//! which no predicted load changes. Such a direction is a [combination](FreeCombination) that the observations do not determine; its parameters have
//! no error.
//!
//! These errors assume independent observations. Observations in one direction, of one specimen or of one day may share errors. An example is a
//! surface that is rougher one way, or a finger that slides along the object. The mean of such observations is less certain than their number
//! suggests. For observations with [groups](Slip::in_group) the standard errors are computed from sums of residuals over each group. They are then
//! valid for any error that the observations of a group share. The rows of the matrix X are the derivatives of predicted loads with respect to the
//! parameters, both in logarithms, each row divided by a standard deviation. X_g are the rows of group g. A known sum is a sum of parameters that is
//! known from another measurement; rows `x_k` are the derivatives of known sums. `ψ` is Huber's psi: residuals divided by standard deviations,
//! clamped where Huber's loss becomes linear. The number c is the mean derivative of ψ with respect to these residuals, and H the derivative of
//! fitted values with respect to observed ones. With a prime for the transpose, the covariance is the sandwich of Liang and Zeger (Biometrika 73,
//! 1986)
//!
//! ```text
//! V = B⁻¹ (Σ_g X_g' A_g ψ_g ψ_g' A_g X_g + Σ_k x_k' x_k) B⁻¹,   B = c Σ_g X_g' X_g + Σ_k x_k' x_k,   A_g = (1 - H_gg)^(-1/2)
//! ```
//!
//! `A_g` is the correction CR2 of Bell and McCaffrey (Survey Methodology 28, 2002): V then has the right mean for independent observations. With few
//! groups the scatter from group to group is poorly known. Intervals are therefore Student's with Satterthwaite's degrees of freedom,
//! [`Estimate::degrees_of_freedom`] (Pustejovsky and Tipton, J. Bus. Econ. Stat. 36, 2018). Groups do not change the estimates. A parameter that one
//! group determines alone has no error.

mod answer;
mod assignments;
mod checked;
mod combination;
mod face;
mod first;
mod fit;
mod gross;
mod grouped;
mod leaving;
mod model;
mod pressing;
mod question;
mod robust;
mod slip;
mod spread;
mod tolerances;
mod unknown;
mod words;

pub use answer::{Estimate, FitEnding, Identified};
pub use combination::FreeCombination;
pub use question::Identify;
#[cfg(feature = "serde")]
pub(crate) use question::LAYOUTS_OF_HANDS;
pub use slip::{Slip, SlipKind};
pub use unknown::{Unknown, UnknownKind};
