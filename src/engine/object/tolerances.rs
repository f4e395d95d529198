//! Tolerances of `object`: a force, work or correction below a tolerance is taken as zero or as rounding. Also limits of numbers of steps.
//!
//! All tolerances are pure numbers: fractions of the forces, work or terms that are compared.

/// The work of a load along a unit motion that no spring opposes is taken as zero up to this fraction of the load's norm. Loads that were computed to
/// balance carry rounding of about 1e-16.
///
/// If smaller, a load that springs balance seems to move the object without resistance. If larger, a load that does move it without resistance is
/// taken as balanced.
pub(super) const NO_WORK: f64 = 1e-13;

/// Contact forces below this fraction of a spring force count as rounding errors. The spring force is the force that the displacements of the
/// contacts could cause in their springs. In a statically determinate grasp without a load, commands move the object, but the exact contact forces
/// are zero. The computed forces result from three projections of the spring force onto forces in balance. Each projection leaves a fraction of about
/// 1e-15, so about 1e-45 of the spring force remains, far below 1e-25. The error of such a force is as large as the force. The errors of forces are
/// therefore divided by at least this fraction of the spring force, not by the forces alone.
///
/// If smaller, rounding errors are taken as forces; if larger, small forces are taken as zero if displacements are large.
pub(crate) const NO_FORCE: f64 = 1e-25;

/// Iterative refinement ends once a correction changes no spring force by more than this fraction of the largest force. If another correction
/// followed, it would be smaller by about the same factor, 1e-8, and thus below the rounding of forces. If the tangent stiffness is factorised as a
/// band matrix, only the first correction is compared with this fraction. A later correction need not be small relative to the one before it, so it
/// must be at most 1e-15 of the largest force.
///
/// If smaller, well-conditioned problems take another correction; if larger, forces miss digits that one more correction would give.
pub(super) const NEARLY_CORRECTED: f64 = 1e-8;

/// Upper limit of the number of refinement steps. If the exact force is zero, no correction is small relative to the force: each step reduces the
/// computed force by a factor of about 1e-16. This limit then ends the refinement.
pub(super) const MOST_CORRECTIONS: usize = 4;

/// Upper limit of the number of steps of the relaxation, an artificial motion from the position in which everything sticks towards an equilibrium
/// (file `relaxing`). As a rule ten to thirty steps are made. With fewer steps, Newton's method may return to an unstable equilibrium that the
/// relaxation has passed.
pub(super) const RELAXING_STEPS: usize = 300;

/// The object has nearly relaxed once its estimated remaining displacement is below this fraction of its displacement from the position at which
/// everything sticks. Newton's method completes the motion. With a fraction twenty times as large, Newton's method finds a different equilibrium in
/// one of 240 random scenes (test `needed_amounts`). With a smaller fraction there are more steps.
pub(super) const NEARLY_RELAXED: f64 = 1e-2;

/// Two steps of the relaxation have nearly the same direction if the cosine of the angle between them is at least this number. The factor by which
/// steps are made longer is then doubled. With a smaller cosine long steps oscillate; with a larger one slow relaxation takes hundreds of steps.
pub(super) const STRAIGHT_ON: f64 = 0.99;

/// Upper limit of the factor by which a step of the relaxation is made longer. With a larger limit a step may pass over an equilibrium; with a
/// smaller one slow relaxation takes longer.
pub(super) const MOST_STEP_FACTOR: f64 = 64.0;
