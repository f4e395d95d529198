//! Equilibria of a few contacts and of patches.

use std::hint::black_box;

use grasp_lcp::PolygonCone;
use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::grasp::Wrench;

use support::best_time::best;

use crate::report::{Beside, row};
use crate::today::sticks;
use crate::{Outcome, up_to};
use support::patches::{fingers, planar_patch, spatial_patch};

/// Prints run times of equilibria of three to five contacts in space, some of which slide, on a polygon of 8 facets and on the round cone.
pub fn few_contacts() -> Outcome {
    for count in 3..=5 {
        let (grasp, load) = fingers(count)?;
        solved(&format!("{count} contacts in space"), &grasp, &load, true)?;
    }
    Ok(())
}

/// Prints run times of equilibria of patches. In the plane two thirds of the springs slide, in space half of them.
pub fn patches(most: usize) -> Outcome {
    for n in up_to(most, [100, 1000, 10_000, 100_000]) {
        let (grasp, load) = planar_patch(n)?;
        solved(&format!("patch in the plane, n = {n}"), &grasp, &load, n <= 300)?;
    }
    for n in up_to(most, [100, 1000, 10_000]) {
        let (grasp, load) = spatial_patch(n)?;
        solved(&format!("patch in space, n = {n}"), &grasp, &load, n <= 100)?;
    }
    Ok(())
}

/// Times `Grasp::solve` on the polygon and on the round cone; and, if they do not take too long, the kinematic form as a dense problem and the
/// reduced quadratic program.
fn solved<const C: usize>(name: &str, grasp: &Grasp<C>, load: &Wrench<C>, affordable: bool) -> Outcome {
    let (dense, today) =
        if affordable { (dense(grasp, load), program_once(grasp, load)) } else { (f64::NAN, f64::NAN) };
    let polygon = Settings::default().on_the_polygon();
    let time = best(|| drop(black_box(grasp.with(&polygon).solve(load))));
    let beside = Beside { in_general: dense, today, ..Beside::NOTHING };
    row(&format!("equilibrium, {name}, polygon"), time, beside, &remark(&grasp.with(&polygon).solve(load)?));
    if C == 3 {
        let time = best(|| drop(black_box(grasp.solve(load))));
        let remarks = remark(&grasp.solve(load)?);
        row(&format!("equilibrium, {name}, round cone"), time, Beside::NOTHING, &remarks);
    }
    Ok(())
}

/// Times the whole way from contacts to an equilibrium: building a grasp, with its validation, and solving it.
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

/// Time to assemble the reduced quadratic program and solve it once by an interior-point method. Its friction law differs, so that only times can be
/// compared.
fn program_once<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> f64 {
    best(|| _ = black_box(sticks(grasp, load)))
}

/// Time to assemble and solve the kinematic form as a dense problem, without forces, gaps and residuals of an answer.
fn dense<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> f64 {
    best(|| {
        if let Ok(Some(form)) = grasp.kinematic_form(load, &PolygonCone::default()) {
            black_box(form.lcp.solve());
        }
    })
}

fn remark<const C: usize>(outcome: &grasp_lcp::equilibrium::Outcome<C>) -> String {
    let Some(found) = outcome.equilibrium() else { return outcome.to_string() };
    let slides = found.contacts.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count();
    let (count, rule) = (found.contacts.len(), found.rule);
    format!("{slides} of {count} slide, {rule:?}, residual {:.1e}", found.residuals.worst())
}
