//! Needed amounts agree with hand calculations.

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Loads, Turn, Wrench};
use support::facts;
use support::jaws::jaws;

type Tested = Result<(), grasp_lcp::Error>;

fn is(need: &Need<2>, grasp: &Grasp, amount: f64) -> Tested {
    let needed = grasp.need(need)?;
    let found = needed.amount.bound();
    assert!(found.is_some_and(|found| (found / amount - 1.0).abs() < 1e-11), "{amount}: {found:?}, {needed}");
    Ok(())
}

/// A pinch holds W <= 2 μ N.
#[test]
fn a_pinch() -> Tested {
    let (pinch, weight) = (jaws([0.5; 2])?, Wrench::force([0.0, -12.0]));
    for demanded in [Need::to_stick, Need::to_hold] {
        is(&demanded(Need::squeeze(weight)), &pinch, 1.2)?;
        is(&demanded(Need::friction(weight)), &pinch, 0.6)?;
        is(&demanded(Need::load(weight)), &pinch, 10.0 / 12.0)?;
        let words = pinch.need(&demanded(Need::load(weight)))?.to_string();
        assert!(words.starts_with("TAKES only 0.833333 times the load, 10 N"), "{words}");
    }
    let needed = pinch.need(&Need::squeeze(weight).to_stick().if_lower_by(0.1, 0.05))?;
    let safe = needed.safe.as_ref().and_then(Amount::bound).expect("more squeeze does");
    assert!((safe - 1.2 / (0.9 * 0.95)).abs() < 1e-11, "{needed}");
    let Amount::Bound { presses, otherwise, .. } = &needed.amount else { panic!("{needed}") };
    let presses: Vec<_> = presses.iter().map(|press| (press.part.label.as_str(), press.force)).collect();
    assert!(
        matches!(&presses[..], [("left", a), ("right", b)] if (a - 12.0).abs() < 1e-9 && (b - 12.0).abs() < 1e-9),
        "{presses:?}"
    );
    assert!(otherwise.contains("left and right"), "{otherwise}");
    Ok(())
}

/// Where no contact has friction, the coefficient of all contacts is sought.
#[test]
fn friction_where_there_is_none() -> Tested {
    for given in [[0.0; 2], [0.5; 2]] {
        is(&Need::friction(Wrench::force([0.0, -12.0])), &jaws(given)?, 0.6)?;
    }
    Ok(())
}

/// A wedge between two pressing faces is held if μ >= tan α/2.
#[test]
fn a_wedge_locks() -> Tested {
    for half in [2.0_f64, 7.5, 20.0].map(f64::to_radians) {
        let face = |side: f64| {
            Contact::new([0.05 * side, 0.0], [-side * half.cos(), half.sin()])
                .series_stiffness(3000.0, 1000.0)
                .friction(0.1)
                .pressed_with(20.0)
        };
        let wedge = Grasp::new([face(-1.0), face(1.0)])?;
        is(&Need::friction(Wrench::ZERO), &wedge, half.tan())?;
    }
    Ok(())
}

/// A ladder is climbed until friction at foot and wall is exhausted together. If the whole load grows from zero, every load factor is then at the limit.
#[test]
fn a_ladder_is_climbed() -> Tested {
    let ([mu_foot, mu_wall], [reach, height]) = ([0.4, 0.2], [2.113, 4.532]);
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(5e5, 2e5).friction(mu_foot);
    let top = Contact::new([reach, height], [-1.0, 0.0]).series_stiffness(2e5, 1e5).friction(mu_wall);
    let ladder = Grasp::new([foot, top])?;
    let (own, climber) = (150.0, 800.0);
    let load = Wrench::force_at([0.0, -own], [0.5 * reach, 0.0]) + Wrench::force([0.0, -climber]);
    // With the total weight W: N_wall = μ_foot N_foot and N_foot + μ_wall N_wall = W. Moments about the foot then give the distance of the climber.
    let wall = mu_foot * (own + climber) / (1.0 + mu_foot * mu_wall);
    let arm = (wall * height + mu_wall * wall * reach - own * 0.5 * reach) / climber;
    is(&Need::arm(load, Wrench::new([0.0, 0.0], -climber)).to_hold(), &ladder, arm)
}

fn box_on_feet(friction: f64) -> Result<Grasp, grasp_lcp::Error> {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 8e3).friction(friction);
    Grasp::new([foot(-0.05), foot(0.05)])
}

