//! Pointed arches of stones, round ones as their limit.

use super::voussoirs::{Joint, NEVER_FAILS, Voussoirs, bisected};

/// Panels of a sum over the thickness of the stones beside the apex.
const PANELS: usize = 400;

/// Two arcs of mean radius 1 m that meet at the apex, symmetric, with radial joints and a vertical one at the apex.
#[derive(Debug, Clone, Copy)]
pub struct PointedArch {
    /// Stones of each side, of equal angle but for the cut at the apex.
    pub stones: usize,
    /// Thickness over the mean radius.
    pub thickness: f64,
    /// How far beyond the middle the centre of each arc lies, over the mean radius: 0 is a semicircle.
    pub eccentricity: f64,
}

impl PointedArch {
    fn count(&self) -> usize {
        2 * self.stones
    }

    /// The angle of a joint of the left side at its own centre, from the foot on.
    fn angle(&self, k: usize) -> f64 {
        self.eccentricity.acos() * k as f64 / self.stones as f64
    }

    fn radii(&self) -> [f64; 2] {
        [1.0 - 0.5 * self.thickness, 1.0 + 0.5 * self.thickness]
    }

    /// A joint, counted from the left foot.
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

    /// Where a stone's weight acts, and how heavy it is: 1000 N for each square metre.
    fn weight(&self, stone: usize) -> ([f64; 2], f64) {
        if stone >= self.stones {
            let ([x, y], weight) = self.weight(self.count() - 1 - stone);
            return ([-x, y], weight);
        }
        let ([inner, outer], from, e) = (self.radii(), self.angle(stone), self.eccentricity);
        // Over the thickness by Simpson's rule: every ring ends at the next joint, or at the middle.
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

    /// Its joints and stones.
    pub fn voussoirs(&self) -> Voussoirs {
        Voussoirs {
            joints: (0..=self.count()).map(|k| self.joint(k)).collect(),
            weights: (0..self.count()).map(|stone| self.weight(stone)).collect(),
        }
    }

    /// The least thickness at which such an arch stands with friction that never fails.
    pub fn least_thickness(&self) -> f64 {
        bisected(1.0, |thickness| Self { thickness, ..*self }.voussoirs().stands(NEVER_FAILS))
    }

    /// The least friction with which it stands.
    pub fn least_friction(&self) -> f64 {
        bisected(2.0, |friction| self.voussoirs().stands(friction))
    }
}
