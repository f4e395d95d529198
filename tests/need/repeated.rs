//! Needed amounts for repeated loads agree with the closed form of the walking block and stay below the shakedown factor. Loads without an order are
//! refused.

use std::f64::consts::PI;

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Turn, Wrench};
use grasp_lcp::{Error, Settings};
use proptest::prelude::*;
use support::samples::{assert_met, config, samples, seeded};
use support::shaken::in_the_plane;

/// Two feet are pressed down by a frictionless contact with a total force of `p` newtons.
fn block(p: f64, mu: f64, k_t: f64) -> Result<Grasp, Error> {
    let foot = |x: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(3.0 * k_t, k_t).friction(mu).pressed_with(0.5 * p)
    };
    Grasp::new([
        foot(-1.0),
        foot(1.0),
        Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(k_t, k_t).pressed_with(p),
    ])
}

/// Rocking moments of both signs, so that each foot in turn carries `m` newtons less.
fn rocked(m: f64) -> Vec<Wrench> {
    [2.0 * m, -2.0 * m].map(|moment| Wrench::new([0.0, 0.0], moment)).to_vec()
}

fn bound(grasp: &Grasp, need: &Need<2>) -> Result<f64, TestCaseError> {
    let amount = grasp.need(&need.clone().if_lower_by(0.0, 0.0)).expect("well posed").amount;
    let told = format!("{amount:?}");
    amount.bound().ok_or_else(|| TestCaseError::fail(told))
}

proptest! {
    #![proptest_config(config(6))]
    /// Two feet share the normal force p of a block, and a repeated moment relieves each of them in turn by m. The block comes to rest under pulls up
    /// to q = μ (p - 2 m). Slips below a billionth of the spring deflections are treated as zero.
    #[test]
    fn rests_up_to_what_one_foot_leaves_to_the_other(
        p in 1.0..100.0, part in 0.05..0.9, mu in 0.2..1.0, k_t in 1e2..1e5,
    ) {
        let m: f64 = 0.5 * p * part;
        let q = mu * (p - 2.0 * m);
        let blur = 1e-9 * p / mu;
        let grasp = block(p, mu, k_t).expect("well posed");
        let pulled = Wrench::force([q, 0.0]);
        for aimed in [Need::to_rest, Need::to_stay] {
            let need = |need: Need<2>| aimed(need.on_top_of(pulled));
            let load = bound(&grasp, &need(Need::load(rocked(1.0))))?;
            prop_assert!((load - m).abs() <= blur, "{load} {m}");
            let friction = bound(&grasp, &need(Need::friction(rocked(m))))?;
            prop_assert!((friction - mu).abs() <= blur / (p - 2.0 * m), "{friction} {mu}");
            let squeeze = bound(&grasp, &need(Need::squeeze(rocked(m))))?;
            prop_assert!((squeeze - 1.0).abs() <= blur / p, "{squeeze}");
        }
    }
}

#[test]
fn rests_under_no_more_than_the_shakedown_factor() -> Result<(), Error> {
    let mut random = seeded(29);
    let mut compared = 0;
    for _ in 0..samples(5) {
        let drawn = in_the_plane(&mut random)?;
        let loads = [0, 1].map(|_| {
            Wrench::new(
                [random.between(-1.0, 1.0), random.between(-1.0, 1.0)],
                0.02 * random.between(-1.0, 1.0),
            )
        });
        let found = drawn.grasp.statics().shakedown(drawn.base, &loads)?;
        let need = Need::load(loads.to_vec()).on_top_of(drawn.base).if_lower_by(0.0, 0.0).with_scan(0);
        let (Some(most), Amount::Bound { sufficient, .. }) =
            (found, drawn.grasp.need(&need.clone().to_rest())?.amount)
        else {
            continue;
        };
        // If a finger opens, the shakedown factor is not an upper bound.
        let is_closed = |load: Wrench| {
            let held = drawn.grasp.hold(load).map(|verdict| verdict.state);
            held.is_ok_and(|state| {
                state.is_some_and(|state| state.contacts.iter().all(|c| c.normal_force() > 0.0))
            })
        };
        if !(is_closed(drawn.base) && loads.iter().all(|load| is_closed(*load * sufficient + drawn.base))) {
            continue;
        }
        compared += 1;
        assert!(sufficient <= most.factor * (1.0 + 1e-9), "{sufficient} {}", most.factor);
        // Each demand is stricter than the next: to stick implies to come to rest, this implies not to walk, and this implies to hold.
        let bound = |need: &Need<2>| Ok::<_, Error>(drawn.grasp.need(need)?.amount.bound());
        let sticks = bound(&need.clone().to_stick())?.unwrap_or(0.0);
        let stays = bound(&need.to_stay())?.unwrap_or(f64::INFINITY);
        assert!(
            sticks <= sufficient * (1.0 + 1e-9) && sufficient <= stays * (1.0 + 1e-9),
            "{sticks} {sufficient} {stays}"
        );
    }
    assert_met(&[(compared, 1)]);
    Ok(())
}

/// A moment of 1.6 N m times the sine of an angle is applied and taken back. At a quarter turn one foot carries 0.8 N less. Where the sine is -s, the
/// other foot carries s · 0.8 N less. Under a pull of 0.4 N = 0.5 (2 N - 0.8 N - s · 0.8 N) the block comes to rest up to s = 1/2.
#[test]
fn a_load_that_turns_goes_there_and_back() -> Result<(), Error> {
    let grasp = block(2.0, 0.5, 100.0)?;
    let turn = Turn::new(Wrench::force([0.4, 0.0]), Wrench::ZERO, Wrench::new([0.0, 0.0], 1.6)).up_to(4.7);
    let need = Need::angle(turn).if_lower_by(0.0, 0.0);
    let most = grasp.need(&need.clone().to_rest())?.amount.bound().expect("some angle");
    assert!((most - 7.0 / 6.0 * PI).abs() < 1e-8, "{most}");
    assert!(matches!(grasp.need(&need.to_hold())?.amount, Amount::Any { to: 4.7, .. }));
    Ok(())
}

#[test]
fn forces_of_any_direction_come_in_no_order() -> Result<(), Error> {
    let any = grasp_lcp::squeeze::Loads::AnyForce { base: Wrench::ZERO, size: 1.0, point: [0.0, 0.0] };
    let refused = block(2.0, 0.5, 100.0)?.with(&Settings::default()).need(&Need::squeeze(any).to_rest());
    assert!(matches!(refused, Err(Error::Question { question: "need", field: "demand", .. })), "{refused:?}");
    Ok(())
}
