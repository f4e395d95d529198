//! Checks the least or greatest amounts that `need` finds, on random scenes: `hold` decides for many amounts around each answer whether the grasp
//! holds.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "few fingers")]

use std::f64::consts::TAU;
use std::time::Instant;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::need::{Amount, FarEnd, Need, Needed, TriedAmounts};
use grasp_lcp::{Error, planar, spatial};

use crate::splitmix::Random;

/// Amounts from the answer divided by this factor up to the answer times this factor are tried.
const REACH: f64 = 16.0;

/// A grasp with a load at rest, and a load that is applied in addition.
pub struct Scene<const C: usize> {
    grasp: Grasp<C>,
    fingers: Vec<(Contact<C>, Press)>,
    base: Wrench<C>,
    load: Wrench<C>,
}

/// The way in which a finger is pressed, with its normal force, N.
#[derive(Clone, Copy)]
enum Press {
    Command(f64),
    Force(f64),
    Nothing,
}

impl Press {
    fn put_on<const C: usize>(self, finger: &Contact<C>, times: f64) -> Contact<C> {
        let finger = finger.clone();
        match self {
            Self::Command(force) => finger.pressed_with(force * times),
            Self::Force(force) => finger.force(force * times),
            Self::Nothing => finger,
        }
    }
}

impl<const C: usize> Scene<C> {
    fn of(fingers: Vec<(Contact<C>, Press)>, base: Wrench<C>, load: Wrench<C>) -> Result<Self, Error> {
        let grasp = Grasp::new(fingers.iter().map(|(finger, press)| press.put_on(finger, 1.0)))?;
        Ok(Self { grasp, fingers, base, load })
    }

    /// The grasp with the force of its first pressed finger multiplied by `times`.
    fn pressed(&self, times: f64) -> Result<Grasp<C>, Error> {
        let presser = self.presser();
        let scaled = |(i, (finger, press)): (usize, &(Contact<C>, Press))| {
            press.put_on(finger, if Some(i) == presser { times } else { 1.0 })
        };
        Grasp::new(self.fingers.iter().enumerate().map(scaled))
    }

    fn presser(&self) -> Option<usize> {
        self.fingers.iter().position(|(_, press)| !matches!(press, Press::Nothing))
    }
}

/// Fingers around a part or anywhere on it, pressed by commands or by forces, or idle. The load at rest is a weight or zero.
pub fn planar(random: &mut Random) -> Result<Scene<2>, Error> {
    let count = 2 + (3.0 * random.uniform()) as usize;
    let is_around = random.uniform() < 0.6;
    let mut fingers = Vec::new();
    for i in 0..count {
        let around = TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
        let angle = if is_around { around } else { random.between(0.0, TAU) };
        let ((sin, cos), off) = (angle.sin_cos(), random.between(-0.02, 0.02));
        let point = [0.04 * cos + off * sin, 0.04 * sin - off * cos];
        let finger = planar::Contact::new(point, [-cos, -sin])
            .name(format!("finger {i}"))
            .series_stiffness(random.between(5e3, 5e4), random.between(5e3, 5e4))
            .friction(if random.uniform() < 0.1 { 0.0 } else { random.between(0.2, 1.0) });
        let drawn = random.uniform();
        let press = if drawn < 0.55 {
            Press::Command(random.between(5.0, 20.0))
        } else if drawn < 0.8 {
            Press::Force(random.between(2.0, 20.0))
        } else {
            Press::Nothing
        };
        fingers.push((finger, press));
    }
    let mut force = |size: f64| {
        let angle = random.between(0.0, TAU);
        let at = [random.between(-0.02, 0.02), random.between(-0.02, 0.02)];
        planar::Wrench::force_at([size * angle.cos(), size * angle.sin()], at)
    };
    let (base, load) = (force(3.0), force(4.0));
    let is_loaded = random.uniform() < 0.5;
    Scene::of(fingers, if is_loaded { base } else { Wrench::ZERO }, load)
}

