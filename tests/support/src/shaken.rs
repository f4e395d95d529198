//! Random grasps under a load that repeats, and a check of their verdicts by following single cycles.

use crate::splitmix::Random;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Twist, Wrench};
use grasp_lcp::load_path::{Leg, PathEnd, Ramp};
use grasp_lcp::shake::{Repeats, Shaken};
use grasp_lcp::{Error, planar, spatial};
use nalgebra::DVector;

/// Rounding of a motion, relative to the displacement of the object.
const ROUNDING: f64 = 1e-13;
/// Changes of forces below this fraction of the largest force are treated as no change.
const STILL: f64 = 1e-8;
/// The largest number of cycles that are followed.
const MOST: usize = 400;

/// A grasp, the load at rest, and the legs of a cycle.
pub struct Cycle<const C: usize> {
    /// The grasp.
    pub grasp: Grasp<C>,
    /// Load at rest.
    pub base: Wrench<C>,
    /// Legs of one cycle.
    pub legs: Vec<Leg<C>>,
}

/// Two to five fingers around a disc under its weight. Two to four accelerations act in turn, with sizes of 0.7 to 2.5 times the first slip.
pub fn in_the_plane(random: &mut Random) -> Result<Cycle<2>, Error> {
    let (count, loads) = (random.index(2, 5), random.index(2, 4));
    let from = random.between(0.0, std::f64::consts::TAU);
    let fingers = (0..count).map(|i| {
        let angle = from + std::f64::consts::TAU * (i as f64 + random.between(-0.15, 0.15)) / count as f64;
        let lean = angle + random.between(-0.3, 0.3);
        let press = random.between(5.0, 30.0);
        planar::Contact::new([0.05 * angle.cos(), 0.05 * angle.sin()], [-lean.cos(), -lean.sin()])
            .series_stiffness(10f64.powf(random.between(3.0, 5.0)), 10f64.powf(random.between(3.0, 5.0)))
            .friction(random.between(0.2, 1.0))
            .pressed_with(press)
    });
    let grasp = Grasp::new(fingers.collect::<Vec<_>>())?;
    let base = planar::Wrench::new([0.0, -random.between(0.0, 4.0)], 0.0);
    let loads: Vec<_> = (0..loads)
        .map(|_| {
            let angle = random.between(0.0, std::f64::consts::TAU);
            planar::Wrench::new([angle.cos(), angle.sin()], 0.03 * random.between(-1.0, 1.0))
        })
        .collect();
    turned_up(grasp, base, &loads, random.between(0.7, 2.5))
}

/// A block on two to five feet under a steady pull, rocked to and fro, so that it may walk.
pub fn rocked_in_the_plane(random: &mut Random) -> Result<Cycle<2>, Error> {
    let count = random.index(2, 5);
    let friction = random.between(0.2, 1.0);
    let feet = (0..count).map(|i| {
        let x = 2.0 * (i as f64 + random.between(-0.2, 0.2)) / (count - 1) as f64 - 1.0;
        planar::Contact::new([x, random.between(-0.1, 0.1)], [random.between(-0.2, 0.2), 1.0])
            .series_stiffness(10f64.powf(random.between(3.0, 5.0)), 10f64.powf(random.between(3.0, 5.0)))
            .friction(friction)
    });
    let grasp = Grasp::new(feet.collect::<Vec<_>>())?;
    let weight = random.between(5.0, 20.0);
    let base = planar::Wrench::new([random.between(-0.7, 0.7) * friction * weight, -weight], 0.0);
    let rock = random.between(0.2, 0.8) * weight;
    let legs = [rock, -rock].map(|moment| {
        let lift = random.between(-0.1, 0.1) * weight;
        Leg::there_and_back(planar::Wrench::new([0.0, lift], moment))
    });
    Ok(Cycle { grasp, base, legs: legs.concat() })
}

