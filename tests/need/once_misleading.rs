//! Amounts, sentences and refusals that once misled: directions between samples, motions that are too large, numbers to enter, overlaps.

use grasp_lcp::Error;
use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar;
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial;
use grasp_lcp::squeeze::Loads;
use support::jaws::jaw;

type Tested = Result<(), Box<dyn std::error::Error>>;

/// A suction cup with a lip of radius 30 mm, 10 N/mm, and a vacuum of `force`.
fn cup(force: f64) -> Result<spatial::Grasp, Error> {
    let lip = spatial::Contact::new([0.0; 3], [0.0, 0.0, -1.0])
        .name("cup")
        .series_stiffness(1e4, 5e3)
        .friction(0.4);
    spatial::Grasp::new(spatial::SuctionCup::of_force(0.03, 12, force)?.contacts(&lip)?)
}

/// While a ring of springs sticks, its stiffness against tilting is k R²/2, here 4.5 N m/rad. A force of any direction at h = 50 mm tilts it by at most
/// F h / 4.5 N m/rad, whatever the vacuum.
#[test]
fn no_vacuum_helps_against_tilting_too_far() -> Tested {
    let limit = grasp_lcp::Settings::default().small_motions.rotation;
    let most = limit * 0.5 * 1e4 * 0.03 * 0.03 / 0.05;
    let weight = spatial::Wrench::force([0.0, 0.0, -29.43]);
    let any = |size: f64| Loads::AnyForce { base: weight, size, point: [0.0, 0.0, -0.05] };
    for need in [Need::squeeze(any(1.01 * most)), Need::friction(any(1.01 * most))] {
        let needed = cup(400.0)?.need(&need.if_lower_by(0.0, 0.0))?;
        let Amount::None { otherwise, .. } = &needed.amount else { panic!("{needed}") };
        assert!(
            otherwise.contains("under a force along") && otherwise.contains("turns by more than"),
            "{needed}"
        );
    }
    let sticks = Need::squeeze(any(0.99 * most)).to_stick().if_lower_by(0.0, 0.0);
    assert!(cup(400.0)?.need(&sticks)?.amount.bound().is_some());
    Ok(())
}

