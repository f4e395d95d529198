//! A bar between three pairs of fingers is pulled, released and pulled again until it is lost: every event with its exact
//! load, the hysteresis loop, the energy balance.
//!
//! `cargo run --release --example load_cycle`

use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::planar::{Beyond, Change, Contact, Grasp, Leg, PathEnd, Wrench};

/// Pairs of fingers above and below the bar, squeezed less and less towards the end that is pulled.
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
    let mut path = grasp.follow(&Wrench::ZERO, &legs)?;

    println!("Pull along x to 13 N, release, push to -9 N, release, pull to 20 N\n");
    println!("  leg  fraction of the leg     load (N)   what happens");
    let mut knots = vec![(0, 0.0)];
    for event in path.by_ref() {
        let what: Vec<String> = event
            .changes
            .iter()
            .map(|(i, change)| format!("{} {}", grasp.contacts()[*i].label_text(*i), word(change)))
            .collect();
        println!(
            "  {:3}  {:.15}  {:11.6}   {}",
            event.leg,
            event.fraction,
            event.load.as_vector()[0],
            what.join(", ")
        );
        knots.push((event.leg, event.fraction));
    }
    match path.end() {
        Some(PathEnd::Lost(loss)) if matches!(path.beyond(), Some(Beyond::LimitLoad)) => {
            let exact = loss.load.as_vector()[0];
            println!(
                "  {:3}  {:.15}  {exact:11.6}   limit load: the bar is pulled out",
                loss.leg, loss.fraction
            );
            knots.push((loss.leg, loss.fraction));
        }
        other => println!("  the path ends: {other:?}"),
    }
    let normal: f64 =
        path.position().map_or(0.0, |(_, _, e)| e.contacts.iter().map(|c| 0.45 * c.normal_force()).sum());
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

    // Between events all is linear: the knots are the whole curve.
    for leg in 0..legs.len() {
        knots.extend([(leg, 0.0), (leg, 1.0)]);
    }
    knots.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let states: Vec<_> = knots.iter().filter_map(|&(leg, f)| path.state_at(leg, f)).collect();
    let mut chart = Chart::new(
        "A grasp with slip memory: finger forces run through loops",
        "load (N)",
        "tangential force of one finger (N)",
    );
    for (i, name) in [(0, "rear"), (2, "middle"), (4, "front")] {
        let curve = states.iter().map(|s| (s.load.as_vector()[0], s.contacts[i].force_world[0])).collect();
        chart = chart.series(name, curve, Stroke::Line);
    }
    println!();
    support::save("load_cycle_forces.svg", &chart.to_svg()?)?;
    let loop_: Vec<_> =
        states.iter().map(|s| (1e3 * s.twist.translation()[0], s.load.as_vector()[0])).collect();
    let chart = Chart::new("The hysteresis loop of the grasp", "displacement of the bar (mm)", "load (N)")
        .series("load, release, push, release, pull", loop_, Stroke::Line);
    support::save("load_cycle_loop.svg", &chart.to_svg()?)?;
    Ok(())
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
