//! A bar between three pairs of fingers is pulled, released and pulled again until it is lost. The report prints every event with
//! its exact load and the energy balance, and draws the hysteresis loop.
//!
//! `cargo run --release -p reports --bin load_cycle`

use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::planar::{Beyond, Change, Contact, Equilibrium, Grasp, Leg, LoadPath, PathEnd, Wrench};

/// Pairs of fingers above and below the bar, with less squeeze towards the end that is pulled.
fn bar() -> Result<Grasp, grasp_lcp::Error> {
    let pairs = [("rear", -0.04, 0.004), ("middle", 0.0, 0.003), ("front", 0.04, 0.0015)];
    Grasp::new(pairs.into_iter().flat_map(|(name, x, squeeze)| {
        [("upper", 1.0), ("lower", -1.0)].map(move |(side, y)| {
            Contact::new([x, 0.01 * y], [0.0, -y])
                .name(format!("{name} {side}"))
                .body_stiffness(2e4, 1e4)
                .finger_stiffness(2000.0, 1500.0)
                .friction(0.45)
                .command([squeeze, 0.0])
        })
    }))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let grasp = bar()?;
    let pull = |newton: f64| Leg::load_to(Wrench::force([newton, 0.0]));
    let legs = [pull(13.0), pull(0.0), pull(-9.0), pull(0.0), pull(20.0)];
    let mut path = grasp.follow(Wrench::ZERO, &legs)?;

    println!("Pull along x to 13 N, release, push to -9 N, release, pull to 20 N\n");
    println!("  no.  leg  fraction of the leg     load (N)   what happens");
    let mut happens = Vec::new();
    for event in path.by_ref() {
        let told =
            event.changes.iter().map(|change| format!("{} {}", change.contact.text(), word(&change.what)));
        let what: Vec<String> = told.collect();
        println!(
            "  {:3}  {:3}  {:.15}  {:11.6}   {}",
            happens.len() + 1,
            event.leg,
            event.fraction,
            event.load.to_vector()[0],
            what.join(", ")
        );
        let pairs = event.changes.iter().map(|change| change.contact.index / 2).collect();
        happens.push(Happens { leg: event.leg, fraction: event.fraction, pairs });
    }
    match path.end() {
        Some(PathEnd::Lost(loss)) if matches!(path.beyond(), Some(Beyond::LimitLoad)) => {
            let exact = loss.load.to_vector()[0];
            println!(
                "  {:3}  {:3}  {:.15}  {exact:11.6}   limit load: the bar is pulled out",
                happens.len() + 1,
                loss.leg,
                loss.fraction
            );
            happens.push(Happens { leg: loss.leg, fraction: loss.fraction, pairs: vec![0, 1, 2] });
        }
        other => println!("  the path ends: {other:?}"),
    }
    let normal: f64 = path.state().map_or(0.0, |e| e.contacts.iter().map(|c| 0.45 * c.normal_force()).sum());
    println!("  sum of μ F_n over all fingers: {normal:.6} N\n");

    println!("  leg   work of the load   stored      to friction   balance (relative)");
    for (leg, e) in path.energies().iter().enumerate() {
        println!(
            "  {leg:3}   {:+.6e} J   {:+.3e}   {:.6e}   {:+.0e}",
            e.load_work,
            e.stored,
            e.dissipated,
            e.residual()
        );
    }
    if let Some(rest) = path.state_at(1, 1.0) {
        println!(
            "\n  after the first release the bar rests {:.4} mm off, and the fingers keep:",
            1e3 * rest.twist.translation()[0]
        );
        for (i, c) in rest.contacts.iter().enumerate().step_by(2) {
            println!("    {:13} F_t = {:+.4} N", grasp.contacts()[i].label_text(i), c.force_world[0]);
        }
    }

    println!();
    Pictures { path: &path, legs: legs.len(), happens: &happens }.save()
}

/// An event, and the pairs of fingers that it changes.
struct Happens {
    leg: usize,
    fraction: f64,
    pairs: Vec<usize>,
}

/// Charts of the finger forces and of the hysteresis loop, with numbered events.
struct Pictures<'a> {
    path: &'a LoadPath<'a>,
    legs: usize,
    happens: &'a [Happens],
}

/// Coordinates on a chart of an equilibrium.
type Point<'a> = &'a dyn Fn(&Equilibrium) -> (f64, f64);

impl Pictures<'_> {
    fn save(&self) -> Result<(), Box<dyn std::error::Error>> {
        let load = |state: &Equilibrium| state.load.to_vector()[0];
        let mut chart = Chart::new(
            "A grasp with slip memory: finger forces run through loops (numbers: events)",
            "load (N)",
            "tangential force of one finger (N)",
        );
        for (pair, name) in ["rear", "middle", "front"].into_iter().enumerate() {
            let force = |state: &Equilibrium| (load(state), state.contacts[2 * pair].force_world[0]);
            let mut whole: Vec<_> = (0..self.legs).flat_map(|leg| self.leg(leg, &force)).collect();
            whole.dedup();
            chart = self.numbered(chart.series(name, whole, Stroke::Directed), Some(pair), &force);
        }
        support::save("load_cycle_forces.svg", &chart.to_svg()?)?;

        let moves = |state: &Equilibrium| (1e3 * state.twist.translation()[0], load(state));
        let mut chart = Chart::new(
            "The hysteresis loop of the grasp (numbers: events)",
            "displacement of the bar (mm)",
            "load (N)",
        );
        let names = ["pull to 13 N", "release", "push to -9 N", "release", "pull until it is lost"];
        for (leg, name) in names.into_iter().enumerate() {
            chart = chart.series(format!("leg {}: {name}", leg + 1), self.leg(leg, &moves), Stroke::Directed);
        }
        support::save("load_cycle_loop.svg", &self.numbered(chart, None, &moves).to_svg()?)?;
        Ok(())
    }

    /// The curve of a leg. Everything is linear between events, so that the points at events and leg ends determine it.
    fn leg(&self, leg: usize, point: Point) -> Vec<(f64, f64)> {
        let events = self.happens.iter().filter(|event| event.leg == leg).map(|event| event.fraction);
        let knots = [0.0].into_iter().chain(events).chain([1.0]);
        knots.filter_map(|fraction| self.path.state_at(leg, fraction)).map(|state| point(&state)).collect()
    }

    /// Labels all events, or the events of one pair of fingers, with their numbers; events at one point share a label.
    fn numbered(&self, chart: Chart, pair: Option<usize>, point: Point) -> Chart {
        let mut labels: Vec<((f64, f64), String)> = Vec::new();
        for (number, event) in self.happens.iter().enumerate() {
            if pair.is_some_and(|pair| !event.pairs.contains(&pair)) {
                continue;
            }
            let Some(state) = self.path.state_at(event.leg, event.fraction) else { continue };
            let (at, words) = (point(&state), (number + 1).to_string());
            let near = |there: &(f64, f64)| (there.0 - at.0).abs() + (there.1 - at.1).abs() < 1e-6;
            match labels.iter_mut().find(|(there, _)| near(there)) {
                Some((_, before)) => *before = format!("{before},{words}"),
                None => labels.push((at, words)),
            }
        }
        labels.into_iter().fold(chart, |chart, (at, words)| chart.label(at, words))
    }
}

fn word(change: &Change) -> &'static str {
    match change {
        Change::Slides { .. } => "slides",
        Change::Sticks => "sticks",
        Change::Reverses { .. } => "slides back",
        Change::Turns { .. } => "turns",
        Change::Opens => "opens",
        Change::Closes => "closes",
        Change::ClosesSliding { .. } => "closes sliding",
    }
}
