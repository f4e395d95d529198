//! Forces and moments from the loads of the command line.

use grasp_lcp::Error;
use grasp_lcp::grasp::{ArmMotion, Payload, Wrench};
use grasp_lcp::squeeze::Loads;

use crate::arguments::{LoadArguments, Numbers};
use crate::failure::Failure;

/// The point where a force acts; the origin if left out.
pub(crate) fn point<const C: usize>(at: Option<&Numbers>) -> Result<[f64; C], Failure> {
    at.map_or(Ok([0.0; C]), |at| at.array("at")).map_err(Failure::Usage)
}

/// The weight of a mass, down along the last axis.
pub(crate) fn weight_of<const C: usize>(mass: f64) -> Result<[f64; C], Failure> {
    let load = Payload::new(mass, [0.0; C]).load(&ArmMotion::still())?;
    Ok(std::array::from_fn(|a| load.components()[a]))
}

/// The load of a mass on the grasp: its weight minus mass times acceleration.
pub(crate) fn pull_of_mass<const C: usize>(load: &LoadArguments) -> Result<Wrench<C>, Failure> {
    let given = |numbers: &Numbers, option: &str| numbers.array(option).map_err(Failure::Usage);
    let mut arm = ArmMotion::<C>::still();
    if let Some(gravity) = &load.gravity {
        arm = arm.gravity(given(gravity, "gravity")?);
    }
    if let Some(acceleration) = &load.acceleration {
        arm = arm.accelerated(given(acceleration, "acceleration")?);
    }
    let about_axes = |numbers: Option<&Numbers>, option: &str| {
        numbers.map_or(Ok([0.0; 3]), |numbers| about_axes::<C>(numbers, option))
    };
    let velocity = about_axes(load.angular_velocity.as_ref(), "angular-velocity")?.map(f64::to_radians);
    let faster = about_axes(load.angular_acceleration.as_ref(), "angular-acceleration")?.map(f64::to_radians);
    let about = load.about.as_ref().map_or(Ok([0.0; C]), |about| given(about, "about"))?;
    let mut body = Payload::new(load.mass.unwrap_or(0.0), point::<C>(load.at.as_ref())?);
    // A steady rotation about a principal axis needs no moment, whatever the inertia. Principal axes are assumed along the coordinate axes.
    let is_steady = faster == [0.0; 3] && velocity.iter().filter(|rate| **rate != 0.0).count() < 2;
    if load.inertia.is_some() || is_steady {
        body = body.of_inertia(about_axes(load.inertia.as_ref(), "inertia")?);
    }
    body.load(&arm.and_turning(about, velocity, faster)).map_err(|error| {
        match error {
        Error::Question { .. } => Failure::Usage(
            "--inertia is missing: about the centre of mass, kg m², zero for a body that is small beside its \
             arm"
                .to_owned(),
        ),
        error => error.into(),
    }
    })
}

/// Components about the three axes: one given number in the plane, about z, or three in space.
fn about_axes<const C: usize>(numbers: &Numbers, option: &str) -> Result<[f64; 3], Failure> {
    match (C, &numbers.0[..]) {
        (2, [z]) => Ok([0.0, 0.0, *z]),
        (2, all) => {
            Err(Failure::Usage(format!("--{option}: {} given, must be one number in the plane", all.len())))
        }
        _ => numbers.array(option).map_err(Failure::Usage),
    }
}

/// The force of a load, N, including the weight of its mass.
pub(crate) fn total_force<const C: usize>(load: &LoadArguments) -> Result<[f64; C], Failure> {
    let moves = [
        ("angular-velocity", &load.angular_velocity),
        ("angular-acceleration", &load.angular_acceleration),
        ("about", &load.about),
        ("inertia", &load.inertia),
    ];
    if let Some((option, _)) = moves.iter().find(|(_, given)| given.is_some()) {
        let message = format!("--{option}: has no place where an arm or an angle is sought");
        return Err(Failure::Usage(message));
    }
    let pull = if load.mass.is_some() { pull_of_mass(load)? } else { Wrench::<C>::ZERO };
    let force = load.force.as_ref().map_or(Ok([0.0; C]), |force| force.array("force"));
    let force = force.map_err(Failure::Usage)?;
    if load.mass.is_none() && load.force.is_none() {
        return Err(Failure::Usage("say for which load: --mass or --force".to_owned()));
    }
    Ok(std::array::from_fn(|a| pull.components()[a] + force[a]))
}

/// A direction, of any length but zero.
pub(crate) fn direction<const C: usize>(numbers: &Numbers, option: &str) -> Result<[f64; C], Failure> {
    let direction = numbers.array(option).map_err(Failure::Usage)?;
    if direction.iter().all(|x| *x == 0.0) {
        return Err(Failure::Usage(format!("--{option}: all zeros given, must be a direction")));
    }
    Ok(direction)
}

/// The load alone, or together with a force of size `any_force` in any direction.
pub(crate) fn loads<const C: usize>(
    load: Option<Wrench<C>>,
    any_force: Option<f64>,
    at: Option<&Numbers>,
) -> Result<Loads<C>, Failure> {
    let base = load.unwrap_or(Wrench::ZERO);
    Ok(match any_force {
        Some(size) => Loads::AnyForce { base, size, point: point(at)? },
        None => base.into(),
    })
}
