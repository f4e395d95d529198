//! At the end of every step the contact law holds. Random grasps and programs have commands, clearances, openings and closings; [`support::programs`]
//! computes the law from points, normals and springs. The path from event to event is compared if it reports that its continuation is unique. Both
//! paths then end with the same forces and motions within the error, or are lost at the same load.

use grasp_lcp::Settings;
use grasp_lcp::load_path::PathEnd;
use proptest::prelude::*;
use support::programs::draw::{few_planar_contacts, over, planar_scenes, spatial_scenes};
use support::programs::tally::Tally;
use support::programs::views::View;
use support::programs::{Goal, Scene, brief, same_state};

/// Allowed error of forces for each leg, relative to the largest force.
const ERROR: f64 = 1e-4;
/// Largest number of steps of a leg. Near the apex of a cone steps become shorter and shorter, and the path ends undecided.
const MOST_STEPS: usize = 300;

fn the_law_holds<const D: usize, const C: usize>(
    scene: &Scene<D, C>,
    tally: &mut Tally,
) -> Result<(), TestCaseError> {
    let grasp = scene.grasp();
    let mut path = grasp.follow(scene.start(), &scene.legs()).unwrap();
    let events = path.run();
    tally.count(&events, &path);
    let asked = grasp.with(&Settings::default().with_most_steps(MOST_STEPS));
    let mut steps = asked.follow_in_steps(scene.start(), &scene.legs(), ERROR).unwrap();
    while let Some(step) = steps.next() {
        let state = steps.state().unwrap();
        let breach = scene.breach_on_the_round_cone(step.leg, step.fraction, &state);
        prop_assert!(breach <= 1e-11, "{breach:e} at {} {}: {}", step.leg, step.fraction, brief(&state));
        tally.checked += 1;
    }
    if events.iter().any(|event| event.other_continuations != Some(0) || event.jump.is_some()) {
        return Ok(());
    }
    match [path.end(), steps.end()].map(Option::unwrap) {
        [PathEnd::Completed, PathEnd::Completed] => {
            if let [Some(a), Some(b)] = [path.state(), steps.state()] {
                same_state(scene, &a, &b, 10.0 * ERROR)?;
            }
        }
        [PathEnd::Lost(a), PathEnd::Lost(b)] => {
            prop_assert!(a.leg == b.leg && (a.fraction - b.fraction).abs() < 1e-4, "{a:?}\n{b:?}");
        }
        [PathEnd::NoStart(_), PathEnd::NoStart(_)] => {}
        [_, PathEnd::Undecided { .. }] => tally.inaccurate += 1,
        ends => prop_assert!(false, "{ends:?}"),
    }
    Ok(())
}

/// A scene that contains the given scene and its mirror image, so that each contact and its image change at once.
fn with_its_image(scene: &Scene<3, 2>) -> Scene<3, 2> {
    let image = View::mirrored().scene(scene);
    let goal = |(a, b): (&Goal<3, 2>, &Goal<3, 2>)| Goal {
        load: a.load + b.load,
        commands: a.commands.iter().chain(&b.commands).copied().collect(),
        turn: None,
    };
    Scene {
        spots: scene.spots.iter().chain(&image.spots).cloned().collect(),
        goals: scene.goals.iter().zip(&image.goals).map(goal).collect(),
    }
}

#[test]
fn in_the_plane() {
    let t = over(120, &planar_scenes(), |scene, tally| the_law_holds(&scene, tally));
    println!("{t:?}");
    assert!(t.slides > 100 && t.sticks > 60 && t.opens > 30 && t.closes > 20 && t.checked > 2000, "{t:?}");
}

#[test]
fn in_pairs_in_the_plane() {
    let scenes = few_planar_contacts().prop_map(|scene| with_its_image(&scene));
    let t = over(40, &scenes, |scene, tally| the_law_holds(&scene, tally));
    println!("{t:?}");
    assert!(t.slides > 30 && t.sticks > 10 && t.checked > 500, "{t:?}");
}

#[test]
fn in_space() {
    let t = over(8, &spatial_scenes(), |scene, tally| the_law_holds(&scene, tally));
    println!("{t:?}");
    assert!(t.slides > 3 && t.checked > 100, "{t:?}");
}
