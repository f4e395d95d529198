//! The two grasps of "Position Control for Multifingered Robot Hand", and the numbers printed in that paper.

use grasp_lcp::Error;
use grasp_lcp::planar::{Contact, Grasp, Wrench};

use crate::printed_program::PrintedContact;

/// Example 1: a disk held by three fingers at 120°, all springs 100 N/m, μ = 0.25. The paper does not print the commands; 0.1 m
/// along each normal reproduces its forces.
///
/// The printed normals (±0.8666, 0.5) have length 1.0005, and the paper's program did not normalise them. A normal of length s is equivalent to a
/// unit normal with springs s² times as stiff and commands 1/s times as long. With `as_computed` the grasp is the grasp of the paper's program, else
/// the grasp that the paper intends.
pub fn disk(as_computed: bool) -> Result<Grasp, Error> {
    let points = [[-0.8666, -0.5], [0.8666, -0.5], [0.0, 1.0]];
    Grasp::new(points.map(|p| {
        let length = if as_computed { f64::hypot(p[0], p[1]) } else { 1.0 };
        let k = 100.0 * length * length;
        Contact::new(p, [-p[0], -p[1]])
            .body_stiffness(k, k)
            .finger_stiffness(k, k)
            .friction(0.25)
            .command([0.1 / length, 0.0])
    }))
}

/// The contacts of either grasp in the paper's program: body and finger are equally stiff.
pub fn printed_contacts(grasp: &Grasp) -> Vec<PrintedContact<2>> {
    let contact = |contact: &Contact| {
        let k = contact.series_stiffness_of_axes() * 2.0;
        PrintedContact::of(k, k)
    };
    grasp.contacts().iter().map(contact).collect()
}

/// The load of example 1.
pub fn disk_load() -> Wrench {
    Wrench::new([0.1, 0.2], 0.3)
}

/// A force printed in the paper, with the correct value for a misprint.
pub struct Printed {
    /// The printed force.
    pub force: [f64; 2],
    /// For a misprint: its description and the correct force.
    pub misprint: Option<(&'static str, [f64; 2])>,
}

const fn printed(x: f64, y: f64) -> Printed {
    Printed { force: [x, y], misprint: None }
}

/// Contact forces, equilibrating forces and interaction forces of example 1, N.
pub const DISK_FORCES: [(&str, [Printed; 3]); 3] = [
    ("contact", [printed(4.2496, 2.5216), printed(-4.4164, 2.3483), printed(0.0666, -5.0651)]),
    (
        "equilibrating",
        [
            Printed { force: [-0.0804, 0.0199], misprint: Some(("x must be -0.0834", [-0.0834, 0.0199])) },
            Printed { force: [-0.0864, -0.1534], misprint: Some(("x must be -0.0834", [-0.0834, -0.1534])) },
            printed(0.0666, -0.0668),
        ],
    ),
    ("interaction", [printed(4.333, 2.5017), printed(-4.333, 2.5017), printed(0.0, -4.9983)]),
];

/// F_t / F_n of example 1.
pub const DISK_RATIOS: [f64; 3] = [-0.0122, -0.0346, -0.0131];

/// Example 2: two fingers, all springs 10, μ = 0.25, fingers commanded by 0.1 along the normal and ∓0.0125 along the
/// tangent. The printed normals have slope 1/5, but the table was made with slope 1/8.
pub fn two_fingers() -> Result<Grasp, Error> {
    let finger = |side: f64, name: &str| {
        Contact::new([4.0 * side, 1.8], [-8.0 * side, -1.0])
            .body_stiffness(10.0, 10.0)
            .finger_stiffness(10.0, 10.0)
            .friction(0.25)
            .command([0.1, 0.0125 * side])
            .name(name)
    };
    Grasp::new([finger(-1.0, "finger 1"), finger(1.0, "finger 2")])
}

/// The load direction of example 2: the printed loads -0.00 … -0.14 act along y.
pub fn down() -> Wrench {
    Wrench::force([0.0, -1.0])
}

/// The printed table of example 2: load W, then normal and tangential force of finger 1 and of finger 2.
pub const TWO_FINGER_TABLE: [[f64; 5]; 15] = [
    [0.00, 0.5000, -0.0625, 0.5000, 0.0625],
    [0.01, 0.4994, -0.0674, 0.4994, 0.0674],
    [0.02, 0.4988, -0.0724, 0.4998, 0.0724],
    [0.03, 0.4981, -0.0774, 0.4981, 0.0774],
    [0.04, 0.4975, -0.0823, 0.4975, 0.0823],
    [0.05, 0.4969, -0.0873, 0.4969, 0.0873],
    [0.06, 0.4963, -0.0923, 0.4963, 0.0923],
    [0.07, 0.4957, -0.0972, 0.4957, 0.0972],
    [0.08, 0.4950, -0.1022, 0.4950, 0.1022],
    [0.09, 0.4944, -0.1071, 0.4944, 0.1071],
    [0.10, 0.4938, -0.1121, 0.4938, 0.1121],
    [0.11, 0.4932, -0.1171, 0.4932, 0.1171],
    [0.12, 0.4926, -0.1220, 0.4926, 0.1220],
    [0.13, 0.4924, -0.1231, 0.4924, 0.1231],
    [0.14, 0.4924, -0.1231, 0.4924, 0.1231],
];

/// Faults in rows of [`TWO_FINGER_TABLE`], by index of the row.
pub const TWO_FINGER_MISPRINTS: [(usize, &str); 3] = [
    (2, "F_2n printed 0.4998, must be 0.4988"),
    (13, "beyond the onset: no equilibrium; the QP stopped at the cone's edge"),
    (14, "beyond the onset: no equilibrium; the QP stopped at the cone's edge"),
];

/// Two fingers as in example 2, with normals inclined downwards by `slope`, and two rests under the object. The rests are soft and
/// frictionless; they carry the load in excess of the fingers.
pub fn two_fingers_on_rests(slope: f64) -> Result<Grasp, Error> {
    let finger = |side: f64, name: &str| {
        Contact::new([4.0 * side, 1.8], [-side, -slope])
            .body_stiffness(10.0, 10.0)
            .finger_stiffness(10.0, 10.0)
            .friction(0.25)
            .command([0.1, 0.0])
            .name(name)
    };
    let rest = |x: f64| Contact::new([x, -1.0], [0.0, 1.0]).series_stiffness(1.0, 1.0);
    Grasp::new([
        finger(-1.0, "finger 1"),
        finger(1.0, "finger 2"),
        rest(-1.0).name("left rest"),
        rest(1.0).name("right rest"),
    ])
}
