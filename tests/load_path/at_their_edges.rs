//! Paths at their edges, as they came from others: each stood still there, and each goes on, or ends with what it is.
//!
//! The second opinion is the path in steps, which knows no events.

use grasp_lcp::load_path::{Change, LossKind, PathEnd};
use grasp_lcp::planar::Wrench as PlanarWrench;
use grasp_lcp::scene::{Question, Scene, Setup, Space};
use grasp_lcp::spatial::{Grasp, Leg, LoadPath, Wrench};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn read(text: &str) -> Result<Space, Box<dyn std::error::Error>> {
    let scene: Scene = serde_json::from_str(text)?;
    Ok(scene.space)
}

/// The grasp of a scene in space, with the load and the legs that are followed.
fn asked<const C: usize>(setup: &Setup<C>) -> Result<Asked<C>, Box<dyn std::error::Error>> {
    let Some(Question::Follow { start, legs }) = setup.questions.first() else {
        return Err("asks for a path".into());
    };
    Ok((setup.grasp()?, *start, setup.legs(legs)?))
}

type Asked<const C: usize> =
    (grasp_lcp::ask::Grasp<C>, grasp_lcp::grasp::Wrench<C>, Vec<grasp_lcp::load_path::Leg<C>>);

fn in_space(text: &str) -> Result<(Grasp, Wrench, Vec<Leg>), Box<dyn std::error::Error>> {
    let Space::Spatial(setup) = read(text)? else { return Err("in space".into()) };
    asked(&setup)
}

fn in_the_plane(text: &str) -> Result<Asked<2>, Box<dyn std::error::Error>> {
    let Space::Planar(setup) = read(text)? else { return Err("in the plane".into()) };
    asked(&setup)
}

/// A finger lets go and presses again while another has stood still on its cone's edge: what happens there is decided for both.
#[test]
fn a_finger_presses_again_beside_one_on_its_edge() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/pressed_on_again.json"))?;
    let mut path = grasp.follow(&start, &legs)?;
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let mut steps = grasp.follow_in_steps(&start, &legs, 1e-7)?;
    steps.by_ref().for_each(drop);
    let (last, near) = (path.state().ok_or("at its end")?, steps.state().ok_or("at its end")?);
    let largest = last.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    for (a, b) in last.contacts.iter().zip(&near.contacts) {
        assert!((a.force - b.force).norm() < 1e-4 * largest, "{} and {}", a.force, b.force);
    }
    Ok(())
}

/// Ordinary arcs, a third of whose fractions were not told.
#[test]
fn every_fraction_that_was_passed_is_told() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/told_everywhere.json"))?;
    let mut path = grasp.follow(&start, &legs)?;
    path.run();
    let (leg, end) = path.place();
    assert!(leg == 0 && end > 0.1);
    let told = |k: usize| path.state_at(0, end * k as f64 / 2000.0);
    let mut before: Option<Vec<[f64; 3]>> = None;
    for k in 0..=2000 {
        let state = told(k).ok_or_else(|| format!("{k} of 2000 is not told"))?;
        let forces: Vec<[f64; 3]> = state.contacts.iter().map(|c| c.force.into()).collect();
        // Nothing jumps between neighbours.
        if let Some(before) = before.replace(forces.clone()) {
            let apart = before.iter().flatten().zip(forces.iter().flatten()).map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f64::max) < 0.05, "between {} and {k}", k - 1);
        }
    }
    Ok(())
}

/// Only two contacts in space stay loaded: what is free about their line stands where contacts without force push it, until a load turns it.
#[test]
fn two_contacts_stay_loaded_in_space() -> Tested {
    for text in
        [include_str!("scenes/third_finger_opens.json"), include_str!("scenes/fourth_finger_opens.json")]
    {
        let (grasp, start, legs) = in_space(text)?;
        let mut path = grasp.follow(&start, &legs[..1])?;
        let events = path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let opened = events.last().ok_or("events")?;
        assert_eq!(opened.free_motions.len(), 1);
        assert!(opened.changes.iter().all(|change| change.what == Change::Opens));
        let last = path.state().ok_or("at its end")?;
        let loaded: Vec<_> = last.contacts.iter().filter(|c| c.force.norm() > 0.0).collect();
        assert_eq!(loaded.len(), 2);
        // Without a load the two forces are opposite each other.
        let (a, b) = (loaded[0].force_world, loaded[1].force_world);
        assert!((a + b).norm() < 1e-12 * a.norm());
        assert!(last.contacts.iter().all(|c| c.gap > -1e-15), "nothing penetrates");
        decided(&grasp, start, &legs)?;
    }
    Ok(())
}

fn decided(grasp: &Grasp, start: Wrench, legs: &[Leg]) -> Tested {
    let mut path: LoadPath<'_> = grasp.follow(&start, legs)?;
    path.run();
    assert!(!matches!(path.end(), Some(PathEnd::Undecided { .. })), "{:?}", path.end());
    Ok(())
}

/// Fingers whose commands carry no force move the object as they come; the first load takes it away.
#[test]
fn nothing_presses() -> Tested {
    for text in [
        include_str!("scenes/nothing_presses_at_the_start.json"),
        include_str!("scenes/nothing_presses_any_more.json"),
    ] {
        let (grasp, start, legs) = in_the_plane(text)?;
        assert!(start == PlanarWrench::ZERO);
        let mut path = grasp.follow(&start, &legs)?;
        let events = path.run();
        assert!(events.len() < 5, "{events:?}");
        let loss = path.end().and_then(PathEnd::loss).ok_or("lost")?;
        assert!(loss.leg == 1 && loss.fraction == 0.0, "{loss:?}");
        assert!(matches!(loss.kind, LossKind::GivesWay | LossKind::Corner));
        let last = path.state_at(0, 1.0).ok_or("at the end of the first leg")?;
        assert!(last.contacts.iter().all(|c| c.force.norm() == 0.0 || c.force.norm() < 1e-30));
        assert!(last.contacts.iter().all(|c| c.friction_used() == 0.0), "of no force");
    }
    Ok(())
}

/// Contacts that slide at the start may go on to slide, and one may stick as well: both hold, and the path says that there is another.
#[test]
fn the_other_way_to_begin_is_told() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/two_ways_at_the_start.json"))?;
    let mut path = grasp.follow(&start, &legs)?;
    let first = path.next().ok_or("an event at the start")?;
    assert!(first.leg == 0 && first.fraction == 0.0 && first.changes.is_empty());
    assert_eq!(first.other_continuations, Some(1));
    path.run();
    // The path slides on to a fold; steps find the one that sticks, which goes on.
    let loss = path.end().and_then(PathEnd::loss).ok_or("lost")?;
    assert_eq!(loss.kind, LossKind::Fold);
    let mut steps = grasp.follow_in_steps(&start, &legs, 1e-6)?;
    steps.by_ref().for_each(drop);
    assert!(matches!(steps.end(), Some(PathEnd::Completed)), "{:?}", steps.end());
    Ok(())
}
