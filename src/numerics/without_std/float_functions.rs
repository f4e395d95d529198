//! The functions of floating point that belong to std, where there is none: by the same names, from `libm`.

/// Declares functions of one number and of two, and takes them from `libm` by the names that they have there.
macro_rules! float_functions {
    ($($one:ident = $one_of_libm:ident),*; $($two:ident = $two_of_libm:ident),*) => {
        /// What std does with a number, and core does not.
        pub(crate) trait FloatFunctions: Sized {
            $(fn $one(self) -> Self;)*
            $(fn $two(self, other: Self) -> Self;)*
            fn sin_cos(self) -> (Self, Self);
            fn powi(self, exponent: i32) -> Self;
            fn rem_euclid(self, divisor: Self) -> Self;
        }

        impl FloatFunctions for f64 {
            $(fn $one(self) -> Self {
                libm::$one_of_libm(self)
            })*

            $(fn $two(self, other: Self) -> Self {
                libm::$two_of_libm(self, other)
            })*

            fn sin_cos(self) -> (Self, Self) {
                libm::sincos(self)
            }

            /// Squares as std multiplies them, so that the same bits come out.
            fn powi(self, exponent: i32) -> Self {
                let (mut power, mut square, mut left) = (1.0, self, exponent.unsigned_abs());
                loop {
                    if left % 2 == 1 {
                        power *= square;
                    }
                    left /= 2;
                    if left == 0 {
                        return if exponent < 0 { 1.0 / power } else { power };
                    }
                    square *= square;
                }
            }

            fn rem_euclid(self, divisor: Self) -> Self {
                let remainder = self % divisor;
                if remainder < 0.0 { remainder + divisor.abs() } else { remainder }
            }
        }
    };
}

float_functions! {
    sqrt = sqrt, sin = sin, cos = cos, tan = tan, asin = asin, acos = acos, atan = atan, exp = exp, exp2 = exp2, exp_m1 = expm1,
    ln = log, ln_1p = log1p, log2 = log2, log10 = log10, floor = floor, ceil = ceil, round = round;
    hypot = hypot, atan2 = atan2, powf = pow
}
