//! If several equilibria exist on the round cone, the solver finds an equilibrium near the elastic trial state, and no equilibrium at displacements
//! so large that all digits are lost.

use std::f64::consts::TAU;

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};

fn at_rest(contacts: [Contact; 3]) -> Equilibrium<3> {
    let grasp = Grasp::new(contacts).unwrap();
    let outcome = grasp.solve(Wrench::ZERO).unwrap();
    let answer = outcome.equilibrium().unwrap_or_else(|| panic!("{outcome:?}")).clone();
    assert!(answer.residuals.worst() < 1e-14, "{:?}", answer.residuals);
    answer
}

/// Three fingers press obliquely on a ball with 10 N each. A second equilibrium has the ball outside of all fingers, without contact.
#[test]
fn fingers_that_press_go_on_to_press() {
    let finger = |angle: f64, height: f64, up: f64| {
        let (sin, cos) = angle.sin_cos();
        Contact::new([cos, sin, height], [-cos, -sin, up])
            .series_stiffness(1000.0, 800.0)
            .friction(0.4)
            .command([0.01, 0.0, 0.0])
    };
    for [a, b, c] in [
        [[-0.2, 0.1, -0.1], [2.2, 0.0, -0.3], [4.2, 0.2, -0.1]],
        [[0.2, 0.0, -0.1], [1.9, -0.2, -0.2], [4.2, 0.1, -0.2]],
    ] {
        let answer = at_rest([a, b, c].map(|[angle, height, up]| finger(angle, height, up)));
        for contact in &answer.contacts {
            assert!(contact.normal_force() > 4.0, "{answer:?}");
        }
    }
}

/// Three fingers squeeze a plug on its flanks. With μ just below the tangent of half its angle it slips out until no finger presses. Each finger is
/// compressed by F/k_n along the normal, so that the plug moves by F/(k_n sin) along the axis.
#[test]
fn a_plug_beside_its_locking_angle_does_not_fly_away() {
    let (sin, cos) = 0.3_f64.sin_cos();
    let (squeeze, normal) = (5.0, 1000.0);
    let finger = |i: u32, friction: f64| {
        let (y, x) = (TAU * f64::from(i) / 3.0).sin_cos();
        Contact::new([x, y, 0.0], [-cos * x, -cos * y, sin])
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(normal, 800.0)
            .friction(friction)
            .command([squeeze / normal, 0.0, 0.0])
    };
    for less in [1e-3, 1e-6, 1e-8, 1e-9, 3e-10, 1e-10] {
        let friction = (sin / cos) * (1.0 - less);
        let answer = at_rest([0, 1, 2].map(|i| finger(i, friction)));
        assert!(answer.contacts.iter().all(|c| c.normal_force() == 0.0), "{less}: {answer:?}");
        let [x, y, z] = answer.twist.translation();
        assert!((z * sin * normal / squeeze - 1.0).abs() < 1e-9 && x.hypot(y) < 1e-9, "{less}: {x} {y} {z}");
    }
}
