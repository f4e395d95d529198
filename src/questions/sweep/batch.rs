//! Screening of batches of grasps of two to five contacts on all cores. Screening computes, for many grasps, the load factor of first slip: the
//! multiple of the growing load at which the first contact ceases to stick.

use crate::prelude::*;
use crate::screening::{Batch, LoadCases, Pull, Screened, ScreenedGradients, ScreenedSqueeze};

/// The load factor at which the first contact ceases to stick, for each grasp of a batch and each of the growing loads: [`Batch::onsets_into`] on all
/// cores. `answers` is overwritten and its storage reused. Afterwards `answers` has the answers for the first grasp in the order of the loads, then
/// the answers for the next grasp, and so on. [`Batch`] has an example.
pub fn onsets_of_batch<const C: usize, const N: usize>(
    batch: &Batch<C, N>,
    pulls: &[Pull<C>],
    answers: &mut Vec<Screened>,
) {
    batch.onsets_on_all_cores(pulls, answers);
}

/// Computes the derivatives of the load factor of first slip with respect to points, normals, commands, stiffnesses, friction and load. At first slip
/// the first contact ceases to stick. They are computed for each grasp of a batch and each of the growing loads: all loads for the first grasp, then
/// all for the next.
///
/// ```
/// use grasp_lcp::spatial::{Batch, Contact, Fingers, Pull, Wrench};
/// use grasp_lcp::sweep::onset_gradients_of_batch;
///
/// // Three fingers on a disc press with 6 N each; the second one is worn.
/// let finger = |x: f64, y: f64, mu: f64| {
///     Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 1e3).friction(mu).pressed_with(6.0)
/// };
/// let (c, s) = (-0.5, 0.75_f64.sqrt());
/// let mut batch = Batch::default();
/// batch.push(&Fingers::new(&[finger(1.0, 0.0, 0.5), finger(c, s, 0.4), finger(c, -s, 0.5)])?);
///
/// // Each bears a third of a load along the axis: the worn one slides at 3 μ N, however far it is from it.
/// let mut gradients = Default::default();
/// onset_gradients_of_batch(&batch, &[Pull::new(&Wrench::ZERO, &Wrench::force([0.0, 0.0, -1.0]))?], &mut gradients);
/// let gradient = gradients.get(0).unwrap();
/// assert_eq!((gradient.contact(), gradient.is_one_sided()), (Some(1), false));
/// assert!((gradient.friction(1) - 18.0).abs() < 1e-12);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
pub fn onset_gradients_of_batch<const C: usize, const N: usize>(
    batch: &Batch<C, N>,
    pulls: &[Pull<C>],
    gradients: &mut ScreenedGradients<C>,
) {
    batch.onset_gradients_on_all_cores(pulls, gradients);
}

/// The least factor on the commands with which all contacts of each grasp of a batch stick under every load of a list, for each of the lists. It is
/// [`Batch::least_squeezes_into`] on all cores. The answers for all lists of the first grasp come first, then those for the next grasp.
pub fn least_squeezes_of_batch<const C: usize, const N: usize>(
    batch: &Batch<C, N>,
    cases: &[LoadCases<C>],
    answers: &mut Vec<ScreenedSqueeze>,
) {
    batch.least_squeezes_on_all_cores(cases, answers);
}
