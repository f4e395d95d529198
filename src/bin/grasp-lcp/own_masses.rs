//! Options of the command line that tilt or accelerate bodies whose masses the scene states. If the scene's gravity already gives a body its weight,
//! this weight is not added again.

use std::borrow::Cow;

use grasp_lcp::words::printable;

use crate::arguments::{Command, LoadArguments, NeedArguments, Numbers};
use crate::failure::Failure;
use grasp_lcp::scene::Setup;

/// The total weight of all bodies, N, and their common centre of mass, m, for a question in which the grasp is tilted.
pub(crate) struct TurnedWeight {
    pub(crate) weight: [f64; 3],
    pub(crate) at: Numbers,
}

/// If the scene's gravity acts on bodies with masses, removes the gravity and returns the total weight of the bodies. The caller turns this weight as
/// a load. `None` otherwise.
pub(crate) fn tilted(setup: &mut Setup<3>) -> Result<Option<TurnedWeight>, Failure> {
    let Some(((mass, centre), gravity)) = setup.own_mass().zip(setup.gravity) else { return Ok(None) };
    *setup = setup.with_gravity_as_load().map_err(|error| Failure::Usage(error.to_string()))?;
    Ok(Some(TurnedWeight {
        weight: std::array::from_fn(|a| mass * gravity[a]),
        at: Numbers(centre[..setup.axes()].to_vec()),
    }))
}

/// Makes every load act on all bodies in proportion to their masses. Returns the total mass, kg, and its centre, m; `option` is the option that an
/// error names.
pub(crate) fn accelerated(setup: &mut Setup<3>, option: &str) -> Result<(f64, [f64; 3]), Failure> {
    let message = || {
        format!("--{option} without --mass: say it, unless bodies have masses and the scene has a gravity")
    };
    let own = setup.own_mass().ok_or_else(|| Failure::Usage(message()))?;
    (setup.loaded, setup.shared_by_mass) = (None, true);
    Ok(own)
}

/// The common centre of mass of the bodies, m, whether or not the scene has gravity. `None` unless the bodies have masses and share every load in
/// proportion to them.
pub(crate) fn shared_centre(setup: &Setup<3>) -> Option<Vec<f64>> {
    let mut setup = setup.shared_by_mass.then(|| setup.clone())?;
    setup.gravity = Some([1.0; 3].into());
    setup.own_mass().map(|(_, centre)| centre[..setup.axes()].to_vec())
}

/// Refuses an arm that turns where the bodies share loads by mass: each body has the acceleration of its own centre, not that of the common one.
pub(crate) fn refuse_turning(asked: &Command) -> Result<(), Failure> {
    let (Command::Hold { load, .. }
    | Command::Compare { load, .. }
    | Command::Improve { load, .. }
    | Command::Solve { load, .. }
    | Command::Onset { load, .. }
    | Command::Need { need_arguments: NeedArguments { load, .. }, .. }) = asked
    else {
        return Ok(());
    };
    if load.angular_velocity.is_none() && load.angular_acceleration.is_none() {
        return Ok(());
    }
    let message = "--angular-velocity, --angular-acceleration: must be left out where bodies share loads by mass, since each has an acceleration of its own; in a scene without `shared_by_mass` the inertia of each is its `load`";
    Err(Failure::Usage(message.to_owned()))
}

/// Refuses `--mass` if the scene's gravity already acts on a mass of the body on which the load acts.
pub(crate) fn refuse_mass(setup: &Setup<3>, mass: Option<f64>) -> Result<(), Failure> {
    match mass.and_then(|_| setup.weighty_body(None)) {
        None => Ok(()),
        Some(body) => Err(Failure::Usage(format!(
            "--mass: the scene's gravity already pulls at {}, which has a mass: leave --mass out for its own weight, and say what lies on it besides as --force",
            printable(body)
        ))),
    }
}

/// Completes a load of the command line by data of the scene. With `--acceleration` and without `--mass`, all bodies of the scene together become the
/// accelerated mass; their weight is not added. With `--mass` and without `--at`, the load acts at the centre of mass of the part, if the scene has a
/// mesh. Other loads are returned unchanged.
pub(crate) fn of_own_masses<'l>(
    load: &'l LoadArguments,
    beside: bool,
    setup: &mut Setup<3>,
) -> Result<Cow<'l, LoadArguments>, Failure> {
    refuse_mass(setup, load.mass)?;
    #[cfg(feature = "mesh")]
    if let (None, Some(_), Some(centre)) =
        (&load.at, load.mass, setup.part_read().and_then(grasp_lcp::touch::Part::centre_of_mass))
    {
        return Ok(Cow::Owned(LoadArguments { at: Some(Numbers(centre.to_vec())), ..load.clone() }));
    }
    if load.acceleration.is_none() || load.mass.is_some() {
        return Ok(Cow::Borrowed(load));
    }
    let (mass, centre) = accelerated(setup, "acceleration")?;
    let others =
        [load.force.is_some(), load.moment.is_some(), load.at.is_some(), !load.together_with.is_empty()];
    if beside || others.contains(&true) {
        let message = "--acceleration: accelerates the bodies by their own masses, must stand without --base, --force, --moment, --at and --together-with: what is always there is the `load` of a body";
        return Err(Failure::Usage(message.to_owned()));
    }
    let axes = setup.axes();
    let (gravity, at) = (Some(Numbers(vec![0.0; axes])), Some(Numbers(centre[..axes].to_vec())));
    Ok(Cow::Owned(LoadArguments { mass: Some(mass), gravity, at, ..load.clone() }))
}
