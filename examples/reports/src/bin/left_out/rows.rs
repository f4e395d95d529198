//! For each scene: rows of the full formulation, rows that the crate assembles, and why it omits the others.

use std::fmt::Write;

use grasp_lcp::Settings;
use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use grasp_lcp::forms::OmissionReason;

use crate::full::Full;
use crate::scene::{self, Failure, Scene};
use support::best_time::timed;

/// Difference of forces, relative to the largest force, above which two answers differ.
const AGREE: f64 = 1e-10;

/// One scene, solved by the crate and by the full formulation.
pub struct Measured {
    pub full_rows: usize,
    pub full_time: f64,
    pub time: f64,
    full_pivots: Option<usize>,
    answer: Answer,
    /// Largest difference of a contact force over the largest force; `None` if the full formulation has no answer.
    apart: Option<f64>,
}

/// Statistics of the crate's answer.
struct Answer {
    sliding: usize,
    rows: usize,
    pivots: usize,
    rule: String,
    left_out: usize,
    why: String,
}

impl Answer {
    fn new<const C: usize>(answer: &Equilibrium<C>) -> Self {
        let left_out = &answer.work.rows_left_out;
        let mut reasons: Vec<(OmissionReason, usize)> = Vec::new();
        for part in left_out {
            match reasons.iter_mut().find(|(why, _)| *why == part.why) {
                Some((_, rows)) => *rows += part.rows,
                None => reasons.push((part.why, part.rows)),
            }
        }
        let words = reasons.iter().map(|(why, rows)| format!("{rows} {}", reason(*why)));
        let slides = |c: &&ContactAnswer<C>| matches!(c.state, ContactState::Sliding { .. });
        Self {
            sliding: answer.contacts.iter().filter(slides).count(),
            rows: answer.work.rows_made,
            pivots: answer.work.pivots,
            rule: format!("{:?}", answer.rule),
            left_out: left_out.iter().map(|part| part.rows).sum(),
            why: match (reasons.len(), answer.work.rows_made) {
                (0, 0) => "all, no such problem was made".into(),
                (0, _) => "none".into(),
                _ => words.collect::<Vec<_>>().join(", "),
            },
        }
    }
}

fn reason(why: OmissionReason) -> &'static str {
    match why {
        OmissionReason::EverythingSticks => "everything sticks",
        OmissionReason::Frictionless => "smooth",
        OmissionReason::InfiniteFriction => "never slide",
        OmissionReason::KeptClosed => "kept closed",
        OmissionReason::Bonded => "bonded",
        _ => "other",
    }
}

/// Solves a scene by the crate and by the full formulation, in space on the same polygon.
pub fn measure<const C: usize>(scene: &Scene<C>) -> Result<Measured, Failure> {
    let settings = Settings::default().on_the_polygon();
    let (outcome, time) = timed(|| Ok(scene.grasp.with(&settings).solve(scene.load)?))?;
    let answer = outcome.equilibrium().ok_or_else(|| format!("{}: {outcome:?}", scene.name))?;
    let ((full_rows, full), full_time) = timed(|| {
        let full = Full::new(scene)?;
        Ok((full.lcp.len(), full.solve::<C>()))
    })?;
    let size = answer.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
    let apart = full.as_ref().map(|(forces, _)| {
        let differences = forces.iter().zip(&answer.contacts).map(|(f, c)| (f - c.force).norm());
        differences.fold(0.0, f64::max) / size
    });
    let full_pivots = full.map(|(_, pivots)| pivots);
    Ok(Measured { full_rows, full_time, time, full_pivots, answer: Answer::new(answer), apart })
}

pub fn report() -> Result<(), Failure> {
    println!("Rows of the contact law (a gap and its facets for every contact), and what they cost\n");
    println!("  {:42} {:>15} {:>13} {:>13} {:>19}", "", "contacts", "rows", "pivots", "time (µs)");
    println!(
        "  {:42} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>11} {:>7} {:>6} {:>7}  rows left out; found by",
        "scene", "all", "sliding", "full", "made", "full", "crate", "full", "crate", "ratio", "forces"
    );
    let mut table = String::from(
        "scene,contacts,sliding,rows_full,rows_made,rows_left_out,why,pivots_full,pivots,time_full_s,time_s,forces_apart,rule\n",
    );
    row(&mut table, &scene::sticks()?)?;
    row(&mut table, &scene::slides()?)?;
    row(&mut table, &scene::smooth()?)?;
    row(&mut table, &scene::mixed()?)?;
    row(&mut table, &scene::in_the_plane()?)?;
    row(&mut table, &scene::in_a_spatial_guise()?)?;
    row(&mut table, &scene::far("far contacts, the near ones stick", 0.1)?)?;
    row(&mut table, &scene::far("far contacts, one of the near ones slides", 1.0)?)?;
    row(&mut table, &scene::pad("pad of 200 springs, everything sticks", 200, 0.01)?)?;
    row(&mut table, &scene::pad("pad of 200 springs, two thirds slide", 200, 1.0)?)?;
    println!(
        "\n  Forces: largest difference from the full formulation over the largest force. In space both are on 8 facets. For the full\n  \
         formulation friction without limit and bonds are a friction of 1000: these contacts press, so that it does not show."
    );
    println!();
    support::save("left_out.csv", &table)?;
    Ok(())
}

fn row<const C: usize>(table: &mut String, scene: &Scene<C>) -> Result<(), Failure> {
    let measured = measure(scene)?;
    let Measured { full_rows, full_time, time, full_pivots, answer, apart } = &measured;
    let or_ray = |text: Option<String>| text.unwrap_or_else(|| "ray".into());
    let pivots = or_ray(full_pivots.map(|pivots| pivots.to_string()));
    let differ = or_ray(apart.map(|apart| format!("{apart:.0e}")));
    println!(
        "  {:42} {:>7} {:>7} {full_rows:>6} {:>6} {pivots:>6} {:>6} {:>11.1} {:>7.1} {:>6.1} {differ:>7}  {}; {}",
        scene.name,
        scene.grasp.len(),
        answer.sliding,
        answer.rows,
        answer.pivots,
        1e6 * full_time,
        1e6 * time,
        full_time / time,
        answer.why,
        answer.rule,
    );
    writeln!(
        table,
        "\"{}\",{},{},{full_rows},{},{},\"{}\",{pivots},{},{full_time:e},{time:e},{differ},{}",
        scene.name,
        scene.grasp.len(),
        answer.sliding,
        answer.rows,
        answer.left_out,
        answer.why,
        answer.pivots,
        answer.rule
    )?;
    if apart.is_some_and(|apart| apart > AGREE) {
        println!("    the two answers differ: with friction several equilibria are common");
    }
    Ok(())
}
