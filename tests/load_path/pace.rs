//! After short steps, the steps along sliding arcs grow again. So a path does not use up the number of steps that a leg may take.

use std::f64::consts::TAU;

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Contact, Grasp, Leg, PathEnd, Wrench};

/// Three unevenly spaced fingers around a glass at three heights, with tilted normals and this friction.
pub(crate) fn around_a_glass(tilt: f64, friction: f64) -> Grasp {
    let finger = |(i, height): (i32, f64)| {
        let (s, c) = (TAU / 3.0 * f64::from(i) + 0.2 * f64::from(i * i)).sin_cos();
        Contact::new([0.03 * c, 0.03 * s, 0.01 * height], [-c, -s, tilt * height])
            .series_stiffness(1000.0, 700.0)
            .friction(friction)
            .command([0.005, 0.0, 0.0])
    };
    Grasp::new([(0, -1.0), (1, 0.0), (2, 1.0)].map(finger)).unwrap()
}

/// The number of undecided paths under pushes from some of 24 sides, horizontal and upward.
pub(crate) fn undecided(grasp: &Grasp, sides: &[u8], settings: &Settings) -> usize {
    let mut count = 0;
    for side in sides {
        let (s, c) = (TAU / 24.0 * f64::from(*side)).sin_cos();
        for up in [0.0, 15.0] {
            let push = Wrench::new([50.0 * c, 50.0 * s, up], [0.3 * s, -0.3 * c, 0.05]);
            let asked = grasp.with(settings);
            let mut path = asked.follow(Wrench::ZERO, &[Leg::load_to(push)]).unwrap();
            path.run();
            count += usize::from(matches!(path.end(), Some(PathEnd::Undecided { .. })));
        }
    }
    count
}

/// A step length that is smaller only by rounding is not treated as shortened, so that all of these paths are decided.
#[test]
fn a_length_that_lost_its_last_digits_was_not_cut_short() {
    let settings = Settings::default().with_step_error(1e-13);
    assert_eq!(undecided(&around_a_glass(0.0, 0.4), &[10, 11, 22], &settings), 0);
}
