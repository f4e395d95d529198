//! A path can end at a fold. While the force of a sliding contact decreases, its friction turns faster and faster, until the load cannot grow any
//! more. At this fold the object snaps over to another equilibrium with nearly the same forces.

use std::error::Error;

use grasp_lcp::Settings;
use grasp_lcp::load_path::PathEnd;
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial::{ContactState, Equilibrium, Event, Grasp, Leg, Wrench};

/// The bottle of the example scenes under a pull along x at the origin. Returns the last state, and the event at which the bottle snaps over.
fn pulled(
    grasp: &Grasp,
    pull: f64,
    settings: &Settings,
) -> Result<(Equilibrium, Option<Event>), Box<dyn Error>> {
    let asked = grasp.with(settings);
    let mut path = asked.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([pull, 0.0, 0.0]))])?;
    let snaps = path.by_ref().find(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps));
    path.run();
    assert!(snaps.is_some() || matches!(path.end(), Some(PathEnd::Completed)));
    Ok((path.state().ok_or("it starts")?, snaps))
}

#[test]
fn a_path_that_turns_back_snaps_over_however_little_changes() -> Result<(), Box<dyn Error>> {
    let scene: Scene = serde_json::from_str(include_str!("../../examples/scenes/bottle.json"))?;
    let Some(setup) = scene.spatial() else { return Err("bottle is spatial".into()) };
    let (grasp, settings) = (setup.grasp()?, Settings::default().with_step_error(1e-13));
    let snap = pulled(&grasp, 100.0, &settings)?.1.ok_or("snaps over")?;
    let (last, most) = (&snap.state, 100.0 * snap.fraction);

    // At a fold the difference of the forces from those at the end is proportional to the square root of the remaining load. If the integration
    // merely failed there, it would not be.
    let away = |distance: f64| -> Result<f64, Box<dyn Error>> {
        let (state, snaps) = pulled(&grasp, most - distance, &settings)?;
        assert!(snaps.is_none());
        Ok((state.contacts[0].force_world - last.contacts[0].force_world).norm())
    };
    for distance in [1e-6, 2.5e-7, 6.25e-8] {
        let quotient = away(4.0 * distance)? / away(distance)?;
        assert!((quotient - 2.0).abs() < 0.05, "{distance}: {quotient}");
    }

    // In the equilibrium at a slightly larger load than that of the fold, the thumb has opened.
    assert!(last.contacts[0].normal_force() > 6e-4);
    let solved = grasp.solve(Wrench::force([most * (1.0 + 1e-9), 0.0, 0.0]))?;
    let solved = solved.equilibrium().ok_or("three fingers")?;
    let largest = last.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    for beyond in [solved, &snap.jump.as_ref().ok_or("a jump")?.state] {
        assert_eq!(beyond.contacts[0].state, ContactState::Separated);
        for (there, here) in beyond.contacts.iter().zip(&last.contacts) {
            assert!((there.force - here.force).norm() < 1e-3 * largest);
        }
    }

    // The load of the fold does not depend on the error of the steps.
    for step_error in [1e-6, 1e-8, 1e-10] {
        let coarse = pulled(&grasp, 100.0, &settings.with_step_error(step_error))?.1.ok_or("snaps over")?;
        assert!((coarse.fraction / snap.fraction - 1.0).abs() < step_error, "{step_error}");
    }
    Ok(())
}
