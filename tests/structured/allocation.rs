//! A workspace that has held the largest scene allocates nothing: few contacts by Lemke's paths, many by Newton's method and by Lemke's. Nor does
//! a path of many in steps, with more and more legs.

use allocation_counter::measure;
use grasp_lcp::ask::Grasp;
use grasp_lcp::ask::{Search, Workspace};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::spatial;
use std::cell::RefCell;
use support::random::{Spread, for_all, scene};

/// The scenes in both places, largest first.
fn scenes<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    cases: usize,
) -> Vec<(Grasp<C>, Wrench<C>)> {
    let list = RefCell::new(Vec::new());
    for_all(file!(), cases, &scene::<D, C>(count, Spread::Narrow, 0.3), |scene| {
        list.borrow_mut().push((scene.grasp(), scene.wrench()));
        Ok(())
    });
    let mut list = list.into_inner();
    list.sort_by_key(|(grasp, _)| std::cmp::Reverse(grasp.len()));
    list
}

fn allocates_only_at_first<const D: usize, const C: usize>(
    mut workspace: Workspace<C>,
    count: std::ops::Range<usize>,
    cases: usize,
) {
    let scenes = scenes::<D, C>(count, cases);
    let (grasp, load) = &scenes[0];
    let first = measure(|| assert!(workspace.solve(grasp, load).is_ok()));
    assert!(first.count_total > 0, "the counter counts");
    // All that Lemke's method needs, in case Newton's did.
    assert!(workspace.solve_along_one_path(grasp, load).is_ok());
    let (mut pivots, mut found) = (0, 0);
    let counted = measure(|| {
        for (grasp, load) in &scenes {
            if let Ok(Search::Found(view)) = workspace.solve(grasp, load) {
                found += 1;
                pivots += view.pivots();
            }
            if let Ok(Search::Found(view)) = workspace.solve_along_one_path(grasp, load) {
                pivots += view.pivots();
            }
        }
    });
    // To the round cone Newton's method mostly finds the way without a pivot.
    let most = if workspace.is_round() { 100 } else { 10 * scenes.len() };
    assert!(found * 3 > scenes.len() * 2 && pivots > most, "{found} {pivots}");
    assert_eq!(counted.count_total, 0);
}

#[test]
fn few_contacts_in_the_plane() {
    allocates_only_at_first::<3, 2>(Workspace::default(), 4..12, 300);
}

#[test]
fn few_contacts_in_space() {
    allocates_only_at_first::<6, 3>(Workspace::default(), 4..12, 300);
}

#[test]
fn many_contacts_in_the_plane() {
    allocates_only_at_first::<3, 2>(Workspace::default(), 20..80, 60);
}

#[test]
fn many_contacts_in_space() {
    allocates_only_at_first::<6, 3>(Workspace::default(), 20..80, 60);
}

#[test]
fn on_the_round_cone() {
    allocates_only_at_first::<6, 3>(Workspace::on_the_round_cone(), 2..12, 300);
    allocates_only_at_first::<6, 3>(Workspace::on_the_round_cone(), 20..80, 60);
}

#[test]
fn steps_of_many_contacts_allocate_nothing() {
    let spring = |i: usize| {
        let (area, (sin, cos)) = ((i as f64 + 0.5) / 200.0, (2.399_963_229_728_653 * i as f64).sin_cos());
        spatial::Contact::new([area.sqrt() * cos, area.sqrt() * sin, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([1.0 - area, 0.0, 0.0])
    };
    let disc = spatial::Grasp::new((0..200).map(spring)).expect("a disc");
    let pressed: f64 = (0..200).map(|i| 1.0 - (f64::from(i) + 0.5) / 200.0).sum();
    let pull = |[x, turn]: [f64; 2]| {
        spatial::Wrench::new([x * 0.3 * pressed, 0.0, -pressed], [0.0, 0.0, turn * 0.3 * pressed])
    };
    let cycle = [[0.5, 0.2], [-0.3, 0.2], [0.0, 0.0]].map(|part| spatial::Leg::load_to(pull(part)));
    let mut path = disc.follow_in_steps(pull([0.0; 2]), &cycle, 1e-3).expect("a program");
    path.by_ref().for_each(drop);
    let mut steps = 0;
    for round in 0..4 {
        let counted = measure(|| {
            path.continue_with(&cycle).expect("more of it");
            steps += path.by_ref().count();
        });
        assert!(round == 0 || counted.count_total == 0, "{counted:?} {round}");
    }
    assert!(path.end().is_some_and(|end| matches!(end, spatial::PathEnd::Completed)));
    assert!(steps > 100, "{steps}");
}