/// A block on a slope slides at tan θ = μ.
#[test]
fn a_block_is_tilted() -> Tested {
    // A weight above the feet loads them unevenly. The foot with less load slides first. When the block is lost, both feet slide, at the same angle
    // for any height.
    let turn = |height: f64| Turn::tilting([0.0, -10.0], [0.0, height]).up_to(1.0);
    is(&Need::angle(turn(0.0)), &box_on_feet(0.4)?, 0.4_f64.atan())?;
    is(&Need::angle(turn(0.01)).to_hold(), &box_on_feet(0.4)?, 0.4_f64.atan())?;
    let up = Need::angle(Turn::tilting([0.0, -10.0], [0.0, 0.0]).up_to(0.3));
    assert!(matches!(box_on_feet(0.9)?.need(&up)?.amount, Amount::Any { to: 0.3, .. }));
    Ok(())
}

/// A box of 10 N with 5 N beyond its foot, at x, tips at 10 · 0.05 = 5 (x - 0.05).
#[test]
fn a_box_tips_over_an_arm() -> Tested {
    let [at_the_middle, a_metre_on] = [0.0, 1.0].map(|x| Wrench::force_at([0.0, -5.0], [x, 0.0]));
    let arm = Need::arm(Wrench::force([0.0, -10.0]) + at_the_middle, a_metre_on - at_the_middle);
    is(&arm.clone().to_hold(), &box_on_feet(0.5)?, 0.15)?;
    is(&arm, &box_on_feet(0.5)?, 0.15)
}

/// The amount for a force of any direction is the least squeeze, which has a closed form.
#[test]
fn a_force_of_any_direction() -> Tested {
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        Contact::new([0.04 * cos, 0.04 * sin], [-cos, -sin])
            .series_stiffness(2000.0, 1500.0)
            .friction(0.6)
            .pressed_with(10.0)
    };
    let hand = Grasp::new([0.1, 2.2, 4.3].map(finger))?;
    let loads = Loads::AnyForce { base: Wrench::force([0.0, -3.0]), size: 4.0, point: [0.0, 0.01] };
    let grasp_lcp::planar::LeastSqueeze::Factor { factor, .. } = hand.least_squeeze(&loads)? else {
        panic!("some squeeze does")
    };
    is(&Need::squeeze(loads).to_stick(), &hand, factor)
}

#[test]
fn no_friction_helps_where_moments_are_not_carried() -> Tested {
    // The right jaw's friction cannot replace the left jaw's friction: two points carry equal shares.
    let needed = jaws([0.5; 2])?.need(&Need::friction_of([1], Wrench::force([0.0, -12.0])))?;
    assert!(matches!(needed.amount, Amount::None { .. }), "{needed}");
    assert!(needed.to_string().starts_with("NO coefficient"), "{needed}");
    Ok(())
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let weight = Wrench::force([0.0, -1.0]);
    let refused = |need: Need<2>| jaws([0.5; 2]).and_then(|pinch| pinch.need(&need)).map(drop).unwrap_err();
    let lower = |part: f64| refused(Need::squeeze(weight).if_lower_by(part, 0.0));
    for (error, datum, value) in [
        (lower(1.0), "friction is less", "1"),
        (lower(f64::NAN), "friction is less", "NaN"),
        (refused(Need::friction_of([2], weight)), "2", "2"),
        (refused(Need::load(Loads::Each(Vec::new()))), "load", ""),
    ] {
        let [_, what, given] = facts(&error);
        assert!(what.ends_with(datum) && given == value, "{error}");
    }
}

/// A weight of 8 N is tilted by θ, and a steady pull of 1.5 N is added. One jaw presses with 10 − 4 sin θ, in newtons, and carries half of 8 cos θ +
/// 1.5. With μ = 0.5 it slides where `8 cos θ + 4 sin θ = 8.5`.
#[test]
fn an_angle_on_top_of_a_steady_pull() -> Tested {
    let tilted = Need::angle(Turn::tilting([0.0, -8.0], [0.0, 0.0])).on_top_of(Wrench::force([0.0, -1.5]));
    let (angle, known) =
        (jaws([0.5; 2])?.need(&tilted)?.amount.bound(), 0.5_f64.atan() - (8.5 / 80.0_f64.sqrt()).acos());
    assert!(angle.is_some_and(|angle| (angle - known).abs() < 1e-11), "{angle:?} {known}");
    Ok(())
}