/// Three or four fingers around a part in space, pressed by commands or by forces.
pub fn spatial(random: &mut Random) -> Result<Scene<3>, Error> {
    let count = 3 + (2.0 * random.uniform()) as usize;
    let mut fingers = Vec::new();
    for i in 0..count {
        let angle = TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
        let ((sin, cos), up) = (angle.sin_cos(), random.between(-0.02, 0.02));
        let normal = [-cos + random.between(-0.2, 0.2), -sin, random.between(-0.3, 0.3)];
        let finger = spatial::Contact::new([0.04 * cos, 0.04 * sin, up], normal)
            .name(format!("finger {i}"))
            .series_stiffness(random.between(5e3, 5e4), random.between(5e3, 5e4))
            .friction(random.between(0.3, 1.0));
        let is_held = random.uniform() < 0.2;
        let force = random.between(5.0, 20.0);
        fingers.push((finger, if is_held { Press::Force(force) } else { Press::Command(force) }));
    }
    let mut force = |size: f64| {
        let mut draw = || random.between(-1.0, 1.0);
        let force: [f64; 3] = std::array::from_fn(|_| size * draw());
        spatial::Wrench::force_at(force, std::array::from_fn(|_| 0.02 * draw()))
    };
    let (base, load) = (force(2.0), force(3.0));
    let is_loaded = random.uniform() < 0.5;
    Scene::of(fingers, if is_loaded { base } else { Wrench::ZERO }, load)
}

/// A sought quantity: the question for `need`, and whether `hold` says that the grasp holds with a given amount of it.
pub type Quantity<const C: usize> =
    (fn(&Scene<C>) -> Need<C>, fn(&Scene<C>, f64) -> Result<Option<bool>, Error>);

/// The sought quantity squeeze: a factor on the commands and forces with which fingers press.
pub fn squeeze<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::squeeze(scene.load).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.squeezed(x)?.hold(Ramp::load(scene.base, scene.load))?.holds()),
    )
}

/// The sought quantity friction: the coefficient of all fingers that have friction, or of all fingers if none has.
pub fn friction<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::friction(scene.load).on_top_of(scene.base),
        |scene, x| {
            let none = scene.grasp.contacts().iter().all(|finger| finger.friction_coefficient() == 0.0);
            let grasp = scene.grasp.with_friction(|_, mu| if mu > 0.0 || none { x } else { mu })?;
            Ok(grasp.hold(Ramp::load(scene.base, scene.load))?.holds())
        },
    )
}

/// The sought quantity load: a multiple of the applied load.
pub fn load<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::load(scene.load).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(scene.base, scene.load * x))?.holds()),
    )
}

/// The sought quantity load at rest: a multiple of the constant base load.
pub fn at_rest<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::load_at_rest(scene.load).on_top_of(rest(scene)),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(rest(scene) * x, scene.load))?.holds()),
    )
}

/// The load at rest of the scene. If the scene has none, half of its load in the opposite direction.
fn rest<const C: usize>(scene: &Scene<C>) -> Wrench<C> {
    if scene.base == Wrench::ZERO { scene.load * -0.5 } else { scene.base }
}

/// The sought quantity arm: a displacement of the load's line of action, m.
pub fn arm<const C: usize>() -> Quantity<C> {
    (
        |scene| Need::arm(scene.load, metre(scene)).on_top_of(scene.base),
        |scene, x| Ok(scene.grasp.hold(Ramp::load(scene.base, scene.load + metre(scene) * x))?.holds()),
    )
}

/// Change of the load for one more metre of arm: a moment.
fn metre<const C: usize>(scene: &Scene<C>) -> Wrench<C> {
    let size = scene.load.components()[..C].iter().map(|x| x * x).sum::<f64>().sqrt();
    let moment: Vec<_> =
        (0..scene.load.components().len()).map(|k| if k == C { size } else { 0.0 }).collect();
    Wrench::from_components(&moment)
}

/// The force of the first finger that is pressed by a command or a force. If no finger is pressed, the squeeze.
pub fn force<const C: usize>() -> Quantity<C> {
    (
        |scene| match scene.presser() {
            Some(i) => Need::force(format!("finger {i}"), scene.load).on_top_of(scene.base),
            None => Need::squeeze(scene.load).on_top_of(scene.base),
        },
        |scene, x| Ok(scene.pressed(x)?.hold(Ramp::load(scene.base, scene.load))?.holds()),
    )
}

/// The comparison of one answer of `need` with verdicts of `hold`.
pub struct Checked {
    /// A sentence for each statement of the answer that the verdict on some amount contradicts.
    pub wrong: Vec<String>,
    /// Whether the answer gives no amount, because a verdict of its search was undecided.
    pub is_undecided: bool,
    /// Number of amounts that the search tried, if the answer gives it.
    pub tried: Option<usize>,
    /// Run times of `need` and, on average, of `hold`, s.
    pub times: [f64; 2],
}

