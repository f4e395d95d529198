//! Paths can start without load and forces, at contacts that just touch.

use std::f64::consts::TAU;

use grasp_lcp::spatial::{Contact, Grasp, Leg, LoadPath, PathEnd, Wrench};
use support::ends::limit_load;

const RADIUS: f64 = 0.03;
const MU: f64 = 0.5;

/// Contacts without normal force on a circle, with normals up or inwards.
fn around(count: u32, up: bool) -> Grasp {
    let contact = |i: u32| {
        let (s, c) = (TAU / f64::from(count) * f64::from(i)).sin_cos();
        let normal = if up { [0.0, 0.0, 1.0] } else { [-c, -s, 0.0] };
        Contact::new([RADIUS * c, RADIUS * s, 0.0], normal).series_stiffness(1000.0, 700.0).friction(MU)
    };
    Grasp::new((0..count).map(contact)).unwrap()
}

fn follow(grasp: &Grasp, load: Wrench) -> LoadPath<'_> {
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(load)]).unwrap();
    path.run();
    path
}

/// A plate lies on contacts that touch it from below. They carry every load within the friction cone that acts within the footprint, and no other.
#[test]
fn a_plate_without_weight_holds_all_or_nothing() {
    for count in 3..=6 {
        let plate = around(count, true);
        // Held loads: a force down, a force down and sideways within friction, and a force down off the middle.
        for load in [
            Wrench::force([0.0, 0.0, -1.0]),
            Wrench::force([0.8 * MU, 0.0, -1.0]),
            Wrench::new([0.0, 0.0, -1.0], [0.0, 0.4 * RADIUS, 0.0]),
        ] {
            let path = follow(&plate, load);
            let end = path.end().unwrap();
            assert!(matches!(end, PathEnd::Completed), "{count} {load:?}: {end:?}");
        }
        // Lost loads: forces up, sideways, down and sideways beyond friction, and down outside the plate, and a torque.
        for load in [
            Wrench::force([0.0, 0.0, 1.0]),
            Wrench::force([1.0, 0.0, 0.0]),
            Wrench::force([1.2 * MU, 0.0, -1.0]),
            Wrench::new([0.0, 0.0, -1.0], [0.0, 1.2 * RADIUS, 0.0]),
            Wrench::new([0.0; 3], [0.0, 0.0, 0.01]),
        ] {
            let path = follow(&plate, load);
            let loss = limit_load(&path);
            assert_eq!((loss.leg, loss.fraction), (0, 0.0));
        }
    }
}

/// Fingers around a glass without squeeze do not carry it, although they could with a squeeze.
#[test]
fn fingers_that_do_not_press_carry_nothing() {
    for count in [2, 3] {
        let grasp = around(count, false);
        let path = follow(&grasp, Wrench::force([0.0, 0.0, -1.0]));
        assert_eq!(limit_load(&path).fraction, 0.0, "{count}");
    }
}

/// If the forces can grow in proportion to the load, an equilibrium exists under every load. The path may be undecided, but it is never lost.
#[test]
fn what_grows_from_nothing_is_not_lost() {
    for count in 3..=6 {
        let (glass, push) = (around(count, false), Wrench::force([1.0, 0.2, 0.0]));
        assert!(glass.solve(push).unwrap().equilibrium().is_some());
        let path = follow(&glass, push);
        let end = path.end().unwrap();
        assert!(end.loss().is_none(), "{count}: {end:?}");
    }
}

/// A cylinder of weight w and radius r rolls freely on a floor and just touches a rough wall. A couple that rolls the cylinder into the wall is held
/// up to `w r μ(1 + μ)/(1 + μ²)`, where floor and wall slide. Nothing holds a couple that rolls it away from the wall. At the start the cylinder is
/// at its given position along the floor.
#[test]
fn a_cylinder_that_touches_a_wall_is_held_by_it() {
    use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};

    let (w, r) = (5.0, 0.2);
    for mu in [0.1, 0.3, 0.8] {
        for [kn, kt] in [[1e3, 7e2], [1e5, 1e6]] {
            let touch = |point: [f64; 2], normal: [f64; 2]| {
                Contact::new(point, normal).series_stiffness(kn, kt).friction(mu)
            };
            let grasp = Grasp::new([touch([0.0, -r], [0.0, 1.0]), touch([r, 0.0], [-1.0, 0.0])]).unwrap();
            let most = w * r * mu * (1.0 + mu) / (1.0 + mu * mu);
            let weight = Wrench::force([0.0, -w]);
            let at_rest = grasp.solve(weight).unwrap();
            assert!(at_rest.equilibrium().unwrap().contacts[1].gap.abs() < 1e-15);
            for (couple, limit) in [(-1.0, 1.0), (1.0, 0.0)] {
                let load = Wrench::new([0.0, -w], 2.0 * couple * most);
                let mut path = grasp.follow(weight, &[Leg::load_to(load)]).unwrap();
                path.run();
                let loss = path.end().unwrap().loss().unwrap();
                assert!((2.0 * loss.fraction - limit).abs() < 1e-12, "{mu} {couple}: {loss:?}");
            }
        }
    }
}
