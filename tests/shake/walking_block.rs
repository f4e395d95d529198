//! A block on two feet is rocked from one foot to the other under a pull Q. It walks by 2 (Q - μ (P - 2 m)) / k_t in every cycle, or comes to rest.
//!
//! The feet carry the normal forces P/2 ± m in turn. While a foot carries P/2 - m, the other foot takes over the friction that the first foot cannot
//! hold. The other foot slides when the block is rocked back. In each half cycle both feet together carry at most μ (P/2 - m) plus their residual
//! force.

use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
use grasp_lcp::shake::Repeats;
use proptest::prelude::*;
use support::samples::config;

/// The verdict on a block of weight `p` under a pull `q`, rocked so that each foot in turn carries `m` less.
fn walk(p: f64, q: f64, m: f64, mu: f64, k_t: f64) -> Repeats<2> {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(3.0 * k_t, k_t).friction(mu);
    let block = Grasp::new([foot(-1.0), foot(1.0)]).expect("well posed");
    let pulled = Wrench::new([q, -p], 0.0);
    // The feet are 2 m apart, so a moment makes one foot carry half of the moment more, and the other half of the moment less.
    let cycle =
        [2.0 * m, -2.0 * m].map(|moment| Leg::there_and_back(Wrench::new([0.0, 0.0], moment))).concat();
    block.shake(pulled, &cycle).expect("well posed").repeats
}

proptest! {
    #![proptest_config(config(200))]
    #[test]
    fn walks_or_rests_as_the_closed_form_says(
        p in 1.0..100.0, part in 0.02..0.98, rocked in 0.05..0.45, mu in 0.1..1.5, k_t in 1e2..1e6,
    ) {
        let (q, m): (f64, f64) = (part * mu * p, rocked * p);
        let by = 2.0 * (q - mu * (p - 2.0 * m)) / k_t;
        match walk(p, q, m, mu, k_t) {
            Repeats::Walks { by: motion, .. } => {
                let moved = motion[0].twist.translation()[0];
                prop_assert!((moved - by).abs() <= 1e-12 * p / k_t, "{moved} {by}");
            }
            Repeats::Rests { .. } | Repeats::DiesOut { .. } => prop_assert!(by <= 1e-9 * p / k_t, "rests, {by}"),
            other => prop_assert!(false, "{other:?}, {by}"),
        }
    }
}
