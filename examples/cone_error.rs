//! What facets cost in space, against what they save: error and run time of polygonal cones with 4 … 128 facets, beside the
//! default, which proposes on 8 facets and finishes on the round cone.
//!
//! Three grasps, two questions each: at which load does the first contact slide, and what do the contacts carry far beyond.
//! The answers that errors are measured against are checked here from the question alone: the onset by solving the
//! quadratic equations again, the sliding state by its balance and its contact law.
//!
//! `cargo run --release --example cone_error`

mod support;

use std::hint::black_box;
use std::time::{Duration, Instant};

use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{Contact, ContactState, Equilibrium, Grasp, Ramp, Wrench};
use grasp_lcp::{Fit, PolygonCone, Settings};
use nalgebra::{Vector2, Vector3, Vector6};

type Failure = Box<dyn std::error::Error>;

const FACETS: [u32; 6] = [4, 8, 16, 32, 64, 128];
/// Each call is repeated for so long, and its shortest time taken.
const PATIENCE: Duration = Duration::from_millis(60);
/// The finest polygon is affordable on so many contacts.
const MANY: usize = 4;
/// Answers closer than this are one.
const SAME: f64 = 1e-9;
/// Nothing less is told from rounding.
const ROUNDING: f64 = 1.1e-16;

/// A grasp, a load and finger commands that grow along a ramp, and the multiple of the onset at which contacts slide far.
struct Scene {
    name: &'static str,
    contacts: Vec<Contact>,
    base: Wrench,
    direction: Wrench,
    commands: Vec<Vector3<f64>>,
    deep: f64,
}

impl Scene {
    fn ramp(&self) -> Ramp {
        Ramp::load(self.base, self.direction).with_commands(self.commands.clone())
    }

    fn commands_at(&self, factor: f64) -> Vec<Vector3<f64>> {
        self.contacts.iter().zip(&self.commands).map(|(c, change)| c.commanded() + change * factor).collect()
    }

    fn at(&self, factor: f64) -> Result<(Grasp, Wrench), Failure> {
        let grasp = Grasp::new(self.contacts.clone())?.with_commands(&self.commands_at(factor))?;
        Ok((grasp, self.base + self.direction * factor))
    }

    /// Contact forces at a factor if nothing could slide or open: the elastic trial state.
    fn trial(&self, factor: f64) -> Result<Equilibrium, Failure> {
        let stuck = Grasp::new(self.contacts.iter().map(|c| c.clone().bonded()))?;
        let stuck = stuck.with_commands(&self.commands_at(factor))?;
        let held = stuck.solve(&(self.base + self.direction * factor))?;
        Ok(held.equilibrium().ok_or("bonded contacts hold")?.clone())
    }

    /// The first tangent is also the axis of a stiffness, and of commands along it: only where neither notices can it be turned.
    fn may_turn(&self) -> bool {
        self.contacts.iter().enumerate().all(|(i, c)| {
            let k = c.series_stiffness_of_axes();
            let sideways =
                c.commanded().yz() != Vector2::zeros() || self.commands[i].yz() != Vector2::zeros();
            self.is_hand(i) || (k[1] == k[2] && !sideways)
        })
    }

    /// Bonded: it has no cone.
    fn is_hand(&self, i: usize) -> bool {
        self.contacts[i].label_text(i) == "hand"
    }

    /// The same with each polygon's first corner along the elastic trial traction at a factor.
    fn turned(&self, factor: f64) -> Result<Self, Failure> {
        let trial = self.trial(factor)?;
        let frames = Grasp::new(self.contacts.clone())?;
        let mut contacts = self.contacts.clone();
        for (i, (contact, frame)) in contacts.iter_mut().zip(frames.frames()).enumerate() {
            let [_, x, y] = trial.contacts[i].force.into();
            if !self.is_hand(i) && x.hypot(y) > 0.0 {
                *contact = contact.clone().tangent(frame * Vector3::new(0.0, x, y));
            }
        }
        let Self { name, base, direction, deep, .. } = *self;
        Ok(Self { name, contacts, base, direction, commands: self.commands.clone(), deep })
    }
}

