//! The compiled kernels of screening: once for the plane and once for space, in this crate.
//!
//! A program that links the library knows the number of axes and of contacts as parameters of types. Functions with such parameters would be compiled
//! again in every such program, for minutes. They are therefore called by pointer.

use core::any::Any;

use super::block::MOST_CONTACTS as MOST;
use super::gradient::GradientOf;
use super::load_cases::LoadCases;
use super::one_grasp::OneGrasp;
use super::part::{Part, screen};
use super::pull::Pull;
use super::question::ScreeningQuestion;
use super::turning_pull::TurningPull;
use super::watch::{Measured, Watched};
use crate::error::Error;
use crate::grasp::Contact;

/// All questions of screening, for `N` contacts in the plane or in space.
pub(super) struct Kernels<const D: usize, const C: usize, const N: usize> {
    pub(super) prepare: fn(&[Contact<C>; N]) -> Result<OneGrasp<D, C, N>, Error>,
    pub(super) pull: Kernel<D, C, N, Pull<C>>,
    pub(super) turning_pull: Kernel<D, C, N, TurningPull<C>>,
    pub(super) load_cases: Kernel<D, C, N, LoadCases<C>>,
    pub(super) gradient: Kernel<D, C, N, GradientOf<C>>,
    pub(super) watch: fn(&OneGrasp<D, C, N>, &Measured<'_, C>) -> Watched,
}

/// One question, for one grasp and for a batch.
pub(super) struct Kernel<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<C>> {
    pub(super) one: fn(&OneGrasp<D, C, N>, &Q, &mut [Q::Answer]),
    pub(super) many: fn(Part<'_, C, Q>),
}

// Each entry is a static of its own, so that a program for a small controller links only those that it uses.
static PLANE_2: Kernels<3, 2, 2> = Kernels::new::<MOST>();
/// Batches of three contacts in the plane have kernels of their own, which are a quarter faster there. All other batches share theirs.
static PLANE_3: Kernels<3, 2, 3> = Kernels::new::<3>();
static PLANE_4: Kernels<3, 2, 4> = Kernels::new::<MOST>();
static PLANE_5: Kernels<3, 2, 5> = Kernels::new::<MOST>();
static SPACE_2: Kernels<6, 3, 2> = Kernels::new::<MOST>();
static SPACE_3: Kernels<6, 3, 3> = Kernels::new::<MOST>();
static SPACE_4: Kernels<6, 3, 4> = Kernels::new::<MOST>();
static SPACE_5: Kernels<6, 3, 5> = Kernels::new::<MOST>();

impl<const D: usize, const C: usize, const N: usize> Kernels<D, C, N> {
    const fn new<const M: usize>() -> Self {
        let prepare = OneGrasp::new;
        let (pull, turning_pull) = (Kernel::new::<M>(), Kernel::new::<M>());
        let (load_cases, gradient) = (Kernel::new::<M>(), Kernel::new::<M>());
        Self { prepare, pull, turning_pull, load_cases, gradient, watch: OneGrasp::watch }
    }

    /// The kernels for this number of axes and contacts.
    #[inline]
    pub(super) fn get() -> &'static Self {
        const {
            assert!(
                (D == 3 && C == 2) || (D == 6 && C == 3),
                "D degrees of freedom and C axes a contact are 3 and 2 in the plane, 6 and 3 in space: \
                 take the names in `grasp_lcp::planar` or `grasp_lcp::spatial`"
            );
        };
        const { assert!(2 <= N && N <= MOST, "screening is for two to five contacts") };
        let kernels: &'static dyn Any = match (C, N) {
            (2, 2) => &PLANE_2,
            (2, 3) => &PLANE_3,
            (2, 4) => &PLANE_4,
            (2, _) => &PLANE_5,
            (_, 2) => &SPACE_2,
            (_, 3) => &SPACE_3,
            (_, 4) => &SPACE_4,
            _ => &SPACE_5,
        };
        kernels.downcast_ref().expect("of that type, as was asserted")
    }
}

impl<const D: usize, const C: usize, const N: usize, Q: ScreeningQuestion<C>> Kernel<D, C, N, Q> {
    const fn new<const M: usize>() -> Self {
        Self { one: OneGrasp::ask, many: screen::<D, C, M, Q> }
    }

    /// The answer to a question with one answer per scene.
    #[inline]
    pub(super) fn ask(&self, grasp: &OneGrasp<D, C, N>, question: &Q) -> Q::Answer {
        let mut answer = [Q::UNKNOWN];
        (self.one)(grasp, question, &mut answer);
        answer[0]
    }
}
