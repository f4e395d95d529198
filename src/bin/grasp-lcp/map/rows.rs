//! The table of a map: a row a direction.

use grasp_lcp::words::Words;

use super::ask::First;
use super::limit::Last;

/// What the columns are.
pub(super) fn head() {
    println!(
        "  {:>9}  {:>12}  {:>12}  {:>15}  {:22} leaves first",
        "direction", "onset (N)", "reserve (N)", "held to (N)", "end of the path"
    );
}

/// One direction; load paths went as far as `most`.
pub(super) fn row(direction: &str, first: &First, reserve: f64, last: &Last, most: f64) {
    let number = |x: f64| Words::default().number(x);
    println!(
        "  {direction:>9}  {:>12}  {:>12}  {:>15}  {:22} {}",
        number(first.factor),
        number(reserve),
        last.words(most),
        last.end.word(),
        first.who
    );
}