/// Asks `need` for the amount, and checks the answer with verdicts on `amounts` further amounts. These are random, one in each of equal intervals of
/// the logarithm.
pub fn checked<const C: usize>(
    scene: &Scene<C>,
    (need, tried): Quantity<C>,
    amounts: i32,
    random: &mut Random,
) -> Result<Checked, Error> {
    let begin = Instant::now();
    let needed = scene.grasp.need(&need(scene).if_lower_by(0.0, 0.0))?;
    let time = begin.elapsed().as_secs_f64();
    let is_least = needed.quantity.is_least();
    // If no finger is pressed by a command, the answer is a multiple of the load at rest instead of the squeeze.
    let tried = if needed.in_place_of_squeeze && needed.of.is_some() { at_rest().1 } else { tried };
    let mut wrong = Vec::new();
    let mut claim = |is_right: bool, what: &str, amount: f64| {
        if !is_right {
            wrong.push(format!("{what} {amount}: {needed}"));
        }
    };
    // This module multiplies a force and computes the command from it, the library multiplies the command. Their results differ in the last digits.
    let off = if needed.of.is_some() { 1e-12 } else { 0.0 };
    let middle = match &needed.amount {
        Amount::Bound { sufficient, insufficient, until, .. } => {
            claim(tried(scene, sufficient * (1.0 + off))? == Some(true), "what does fails", *sufficient);
            claim(tried(scene, insufficient * (1.0 - off))? != Some(true), "less does, too", *insufficient);
            if let Some(end) = until {
                let inwards = if end.sufficient > end.insufficient { 1.0 + off } else { 1.0 - off };
                claim(tried(scene, end.sufficient * inwards)? == Some(true), "far end fails", end.sufficient);
            }
            *sufficient
        }
        Amount::None { best, .. } => *best,
        _ => 1.0,
    };
    let begin = Instant::now();
    for k in 0..amounts {
        let part = (f64::from(k) + random.uniform()) / f64::from(amounts);
        let amount = middle * REACH.powf(2.0 * part - 1.0);
        let holds = tried(scene, amount)?;
        match &needed.amount {
            Amount::None { .. } => claim(holds != Some(true), "one holds", amount),
            Amount::Bound { sufficient, elsewhere, until, tried, .. } => {
                let is_beyond = if is_least { amount < *sufficient } else { amount > *sufficient };
                let is_told = elsewhere.iter().any(|window| {
                    window.from.is_none_or(|from| from <= amount * 1.001)
                        && window.to.is_none_or(|to| amount <= to * 1.001)
                });
                claim(!(is_beyond && holds == Some(true)) || is_told, "less would do", amount);
                let far = far_end(until.as_ref(), *tried, is_least);
                let is_inside = (amount - sufficient) * (amount - far) < 0.0;
                claim(!is_inside || holds != Some(false), "one fails", amount);
            }
            Amount::Any { to, until, tried, .. } => {
                let far = far_end(until.as_ref(), *tried, is_least);
                let is_inside = (amount - to) * (amount - far) < 0.0;
                claim(!is_inside || holds != Some(false), "one fails", amount);
            }
            _ => {}
        }
    }
    let times = [time, begin.elapsed().as_secs_f64() / f64::from(amounts)];
    let is_undecided = matches!(needed.amount, Amount::Undecided { .. });
    Ok(Checked { wrong, is_undecided, tried: count(&needed), times })
}

/// The end, farthest from the bound found, of the amounts that an answer claims to suffice. It is the end `until` if given, else the last amount
/// tried, else there is no end.
fn far_end(until: Option<&FarEnd>, tried: Option<TriedAmounts>, is_least: bool) -> f64 {
    let open = if is_least { f64::INFINITY } else { 0.0 };
    let last = tried.map_or(open, |tried| if is_least { tried.to } else { tried.from });
    until.map_or(last, |end| end.sufficient)
}

fn count(needed: &Needed) -> Option<usize> {
    match &needed.amount {
        Amount::None { tried, .. } => Some(*tried),
        Amount::Bound { tried: Some(TriedAmounts { count, .. }), .. }
        | Amount::Any { tried: Some(TriedAmounts { count, .. }), .. } => Some(*count),
        _ => None,
    }
}