/// The weight w at rest leaves less friction for a push p: `w + p <= 2 μ N` for a push along the line of the weight. Other cases are a push in any
/// direction and a push on an arm.
#[test]
fn a_push_on_top_of_a_weight() -> Tested {
    let (pinch, weight) = (jaws([0.5; 2])?, Wrench::force([0.0, -6.0]));
    is(&Need::load(Wrench::force([0.0, -1.0])).on_top_of(weight), &pinch, 4.0)?;
    is(&Need::squeeze(Wrench::force([0.0, -9.0])).on_top_of(weight), &pinch, 1.5)?;
    is(&Need::friction(Wrench::force([0.0, -9.0])).on_top_of(weight), &pinch, 0.75)
}

/// A lobe of a climbing cam: its axle is guided along the middle of the crack, and touches the wall at an angle α below it. The other two forces act at
/// the axle, so the wall's force passes through it too: μ >= tan α, for every weight.
#[test]
fn a_cam_climbs() -> Tested {
    for (alpha, weight) in [(13.75_f64.to_radians(), 800.0), (0.3, 1.0), (0.6, 5e4)] {
        let (sin, cos) = alpha.sin_cos();
        // The other lobe pushes horizontally, like a guide along the middle.
        let axle = Contact::new([0.0, 0.0], [-1.0, 0.0]).series_stiffness(3e9, 1e9).kept_closed();
        let wall =
            Contact::new([-0.02 * cos, -0.02 * sin], [1.0, 0.0]).series_stiffness(1e9, 4e8).friction(0.5);
        let cam = Grasp::new([axle, wall])?;
        is(&Need::friction(Wrench::force([0.0, -weight])), &cam, alpha.tan())?;
    }
    Ok(())
}

/// If the given squeeze does not hold the weight, the weight is applied from zero for every multiple s of the squeeze. Then `2 μ s 10 N` must carry
/// the weight together with the other force.
#[test]
fn a_force_of_any_direction_beside_a_weight_that_is_not_held() -> Tested {
    let pinch = jaws([0.5; 2])?;
    let loads = Loads::AnyForce { base: Wrench::force([0.0, -12.0]), size: 2.0, point: [0.0; 2] };
    let grasp_lcp::planar::LeastSqueeze::Factor { factor, .. } = pinch.least_squeeze(&loads)? else {
        panic!("some squeeze does")
    };
    is(&Need::squeeze(loads.clone()).to_stick(), &pinch, factor)?;
    // Without any friction the answer says that the weight drops at once.
    let needed = pinch.with_friction(|_, _| 0.0)?.need(&Need::squeeze(loads))?;
    assert!(matches!(needed.amount, Amount::None { .. }), "{needed}");
    assert!(needed.to_string().contains("DROPS at once"), "{needed}");
    Ok(())
}

#[test]
fn directions_are_not_compared_across_an_open_contact() -> Tested {
    let spare =
        Contact::new([0.0, -0.03], [0.0, 1.0]).series_stiffness(1000.0, 800.0).friction(0.5).clearance(0.01);
    let contacts = jaws([0.5; 2])?.contacts().iter().cloned().chain([spare]).collect::<Vec<_>>();
    let loads = Loads::AnyForce { base: Wrench::force([0.0, -3.0]), size: 1.0, point: [0.0; 2] };
    let needed = Grasp::new(contacts)?.need(&Need::squeeze(loads).to_stick())?;
    assert!(
        matches!(&needed.amount, Amount::Undecided { doubt, .. } if doubt.contains("open or at")),
        "{needed}"
    );
    Ok(())
}

/// A bracket whose edges touch a post, with a height h between them, jams if its load hangs at h / 2μ or farther. The first line reports this bound.
#[test]
fn a_bracket_jams_from_an_arm_on() -> Tested {
    let edge = |x: f64, y: f64| Contact::new([x, y], [x, 0.0]).series_stiffness(1e7, 1e7).friction(0.2);
    let bracket = Grasp::new([edge(-0.02, 0.05), edge(0.02, -0.05)])?;
    let [here, a_metre_on] = [0.0, 1.0].map(|x| Wrench::force_at([0.0, -500.0], [x, 0.0]));
    let needed = bracket.need(&Need::arm(here, a_metre_on - here))?;
    let Amount::Bound { until: Some(least), .. } = &needed.amount else { panic!("{needed}") };
    assert!((least.sufficient - 0.1 / 0.4).abs() < 1e-9, "{needed}");
    assert!(needed.to_string().starts_with("HOLDS from an arm"), "{needed}");
    Ok(())
}
