//! Whole load paths of patches.

use std::hint::black_box;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Leg, PathEnd};
use nalgebra::SVector;

use support::best_time::best;

use crate::report::{Beside, row};
use crate::{Outcome, up_to};
use grasp_lcp::spatial;
use support::patches::{planar_patch, spatial_patch, uneven};

/// Error that a leg may add to forces, relative to the largest force.
const ERROR: f64 = 1e-4;

/// Times whole load paths in steps: a pressed patch is sheared until most of it slides, and back. The time includes the equilibrium at the start.
/// `Grasp::follow` is compared if it does not take too long.
pub fn rows(most: usize) -> Outcome {
    for n in up_to(most, [100, 1000, 10_000, 100_000]) {
        let (grasp, load) = planar_patch(n)?;
        whole_path::<3, 2>("in the plane", &grasp, &load, n <= 100)?;
    }
    for n in up_to(most, [100, 1000, 10_000]) {
        let (grasp, load) = spatial_patch(n)?;
        whole_path::<6, 3>("in space", &grasp, &load, n <= 100)?;
    }
    for n in up_to(most, [30, 100, 300]) {
        round_a_ball(n)?;
    }
    Ok(())
}

/// Times the load path of many fingers that press on a ball from all sides, on the round cone: from no load until many slide, in directions that turn.
fn round_a_ball(n: usize) -> Outcome {
    let finger = |i: usize| {
        let u = |k: usize| uneven(13 * i + k) - 0.5;
        let height = 1.6 * u(1);
        let radius = (1.0 - height * height).sqrt();
        let (sin, cos) = (std::f64::consts::TAU * u(2)).sin_cos();
        let [x, y, z] = [radius * cos, radius * sin, height];
        spatial::Contact::new([x, y, z], [-x + 0.2 * u(3), -y + 0.2 * u(4), -z + 0.2 * u(5)])
            .series_stiffness(900.0 * (1.0 + u(6)), 600.0 * (1.0 + u(7)))
            .friction(0.5 + 0.4 * u(8))
            .command([0.01, 0.0, 0.0])
    };
    let grasp = Grasp::new((0..n).map(finger))?;
    let load = spatial::Wrench::new([0.2, 0.1, -1.0], [0.05, 0.1, 0.02]) * n as f64;
    let legs = [Leg::load_to(load * 10.0)];
    let mut remark = String::new();
    let time = best(|| {
        let Ok(mut path) = grasp.follow(Wrench::ZERO, &legs) else { return };
        let events = path.run().len();
        remark = format!("{events} events, {}, error {:.0e}", how(path.end()), path.step_error());
    });
    row(&format!("load path on the round cone, {n} fingers"), time, Beside::NOTHING, &remark);
    Ok(())
}

fn whole_path<const D: usize, const C: usize>(
    place: &str,
    grasp: &Grasp<C>,
    load: &Wrench<C>,
    affordable: bool,
) -> Outcome {
    // The normal component of the load; all contacts have the same normal.
    let press = SVector::<f64, D>::from_fn(|k, _| if k == C - 1 { load.components()[k] } else { 0.0 });
    let press = Wrench::from_components(press.as_slice());
    let there_and_back = [Leg::load_to(*load), Leg::load_to(press)];
    for (name, legs) in [("", &there_and_back[..1]), (" and back", &there_and_back)] {
        let mut path = grasp.follow_in_steps(press, legs, ERROR)?;
        let steps = path.by_ref().count();
        let residual = path.state().map_or(f64::NAN, |state| state.residuals.worst());
        let how = how(path.end());
        let time = best(|| {
            black_box(grasp.follow_in_steps(press, legs, ERROR).map_or(0, Iterator::count));
        });
        let whole = || grasp.follow(press, legs).map(|mut path| path.run().len());
        let long = if affordable { best(|| drop(black_box(whole()))) } else { f64::NAN };
        row(
            &format!("load path{name}, patch {place}, n = {}", grasp.len()),
            time,
            Beside { in_general: long, ..Beside::NOTHING },
            &format!("{steps} steps within {ERROR:.0e}, residual {residual:.1e}, {how}"),
        );
    }
    Ok(())
}

fn how<const C: usize>(end: Option<&PathEnd<C>>) -> &'static str {
    if matches!(end, Some(PathEnd::Completed)) { "completed" } else { "not completed" }
}