/// Three fingertips around an object of 60 mm, pulled down and to the side off its middle.
fn three_fingers() -> Scene {
    let finger = |degrees: f64, height: f64, mu: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, height], [-cos, -sin, 0.0])
            .tangent([0.0, 0.0, 1.0])
            .body_stiffness(2e5, 1e5)
            .finger_stiffness(1500.0, 900.0)
            .friction(mu)
            .command([0.003, 0.0, 0.0])
    };
    Scene {
        name: "three fingers",
        contacts: vec![finger(5.0, 0.002, 0.6), finger(125.0, -0.004, 0.5), finger(238.0, 0.005, 0.7)],
        base: Wrench::ZERO,
        direction: Wrench::force_at([0.5, 0.2, -1.0], [0.004, -0.006, 0.01]),
        commands: vec![Vector3::zeros(); 3],
        deep: 2.5,
    }
}

/// Four fingertips with ridged skin: three times softer across the ridges than along.
fn four_fingers() -> Scene {
    let finger = |degrees: f64, height: f64, squeeze: f64, mu: f64, ridges: [f64; 3]| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.035 * cos, 0.035 * sin, height], [-cos, -sin, 0.0])
            .tangent(ridges)
            .body_stiffness(2e5, 1e5)
            .finger_stiffness_axes([1500.0, 1200.0, 400.0])
            .friction(mu)
            .command([squeeze, 0.0, 0.0])
    };
    Scene {
        name: "four fingers, ridged",
        contacts: vec![
            finger(180.0, 0.002, 0.0051, 0.9, [0.3, 0.2, 1.0]),
            finger(50.0, 0.008, 0.003, 0.5, [-0.2, 0.4, 1.0]),
            finger(-3.0, 0.004, 0.001, 0.3, [0.1, -1.0, 0.6]),
            finger(-48.0, -0.006, 0.003, 0.8, [0.5, 0.6, 1.0]),
        ],
        base: Wrench::ZERO,
        direction: Wrench::force_at([0.25, 0.1, -1.0], [0.01, -0.012, 0.02]),
        commands: vec![Vector3::zeros(); 4],
        deep: 2.3,
    }
}

/// A block of 20 N on twelve feet, drawn by a hand at one of its corners: it turns as it goes.
fn dragged_block() -> Scene {
    let mut contacts = Vec::new();
    for row in 0..3 {
        for column in 0..4 {
            let point = [0.04 * f64::from(column) - 0.06, 0.03 * f64::from(row) - 0.03, 0.0];
            contacts.push(
                Contact::new(point, [0.0, 0.0, 1.0])
                    .tangent([1.0, 0.0, 0.0])
                    .series_stiffness(2e4, 1.2e4)
                    .friction(0.4),
            );
        }
    }
    let hand = Contact::new([0.07, 0.05, 0.01], [0.0, 0.0, 1.0]).tangent([1.0, 0.0, 0.0]);
    contacts.push(hand.name("hand").series_stiffness(50.0, 400.0).bonded());
    let mut commands = vec![Vector3::zeros(); 12];
    commands.push(Vector3::new(0.0, 0.001, 0.0025));
    Scene {
        name: "block on twelve feet, dragged askew",
        contacts,
        base: Wrench::force_at([0.0, 0.0, -20.0], [0.008, -0.005, 0.02]),
        direction: Wrench::ZERO,
        commands,
        deep: 3.0,
    }
}

/// A value and the time it took, s.
fn once<T>(mut call: impl FnMut() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let start = Instant::now();
    let value = black_box(call()?);
    Ok((value, start.elapsed().as_secs_f64()))
}

/// A value and the shortest of several times, s.
fn timed<T>(mut call: impl FnMut() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let start = Instant::now();
    let (mut value, mut best) = once(&mut call)?;
    while start.elapsed() < PATIENCE {
        let (next, time) = once(&mut call)?;
        (value, best) = (next, best.min(time));
    }
    Ok((value, best))
}

