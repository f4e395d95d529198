//! Many grasps of as many contacts each, laid out so that several are screened at once.

use super::block::{Block, Parted};
use super::fingers::Fingers;
use super::load_cases::LoadCases;
use super::method::Method;
use super::prepared::Prepared;
use super::pull::Pull;
use super::question::{Scenes, ScreeningQuestion};
use super::screened::{Screened, ScreenedTurn};
use super::screened_squeeze::ScreenedSqueeze;
use super::turning_pull::TurningPull;
use crate::numerics::{Loop, wide};

/// Scenes side by side.
pub(super) const LANES: usize = if cfg!(feature = "simd") { 8 } else { 4 };

/// Many grasps of `N` contacts each, two to five, to be screened under common loads. `D` and `C`
/// are 3 and 2 in the plane, 6 and 3 in space.
///
/// Numbers of eight grasps lie side by side, so that one instruction works on several of them. A
/// grasp gets the same answer, to the last bit, as from [`Fingers::onset`] on its own, whatever the
/// batch, the processor and the number of threads.
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
pub struct Batch<const D: usize, const C: usize, const N: usize> {
    blocks: Vec<Block<C, N, LANES>>,
    parted: Vec<Parted<N, LANES>>,
    len: usize,
}

impl<const D: usize, const C: usize, const N: usize> Default for Batch<D, C, N> {
    fn default() -> Self {
        Self { blocks: Vec::new(), parted: Vec::new(), len: 0 }
    }
}

impl<const D: usize, const C: usize, const N: usize> Batch<D, C, N> {
    /// An empty batch with room for so many grasps.
    #[must_use]
    pub fn with_capacity(grasps: usize) -> Self {
        let blocks = grasps.div_ceil(LANES);
        Self { blocks: Vec::with_capacity(blocks), parted: Vec::with_capacity(blocks), len: 0 }
    }

    /// Appends a grasp; its answers come in the place of its number.
    pub fn push(&mut self, fingers: &Fingers<D, C, N>) {
        let lane = self.len % LANES;
        if lane == 0 {
            self.blocks.push(Block::EMPTY);
            self.parted.push(Parted::EMPTY);
        }
        // Lanes that stay empty hold the last scene again.
        let lanes = lane..LANES;
        if let (Some(block), Some(parted)) = (self.blocks.last_mut(), self.parted.last_mut()) {
            block.set(&lanes, &fingers.block);
            parted.set(&lanes, &fingers.parted);
        }
        self.len += 1;
    }

    /// The number of grasps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Removes all grasps and keeps the memory.
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.parted.clear();
        self.len = 0;
    }

    /// When the first contact of each grasp stops sticking as each of the loads grows, on one
    /// thread; for all cores there is [`sweep::onsets_of_batch`](crate::sweep::onsets_of_batch).
    /// The answers come grasp by grasp, for each in the order of the loads: what does not depend on
    /// the load is done once. What `answers` held before is lost; then it holds the one of grasp g and pull
    /// p at `g * pulls.len() + p`; with room for all of them nothing is allocated.
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
        self.ask_into(pulls, answers);
    }

    /// At which angle the first contact of each grasp stops sticking while each of the loads turns, on
    /// one thread; for all cores there is [`sweep::turn_onsets_of_batch`](crate::sweep::turn_onsets_of_batch).
    /// Answers come as from [`Self::onsets_into`], each with the bits of [`Fingers::onset_of_turn`].
    pub fn turn_onsets_into(&self, turns: &[TurningPull<C>], answers: &mut Vec<ScreenedTurn>) {
        self.ask_into(turns, answers);
    }

    /// The least factor of the commands with which each grasp holds every load of a list, for each of
    /// the lists, on one thread; for all cores there is
    /// [`sweep::least_squeezes_of_batch`](crate::sweep::least_squeezes_of_batch). Answers come as from
    /// [`Self::onsets_into`], each with the bits of [`Fingers::least_squeeze`].
    pub fn least_squeezes_into(&self, cases: &[LoadCases<C>], answers: &mut Vec<ScreenedSqueeze>) {
        self.ask_into(cases, answers);
    }

    fn ask_into<Q: ScreeningQuestion<D, C>>(&self, questions: &[Q], answers: &mut Vec<Q::Answer>) {
        for part in self.parts(questions, self.blocks.len(), answers) {
            part.screen();
        }
    }

    /// The batch in parts of so many blocks of scenes, each with the places for its answers.
    pub(crate) fn parts<'a, Q: ScreeningQuestion<D, C>>(
        &'a self,
        questions: &'a [Q],
        blocks: usize,
        answers: &'a mut Vec<Q::Answer>,
    ) -> impl Iterator<Item = Part<'a, D, C, N, Q>> {
        // Every place is written below: what an earlier batch left there need not be wiped.
        answers.resize(self.len * questions.len(), Q::UNKNOWN);
        let size = blocks.max(1);
        let places = answers.chunks_mut((size * LANES * questions.len()).max(1));
        let parts = self.blocks.chunks(size).zip(self.parted.chunks(size)).zip(places);
        parts.map(move |((blocks, parted), answers)| Part { blocks, parted, questions, answers })
    }
}

/// A part of a batch.
pub(crate) struct Part<'a, const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<D, C>> {
    blocks: &'a [Block<C, N, LANES>],
    parted: &'a [Parted<N, LANES>],
    questions: &'a [Q],
    answers: &'a mut [Q::Answer],
}

impl<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<D, C>> Part<'_, D, C, N, Q> {
    pub(crate) fn screen(self) {
        wide(self);
    }
}

impl<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<D, C>> Loop
    for Part<'_, D, C, N, Q>
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let blocks = self.blocks.iter().zip(self.parted);
        for ((block, parted), answers) in blocks.zip(self.answers.chunks_mut(LANES * self.questions.len())) {
            // Not a loop: which way it is must be known where it is compiled.
            answer(Method::Edges, (block, parted), self.questions, answers);
            answer(Method::Motions, (block, parted), self.questions, answers);
        }
    }
}

/// Asks the scenes that go this way.
#[inline(always)]
fn answer<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<D, C>>(
    way: Method,
    (block, parted): (&Block<C, N, LANES>, &Parted<N, LANES>),
    questions: &[Q],
    answers: &mut [Q::Answer],
) {
    let these = way.of(block);
    if these == [false; LANES] {
        return;
    }
    let ready = Prepared::new(block, way);
    let squeezed = ready.squeezed(block);
    let scenes = Scenes { block, parted, ready: &ready, squeezed: &squeezed };
    for (k, question) in questions.iter().enumerate() {
        let answered = question.ask(scenes);
        // A last block need not be full.
        let of_grasps = answers.chunks_mut(questions.len()).zip(these);
        for ((of_grasp, this), answer) in of_grasps.zip(answered) {
            if this {
                of_grasp[k] = answer;
            }
        }
    }
}
