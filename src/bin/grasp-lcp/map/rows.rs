//! The table of a map: one row for each direction of the force, with the force at first slip and the force at the end of the load path.

use grasp_lcp::words::Words;

use super::ask::FirstSlipForce;
use super::limit::LimitForce;

/// Prints the names of the columns.
pub(super) fn head() {
    println!(
        "  {:>9}  {:>12}  {:>12}  {:>15}  {:22} leaves first",
        "direction", "onset (N)", "reserve (N)", "held to (N)", "end of the path"
    );
}

/// Prints the row of one direction. It has the force at first slip, the force `reserve` that allows for uncertain data, and the force at the end of
/// the load path, N. Load paths were followed up to the force `most`, N.
pub(super) fn row(direction: &str, first: &FirstSlipForce, reserve: f64, last: &LimitForce, most: f64) {
    let number = |x: f64| Words::default().number(x);
    println!(
        "  {direction:>9}  {:>12}  {:>12}  {:>15}  {:22} {}",
        number(first.force),
        number(reserve),
        last.words(most),
        last.end.word(),
        first.contacts
    );
}
