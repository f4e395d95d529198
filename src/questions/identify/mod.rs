//! Friction, the forces that supports carry, squeeze and stiffness ratios of a grasp from observed slips, with their errors.
//!
//! A [`Slip`] is a load, or an angle, at which a slip was observed: first slip, where the first contact slides, or gross slip, where the object is
//! lost. An [`Unknown`] is a number to be found, such as a coefficient of friction. [`Identify`] holds both, and
//! [`Grasp::identify`](crate::ask::Grasp::identify) returns [`Identified`]: every number with its standard error and its confidence interval of 95 %,
//! and the combinations that the slips do not determine.
//!
//! | sought | meaning | unit |
//! |---|---|---|
//! | [`Unknown::friction`] | one coefficient of friction common to some contacts | |
//! | [`Unknown::carried`] | the normal force that a contact carries before the load grows, such as the load of a support | N |
//! | [`Unknown::squeeze`] | factor on the given squeeze of some contacts | |
//! | [`Unknown::stiffness`] | factor on the given tangential stiffness of some contacts; their normal stiffness and other contacts stay as given | |
//!
//! **Method.** All unknowns are positive, so that the search is in their logarithms x. The residual of a slip observed at load factor λ and predicted
//! at λ(x) is `ln λ - ln λ(x)`. Gauss-Newton steps with Levenberg's damping minimise the sum of [Huber's loss](Identify::with_outliers_beyond).
//! Derivatives of first slip are exact, see [`OnsetMargins`](crate::load_path::OnsetMargins). At gross slip the object leaves with a motion m. If m
//! opens no contact, λ is a root of the equations below, with the constant load W₀ and the growing load W. The sum is over the contacts i that press,
//! with friction μᵢ, normal stiffness kᵢ and normal force Nᵢ. Here nᵢ is the wrench of a unit force along the normal of contact i, and the columns of
//! Tᵢ are the wrenches of unit forces along its tangents:
//!
//! ```text
//! W₀ + λ W + Σ (nᵢ − μᵢ Tᵢ vᵢ/|vᵢ|) Nᵢ = 0,   vᵢ = Tᵢᵀ m,   nᵢᵀ m = 0,   dNᵢ = −kᵢ nᵢᵀ dy
//! ```
//!
//! Sticking contacts carry arbitrary tangential forces in addition. The unknowns of these equations are λ, m and y, the displacement that has changed
//! the normal forces. The implicit function theorem gives their derivatives. If these equations do not hold, because the object wedges itself between
//! contacts or kinetic friction is lower than static friction, derivatives are difference quotients of predictions.
//!
//! **Start.** The search starts at the given values of the unknowns. At these values the model may not predict some slip: the object holds any load,
//! or is lost at once. Then all unknown friction is halved or doubled, in at most twelve trials, until all slips are predicted. The same is tried if
//! a predicted load differs from the observed one, but does not depend on friction: the model predicts that a box tips, while in fact it slid. If
//! nothing but the load of a slip presses on the contacts, the component of this load along the normals acts from the start. Only the other
//! components of the load grow. An example is an object that is dragged over a table: it lies on the table first.
//!
//! **Which contact slips first.** Between two jaws the weaker one slips first, so that a slip depends on the friction of one jaw alone. Which jaw
//! this is may depend on the start of the search. Therefore pairs of unknowns of one kind exchange their values at the solution, and the search is
//! repeated if slips then depend on other unknowns. Another assignment of slips to unknowns may fit as well, at 95 %. Then
//! [`Identified::assignments`] has the estimates of each assignment. An unknown on which the assignments disagree has no unique estimate.
//!
//! # Errors
//!
//! The errors are those of the linearised problem at the solution. If the scatter of slips (their relative standard deviation) is not given, it is
//! estimated from the residuals, and confidence intervals use Student's distribution. If the scatter is given, but the residuals exceed it at 95 %,
//! only the ratios of the given standard deviations are used. Their common factor is then estimated, too ([`Identified::misfit`]), and Student's
//! distribution is used as well. The singular values of all derivatives show directions, in the logarithms of the unknowns, along which no predicted
//! slip changes. Such a direction is a [combination](FreeCombination) that the slips do not determine; its unknowns have no error.
//!
//! These errors assume independent slips. Slips in one direction, of one specimen or of one day may share errors. An example is a surface that is
//! rougher one way, or a finger that slides along the object. Their mean is then less certain than their number suggests. For slips with
//! [groups](Slip::in_group) the standard errors are computed from sums of residuals over each group. They are then valid for any error that the slips
//! of a group share. Let each row of X be the derivatives of a predicted load with respect to the unknowns, both in logarithms, divided by a standard
//! deviation. X_g are the rows of group g. Rows `x_k` are the derivatives of known sums (sums of unknowns that are known from other measurements).
//! `ψ` is Huber's psi: residuals divided by standard deviations, clamped where Huber's loss becomes linear. The number c is the mean derivative of ψ
//! with respect to these residuals, and H the derivative of fitted values with respect to observed ones. With a prime for the transpose, the
//! covariance is the sandwich of Liang and Zeger (Biometrika 73, 1986)
//!
//! ```text
//! V = B⁻¹ (Σ_g X_g' A_g ψ_g ψ_g' A_g X_g + Σ_k x_k' x_k) B⁻¹,   B = c Σ_g X_g' X_g + Σ_k x_k' x_k,   A_g = (1 - H_gg)^(-1/2)
//! ```
//!
//! `A_g` is the correction CR2 of Bell and McCaffrey (Survey Methodology 28, 2002): V then has the right mean for independent slips. With few groups
//! the scatter from group to group is poorly known. Intervals are therefore Student's with Satterthwaite's degrees of freedom,
//! [`Estimate::degrees_of_freedom`] (Pustejovsky and Tipton, J. Bus. Econ. Stat. 36, 2018). Groups do not change the estimates. An unknown that one
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
