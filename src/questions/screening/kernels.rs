//! The functions ("kernels") that answer the questions of screening, such as the load factor at which the first contact ceases to stick. They are
//! compiled once for the plane and once for space, in this crate.
//!
//! In a program that links the library the number of axes is a type parameter. If the kernels had this parameter, they would be compiled again in
//! every such program, which takes minutes. They are therefore called by pointer.

use core::any::Any;

use super::batch_part::{BatchPart, screen};
use super::gradient::GradientOf;
use super::load_cases::LoadCases;
use super::one_grasp::OneGrasp;
use super::pull::Pull;
use super::question::ScreeningQuestion;
use super::slip_and_rotation::SlipAndRotation;
use super::watch::{Measured, Watched};
use crate::error::Error;
use crate::grasp::Contact;

/// The functions for all questions of screening, for grasps in the plane or for grasps in space.
pub(super) struct Kernels<const C: usize> {
    pub(super) prepare: fn(&[Contact<C>]) -> Result<OneGrasp<C>, Error>,
    pub(super) pull: Kernel<C, Pull<C>>,
    pub(super) load_cases: Kernel<C, LoadCases<C>>,
    pub(super) gradient: Kernel<C, GradientOf<C>>,
    pub(super) put_on: fn(BatchPart<'_, C, SlipAndRotation<C>>),
    pub(super) watch: fn(&OneGrasp<C>, &Measured<'_, C>) -> Watched,
}

/// The functions that answer one kind of question: for one grasp, and for consecutive grasps of a batch.
pub(super) struct Kernel<const C: usize, Q: ScreeningQuestion<C>> {
    pub(super) one: fn(&OneGrasp<C>, &Q, &mut [Q::Answer]),
    pub(super) many: fn(BatchPart<'_, C, Q>),
}

// Plane and space have a static each, so that a program for a small controller contains only the static that it uses.
static PLANE: Kernels<2> = Kernels::new();
static SPACE: Kernels<3> = Kernels::new();

impl<const C: usize> Kernels<C> {
    const fn new() -> Self {
        let prepare = OneGrasp::new;
        let (pull, load_cases, gradient) = (Kernel::new(), Kernel::new(), Kernel::new());
        Self { prepare, pull, load_cases, gradient, put_on: screen, watch: OneGrasp::watch }
    }

    /// The functions that answer questions of screening for contacts with `C` axes: 2 in the plane, 3 in space.
    #[inline]
    pub(super) fn get() -> &'static Self {
        const { assert!(C == 2 || C == 3, "contacts have 2 axes in the plane and 3 in space") };
        let kernels: &'static dyn Any = if C == 2 { &PLANE } else { &SPACE };
        kernels.downcast_ref().expect("of that type, as was asserted")
    }
}

impl<const C: usize, Q: ScreeningQuestion<C>> Kernel<C, Q> {
    const fn new() -> Self {
        Self { one: OneGrasp::ask, many: screen }
    }

    /// The answer to a question with a single answer per grasp, for one grasp.
    #[inline]
    pub(super) fn ask(&self, grasp: &OneGrasp<C>, question: &Q) -> Q::Answer {
        let mut answer = [Q::UNKNOWN];
        (self.one)(grasp, question, &mut answer);
        answer[0]
    }
}