/// The onset from two elastic states and a quadratic equation for each contact.
fn onset_by_hand(scene: &Scene) -> Result<f64, Failure> {
    let (from, to) = (scene.trial(0.0)?, scene.trial(1.0)?);
    let mut first = f64::INFINITY;
    for (i, contact) in scene.contacts.iter().enumerate().filter(|(i, _)| !scene.is_hand(*i)) {
        let (f, change) = (from.contacts[i].force, to.contacts[i].force - from.contacts[i].force);
        let mu = contact.friction_coefficient();
        // |f_t + τ f'_t|² = μ² (f_n + τ f'_n)²
        let a = change.yz().norm_squared() - (mu * change[0]).powi(2);
        let b = f.yz().dot(&change.yz()) - mu * mu * f[0] * change[0];
        let c = f.yz().norm_squared() - (mu * f[0]).powi(2);
        let root = (b * b - a * c).max(0.0).sqrt();
        // Both roots, without cancellation; c < 0 inside the cone.
        let q = -b - root.copysign(b);
        for factor in [q / a, c / q] {
            if factor > 0.0 {
                first = first.min(factor);
            }
        }
    }
    Ok(first)
}

/// The largest violation of balance and of the round contact law, relative to the largest force.
fn residual(grasp: &Grasp, load: &Wrench, answer: &Equilibrium) -> f64 {
    let size = largest_force(answer);
    let (mut worst, mut missing) = (0.0_f64, *load.as_vector());
    let mut arm = 0.0_f64;
    for ((contact, frame), c) in grasp.contacts().iter().zip(grasp.frames()).zip(&answer.contacts) {
        let (p, k, mu) =
            (contact.point(), contact.series_stiffness_of_axes(), contact.friction_coefficient());
        let u = frame.tr_mul(&Vector3::from(answer.twist.displacement_at(p.into())));
        let held = k.component_mul(&(contact.commanded() - u));
        // What the springs would carry more if nothing had slipped: k s.
        let slipped = (held - c.force).yz();
        let friction = c.force.yz();
        let violation = match c.state {
            ContactState::Sliding { .. } => {
                let along = friction.normalize();
                let slip = slipped.component_div(&k.yz());
                let across = k[1].min(k[2]) * slip.perp(&along).abs();
                let backwards = (-slip.dot(&along)).max(0.0) * k[1].min(k[2]);
                (friction.norm() - mu * c.force[0])
                    .abs()
                    .max(across)
                    .max(backwards)
                    .max((held - c.force)[0].abs())
            }
            ContactState::Rolling => (held - c.force).norm(),
            _ => held[0].max(0.0) + c.force.norm(),
        };
        worst = worst.max(violation);
        let force = frame * c.force;
        let moment = p.cross(&force);
        missing += Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        arm = arm.max(p.norm());
    }
    let forces = missing.fixed_rows::<3>(0).norm();
    let moments = missing.fixed_rows::<3>(3).norm() / arm;
    worst.max(forces).max(moments) / size
}

fn largest_force(answer: &Equilibrium) -> f64 {
    answer.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max)
}

/// The largest difference of a contact force relative to the largest force.
fn difference(answer: &Equilibrium, exact: &Equilibrium) -> f64 {
    let pairs = answer.contacts.iter().zip(&exact.contacts);
    pairs.map(|(a, b)| (a.force_world - b.force_world).norm()).fold(0.0, f64::max) / largest_force(exact)
}

/// How a method is called; the polygons first.
const METHODS: [&str; 4] = ["inscribed", "circumscribed", "balanced", "turned"];

fn polygon(facets: u32, method: usize) -> Result<Settings, Failure> {
    let fit = [Fit::Inscribed, Fit::Circumscribed, Fit::Balanced, Fit::Inscribed][method];
    // Nothing beyond the question is searched for.
    let settings = Settings::default().with_most_states(0).on_the_polygon();
    Ok(settings.with_cone(PolygonCone::new(usize::try_from(facets)?, fit)?))
}

/// Error and time, s, of each method at each number of facets, and of the default. An undecided answer has no error.
struct Measured {
    polygons: Vec<Vec<(u32, f64, f64)>>,
    default: (f64, f64),
    /// The part of the default that pivots, 8 turned facets, and the whole, s.
    proposal: Option<(f64, f64)>,
}

