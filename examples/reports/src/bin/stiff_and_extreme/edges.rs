//! Scenes in which the last digits decide: loads close to the onset of sliding, and wedges close to their locking angle.

use nalgebra::SVector;

use crate::Failure;
use crate::measure::{Expected, Question, Table};
use crate::ring::{NORMAL, SQUEEZE, TANGENTIAL, TILTED, held};
use support::scene::{Datum, Scene};

/// Half the angle of the wedge, rad.
const HALF_ANGLE: f64 = 0.3;
/// Relative distance from a locking angle or limit load below which the rounding of the scene's own numbers decides.
const DATA: f64 = 1e-12;

pub(crate) fn rows(table: &mut Table) -> Result<(), Failure> {
    onset(table, "fingers around a body", &held::<3, 2>(4, TILTED))?;
    onset(table, "fingers around a body", &held::<6, 3>(4, TILTED))?;
    for part in parts() {
        paper(table, part)?;
    }
    for part in parts() {
        wedge::<3, 2>(table, part.clone())?;
        wedge::<6, 3>(table, part)?;
    }
    Ok(())
}

/// Relative distances below and above a limit: 1e-3 … 1e-15, and zero.
fn parts() -> impl Iterator<Item = (String, f64)> {
    let exponents = [3, 6, 9, 12, 13, 14, 15];
    let below = exponents.map(|k| (format!("-1e-{k}"), -10_f64.powi(-k)));
    let above = exponents.map(|k| (format!("+1e-{k}"), 10_f64.powi(-k)));
    below.into_iter().chain([("0".to_owned(), 0.0)]).chain(above.into_iter().rev())
}

/// Adds rows with loads around the onset of sliding of a grasp. After the first finger has slipped, the other fingers hold on.
fn onset<const D: usize, const C: usize>(
    table: &mut Table,
    case: &'static str,
    scene: &Scene<D, C>,
) -> Result<(), Failure> {
    let factor = scene.grasp().onset(scene.wrench())?.factor();
    let factor = factor.ok_or("the fingers slide at some load")?;
    for value in parts() {
        let mut scene = scene.clone();
        scene.load *= factor * (1.0 + value.1);
        table.ask(Question { family: "load beside the onset", case, value, expected: None }, &scene)?;
    }
    Ok(())
}

/// Adds a row for the paper's two fingers. Their load at the onset of sliding, W* = √65/66 N, is also their limit load.
fn paper(table: &mut Table, value: (String, f64)) -> Result<(), Failure> {
    let finger = |side: f64| Datum {
        point: SVector::from([4.0 * side, 1.8]),
        normal: SVector::from([-8.0 * side, -1.0]),
        tangent: SVector::zeros(),
        stiffness: SVector::from([5.0, 5.0]),
        friction: 0.25,
        command: SVector::from([0.1, 0.0125 * side]),
        clearance: 0.0,
    };
    let load = SVector::from([0.0, -65_f64.sqrt() / 66.0 * (1.0 + value.1), 0.0]);
    let scene = Scene { contacts: vec![finger(-1.0), finger(1.0)], load };
    let expected = (value.1 > DATA).then_some(Expected::NoEquilibrium);
    let case = "the paper's two fingers, no equilibrium beyond";
    table.ask(Question { family: "load beside the onset", case, value, expected }, &scene)?;
    Ok(())
}

/// Adds a row for a wedge, in space a plug, squeezed by fingers on its flanks. Sticking contacts have `F_t / F_n = tan(half angle)` whatever the
/// stiffness. With more friction the wedge is held; with less it is squeezed out and nothing presses any more.
fn wedge<const D: usize, const C: usize>(table: &mut Table, value: (String, f64)) -> Result<(), Failure> {
    let (sin, cos) = HALF_ANGLE.sin_cos();
    let count = if C == 2 { 2 } else { 3 };
    let contacts = (0..count).map(|i| {
        let (y, x) = (std::f64::consts::TAU * f64::from(i) / f64::from(count)).sin_cos();
        let (mut point, mut normal) = (SVector::zeros(), SVector::zeros());
        (point[0], normal[0]) = (x, -cos * x);
        if C == 3 {
            (point[1], normal[1]) = (y, -cos * y);
        }
        normal[C - 1] = sin;
        let (mut stiffness, mut command) = (SVector::repeat(TANGENTIAL), SVector::zeros());
        (stiffness[0], command[0]) = (NORMAL, SQUEEZE / NORMAL);
        let mut tangent = SVector::zeros();
        tangent[C - 1] = 1.0;
        let friction = HALF_ANGLE.tan() * (1.0 + value.1);
        Datum::<C> { point, normal, tangent, stiffness, friction, command, clearance: 0.0 }
    });
    let scene = Scene { contacts: contacts.collect(), load: SVector::<f64, D>::zeros() };
    let held = if value.1 > 0.0 { Expected::AllStick } else { Expected::NoForce };
    let expected = (value.1.abs() > DATA).then_some(held);
    let case = "friction over the tangent of half the angle, less 1";
    table.ask(Question { family: "wedge beside its locking angle", case, value, expected }, &scene)?;
    Ok(())
}
