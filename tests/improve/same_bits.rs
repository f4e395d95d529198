//! Answers are the same to the last bit for any number of threads.

use grasp_lcp::improve::{Improve, Surface};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use rayon::ThreadPoolBuilder;

#[test]
fn threads_do_not_change_a_bit() {
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = Contact::new([0.05 * cos, 0.05 * sin, 0.01], [-cos, -sin, 0.0]);
        contact.series_stiffness(1e3, 8e2).friction(0.5).pressed_with(9.0)
    };
    let grasp = Grasp::new([0.2, 2.0, 4.5].map(finger)).expect("three fingers");
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], 0.05);
    let loads = vec![Wrench::force([0.3, 0.0, -1.0]), Wrench::force([-0.3, 0.0, -1.0])];
    let question = (0..3).fold(Improve::new(loads), |question, k| question.along(k, can()));
    let on = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let improved = pool.install(|| grasp.improve(&question)).expect("asked well");
        // The debug text has all digits.
        format!("{improved:?}")
    };
    assert_eq!(on(1), on(4));
}
