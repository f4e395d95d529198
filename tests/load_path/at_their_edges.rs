//! A path on which a contact reaches the edge of its cone continues, or ends with a stated cause. The scenes come from users.
//!
//! The reference is the path followed in steps of bounded error, which does not compute events.

use grasp_lcp::load_path::{Change, LossKind, PathEnd};
use grasp_lcp::planar::Wrench as PlanarWrench;
use grasp_lcp::scene::{Question, Scene, Setup};
use grasp_lcp::spatial::{Grasp, Leg, LoadPath, Wrench};

type Tested = Result<(), Box<dyn std::error::Error>>;

/// The grasp of a scene, the load at the start, and the legs to follow.
fn asked<const C: usize>(setup: &Setup<C>) -> Result<Asked<C>, Box<dyn std::error::Error>> {
    let Some(Question::Follow { start, legs, .. }) = setup.questions.first() else {
        return Err("asks for a path".into());
    };
    Ok((setup.grasp()?, *start, legs.clone()))
}

type Asked<const C: usize> =
    (grasp_lcp::ask::Grasp<C>, grasp_lcp::grasp::Wrench<C>, Vec<grasp_lcp::load_path::Leg<C>>);

fn in_space(text: &str) -> Result<(Grasp, Wrench, Vec<Leg>), Box<dyn std::error::Error>> {
    asked(&serde_json::from_str::<Scene>(text)?.spatial().ok_or("in space")?)
}

fn in_the_plane(text: &str) -> Result<Asked<2>, Box<dyn std::error::Error>> {
    asked(&serde_json::from_str::<Scene>(text)?.planar().ok_or("in the plane")?)
}

/// A finger opens and presses again while another finger is on the edge of its cone without slip. The path must find contact states for both fingers
/// together.
#[test]
fn a_finger_presses_again_beside_one_on_its_edge() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/pressed_on_again.json"))?;
    let mut path = grasp.follow(start, &legs)?;
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let mut steps = grasp.follow_in_steps(start, &legs, 1e-7)?;
    steps.by_ref().for_each(drop);
    let (last, near) = (path.state().ok_or("at its end")?, steps.state().ok_or("at its end")?);
    let largest = last.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    for (a, b) in last.contacts.iter().zip(&near.contacts) {
        assert!((a.force - b.force).norm() < 1e-4 * largest, "{} and {}", a.force, b.force);
    }
    Ok(())
}

/// The path has a state at every fraction of a leg, also where contacts slide in turning directions (along arcs).
#[test]
fn every_fraction_that_was_passed_is_told() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/told_everywhere.json"))?;
    let mut path = grasp.follow(start, &legs)?;
    path.run();
    let (leg, end) = path.place();
    assert!(leg == 0 && end > 0.1);
    let told = |k: usize| path.state_at(0, end * k as f64 / 2000.0);
    let mut before: Option<Vec<[f64; 3]>> = None;
    for k in 0..=2000 {
        let state = told(k).ok_or_else(|| format!("{k} of 2000"))?;
        let forces: Vec<[f64; 3]> = state.contacts.iter().map(|c| c.force.into()).collect();
        // Forces are continuous between neighbouring fractions.
        if let Some(before) = before.replace(forces.clone()) {
            let apart = before.iter().flatten().zip(forces.iter().flatten()).map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f64::max) < 0.05, "between {} and {k}", k - 1);
        }
    }
    Ok(())
}

/// All contacts but two open. The object may then turn freely about the line through these two, and stays where the other contacts have pushed it,
/// until a load turns it.
#[test]
fn two_contacts_stay_loaded_in_space() -> Tested {
    for text in
        [include_str!("scenes/third_finger_opens.json"), include_str!("scenes/fourth_finger_opens.json")]
    {
        let (grasp, start, legs) = in_space(text)?;
        let mut path = grasp.follow(start, &legs[..1])?;
        let events = path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let opened = events.last().ok_or("events")?;
        assert_eq!(opened.free_motions.len(), 1);
        assert!(opened.changes.iter().all(|change| change.what == Change::Opens));
        let last = path.state().ok_or("at its end")?;
        let loaded: Vec<_> = last.contacts.iter().filter(|c| c.force.norm() > 0.0).collect();
        assert_eq!(loaded.len(), 2);
        // Without a load the two remaining forces are opposite.
        let (a, b) = (loaded[0].force_world, loaded[1].force_world);
        assert!((a + b).norm() < 1e-12 * a.norm());
        assert!(last.contacts.iter().all(|c| c.gap > -1e-15), "nothing penetrates");
        decided(&grasp, start, &legs)?;
    }
    Ok(())
}

fn decided(grasp: &Grasp, start: Wrench, legs: &[Leg]) -> Tested {
    let mut path: LoadPath<'_> = grasp.follow(start, legs)?;
    path.run();
    assert!(!matches!(path.end(), Some(PathEnd::Undecided { .. })), "{:?}", path.end());
    Ok(())
}

