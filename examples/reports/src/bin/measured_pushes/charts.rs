//! Charts of predicted against measured forces. The scatter of repeated pushes is the least error that a model could have.

use grasp_lcp::picture::{Chart, Stroke};
use support::measured_pushes::{LAYOUTS, Limit, Push, SURFACES};

use crate::quantile;
use crate::repeats::Repeats;

/// One chart for each surface, with the coefficient of friction from all of its pushes.
pub(crate) fn of_surfaces(pushes: &[Push], limits: &[Limit], floors: &[Repeats; 2]) -> Vec<Chart> {
    let of_surface = |(surface, floor): (&&'static str, &Repeats)| {
        let own = || pushes.iter().zip(limits).filter(move |(push, _)| push.surface == *surface);
        let mu = quantile(own().map(|(_, limit)| 1.0 / limit.factor).collect(), 50);
        let mut chart = Chart::new(
            format!("Pushes on {surface}, μ = {mu:.3}"),
            "measured force (N)",
            "predicted force (N)",
        );
        for (layout, (name, _)) in LAYOUTS.iter().enumerate() {
            let points = own().filter(|(push, _)| push.layout == layout).map(|(push, limit)| {
                let measured = push.load.xy().norm();
                (measured, mu * limit.factor * measured)
            });
            chart = chart.series(*name, points.collect(), Stroke::Circles);
        }
        let most = own().map(|(push, _)| push.load.xy().norm()).fold(0.0, f64::max);
        // Two lines at twice the scatter of repeated pushes, above and below equality of prediction and measurement. Most
        // repeated pushes lie between them.
        let [above, below] = [2.0, -2.0].map(|times| most * (times * floor.scatter).exp());
        let band = vec![(most, above), (0.0, 0.0), (most, below)];
        chart
            .series("as measured", vec![(0.0, 0.0), (most, most)], Stroke::Line)
            .series("scatter of repeated pushes", band, Stroke::Dashed)
            .note(format!(
                "Dashed: twice the scatter of pushes that repeat others, {:.1} %, to either side.",
                100.0 * floor.scatter
            ))
    };
    SURFACES.iter().zip(floors).map(of_surface).collect()
}
