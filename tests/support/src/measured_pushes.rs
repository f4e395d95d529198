//! Measured pushes of a block that slides on three supports.
//!
//! The pushes in `data/cmu_three_point_pushes.csv` come from the sensor logs of Zhou, Paolini, Bagnell and Mason, *A convex polynomial
//! force-motion model for planar sliding: identification and application*, ICRA 2016 (arXiv 1602.06056; github.com/robinzhoucmu/Pushing, revision
//! 1ff9b01, Apache-2.0). A push has the mean force and moment of the finger while a triangular block of 1.518 kg slides, and the motion of the block.

use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
use nalgebra::{Vector2, Vector3};

use crate::Failure;

const DATA: &str = include_str!("../data/cmu_three_point_pushes.csv");
/// Surfaces on which the block slides.
pub const SURFACES: [&str; 2] = ["hardboard", "plywood"];
/// Name of each layout, and its supports relative to the right-angled corner, mm.
pub const LAYOUTS: [(&str, [[f64; 2]; 3]); 4] = [
    ("3pts1", [[30.0, 30.0], [63.333_333_333, 43.333_333_333], [43.333_333_333, 63.333_333_333]]),
    ("3pts2", [[10.0, 10.0], [10.0, 130.0], [130.0, 10.0]]),
    ("3pts3", [[30.0, 30.0], [90.0, 30.0], [30.0, 90.0]]),
    ("3pts4", [[10.0, 10.0], [90.0, 30.0], [10.0, 130.0]]),
];
/// The centre of mass relative to the right-angled corner, mm. It is the origin of coordinates of the grasps.
const CENTRE: [f64; 2] = [50.0, 50.0];
/// Weight of the block, N.
pub const WEIGHT: f64 = 1.518 * 9.8;
/// Stiffness of each support. Forces at gross slip do not depend on it, as long as all three supports are equal.
const STIFFNESS: f64 = 1e6; // N/m
/// Multiple of a measured push that certainly makes the block slide with a friction coefficient of one.
const FAR: f64 = 20.0;

/// One measured push.
pub struct Push {
    /// Surface, one of [`SURFACES`].
    pub surface: &'static str,
    /// Index in [`LAYOUTS`].
    pub layout: usize,
    /// Force along the legs of the triangle (N), and moment about the centre of mass (N m).
    pub load: Vector3<f64>,
    /// Displacement (m) and rotation (rad).
    pub motion: Vector3<f64>,
    /// Standard deviation of the force during the push, relative to its mean.
    pub scatter: f64,
    /// The friction coefficient with which the exact limit load of three points equals the push; five digits, from the file.
    pub friction: f64,
}

/// Criterion for groups of pushes that may share errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Together {
    /// Direction of the force, in sectors of this width, degrees.
    Direction(f64),
    /// Side of the triangle at which the finger pushes, and motion of the finger along it. The group is 3 times the side, plus 0 (slides one
    /// way), 1 (sticks) or 2 (slides the other way).
    SideAndFinger,
}

/// Inward normals of the sides of the block, degrees.
const SIDES: [f64; 3] = [0.0, 90.0, -135.0];
/// The finger is taken to slide along the block if its force makes more than this angle with the normal, degrees. Its friction angle is some 23° to
/// 25°: many measured forces have such an angle.
const SLIDES: f64 = 20.0;

impl Together {
    /// Number of the group of a push.
    pub fn group(self, push: &Push) -> usize {
        let direction = push.load.y.atan2(push.load.x).to_degrees();
        match self {
            Self::Direction(wide) => {
                // The number of the last sector that begins at or below the direction of the force.
                (0..360).take_while(|k| f64::from(*k) * wide <= direction + 180.0).count()
            }
            Self::SideAndFinger => {
                let off = SIDES.map(|normal| (direction - normal + 540.0) % 360.0 - 180.0);
                let side = (0..3).min_by(|a: &usize, b| off[*a].abs().total_cmp(&off[*b].abs())).unwrap_or(0);
                let finger = [off[side] < -SLIDES, off[side].abs() <= SLIDES, true];
                3 * side + finger.iter().position(|is| *is).unwrap_or(0)
            }
        }
    }
}

/// Gross slip along the direction of a push, with a friction coefficient of one.
pub struct Limit {
    /// Multiple of the measured push at which the block slides.
    pub factor: f64,
    /// Direction of motion of the block: displacement (m) and rotation (rad), of arbitrary size.
    pub motion: Vector3<f64>,
}

/// All measured pushes.
pub fn pushes() -> Result<Vec<Push>, Failure> {
    let push = |line: &str| -> Result<Push, Failure> {
        let fields: Vec<_> = line.split(',').collect();
        let [surface, layout, _, rest @ ..] = &fields[..] else {
            return Err("a line without numbers".into());
        };
        let numbers = rest.iter().map(|text| text.trim().parse::<f64>()).collect::<Result<Vec<_>, _>>()?;
        let [fx, fy, mz, _, _, dx, dy, turn, scatter, friction] = numbers[..] else {
            return Err("a short line".into());
        };
        let surface = SURFACES.iter().find(|name| *name == surface).ok_or("an unknown surface")?;
        let layout = LAYOUTS.iter().position(|(name, _)| name == layout).ok_or("an unknown layout")?;
        let (load, motion) = (Vector3::new(fx, fy, mz), Vector3::new(1e-3 * dx, 1e-3 * dy, turn));
        Ok(Push { surface, layout, load, motion, scatter, friction })
    };
    DATA.lines().skip(1).map(push).collect()
}

/// Positions of the supports relative to the centre of mass, m.
pub fn supports(layout: usize) -> [Vector2<f64>; 3] {
    LAYOUTS[layout].1.map(|at| Vector2::from(at) - Vector2::from(CENTRE)).map(|at| at * 1e-3)
}

/// The block on the supports of each layout, with a coefficient of friction of one.
pub fn blocks() -> Result<Vec<Grasp>, grasp_lcp::Error> {
    let support = |at: Vector2<f64>| {
        Contact::new([at.x, at.y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(STIFFNESS, STIFFNESS).friction(1.0)
    };
    (0..LAYOUTS.len()).map(|layout| Grasp::new(supports(layout).map(support))).collect()
}

/// The multiple of a push at which the block slides, and its motion.
pub fn limit(blocks: &[Grasp], push: &Push) -> Result<Limit, Failure> {
    let weight = Wrench::force([0.0, 0.0, -WEIGHT]);
    let load = Wrench::new([push.load.x, push.load.y, 0.0], [0.0, 0.0, push.load.z]);
    let mut path = blocks[push.layout].follow(weight, &[Leg::load_by(load * FAR)])?;
    path.by_ref().for_each(drop);
    let end = path.end().ok_or("no end")?;
    let loss = end.loss().ok_or_else(|| end.to_string())?;
    let motion = loss.motion.as_ref().ok_or("lost without a motion")?.object;
    let ([x, y, _], [_, _, turn]) = (motion.translation(), motion.rotation());
    Ok(Limit { factor: loss.fraction * FAR, motion: Vector3::new(x, y, turn) })
}

/// Normal forces of three supports under the weight, N. The centre of mass is the origin.
pub fn normal_forces(at: &[Vector2<f64>; 3]) -> [f64; 3] {
    let twice = |a: Vector2<f64>, b: Vector2<f64>| a.perp(&b);
    let all = twice(at[1] - at[0], at[2] - at[0]);
    [twice(at[1], at[2]), twice(at[2], at[0]), twice(at[0], at[1])].map(|part| WEIGHT * part / all)
}
