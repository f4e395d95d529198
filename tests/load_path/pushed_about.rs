//! A rod pinched between two fingertips turns freely about the line between them. A third finger on it turns it without force.
//!
//! The two fingers press along x at ±1, and the third touches at (0, r, 0) from above. If it moves down by a, the rod turns by -a/r. A moment about x
//! against this rotation needs the force F = M/r. A moment in the other direction is not resisted.

use grasp_lcp::load_path::{LossKind, PathEnd};
use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
use proptest::prelude::*;
use support::jaws::jaw;
use support::random::for_all;

const PRESS: f64 = 5.0;

fn rod(k: f64, arm: f64) -> Result<Grasp, grasp_lcp::Error> {
    let tip = |x: f64| jaw::<3>(x, [k, 0.7 * k], 0.6).command([PRESS / k, 0.0, 0.0]);
    let third = Contact::new([0.0, arm, 0.0], [0.0, 0.0, -1.0]).series_stiffness(2.0 * k, k).friction(0.3);
    Grasp::new([tip(1.0), tip(-1.0), third])
}

#[test]
fn a_finger_turns_a_rod_without_force() {
    for_all(file!(), 60, &(100.0..5000.0_f64, 0.2..0.9_f64, 1e-4..5e-3_f64), |(k, arm, a)| {
        let grasp = rod(k, arm).unwrap();
        let down = || Leg::commands_by(vec![[0.0; 3], [0.0; 3], [a, 0.0, 0.0]]);
        let mut path = grasp.follow(Wrench::ZERO, &[down()]).unwrap();
        path.run();
        prop_assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        for part in [0.25, 0.5, 1.0] {
            let state = path.state_at(0, part).unwrap();
            let [about, ..] = state.twist.rotation();
            prop_assert!((about + part * a / arm).abs() < 1e-12, "{about} and {}", -part * a / arm);
            prop_assert!((state.contacts[0].normal_force() - PRESS).abs() < 1e-12);
            prop_assert!(state.contacts[2].force.norm() < 1e-12);
        }
        // The third finger resists a moment that turns the rod against this finger.
        let moment = 0.1 * arm;
        let mut held = grasp.follow(Wrench::ZERO, &[down(), turn(moment)]).unwrap();
        held.run();
        prop_assert!(matches!(held.end(), Some(PathEnd::Completed)), "{:?}", held.end());
        prop_assert!((held.state().unwrap().contacts[2].normal_force() - 0.1).abs() < 1e-9);
        let mut lost = grasp.follow(Wrench::ZERO, &[down(), turn(-moment)]).unwrap();
        lost.run();
        let loss = lost.end().and_then(PathEnd::loss).unwrap();
        prop_assert!(loss.leg == 1 && loss.fraction == 0.0);
        prop_assert!(matches!(loss.kind, LossKind::GivesWay | LossKind::Corner));
        Ok(())
    });
}

fn turn(moment: f64) -> Leg {
    Leg::load_by(Wrench::new([0.0; 3], [moment, 0.0, 0.0]))
}