fn planar_scene(contacts: &str) -> Result<planar::Grasp, Box<dyn std::error::Error>> {
    let text = format!(r#"{{ "format": "grasp-lcp/1", "planar": {{ "contacts": [{contacts}] }} }}"#);
    Ok(Scene::from_json(text.as_bytes())?.planar().ok_or("a planar scene")?.grasp()?)
}

/// Two jaws with 20 N at μ = 0.4 carry the multiple λ of 20 N beside 1 N in any direction while `λ (20 + s + 0.4 c) <= 16` for each sine s and cosine c.
/// The whole load slides at once; without friction nothing resists the direction along the jaws, which is named.
#[test]
fn a_load_beside_a_force_in_any_direction_is_sought_below_it() -> Tested {
    let any = |size: f64| {
        let base = planar::Wrench::force([0.0, -20.0]);
        Need::load(Loads::AnyForce { base, size, point: [0.0; 2] }).if_lower_by(0.0, 0.0)
    };
    let jaws =
        |mu: f64| planar::Grasp::new([-0.04, 0.04].map(|x| jaw::<2>(x, [5e3, 2e3], mu).pressed_with(20.0)));
    let sticks = jaws(0.4)?.need(&any(1.0))?.sticks.and_then(|sticks| sticks.bound());
    assert!(sticks.is_some_and(|most| (most - 16.0 / (20.0 + 1.16_f64.sqrt())).abs() < 1e-6), "{sticks:?}");
    let needed = jaws(0.0)?.need(
        &Need::squeeze(Loads::AnyForce { base: planar::Wrench::ZERO, size: 1.0, point: [0.0; 2] }).to_stick(),
    )?;
    let Amount::None { otherwise, .. } = &needed.amount else { panic!("{needed}") };
    assert!(otherwise.starts_with("nothing resists ") && otherwise.ends_with('y'), "{needed}");
    Ok(())
}

/// A force of 4.82 N in any direction. In some directions the object is caught, in others it is lost only beyond 4.82 N. Between these directions,
/// within a small angle, it is lost before.
#[test]
fn no_direction_between_samples_is_lost() -> Tested {
    let scene = |press: f64| {
        planar_scene(&format!(
            r#"{{ "name": "c0", "point": [0.04975, 0.00503], "normal": [-0.99492, -0.10066], "stiffness": [25596, 11011], "friction": 0.6561 }},
            {{ "name": "c1", "point": [-0.01085, 0.04881], "normal": [0.21698, -0.97618], "stiffness": [25971, 10506], "friction": 0.2918, "clearance": 0.0005 }},
            {{ "name": "c2", "point": [-0.01228, -0.04847], "normal": [0.24564, 0.96936], "stiffness": [6457, 13594], "friction": 0.8005, "pressed_with": {press} }}"#
        ))
    };
    let (point, load) = ([0.0143, -0.0025], planar::Wrench::force_at([1.857, -1.122], [0.0143, -0.0025]));
    let any = Loads::AnyForce { base: load, size: 4.82, point };
    let needed = scene(16.7185)?.need(&Need::squeeze(any).if_lower_by(0.0, 0.0).with_scan(0))?;
    let least = needed.amount.bound().expect("some does");
    // At rest without a load no contact presses, so that the answer names only the force to enter.
    let words = needed.to_string();
    let (_, entered) = words.split_once("(`pressed_with` ").expect("names the force to enter");
    let entered: f64 = entered.split_once(" N at c2)").expect("names c2").0.parse().expect("a number");
    // The number in words is rounded up, so that it suffices.
    assert!(entered >= 16.7185 * least && entered <= 16.7185 * least + 1e-6, "{words}");
    for (press, holds) in [(1.0001 * least, true), (0.8 * least, false)] {
        let grasp = scene(16.7185 * press)?;
        let mut all = true;
        let near = (0..100).map(|k| 213.0 + 0.005 * f64::from(k));
        for degrees in (0..180).map(|k| 2.0 * f64::from(k)).chain(near) {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let force = planar::Wrench::force_at([4.82 * cos, 4.82 * sin], point);
            all &= grasp.hold(planar::Ramp::load(load, force))?.holds() == Some(true);
        }
        assert_eq!(all, holds, "{press}");
    }
    Ok(())
}

const FOUR: &str = r#"{ "name": "c0", "point": [0.04688, 0.0174], "normal": [-0.93753, -0.34791], "stiffness": [5254, 21656], "friction": 0.2423, "pressed_with": 19.0759 },
    { "name": "c1", "point": [0.00152, 0.04998], "normal": [-0.0304, -0.99954], "stiffness": [3463, 21185], "friction": 0.2037, "pressed_with": 3.02 },
    { "name": "c2", "point": [-0.04962, -0.00615], "normal": [0.99241, 0.12294], "stiffness": [20692, 5954], "friction": 0.3441, "kinetic_friction": 0.2444 },
    { "name": "c3", "point": [0.01167, -0.04862], "normal": [-0.2334, 0.97238], "stiffness": [4127, 23934], "friction": 0.2582, "kinetic_friction": 0.2085 }"#;

/// With kinetic friction at rest, the greatest squeeze of the answer is one that `hold` confirms, and the forces at rest are those that `follow`
/// finds.
#[test]
fn kinetic_friction_at_rest() -> Tested {
    let (grasp, load) = (planar_scene(FOUR)?, planar::Wrench::force_at([1.095, 1.515], [0.0122, 0.0013]));
    let needed = grasp.need(&Need::squeeze(load).if_lower_by(0.0, 0.0))?;
    let Amount::Any { until: Some(end), .. } = &needed.amount else { panic!("{needed}") };
    for (squeeze, holds) in [(end.sufficient, true), (end.insufficient, false)] {
        assert_eq!(grasp.squeezed(squeeze)?.hold(load)?.holds(), Some(holds), "{needed}");
    }
    let squeezed = grasp.squeezed(end.sufficient)?;
    let state = squeezed.follow(planar::Wrench::ZERO, &[])?.state().ok_or("rests")?;
    for (press, contact) in end.presses.iter().zip(&state.contacts) {
        assert!((press.force - contact.normal_force()).abs() < 1e-9, "{needed}");
    }
    Ok(())
}

/// A contact presses an object against springs. At rest its force is less than its `pressed_with`, and the sentence gives the value of `pressed_with`
/// to enter.
#[test]
fn the_number_to_enter() -> Tested {
    let jaw = |x: f64, k: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(k, k).friction(0.5);
    let grasp = |press: f64| {
        planar::Grasp::new([jaw(-0.03, 3e3).name("left").pressed_with(press), jaw(0.03, 1e3).name("right")])
    };
    let weight = planar::Wrench::force([0.0, -4.0]);
    let needed = grasp(40.0)?.need(&Need::squeeze(weight).if_lower_by(0.0, 0.0))?;
    // The springs of both jaws are in series, which leaves a quarter of the left jaw's force: 4 N at each contact for 16 N. With 140.1334 N the object
    // turns by 0.1 rad, as the balance of forces says with exact rotations.
    let words = needed.to_string();
    assert!(
        words.starts_with(
            "NEEDS 4 N at left (`pressed_with` 16 N, 0.4 times the squeeze given), at most 35.0333 N (`pressed_with` 140.133 N"
        ),
        "{words}"
    );
    for (press, holds) in [(16.0 * (1.0 + 1e-9), true), (16.0 * (1.0 - 1e-9), false)] {
        assert_eq!(grasp(press)?.hold(weight)?.holds(), Some(holds));
    }
    Ok(())
}

/// A tendon closes a finger of one joint against a stop without friction. Only the tension that balances the other tendon holds.
#[test]
fn only_the_balanced_tension() -> Tested {
    let text = r#"{ "format": "grasp-lcp/1", "planar": {
        "fingers": [
            { "joints": [{ "name": "l", "prismatic": [1, 0] }], "contacts": [{ "name": "left", "point": [-0.03, 0], "normal": [1, 0], "stiffness": 1e4, "friction": 0.5 }] },
            { "joints": [{ "name": "r", "prismatic": [-1, 0] }], "contacts": [{ "name": "right", "point": [0.03, 0], "normal": [-1, 0], "stiffness": 1e4, "friction": 0.5 }] }
        ],
        "tendons": [{ "name": "tl", "arms": [1, 0], "tension": TENSION }, { "name": "tr", "arms": [0, 1], "tension": 20 }]
    } }"#;
    let weight = planar::Wrench::force([0.0, -3.0]);
    for (given, said) in [("20", "ONLY 20 N at tl does, as given, and"), ("8", "ONLY 20 N at tl does, and")] {
        let scene = Scene::from_json(text.replace("TENSION", given).as_bytes())?;
        let grasp = scene.planar().ok_or("a planar scene")?.grasp()?;
        let needed = grasp.need(&Need::force("tl", weight))?;
        let tension: f64 = given.parse()?;
        assert!((needed.amount.bound().ok_or("one does")? * tension / 20.0 - 1.0).abs() < 1e-12, "{needed}");
        assert!(
            needed.to_string().starts_with(said) && !needed.to_string().contains("does not do"),
            "{needed}"
        );
    }
    Ok(())
}

