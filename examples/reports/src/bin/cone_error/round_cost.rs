//! Run times on the round cone compared with polygons, for random grasps in which some contacts slide.
//!
//! For each scene four times are measured alternately. The first is Lemke's method on the kinematic form, with its assembly. The others are those
//! of whole answers: on the polygon, with corners along the tangential forces of the stuck grasp, by the method that the crate chooses; on the
//! round cone, by Newton's method; and with every contact bonded, which needs neither Lemke's nor Newton's method.

use std::hint::black_box;

use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::spatial::{ContactState, Grasp};
use grasp_lcp::{PolygonCone, Settings};

use support::Failure;
use support::best_time::best_in_turns;
use support::loaded::random_fingers;
use support::splitmix::Random;

const CONTACTS: [usize; 5] = [3, 5, 8, 13, 20];
/// Number of scenes for each number of contacts; the medians of their times are printed.
const SCENES: usize = 25;
/// Number of random grasps that are drawn at most for these scenes.
const MOST_DRAWN: usize = 20 * SCENES;

pub(crate) fn print() -> Result<(), Failure> {
    println!("the round cone beside its polygon, medians of {SCENES} random grasps, µs");
    println!(
        "  {:>8} {:>8} {:>9} {:>9} {:>9} {:>9} {:>11}",
        "contacts", "sliding", "pivoting", "polygon", "round", "bonded", "of polygon"
    );
    for count in CONTACTS {
        let mut random = Random(0x9E37_79B9_7F4A_7C15 ^ count as u64);
        let mut rows = Vec::new();
        for _ in 0..MOST_DRAWN {
            rows.extend(times(count, &mut random)?);
            if rows.len() == SCENES {
                break;
            }
        }
        if rows.len() < SCENES {
            return Err(format!("{MOST_DRAWN} grasps of {count} contacts give {} scenes", rows.len()).into());
        }
        let median = |f: &dyn Fn(&Times) -> f64| {
            let mut values: Vec<f64> = rows.iter().map(f).collect();
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        println!(
            "  {count:>8} {:>8.0} {:>9.1} {:>9.1} {:>9.1} {:>9.1} {:>11.2}",
            median(&|t| t.sliding),
            1e6 * median(&|t| t.pivoting),
            1e6 * median(&|t| t.polygon),
            1e6 * median(&|t| t.round),
            1e6 * median(&|t| t.bonded),
            median(&|t| t.round / t.polygon),
        );
    }
    println!();
    Ok(())
}

/// Run times of one scene by each method, s; `sliding` is the number of contacts that slide.
struct Times {
    sliding: f64,
    pivoting: f64,
    polygon: f64,
    round: f64,
    bonded: f64,
}

/// The times of a random scene. `None` if nothing slides, Lemke's method does not solve the kinematic form, or Newton's method does not converge.
fn times(count: usize, random: &mut Random) -> Result<Option<Times>, Failure> {
    let scene = random_fingers(count, random);
    let (grasp, _) = scene.at(0.0)?;
    let Ok(onset) = grasp.onset(scene.ramp()) else { return Ok(None) };
    let Some(onset) = onset.factor() else { return Ok(None) };
    let factor = scene.deep * onset;
    let (grasp, load) = scene.turned(factor)?.at(factor)?;
    let round = Settings::default();
    let polygon = Settings::default().on_the_polygon();
    let answers = [grasp.with(&polygon).solve(load)?, grasp.with(&round).solve(load)?];
    let [Some(_), Some(answer)] = answers.each_ref().map(|outcome| outcome.equilibrium()) else {
        return Ok(None);
    };
    let sliding = answer.contacts.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count();
    let Some(form) = grasp.kinematic_form(load, &PolygonCone::default())? else { return Ok(None) };
    let lemke = grasp_lcp::lcp::Settings::default();
    let pivots = form.lcp.solve_with(&lemke).solution().is_some();
    if sliding == 0 || !pivots || answer.rule != FoundBy::Newton {
        return Ok(None);
    }
    let stuck = Grasp::new(grasp.contacts().iter().map(|c| c.clone().bonded()))?;
    let [pivoting, polygon, round, bonded] = best_in_turns([
        &mut || {
            let form = grasp.kinematic_form(load, &PolygonCone::default())?.ok_or("rows to pivot on")?;
            black_box(form.lcp.solve_with(&lemke));
            Ok(())
        },
        &mut || grasp.with(&polygon).solve(load).map(drop).map_err(Failure::from),
        &mut || grasp.with(&round).solve(load).map(drop).map_err(Failure::from),
        &mut || stuck.solve(load).map(drop).map_err(Failure::from),
    ])?;
    Ok(Some(Times { sliding: sliding as f64, pivoting, polygon, round, bonded }))
}
