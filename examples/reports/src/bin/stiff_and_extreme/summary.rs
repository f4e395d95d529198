//! The worst results of the table, with the bounds that they must meet.

use crate::friction::ONE;
use crate::measure::{Answer, Row, States, Table};
use crate::stiffness::{SLIDING, STICKING};

/// Errors below this fraction of the largest force count as zero.
const NONE: f64 = 1e-18;

pub(crate) fn print(table: &Table) {
    let rows = &table.rows;
    let sticking =
        |row: &&Row| row.question.family == STICKING && row.question.value.1 <= 1e14 && !row.slides;
    let sliding = |row: &&Row| {
        let value = row.question.value.1;
        row.slides
            && (row.question.family == SLIDING && value <= 1e12
                || row.question.family == ONE && (1e-8..=1e6).contains(&value))
    };
    let worst = |chosen: &dyn Fn(&&Row) -> bool, what: fn(&Answer) -> Option<f64>| {
        let errors: Vec<f64> =
            rows.iter().filter(chosen).filter_map(|row| row.answer.as_ref().and_then(what)).collect();
        (errors.iter().copied().fold(0.0, f64::max), errors.len())
    };
    let (error, count) = worst(&sticking, |a| a.error);
    println!("worst sticking error, ratios to 1e14:           {error:.1e} of {count} (bar 1e-14)");
    let (error, _) = worst(&sticking, |a| a.component);
    println!("  of a component by itself:                    {error:.1e} (bar 1e-12)");
    let (error, _) = worst(&sticking, |a| a.textbook);
    println!("  of the textbook's normal equations there:    {error:.1e}");
    let (error, count) = worst(&sliding, |a| a.error);
    println!("worst sliding error, μ 1e-8…1e6, ratios to 1e12: {error:.1e} of {count} (bar 1e-13)");
    let (error, count) = worst(&|_| true, |a| a.error);
    println!("worst error of all:                            {error:.1e} of {count}");
    let wrong = rows.iter().filter(|row| row.states == Some(States::Wrong)).count();
    let edge = rows.iter().filter(|row| matches!(row.states, Some(States::Edge(_)))).count();
    let checked = rows.iter().filter(|row| row.states.is_some()).count();
    println!("rows with wrong states or outcome not marked:  {wrong} of {checked} (bar 0); marked: {edge}");
    let undecided = rows.iter().filter(|row| row.outcome.starts_with("undecided")).count();
    println!("rows that stay undecided:                      {undecided} of {}", rows.len());
    let ratio = |a: &Answer| a.error.map(|error| if error <= NONE { 0.0 } else { error / a.estimate });
    let (largest, _) = worst(&|_| true, ratio);
    println!("largest true error over estimate:              {largest:.1} (bar 10)");
}
