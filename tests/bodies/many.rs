//! In piles of many bodies the first to slide is known. The bodies above or beside each cut are in balance, with sums of forces computed here.

use grasp_lcp::planar::{Grasp, Wrench};
use grasp_lcp::spatial;
use support::piles::{books, wall};
use support::spatial_piles::spatial_wall;

/// The index of the nearest multiple of `apart`.
fn nearest(x: f64, apart: f64) -> usize {
    (0..1000_u32).find(|k| x < (f64::from(*k) + 0.5) * apart).map_or(0, |k| k as usize)
}

/// The sum of contact forces for each index that `place` assigns to a contact point. Also checks that all forces are in their cones.
fn sums(grasp: &Grasp, (load, mu): (&Wrench, f64), place: impl Fn([f64; 2]) -> usize) -> Vec<[f64; 2]> {
    let outcome = grasp.solve(load).expect("well posed");
    let equilibrium = outcome.equilibrium().expect("stands");
    let mut sums = Vec::new();
    for (contact, answer) in grasp.contacts().iter().zip(&equilibrium.contacts) {
        let (normal, friction) = (answer.force[0], answer.force[1].abs());
        assert!(normal >= 0.0 && friction <= mu * normal * (1.0 + 1e-12));
        let at = place([contact.point()[0], contact.point()[1]]);
        sums.resize(sums.len().max(at + 1), [0.0; 2]);
        (0..2).for_each(|a| sums[at][a] += answer.force_world[a]);
    }
    sums
}

/// The first brick of the top row carries no other brick, so it slides at a force of μ m g.
#[test]
fn the_top_brick_of_a_wall_slides_first() {
    for rows in [5, 8, 10, 20] {
        let grasp = wall(rows).grasp().expect("well posed");
        let push = Wrench::force_at([5.0, 0.0], [0.5, 0.5 * rows as f64 - 0.1]);
        let verdict = grasp.hold(push).expect("well posed");
        let limit = 0.6 * 2.0 * 9.81 / 5.0;
        assert_eq!(verdict.holds(), Some(true), "{rows}: {verdict}");
        assert!((verdict.held_to - limit).abs() < 1e-12 * limit, "{rows}: {} of {limit}", verdict.held_to);
        // A cut through the wall below a row: the bricks above it stand on the row below, and half bricks at both ends stand on the ground.
        let on_ground = |[x, y]: [f64; 2]| {
            let shift = 0.5 * ((nearest(y, 0.5) + 1) % 2) as f64;
            y < 0.1 || x < shift || x > shift + rows as f64
        };
        let place = |at: [f64; 2]| 2 * nearest(at[1], 0.5) + usize::from(on_ground(at));
        let places = sums(&grasp, (&push, 0.6), place);
        let of = |place: usize| places.get(place).copied().unwrap_or_default();
        for row in 0..rows {
            let weight = 2.0 * 9.81 * ((rows - row) * rows) as f64;
            let grounds = (row..rows).map(|row| 2 * row + 1);
            let carried = grounds.chain([2 * row]).map(of).fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
            let off = (carried[1] - weight).abs().max((carried[0] + 5.0).abs());
            assert!(off < 1e-12 * weight, "{row}: {carried:?} {weight}");
        }
    }
}

/// The same wall in space, with four points below each half brick and friction on the round cone.
#[test]
fn the_top_brick_of_a_wall_in_space_slides_first() {
    for rows in [3, 5] {
        let grasp = spatial_wall(rows).grasp().expect("well posed");
        let push = spatial::Wrench::force_at([5.0, 0.0, 0.0], [0.5, 0.0, 0.5 * rows as f64 - 0.1]);
        let verdict = grasp.hold(push).expect("well posed");
        let limit = 0.6 * 2.0 * 9.81 / 5.0;
        assert_eq!(verdict.holds(), Some(true), "{rows}: {verdict}");
        assert!((verdict.held_to - limit).abs() < 1e-9 * limit, "{rows}: {} of {limit}", verdict.held_to);
        let outcome = grasp.solve(push).expect("well posed");
        let state = outcome.equilibrium().expect("stands");
        let mut on_ground = [0.0; 3];
        for (contact, answer) in grasp.contacts().iter().zip(&state.contacts) {
            let [normal, a, b]: [f64; 3] = answer.force.into();
            assert!(normal >= 0.0 && a.hypot(b) <= 0.6 * normal * (1.0 + 1e-12));
            let at = [contact.point()[0], contact.point()[2]];
            let shift = 0.5 * ((nearest(at[1], 0.5) + 1) % 2) as f64;
            if at[1] < 0.1 || at[0] < shift || at[0] > shift + rows as f64 {
                (0..3).for_each(|k| on_ground[k] += answer.force_world[k]);
            }
        }
        let weight = 2.0 * 9.81 * (rows * rows) as f64;
        let off = [on_ground[0] + 5.0, on_ground[1], on_ground[2] - weight];
        assert!(off.iter().all(|x| x.abs() < 1e-11 * weight), "{on_ground:?} {weight}");
    }
}

/// From one face of a row of books to the next, the shear force grows by the weight of a book, and the pressing force is constant.
#[test]
fn a_long_row_of_books_is_carried() {
    for count in [9, 25, 60] {
        let grasp = books(count).grasp().expect("well posed");
        let weight = 9.81 * count as f64;
        // The compliances of sixty books add up to a rotation beyond small motions.
        let grasp = grasp.with(&grasp.settings().with_small_motions(1.0, 1.0));
        let verdict = grasp.hold(Wrench::force([0.0, -0.1 * weight])).expect("well posed");
        assert_eq!(verdict.holds(), Some(true), "{count}: {verdict}");
        let faces = sums(&grasp, (&Wrench::ZERO, 0.5), |[x, _]| nearest(x, 0.03));
        for (face, [x, y]) in faces.iter().enumerate().take(count) {
            let carried = faces[0][1] - 9.81 * face as f64;
            assert!((y - carried).abs() < 1e-12 * weight, "{count} {face} {y} {carried}");
            assert!((x - faces[0][0]).abs() < 1e-12 * faces[0][0], "{count}, {face}: {x}");
        }
    }
}