/// The onset on a turned polygon: the traction is known where the first polygon starts to slide.
fn turned_onset(scene: &Scene, settings: &Settings) -> Result<f64, Failure> {
    let first = Grasp::new(scene.contacts.clone())?.onset_on_polygon(&scene.ramp(), settings)?;
    let there = scene.turned(first.factor().ok_or("a rolling base")?)?;
    let second = Grasp::new(there.contacts.clone())?.onset_on_polygon(&there.ramp(), settings)?;
    Ok(second.factor().ok_or("a rolling base")?)
}

fn measure_onset(scene: &Scene) -> Result<Measured, Failure> {
    let exact = onset_by_hand(scene)?;
    let (grasp, ramp) = (Grasp::new(scene.contacts.clone())?, scene.ramp());
    let settings = Settings::default().with_most_states(0);
    let (factor, time) = timed(|| Ok(grasp.onset(&ramp, &settings)?.factor().ok_or("a rolling base")?))?;
    let mut polygons = Vec::new();
    for method in 0..METHODS.len() {
        let mut row = Vec::new();
        for facets in FACETS {
            if method == 3 && !scene.may_turn() {
                continue;
            }
            let on = polygon(facets, method)?;
            let (factor, time) = timed(|| {
                if method == 3 {
                    turned_onset(scene, &on)
                } else {
                    Ok(grasp.onset_on_polygon(&ramp, &on)?.factor().ok_or("a rolling base")?)
                }
            })?;
            row.push((facets, (factor / exact - 1.0).abs(), time));
        }
        polygons.push(row);
    }
    println!("  onset at factor {factor:.12}, by hand {exact:.12}");
    Ok(Measured { polygons, default: ((factor / exact - 1.0).abs(), time), proposal: None })
}

fn measure_sliding(scene: &Scene) -> Result<Measured, Failure> {
    let factor = scene.deep * onset_by_hand(scene)?;
    let (grasp, load) = scene.at(factor)?;
    let held = |grasp: &Grasp, settings: &Settings| Ok(grasp.solve_with(&load, settings)?);
    let (outcome, time) = timed(|| held(&grasp, &Settings::default()))?;
    let exact = outcome.equilibrium().ok_or_else(|| format!("no equilibrium: {outcome:?}"))?;
    let residual = residual(&grasp, &load, exact);
    let sliding = exact.contacts.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count();
    println!(
        "  sliding state at factor {factor:.6}: {sliding} of {} contacts slide, {} pivots, residual recomputed {residual:.0e}",
        grasp.len(),
        exact.work.pivots
    );
    if grasp.len() <= MANY {
        let (answer, time) = once(|| held(&grasp, &polygon(1024, 0)?))?;
        if let Some(answer) = answer.equilibrium() {
            println!("  1024 facets come to {:.1e} of it in {:.1} s", difference(answer, exact), time);
        }
    }
    // With friction several equilibria are common, on the round cone as well; which one is found depends on where the polish starts.
    for facets in FACETS {
        let proposed = Settings::default().with_cone(polygon(facets, 0)?.cone);
        let far = held(&grasp, &proposed)?.equilibrium().map(|other| difference(other, exact));
        if let Some(far) = far.filter(|far| *far > SAME) {
            println!("  from {facets} facets the polish ends at another equilibrium, {far:.1e} away");
        }
    }
    let (mut polygons, mut proposal) = (Vec::new(), None);
    for method in 0..METHODS.len() {
        let mut row = Vec::new();
        for facets in FACETS {
            if method == 3 && !scene.may_turn() {
                continue;
            }
            let on = polygon(facets, method)?;
            let (answer, time) = if method == 3 {
                timed(|| {
                    let turned = scene.turned(factor)?;
                    held(&turned.at(factor)?.0, &on)
                })?
            } else {
                timed(|| held(&grasp, &on))?
            };
            if method == 3 && facets == 8 {
                let ready = scene.turned(factor)?.at(factor)?.0;
                // In turns, so that whatever else the machine does slows both.
                let (start, mut best) = (Instant::now(), (f64::INFINITY, f64::INFINITY));
                while start.elapsed() < 4 * PATIENCE {
                    best.0 = best.0.min(once(|| held(&ready, &on))?.1);
                    best.1 = best.1.min(once(|| held(&grasp, &Settings::default()))?.1);
                }
                proposal = Some(best);
            }
            let error = answer.equilibrium().map_or(f64::NAN, |answer| difference(answer, exact));
            row.push((facets, error, time));
        }
        polygons.push(row);
    }
    Ok(Measured { polygons, default: (residual, time), proposal })
}

