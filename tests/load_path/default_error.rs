//! The default error of the steps of a path can be met, even if the path folds back.

use crate::pace::{around_a_glass, undecided};
use grasp_lcp::Settings;

/// Near a fold, steps with an error of 1e-13 become too short and some of these paths end undecided. With the default error no path ends undecided.
#[test]
fn no_path_around_a_glass_asks_for_more_than_can_be_had() {
    for (tilt, friction) in [(0.1, 0.5), (0.2, 0.6)] {
        assert_eq!(undecided(&around_a_glass(tilt, friction), &[19, 20], &Settings::default()), 0);
    }
}
