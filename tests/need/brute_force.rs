//! Amounts against brute force: amounts around each answer, put on by `hold` one by one, on random scenes.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few fingers are counted")]

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::{load_path::Ramp, spatial};
use support::samples::{samples, seeded};
use support::splitmix::Random;

type Tested = Result<(), grasp_lcp::Error>;

/// Scenes that are drawn for each quantity.
const SCENES: usize = 2;
/// Amounts that are tried in each scene, at a random place in equal parts of the reach: by default, and where more scenes are drawn.
const AMOUNTS: [i32; 2] = [12, 200];
/// How far below and above an answer they reach.
const REACH: f64 = 16.0;

/// A scene with a load at rest and one that is put on.
struct Scene<const C: usize> {
    grasp: grasp_lcp::ask::Grasp<C>,
    base: grasp_lcp::grasp::Wrench<C>,
    load: grasp_lcp::grasp::Wrench<C>,
}

/// Fingers around a part or anywhere on it, pressed by commands or by forces, or idle; a weight at rest, or none.
fn planar(random: &mut Random) -> Result<Scene<2>, grasp_lcp::Error> {
    let count = 2 + (3.0 * random.uniform()) as usize;
    let is_around = random.uniform() < 0.6;
    let mut fingers = Vec::new();
    for i in 0..count {
        let around = std::f64::consts::TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
        let angle = if is_around { around } else { random.between(0.0, std::f64::consts::TAU) };
        let ((sin, cos), off) = (angle.sin_cos(), random.between(-0.02, 0.02));
        let point = [0.04 * cos + off * sin, 0.04 * sin - off * cos];
        let finger = Contact::new(point, [-cos, -sin])
            .series_stiffness(random.between(5e3, 5e4), random.between(5e3, 5e4))
            .friction(if random.uniform() < 0.1 { 0.0 } else { random.between(0.2, 1.0) });
        let drawn = random.uniform();
        fingers.push(if drawn < 0.55 {
            finger.pressed_with(random.between(5.0, 20.0))
        } else if drawn < 0.8 {
            finger.force(random.between(2.0, 20.0))
        } else {
            finger
        });
    }
    let mut force = |size: f64| {
        let angle = random.between(0.0, std::f64::consts::TAU);
        let at = [random.between(-0.02, 0.02), random.between(-0.02, 0.02)];
        Wrench::force_at([size * angle.cos(), size * angle.sin()], at)
    };
    let (base, load) = (force(3.0), force(4.0));
    let is_loaded = random.uniform() < 0.5;
    Ok(Scene { grasp: Grasp::new(fingers)?, base: if is_loaded { base } else { Wrench::ZERO }, load })
}

fn spatial(random: &mut Random) -> Result<Scene<3>, grasp_lcp::Error> {
    let count = 3 + (2.0 * random.uniform()) as usize;
    let mut fingers = Vec::new();
    for i in 0..count {
        let angle = std::f64::consts::TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
        let ((sin, cos), up) = (angle.sin_cos(), random.between(-0.02, 0.02));
        let normal = [-cos + random.between(-0.2, 0.2), -sin, random.between(-0.3, 0.3)];
        let finger = spatial::Contact::new([0.04 * cos, 0.04 * sin, up], normal)
            .series_stiffness(random.between(5e3, 5e4), random.between(5e3, 5e4))
            .friction(random.between(0.3, 1.0));
        let is_held = random.uniform() < 0.2;
        let force = random.between(5.0, 20.0);
        fingers.push(if is_held { finger.force(force) } else { finger.pressed_with(force) });
    }
    let mut force = |size: f64| {
        let mut draw = || random.between(-1.0, 1.0);
        let force: [f64; 3] = std::array::from_fn(|_| size * draw());
        spatial::Wrench::force_at(force, std::array::from_fn(|_| 0.02 * draw()))
    };
    let (base, load) = (force(2.0), force(3.0));
    let is_loaded = random.uniform() < 0.5;
    let base = if is_loaded { base } else { spatial::Wrench::ZERO };
    Ok(Scene { grasp: spatial::Grasp::new(fingers)?, base, load })
}

/// A quantity: its need, and whether an amount of it is held.
type Quantity<const C: usize> =
    (fn(&Scene<C>) -> Need<C>, fn(&Scene<C>, f64) -> Result<Option<bool>, grasp_lcp::Error>);

fn squeeze<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::squeeze(scene.load).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.squeezed(x)?.hold(Ramp::load(scene.base, scene.load))?.holds()),
    )
}