/// A plate on three to five feet under a steady pull, rocked about two axes.
pub fn rocked_in_space(random: &mut Random) -> Result<Cycle<3>, Error> {
    let count = random.index(3, 5);
    let friction = random.between(0.2, 1.0);
    let feet = (0..count).map(|i| {
        let angle = std::f64::consts::TAU * (i as f64 + random.between(-0.2, 0.2)) / count as f64;
        spatial::Contact::new([angle.cos(), angle.sin(), 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(10f64.powf(random.between(3.0, 5.0)), 10f64.powf(random.between(3.0, 5.0)))
            .friction(friction)
    });
    let grasp = Grasp::new(feet.collect::<Vec<_>>())?;
    let weight = random.between(5.0, 20.0);
    let pull = random.between(0.0, 0.7) * friction * weight;
    let base = spatial::Wrench::new([pull, 0.0, -weight], [0.0; 3]);
    let rock = random.between(0.1, 0.4) * weight;
    let legs = [[rock, 0.0, 0.0], [0.0, rock, 0.0], [-rock, 0.0, 0.0], [0.0, -rock, 0.0]]
        .map(|moment| Leg::there_and_back(spatial::Wrench::new([0.0; 3], moment)));
    Ok(Cycle { grasp, base, legs: legs.concat() })
}

/// The same cycle with friction that falls by up to 30 % once contacts slide.
pub fn weaker_once_it_slides<const C: usize>(
    cycle: Cycle<C>,
    random: &mut Random,
) -> Result<Cycle<C>, Error> {
    let weaker = |contact: &grasp_lcp::grasp::Contact<C>| {
        contact.clone().kinetic(contact.friction_coefficient() * (1.0 - 0.3 * random.uniform()))
    };
    let grasp = Grasp::new(cycle.grasp.contacts().iter().map(weaker).collect::<Vec<_>>())?;
    Ok(Cycle { grasp, ..cycle })
}

/// A roller on `springs` springs, pressed with force P and sheared by `part` μ P. The moment rocks P to and fro by `w` half widths of the contact.
pub fn roller(springs: i32, w: f64, part: f64) -> Result<Cycle<2>, Error> {
    // The half width of the contact is 1; the springs are compressed by `depth` in the middle.
    let (k, depth, mu) = (1e3, 1e-3, 0.4);
    let h = 2.8 / f64::from(springs);
    let spring = |i: i32| {
        let x = h * (f64::from(i) - 0.5 * f64::from(springs - 1));
        planar::Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(k * h, k * h)
            .friction(mu)
            .command([-depth * x * x, 0.0])
    };
    let grasp = Grasp::new((0..springs).map(spring))?;
    let pressed = k * depth * 4.0 / 3.0;
    let base = planar::Wrench::new([part * mu * pressed, -pressed], 0.0);
    let legs = [w, -w].map(|w| Leg::there_and_back(planar::Wrench::new([0.0, 0.0], w * pressed)));
    Ok(Cycle { grasp, base, legs: legs.concat() })
}

/// The largest shear, as a part of μ P, under which the roller comes to rest, to about a thousandth. `None` if a verdict is undecided.
pub fn roller_rests_up_to(springs: i32, w: f64) -> Result<Option<f64>, Error> {
    let (mut below, mut above) = (0.0, 1.0);
    for _ in 0..10 {
        let middle = 0.5 * (below + above);
        let cycle = roller(springs, w, middle)?;
        match cycle.grasp.shake(cycle.base, &cycle.legs)?.rests() {
            Some(true) => below = middle,
            Some(false) => above = middle,
            None => return Ok(None),
        }
    }
    Ok(Some(0.5 * (below + above)))
}

/// Three to five fingers around a ball under its weight, with accelerations to and fro along three axes.
pub fn in_space(random: &mut Random) -> Result<Cycle<3>, Error> {
    let count = random.index(3, 5);
    let from = random.between(0.0, std::f64::consts::TAU);
    let fingers = (0..count).map(|i| {
        let angle = from + std::f64::consts::TAU * (i as f64 + random.between(-0.15, 0.15)) / count as f64;
        let height: f64 = random.between(-0.4, 0.4);
        let normal = [-angle.cos() * height.cos(), -angle.sin() * height.cos(), -height.sin()];
        spatial::Contact::new(normal.map(|x| -0.04 * x), normal)
            .series_stiffness(10f64.powf(random.between(3.0, 5.0)), 10f64.powf(random.between(3.0, 5.0)))
            .friction(random.between(0.3, 1.0))
            .pressed_with(random.between(5.0, 30.0))
    });
    let grasp = Grasp::new(fingers.collect::<Vec<_>>())?;
    let weight = random.between(0.5, 4.0);
    let base = spatial::Wrench::new([0.0, 0.0, -weight], [0.0; 3]);
    let loads = [0, 1, 2, 3, 4, 5].map(|k| {
        let mut force = [0.0; 3];
        force[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
        spatial::Wrench::new(force, [0.0; 3])
    });
    turned_up(grasp, base, &loads, random.between(0.7, 2.5))
}

/// A cycle of these loads, each scaled to `times` the least factor at which one of them makes a contact slide.
fn turned_up<const C: usize>(
    grasp: Grasp<C>,
    base: Wrench<C>,
    loads: &[Wrench<C>],
    times: f64,
) -> Result<Cycle<C>, Error> {
    let mut least = 1e3;
    for load in loads {
        if let Some(first) = grasp.hold(Ramp::load(base, *load))?.first_slip {
            least = first.factor.min(least);
        }
    }
    let legs = loads.iter().flat_map(|load| Leg::there_and_back(*load * (times * least))).collect();
    Ok(Cycle { grasp, base, legs })
}

/// The contradiction between a verdict and cycles that are followed one after the other; `None` if they agree.
///
/// The function follows `cycles` cycles, or the number to which the verdict refers. Amounts may differ by `error`, relative to the largest.
pub fn fault<const C: usize>(
    cycle: &Cycle<C>,
    shaken: &Shaken<C>,
    cycles: usize,
    error: f64,
) -> Result<Option<String>, Error> {
    let cycles = match shaken.repeats {
        Repeats::Lost { cycle, .. } => cycles.max(cycle),
        _ if shaken.ratio > 0.0 => shaken.cycles + until(shaken.ratio, error * error),
        // A walk that still changes is compared at the cycle of the verdict.
        Repeats::Walks { .. } if shaken.change > STILL => shaken.cycles,
        _ => cycles.max(shaken.cycles + 5 * shaken.every),
    };
    // If the verdict refers to more than `MOST` cycles, only the first 100 are followed, and checked for a loss alone.
    let (is_all, cycles) = (cycles <= MOST, if cycles <= MOST { cycles } else { 100 });
    let mut path = cycle.grasp.follow(cycle.base, &[])?;
    path.by_ref().for_each(drop);
    if !matches!(path.end(), Some(PathEnd::Completed)) {
        let right = matches!(shaken.repeats, Repeats::NoRest { .. });
        return Ok((!right).then(|| "no rest".to_owned()));
    }
    let rest = path.state().map(|state| numbers(&state.twist));
    let (mut heats, mut twists) = (Vec::new(), vec![rest]);
    for k in 1..=cycles {
        path.continue_with(&cycle.legs)?;
        path.by_ref().for_each(drop);
        match path.end() {
            Some(PathEnd::Completed) => {}
            Some(PathEnd::Lost(_)) => {
                let right = matches!(shaken.repeats, Repeats::Lost { cycle, .. } if cycle == k);
                return Ok((!right).then(|| format!("lost in cycle {k}")));
            }
            Some(PathEnd::Undecided { doubt, .. }) => {
                // A path may end undecided once its slips have nearly died out.
                let died_out = shaken.ratio > 0.0 && until(shaken.ratio, 1e-6) < k;
                let right = died_out || matches!(shaken.repeats, Repeats::Undecided { .. });
                return Ok((!right).then(|| format!("cycle {k}: {doubt}")));
            }
            _ => return Ok(Some(format!("endless cycle {k}"))),
        }
        let legs = path.energies().len();
        heats.push(path.energies()[legs - cycle.legs.len()..].iter().map(|leg| leg.dissipated).sum::<f64>());
        twists.push(path.state().map(|state| numbers(&state.twist)));
    }
    if !is_all {
        return Ok(None);
    }
    let (Some(Some(first)), Some(Some(before)), Some(Some(last))) =
        (twists.first(), twists.get(cycles - shaken.every), twists.last())
    else {
        return Ok(Some("no state".to_owned()));
    };
    let heat = heats[cycles - shaken.every..].iter().sum::<f64>();
    let most_heat = heats.iter().copied().fold(0.0, f64::max);
    let step = last - before;
    let most = twists
        .windows(2)
        .filter_map(|two| Some((two[1].as_ref()? - two[0].as_ref()?).norm()))
        .fold(0.0, f64::max);
    // Allowed distance of the last cycle from the limit cycle.
    let left = error + shaken.ratio.powf(0.5 * cycles.saturating_sub(shaken.cycles) as f64);
    let right = match &shaken.repeats {
        Repeats::Rests { after, .. } => {
            // If no contact ever slides, motion and step are both rounding.
            let moved = error * most + ROUNDING * last.norm();
            heats[*after..].iter().all(|heat| *heat <= error * most_heat) && step.norm() <= moved
        }
        Repeats::DiesOut { .. } => {
            let moved = numbers(&shaken.moved[0].twist);
            (last - first - &moved).norm() <= left * moved.norm().max(most) && heat <= left * most_heat
        }
        Repeats::Alternates { dissipated, .. } => {
            (heat - dissipated).abs() <= left * most_heat && step.norm() <= left * most
        }
        Repeats::Walks { by, dissipated, .. } => {
            (heat - dissipated).abs() <= left * most_heat
                && (numbers(&by[0].twist) - &step).norm() <= left * most
        }
        Repeats::Undecided { .. } => true,
        _ => false,
    };
    Ok((!right).then(|| format!("heat {heat} of {most_heat}, step {} of {most}", step.norm())))
}

/// The number of cycles n with `ratio^n > part`; a million at most.
fn until(ratio: f64, part: f64) -> usize {
    let mut left = 1.0;
    (0..1_000_000)
        .take_while(|_| {
            left *= ratio;
            left > part
        })
        .count()
}

fn numbers<const C: usize>(twist: &Twist<C>) -> DVector<f64> {
    DVector::from_column_slice(twist.components())
}