/// A press fit of four points: friction carries μ k δ R at each, so that an overlap of δ = M / (4 μ k R) is needed.
#[test]
fn the_overlap_of_a_press_fit() -> Tested {
    let (k, mu, radius, moment) = (1e7, 0.15, 0.02, 3.0);
    let point = |quarter: i32| {
        let (sin, cos) = (f64::from(quarter) * std::f64::consts::FRAC_PI_2).sin_cos();
        let contact =
            planar::Contact::new([radius * cos, radius * sin], [-cos, -sin]).series_stiffness(k, 0.8 * k);
        contact.name(format!("g{quarter}")).friction(mu).clearance(-2e-5)
    };
    let grasp = planar::Grasp::new((0..4).map(point))?;
    let load = planar::Wrench::new([0.0, 0.0], moment);
    let needed = grasp.need(&Need::squeeze(load).if_lower_by(0.1, 0.0))?;
    let overlap = moment / (4.0 * mu * k * radius);
    assert!((needed.amount.bound().ok_or("some does")? * 2e-5 / overlap - 1.0).abs() < 1e-10, "{needed}");
    let words = needed.to_string();
    assert!(
        words.starts_with("NEEDS 0.025 mm of overlap (250 N) at g0, g1, g2 and g3 so that it holds"),
        "{words}"
    );
    let Amount::Bound { presses, .. } = &needed.amount else { panic!("{needed}") };
    assert!(presses.iter().all(|press| press.is_set && (press.force - k * overlap).abs() < 1e-6), "{needed}");
    // No contact of the press fit has a command, so the error lists no part whose force could be asked for.
    let Err(Error::Part { allowed, .. }) = grasp.need(&Need::force("g0", load)) else { panic!("no command") };
    assert!(allowed.is_empty(), "{allowed}");
    Ok(())
}

