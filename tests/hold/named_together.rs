//! The first slip of a verdict names all contacts that slide at loads that differ by rounding alone, and drives that give way at rest.

use std::error::Error;

use grasp_lcp::hold::Verdict;
use grasp_lcp::planar::Wrench;
use grasp_lcp::scene::Scene;

fn held(scene: &str, force: f64) -> Result<Verdict<2>, Box<dyn Error>> {
    let scene: Scene = serde_json::from_str(scene)?;
    let setup = scene.planar().ok_or("in the plane")?;
    Ok(setup.grasp()?.hold(Wrench::force([0.0, force]))?)
}

fn first(verdict: &Verdict<2>) -> Vec<&str> {
    let first = verdict.first_slip.as_ref().expect("something slides");
    first.slide.iter().map(|part| part.label.as_str()).collect()
}

/// A pipe lies on two pipes that slide below it on both sides, under the weight alone.
#[test]
fn both_sides_slide_from_the_start() -> Result<(), Box<dyn Error>> {
    let verdict = held(include_str!("scenes/stacked_pipes.json"), 0.0)?;
    assert_eq!(first(&verdict), ["tl", "tr"], "{verdict}");
    Ok(())
}

/// Two equal fingers of a hand with one tendon.
#[test]
fn both_fingers_slide_at_the_same_load() -> Result<(), Box<dyn Error>> {
    let verdict = held(include_str!("scenes/tendon_hand.json"), -5.0)?;
    assert_eq!(first(&verdict), ["Lp", "Rp"], "{verdict}");
    Ok(())
}

/// Two joints that press against each other with 0.5 N m. The clutch of one slips at 0.3 N m.
#[test]
fn a_clutch_slips_at_rest() -> Result<(), Box<dyn Error>> {
    let verdict = held(include_str!("scenes/clutch_slips_at_rest.json"), -1.0)?;
    assert_eq!(verdict.first_slip.as_ref().expect("the clutch slips").give_way, ["clutch"]);
    assert!(verdict.to_string().starts_with("HOLDS, but clutch gives way from the start"), "{verdict}");
    Ok(())
}
