//! Equilibria of a few contacts and of patches.

use std::hint::black_box;

use grasp_lcp::PolygonCone;
use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::ask::{Search, Workspace};
use grasp_lcp::forms::Row;
use grasp_lcp::grasp::Wrench;

use crate::limits::{Cores, Limit, Needs};
use support::best_time::best;

use crate::report::{Beside, row};
use crate::today::sticks;
use crate::{Outcome, up_to};
use support::patches::{fingers, planar_patch, spatial_patch};

/// Three to five contacts in space, 8 facets, some sliding: one solve in a workspace that has seen the grasp before.
pub fn few_contacts() -> Outcome {
    for count in 3..=5 {
        let (grasp, load) = fingers(count)?;
        let mut workspace = Workspace::default();
        let time = best(|| {
            black_box(workspace.solve(black_box(&grasp), black_box(&load)).is_ok());
        });
        let dense = dense(&grasp, &load);
        row(
            &format!("equilibrium, {count} contacts in space, 8 facets"),
            time,
            Beside { in_general: dense, today: program_once(&grasp, &load), ..Beside::NOTHING },
            &found(&mut workspace, &grasp, &load)?,
        );
        on_the_round_cone(&format!("{count} contacts in space"), &grasp, &load)?;
    }
    Ok(())
}

/// The same on the round cone, beside `Grasp::solve`.
fn on_the_round_cone(name: &str, grasp: &Grasp<3>, load: &Wrench<3>) -> Outcome {
    let mut workspace = Workspace::on_the_round_cone();
    let time = best(|| {
        black_box(workspace.solve(black_box(grasp), black_box(load)).is_ok());
    });
    let in_general = best(|| drop(black_box(grasp.solve(load))));
    let remarks = found(&mut workspace, grasp, load)?;
    row(
        &format!("equilibrium, {name}, round cone"),
        time,
        Beside { in_general, ..Beside::NOTHING },
        &remarks,
    );
    Ok(())
}

/// Patches of which two thirds slide in the plane, half in space: by Lemke's method alone, and with Newton's method as a start.
pub fn patches(most: usize) -> Outcome {
    for n in up_to(most, [100, 1000, 10_000, 100_000]) {
        let (grasp, load) = planar_patch(n)?;
        patch::<3, 2>("in the plane", &grasp, &load, n <= 300)?;
    }
    for n in up_to(most, [100, 1000, 10_000]) {
        let (grasp, load) = spatial_patch(n)?;
        patch::<6, 3>("in space", &grasp, &load, n <= 100)?;
        on_the_round_cone(&format!("patch in space, n = {n}"), &grasp, &load)?;
    }
    Ok(())
}

fn patch<const D: usize, const C: usize>(
    place: &str,
    grasp: &Grasp<C>,
    load: &Wrench<C>,
    affordable: bool,
) -> Outcome {
    let mut workspace = Workspace::default();
    let lemke = best(|| {
        black_box(workspace.solve_along_one_path(grasp, load).is_ok());
    });
    let remarks = remark(workspace.solve_along_one_path(grasp, load)?);
    let (dense, today) =
        if affordable { (dense(grasp, load), program_once(grasp, load)) } else { (f64::NAN, f64::NAN) };
    let name = format!("equilibrium, patch {place}, n = {}", grasp.len());
    let beside = Beside { in_general: dense, today, ..Beside::NOTHING };
    row(&format!("{name}, Lemke"), lemke, beside, &remarks);
    let newton = best(|| {
        black_box(workspace.solve(grasp, load).is_ok());
    });
    let limit = match workspace.solve(grasp, load)? {
        Search::Found(view) => view.newton_steps().map(|steps| Limit::of(&needs::<D, C>(grasp.len(), steps))),
        _ => None,
    };
    let beside = Beside { limit: limit.unwrap_or(Beside::NOTHING.limit), ..beside };
    row(&format!("{name}, Newton first"), newton, beside, &found(&mut workspace, grasp, load)?);
    Ok(())
}

/// Work for each contact in each step and at the start. Data are G_i, springs, friction, command and force. Operations are for its stretch, its
/// force, its part of the imbalance, and half of its part of the stiffness, three dyads.
fn needs<const D: usize, const C: usize>(contacts: usize, steps: usize) -> Needs {
    let [d, c] = [D, C].map(|n| n as f64);
    let bytes = 8.0 * (d * c + 3.0 * c + 1.0);
    let operations = 2.0 * (2.0 * d * c) + 4.0 * c + c * (d + d * (d + 1.0));
    let visits = contacts as f64 * (steps as f64 + 1.0);
    Needs {
        bytes: visits * bytes,
        among: contacts as f64 * bytes,
        operations: visits * operations,
        cores: Cores::All,
    }
}

/// The exponent p of n^p between 10³ and 10⁵ contacts in the plane.
pub fn growth() -> Outcome {
    let mut times = Vec::new();
    for n in [1000, 100_000] {
        let (grasp, load) = planar_patch(n)?;
        let mut workspace = Workspace::default();
        times.push(best(|| {
            black_box(workspace.solve_along_one_path(&grasp, &load).is_ok());
        }));
    }
    println!("growth of Lemke's cost from n = 10³ to 10⁵: n^{:.2}", (times[1] / times[0]).log10() / 2.0);
    Ok(())
}

/// From the public question to the answer as physics: building the scene with its validation, and solving it.
pub fn whole_solve(most: usize) -> Outcome {
    for n in up_to(most, [10_000, 100_000]) {
        let build = best(|| {
            black_box(planar_patch(n).is_ok());
        });
        let (grasp, load) = planar_patch(n)?;
        let mut worst = f64::NAN;
        let solve = best(|| {
            if let Ok(outcome) = grasp.with(&Settings::default()).solve(load) {
                worst = outcome.equilibrium().map_or(f64::NAN, |e| e.residuals.worst());
            }
        });
        row(&format!("building the grasp, plane, n = {n}"), build, Beside::NOTHING, "");
        let residual = format!("residual {worst:.1e}");
        row(&format!("Grasp::solve, plane, n = {n}"), solve, Beside::NOTHING, &residual);
    }
    Ok(())
}

/// Time to assemble the reduced quadratic program and solve it once by an interior-point method. Its friction law is another one: only the time
/// compares.
fn program_once<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> f64 {
    best(|| _ = black_box(sticks(grasp, load)))
}

/// Time to assemble and solve the kinematic form as a dense problem, without check of the answer as physics.
fn dense<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> f64 {
    best(|| {
        if let Ok(Some(form)) = grasp.kinematic_form(load, &PolygonCone::default()) {
            black_box(form.lcp.solve());
        }
    })
}

fn found<const C: usize>(
    workspace: &mut Workspace<C>,
    grasp: &Grasp<C>,
    load: &Wrench<C>,
) -> Result<String, grasp_lcp::Error> {
    Ok(remark(workspace.solve(grasp, load)?))
}

fn remark<const C: usize>(search: Search<'_, C>) -> String {
    let Search::Found(view) = search else { return format!("{search:?}") };
    let mut last = None;
    let slides = view.jumps().filter(|row| last.replace(contact_of(row)) != Some(contact_of(row))).count();
    let way =
        view.newton_steps().map_or(format!("{} pivots", view.pivots()), |steps| format!("{steps} steps"));
    format!("{slides} of {} slide, {way}, residual {:.1e}", view.forces().len(), view.residual())
}

fn contact_of(row: &Row) -> usize {
    match *row {
        Row::Gap { contact } | Row::Slip { contact, .. } => contact,
        _ => usize::MAX,
    }
}
