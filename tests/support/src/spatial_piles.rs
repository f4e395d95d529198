//! Piles of several bodies in space: walls of bricks with four contact points below each half brick.

use grasp_lcp::spatial::{Bodies, Body, Contact};

use super::piles::brick_below;

/// A wall of `rows` rows of `rows` bricks each. A brick has 2 kg and is 1 m by 0.5 m by 0.5 m; every other row is shifted by half a brick along x.
///
/// Loads act on the first brick of the top row. Half bricks that overhang stand on the ground.
pub fn spatial_wall(rows: usize) -> Bodies {
    let name = |row: usize, column: usize| format!("brick {row}.{column}");
    let (mut bodies, mut contacts) = (Vec::new(), Vec::new());
    for (row, column) in (0..rows).flat_map(|row| (0..rows).map(move |column| (row, column))) {
        // Number of the first half brick, counted from the left.
        let (first, height) = (2 * column + row % 2, 0.5 * row as f64);
        bodies.push(Body::new(name(row, column)).mass(2.0, [0.5 * first as f64 + 0.5, 0.0, height + 0.25]));
        for half in [first, first + 1] {
            let corners = [[0.02, -0.24], [0.48, -0.24], [0.02, 0.24], [0.48, 0.24]];
            let points = corners.map(|[x, y]| {
                let point = Contact::new([0.5 * half as f64 + x, y, height], [0.0, 0.0, 1.0]);
                point.series_stiffness(1e6, 8e5).friction(0.6).on(name(row, column))
            });
            contacts.extend(points.map(|point| match brick_below(rows, row, half) {
                Some((row, column)) => point.against(name(row, column)),
                None => point,
            }));
        }
    }
    Bodies::new(bodies).contacts(contacts).gravity([0.0, 0.0, -9.81]).loaded(name(rows - 1, 0))
}