fn friction<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::friction(scene.load).on_top_of(scene.base),
        |scene, x| {
            let grasp = scene.grasp.with_friction(|_, mu| if mu > 0.0 { x } else { mu })?;
            Ok(grasp.hold(Ramp::load(scene.base, scene.load))?.holds())
        },
    )
}

fn load<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::load(scene.load).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(scene.base, scene.load * x))?.holds()),
    )
}

fn at_rest<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::load_at_rest(scene.load).on_top_of(rest(scene)),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(rest(scene) * x, scene.load))?.holds()),
    )
}

/// The load at rest; half of the load the other way where there is none.
fn rest<const C: usize>(scene: &Scene<C>) -> grasp_lcp::grasp::Wrench<C> {
    if scene.base == grasp_lcp::grasp::Wrench::ZERO { scene.load * -0.5 } else { scene.base }
}

fn arm<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::arm(scene.load, metre(scene)).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(scene.base, scene.load + metre(scene) * x))?.holds()),
    )
}

/// What a metre more adds to the load: a moment.
fn metre<const C: usize>(scene: &Scene<C>) -> grasp_lcp::grasp::Wrench<C> {
    let size = scene.load.components()[..C].iter().map(|x| x * x).sum::<f64>().sqrt();
    let moment: Vec<_> =
        (0..scene.load.components().len()).map(|k| if k == C { size } else { 0.0 }).collect();
    grasp_lcp::grasp::Wrench::from_components(&moment)
}

/// Asks for amounts in random scenes, and tries others around each answer.
fn is_met<const C: usize>(
    name: &str,
    draw: &dyn Fn(&mut Random) -> Result<Scene<C>, grasp_lcp::Error>,
    (need, tried): Quantity<C>,
) -> Tested {
    let mut wrong = Vec::new();
    let amounts = AMOUNTS[usize::from(samples(SCENES) > SCENES)];
    for number in 0..samples(SCENES) {
        let mut random = seeded(number as u64);
        let scene = draw(&mut random)?;
        let needed = scene.grasp.need(&need(&scene).if_lower_by(0.0, 0.0))?;
        let is_least = needed.quantity.is_least();
        let mut claim = |is_right: bool, what: &str, amount: f64| {
            if !is_right {
                wrong.push(format!("{name} {number}: {what} at {amount}: {needed}"));
            }
        };
        let middle = match &needed.amount {
            Amount::Bound { does, does_not, until, .. } => {
                claim(tried(&scene, *does)? == Some(true), "what does fails", *does);
                claim(tried(&scene, *does_not)? != Some(true), "what does not holds", *does_not);
                if let Some(end) = until {
                    claim(tried(&scene, end.does)? == Some(true), "the far end fails", end.does);
                }
                *does
            }
            Amount::None { best, .. } => *best,
            _ => 1.0,
        };
        for k in 0..amounts {
            let part = (f64::from(k) + random.uniform()) / f64::from(amounts);
            let amount = middle * REACH.powf(2.0 * part - 1.0);
            let holds = tried(&scene, amount)?;
            match &needed.amount {
                Amount::None { .. } => claim(holds != Some(true), "no amount, but one holds", amount),
                Amount::Bound { does, elsewhere, .. } => {
                    let is_beyond = if is_least { amount < *does } else { amount > *does };
                    let is_told = elsewhere.iter().any(|window| {
                        window.from.is_none_or(|from| from <= amount * 1.001)
                            && window.to.is_none_or(|to| amount <= to * 1.001)
                    });
                    claim(!(is_beyond && holds == Some(true)) || is_told, "less would do", amount);
                }
                Amount::Any { to, until, .. } => {
                    let far =
                        until.as_ref().map_or(if is_least { f64::INFINITY } else { 0.0 }, |end| end.does);
                    let is_inside = (amount - to) * (amount - far) < 0.0;
                    claim(!is_inside || holds != Some(false), "any does, but one fails", amount);
                }
                _ => {}
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(20)].join("\n"));
    Ok(())
}

#[test]
fn squeezes() -> Tested {
    is_met("squeeze", &planar, squeeze())?;
    is_met("squeeze in space", &spatial, squeeze())
}

#[test]
fn coefficients() -> Tested {
    is_met("friction", &planar, friction())?;
    is_met("friction in space", &spatial, friction())
}

#[test]
fn loads() -> Tested {
    is_met("load", &planar, load())?;
    is_met("load in space", &spatial, load())
}

#[test]
fn loads_at_rest() -> Tested {
    is_met("load at rest", &planar, at_rest())?;
    is_met("load at rest in space", &spatial, at_rest())
}

#[test]
fn arms() -> Tested {
    is_met("arm", &planar, arm())?;
    is_met("arm in space", &spatial, arm())
}
