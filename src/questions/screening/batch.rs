//! Many grasps with the same number of contacts, laid out so that several grasps are screened at once. Screening computes, for many grasps, the load
//! factor of first slip, at which the first contact ceases to stick, and similar numbers. A block holds as many grasps as a SIMD vector has numbers
//! (lanes). A command is the displacement that a finger would make if there were no object.

use super::block::AnyGraspData;
use super::fingers::Fingers;
use super::gradient::GradientOf;
use super::kernels::{Kernel, Kernels};
use super::load_cases::LoadCases;
use super::point_batch::PointBatch;
use super::pull::Pull;
use super::question::ScreeningQuestion;
use super::screened::Screened;
use super::screened_gradient::ScreenedGradients;
use super::screened_squeeze::ScreenedSqueeze;
use crate::numerics::each_taken;
use crate::prelude::*;

/// Many grasps of `N` contacts each, N from two to five, to be screened under common loads. `C` is 2 in the plane and 3 in space.
///
/// Numbers of several grasps are stored side by side (eight with the feature `simd`, else four), so that one instruction works on all of them. A
/// grasp gets the same answer as from [`Fingers::onset`], to the last bit, whatever the batch, the processor and the number of threads.
///
/// ```
/// use grasp_lcp::planar::{Batch, Contact, Fingers, Pull, Wrench};
/// use grasp_lcp::sweep::onsets_of_batch;
///
/// let mut batch = Batch::default();
/// for squeeze in [0.01, 0.02, 0.03] {
///     let jaw = |side: f64| {
///         Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([squeeze, 0.0])
///     };
///     batch.push(&Fingers::new(&[jaw(-1.0), jaw(1.0)])?);
/// }
/// let mut onsets = Vec::new();
/// onsets_of_batch(&batch, &[Pull::new(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?], &mut onsets);
/// assert!((onsets[2].factor().unwrap() - 30.0).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Batch<const C: usize, const N: usize>(PointBatch<C>);

impl<const C: usize, const N: usize> Default for Batch<C, N> {
    fn default() -> Self {
        Self::with_capacity(0)
    }
}

impl<const C: usize, const N: usize> Batch<C, N> {
    /// An empty batch with room for `grasps` grasps.
    #[must_use]
    pub fn with_capacity(grasps: usize) -> Self {
        Self(PointBatch::with_capacity(N, grasps))
    }

    /// Appends a grasp. Its index in the batch, and among the answers, is the number of grasps before it.
    pub fn push(&mut self, fingers: &Fingers<C, N>) {
        self.0.push_grasp(&AnyGraspData::block(&fingers.grasp.data));
    }

