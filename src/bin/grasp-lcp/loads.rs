//! Loads of the command line, as forces.

use crate::arguments::{LoadArguments, Numbers};
use crate::failure::Failure;

/// Weight of a kilogram where nothing else is said, m/s².
const GRAVITY: f64 = 9.81;

/// Where a force acts: the origin unless said otherwise.
pub(crate) fn point<const C: usize>(at: Option<&Numbers>) -> Result<[f64; C], Failure> {
    at.map_or(Ok([0.0; C]), |at| at.array("at")).map_err(Failure::Usage)
}

/// With what a mass pulls: its weight, less what accelerates it.
pub(crate) fn pull_of_mass<const C: usize>(load: &LoadArguments) -> Result<[f64; C], Failure> {
    let mass = load.mass.unwrap_or(0.0);
    let down = std::array::from_fn(|a| if a + 1 == C { -GRAVITY } else { 0.0 });
    let given = |numbers: Option<&Numbers>, option: &str, default: [f64; C]| {
        numbers.map_or(Ok(default), |numbers| numbers.array(option)).map_err(Failure::Usage)
    };
    let gravity = given(load.gravity.as_ref(), "gravity", down)?;
    let accelerated = given(load.accelerated.as_ref(), "accelerated", [0.0; C])?;
    Ok(std::array::from_fn(|a| mass * (gravity[a] - accelerated[a])))
}

/// The force of a load, a weight included.
pub(crate) fn total_force<const C: usize>(load: &LoadArguments) -> Result<[f64; C], Failure> {
    let pull = if load.mass.is_some() { pull_of_mass(load)? } else { [0.0; C] };
    let force = load.force.as_ref().map_or(Ok([0.0; C]), |force| force.array("force"));
    let force = force.map_err(Failure::Usage)?;
    if load.mass.is_none() && load.force.is_none() {
        return Err(Failure::Usage("say for which load: --mass or --force".to_owned()));
    }
    Ok(std::array::from_fn(|a| pull[a] + force[a]))
}

/// A direction, of any length but zero.
pub(crate) fn direction<const C: usize>(numbers: &Numbers, option: &str) -> Result<[f64; C], Failure> {
    let direction = numbers.array(option).map_err(Failure::Usage)?;
    if direction.iter().all(|x| *x == 0.0) {
        return Err(Failure::Usage(format!("--{option}: all zeros given, must be a direction")));
    }
    Ok(direction)
}
