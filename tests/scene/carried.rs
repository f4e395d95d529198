//! The load of a body that an arm carries, written in a scene, is the load that the library computes.

use grasp_lcp::grasp::Wrench;
use grasp_lcp::{planar, spatial};
use serde_json::{Value, json};

fn read<const C: usize>(written: Value) -> Wrench<C> {
    serde_json::from_value(written).expect("a wrench")
}

fn refused<const C: usize>(written: Value) -> String {
    serde_json::from_value::<Wrench<C>>(written).expect_err("no wrench").to_string()
}

#[test]
fn a_mass_pulls_with_its_weight_and_against_the_arm() {
    let hangs = read::<3>(json!({ "mass": 2, "at": [0.1, 0, 0] }));
    assert_eq!(hangs, spatial::Wrench::force_at([0.0, 0.0, -19.62], [0.1, 0.0, 0.0]));
    let jerked = read::<2>(
        json!({ "mass": 2, "gravity": [0, 0], "accelerated": [3, 0], "force": [1, 0], "moment": 0.5 }),
    );
    assert_eq!(jerked, planar::Wrench::new([-5.0, 0.0], 0.5));
}

/// 90°/s are π/2 rad/s. With the distance r = 0.5 m from the axis, the load for each kilogram is (π/2)² · 0.5 newtons outwards, and α r tangentially.
#[test]
fn an_arm_that_turns_throws_it_outwards() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let degrees =
        read::<2>(json!({ "mass": 1, "at": [0.5, 0], "gravity": [0, 0], "turning": { "velocity_deg": 90 } }));
    let radians = read::<2>(
        json!({ "mass": 1, "at": [1.5, 2], "gravity": [0, 0], "turning": { "about": [1, 2], "velocity_rad": quarter } }),
    );
    assert!(
        (degrees.resultant()[0] - 0.5 * quarter * quarter).abs() < 1e-15 && degrees.resultant()[1] == 0.0
    );
    assert!((radians.about([1.0, 2.0]) - degrees).to_vector().norm() < 1e-15);
    let faster = json!({ "mass": 1, "at": [0.5, 0, 0], "gravity": [0, 0, 0], "inertia": [0.1, 0.2, 0.3], "turning": { "acceleration_rad": [0, 0, 2] } });
    assert_eq!(read::<3>(faster), spatial::Wrench::new([0.0, -1.0, 0.0], [0.0, 0.0, -0.5 - 0.6]));
}

#[test]
fn what_does_not_fit_is_refused_with_a_reason() {
    let cases = [
        (json!({ "turning": { "velocity_deg": 90 } }), "turning: ", "needs a `mass`"),
        (json!({ "gravity": [0, -9] }), "gravity: ", "needs a `mass`"),
        (json!({ "mass": -1 }), "mass ", "is -1"),
        (json!({ "mass": 1, "turning": { "acceleration_deg": 90 } }), "payload: inertia", "missing"),
        (
            json!({ "mass": 1, "turning": { "velocity_deg": 90, "velocity_rad": 1 } }),
            "velocity_deg and",
            "velocity_rad: ",
        ),
        (json!({ "mass": 1, "turning": { "velocity_deg": [0, 0, 90] } }), "velocity_deg: ", "3 numbers"),
    ];
    for (written, field, fault) in cases {
        let message = refused::<2>(written.clone());
        assert!(message.starts_with(field) && message.contains(fault), "{written}: {message}");
    }
    let wobbles = refused::<3>(json!({ "mass": 1, "turning": { "velocity_deg": [0, 0, 90] } }));
    assert!(wobbles.starts_with("payload: inertia"), "{wobbles}");
}
