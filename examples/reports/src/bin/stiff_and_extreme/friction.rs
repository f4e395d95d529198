//! Friction from zero to infinite, and squeezes much larger and smaller than the load.

use crate::Failure;
use crate::measure::{Question, Table};
use crate::ring::{NORMAL, PULL, TANGENTIAL, TILTED, enough, held, power, uneven};

pub(crate) const ALL: &str = "friction of all contacts";
pub(crate) const ONE: &str = "friction of a contact that is pulled along";
/// Stiffness of the first finger relative to the others, and its name in the table.
const STIFFER: [(f64, &str); 2] =
    [(1.0, "fingers equally stiff"), (1e12, "the first finger 1e12 times as stiff")];

pub(crate) fn rows(table: &mut Table) -> Result<(), Failure> {
    all::<3, 2>(table)?;
    all::<6, 3>(table)?;
    for stiffer in STIFFER {
        one::<3, 2>(table, stiffer)?;
        one::<6, 3>(table, stiffer)?;
    }
    squeeze::<3, 2>(table)?;
    squeeze::<6, 3>(table)
}

/// The coefficients 0, 1e-12 … 1e12 and infinite.
fn frictions() -> impl Iterator<Item = (String, f64)> {
    let none = std::iter::once(("0".to_owned(), 0.0));
    none.chain((-12..=12).step_by(2).map(power)).chain([("infinite".to_owned(), f64::INFINITY)])
}

fn all<const D: usize, const C: usize>(table: &mut Table) -> Result<(), Failure> {
    for value in frictions() {
        let mut scene = held::<D, C>(enough::<C>(), TILTED);
        for datum in &mut scene.contacts {
            datum.friction = value.1;
        }
        table.ask(Question { family: ALL, case: "fingers around a body", value, expected: None }, &scene)?;
    }
    Ok(())
}

/// Adds rows for a grasp of which one finger is pulled along the surface. With much friction this finger presses with a soft
/// spring, so that friction stays below the pull.
fn one<const D: usize, const C: usize>(
    table: &mut Table,
    (stiffer, case): (f64, &'static str),
) -> Result<(), Failure> {
    for value in frictions().filter(|value| value.1.is_finite()) {
        let mut scene = held::<D, C>(enough::<C>(), TILTED);
        scene.contacts[0].stiffness *= stiffer;
        let datum = &mut scene.contacts[1];
        datum.friction = value.1;
        datum.stiffness[0] = NORMAL / value.1.max(1.0);
        datum.command[1] = PULL / TANGENTIAL;
        table.ask(Question { family: ONE, case, value, expected: None }, &scene)?;
    }
    Ok(())
}

fn squeeze<const D: usize, const C: usize>(table: &mut Table) -> Result<(), Failure> {
    for exponent in (-12..=12).step_by(2) {
        let value = power(exponent);
        let mut scene = held::<D, C>(enough::<C>(), TILTED);
        for (i, datum) in scene.contacts.iter_mut().enumerate() {
            // Commands differ slightly from finger to finger.
            datum.command[0] = value.1 * (1.0 + 0.05 * uneven(i)) / NORMAL;
        }
        let load = nalgebra::SVector::<f64, C>::from_column_slice(&scene.wrench().components()[..C]).norm();
        scene.load /= load;
        let case = "commands times stiffness over the load";
        table.ask(Question { family: "squeeze", case, value, expected: None }, &scene)?;
    }
    Ok(())
}
