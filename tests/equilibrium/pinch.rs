//! Shared by tests: two fingers that pinch along the x axis, and soft tips for them.

use std::f64::consts::PI;

use grasp_lcp::spatial::{Contact, Grasp, Pressure, SoftFingertip, Wrench};

pub(crate) const KN: f64 = 2000.0;
pub(crate) const KT: f64 = 900.0;
pub(crate) const MU: f64 = 0.6;
pub(crate) const R: f64 = 0.007;
/// Squeeze of each finger, N.
pub(crate) const N: f64 = 5.0;

/// A finger at ±30 mm on the x axis that presses with N.
pub(crate) fn finger(side: f64) -> Contact {
    Contact::new([0.03 * side, 0.0, 0.0], [-side, 0.0, 0.0])
        .name(if side < 0.0 { "left" } else { "right" })
        .series_stiffness(KN, KT)
        .friction(MU)
        .command([N / KN, 0.0, 0.0])
}

pub(crate) fn pinch(tip: &SoftFingertip, finger: impl Fn(f64) -> Contact) -> Grasp {
    let [left, right] = [-1.0, 1.0].map(|side| tip.contacts(&finger(side)).unwrap());
    Grasp::new([left, right].concat()).unwrap()
}

/// A moment about the line of the pinch.
pub(crate) fn spin(moment: f64) -> Wrench {
    Wrench::new([0.0; 3], [moment, 0.0, 0.0])
}

/// Tips with ⟨r⟩/R and ⟨r²⟩/R². On a disc these are `∫ ρ² p / ∫ ρ p` and `∫ ρ³ p / ∫ ρ p` over ρ from 0 to 1:
/// 1/3 : 1/2 and 1/4 : 1/2; 2/15 : 1/4 and 1/12 : 1/4; with p = √(1 - ρ²), π/16 : 1/3 and 2/15 : 1/3.
pub(crate) fn tips() -> Vec<(SoftFingertip, f64, f64)> {
    let profiles = [
        (Pressure::Uniform, 2.0 / 3.0, 0.5),
        (Pressure::Parabolic, 8.0 / 15.0, 1.0 / 3.0),
        (Pressure::Hertz, 3.0 * PI / 16.0, 0.4),
    ];
    let rings = [3, 4, 5, 8, 13].map(|points| (SoftFingertip::ring(R, points).unwrap(), 1.0, 1.0));
    let discs = profiles.into_iter().flat_map(|(pressure, mean, square)| {
        [(1, 3), (1, 4), (2, 5), (3, 6)]
            .map(|(annuli, points)| (SoftFingertip::disc(R, annuli, points, pressure).unwrap(), mean, square))
    });
    rings.into_iter().chain(discs).collect()
}
