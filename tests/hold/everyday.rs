//! Every verdict on everyday grippers near their limit is decided and right.

use grasp_lcp::hold::Holding;
use grasp_lcp::{planar, spatial};
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};

const AROUND: [f64; 5] = [0.5, 0.99, 1.01, 1.5, 4.0];

/// The normal forces of opposed pads do not change under a tangential pull: they hold 2 μ N, whatever their springs.
#[test]
fn opposed_pads_in_the_plane_hold_what_friction_allows() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(3);
    for _ in 0..samples(67) {
        let (friction, press, width) =
            (random.between(0.1, 1.0), random.between(1.0, 100.0), random.between(0.005, 0.03));
        // Fingers of less than 2.5 N/mm would buckle under 100 N.
        let stiffness = [random.between(5e3, 5e4), random.between(5e3, 5e4)];
        let pad = planar::SoftFingertip::pad(width, 2, planar::Pressure::Parabolic)?;
        let jaw = |x: f64| jaw::<2>(x, [stiffness[0], stiffness[1]], friction).pressed_with(press);
        let grasp = planar::Grasp::new([pad.contacts(&jaw(-0.04))?, pad.contacts(&jaw(0.04))?].concat())?;
        for part in AROUND {
            let verdict = grasp.hold(planar::Wrench::force([0.0, -2.0 * friction * press * part]))?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            let lost = verdict.lost.expect("within a hundred times").factor;
            assert!((lost * part - 1.0).abs() < 1e-9, "{lost} {part}");
        }
    }
    Ok(())
}

/// Opposed rings in space under a tangential pull have the same limit, for every number of points.
#[test]
fn opposed_rings_in_space_hold_what_friction_allows() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(4);
    for _ in 0..samples(20) {
        let (friction, press, radius) =
            (random.between(0.1, 1.0), random.between(1.0, 100.0), random.between(0.003, 0.015));
        let stiffness = [random.between(500.0, 5e4), random.between(500.0, 5e4)];
        let ring = spatial::SoftFingertip::ring(radius, 12)?;
        let jaw = |x: f64| jaw::<3>(x, [stiffness[0], stiffness[1]], friction).pressed_with(press);
        let grasp = spatial::Grasp::new([ring.contacts(&jaw(-0.03))?, ring.contacts(&jaw(0.03))?].concat())?;
        for part in AROUND {
            let load = spatial::Wrench::force([0.0, 0.0, -2.0 * friction * press * part]);
            let verdict = grasp.hold(load)?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            assert!(matches!(verdict.holding, Holding::Sticks | Holding::Lost), "{verdict}");
        }
    }
    Ok(())
}

/// Fingers around a disc with random springs: the path ends at the reported load, and the limit load of statics is never lower.
#[test]
fn fingers_around_a_disc_are_decided() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(5);
    let mut held = [0; 2];
    for _ in 0..samples(100) {
        let count = random.index(2, 5);
        let finger = |i: usize| {
            let angle = std::f64::consts::TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
            let (sin, cos) = angle.sin_cos();
            planar::Contact::new([0.04 * cos, 0.04 * sin], [-cos, -sin])
                .series_stiffness(random.between(500.0, 5e3), random.between(500.0, 5e3))
                .friction(random.between(0.1, 0.5))
                .pressed_with(random.between(2.0, 20.0))
        };
        let grasp = planar::Grasp::new((0..count).map(finger).collect::<Vec<_>>())?;
        let way = random.between(0.0, std::f64::consts::TAU);
        let load = planar::Wrench::new([way.cos(), way.sin()], random.between(-0.05, 0.05));
        let unit = grasp.hold(load)?;
        let Some(limit) = unit.lost.map(|lost| lost.factor).filter(|limit| *limit > 0.0) else { continue };
        for part in AROUND {
            let verdict = grasp.hold(load * (limit * part))?;
            assert_eq!(verdict.holds(), Some(part < 1.0), "{verdict}");
            held[usize::from(part < 1.0)] += 1;
        }
    }
    assert_met(&[(held[0], 100), (held[1], 66)]);
    Ok(())
}
