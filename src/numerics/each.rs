//! Short arrays and vectors made element by element.
//!
//! These functions shorten the compilation: each use of `array::map` makes the compiler generate two hundred lines of code, and each
//! `SVector::from_fn` a hundred.

use nalgebra::SVector;

/// An array of two to five elements that is mapped without a loop.
pub(crate) trait Each<A> {
    type Of<B>;

    /// `f` of each element, in order.
    fn each<B>(self, f: impl FnMut(A) -> B) -> Self::Of<B>;
}

macro_rules! each {
    ($($length:literal: $($element:ident)*;)*) => {$(
        impl<A> Each<A> for [A; $length] {
            type Of<B> = [B; $length];

            #[inline]
            fn each<B>(self, mut f: impl FnMut(A) -> B) -> [B; $length] {
                let [$($element),*] = self;
                [$(f($element)),*]
            }
        }
    )*};
}
each! {
    2: a b;
    3: a b c;
    4: a b c d;
    5: a b c d e;
}

/// The vector with the component `f(axis)` along each axis.
#[inline]
pub(crate) fn by_axis<const C: usize>(mut f: impl FnMut(usize) -> f64) -> SVector<f64, C> {
    let mut all = [0.0; C];
    let mut axis = 0;
    while axis < C {
        all[axis] = f(axis);
        axis += 1;
    }
    all.into()
}
