//! The first line of a path that snaps over names the snap, although the path goes on to its end. It counts legs from 1; fields are indices.

use std::error::Error;

use grasp_lcp::scene::{Answer, Scene};
use grasp_lcp::words::Words;

#[test]
fn a_snap_on_the_way() -> Result<(), Box<dyn Error>> {
    let scene: Scene = serde_json::from_str(include_str!("scenes/snaps_over_on_the_way.json"))?;
    let setup = scene.planar().ok_or("in the plane")?;
    let answer = setup.answers()?.swap_remove(0);
    let line = setup.questions[0].first_line(&answer, Words::default());
    assert!(line.starts_with("HELD to the end: snaps over at 0.729146 of leg 3, "), "{line}");
    assert!(line.contains(", counting no momentum; first slip at 0.942701 of leg 2, "), "{line}");
    let Answer::Follow(path) = answer else { panic!("a path") };
    let snap = path.events.iter().find(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps));
    assert_eq!(snap.map(|event| event.leg), Some(2));
    Ok(())
}
