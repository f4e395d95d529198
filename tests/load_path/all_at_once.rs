//! If hundreds of contacts reach the edge of their cones at one load, the load path ends at the known limit load: `μ Σ F_n` for a force, and `μ Σ F_n
//! R` for a torque.

use grasp_lcp::load_path::{Beyond, LossKind, Onset, PathEnd, Ramp};
use grasp_lcp::{planar, spatial};
use support::jaws::around;

const FRICTION: f64 = 0.5;
/// Load at the end of a leg, relative to the limit load.
const OVERLOAD: f64 = 1.25;

/// Springs on a unit circle, each pressed with 1 N.
fn ring(count: usize) -> spatial::Grasp {
    let spring = |i: usize| around::<3>(i, count, 1.0, [1e3, 8e2], FRICTION).pressed_with(1.0);
    spatial::Grasp::new((0..count).map(spring)).expect("a valid ring")
}

/// Two opposed rows of springs that press with 1 N each.
fn rows(count: u32) -> planar::Grasp {
    let spring = |i: u32| {
        let side = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        planar::Contact::new([side, f64::from(i / 2) / f64::from(count)], [-side, 0.0])
            .series_stiffness(1e3, 8e2)
            .friction(FRICTION)
            .pressed_with(1.0)
    };
    planar::Grasp::new((0..count).map(spring)).expect("valid rows")
}

fn ends_at_the_limit<const C: usize>(
    grasp: &grasp_lcp::ask::Grasp<C>,
    limit: grasp_lcp::grasp::Wrench<C>,
    asks_beyond: bool,
) {
    let nothing = grasp_lcp::grasp::Wrench::ZERO;
    let onset = grasp.onset(Ramp::load(nothing, limit)).expect("a finite load");
    let Onset::At(event) = &onset else { panic!("{onset}") };
    assert!((event.factor - 1.0).abs() < 1e-12, "{}", event.factor);
    assert_eq!(event.leaving.len(), grasp.len());
    if asks_beyond {
        let beyond = grasp.beyond(event).expect("its own event");
        assert!(matches!(beyond, Beyond::LimitLoad | Beyond::Ends { .. }), "{beyond:?}");
    }
    let legs = [grasp_lcp::load_path::Leg::load_to(limit * OVERLOAD)];
    let mut path = grasp.follow(nothing, &legs).expect("a finite load");
    assert_eq!(path.by_ref().count(), 0);
    let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{:?}", path.end()) };
    assert!((loss.fraction * OVERLOAD - 1.0).abs() < 1e-12, "{}", loss.fraction);
    assert_eq!((loss.kind, loss.contacts.len()), (LossKind::Corner, grasp.len()));
}

#[test]
fn rings_along_their_axis_and_around_it() {
    for count in [40, 64, 256, 1_024] {
        let (ring, limit) = (ring(count), FRICTION * count as f64);
        ends_at_the_limit(&ring, spatial::Wrench::force([0.0, 0.0, -limit]), count == 256);
        ends_at_the_limit(&ring, spatial::Wrench::new([0.0; 3], [0.0, 0.0, limit]), false);
        let both = limit / 2.0_f64.sqrt();
        ends_at_the_limit(&ring, spatial::Wrench::new([0.0, 0.0, both], [0.0, 0.0, both]), false);
    }
}

#[test]
fn rows_in_the_plane() {
    for count in [40, 64, 256, 1_024, 4_096] {
        ends_at_the_limit(
            &rows(count),
            planar::Wrench::force([0.0, -FRICTION * f64::from(count)]),
            count < 2_000,
        );
    }
}
