//! Loads may act on one body, on all bodies in proportion to their masses, or as weights under gravity.

use grasp_lcp::planar::{Bodies, Body, Contact, Leg, PathEnd, Turn, Wrench};

use support::stacks::grasp;

const MASSES: [f64; 2] = [2.0, 1.0];
const CENTRES: [[f64; 2]; 2] = [[0.05, 0.5], [-0.1, 1.4]];

/// Two boxes on a tray, μ = 0.4 and 0.7.
fn boxes() -> Bodies {
    let face = |y: f64, friction: f64| {
        [-0.5, 0.5].map(|x| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 7e4).friction(friction))
    };
    Bodies::new(
        ["lower", "upper"]
            .into_iter()
            .zip(MASSES)
            .zip(CENTRES)
            .map(|((name, mass), centre)| Body::new(name).mass(mass, centre)),
    )
    .contacts(face(0.0, 0.4).map(|contact| contact.on("lower")))
    .contacts(face(1.0, 0.7).map(|contact| contact.on("upper").against("lower")))
}

/// A weight shared in proportion to masses has the answers of the weights of the single bodies.
#[test]
fn shared_by_mass() {
    let down = [0.0, -9.81];
    let shared = grasp(boxes().shared_by_mass()).solve(boxes().weight(down)).expect("well posed");
    let each = grasp(boxes().gravity(down)).solve(Wrench::ZERO).expect("well posed");
    let (shared, each) =
        (shared.equilibrium().expect("rests").clone(), each.equilibrium().expect("rests").clone());
    for (a, b) in shared.contacts.iter().zip(&each.contacts) {
        assert!((a.force - b.force).norm() < 1e-13 * 30.0, "{a} or {b}");
    }
    // By hand: only the upper box presses on the upper face.
    let [left, right] = [2, 3].map(|i| shared.contacts[i].force_world[1]);
    assert!((left - 9.81 * 0.6).abs() < 1e-12 && (right - 9.81 * 0.4).abs() < 1e-12);
    assert!(shared.residuals.worst() < 1e-14, "{}", shared.residuals.worst());
}

/// On a tilted tray all weights turn together, and the lower box slides at tan θ = μ.
#[test]
fn tilted_tray() {
    let weight = boxes().weight([0.0, -9.81]);
    let at = [0.0, 0.8];
    assert!((weight.about(at).moment()).abs() < 1e-12);
    let tray = grasp(boxes().shared_by_mass());
    let turn = Turn::tilting([0.0, -3.0 * 9.81], at).up_to(1.0);
    let start = turn.load_at(0.0);
    let mut path = tray.follow(start, &[Leg::turn(&turn)]).expect("well posed");
    path.run();
    let lost = path.end().and_then(PathEnd::loss).expect("slides off").fraction;
    assert!((lost - 0.4f64.atan()).abs() < 1e-12, "{lost}");
}

/// Each body receives its share of a force, and of the moment about the common centre of mass.
#[test]
fn moments_are_shared_too() {
    let tray = grasp(boxes().shared_by_mass().gravity([0.0, -100.0]));
    let state = tray.solve(Wrench::new([3.0, 0.0], 0.9)).expect("well posed");
    let state = state.equilibrium().expect("rests");
    // The upper box has a third of the force at its centre, and a third of the remaining moment.
    let centre = [0.0, 0.8];
    let left = 0.9 - (centre[0] * 0.0 - centre[1] * 3.0);
    let moment = -CENTRES[1][1] + left / 3.0 - 100.0 * CENTRES[1][0];
    let carried: f64 = [2, 3]
        .map(|i| {
            let (point, force) = (tray.contacts()[i].point(), state.contacts[i].force_world);
            point[0] * force[1] - point[1] * force[0]
        })
        .iter()
        .sum();
    assert!((carried + moment).abs() < 1e-12, "{carried} and {moment}");
}