/// Two edges at x = -60 mm and +20 mm, with the centre of mass 100 mm above. Tilted one way the block tips at atan(20/100). Tilted the other way it
/// slides, or tips at a larger angle.
#[test]
fn the_sense_of_a_tilt() -> Tested {
    let edge = |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e7, 1e7).friction(0.8);
    let block = planar::Grasp::new([edge(-0.06), edge(0.02)])?;
    let turn = planar::Turn::tilting([0.0, -9.81], [0.0, 0.1]).up_to(1.5);
    for (turn, sense, tangent) in [(turn, " anticlockwise", 0.6), (turn.reversed(), " clockwise", 0.2)] {
        let needed = block.need(&Need::angle(turn))?;
        let angle = needed.amount.bound().ok_or("it tips")?;
        assert!((angle.tan() - tangent).abs() < 1e-3, "{needed}");
        assert!(needed.to_string().contains(&format!("°{sense} and holds")), "{needed}");
    }
    Ok(())
}

/// A squeeze that carries the load may move contacts too far at a small multiple of the given squeeze, although far smaller multiples suffice.
#[test]
fn the_upper_end_beyond_the_squeeze_given() -> Tested {
    let jaw = |x: f64, k: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(k, k).friction(0.8);
    let grasp = planar::Grasp::new([
        jaw(-0.03, 1e3).pressed_with(300.0),
        jaw(0.03, 1e3).command([0.0, 0.0]),
        planar::Contact::new([0.0, 0.02], [0.0, -1.0]).series_stiffness(1e3, 1e3).friction(0.01),
    ])?;
    let load = planar::Wrench::force([0.0, 1.0]);
    let needed = grasp.need(&Need::squeeze(load).if_lower_by(0.0, 0.0))?;
    let (Amount::Bound { until: Some(until), .. } | Amount::Any { until: Some(until), .. }) = &needed.amount
    else {
        panic!("{needed}")
    };
    for (squeeze, holds) in [(until.sufficient, true), (until.insufficient, false)] {
        assert_eq!(grasp.squeezed(squeeze)?.hold(load)?.holds(), Some(holds), "{needed}");
    }
    Ok(())
}