/// The least-squares slope of -log error against log m: errors fall like 1/m^p.
fn order(row: &[(u32, f64, f64)]) -> f64 {
    let points: Vec<_> =
        row.iter().filter(|r| r.1 > 100.0 * ROUNDING).map(|r| (f64::from(r.0).ln(), r.1.ln())).collect();
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let (over, under) = points
        .iter()
        .fold((0.0, 0.0), |s, p| (s.0 + (p.0 - mean.0) * (p.1 - mean.1), s.1 + (p.0 - mean.0).powi(2)));
    -over / under
}

fn report(question: &str, measured: &Measured) {
    println!("  {question}: error, time in µs");
    print!("    facets");
    for method in METHODS {
        print!("{method:>24}");
    }
    println!();
    for (j, facets) in FACETS.iter().enumerate() {
        print!("    {facets:6}");
        for row in &measured.polygons {
            match row.get(j) {
                Some((_, error, time)) if error.is_nan() => {
                    print!("{:>12} {:>11.1}", "undecided", 1e6 * time);
                }
                Some((_, error, time)) => print!("{:>12.2e} {:>11.1}", error, 1e6 * time),
                None => print!("{:>24}", "-"),
            }
        }
        println!();
    }
    print!("    falls like");
    for row in measured.polygons.iter().filter(|row| !row.is_empty()) {
        print!("{:>20}    ", format!("1/m^{:.2}", order(row)));
    }
    let (error, time) = measured.default;
    println!("\n    default, on the round cone: {error:.1e}, {:.1} µs", 1e6 * time);
    let all = || measured.polygons.iter().flatten();
    let as_fast = all().filter(|r| r.2 <= time).map(|r| r.1).fold(f64::INFINITY, f64::min);
    if as_fast.is_finite() {
        println!("    the best polygon in that time: {as_fast:.1e}");
    } else {
        println!("    no polygon is as fast");
    }
    let best = all().fold((f64::INFINITY, 0.0), |b, r| if r.1 < b.0 { (r.1, r.2) } else { b });
    println!("    the best polygon of all: {:.1e} in {:.1} times that time", best.0, best.1 / time);
    if let Some((proposal, whole)) = measured.proposal {
        println!(
            "    turned polygon alone {:.1} µs: turning it and the polish take {:.1} µs",
            1e6 * proposal,
            1e6 * (whole - proposal)
        );
    }
}

fn chart(title: &str, error: &str, measured: &Measured) -> Chart {
    let (least, time) = measured.default;
    let default = vec![(time, least.max(ROUNDING))];
    let mut chart = Chart::new(title, "time of one call (s)", error).log_log();
    chart = chart.series("round cone (default)", default, Stroke::Circles);
    for (method, row) in METHODS.iter().zip(&measured.polygons).filter(|(_, row)| !row.is_empty()) {
        let points = row.iter().map(|&(_, error, time)| (time, error.max(ROUNDING))).collect();
        chart = chart.series(format!("{method}, m = 4 … 128"), points, Stroke::Line);
    }
    chart
}

fn main() -> Result<(), Failure> {
    let mut charts = Vec::new();
    for scene in [three_fingers(), four_fingers(), dragged_block()] {
        println!("{}", scene.name);
        let onset = measure_onset(&scene)?;
        report("onset", &onset);
        let sliding = measure_sliding(&scene)?;
        report("sliding state", &sliding);
        println!();
        charts.push(chart(&format!("Onset: {}", scene.name), "relative error of the onset", &onset));
        let title = format!("Far beyond it: {}", scene.name);
        charts.push(chart(&title, "error of a contact force / largest force", &sliding));
    }
    support::save("cone_error.svg", &Chart::sheet(&charts, 2)?)?;
    Ok(())
}
