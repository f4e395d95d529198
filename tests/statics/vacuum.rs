//! In static questions the vacuum of suction cups acts besides the contact forces. Answers agree with sums over directions and balances by hand.

use std::f64::consts::PI;

use grasp_lcp::Error;
use grasp_lcp::planar::{Closure, Contact, Grasp, Wrench};
use grasp_lcp::statics::{Budget, LoadLimit, WrenchScale};
use support::jaws::jaw;

const VACUUM: f64 = 60.0;
const FRICTION: f64 = 0.5;
/// Distance of a cup from the middle, m.
const ASIDE: f64 = 0.1;
/// Number of steps of a grid of directions, from pole to pole.
const STEPS: i32 = 200;

type Tested = Result<(), Error>;

/// Two cups on top of a plate.
fn cups() -> Result<Grasp, Error> {
    let cup = |x: f64| {
        Contact::new([x, 0.0], [0.0, -1.0])
            .name("cup")
            .series_stiffness(5e3, 5e3)
            .friction(FRICTION)
            .suction(VACUUM)
    };
    Grasp::new([cup(-ASIDE), cup(ASIDE)])
}

/// The radius of the largest ball of balanced wrenches is the minimum of the support function over many directions. Each lip pushes with any force up
/// to `most`, and each vacuum pulls with V.
#[test]
fn the_ball_is_about_no_load_and_beside_the_vacuum() -> Tested {
    for most in [70.0, 100.0, 400.0] {
        let reach = |v: [f64; 3]| {
            let cup = |x: f64| {
                // Moments are divided by 1 m; the normal is −y.
                let (normal, along) = (-(v[1] + v[2] * x), v[0]);
                (normal + FRICTION * along.abs()).max(0.0) * most - VACUUM * normal
            };
            cup(-ASIDE) + cup(ASIDE)
        };
        let scale = WrenchScale { about: [0.0, 0.0], length: 1.0 };
        let ball = cups()?.statics().ferrari_canny_scaled(Budget::Each(most), &scale)?;
        assert!(ball.at_least > 0.0 && ball.at_most - ball.at_least < 1e-6 * most, "{ball:?}");
        // No direction of the grid has a lower value of the support function, and the reported weakest direction has exactly this value.
        let told = ball.weakest.components();
        let farthest = reach([-told[0], -told[1], -told[2]]);
        assert!((farthest - ball.at_most).abs() < 1e-9 * most, "{farthest} {ball:?}");
        let angle = |k: i32| PI * f64::from(k) / f64::from(STEPS);
        for (polar, azimuth) in (0..=STEPS).flat_map(|i| (0..2 * STEPS).map(move |j| (angle(i), angle(j)))) {
            let (sin, cos) = azimuth.sin_cos();
            let there = reach([polar.sin() * cos, polar.sin() * sin, polar.cos()]);
            assert!(there > ball.at_least * (1.0 - 1e-9), "{polar} {azimuth} {there}");
        }
    }
    Ok(())
}

/// If the lips may not push as much as the vacuum pulls, even zero load is not balanced.
#[test]
fn lips_must_bear_the_vacuum() -> Tested {
    let ball = cups()?.statics().ferrari_canny(Budget::Each(50.0))?;
    assert_eq!((ball.at_least, ball.at_most), (0.0, 0.0));
    let limit = cups()?.statics().load_limit(Wrench::ZERO, Wrench::force([0.0, -1.0]), Budget::Each(50.0))?;
    // The vacuum pulls with 20 N more than the lips may push. Only a load could take this off the lips, so at zero load nothing is balanced.
    assert!(matches!(limit, LoadLimit::NoBase { .. }), "{limit:?}");
    Ok(())
}

#[test]
fn limits_along_a_load() -> Tested {
    let plate = cups()?;
    for (load, expected) in [
        // A load that pulls the plate off is limited by both vacuums, and a load along the plate by the friction of the lips.
        (Wrench::force([0.0, -1.0]), 2.0 * VACUUM),
        (Wrench::force([1.0, 0.0]), FRICTION * 2.0 * VACUUM),
        // A load W at one cup peels the plate about the other lip: W (a + b) = 2 a V with b = a.
        (Wrench::force_at([0.0, -1.0], [ASIDE, 0.0]), VACUUM),
    ] {
        let limit = plate.statics().load_limit(Wrench::ZERO, load, Budget::Each(1e3))?;
        let LoadLimit::Factor { at_least, at_most, .. } = limit else { panic!("{limit:?}") };
        assert!(
            (at_least - expected).abs() < 1e-6 && (at_most - expected).abs() < 1e-6,
            "{at_least}..{at_most}"
        );
    }
    Ok(())
}

#[test]
fn closure_does_not_rest_on_a_vacuum() -> Tested {
    let refused = cups()?.statics().force_closure().unwrap_err();
    let Error::Vacuum { question: "force_closure", contact } = &refused else { panic!("{refused}") };
    assert_eq!(contact.to_string(), "0 (cup)");
    assert!(matches!(cups()?.statics().form_closure(), Err(Error::Vacuum { .. })));
    // Two jaws are in force closure with or without a cup.
    let jaw = |x: f64| jaw::<2>(x, [1e3, 1e3], FRICTION);
    let cup =
        Contact::new([0.0, 0.5], [0.0, -1.0]).series_stiffness(1e3, 1e3).friction(FRICTION).suction(VACUUM);
    let jaws = Grasp::new([jaw(-1.0), jaw(1.0), cup])?;
    assert!(matches!(jaws.statics().force_closure()?, Closure::Closed { .. }));
    Ok(())
}
