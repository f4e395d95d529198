//! Loops compiled for the widest vectors that the processor has.
//!
//! Loops are written so that the compiler turns them into vector instructions. With the feature
//! `simd` they are compiled for wider vectors as well, and the widest that the processor has is
//! chosen at run time. The operations and their order are the same, hence so are all bits.

/// A loop with its operands.
pub(crate) trait Loop {
    type Output;
    /// Must be inlined for the caller's vectors to be used.
    fn run(self) -> Self::Output;
}

/// Runs a loop on the widest vectors there are.
#[cfg(feature = "simd")]
#[inline]
pub(crate) fn wide<L: Loop>(work: L) -> L::Output {
    struct Wide<L>(L);
    impl<L: Loop> pulp::NullaryFnOnce for Wide<L> {
        type Output = L::Output;
        #[inline(always)]
        fn call(self) -> L::Output {
            self.0.run()
        }
    }
    pulp::Arch::new().dispatch(Wide(work))
}

/// Runs a loop as it was compiled.
#[cfg(not(feature = "simd"))]
#[inline]
pub(crate) fn wide<L: Loop>(work: L) -> L::Output {
    work.run()
}
