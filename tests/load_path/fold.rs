//! A path can end at a fold. While the force of a sliding contact decreases, its friction turns faster and faster, until the load cannot grow any
//! more. Another equilibrium with nearly the same forces may exist beyond.

use std::error::Error;

use grasp_lcp::Settings;
use grasp_lcp::load_path::LossKind;
use grasp_lcp::scene::{Scene, Space};
use grasp_lcp::spatial::{Beyond, ContactState, Equilibrium, Grasp, Leg, PathEnd, Wrench};

/// The bottle of the example scenes under a pull along x at the origin: its last state, the end of the path, and the search beyond the end.
fn pulled(
    grasp: &Grasp,
    pull: f64,
    settings: &Settings,
) -> Result<(Equilibrium, PathEnd, Option<Beyond>), Box<dyn Error>> {
    let asked = grasp.with(settings);
    let mut path = asked.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([pull, 0.0, 0.0]))])?;
    path.by_ref().for_each(drop);
    let end = path.end().ok_or("no end")?.clone();
    let state = path.state().ok_or("it starts")?;
    Ok((state, end, path.beyond()))
}

#[test]
fn a_path_that_turns_back_ends_in_a_snap_however_little_changes() -> Result<(), Box<dyn Error>> {
    let scene: Scene = serde_json::from_str(include_str!("../../examples/scenes/bottle.json"))?;
    let Space::Spatial(setup) = scene.space else { return Err("bottle is spatial".into()) };
    let (grasp, settings) = (setup.grasp()?, Settings::default().with_step_error(1e-13));
    let (last, end, beyond) = pulled(&grasp, 100.0, &settings)?;
    let PathEnd::Lost(loss) = end else { return Err(format!("{end:?}").into()) };
    assert_eq!(loss.kind, LossKind::Fold);
    assert!(matches!(beyond, Some(Beyond::Snap)), "{beyond:?}");
    let most = 100.0 * loss.fraction;

    // At a fold forces approach those of the end like the square root of the distance, up to a linear term.
    // A failure of the integration would not show this.
    let away = |distance: f64| -> Result<f64, Box<dyn Error>> {
        let (state, end, _) = pulled(&grasp, most - distance, &settings)?;
        assert!(matches!(end, PathEnd::Completed));
        Ok((state.contacts[0].force_world - last.contacts[0].force_world).norm())
    };
    for distance in [1e-6, 2.5e-7, 6.25e-8] {
        let quotient = away(4.0 * distance)? / away(distance)?;
        assert!((quotient - 2.0).abs() < 0.05, "{distance}: {quotient}");
    }

    // In the equilibrium beyond the fold, the thumb has opened.
    assert!(last.contacts[0].normal_force() > 6e-4);
    let beyond = grasp.solve(Wrench::force([most * (1.0 + 1e-9), 0.0, 0.0]))?;
    let beyond = beyond.equilibrium().ok_or("three fingers")?;
    assert_eq!(beyond.contacts[0].state, ContactState::Separated);
    let largest = last.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    for (there, here) in beyond.contacts.iter().zip(&last.contacts) {
        assert!((there.force - here.force).norm() < 1e-3 * largest);
    }

    // The fold does not depend on the error of the steps.
    for step_error in [1e-6, 1e-8, 1e-10] {
        let (_, end, beyond) = pulled(&grasp, 100.0, &settings.with_step_error(step_error))?;
        let PathEnd::Lost(coarse) = end else { return Err(format!("{step_error}: {end:?}").into()) };
        assert!(matches!(beyond, Some(Beyond::Snap)), "{step_error}: {beyond:?}");
        assert!((coarse.fraction / loss.fraction - 1.0).abs() < step_error, "{step_error}");
    }
    Ok(())
}
