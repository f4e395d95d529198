//! Irregular random load programs, as in practice: fingers at unequal heights, friction 0.2 to 0.9, stiffness ratios up to twenty.
//! They have a weight from the start, forces with moments, and fingers that are released and pressed again.

use std::f64::consts::TAU;

use grasp_lcp::{Error, planar, spatial};

use super::splitmix::Random;

/// A grasp, its load at the start, and a load program.
pub struct OddPath<const C: usize> {
    /// The grasp, with default settings.
    pub grasp: grasp_lcp::ask::Grasp<C>,
    /// Load at the start.
    pub start: grasp_lcp::grasp::Wrench<C>,
    /// Legs of the load program.
    pub legs: Vec<grasp_lcp::load_path::Leg<C>>,
}

/// A family of load programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Odd {
    /// A box in three to six fingers at any height. One finger is released and pressed again, and a force with a moment acts, in any order.
    Regrasped,
    /// Contacts anywhere around an object, and one to four legs of loads and commands.
    Handled,
    /// A block on three points that is pushed nearly through its middle.
    Pushed,
}

/// The families in space.
pub const IN_SPACE: [Odd; 3] = [Odd::Regrasped, Odd::Handled, Odd::Pushed];

/// A random number between two positive numbers, uniform in its logarithm.
fn of_any_size(random: &mut Random, from: f64, to: f64) -> f64 {
    from * (to / from).powf(random.uniform())
}

fn vector<const C: usize>(random: &mut Random, size: f64) -> [f64; C] {
    std::array::from_fn(|_| random.between(-size, size))
}

fn direction<const C: usize>(random: &mut Random) -> [f64; C] {
    loop {
        let v: [f64; C] = vector(random, 1.0);
        let square: f64 = v.iter().map(|x| x * x).sum();
        if (0.01..1.0).contains(&square) {
            return v.map(|x| x / square.sqrt());
        }
    }
}

/// A random program of a family in space.
///
/// # Errors
/// Never for random scenes, which are valid.
pub fn in_space(odd: Odd, random: &mut Random) -> Result<OddPath<3>, Error> {
    match odd {
        Odd::Regrasped => regrasped(random),
        Odd::Handled => handled_in_space(random),
        Odd::Pushed => pushed(random),
    }
}

/// A box of 50 by 80 mm, 30 to 150 g, in fingers that press with 1.5 to 8 N each.
fn regrasped(random: &mut Random) -> Result<OddPath<3>, Error> {
    use spatial::{Contact, Grasp, Leg, Wrench};
    let count = random.index(3, 6);
    let mut commands = Vec::new();
    let mut contacts = Vec::new();
    for i in 0..count {
        // The first two fingers are opposite each other, so that the grasp holds the box.
        let face = if i < 2 { i } else { random.index(0, 3) };
        let [along, height] = [random.between(-0.03, 0.03), random.between(-0.015, 0.015)];
        let (point, normal) = match face {
            0 => ([-0.025, along, height], [1.0, 0.0, 0.0]),
            1 => ([0.025, along, height], [-1.0, 0.0, 0.0]),
            2 => ([0.6 * along, 0.04, height], [0.0, -1.0, 0.0]),
            _ => ([0.6 * along, -0.04, height], [0.0, 1.0, 0.0]),
        };
        let stiffness = of_any_size(random, 500.0, 10_000.0);
        let sway = if random.index(0, 2) == 0 { 1.0 } else { 0.0 };
        let press = random.between(1.5, 8.0) / stiffness;
        let command = [press, 0.3 * sway * press * random.between(-1.0, 1.0), 0.1 * sway * press];
        commands.push(command);
        contacts.push(
            Contact::new(point, normal)
                .series_stiffness(stiffness, stiffness * random.between(0.5, 1.0))
                .friction(random.between(0.2, 0.9))
                .command(command),
        );
    }
    let weight = random.between(0.3, 1.5);
    let aside: [f64; 2] = vector(random, 0.003);
    let weight = Wrench::new([0.0, 0.0, -weight], [aside[1] * weight, -aside[0] * weight, 0.0]);
    let size = random.between(0.3, 10.0);
    let way = Wrench::new(vector(random, size), vector(random, 0.02 * size));
    let finger = random.index(0, count - 1);
    let off = random.between(0.5, 2.5);
    let of_finger = |part: f64| {
        let change = (0..count).map(|i| if i == finger { commands[i].map(|a| part * a) } else { [0.0; 3] });
        Leg::commands_by(change.collect::<Vec<_>>())
    };
    let (away, again) = (of_finger(-off), of_finger(off));
    let (push, back) = (Leg::load_by(way), Leg::load_by(way * -1.0));
    let legs = match random.index(0, 4) {
        0 => vec![away, again, push],
        1 => vec![push, away, again],
        2 => vec![push, back, away, again],
        3 => vec![away, push, again],
        _ => vec![away.and_load_by(way), again, back],
    };
    Ok(OddPath { grasp: Grasp::new(contacts)?, start: weight, legs })
}

/// Contacts around an object of about 1 m, and their commands along the normals, m.
struct Around<const C: usize> {
    contacts: Vec<grasp_lcp::grasp::Contact<C>>,
    press: Vec<f64>,
}