/// Fingers without normal forces move the object by their commands. The first load loses it.
#[test]
fn nothing_presses() -> Tested {
    for text in [
        include_str!("scenes/nothing_presses_at_the_start.json"),
        include_str!("scenes/nothing_presses_any_more.json"),
    ] {
        let (grasp, start, legs) = in_the_plane(text)?;
        assert!(start == PlanarWrench::ZERO);
        let mut path = grasp.follow(start, &legs)?;
        let events = path.run();
        // As soon as a load acts, the loose object jumps from gap to gap, and hardly any other events occur.
        assert!(events.iter().filter(|event| event.jump.is_none()).count() < 5, "{events:?}");
        let loss = path.end().and_then(PathEnd::loss).ok_or("lost")?;
        assert!(loss.leg == 1 && loss.fraction == 0.0, "{loss:?}");
        assert!(matches!(loss.kind, LossKind::GivesWay | LossKind::Corner));
        let last = path.state_at(0, 1.0).ok_or("after a leg")?;
        assert!(last.contacts.iter().all(|c| c.force.norm() == 0.0 || c.force.norm() < 1e-30));
        assert!(last.contacts.iter().all(|c| c.friction_used() == 0.0), "of no force");
    }
    Ok(())
}

/// Contacts that slide at the start may all continue to slide, or one of them may stick. The path follows one of these continuations and reports that
/// another exists.
#[test]
fn the_other_way_to_begin_is_told() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/two_ways_at_the_start.json"))?;
    let mut path = grasp.follow(start, &legs)?;
    let first = path.next().ok_or("no event")?;
    assert!(first.leg == 0 && first.fraction == 0.0 && first.changes.is_empty());
    assert_eq!(first.other_continuations, Some(1));
    let events = path.run();
    assert!(events.iter().any(|event| event.jump.as_ref().is_some_and(|jump| jump.snaps)));
    // The path continues with sliding until a fold, where the object snaps over. The path in steps finds the continuation with the sticking contact,
    // which has no fold.
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let mut steps = grasp.follow_in_steps(start, &legs, 1e-6)?;
    steps.by_ref().for_each(drop);
    assert!(matches!(steps.end(), Some(PathEnd::Completed)), "{:?}", steps.end());
    Ok(())
}

/// A finger slides with vanishing force, and another finger comes to rest on the edge of its cone. After this no force changes, and the second finger
/// stays on the edge.
#[test]
fn a_slip_dies_out_on_the_edge_of_its_cone() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/slip_dies_out.json"))?;
    let mut path = grasp.follow(start, &legs)?;
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let mut steps = grasp.follow_in_steps(start, &legs[..1], 1e-7)?;
    steps.by_ref().for_each(drop);
    let (there, near) = (path.state_at(0, 1.0).ok_or("has passed")?, steps.state().ok_or("at its end")?);
    for (a, b) in there.contacts.iter().zip(&near.contacts) {
        assert!((a.force - b.force).norm() < 1e-4 * there.largest_force(), "{} and {}", a.force, b.force);
    }
    Ok(())
}

/// A contact stops sliding just before the load has a maximum. Further slip would be against friction, and sticking would leave the cone, so the path
/// ends.
#[test]
fn what_neither_sticks_nor_slides_ends_the_path() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/stops_beside_a_maximum.json"))?;
    let mut path = grasp.follow(start, &legs)?;
    path.run();
    let lost = path.end().and_then(PathEnd::loss).ok_or("is lost")?;
    assert!(lost.kind == LossKind::Corner && lost.leg == 0, "{lost:?}");
    let mut steps = grasp.follow_in_steps(start, &legs, 1e-7)?;
    steps.by_ref().for_each(drop);
    let (leg, fraction) = steps.place();
    assert!(leg == 0 && (fraction - lost.fraction).abs() < 1e-3, "{fraction} and {}", lost.fraction);
    Ok(())
}

/// A contact slides and sticks again within a twentieth of a leg. The loads of both events do not depend on the length of the leg, and all states are
/// inside their cones.
#[test]
fn a_slip_that_comes_and_goes_is_told_however_long_the_leg() -> Tested {
    let (grasp, start, legs) = in_space(include_str!("scenes/slips_and_sticks_again.json"))?;
    let load = |path: &mut LoadPath| -> Vec<_> {
        let events = path.run();
        let of_it = |event: &&grasp_lcp::spatial::Event| {
            event.fraction > 0.0 && event.changes.iter().any(|change| change.contact.index == 1)
        };
        events.iter().filter(of_it).map(|event| event.load.resultant()[0]).collect()
    };
    let mut whole = grasp.follow(start, &legs)?;
    let told = load(&mut whole);
    assert_eq!(told.len(), 2, "{told:?}");
    // The same path in ten legs.
    let part = |k: u8| whole.state_at(0, f64::from(k) / 10.0).map(|state| Leg::load_to(state.load));
    let parts: Option<Vec<_>> = (1..=10).map(part).collect();
    let in_parts = load(&mut grasp.follow(start, &parts.ok_or("has passed")?)?);
    assert_eq!(in_parts.len(), 2, "{in_parts:?}");
    for (a, b) in told.iter().zip(&in_parts) {
        assert!((a - b).abs() < 1e-8, "{told:?} {in_parts:?}");
    }
    for fraction in (0..=400).map(|k| f64::from(k) / 400.0) {
        let state = whole.state_at(0, fraction).ok_or("has passed")?;
        for (contact, answer) in grasp.contacts().iter().zip(&state.contacts) {
            let over = answer.friction_force() - contact.friction_coefficient() * answer.normal_force();
            assert!(over < 1e-9 * state.largest_force(), "{fraction}: {over}");
        }
    }
    Ok(())
}
