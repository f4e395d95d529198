//! Measured pushes of a block that slides on three supports.
//!
//! The pushes in `data/cmu_three_point_pushes.csv` are made from the sensor logs of Zhou, Paolini, Bagnell and Mason, *A convex polynomial
//! force-motion model for planar sliding: identification and application*, ICRA 2016 (arXiv 1602.06056; github.com/robinzhoucmu/Pushing, revision
//! 1ff9b01, Apache-2.0): the mean force and moment of the finger while a triangular block of 1.518 kg slides, and its motion from before to after.

use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
use nalgebra::{Vector2, Vector3};

use crate::Failure;

const DATA: &str = include_str!("../data/cmu_three_point_pushes.csv");
/// What the block slides on.
pub const SURFACES: [&str; 2] = ["hardboard", "plywood"];
/// Names, and supports from the right-angled corner, mm.
pub const LAYOUTS: [(&str, [[f64; 2]; 3]); 4] = [
    ("3pts1", [[30.0, 30.0], [63.333_333_333, 43.333_333_333], [43.333_333_333, 63.333_333_333]]),
    ("3pts2", [[10.0, 10.0], [10.0, 130.0], [130.0, 10.0]]),
    ("3pts3", [[30.0, 30.0], [90.0, 30.0], [30.0, 90.0]]),
    ("3pts4", [[10.0, 10.0], [90.0, 30.0], [10.0, 130.0]]),
];
/// The centre of mass from there, mm: the origin of the grasps.
const CENTRE: [f64; 2] = [50.0, 50.0];
/// Of the block, N.
pub const WEIGHT: f64 = 1.518 * 9.8;
/// Any will do, if all three are alike: what is carried at last does not depend on it.
const STIFFNESS: f64 = 1e6; // N/m
/// No push is so many times too small for a coefficient of one.
const FAR: f64 = 20.0;

/// One measured push.
pub struct Push {
    /// One of [`SURFACES`].
    pub surface: &'static str,
    /// One of [`LAYOUTS`].
    pub layout: usize,
    /// Along the legs (N), and about the centre of mass (N m).
    pub load: Vector3<f64>,
    /// Displacement (m) and turn (rad).
    pub motion: Vector3<f64>,
    /// Standard deviation of the force during the push, over its mean.
    pub scatter: f64,
    /// The coefficient with which the exact limit of three points equals the push, as the file tells it in five digits.
    pub friction: f64,
}

/// What pushes are taken together by that may share errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Together {
    /// The direction of their forces, in sectors of so many degrees.
    Direction(f64),
    /// The side of the triangle that the finger is at, and whether it slides along that one way, sticks, or slides the other way: 3 times the side, and 0, 1 or 2.
    SideAndFinger,
}

/// Inward normals of the sides of the block, degrees.
const SIDES: [f64; 3] = [0.0, 90.0, -135.0];
/// A force so many degrees off the normal is that of a finger that slides: its friction is some 23° to 25°, where forces pile up.
const SLIDES: f64 = 20.0;

impl Together {
    /// The number of a push's group.
    pub fn group(self, push: &Push) -> usize {
        let direction = push.load.y.atan2(push.load.x).to_degrees();
        match self {
            Self::Direction(wide) => {
                // The last sector that begins below it.
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

/// What is told of a push at a coefficient of one.
pub struct Limit {
    /// The part of the measured push at which the block slides.
    pub factor: f64,
    /// The direction of its motion: displacement (m) and turn (rad) of any size.
    pub motion: Vector3<f64>,
}

/// All of them.
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

/// Where the supports are, m from the centre of mass.
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

/// The load at which it slides, and how.
pub fn limit(blocks: &[Grasp], push: &Push) -> Result<Limit, Failure> {
    let weight = Wrench::force([0.0, 0.0, -WEIGHT]);
    let load = Wrench::new([push.load.x, push.load.y, 0.0], [0.0, 0.0, push.load.z]);
    let mut path = blocks[push.layout].follow(&weight, &[Leg::load_by(load * FAR)])?;
    path.by_ref().for_each(drop);
    let end = path.end().ok_or("no end")?;
    let loss = end.loss().ok_or_else(|| end.to_string())?;
    let motion = loss.motion.as_ref().ok_or("lost without a motion")?.object;
    let ([x, y, _], [_, _, turn]) = (motion.translation(), motion.rotation());
    Ok(Limit { factor: loss.fraction * FAR, motion: Vector3::new(x, y, turn) })
}

/// What three supports carry of the weight, whose centre is the origin, N.
pub fn normal_forces(at: &[Vector2<f64>; 3]) -> [f64; 3] {
    let twice = |a: Vector2<f64>, b: Vector2<f64>| a.perp(&b);
    let all = twice(at[1] - at[0], at[2] - at[0]);
    [twice(at[1], at[2]), twice(at[2], at[0]), twice(at[0], at[1])].map(|part| WEIGHT * part / all)
}
