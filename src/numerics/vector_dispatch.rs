//! Loops compiled for the widest vector instructions of the processor.
//!
//! Loops are written so that the compiler vectorises them. With the feature `simd` they are also compiled for wider vectors, and the widest that
//! the processor supports are chosen at run time. The operations and their order are the same, hence all bits are, too.

/// A loop with its operands.
pub(crate) trait Loop {
    type Output;
    /// Runs the loop; must be inlined so that it is compiled for the caller's vectors.
    fn run(self) -> Self::Output;
}

/// Runs a loop on the widest vectors of the processor.
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

/// A token for vector instructions that the processor is known to support. Work that spans several functions passes it along, so that each
/// function is compiled for these vectors.
pub(crate) trait Vectors: Copy {
    /// Runs the work, compiled for these vectors; the work must be inlined here.
    fn run<R>(self, work: impl FnOnce() -> R) -> R;
}

/// Vector instructions of the compilation target, without a check at run time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Compiled;

impl Vectors for Compiled {
    #[inline(always)]
    fn run<R>(self, work: impl FnOnce() -> R) -> R {
        work()
    }
}

/// Work that is generic over the vector instructions it is compiled for.
pub(crate) trait OnVectors {
    type Output;
    fn on<V: Vectors>(self, vectors: V) -> Self::Output;
}

/// Runs the work on the widest vectors of the processor.
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
