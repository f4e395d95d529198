//! A workspace that has held the largest scene allocates nothing: few contacts by Lemke's paths, many by Newton's method and by Lemke's.

use allocation_counter::measure;
use grasp_lcp::grasp::{Grasp, Wrench};
use grasp_lcp::structured::{Search, Workspace};
use std::cell::RefCell;
use support::random::{Spread, for_all, scene};

/// The scenes in both places, largest first.
fn scenes<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    cases: u32,
) -> Vec<(Grasp<D, C>, Wrench<D, C>)> {
    let list = RefCell::new(Vec::new());
    for_all(file!(), cases, &scene::<D, C>(count, Spread::Narrow, 0.3), |scene| {
        list.borrow_mut().push((scene.grasp(), scene.wrench()));
        Ok(())
    });
    let mut list = list.into_inner();
    list.sort_by_key(|(grasp, _)| std::cmp::Reverse(grasp.len()));
    list
}

fn allocates_only_at_first<const D: usize, const C: usize>(count: std::ops::Range<usize>, cases: u32) {
    let scenes = scenes::<D, C>(count, cases);
    let mut workspace = Workspace::default();
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
    assert!(found * 3 > scenes.len() * 2 && pivots > 10 * scenes.len(), "{found} found, {pivots} pivots");
    assert_eq!(counted.count_total, 0);
}

#[test]
fn few_contacts_in_the_plane() {
    allocates_only_at_first::<3, 2>(4..12, 300);
}

#[test]
fn few_contacts_in_space() {
    allocates_only_at_first::<6, 3>(4..12, 300);
}

#[test]
fn many_contacts_in_the_plane() {
    allocates_only_at_first::<3, 2>(20..80, 60);
}

#[test]
fn many_contacts_in_space() {
    allocates_only_at_first::<6, 3>(20..80, 60);
}
