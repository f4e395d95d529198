//! A round fingertip in shear and torsion at once, on the round cone: all over it the directions of slip turn.
//!
//! Sixty springs under a parabolic pressure are sheared, then twisted in addition, and pulled back. `Grasp::follow` finds every event, with a relative
//! error of 1e-13 a step, and integrates directions by an explicit method of order 8. `Grasp::follow_in_steps` is independent of it: its steps are
//! straight in the springs' displacements, with slips in closed form.

use std::f64::consts::PI;

use grasp_lcp::load_path::Leg;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use grasp_lcp::{PolygonCone, PolygonFit, Settings};
use nalgebra::Vector3;

use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;

const SPRINGS: usize = 60;
const PRESSED: f64 = 10.0;
const FRICTION: f64 = 0.5;
/// Shear force as a fraction of its limit μ N, and moment as a fraction of μ N R, at the end of each leg; N is the normal force and R the radius. The
/// fingertip is sheared, twisted in addition, and pulled back beyond the start.
const LEGS: [[f64; 2]; 3] = [[0.6, 0.0], [0.6, 0.3], [-0.3, -0.1]];

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    let grasp = disc()?;
    let load = |[shear, torsion]: [f64; 2]| {
        let most = FRICTION * PRESSED;
        Wrench::new([shear * most, 0.0, -PRESSED], [0.0, 0.0, torsion * most])
    };
    let (start, legs) = (load([0.0; 2]), LEGS.map(|part| Leg::load_to(load(part))));
    let followed = |step_error: f64| -> Result<Vec<Vector3<f64>>, Failure> {
        let asked = grasp.with(&Settings::default().with_step_error(step_error));
        let mut path = asked.follow(start, &legs)?;
        path.by_ref().for_each(drop);
        let state = path.state().ok_or("it starts")?;
        Ok(state.contacts.iter().map(|contact| contact.force).collect())
    };
    let exact = followed(1e-13)?;
    let largest = exact.iter().map(Vector3::norm).fold(0.0, f64::max);
    let off = |forces: &[Vector3<f64>]| {
        forces.iter().zip(&exact).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / largest
    };
    let mut panel = Panel::new(
        "patch",
        "A fingertip of 60 springs in shear and torsion, and back: its forces",
        "error of a contact force / largest force",
    );
    for step_error in [1e-4, 1e-7, 1e-10] {
        let (forces, time) = timed(|| followed(step_error))?;
        panel.add("every event, Grasp::follow", format!("{step_error:.0e}"), off(&forces), time);
    }
    for error in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let (forces, time) = timed(|| {
            let mut path = grasp.follow_in_steps(start, &legs, error)?;
            path.by_ref().for_each(drop);
            Ok(path.forces())
        })?;
        panel.add("Grasp::follow_in_steps", format!("{error:.0e}"), off(&forces), time);
    }
    for facets in [8, 16, 32, 64, 128] {
        let cone = PolygonCone::new(facets, PolygonFit::Balanced)?;
        let (forces, time) = timed(|| {
            let asked = grasp.with(&Settings::default().on_the_polygon().with_cone(cone));
            let mut path = asked.follow(start, &legs)?;
            path.by_ref().for_each(drop);
            let state = path.state().ok_or("it starts")?;
            Ok(state.contacts.iter().map(|contact| contact.force).collect::<Vec<_>>())
        })?;
        panel.add("facets, Grasp::follow", facets.to_string(), off(&forces), time);
    }
    report.push(panel);
    Ok(())
}

/// Springs on a spiral, each of which represents the same area.
fn disc() -> Result<Grasp, Failure> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let area = |i: usize| (i as f64 + 0.5) / SPRINGS as f64;
    let whole: f64 = (0..SPRINGS).map(|i| (1.0 - area(i)).sqrt()).sum();
    let spring = |i: usize| {
        let ((sin, cos), r) = ((golden * i as f64).sin_cos(), area(i).sqrt());
        Contact::new([r * cos, r * sin, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(1000.0, 800.0)
            .friction(FRICTION)
            .pressed_with(PRESSED * (1.0 - area(i)).sqrt() / whole)
    };
    Ok(Grasp::new((0..SPRINGS).map(spring))?)
}
