//! The directions at which a map of the sphere has its values.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Directions covering the sphere: circles of latitude from +z to −z, each divided evenly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SphereGrid {
    pub(super) rings: usize,
    pub(super) around: usize,
}

impl SphereGrid {
    /// A grid of `rings` steps (at least 2) from the pole to the equator and `around` steps (at least 8) along each circle.
    #[must_use]
    pub fn new(rings: usize, around: usize) -> Self {
        Self { rings: rings.max(2), around: around.max(8) }
    }

    /// Unit vectors ring by ring: +z, the rings below it with azimuth growing from x towards y, −z. Their number is 2 + (2 rings − 1) around.
    #[must_use]
    pub fn directions(&self) -> Vec<[f64; 3]> {
        let mut directions = vec![[0.0, 0.0, 1.0]];
        for ring in 1..2 * self.rings {
            let (sin, cos) = self.polar_angle(ring).sin_cos();
            for k in 0..self.around {
                let azimuth = self.azimuth(k);
                directions.push([sin * azimuth.cos(), sin * azimuth.sin(), cos]);
            }
        }
        directions.push([0.0, 0.0, -1.0]);
        directions
    }

    /// Angle between +z and the directions of a ring, rad; ring 0 is the direction +z.
    pub(super) fn polar_angle(&self, ring: usize) -> f64 {
        FRAC_PI_2 * ring as f64 / self.rings as f64
    }

    pub(super) fn azimuth(&self, k: usize) -> f64 {
        TAU * k as f64 / self.around as f64
    }

    pub(super) fn len(&self) -> usize {
        2 + (2 * self.rings - 1) * self.around
    }

    /// Index in [`Self::directions`] of a direction; `ring` counts from +z and `k` along the ring, both from 0.
    pub(super) fn index(&self, ring: usize, k: usize) -> usize {
        match ring {
            0 => 0,
            r if r == 2 * self.rings => self.len() - 1,
            r => 1 + (r - 1) * self.around + k % self.around,
        }
    }
}