    /// The number of grasps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether the batch has no grasps.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.len() == 0
    }

    /// Removes all grasps and keeps the allocated storage.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// The load factor of first slip of every grasp under each of the growing loads `pulls`, on one thread;
    /// [`sweep::onsets_of_batch`](crate::sweep::onsets_of_batch) uses all cores. The earlier content of `answers` is replaced: the answer of grasp g
    /// under the load p of `pulls` is at `g * pulls.len() + p`. Work that does not depend on the load is done once per grasp. Nothing is allocated if
    /// `answers` has the capacity for all answers.
    ///
    /// ```
    /// use grasp_lcp::planar::{Batch, Contact, Fingers, Pull, Wrench};
    ///
    /// let mut batch = Batch::with_capacity(2);
    /// for squeeze in [0.01, 0.02] {
    ///     let jaw = |side: f64| {
    ///         Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([squeeze, 0.0])
    ///     };
    ///     batch.push(&Fingers::new(&[jaw(-1.0), jaw(1.0)])?);
    /// }
    /// // Jaws that press with 10 N or 20 N hold as much; a load of 4 N leaves the rest of it, an upward pull 4 N more.
    /// let weight = Wrench::force([0.0, -4.0]);
    /// let pulls = [
    ///     Pull::new(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?,
    ///     Pull::new(&weight, &Wrench::force([0.0, -1.0]))?,
    ///     Pull::new(&weight, &Wrench::force([0.0, 1.0]))?,
    /// ];
    /// let mut onsets = Vec::new();
    /// batch.onsets_into(&pulls, &mut onsets);
    /// for (onset, exact) in onsets.iter().zip([10.0, 6.0, 14.0, 20.0, 16.0, 24.0]) {
    ///     assert!((onset.factor().unwrap() - exact).abs() < 1e-13);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn onsets_into(&self, pulls: &[Pull<C>], answers: &mut Vec<Screened>) {
        self.ask_into(&Kernels::get().pull, pulls, answers);
    }

    /// For each grasp and each of the lists of loads `cases`, the least common factor of all commands with which every contact sticks under each load
    /// of the list. Computed on one thread; [`sweep::least_squeezes_of_batch`](crate::sweep::least_squeezes_of_batch) uses all cores. The answer of
    /// grasp g to list c is at `g * cases.len() + c`, and equals the answer of [`Fingers::least_squeeze`] bit for bit.
    pub fn least_squeezes_into(&self, cases: &[LoadCases<C>], answers: &mut Vec<ScreenedSqueeze>) {
        self.ask_into(&Kernels::get().load_cases, cases, answers);
    }

    /// For each grasp and each growing load, the derivatives of the load factor of first slip, on one thread. They are taken with respect to contact
    /// points, normals, commands, stiffnesses, coefficients of friction and the load.
    /// [`sweep::onset_gradients_of_batch`](crate::sweep::onset_gradients_of_batch) uses all cores and has an example. The gradient of grasp g under
    /// load p has the number `g * pulls.len() + p`, and equals the gradient of [`Fingers::onset_gradients`] bit for bit.
    pub fn onset_gradients_into(&self, pulls: &[Pull<C>], gradients: &mut ScreenedGradients<C>) {
        gradients.contacts = N;
        self.ask_into(&Kernels::get().gradient, &of_the_first(pulls), &mut gradients.numbers);
    }

    fn ask_into<Q: ScreeningQuestion<C>>(
        &self,
        kernel: &Kernel<C, Q>,
        questions: &[Q],
        answers: &mut Vec<Q::Answer>,
    ) {
        self.0.parts(questions, self.len(), answers).for_each(kernel.many);
    }

    pub(crate) fn onsets_on_all_cores(&self, pulls: &[Pull<C>], answers: &mut Vec<Screened>) {
        self.ask_on_all_cores(&Kernels::get().pull, pulls, answers);
    }

    pub(crate) fn onset_gradients_on_all_cores(
        &self,
        pulls: &[Pull<C>],
        gradients: &mut ScreenedGradients<C>,
    ) {
        gradients.contacts = N;
        self.ask_on_all_cores(&Kernels::get().gradient, &of_the_first(pulls), &mut gradients.numbers);
    }

    pub(crate) fn least_squeezes_on_all_cores(
        &self,
        cases: &[LoadCases<C>],
        answers: &mut Vec<ScreenedSqueeze>,
    ) {
        self.ask_on_all_cores(&Kernels::get().load_cases, cases, answers);
    }

    fn ask_on_all_cores<Q: ScreeningQuestion<C>>(
        &self,
        kernel: &Kernel<C, Q>,
        questions: &[Q],
        answers: &mut Vec<Q::Answer>,
    ) {
        // A part of 256 blocks, of 4 or 8 grasps each, is so large that handing it to a thread costs little. It is small enough to share a batch of
        // ten thousand grasps among several cores.
        each_taken(self.0.parts(questions, 256, answers), &kernel.many);
    }
}

fn of_the_first<const C: usize>(pulls: &[Pull<C>]) -> Vec<GradientOf<C>> {
    pulls.iter().map(|&pull| GradientOf { pull, contact: None }).collect()
}
