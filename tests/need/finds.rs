//! Amounts, sentences and refusals that once misled: directions between samples, motions that are too large, numbers to enter, overlaps.

use grasp_lcp::Error;
use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar;
use grasp_lcp::scene::Scene;
use grasp_lcp::spatial;
use grasp_lcp::squeeze::Loads;

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

/// Between directions at which the object is caught, and directions at which it is lost beyond 4.82 N, it is lost before, within a small angle.
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

/// A finger of one joint that a tendon closes against a stop without friction: only the tension that balances the other tendon holds.
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

/// A squeeze that carries the load may move contacts too far at a small multiple of the one given, though its least multiple is far smaller.
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
    let until = match &needed.amount {
        Amount::Bound { until: Some(end), .. } | Amount::Any { until: Some(end), .. } => end,
        _ => panic!("{needed}"),
    };
    for (squeeze, holds) in [(until.does, true), (until.does_not, false)] {
        assert_eq!(grasp.squeezed(squeeze)?.hold(load)?.holds(), Some(holds), "{needed}");
    }
    Ok(())
}
