//! Other models of the same pushes: a finger that pushes above the surface, and a surface with different friction along and across.
//!
//! A finger at a height above the surface tips the block forwards, so that supports in front carry more. The second model has an ellipse of friction:
//! the coefficient is `√q μ` along a direction and `μ / √q` across it, with the ratio q of both. Stretching the plane makes friction uniform: places
//! and forces are multiplied by `1 / √q` along and `√q` across, velocities are divided by these, and moments are unchanged.

use std::error::Error;

use grasp_lcp::nalgebra::{Matrix2, Rotation2, Vector2};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use support::measured_pushes::{Push, SURFACES, blocks, pushes, supports};

use crate::supports::{Within, identified};

const STIFFNESS: f64 = 1e6; // N/m
/// Heights of the pusher above the surface, mm.
pub(crate) const HEIGHTS: [f64; 4] = [0.0, 5.0, 10.0, 15.0];

/// The scatter of all layouts of one surface, and the number of support loads within their standard errors.
fn all_layouts(
    surface: &str,
    all: &[Push],
    blocks: &[Grasp],
    load: &dyn Fn(&Push) -> Wrench,
    within: &mut Within,
) -> Result<f64, Box<dyn Error>> {
    let mut squares = 0.0;
    for (layout, block) in blocks.iter().enumerate() {
        let own: Vec<_> = all.iter().filter(|p| p.surface == surface && p.layout == layout).collect();
        let found = identified(block, &own, load, None)?;
        within.count(&found, layout, &found);
        squares += found.scatter.ok_or_else(|| found.to_string())?.powi(2);
    }
    Ok((squares / blocks.len() as f64).sqrt())
}

/// Compares the models on this number of layouts of each surface, with this number of directions of the ellipse over half a turn, and this number of
/// heights of the pusher.
pub(crate) fn compared(turns: u8, layouts: usize, heights: usize) -> Result<(), Box<dyn Error>> {
    let (mut blocks, pushes) = (blocks()?, pushes()?);
    blocks.truncate(layouts);
    println!(
        "\nOther models, pushes each for itself: how much is left, and how many loads are within two standard errors:\n"
    );
    println!("{:<56}{:>12}{:>12}{:>14}", "", "hardboard", "plywood", "within 2 σ");
    for height in HEIGHTS.into_iter().take(heights) {
        let above = |push: &Push| {
            let (x, y, h) = (push.load.x, push.load.y, 1e-3 * height);
            Wrench::new([x, y, 0.0], [-h * y, h * x, push.load.z])
        };
        let mut within = Within::default();
        let left = SURFACES.map(|surface| all_layouts(surface, &pushes, &blocks, &above, &mut within));
        row(&format!("pushed {height:.0} mm above the surface"), left, &within)?;
    }
    let mut within = Within::default();
    let mut told = Vec::new();
    let left = SURFACES.map(|surface| -> Result<f64, Box<dyn Error>> {
        let mut best = (f64::INFINITY, 1.0, 0.0, Within::default());
        for ratio in [1.05_f64, 1.1, 1.15, 1.2] {
            for angle in (0..turns).map(|k| 180.0 * f64::from(k) / f64::from(turns)) {
                let mut own = Within::default();
                let shape = stretched(ratio, angle);
                let blocks = blocks_stretched(&shape, blocks.len())?;
                let load = |push: &Push| {
                    let force = shape * push.load.xy();
                    Wrench::new([force.x, force.y, 0.0], [0.0, 0.0, push.load.z])
                };
                let left = all_layouts(surface, &pushes, &blocks, &load, &mut own)?;
                if left < best.0 {
                    best = (left, ratio, angle, own);
                }
            }
        }
        let (left, ratio, angle, own) = best;
        told.push(format!("{ratio:.2} at {angle:.0}°"));
        (within.all, within.two_errors) = (within.all + own.all, within.two_errors + own.two_errors);
        Ok(left)
    });
    row(&format!("rubs more along than across, {}", told.join(" and ")), left, &within)
}

fn row(name: &str, left: [Result<f64, Box<dyn Error>>; 2], within: &Within) -> Result<(), Box<dyn Error>> {
    let [hardboard, plywood] = left;
    println!(
        "{name:<56}{:>10.2} %{:>10.2} %{:>8} of {:<3}",
        100.0 * hardboard?,
        100.0 * plywood?,
        within.two_errors,
        within.all
    );
    Ok(())
}

/// Matrix that stretches forces and places, for a ratio of friction along a direction to friction across it.
fn stretched(ratio: f64, degrees: f64) -> Matrix2<f64> {
    let turn = Rotation2::new(degrees.to_radians());
    let scale = Matrix2::from_diagonal(&Vector2::new(ratio.sqrt().recip(), ratio.sqrt()));
    turn * scale * turn.inverse()
}

fn blocks_stretched(shape: &Matrix2<f64>, layouts: usize) -> Result<Vec<Grasp>, grasp_lcp::Error> {
    let support = |at: Vector2<f64>| {
        let at = shape * at;
        Contact::new([at.x, at.y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(STIFFNESS, STIFFNESS).friction(1.0)
    };
    (0..layouts).map(|layout| Grasp::new(supports(layout).map(support))).collect()
}
