//! Comparison of computed numbers with expected numbers.

/// Asserts equality within `1e-12 (1 + |b|)`: relative for large numbers and absolute for small numbers.
#[macro_export]
macro_rules! assert_close {
    ($a:expr, $b:expr) => {
        let (a, b): (f64, f64) = ($a, $b);
        assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{} = {a}, expected {b}", stringify!($a));
    };
}

/// Whether a equals the expected b within `1e-12 |b|`, however small b is.
pub fn relatively_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

/// Asserts that a equals the expected b within `1e-12 |b|`, however small b is.
#[macro_export]
macro_rules! assert_relatively_close {
    ($a:expr, $b:expr) => {
        let (a, b) = ($a, $b);
        assert!($crate::relatively_close(a, b), "{} = {a}, expected {b}", stringify!($a));
    };
}