fn around<const C: usize>(random: &mut Random, count: usize) -> Around<C> {
    let softest = random.between(100.0, 400.0);
    let mut made = Around { contacts: Vec::new(), press: Vec::new() };
    // Opposite contacts press on each other; contacts at random places may carry no force without a load.
    let opposite = random.index(0, 3) > 0;
    let begin = TAU * random.uniform();
    for i in 0..count {
        let mut out: [f64; C] = direction(random);
        if !opposite {
            // The random direction of the contact is kept.
        } else if C == 2 {
            let (sin, cos) = (begin + TAU * (i as f64 + 0.6 * random.uniform()) / count as f64).sin_cos();
            (out[0], out[1]) = (cos, sin);
        } else if i % 2 == 1 {
            // The contact is roughly opposite the previous contact.
            let before: [f64; C] = std::array::from_fn(|a| made.contacts[i - 1].point()[a]);
            out = std::array::from_fn(|a| 0.4 * out[a] - before[a]);
            let size = out.iter().map(|x| x * x).sum::<f64>().sqrt();
            out = out.map(|x| x / size);
        }
        let arm = random.between(0.5, 1.5);
        let tilt: [f64; C] = vector(random, 0.35);
        let [point, normal] = [out.map(|x| arm * x), std::array::from_fn(|a| tilt[a] - out[a])];
        let stiffness = of_any_size(random, softest, 20.0 * softest);
        let press = random.between(1.5, 8.0) / stiffness;
        let mut command = [0.0; C];
        command[0] = press;
        made.press.push(press);
        made.contacts.push(
            grasp_lcp::grasp::Contact::new(point, normal)
                .series_stiffness(stiffness, stiffness * random.between(0.12, 1.2))
                .friction(random.between(0.2, 0.9))
                .command(command),
        );
    }
    made
}

/// Random changes of commands, of one finger or of all, up to 1.2 times the command that presses.
fn commands<const C: usize>(random: &mut Random, press: &[f64]) -> Vec<[f64; C]> {
    let only = (random.index(0, 2) == 0).then(|| random.index(0, press.len() - 1));
    let change = |(i, press): (usize, &f64)| {
        let change: [f64; C] = vector(random, 1.2 * press);
        if only.is_none_or(|only| only == i) { change } else { [0.0; C] }
    };
    press.iter().enumerate().map(change).collect()
}

fn handled_in_space(random: &mut Random) -> Result<OddPath<3>, Error> {
    use spatial::{Grasp, Leg, Wrench};
    let count = random.index(3, 6);
    let Around { contacts, press } = around::<3>(random, count);
    let wrench = |random: &mut Random| {
        let size = of_any_size(random, 0.1, 10.0);
        Wrench::new(vector(random, size), vector(random, size))
    };
    let start = wrench(random) * if random.index(0, 2) == 0 { 0.0 } else { 0.3 };
    let legs = (0..random.index(1, 4)).map(|_| match random.index(0, 3) {
        0 => Leg::commands_by(commands(random, &press)),
        1 => Leg::commands_by(commands(random, &press)).and_load_by(wrench(random)),
        _ => Leg::load_by(wrench(random)),
    });
    let legs = legs.collect();
    Ok(OddPath { grasp: Grasp::new(contacts)?, start, legs })
}

/// A block on three feet up to 120 mm apart along each axis, pushed at the height of its feet.
fn pushed(random: &mut Random) -> Result<OddPath<3>, Error> {
    use spatial::{Contact, Grasp, Leg, Wrench};
    let friction = random.between(0.2, 0.5);
    let foot = |[x, y]: [f64; 2]| {
        Contact::new([x - 0.05, y - 0.05, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e6, 1e5).friction(friction)
    };
    let feet = match random.index(0, 3) {
        0 => [[0.03, 0.03], [0.063_33, 0.043_33], [0.043_33, 0.063_33]],
        1 => [[0.01, 0.01], [0.01, 0.13], [0.13, 0.01]],
        2 => [[0.03, 0.03], [0.09, 0.03], [0.03, 0.09]],
        _ => [[0.01, 0.01], [0.09, 0.03], [0.01, 0.13]],
    };
    let weight = 14.876_4;
    let [toward]: [[f64; 2]; 1] = [direction(random)];
    let miss = of_any_size(random, 1e-5, 0.05) * if random.index(0, 1) == 0 { 1.0 } else { -1.0 };
    let push = 2.0 * weight;
    let way = Wrench::new([push * toward[0], push * toward[1], 0.0], [0.0, 0.0, push * miss]);
    let grasp = Grasp::new(feet.map(foot))?;
    Ok(OddPath { grasp, start: Wrench::force([0.0, 0.0, -weight]), legs: vec![Leg::load_by(way)] })
}

/// Contacts anywhere around an object in the plane, and one to four legs of loads and commands.
///
/// # Errors
/// Never for random scenes, which are valid.
pub fn in_the_plane(random: &mut Random) -> Result<OddPath<2>, Error> {
    use planar::{Grasp, Leg, Wrench};
    let count = random.index(2, 5);
    let Around { contacts, press } = around::<2>(random, count);
    let wrench = |random: &mut Random| {
        let size = of_any_size(random, 0.1, 10.0);
        Wrench::new(vector(random, size), random.between(-size, size))
    };
    let start = wrench(random) * if random.index(0, 2) == 0 { 0.0 } else { 0.3 };
    let legs = (0..random.index(1, 4)).map(|_| match random.index(0, 3) {
        0 => Leg::commands_by(commands(random, &press)),
        1 => Leg::commands_by(commands(random, &press)).and_load_by(wrench(random)),
        _ => Leg::load_by(wrench(random)),
    });
    let legs = legs.collect();
    Ok(OddPath { grasp: Grasp::new(contacts)?, start, legs })
}
