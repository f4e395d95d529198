//! Needed amounts agree with verdicts of `hold` on amounts around each answer, on random scenes.

use support::amounts::{self, Quantity, Scene, checked};
use support::samples::{samples, seeded};
use support::splitmix::Random;

type Tested = Result<(), grasp_lcp::Error>;

/// Number of random scenes for each quantity.
const SCENES: usize = 2;
/// Number of tried amounts in each scene: by default, and if more scenes are requested.
const AMOUNTS: [i32; 2] = [12, 200];

/// Asks for needed amounts in random scenes, and checks other amounts around each answer.
fn is_met<const C: usize>(
    name: &str,
    draw: &dyn Fn(&mut Random) -> Result<Scene<C>, grasp_lcp::Error>,
    quantity: Quantity<C>,
) -> Tested {
    let mut wrong = Vec::new();
    let amounts = AMOUNTS[usize::from(samples(SCENES) > SCENES)];
    for number in 0..samples(SCENES) {
        let mut random = seeded(number as u64);
        let scene = draw(&mut random)?;
        let found = checked(&scene, quantity, amounts, &mut random)?.wrong;
        wrong.extend(found.into_iter().map(|what| format!("{name} {number}: {what}")));
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(20)].join("\n"));
    Ok(())
}

#[test]
fn squeezes() -> Tested {
    is_met("squeeze", &amounts::planar, amounts::squeeze())?;
    is_met("squeeze in space", &amounts::spatial, amounts::squeeze())
}

#[test]
fn coefficients() -> Tested {
    is_met("friction", &amounts::planar, amounts::friction())?;
    is_met("friction in space", &amounts::spatial, amounts::friction())
}

#[test]
fn loads() -> Tested {
    is_met("load", &amounts::planar, amounts::load())?;
    is_met("load in space", &amounts::spatial, amounts::load())
}

#[test]
fn loads_at_rest() -> Tested {
    is_met("load at rest", &amounts::planar, amounts::at_rest())?;
    is_met("at rest, space", &amounts::spatial, amounts::at_rest())
}

#[test]
fn arms() -> Tested {
    is_met("arm", &amounts::planar, amounts::arm())?;
    is_met("arm in space", &amounts::spatial, amounts::arm())
}

#[test]
fn forces() -> Tested {
    is_met("force", &amounts::planar, amounts::force())?;
    is_met("force in space", &amounts::spatial, amounts::force())
}
