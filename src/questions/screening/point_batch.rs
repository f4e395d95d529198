//! Many grasps with the same number of contact points, up to 64. Screening computes, for each grasp, the load factor of first slip, at which its
//! first contact ceases to stick. A block holds as many grasps as a SIMD vector has numbers (lanes).

use super::batch_part::BatchPart;
use super::block::{AnyGraspData, Block, Layout, MOST_POINTS, WideGraspData};
use super::kernels::Kernels;
use super::lanes::{LANES, Lanes, Packed};
use super::one_grasp::write_all;
use super::pull::Pull;
use super::question::ScreeningQuestion;
use super::screened::Screened;
use super::slip_and_rotation::SlipAndRotation;
use crate::grasp::Contact;
use crate::numerics::Each;
use crate::prelude::*;

/// Many grasps for screening, all with the same number of contact points, two to 64, which is known only at run time.
///
/// The points of a [soft fingertip](crate::grasp::SoftFingertip) are contacts of one finger, which ceases to stick as soon as one of its points does.
/// All grasps have the same number of fingers, with the same number of points each. The answers equal the answers of [`Batch`](super::Batch) bit for
/// bit.
///
/// ```
/// use grasp_lcp::spatial::{Contact, PointBatch, Pull, SoftFingertip, Wrench};
///
/// // A parallel jaw with pads, which two points in space would let turn freely: it holds 2 μ N.
/// let pad = SoftFingertip::ring(0.006, 8)?;
/// let mut batch = PointBatch::with_capacity(16, 1);
/// let mut points = Vec::new();
/// for x in [-0.03, 0.03] {
///     let jaw = Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(2e4, 1e4);
///     points.extend(pad.contacts(&jaw.friction(0.5).pressed_with(10.0))?);
/// }
/// assert!(batch.push(&points));
/// let mut onsets = Vec::new();
/// batch.onsets_into(&[Pull::new(&Wrench::ZERO, &Wrench::force([0.0, 0.0, -1.0]))?], &mut onsets);
/// assert!((onsets[0].factor().unwrap() - 10.0).abs() < 1e-12);
/// assert!(onsets[0].leaving().eq([0, 1]));
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct PointBatch<const C: usize> {
    contacts: usize,
    /// Bit i is set if contact point i is the last point of its finger; this is the same in every grasp.
    ends: u64,
    /// The data of all blocks one after the other: for each block rows of positions, normals, commands and springs, with one entry per contact, in
    /// the order of `numbers` of [`Block`].
    numbers: Vec<Lanes>,
    commands_and_clearances: Vec<Lanes>,
    len: usize,
    /// Storage of the data of one grasp before they are appended to the batch, reused by each [`Self::push`]; `None` before the first of them.
    grasp: Option<Box<WideGraspData<C>>>,
}

impl<const C: usize> PointBatch<C> {
    /// An empty batch for grasps with this many points each, with storage allocated for `grasps` grasps.
    #[must_use]
    pub fn with_capacity(points: usize, grasps: usize) -> Self {
        let blocks = grasps.div_ceil(LANES);
        let sizes = [Layout::<C>::numbers(points), 2 * points];
        let [numbers, commands_and_clearances] = sizes.each(|size| Vec::with_capacity(blocks * size));
        Self { contacts: points, ends: u64::MAX, numbers, commands_and_clearances, len: 0, grasp: None }
    }

