//! A body that slides to a stop then turns about this stop, until a second stop, which has more play, carries a part of the load.

use grasp_lcp::equilibrium::ContactAnswer;
use grasp_lcp::load_path::Ramp;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};

/// A box of 20 kg on four feet is pushed towards two stops with unequal play. It slides to the first stop, turns about this stop, and rests against
/// both stops. By statics the stops then carry the push, less at most the friction of the feet.
#[test]
fn a_box_turns_on_to_the_second_stop() {
    for mu in [0.0, 0.001, 0.01, 0.02, 0.021, 0.0215, 0.023, 0.03, 0.05] {
        rests_against(&[stop(0.1, 2e-4, mu), stop(-0.1, 5e-4, mu)], mu, 0.0);
    }
    // Beside a third stop the path reaches a fold, and the box slowly moves on to another equilibrium.
    let side = Contact::new([0.0, 0.25, 0.05], [0.0, -1.0, 0.0]).series_stiffness(1e6, 1e6).friction(0.154);
    rests_against(
        &[stop(0.1, 2.8e-4, 0.154), stop(-0.1, 5.5e-4, 0.154), side.clearance(3.78e-4)],
        0.011,
        1e-3,
    );
}

fn stop(y: f64, play: f64, mu: f64) -> Contact {
    let stop = Contact::new([0.25, y, 0.05], [-1.0, 0.0, 0.0]).series_stiffness(1e6, 1e6).friction(mu);
    stop.clearance(play)
}

/// Asserts that the box on feet with this friction holds a push at the distance `y` from its middle. The stops carry the push, less at most the
/// friction of the feet.
fn rests_against(stops: &[Contact], mu: f64, y: f64) {
    let foot =
        |[x, y]: [f64; 2]| Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e6, 1e6).friction(mu);
    let feet = [[-0.2, -0.2], [0.2, -0.2], [0.2, 0.2], [-0.2, 0.2]].map(foot);
    let grasp = Grasp::new(feet.into_iter().chain(stops.iter().cloned())).expect("well posed");
    let weight = Wrench::force_at([0.0, 0.0, -196.2], [0.0, 0.0, 0.1]);
    let push = Wrench::force_at([100.0, 0.0, 0.0], [0.0, y, 0.05]);
    let verdict = grasp.hold(Ramp::load(weight, push)).expect("well posed");
    assert_eq!(verdict.holds(), Some(true), "{mu}: {verdict}");
    let state = verdict.state.as_ref().expect("held");
    let carried: f64 = state.contacts[4..].iter().map(ContactAnswer::normal_force).sum();
    assert!((100.0 - 196.2 * mu - 1e-9..=100.0 + 1e-9).contains(&carried), "{mu}: {carried}");
}
