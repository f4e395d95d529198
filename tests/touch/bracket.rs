//! Loads of a gripper on a bracket, computed from the mesh, agree with hand calculations.

use grasp_lcp::spatial::{Grasp, Wrench};

use crate::shapes::{bracket_in_metres, jaw};

/// Two pads on both sides of the upright leg, which press with 40 N.
fn gripped(strips: [usize; 2]) -> Grasp {
    let part = bracket_in_metres();
    let (left, right) = (
        jaw("left", [-0.01, 0.025, 0.015], 1.0, strips, &part),
        jaw("right", [0.09, 0.025, 0.015], -1.0, strips, &part),
    );
    assert_eq!((left.missing(), right.missing()), (0.0, 0.0));
    Grasp::new([left.into_contacts(), right.into_contacts()].concat()).expect("a grasp")
}

fn lost_at(strips: [usize; 2], load: Wrench) -> f64 {
    gripped(strips).hold(load * 100.0).expect("answered").lost.expect("is lost").factor * 100.0
}

#[test]
fn the_points_lie_on_the_leg() {
    let grasp = gripped([1, 1]);
    for contact in grasp.contacts() {
        let (point, face) =
            (contact.point(), if contact.label_text(0).starts_with("left") { 0.0 } else { 0.006 });
        assert!((point[0] - face).abs() < 1e-16, "{point}");
        assert!(
            (point[1] - 0.025).abs() < 0.01 + 1e-15 && (point[2] - 0.015).abs() < 0.015 + 1e-15,
            "{point}"
        );
    }
}

#[test]
fn a_pull_across_takes_the_friction_of_both_pads() {
    for pull in [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let lost = lost_at([1, 1], Wrench::force_at(pull, [0.003, 0.025, 0.015]));
        assert!((lost - 40.0).abs() < 1e-9, "{lost}");
    }
}

/// The limit torque is 2 μ N r̄, where r̄ = 9.6811 mm is the mean distance of a rectangle's points from its centre.
#[test]
fn a_torque_takes_the_mean_distance_of_the_pads() {
    let lost = lost_at([2, 2], Wrench::new([0.0; 3], [1.0, 0.0, 0.0]).about([-0.003, -0.025, -0.015]));
    assert!((lost / 0.38724 - 1.0).abs() < 0.01, "{lost}");
}

#[test]
fn its_weight_is_held() {
    let part = bracket_in_metres().of_density(7850.0).expect("closed");
    let (weight, centre) = (9.81 * part.mass().expect("of steel"), part.centre_of_mass().expect("closed"));
    for down in [[0.0, -weight, 0.0], [0.0, 0.0, -weight]] {
        let verdict = gripped([1, 1]).hold(Wrench::force_at(down, centre)).expect("answered");
        assert_eq!(verdict.holds(), Some(true), "{verdict}");
    }
}

/// The leg of the bracket ends at 40 mm. Of a pad of 20 mm centred at 40 mm, half is beyond this end, and of a pad centred at 45 mm three quarters.
/// The error is up to the share of the points at the border of the pad.
#[test]
fn a_pad_beyond_the_end_of_the_leg_misses_in_part() {
    let part = bracket_in_metres();
    for (y, missing, off) in [(0.04, 0.5, 1e-12), (0.045, 0.75, 0.07)] {
        let touched = jaw("left", [-0.01, y, 0.015], 1.0, [2, 2], &part);
        assert!((touched.missing() - missing).abs() < off, "{}", touched.missing());
        let force: f64 =
            touched.contacts().iter().map(|c| c.series_stiffness_of_axes()[0] * c.commanded()[0]).sum();
        assert!((force - 40.0).abs() < 1e-10, "{force}");
    }
}
