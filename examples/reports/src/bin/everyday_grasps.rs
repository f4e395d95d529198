//! Everyday grasps in space far beyond the onset of sliding: how many equilibria and load paths are decided, and how long does it take?
//!
//! Three to twelve fingers in a ring, on two faces or over a ball, with a growing weight, a push or a twist, and default settings. Loads are
//! multiples of the load at the onset of sliding. Each path goes from no load until it ends, or to ten times the squeeze. Pinches of soft fingertips
//! follow, and odd load programs: fingers at unequal heights, uneven friction and stiffness, a weight held before, forces with moments, fingers
//! released and pressed on again. For these the state is computed at 2 001 fractions.
//!
//! `cargo run --release -p reports --bin everyday_grasps [-- number of grasps of each kind]` (4 by default)

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::time::Instant;

use grasp_lcp::equilibrium::{Outcome as OutcomeOf, Proof};
use grasp_lcp::load_path::{LossKind, PathEnd as EndOf};
use grasp_lcp::spatial::{Beyond, Contact, Grasp, Leg, Outcome, PathEnd, Wrench};
use support::odd_paths::{IN_SPACE, OddPath, in_space, in_the_plane};
use support::soft_tips::draw;
use support::splitmix::Random;

type Failure = Box<dyn std::error::Error>;

const PARTS: [f64; 4] = [0.5, 1.15, 2.5, 6.0];

