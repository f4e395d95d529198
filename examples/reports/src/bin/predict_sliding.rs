//! At which load does the two-finger grasp of the paper (see `paper-notes.md`) start to slide? Recomputes the paper's table, finds the
//! onset directly, and draws two pictures.
//!
//! `cargo run --release -p reports --bin predict_sliding`

use grasp_lcp::picture::{Chart, Stroke, draw_grasp};
use grasp_lcp::planar::{Beyond, ContactState, Departure, Outcome, Wrench};
use support::paper::{TWO_FINGER_TABLE, down, two_fingers};

/// State of a contact, in one word.
fn word(state: &ContactState) -> &'static str {
    match state {
        ContactState::Separated => "open   ",
        ContactState::Sticking => "sticking",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "smooth ",
    }
}

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let grasp = two_fingers()?;

    println!("The paper's second grasp under a growing load W along -y (N); margin = μ F_n - |F_t|\n");
    println!(
        "            finger 1                               finger 2                              printed by the paper"
    );
    println!(
        "   W      F_n      F_t    F_t/F_n  margin  state    F_n      F_t    F_t/F_n  margin  state    F_1n    F_1t     F_2n    F_2t"
    );
    let mut pivots = 0;
    for row in TWO_FINGER_TABLE {
        print!("{:5.2}", row[0]);
        match grasp.solve(down() * row[0])? {
            Outcome::Equilibrium(state) => {
                pivots += state.work.pivots;
                for c in &state.contacts {
                    let (n, t) = (c.normal_force(), c.tangential_force());
                    print!("  {n:.5} {t:8.5} {:7.4} {:8.5} {}", c.ratio(), c.margin, word(&c.state));
                }
            }
            Outcome::NoEquilibrium(_) => print!("  {:^76}", "no equilibrium exists"),
            other => print!("  {other:?}"),
        }
        println!("  {:.4} {:7.4}  {:.4} {:7.4}", row[1], row[2], row[3], row[4]);
    }
    println!("pivots spent on all rows together: {pivots}");

    let onset = grasp.onset(down())?;
    let event = onset.event().ok_or("the paper's grasp has an onset")?;
    let exact = 65f64.sqrt() / 66.0;
    println!("\nOnset of sliding, found directly");
    println!("  W*    = {:.15}   exact √65/66  = {exact:.15}", event.factor);
    let state = grasp.state_at_onset(event).ok_or("its own event")?;
    for c in &state.contacts {
        let (n, t) = (c.normal_force(), c.friction_force());
        println!(
            "  F_n   = {n:.15}   65/132 {:+.0e}   |F_t| = {t:.15}   65/528 {:+.0e}",
            n - 65.0 / 132.0,
            t - 65.0 / 528.0
        );
    }
    for leaving in &event.leaving {
        let name = leaving.contact.text();
        match leaving.how {
            Departure::Slides { direction } => {
                println!(
                    "  {name} slides over the object along ({:+.4}, {:+.4})",
                    direction[0], direction[1]
                );
            }
            how => println!("  {name} {}", how.verb()),
        }
    }
    match grasp.beyond(event).ok_or("its own event")? {
        Beyond::LimitLoad => println!("  beyond: no equilibrium; W* is also the limit load"),
        other => println!("  beyond: {other:?}"),
    }
    for factor in [1.0 - 1e-9, 1.0 + 1e-9, 1.1, 10.0] {
        let word = match grasp.solve(down() * (exact * factor))? {
            Outcome::Equilibrium(_) => "holds",
            Outcome::NoEquilibrium(_) => "no equilibrium",
            _ => "undecided",
        };
        println!("  at W* · {factor:<12}: {word}");
    }

    println!();
    let outline = [[-4.0, 1.8], [-3.6, 5.0], [3.6, 5.0], [4.0, 1.8], [2.4, -2.5], [-2.4, -2.5]];
    let title = format!("The paper's two-finger grasp at its onset of sliding, W* = {:.6} N", event.factor);
    support::save("predict_sliding_grasp.svg", &draw_grasp(&grasp, &state, Some(&outline), &title)?)?;

    // Forces are linear in the load up to the onset, so that two equilibria determine the lines.
    let start = grasp.solve(Wrench::ZERO)?;
    let start = start.equilibrium().ok_or("holds without load")?;
    let (first, last) = (&start.contacts[0], &state.contacts[0]);
    let line = |y0: f64, y1: f64| vec![(0.0, y0), (event.factor, y1)];
    let paper: Vec<_> = TWO_FINGER_TABLE.iter().map(|row| (row[0], row[4])).collect();
    let chart = Chart::new(
        "Finger forces against load: friction is used up at W*",
        "load W along -y (N)",
        "force (N)",
    )
    .series("μ F_n", line(0.25 * first.normal_force(), 0.25 * last.normal_force()), Stroke::Line)
    .series("|F_t|", line(first.friction_force(), last.friction_force()), Stroke::Line)
    .series("|F_t| printed in the paper", paper, Stroke::Circles)
    .mark(event.factor, format!("onset W* = {:.6}", event.factor))
    .shade_from(event.factor, "no equilibrium");
    support::save("predict_sliding_forces.svg", &chart.to_svg()?)?;
    Ok(())
}
