//! Answers with large rotations are labelled as beyond small motions. The rotation is the closed form of a beam on two bonded springs.

use grasp_lcp::{planar, spatial};

/// Stiffness of each spring, N/m, and half their distance, m.
const SPRING: f64 = 1000.0;
const ARM: f64 = 0.05;

/// The moment that turns the beam by an angle: `M = 2 k a² θ`.
fn moment(angle: f64) -> f64 {
    2.0 * SPRING * ARM * ARM * angle
}

#[test]
fn in_the_plane() -> Result<(), grasp_lcp::Error> {
    let end = |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(SPRING, SPRING).bonded();
    let grasp = planar::Grasp::new([end(-ARM), end(ARM)])?;
    for (angle, far) in
        [(0.01, false), (0.09, false), (-0.09, false), (0.11, true), (-0.11, true), (1e9, true)]
    {
        let outcome = grasp.solve(planar::Wrench::new([3.0, -2.0], moment(angle)))?;
        let state = outcome.equilibrium().expect("springs that pull");
        assert!((state.twist.rotation() - angle).abs() <= 1e-12 * angle.abs());
        assert_eq!(state.is_beyond_small_motions(), far, "{angle} rad");
        assert_eq!(state.to_string().contains("small motions"), far);
    }
    Ok(())
}

#[test]
fn in_space_about_any_axis() -> Result<(), grasp_lcp::Error> {
    // Six springs on the axes, each with stiffness k in all directions. Four of them are at the distance a from the axis and add k a² each.
    let ends = [[ARM, 0.0, 0.0], [0.0, ARM, 0.0], [0.0, 0.0, ARM]];
    let contacts = ends
        .into_iter()
        .flat_map(|end| [end, end.map(|x| -x)])
        .map(|end| spatial::Contact::new(end, end.map(|x| -x)).series_stiffness(SPRING, SPRING).bonded());
    let grasp = spatial::Grasp::new(contacts)?;
    for (angle, far) in [(0.09, false), (0.11, true)] {
        for axis in [[0.6, 0.0, 0.8], [0.0, -1.0, 0.0], [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0]] {
            let twisting = axis.map(|x| 2.0 * moment(angle) * x);
            let outcome = grasp.solve(spatial::Wrench::new([40.0, 0.0, 0.0], twisting))?;
            let state = outcome.equilibrium().expect("springs that pull");
            assert_eq!(state.is_beyond_small_motions(), far, "{angle} {axis:?}");
        }
    }
    Ok(())
}
