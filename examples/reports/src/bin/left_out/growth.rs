//! The time that omitted rows save, for pads with more and more springs.

use grasp_lcp::picture::{Chart, Stroke};

use crate::rows::measure;
use crate::scene::{Failure, pad};

const SPRINGS: [usize; 6] = [5, 10, 20, 40, 80, 160];

pub fn report() -> Result<(), Failure> {
    let mut chart = Chart::new(
        "One equilibrium of a pad of 5 … 160 springs",
        "rows of the full formulation (three a contact)",
        "run time (s)",
    )
    .log_log();
    for (name, part) in [("everything sticks", 0.01), ("two thirds slide", 1.0)] {
        let (mut full, mut made) = (Vec::new(), Vec::new());
        for springs in SPRINGS {
            let measured = measure(&pad(name, springs, part)?)?;
            let rows = f64::from(u32::try_from(measured.full_rows)?);
            full.push((rows, measured.full_time));
            made.push((rows, measured.time));
        }
        chart = chart.series(format!("{name}: full formulation"), full, Stroke::Dashed).series(
            format!("{name}: Grasp::solve"),
            made,
            Stroke::Line,
        );
    }
    support::save("left_out.svg", &chart.to_svg()?)?;
    Ok(())
}
