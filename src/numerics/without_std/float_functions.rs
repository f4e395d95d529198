//! Floating-point functions with the names of std's, from `libm`, for targets without std.

/// Declares functions of one and of two numbers, and maps each to its name in `libm`.
macro_rules! float_functions {
    ($($one:ident = $one_of_libm:ident),*; $($two:ident = $two_of_libm:ident),*) => {
        /// The floating-point functions that std provides and core lacks.
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

            /// Multiplies squares in the same order as std, so that the bits agree.
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
    sqrt = sqrt, sin = sin, cos = cos, tan = tan, asin = asin, atan = atan, exp = exp, exp2 = exp2, exp_m1 = expm1,
    ln = log, ln_1p = log1p, log2 = log2, log10 = log10, floor = floor, ceil = ceil, round = round;
    hypot = hypot, atan2 = atan2, powf = pow
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest relative difference between std and libm: both have errors below one or two units in the last place.
    const ULPS: f64 = 4.0 * f64::EPSILON;

    /// 1001 evenly spaced numbers of a range.
    fn numbers(low: f64, high: f64) -> impl Iterator<Item = f64> {
        (0..=1000).map(move |k| low + (high - low) * f64::from(k) / 1000.0)
    }

    fn agree(what: &str, low: f64, high: f64, here: fn(f64) -> f64, std: fn(f64) -> f64) {
        for x in numbers(low, high) {
            let (a, b) = (here(x), std(x));
            assert!((a - b).abs() <= ULPS * b.abs().max(f64::MIN_POSITIVE), "{what}({x}): {a} and {b}");
        }
    }

    macro_rules! agree {
        ($($name:ident from $low:literal to $high:literal),* $(,)?) => {
            $(agree(stringify!($name), $low, $high, <f64 as FloatFunctions>::$name, f64::$name);)*
        };
    }

    #[test]
    fn functions_agree_with_those_of_std() {
        agree!(sqrt from 0.0 to 1e9, sin from -7.0 to 7.0, cos from -7.0 to 7.0, tan from -1.5 to 1.5, asin from -1.0 to 1.0);
        agree!(atan from -9.0 to 9.0, exp from -30.0 to 30.0, exp2 from -40.0 to 40.0, exp_m1 from -1.0 to 1.0);
        agree!(ln from 0.001 to 90.0, ln_1p from -0.9 to 9.0, log2 from 0.001 to 90.0, log10 from 0.001 to 90.0);
        agree!(floor from -9.0 to 9.0, ceil from -9.0 to 9.0, round from -9.0 to 9.0);
        for x in numbers(-9.0, 9.0) {
            for y in numbers(-2.0, 3.0).step_by(50) {
                let pairs = [
                    (FloatFunctions::hypot(x, y), x.hypot(y)),
                    (FloatFunctions::atan2(x, y), x.atan2(y)),
                    (FloatFunctions::powf(x.abs(), y), x.abs().powf(y)),
                ];
                assert!(
                    pairs.iter().all(|(a, b)| a == b || (a - b).abs() <= ULPS * b.abs()),
                    "{x}, {y}: {pairs:?}"
                );
            }
        }
    }

    #[test]
    fn sums_and_products_alone_give_the_bits_of_std() {
        for x in numbers(-9.0, 9.0) {
            assert_eq!(FloatFunctions::sin_cos(x), (FloatFunctions::sin(x), FloatFunctions::cos(x)));
            for power in -9..=9 {
                assert_eq!(
                    FloatFunctions::powi(x, power).to_bits(),
                    x.powi(power).to_bits(),
                    "{x} to the {power}"
                );
            }
            for divisor in [0.3, 2.0, -7.0] {
                assert_eq!(FloatFunctions::rem_euclid(x, divisor).to_bits(), x.rem_euclid(divisor).to_bits());
            }
        }
    }
}
