//! Limits below which a quantity of a contact counts as zero, in all solvers that use the contact law. A margin is what is left of a friction limit;
//! the apex of a cone is zero force.

/// A friction margin `μ F_n - |F_t|` or a gap counts as zero below this fraction of the terms from which it is computed. Forces and gaps from one
/// linear solve have rounding errors of this order. In symmetric grasps the forces of several contacts reach their cones at the same load, and this
/// must count as one event.
pub(crate) const ZERO_SLACK: f64 = 5e-14;

/// A condition counts as satisfied if it is violated by no more than an allowance for rounding, relative to the terms of the condition. The allowance
/// grows with the condition number of the linear system, up to this bound.
///
/// With a smaller bound, true answers of ill-conditioned systems are refused. With a larger bound, violated conditions count as satisfied.
pub(crate) const MOST_SLACK: f64 = 1e-10;

/// A force below this fraction of the terms from which it is computed is zero. The contact is then at the apex of its cone. The limit is looser than
/// [`ZERO_SLACK`], since so close to the apex the facets cannot be distinguished.
pub(crate) const WEIGHTLESS: f64 = 1e-12;

/// A force, N, or displacement, m, that is added to the terms with which quantities are compared. A quantity thus counts as zero before it becomes
/// subnormal and loses its relative precision.
pub(crate) const SMALLEST: f64 = 1e-250;

/// Narrowest sector, rad, of friction directions that a proof on the round cone still divides. The proof splits the states of each contact into ever
/// narrower sectors, until none of them allows an equilibrium. Fingers whose normals deviate from symmetry by 1e-8 may wedge the object; slip
/// directions therefore matter down to this angle. In narrower sectors the contact law is violated only by rounding.
///
/// With a smaller width, the search also divides sectors in which the law is violated only by rounding. With a larger width, grasps that wedge the
/// object remain undecided.
pub(super) const NARROWEST_ARC: f64 = 1e-8;