    /// The number of grasps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether the batch has no grasps.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Appends a grasp. Its index in the batch is also the index of its answers. Returns `false`, and appends nothing, if contacts are malformed, or
    /// if [`Fingers::new`](super::Fingers::new) refuses such contacts. The same if they do not fit the batch: another number of points, or other
    /// fingers. For such contacts use [`Grasp`](crate::ask::Grasp), which also names the fault.
    pub fn push(&mut self, contacts: &[Contact<C>]) -> bool {
        if contacts.len() != self.contacts || !(2..=MOST_POINTS).contains(&contacts.len()) {
            return false;
        }
        let mut memory = self.grasp.take().unwrap_or_else(|| Box::new(WideGraspData::new(0)));
        let grasp: &mut AnyGraspData<C> = &mut *memory;
        grasp.begin(contacts.len());
        let is_written = write_all(grasp, contacts).is_ok();
        let grasp = grasp.block();
        let fingers = (grasp.ends << (u64::BITS as usize - contacts.len())).count_ones();
        // One floating-point number stores which fingers leave, one bit for each finger, so a grasp may have at most 52 fingers.
        let fits = fingers < f64::MANTISSA_DIGITS && (self.is_empty() || self.ends == grasp.ends);
        if is_written && fits {
            self.push_grasp(&grasp);
        }
        self.grasp = Some(memory);
        is_written && fits
    }

    /// The load factor of first slip of every grasp under each of the growing loads `pulls`, on one thread. The answer of grasp g under the load p is
    /// at `g * pulls.len() + p`.
    pub fn onsets_into(&self, pulls: &[Pull<C>], answers: &mut Vec<Screened>) {
        self.parts(pulls, self.len, answers).for_each(Kernels::get().pull.many);
    }

    /// The load factor of first slip of each grasp under its own growing load, on one thread. `pulls` has one load for each grasp; if their number
    /// differs, the result is empty.
    #[must_use]
    pub fn own_onsets(&self, pulls: Vec<Pull<C>>) -> Vec<Screened> {
        let mut onsets = Vec::with_capacity(pulls.len());
        onsets
            .extend(SlipAndRotation { pulls, turns: false }.answers(self).iter().map(|answer| answer.first));
        onsets
    }

    pub(super) fn clear(&mut self) {
        self.numbers.clear();
        self.commands_and_clearances.clear();
        self.len = 0;
    }

    /// Appends a grasp, given as a block of one lane, which must fit the batch.
    pub(super) fn push_grasp(&mut self, grasp: &Block<'_, C, f64>) {
        let lane = self.len % LANES;
        self.ends = grasp.ends;
        let both = [
            (&mut self.numbers, grasp.numbers),
            (&mut self.commands_and_clearances, grasp.commands_and_clearances),
        ];
        for (numbers, of_scene) in both {
            if lane == 0 {
                numbers.resize(numbers.len() + of_scene.len(), Lanes::all(0.0));
            }
            // Unused lanes of the last block repeat the last grasp.
            let block = numbers.len() - of_scene.len();
            for (number, of_scene) in numbers[block..].iter_mut().zip(of_scene) {
                number.fill(lane, *of_scene);
            }
        }
        self.len += 1;
    }

    /// Divides the batch into parts of at most `blocks` blocks, each with the questions and the storage of its answers.
    pub(super) fn parts<'a, Q: ScreeningQuestion<C>>(
        &'a self,
        questions: &'a [Q],
        blocks: usize,
        answers: &'a mut Vec<Q::Answer>,
    ) -> impl Iterator<Item = BatchPart<'a, C, Q>> {
        // The kernels, the functions that compute the answers of a block, write every answer. Old answers in reused storage thus need not be cleared.
        let of_grasp = questions.len() * Q::answers(self.contacts);
        answers.resize(self.len * of_grasp, Q::UNKNOWN);
        // A batch of grasps without contacts has no blocks. Each length is then set to one, since the length of chunks must not be zero.
        let (blocks, numbers, commands_and_clearances) =
            (blocks.max(1), Layout::<C>::numbers(self.contacts), (2 * self.contacts).max(1));
        let slots = answers.chunks_mut((blocks * LANES * of_grasp).max(1));
        let parts = self
            .numbers
            .chunks(blocks * numbers)
            .zip(self.commands_and_clearances.chunks(blocks * commands_and_clearances));
        parts.zip(slots).enumerate().map(move |(part, ((numbers, commands_and_clearances), answers))| {
            BatchPart {
                contacts: self.contacts,
                ends: self.ends,
                first: part * blocks * LANES,
                numbers,
                commands_and_clearances,
                questions,
                answers,
            }
        })
    }
}
