//! Charts of errors against the stiffness ratio.

use grasp_lcp::picture::{Chart, Stroke};

use crate::Failure;
use crate::measure::{Answer, Row, Table};
use crate::stiffness::{FEW, SLIDING, STICKING};

/// Height at which errors of exactly zero are drawn.
const ZERO: f64 = 1e-17;

pub(crate) fn save(table: &Table) -> Result<(), Failure> {
    let charts = [("plane", "Four fingers in the plane"), ("space", "Eight fingers in space")].map(
        |(place, title)| {
            let worst = |family, what: fn(&Answer) -> Option<f64>| worst(&table.rows, (place, family), what);
            Chart::new(
                format!("{title}: worst error at each stiffness ratio"),
                "largest stiffness / smallest stiffness (zero errors are drawn at 10⁻¹⁷)",
                "error of a contact force / largest force",
            )
            .log_log()
            .series("textbook (G K Gᵀ)⁻¹, sticking", worst(STICKING, |a| a.textbook), Stroke::Line)
            .series("this crate, sticking", worst(STICKING, |a| a.error), Stroke::Circles)
            .series("its own estimate, sticking", worst(STICKING, |a| Some(a.estimate)), Stroke::Dashed)
            .series("this crate, sliding", worst(SLIDING, |a| a.error), Stroke::Circles)
            .series(
                "its own estimate, sliding",
                worst(SLIDING, |a| Some(a.estimate)),
                Stroke::Dashed,
            )
        },
    );
    support::save("stiff_and_extreme.svg", &Chart::sheet(&charts, 1)?)?;
    Ok(())
}

/// The largest error among all cases, for each ratio.
fn worst(
    rows: &[Row],
    (place, family): (&str, &str),
    what: impl Fn(&Answer) -> Option<f64>,
) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for row in rows
        .iter()
        .filter(|row| row.place == place && row.question.family == family && row.question.case != FEW)
    {
        let Some(error) = row.answer.as_ref().and_then(&what) else { continue };
        let (ratio, error) = (row.question.value.1, error.max(ZERO));
        match points.iter_mut().find(|point| point.0 == ratio) {
            Some(point) => point.1 = point.1.max(error),
            None => points.push((ratio, error)),
        }
    }
    points
}
