//! Largest angles, and largest squeezes under a force of any direction, where the normal forces make the held bar buckle.
//!
//! Two fingers at x = ±a with tangential stiffness k press a bar with N each. The bar resists turning with the stiffness `2 k a²`, of which the
//! fingers' forces take away `2 N a`. A force F at the height h below the middle adds `F h` to this stiffness if it points down, and takes `F h` away
//! if it points up.

use grasp_lcp::need::{Amount, Demand, Need, Quantity};
use grasp_lcp::planar::{Contact, Grasp, Loads, Turn, Wrench};
use grasp_lcp::{Error, Settings};

const STIFFNESS: f64 = 2e3;
const ALONG: f64 = 1e5;
const HALF: f64 = 0.05;
const BELOW: f64 = 0.1;
const RESISTS: f64 = 2.0 * STIFFNESS * HALF * HALF;

fn bar(press: f64) -> Result<Grasp, Error> {
    Grasp::new([-HALF, HALF].map(|x| {
        let finger = Contact::new([x, 0.0], [-x.signum(), 0.0]).series_stiffness(ALONG, STIFFNESS);
        finger.friction(0.5).pressed_with(press)
    }))
}

/// The fingers tilt the bar by θ. Its weight W acts at the height h below the middle and turns it back by φ in the fingers, until
/// `W h sin(θ - φ) = 2 a (k_t a cos φ + k_n a (1 - cos φ) - N) sin φ`. Near buckling that is too much long before the bar buckles.
#[test]
fn a_bar_that_is_tilted_over() -> Result<(), Error> {
    let (press, weight) = (97.0, 5.0);
    let turn = Turn::tilting([0.0, -weight], [0.0, -BELOW]);
    let needed = bar(press)?.need(&Need::angle(turn))?;
    let back = Settings::default().small_motions.rotation;
    let springs = HALF * (STIFFNESS * back.cos() + ALONG * (1.0 - back.cos())) - press;
    let expected = back + (2.0 * HALF * springs * back.sin() / (weight * BELOW)).asin();
    let most = needed.amount.bound().expect("it turns too far");
    assert!((most - expected).abs() < 1e-6, "{most} {expected} {needed}");
    Ok(())
}

#[test]
fn a_force_that_may_point_up() -> Result<(), Error> {
    let (press, size) = (10.0, 2.0);
    let loads = Loads::AnyForce { base: Wrench::ZERO, size, point: [0.0, -BELOW] };
    let needed = bar(press)?.need(&Need::squeeze(loads).if_lower_by(0.0, 0.0))?;
    let Amount::Bound { until: Some(end), .. } = &needed.amount else { panic!("{needed}") };
    let expected = (RESISTS - size * BELOW) / (2.0 * press * HALF);
    assert!((end.sufficient / expected - 1.0).abs() < 1e-5, "{} {expected} {needed}", end.sufficient);
    Ok(())
}

/// With the load that is taken, the forces of the fingers take N/(k a) of what resists. The answer says so from a half on.
#[test]
fn what_the_forces_take_is_said_beside_the_amount() -> Result<(), Error> {
    for (part, is_said) in [(0.4, false), (0.6, true)] {
        let push = Wrench::force_at([0.0, -1.0], [0.0, 0.0]);
        let needed = bar(part * STIFFNESS * HALF)?.need(&Need::load(push))?;
        assert_eq!(needed.left_out.is_some(), is_said, "{needed}");
        assert!(needed.left_out.is_none_or(|taken| (taken + part).abs() < 1e-6), "{needed}");
        let words = "they take 60 % of what resists, and motions are up to 2.5 times as large";
        assert_eq!(needed.to_string().contains(words), is_said, "{needed}");
    }
    Ok(())
}

/// A batch finds neither a load nor a squeeze with which everything sticks where the bar buckles, as the search for a single grasp.
#[test]
fn amounts_of_a_batch() -> Result<(), Error> {
    let presses = [0.9, 1.1].map(|part| part * STIFFNESS * HALF);
    let push = Wrench::force_at([0.0, -200.0], [0.0, 0.0]);
    for quantity in [Quantity::Load, Quantity::Squeeze] {
        let row = |row: usize, contacts: &mut Vec<Contact>| {
            contacts.extend(bar(presses[row]).expect("well posed").contacts().iter().cloned());
            [Wrench::ZERO, push]
        };
        let batch = Grasp::need_batch(2, &row, (quantity, Demand::Sticks), &Settings::default());
        for (press, amount) in presses.into_iter().zip(batch) {
            let need = if quantity == Quantity::Load { Need::load(push) } else { Need::squeeze(push) };
            let needed = bar(press)?.need(&need.to_stick().with_scan(0))?;
            let amount = amount?;
            assert!(
                amount
                    .bound()
                    .is_none_or(|bound| (bound / needed.amount.bound().unwrap() - 1.0).abs() < 1e-9),
                "{needed}"
            );
            assert_eq!(
                amount.bound().is_some(),
                press < STIFFNESS * HALF && quantity == Quantity::Load,
                "{needed}"
            );
        }
    }
    Ok(())
}

/// Jaws with springs of 10 kN/m on arms of 0.04 m buckle from 400 N on. A weight that turns does not hide that it acts at the centre.
#[test]
fn jaws_of_a_scene_before_they_turn() {
    let needed = |pressed: f64| {
        let jaw = |x: f64| serde_json::json!({ "point": [x, 0], "normal": [-x.signum(), 0], "friction": 0.5, "stiffness": 1e4, "pressed_with": pressed });
        let turn = serde_json::json!({ "weight": [0, -5], "at": [0, 0] });
        let setup = serde_json::json!({
            "contacts": [jaw(-0.04), jaw(0.04)], "questions": [{ "need": { "quantity": "angle", "turn": turn } }]
        });
        let setup: grasp_lcp::scene::Setup<2> = serde_json::from_value(setup).expect("a scene");
        let answers = setup.answers().expect("well posed");
        setup.questions[0].first_line(&answers[0], grasp_lcp::words::Words::default())
    };
    assert!(needed(396.0).starts_with("TAKES any: it holds up to 360°"), "{}", needed(396.0));
    let buckles = needed(404.0);
    assert!(
        buckles.starts_with("NO angle does, since it does not hold before it turns: BUCKLES"),
        "{buckles}"
    );
}
