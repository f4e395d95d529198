//! The verdict reports how much the rotation of the squeeze reduces the stiffness. For a pinch this is the closed form `−N / (k_t a)`.

use grasp_lcp::planar::{Grasp, Wrench};
use grasp_lcp::spatial;
use support::jaws::jaw;

#[test]
fn of_a_pinch() -> Result<(), grasp_lcp::Error> {
    let (half, press, tangential) = (0.04, 20.0, 2000.0);
    let jaw = |x: f64| jaw::<2>(x, [5000.0, tangential], 0.9).pressed_with(press);
    let verdict = Grasp::new([jaw(-half), jaw(half)])?.hold(Wrench::new([0.0, 0.0], 0.1))?;
    let part = verdict.left_out.expect("a quarter");
    assert!((part + press / (tangential * half)).abs() < 1e-12, "{part}");
    assert!(verdict.to_string().contains(". CAUTION"), "{verdict}");
    // A translation does not turn the squeeze, and a stiff finger loses little stiffness.
    assert_eq!(Grasp::new([jaw(-half), jaw(half)])?.hold(Wrench::force([0.0, -1.0]))?.left_out, None);
    let stiff = |x: f64| jaw(x).series_stiffness(5e5, 2e5);
    assert_eq!(Grasp::new([stiff(-half), stiff(half)])?.hold(Wrench::new([0.0, 0.0], 0.1))?.left_out, None);
    Ok(())
}

/// In space the reduction is the same about each axis perpendicular to the pinch, and zero about its line.
#[test]
fn of_a_pinch_in_space() -> Result<(), grasp_lcp::Error> {
    let (half, press, tangential) = (0.04, 20.0, 2000.0);
    let jaw = |x: f64| jaw::<3>(x, [5000.0, tangential], 0.9).pressed_with(press);
    let grasp = spatial::Grasp::new([jaw(-half), jaw(half)])?;
    for about in [[0.0, 0.1, 0.0], [0.0, 0.06, -0.08]] {
        let part = grasp.hold(spatial::Wrench::new([0.0; 3], about))?.left_out.expect("a quarter");
        assert!((part + press / (tangential * half)).abs() < 1e-12, "{part}");
    }
    Ok(())
}
