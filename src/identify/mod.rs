//! What do slips that were seen tell of a grasp? Friction, the loads of supports, squeeze and stiffness ratios, with their errors.
//!
//! A [`Slip`] is a load, or an angle, at which first or gross slip was seen; an [`Unknown`] is a number of the grasp that is sought. [`Identify`] holds
//! both, and [`Identify::answered_by`] a grasp answers with [`Identified`]: every number with its standard error and the interval that holds
//! it with 95 %, and which combinations the slips do not fix.
//!
//! | sought | what it is | unit |
//! |---|---|---|
//! | [`Unknown::friction`] | one coefficient of friction of some contacts | |
//! | [`Unknown::carried`] | the normal force that a contact carries at rest: the load of a support | N |
//! | [`Unknown::squeeze`] | how many times the squeeze given | |
//! | [`Unknown::stiffness`] | how many times the tangential stiffness given, beside the normal one and that of other contacts | |
//!
//! **How.** All of them are positive, so that the search goes in their logarithms x, and so do residuals: a slip at load factor λ that was predicted at
//! λ(x) is off by `ln λ - ln λ(x)`. Gauss and Newton's steps, damped as Levenberg has it, make the sum of
//! [Huber's loss](Identify::with_outliers_beyond) of them least. Derivatives are exact: those of an onset are
//! [known](crate::ask::Sensitivity::onset_gradients). Where the last motion m opens nothing, a loss is a root of equations of its own, over contacts i that
//! press:
//!
//! ```text
//! W₀ + λ W + Σ (nᵢ − μᵢ Tᵢ vᵢ/|vᵢ|) Nᵢ = 0,   vᵢ = Tᵢᵀ m,   nᵢᵀ m = 0,   dNᵢ = −kᵢ nᵢᵀ dy
//! ```
//!
//! where what sticks carries any tangential force. Their unknowns λ, m and y, by which normal springs have changed, have derivatives by the implicit
//! function theorem. Elsewhere, as where the object wedges or friction falls, derivatives are differences of exact answers.
//!
//! **Where it begins.** At the values given. Where some slip is not predicted there – the object holds however far the load goes, or it is lost at once –
//! all friction is halved or doubled, at most twelve times, until all are. Where nothing but a slip's own load presses, the part of it along the normals is
//! there at rest and the rest grows: an object that was dragged over a table lies on it first.
//!
//! # Errors
//!
//! They are those of the linear problem at the solution. Where scatter is not given with the slips it is estimated from what is left, and
//! intervals are Student's. A direction in which no slip changes, by the singular values of all derivatives, is a [combination](FreeCombination) that is not
//! fixed, and no number is told of what takes part in it.
//!
//! All that takes slips for independent. Slips in one direction, of one specimen or of one day share what is wrong there: a surface that rubs better
//! one way, a finger that slides along the object. Their mean is then less sure than their number says. Slips with [groups](Slip::in_group) have errors
//! from what is left group by group, whatever the slips of a group share. The covariance is the sandwich of Liang and Zeger (Biometrika 73, 1986)
//!
//! ```text
//! V = B⁻¹ (Σ_g X_g' A_g ψ_g ψ_g' A_g X_g + Σ_k x_k' x_k) B⁻¹,   B = c Σ_g X_g' X_g + Σ_k x_k' x_k,   A_g = (1 - H_gg)^(-1/2)
//! ```
//!
//! with rows X of derivatives over standard deviations; `ψ`, what is left over them, cut where the loss bends; c, by how much that changes with what is
//! left; rows `x_k` of sums that are known; and H, by how much the solution follows each slip. `A_g` is the correction CR2 of Bell and McCaffrey (Survey
//! Methodology 28, 2002): V is then right in the mean where slips are independent after all. Few groups tell little of their own scatter. Intervals are
//! Student's with Satterthwaite's degrees of freedom of that one number, [`Estimate::degrees_of_freedom`] (Pustejovsky and Tipton, J. Bus. Econ. Stat.
//! 36, 2018). Estimates stay as they are, and what one group tells alone has no error.

mod answer;
mod checked;
mod combination;
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
mod unknown;
mod words;

pub use answer::{Ending, Estimate, Identified};
pub use combination::FreeCombination;
pub use question::Identify;
pub use slip::{Slip, SlipKind};
pub use unknown::{Unknown, UnknownKind};
