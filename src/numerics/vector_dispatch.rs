//! Loops compiled for the widest vector (SIMD) instructions of the processor.
//!
//! Loops are written so that the compiler vectorises them. With the feature `simd` they are also compiled for wider SIMD registers, and the widest
//! registers that the processor supports are chosen at run time. The operations and their order are the same for every width, and so are all bits of
//! the results.

/// A loop with its operands, to be compiled for several SIMD widths.
pub(crate) trait Loop {
    type Output;
    /// Runs the loop. Implementations must be inlined, so that the loop is compiled for the SIMD width of the calling function.
    fn run(self) -> Self::Output;
}

/// Runs a loop with the widest SIMD instructions of the processor.
#[inline]
pub(crate) fn wide<L: Loop>(work: L) -> L::Output {
    struct Inlined<L>(L);
    impl<L: Loop> OnVectors for Inlined<L> {
        type Output = L::Output;
        #[inline(always)]
        fn on<V: Vectors>(self, _: V) -> L::Output {
            self.0.run()
        }
    }
    on_the_widest(Inlined(work))
}

/// A value that proves that the processor supports certain SIMD instructions. Work that spans several functions passes this token along, so that each
/// function is compiled for these instructions.
pub(crate) trait Vectors: Copy {
    /// Runs the work, compiled for these SIMD instructions. The work must be inlined into this function.
    fn run<R>(self, work: impl FnOnce() -> R) -> R;
}

/// SIMD instructions of the compilation target, without a check at run time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Compiled;

impl Vectors for Compiled {
    #[inline(always)]
    fn run<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
}

/// Work that is generic over the SIMD instructions for which it is compiled.
pub(crate) trait OnVectors {
    type Output;
    fn on<V: Vectors>(self, vectors: V) -> Self::Output;
}

/// Runs the work with the widest SIMD instructions of the processor.
#[inline]
pub(crate) fn on_the_widest<W: OnVectors>(work: W) -> W::Output {
    #[cfg(feature = "simd")]
    return pulp::Arch::new().dispatch(wider::Work(work));
    #[cfg(not(feature = "simd"))]
    work.on(Compiled)
}

#[cfg(feature = "simd")]
mod wider {
    use super::{OnVectors, Vectors};
    use pulp::{Simd, WithSimd};

    pub(super) struct Work<W>(pub(super) W);

    impl<W: OnVectors> WithSimd for Work<W> {
        type Output = W::Output;
        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) -> W::Output {
            self.0.on(Wide(simd))
        }
    }

    #[derive(Clone, Copy)]
    struct Wide<S>(S);

    impl<S: Simd> Vectors for Wide<S> {
        #[inline(always)]
        fn run<R>(self, work: impl FnOnce() -> R) -> R {
            struct Once<F>(F);
            impl<F: FnOnce() -> R, R> WithSimd for Once<F> {
                type Output = R;
                #[inline(always)]
                fn with_simd<S: Simd>(self, _: S) -> R {
                    (self.0)()
                }
            }
            self.0.vectorize(Once(work))
        }
    }
}
