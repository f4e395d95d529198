//! Arches of stones: as bodies, and a check whether a line of thrust lies within all joints.

use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};

/// Friction that never fails.
pub const NEVER_FAILS: f64 = 1e3;

/// A joint between two stones, or between a stone and the ground.
#[derive(Debug, Clone, Copy)]
pub struct Joint {
    /// Middle of the joint, m.
    pub middle: [f64; 2],
    /// Unit normal of the joint, from the left stone to the right stone.
    pub across: [f64; 2],
    /// Half of the length of the joint, m.
    pub half: f64,
}

/// Stones and joints of a symmetric arch, from the left foot.
#[derive(Debug, Clone)]
pub struct Voussoirs {
    /// Joints, one more than stones. The first and the last stone are on the ground.
    pub joints: Vec<Joint>,
    /// Centre of gravity (m) and weight (N) of each stone.
    pub weights: Vec<([f64; 2], f64)>,
}

impl Voussoirs {
    /// The stones as bodies, with contacts at both edges of each joint.
    pub fn bodies(&self, friction: f64) -> Bodies {
        let name = |stone: usize| format!("stone {}", stone + 1);
        let body = |stone: usize| {
            let (at, weight) = self.weights[stone];
            Body::new(name(stone)).load(Wrench::force_at([0.0, -weight], at))
        };
        let points = |k: usize| {
            let Joint { middle: [x, y], across: [a, b], half } = self.joints[k];
            // The normal of the last joint points into its left stone, because the ground is not a body.
            let (on, sign) = if k < self.weights.len() { (k, 1.0) } else { (k - 1, -1.0) };
            [-half, half].map(|off| {
                let point = Contact::new([x - b * off, y + a * off], [sign * a, sign * b]);
                let point = point.series_stiffness(1e8, 1e8).friction(friction).on(name(on));
                if (1..self.weights.len()).contains(&k) { point.against(name(k - 1)) } else { point }
            })
        };
        Bodies::new((0..self.weights.len()).map(body)).contacts((0..=self.weights.len()).flat_map(points))
    }

    /// Whether some line of thrust lies within all joints, at angles that friction holds. If a line exists, so does a symmetric one, with two
    /// unknowns: the thrust and the moment at the feet.
    pub fn stands(&self, friction: f64) -> bool {
        let Self { joints, weights } = self;
        let upwards = 0.5 * weights.iter().map(|(_, weight)| weight).sum::<f64>();
        let vertical = |k: usize| upwards - weights[..k].iter().map(|(_, weight)| weight).sum::<f64>();
        // The interval of horizontal thrusts with which friction holds every joint: `μ N ± S >= 0`, with normal force N and shear force S, is linear
        // in the thrust.
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
        // At a given thrust, the width of the interval of moments at the foot with which the line of thrust lies within all joints.
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
}

/// The least number in [0, `most`] for which `is_so` is true, to 1e-12, if `is_so` changes once, from false to true.
pub fn bisected(most: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    while high - low > 1e-12 {
        let middle = 0.5 * (low + high);
        *(if is_so(middle) { &mut high } else { &mut low }) = middle;
    }
    high
}
