//! The visible edges of a part (the mesh of an object to be held): lines at which its faces meet at an angle, or end.

use crate::numerics::moved;

use std::collections::HashMap;

use nalgebra::Vector3;

use super::part::Part;

impl Part {
    /// The edges between faces that meet at more than this angle, rad, and the edges that belong to a single face. Each edge is given by its two end
    /// points, m. With 0.5 rad the side faces of a cylinder of 13 or more sides give no edges, so only its end circles remain.
    #[must_use]
    pub fn edges(&self, angle: f64) -> Vec<[[f64; 3]; 2]> {
        let least = angle.cos();
        let mut first_normal: HashMap<[[u64; 3]; 2], (usize, Vector3<f64>, bool)> = HashMap::new();
        for (index, triangle) in self.triangles.iter().enumerate() {
            let [a, b, c] = triangle;
            let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else { continue };
            for side in 0..3 {
                let ends = [bits(&triangle[side]), bits(&triangle[(side + 1) % 3])];
                let key = if ends[0] <= ends[1] { ends } else { [ends[1], ends[0]] };
                let entry = first_normal.entry(key).or_insert((3 * index + side, normal, true));
                if entry.0 != 3 * index + side {
                    entry.2 = entry.1.dot(&normal) < least;
                }
            }
        }
        let mut places: Vec<usize> =
            first_normal.into_values().filter(|(_, _, sharp)| *sharp).map(|(place, ..)| place).collect();
        places.sort_unstable();
        let ends = |place: usize| {
            [place % 3, (place + 1) % 3].map(|corner| self.triangles[place / 3][corner].into())
        };
        moved(places, &ends)
    }
}

/// The bit pattern of a point, as a key; both zeros have the same pattern.
fn bits(point: &Vector3<f64>) -> [u64; 3] {
    std::array::from_fn(|a| (point[a] + 0.0).to_bits())
}
