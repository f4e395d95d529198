//! Whole load paths of patches.

use std::hint::black_box;

use grasp_lcp::Settings;
use grasp_lcp::grasp::{Grasp, Wrench};
use grasp_lcp::load_path::{Leg, PathEnd};
use nalgebra::SVector;

use crate::Outcome;
use crate::report::{best, row};
use support::patches::{planar_patch, spatial_patch};

/// Whole load paths, pressed to begin with and sheared up to where most of the patch slides, and back: every event exact, from the
/// public question on, with the equilibrium to start from; beside `Grasp::follow` where that is still affordable.
pub fn rows() -> Outcome {
    for n in [100, 1000, 10_000, 100_000] {
        let (grasp, load) = planar_patch(n)?;
        whole_path("in the plane", &grasp, &load, n <= 100)?;
    }
    for n in [100, 1000] {
        let (grasp, load) = spatial_patch(n)?;
        whole_path("in space", &grasp, &load, n <= 100)?;
    }
    Ok(())
}

fn whole_path<const D: usize, const C: usize>(
    place: &str,
    grasp: &Grasp<D, C>,
    load: &Wrench<D, C>,
    affordable: bool,
) -> Outcome {
    // Along the normals, which all contacts share.
    let press = SVector::from_fn(|k, _| if k == C - 1 { load.as_vector()[k] } else { 0.0 });
    let press = Wrench::from_vector(press);
    let there_and_back = [Leg::load_to(*load), Leg::load_to(press)];
    for (name, legs) in [("", &there_and_back[..1]), (" and back", &there_and_back)] {
        let mut path = grasp.follow_patch(&press, legs)?;
        let events = path.by_ref().count();
        let residual = path.state().map_or(f64::NAN, |state| state.residuals.worst());
        let looked = path.contacts_looked_at() as f64 / events as f64;
        let how = if matches!(path.end(), Some(PathEnd::Completed)) { "" } else { ", not completed" };
        let time = best((20_000 / grasp.len()).clamp(5, 50), || {
            black_box(grasp.follow_patch(&press, legs).map_or(0, Iterator::count));
        });
        let settings = Settings::default().on_the_polygon();
        let whole = || grasp.follow_with(&press, legs, &settings).map(|mut path| path.run().len());
        let long = if affordable { best(3, || drop(black_box(whole()))) } else { f64::NAN };
        row(
            &format!("load path{name}, patch {place}, n = {}", grasp.len()),
            time,
            long,
            f64::NAN,
            &format!("{events} events of {looked:.0} contacts, residual {residual:.1e}{how}"),
        );
    }
    Ok(())
}
