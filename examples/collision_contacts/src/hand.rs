//! Shapes and poses of a mug and of fingertips around it.

use std::f64::consts::FRAC_PI_2;

use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::shape::{Ball, Capsule, Compound, Cylinder, SharedShape};

/// A fingertip: its name, its shape, and its pose in the frame of the hand.
pub struct Fingertip {
    pub name: &'static str,
    pub shape: SharedShape,
    pub pose: Pose,
}

/// A mug of 40 mm radius and 90 mm height, upright along z, with its centre at the origin. Its handle is on the side of +x. Lengths in m.
pub fn mug() -> Compound {
    let (top, bottom) = (Vector::new(0.065, 0.0, 0.022), Vector::new(0.065, 0.0, -0.022));
    let wall = |end: Vector| Vector::new(0.038, 0.0, end.z);
    let bar = |a, b| (Pose::identity(), SharedShape::new(Capsule::new(a, b, 0.006)));
    Compound::new(vec![
        // The axis of parry's cylinder is y.
        (Pose::rotation(Vector::X * FRAC_PI_2), SharedShape::new(Cylinder::new(0.045, 0.04))),
        bar(top, bottom),
        bar(wall(top), top),
        bar(wall(bottom), bottom),
    ])
}

/// A thumb and three fingers in the frame of the hand, closed around a cylinder of 40 mm radius. Thumb, index and middle finger
/// penetrate it by 2.4, 1.8 and 1.8 mm; the ring finger has a distance of 0.2 mm.
pub fn fingertips() -> [Fingertip; 4] {
    let around = |degrees: f64, distance: f64, z: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Vector::new(distance * cos, distance * sin, z)
    };
    // The last phalanx of a finger is tangential to the mug, with its pad towards the axis of the mug.
    let finger = |name, degrees: f64, distance, z| Fingertip {
        name,
        shape: SharedShape::new(Capsule::new_y(0.01, 0.008)),
        pose: Pose::new(around(degrees, distance, z), Vector::Z * degrees.to_radians()),
    };
    [
        Fingertip {
            name: "thumb",
            shape: SharedShape::new(Ball::new(0.010)),
            pose: Pose::from_translation(around(180.0, 0.0476, 0.004)),
        },
        finger("index", 50.0, 0.0462, 0.008),
        finger("middle", -50.0, 0.0462, 0.008),
        finger("ring", -50.0, 0.0482, -0.010),
    ]
}
