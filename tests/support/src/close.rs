//! When a number is the one that was worked out by hand.

/// Equal to 1e-12, relative for large numbers and absolute for small ones.
#[macro_export]
macro_rules! assert_close {
    ($a:expr, $b:expr) => {
        let (a, b): (f64, f64) = ($a, $b);
        assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{} = {a}, expected {b}", stringify!($a));
    };
}

/// Equal to 1e-12 of the expected number, however small.
pub fn relatively_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

/// Equal to 1e-12 of the expected number, however small.
#[macro_export]
macro_rules! assert_relatively_close {
    ($a:expr, $b:expr) => {
        let (a, b) = ($a, $b);
        assert!($crate::relatively_close(a, b), "{} = {a}, expected {b}", stringify!($a));
    };
}