/// A wedge of 30° that is driven in with 100 N presses a jaw against a part. With much friction it sticks before it presses enough, whatever friction
/// stands in the scene.
#[test]
fn a_wedge_with_more_friction_than_in_the_scene_is_tried() -> Tested {
    let grasp = |friction: f64| -> Result<planar::Grasp, Box<dyn std::error::Error>> {
        let contacts = [
            r#""on": "part", "point": [-0.03, 0], "normal": [1, 0]"#,
            r#""on": "part", "against": "jaw", "point": [-0.01, 0], "normal": [-1, 0]"#,
            r#""on": "jaw", "against": "wedge", "point": [0.01, 0], "normal": [-0.8660254037844386, -0.5]"#,
            r#""on": "jaw", "point": [0, -0.02], "normal": [0, 1]"#,
            r#""on": "wedge", "point": [0.03, 0], "normal": [-1, 0]"#,
        ];
        let springs =
            format!(r#""friction": {friction}, "stiffness": 1e7, "soft": {{"pair": {{"width": 0.02}}}}"#);
        let contacts = contacts.map(|contact| format!("{{{contact}, {springs}}}")).join(",");
        let wedge = r#"{"name": "wedge", "load": {"force": [0, -100], "at": [0.02, 0]}}"#;
        let text = format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{"bodies": [{{"name": "part"}}, {{"name": "jaw"}}, {wedge}], "contacts": [{contacts}]}}}}"#
        );
        Ok(Scene::from_json(text.as_bytes())?.planar().ok_or("a planar scene")?.grasp()?)
    };
    let load = planar::Wrench::force_at([0.0, 20.0], [-0.02, 0.0]);
    for friction in [0.1, 0.3, 0.5] {
        let needed = grasp(friction)?.need(&Need::friction(load).if_lower_by(0.0, 0.0))?;
        let Amount::Bound { until: Some(end), .. } = &needed.amount else { panic!("{friction} {needed}") };
        assert_eq!(grasp(0.999 * end.sufficient)?.hold(load)?.holds(), Some(true), "{friction} {needed}");
        assert_eq!(grasp(1.001 * end.insufficient)?.hold(load)?.holds(), Some(false), "{friction} {needed}");
    }
    Ok(())
}

/// A least amount is rounded up in words, a greatest down, so that the number in words suffices with any number of digits. By statics two jaws that
/// press with 10 N carry 20 N times their friction.
#[test]
fn the_number_in_words_suffices() -> Tested {
    let grasp = |friction: f64| {
        let jaw =
            |x: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2e4, 2e4).friction(friction);
        planar::Grasp::new([jaw(-0.03).pressed_with(10.0), jaw(0.03).pressed_with(10.0)])
    };
    let load = |force: f64| planar::Wrench::force([0.0, -force]);
    for force in [6.6, 20.0 / 3.0, 9.99] {
        let needed = grasp(0.9)?.need(&Need::friction(load(force)).if_lower_by(0.0, 0.0))?;
        let friction = 0.05 * force;
        let verdict = grasp(friction)?.hold(load(0.7 * force))?;
        for digits in 1..8 {
            let unit = 10.0_f64.powi(1 - digits);
            let digits = usize::try_from(digits)?;
            let words = format!("{needed:.digits$}");
            let amount = words.strip_prefix("NEEDS a coefficient of friction of ").expect("a least friction");
            let amount: f64 = amount.split([' ', ',']).next().expect("a number").parse()?;
            assert!(amount >= friction * (1.0 - 1e-8) && amount < friction + unit, "{words}");
            let words = format!("{verdict:.digits$}");
            let (_, limit) = words.split_once("sticks: ").expect("the limit");
            let limit: f64 = limit.split(' ').next().expect("a number").parse()?;
            assert!(limit <= force * (1.0 + 1e-8) && limit > force - 10.0 * unit, "{words}");
        }
    }
    Ok(())
}

/// A force of 12 N beside two jaws, which carry it within ±0.14/3 m of their middle. Counted from 55 mm beside it, that is from 1/120 m on.
#[test]
fn the_least_arm_is_named() -> Tested {
    let jaw = |x: f64| planar::Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(4e5, 3e5).friction(0.5);
    let grasp = planar::Grasp::new([jaw(-0.04).pressed_with(26.0), jaw(0.04).pressed_with(26.0)])?;
    let force = |x: f64| planar::Wrench::force_at([0.0, -12.0], [x, 0.0]);
    let needed = grasp.need(&Need::arm(force(-0.055), force(1.0) - force(0.0)))?;
    let Amount::Bound { sufficient, until: Some(until), .. } = &needed.amount else { panic!("{needed}") };
    assert!((sufficient - (0.055 + 0.14 / 3.0)).abs() < 1e-9, "{needed}");
    assert!((until.sufficient - (0.055 - 0.14 / 3.0)).abs() < 1e-6, "{needed}");
    assert!(
        needed.to_string().starts_with("TAKES an arm of 0.00833334 m to 0.101666 m and holds"),
        "{needed}"
    );
    Ok(())
}