/// A random direction, uniform over the sphere.
fn direction(numbers: &mut Random) -> [f64; 3] {
    loop {
        let v = numbers.vector();
        let square: f64 = v.iter().map(|x| x * x).sum();
        if (0.01..1.0).contains(&square) {
            return v.map(|x| x / square.sqrt());
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Place {
    Ring,
    Faces,
    Ball,
}

#[derive(Clone, Copy, Debug)]
enum Load {
    Weight,
    Push,
    Twist,
}

/// Fingers that press with 5 to 15 N.
fn grasp(place: Place, count: usize, numbers: &mut Random) -> Result<Grasp, grasp_lcp::Error> {
    let contact = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / count as f64 + 0.3 * numbers.signed()).sin_cos();
        let mut near = |x: f64| 0.1 * numbers.signed() - x;
        let (point, normal) = match place {
            Place::Ring => {
                let normal = [-cos, -sin, 2.0 * near(0.0)];
                ([cos, sin, 3.0 * near(0.0)], normal)
            }
            Place::Faces => {
                let side = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
                let normal = [near(0.0), near(0.0), -side];
                ([8.0 * near(0.0), 8.0 * near(0.0), side], normal)
            }
            Place::Ball => {
                let point = direction(numbers);
                (point, point.map(|x| 0.1 * numbers.signed() - x))
            }
        };
        let stiffness = 1000.0 * (0.3 * numbers.signed()).exp();
        Contact::new(point, normal)
            .series_stiffness(stiffness, stiffness * (0.75 + 0.15 * numbers.signed()))
            .friction(0.45 + 0.15 * numbers.signed())
            .command([0.01 + 0.005 * numbers.signed(), 0.0, 0.0])
    };
    Grasp::new((0..count).map(contact).collect::<Vec<_>>())
}

fn load(load: Load, numbers: &mut Random) -> Wrench {
    match load {
        Load::Weight => Wrench::force([0.0, 0.0, -100.0]),
        Load::Push => Wrench::force(direction(numbers).map(|x| 100.0 * x)),
        Load::Twist => Wrench::new([0.0, 0.0, -5.0], direction(numbers).map(|x| 70.0 * x)),
    }
}

/// Run times, ms, and the number of answers of each kind.
#[derive(Default)]
struct Tally {
    times: Vec<f64>,
    answers: BTreeMap<&'static str, usize>,
}

impl Tally {
    fn add(&mut self, answer: &'static str, start: Instant) {
        self.times.push(1e3 * start.elapsed().as_secs_f64());
        *self.answers.entry(answer).or_default() += 1;
    }

    fn print(&mut self, name: &str) {
        self.times.sort_by(f64::total_cmp);
        let last = self.times.len() - 1;
        let time = |hundredths: usize| self.times[last * hundredths / 100];
        let answers: Vec<_> =
            self.answers.iter().map(|(answer, count)| format!("{count} {answer}")).collect();
        println!(
            "  {name:32} {:5}   {:8.3} {:8.2} {:8.1} ms   {}",
            self.times.len(),
            time(50),
            time(99),
            time(100),
            answers.join(", ")
        );
    }
}

fn main() -> Result<(), Failure> {
    let each = std::env::args().nth(1).map_or(Ok(4), |text| text.parse::<usize>())?;
    let places = [Place::Ring, Place::Faces, Place::Ball];
    let loads = [Load::Weight, Load::Push, Load::Twist];
    let mut escape = f64::INFINITY;
    println!("  equilibria                       loads     median     99 %  longest");
    for count in [3, 4, 5, 6, 8, 12] {
        let mut tallies = PARTS.map(|_| Tally::default());
        let mut numbers = Random(count as u64);
        for (place, kind) in places.into_iter().flat_map(|place| loads.map(|load| (place, load))) {
            for _ in 0..each {
                let grasp = grasp(place, count, &mut numbers)?;
                let direction = load(kind, &mut numbers);
                let onset = grasp.onset(direction)?;
                let Some(onset) = onset.factor().filter(|factor| factor.is_finite()) else { continue };
                for (part, tally) in PARTS.into_iter().zip(&mut tallies) {
                    let (load, start) = (direction * (part * onset), Instant::now());
                    let outcome = grasp.solve(load)?;
                    tally.add(answer(&outcome), start);
                    if let Outcome::NoEquilibrium(none) = &outcome
                        && let Proof::EveryCaseContradicted { escape: this, .. } = none.proof
                    {
                        escape = escape.min(this);
                    }
                }
            }
        }
        for (part, tally) in PARTS.iter().zip(&mut tallies) {
            tally.print(&format!("{count} fingers, {part} times the onset"));
        }
    }
    println!("  What could escape a proof would have to exceed the data {escape:.0e} times.\n");
    println!("  load paths                       paths     median     99 %  longest");
    let mut beyond = Tally::default();
    for place in places {
        for kind in loads {
            let mut tally = Tally::default();
            let mut numbers = Random(1);
            for count in [3, 4, 5, 6].into_iter().flat_map(|count| std::iter::repeat_n(count, each)) {
                let grasp = grasp(place, count, &mut numbers)?;
                let leg = Leg::load_to(load(kind, &mut numbers));
                let start = Instant::now();
                let mut path = grasp.follow(Wrench::ZERO, &[leg])?;
                path.run();
                tally.add(end(path.end()), start);
                let start = Instant::now();
                let answer = match path.beyond() {
                    Some(Beyond::LimitLoad) => "limit loads",
                    Some(Beyond::Snap) => "snaps",
                    Some(_) => "not known",
                    None => continue,
                };
                beyond.add(answer, start);
            }
            tally.print(&format!("{place:?}, {kind:?}"));
        }
    }
    beyond.print("what lies beyond their ends");
    soft_tips(30 * each)?;
    odd_paths(100 * each)
}

/// Number of states requested of each odd path, over all legs.
const FRACTIONS: usize = 2001;

/// Follows `count` odd load programs of each family. Prints how the load paths end, and whether the state is known at every fraction that was
/// passed.
fn odd_paths(count: usize) -> Result<(), Failure> {
    println!("\n  odd programs                     paths     median     99 %  longest");
    let mut untold = [0, 0];
    for odd in IN_SPACE {
        let (mut tally, mut random) = (Tally::default(), Random(1));
        for _ in 0..count {
            followed(&in_space(odd, &mut random)?, &mut tally, &mut untold)?;
        }
        tally.print(&format!("{odd:?}, in space"));
    }
    let (mut tally, mut random) = (Tally::default(), Random(1));
    for _ in 0..count {
        followed(&in_the_plane(&mut random)?, &mut tally, &mut untold)?;
    }
    tally.print("Handled, in the plane");
    let [untold, asked] = untold;
    println!("  Of {asked} states on the way {untold} are not told.");
    Ok(())
}

/// Follows a load program. Counts the equilibria that are requested along its path (`asked`), and the requested equilibria that the path does not
/// give (`untold`).
fn followed<const C: usize>(
    odd: &OddPath<C>,
    tally: &mut Tally,
    [untold, asked]: &mut [usize; 2],
) -> Result<(), Failure> {
    let start = Instant::now();
    let mut path = odd.grasp.follow(odd.start, &odd.legs)?;
    path.run();
    tally.add(end(path.end()), start);
    let (last, most) = path.place();
    let (legs, started) = (odd.legs.len(), path.state().is_some());
    for k in (0..FRACTIONS).filter(|_| started) {
        let along = legs as f64 * k as f64 / (FRACTIONS - 1) as f64;
        let leg = (0..legs).rfind(|leg| along >= *leg as f64).unwrap_or(0);
        let fraction = along - leg as f64;
        if leg < last || (leg == last && fraction <= most) {
            *asked += 1;
            *untold += usize::from(path.state_at(leg, fraction).is_none());
        }
    }
    Ok(())
}

/// Pinches of two or three soft fingertips with 12 to 96 springs are sheared and twisted until they are lost: from event to event, and in steps.
/// Beyond the limit load an object that has turned far may wedge and be held again, so that a proof of non-existence is rare.
fn soft_tips(count: usize) -> Result<(), Failure> {
    let (mut events, mut steps, mut loads) = (Tally::default(), Tally::default(), Tally::default());
    let (mut random, mut apart) = (Random(1), 0.0_f64);
    for _ in 0..count {
        let (grasp, load) = draw(&mut random)?;
        let leg = [Leg::load_to(load * 100.0)];
        let start = Instant::now();
        let mut path = grasp.follow(Wrench::ZERO, &leg)?;
        path.run();
        events.add(end(path.end()), start);
        let start = Instant::now();
        let mut stepped = grasp.follow_in_steps(Wrench::ZERO, &leg, 1e-6)?;
        stepped.by_ref().for_each(drop);
        steps.add(end(stepped.end()), start);
        let [limit, near] = [path.end(), stepped.end()].map(|end| end.and_then(PathEnd::loss));
        let Some(limit) = limit else { continue };
        apart = near.map_or(apart, |near| apart.max((near.fraction / limit.fraction - 1.0).abs()));
        let start = Instant::now();
        let overload = grasp.solve(load * (150.0 * limit.fraction))?;
        loads.add(answer(&overload), start);
    }
    events.print("soft tips, every event");
    steps.print("soft tips, in steps, 1e-6");
    loads.print("soft tips, 1.5 times the limit");
    println!("  Limits in steps are off by {apart:.0e}.");
    Ok(())
}

fn answer(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Equilibrium(_) => "held",
        Outcome::NoEquilibrium(_) => "none",
        _ => "undecided",
    }
}

/// The end of a path, in words.
fn end<const C: usize>(end: Option<&EndOf<C>>) -> &'static str {
    match end {
        Some(EndOf::Completed) => "completed",
        Some(EndOf::Lost(loss)) => how(loss.kind),
        Some(EndOf::NoStart(why)) if !matches!(**why, OutcomeOf::Undecided(_)) => "without a start",
        _ => "undecided",
    }
}

/// The kind of a loss, in words.
fn how(kind: LossKind) -> &'static str {
    match kind {
        LossKind::Fold => "folds",
        LossKind::Corner => "corners",
        LossKind::Asymptote => "asymptotes",
        LossKind::GivesWay => "give way",
        _ => "let go",
    }
}
