//! A hand may have any number of joints.

use grasp_lcp::{planar, spatial};
use support::jaws::jaw;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// Joints in series with this total stiffness along the normal, N/m, then the contact's own stiffness, N/m, and the command, m.
const JOINTS: f64 = 2e3;
const CONTACT: f64 = 1e4;
const COMMAND: f64 = 0.01;

/// The normal force of the springs of joints and contact in series, N.
fn force() -> f64 {
    COMMAND / (1.0 / JOINTS + 1.0 / CONTACT)
}

#[test]
fn slides_in_a_row_give_way_like_one_in_the_plane() -> Tested {
    for count in [1_u32, 12, 13, 60, 150] {
        let finger = |x: f64| {
            let pad = jaw::<2>(x, [CONTACT, 8e3], 0.5);
            let slide = planar::hand::Joint::prismatic([-x, 0.0]).stiffness(JOINTS * f64::from(count));
            planar::hand::Finger::new((0..count).map(|_| slide.clone())).contact(pad.command([COMMAND, 0.0]))
        };
        let grasp = planar::hand::Hand::new([finger(-1.0), finger(1.0)]).grasp()?;
        let onset = grasp.onset(planar::Wrench::force([0.0, -1.0]))?;
        let (factor, exact) = (onset.factor().ok_or("slides")?, force());
        assert!((factor / exact - 1.0).abs() < 1e-11, "{count}: {factor} {exact}");
    }
    Ok(())
}

#[test]
fn slides_in_a_row_give_way_like_one_in_space() -> Tested {
    for count in [1_u32, 9, 40] {
        let finger = |turn: f64| {
            let (sin, cos) = (turn * std::f64::consts::TAU / 3.0).sin_cos();
            let pad =
                spatial::Contact::new([cos, sin, 0.0], [-cos, -sin, 0.0]).series_stiffness(CONTACT, 8e3);
            let slide =
                spatial::hand::Joint::prismatic([-cos, -sin, 0.0]).stiffness(JOINTS * f64::from(count));
            spatial::hand::Finger::new((0..count).map(|_| slide.clone()))
                .contact(pad.friction(0.5).command([COMMAND, 0.0, 0.0]))
        };
        let grasp = spatial::hand::Hand::new([finger(0.0), finger(1.0), finger(2.0)]).grasp()?;
        let onset = grasp.onset(spatial::Wrench::force([0.0, 0.0, -1.0]))?;
        let (factor, exact) = (onset.factor().ok_or("slides")?, 1.5 * force());
        assert!((factor / exact - 1.0).abs() < 1e-11, "{count}: {factor} {exact}");
    }
    Ok(())
}
