//! Pointed arches of stones, with round arches as a limit case.

use super::voussoirs::{Joint, NEVER_FAILS, Voussoirs, bisected};

/// Number of panels of Simpson's rule over the thickness of a stone. It matters for stones next to the apex, whose rings end at different angles.
const PANELS: usize = 400;

/// Two arcs of mean radius 1 m that meet at the apex, symmetric, with radial joints and a vertical one at the apex.
#[derive(Debug, Clone, Copy)]
pub struct PointedArch {
    /// Number of stones on each side. They have equal angles, except for the vertical cut at the apex.
    pub stones: usize,
    /// Thickness relative to the mean radius.
    pub thickness: f64,
    /// Distance by which the centre of each arc lies beyond the middle, relative to the mean radius; 0 is a semicircle.
    pub eccentricity: f64,
}

impl PointedArch {
    fn count(&self) -> usize {
        2 * self.stones
    }

    /// Angle of joint k of the left side about the centre of its arc, from the foot, rad.
    fn angle(&self, k: usize) -> f64 {
        self.eccentricity.acos() * k as f64 / self.stones as f64
    }

    fn radii(&self) -> [f64; 2] {
        [1.0 - 0.5 * self.thickness, 1.0 + 0.5 * self.thickness]
    }

    /// Joint k, counted from the left foot.
    fn joint(&self, k: usize) -> Joint {
        let half = 0.5 * self.thickness;
        if k > self.stones {
            let Joint { middle: [x, y], across: [a, b], half } = self.joint(self.count() - k);
            return Joint { middle: [-x, y], across: [a, -b], half };
        }
        if k == self.stones {
            let [low, high] = self.radii().map(|r| (r * r - self.eccentricity * self.eccentricity).sqrt());
            return Joint { middle: [0.0, 0.5 * (low + high)], across: [1.0, 0.0], half: 0.5 * (high - low) };
        }
        let (sin, cos) = self.angle(k).sin_cos();
        Joint { middle: [self.eccentricity - cos, sin], across: [sin, cos], half }
    }

    /// Centre of gravity of a stone (m) and its weight (N), at 1000 N for each square metre.
    fn weight(&self, stone: usize) -> ([f64; 2], f64) {
        if stone >= self.stones {
            let ([x, y], weight) = self.weight(self.count() - 1 - stone);
            return ([-x, y], weight);
        }
        let ([inner, outer], from, e) = (self.radii(), self.angle(stone), self.eccentricity);
        // Simpson's rule over the thickness. A thin ring of the stone ends at the next joint, or at the vertical cut of the apex.
        let ring = |r: f64| {
            let to = if stone + 1 < self.stones { self.angle(stone + 1) } else { (e / r).acos() };
            let across = e * r * (to - from) - r * r * (to.sin() - from.sin());
            [r * (to - from), across, r * r * (from.cos() - to.cos())]
        };
        let width = (outer - inner) / PANELS as f64;
        let mut sums = [0.0; 3];
        for k in 0..=PANELS {
            let share = if k == 0 || k == PANELS { 1.0 } else { [2.0, 4.0][k % 2] } * width / 3.0;
            let at = ring(inner + width * k as f64);
            (0..3).for_each(|i| sums[i] += share * at[i]);
        }
        ([sums[1] / sums[0], sums[2] / sums[0]], 1000.0 * sums[0])
    }

    /// The joints and stones of the arch.
    pub fn voussoirs(&self) -> Voussoirs {
        Voussoirs {
            joints: (0..=self.count()).map(|k| self.joint(k)).collect(),
            weights: (0..self.count()).map(|stone| self.weight(stone)).collect(),
        }
    }

    /// The least thickness at which the arch stands, with friction that never fails.
    pub fn least_thickness(&self) -> f64 {
        bisected(1.0, |thickness| Self { thickness, ..*self }.voussoirs().stands(NEVER_FAILS))
    }

    /// The least friction coefficient with which the arch stands.
    pub fn least_friction(&self) -> f64 {
        bisected(2.0, |friction| self.voussoirs().stands(friction))
    }
}
