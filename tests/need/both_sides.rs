//! On random grasps the least or greatest sufficient amount is sharp: an amount that is better by a billionth suffices, and one that is worse by a
//! billionth does not.

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Fingers around a disc that is pulled and turned.
fn scene(random: &mut Random) -> Result<(Grasp, Wrench), grasp_lcp::Error> {
    let count = 2.0 + random.between(0.0, 3.0).floor();
    let mut fingers = Vec::new();
    for i in 0..4 {
        let angle = std::f64::consts::TAU * (f64::from(i) + random.between(-0.1, 0.1)) / count;
        let (sin, cos) = angle.sin_cos();
        let finger = Contact::new([0.04 * cos, 0.04 * sin], [-cos, -sin])
            .series_stiffness(random.between(500.0, 5e3), random.between(500.0, 5e3))
            .friction(random.between(0.3, 0.8))
            .pressed_with(random.between(5.0, 20.0));
        if f64::from(i) < count {
            fingers.push(finger);
        }
    }
    let way = random.between(0.0, std::f64::consts::TAU);
    Ok((Grasp::new(fingers)?, Wrench::new([2.0 * way.cos(), 2.0 * way.sin()], random.between(-0.05, 0.05))))
}

type Tried<'t> = &'t dyn Fn(f64) -> Result<Option<bool>, grasp_lcp::Error>;

/// The verdict: if `held`, whether the grasp holds the load, otherwise whether no contact slides.
fn verdict(grasp: &Grasp, load: Wrench, held: bool) -> Result<Option<bool>, grasp_lcp::Error> {
    let verdict = grasp.hold(load)?;
    Ok(if held { verdict.holds() } else { verdict.sticks() })
}

/// Checks bounds on squeeze, friction and load, for sticking or for holding. At least `least` bounds must exist. At most one in `one_in` may be
/// blurred, which means known to less than 1e-12.
fn a_billionth_decides(held: bool, least: usize, one_in: usize) -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(17);
    let (mut bounds, mut blurred) = (0, 0);
    for _ in 0..samples(125) {
        let (grasp, load) = scene(&mut random)?;
        let aimed = |need: Need<2>| {
            let need = need.if_lower_by(0.0, 0.0).with_scan(0);
            if held { need.to_hold() } else { need.to_stick() }
        };
        let squeeze = |amount: f64| verdict(&grasp.squeezed(amount)?, load, held);
        let friction = |amount: f64| verdict(&grasp.with_friction(|_, _| amount)?, load, held);
        let times = |amount: f64| verdict(&grasp, load * amount, held);
        let sought: [(Need<2>, Tried, f64); 3] = [
            (Need::squeeze(load), &squeeze, 1.0),
            (Need::friction(load), &friction, 1.0),
            (Need::load(load), &times, -1.0),
        ];
        for (need, tried, more) in sought {
            let Amount::Bound { sufficient, insufficient, .. } = grasp.need(&aimed(need))?.amount else {
                continue;
            };
            bounds += 1;
            // If the verdict at the bound is undecided, the answer gives an insufficient amount slightly beyond the bound.
            blurred += usize::from((sufficient - insufficient).abs() > 1e-12 * sufficient);
            assert!((sufficient - insufficient).abs() <= 1e-9 * sufficient, "{sufficient} {insufficient}");
            assert_eq!(tried(sufficient * (1.0 + more * 1e-9))?, Some(true), "{sufficient}");
            assert_eq!(tried(sufficient * (1.0 - more * 1e-9))?, Some(false), "{sufficient}");
        }
    }
    assert_met(&[(bounds, least)]);
    assert!(blurred < bounds / one_in, "{blurred} of {bounds}");
    Ok(())
}

#[test]
fn a_billionth_decides_whether_it_sticks() -> Result<(), grasp_lcp::Error> {
    a_billionth_decides(false, 312, 100)
}

#[test]
fn a_billionth_decides_whether_it_is_held() -> Result<(), grasp_lcp::Error> {
    a_billionth_decides(true, 156, 12)
}
