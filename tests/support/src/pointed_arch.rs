//! Pointed arches of stones, round ones as their limit, and whether a line of thrust keeps within their joints.

use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};

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

/// A joint: its middle, the direction across it from the left to the right, and half of its length.
#[derive(Clone, Copy)]
struct Joint {
    middle: [f64; 2],
    across: [f64; 2],
    half: f64,
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

    /// Its stones, with two points at the edges of each joint.
    pub fn bodies(&self, friction: f64) -> Bodies {
        let name = |stone: usize| format!("stone {}", stone + 1);
        let body = |stone: usize| {
            let (at, weight) = self.weight(stone);
            Body::new(name(stone)).load(Wrench::force_at([0.0, -weight], at))
        };
        let points = |k: usize| {
            let Joint { middle: [x, y], across: [a, b], half } = self.joint(k);
            // The last joint is told from the other side, as the ground has no name.
            let (on, sign) = if k < self.count() { (k, 1.0) } else { (k - 1, -1.0) };
            [-half, half].map(|off| {
                let point = Contact::new([x - b * off, y + a * off], [sign * a, sign * b]);
                let point = point.series_stiffness(1e8, 1e8).friction(friction).on(name(on));
                if (1..self.count()).contains(&k) { point.against(name(k - 1)) } else { point }
            })
        };
        Bodies::new((0..self.count()).map(body)).contacts((0..=self.count()).flat_map(points))
    }

    /// Whether some line of thrust stays within all joints, leaning on none by more than friction does. If any does, a symmetric one does; it has two unknowns, the
    /// thrust and the moment at the feet.
    pub fn stands(&self, friction: f64) -> bool {
        let joints: Vec<_> = (0..=self.count()).map(|k| self.joint(k)).collect();
        let weights: Vec<_> = (0..self.count()).map(|stone| self.weight(stone)).collect();
        let upwards = 0.5 * weights.iter().map(|(_, weight)| weight).sum::<f64>();
        let vertical = |k: usize| upwards - weights[..k].iter().map(|(_, weight)| weight).sum::<f64>();
        // Thrusts with which friction holds every joint: `μ N ± S >= 0`, linear in the thrust.
        let (mut least, mut most) = (0.0_f64, 100.0 * upwards);
        for (k, Joint { across: [a, b], .. }) in joints.iter().enumerate() {
            for sign in [1.0, -1.0] {
                let by_thrust = friction * a - sign * b;
                let rest = vertical(k) * (friction * b + sign * a);
                if by_thrust > 0.0 {
                    least = least.max(-rest / by_thrust);
                } else if by_thrust < 0.0 {
                    most = most.min(-rest / by_thrust);
                } else if rest < 0.0 {
                    return false;
                }
            }
        }
        if least > most {
            return false;
        }
        // Moments at the foot between which the line stays within all joints, at a thrust.
        let [foot_x, foot_y] = joints[0].middle;
        let room = |thrust: f64| {
            let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
            for (k, Joint { middle: [x, y], across: [a, b], half }) in joints.iter().enumerate() {
                let carried = weights[..k].iter().map(|(at, weight)| (at[0] - x) * weight).sum::<f64>();
                let moment = (foot_x - x) * upwards - (foot_y - y) * thrust - carried;
                let reach = half * (thrust * a + vertical(k) * b);
                (low, high) = (low.max(-reach - moment), high.min(reach - moment));
            }
            high - low
        };
        for _ in 0..200 {
            let [one, other] = [least + (most - least) / 3.0, most - (most - least) / 3.0];
            if room(one) < room(other) { least = one } else { most = other }
        }
        room(0.5 * (least + most)) >= 0.0
    }

    /// The least thickness at which such an arch stands with friction that never fails.
    pub fn least_thickness(&self) -> f64 {
        bisected(1.0, |thickness| Self { thickness, ..*self }.stands(1e3))
    }

    /// The least friction with which it stands.
    pub fn least_friction(&self) -> f64 {
        bisected(2.0, |friction| self.stands(friction))
    }
}

/// The least number from 0 on at which something is so, if it stays so from there on.
fn bisected(most: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    while high - low > 1e-12 {
        let middle = 0.5 * (low + high);
        *(if is_so(middle) { &mut high } else { &mut low }) = middle;
    }
    high
}
