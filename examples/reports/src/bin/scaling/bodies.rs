//! Run time of a verdict for each body, in rows of books and walls of bricks.

use grasp_lcp::planar::{Bodies, Wrench};
use support::piles::{books, wall};

use support::best_time::best;

use crate::report::{Beside, row};
use crate::{Outcome, up_to};

/// Prints the run time of a verdict per book or brick. In a row of books it is constant, for any length. In a wall of n bricks the band matrix is
/// as wide as a row of √n bricks, so that its factorisation takes O(n) per brick.
pub fn rows(most: usize) -> Outcome {
    let book = |count: usize| (count, books(count), Wrench::force([0.0, -5.0]));
    grown("book of a row, one pulled: hold, for each book", up_to(most, [10, 100, 1000]).map(book))?;
    let brick =
        |rows: usize| (rows * rows, wall(rows), Wrench::force_at([5.0, 0.0], [0.5, 0.5 * rows as f64 - 0.1]));
    grown(
        "brick of a wall, pushed at the top: hold, for each brick",
        [5, 10, 20, 32].into_iter().filter(|rows| rows * rows <= most).map(brick),
    )
}

/// Prints a row for each size of a growing family, with the ratio to the previous size.
fn grown(work: &str, family: impl IntoIterator<Item = (usize, Bodies, Wrench)>) -> Outcome {
    let mut before: Option<(usize, f64)> = None;
    for (count, bodies, load) in family {
        let grasp = bodies.grasp()?;
        let mut holds = None;
        let time = best(|| holds = grasp.hold(load).ok().and_then(|verdict| verdict.holds())) / count as f64;
        let grows = before.map_or_else(String::new, |(fewer, less)| {
            let (more, longer) = (count as f64 / fewer as f64, time / less);
            format!(", {more:.1} times as many: each takes {longer:.1} times as long")
        });
        let says = match holds {
            Some(true) => "holds",
            Some(false) => "does not hold",
            None => "undecided",
        };
        row(&format!("{count}: {work}"), time, Beside::NOTHING, &format!("{says}{grows}"));
        before = Some((count, time));
    }
    Ok(())
}
