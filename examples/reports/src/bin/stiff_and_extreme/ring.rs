//! Fingers around a body: the base scene of most rows.

use std::f64::consts::TAU;

use nalgebra::SVector;

use support::scene::{Datum, Scene};

/// Default stiffness, N/m, and friction.
pub(crate) const NORMAL: f64 = 1000.0;
pub(crate) const TANGENTIAL: f64 = 800.0;
pub(crate) const FRICTION: f64 = 0.8;
/// Force with which a finger squeezes, N.
pub(crate) const SQUEEZE: f64 = 5.0;
/// Force that pulls a finger along the surface if it is to slide, N.
pub(crate) const PULL: f64 = 20.0;
/// Tilts of the normals, rad. With `LEVEL` fingers press almost towards the centre; with `TILTED` stiff fingers push each other aside.
pub(crate) const LEVEL: f64 = 0.1;
pub(crate) const TILTED: f64 = 0.25;

/// A fixed irregular sequence in [-½, ½).
pub(crate) fn uneven(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9 + 0.37).fract() - 0.5
}

/// Fingers about 1 m from the centre, not quite evenly spaced, normals turned by the tilt to alternate sides and in space up and down.
pub(crate) fn ring<const C: usize>(count: usize, tilt: f64) -> Vec<Datum<C>> {
    let side = |odd: bool| if odd { -1.0 } else { 1.0 };
    (0..count)
        .map(|i| {
            let angle = TAU * (i as f64 + 0.2 * uneven(i)) / count as f64 + 0.3;
            let turned = angle + tilt * side(i % 2 == 1);
            let (mut point, mut normal) = (SVector::zeros(), SVector::zeros());
            (point[0], point[1]) = (angle.cos(), angle.sin());
            (normal[0], normal[1]) = (-turned.cos(), -turned.sin());
            let mut tangent = SVector::zeros();
            tangent[C - 1] = 1.0;
            if C == 3 {
                point[2] = 0.6 * uneven(i + 50);
                normal[2] = tilt * side(i / 2 % 2 == 1);
            }
            let mut stiffness = SVector::repeat(TANGENTIAL);
            stiffness[0] = NORMAL;
            let mut command = SVector::zeros();
            command[0] = SQUEEZE / NORMAL;
            Datum { point, normal, tangent, stiffness, friction: FRICTION, command, clearance: 0.0 }
        })
        .collect()
}

/// Number of tilted fingers whose normals alone resist every motion (form closure).
pub(crate) const fn enough<const C: usize>() -> usize {
    if C == 2 { 4 } else { 8 }
}

/// The ring under a load of about 1 N.
pub(crate) fn held<const D: usize, const C: usize>(count: usize, tilt: f64) -> Scene<D, C> {
    let load = if C == 2 { vec![0.3, -0.9, 0.05] } else { vec![0.2, 0.3, -0.9, 0.02, -0.04, 0.05] };
    Scene { contacts: ring(count, tilt), load: SVector::from_vec(load) }
}

/// A power of ten: its label in the table, and its value.
pub(crate) fn power(exponent: i32) -> (String, f64) {
    let label = if exponent == 0 { "1".to_owned() } else { format!("1e{exponent}") };
    (label, 10_f64.powi(exponent))
}
