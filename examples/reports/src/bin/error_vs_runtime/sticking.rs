//! Contact forces while everything sticks: the crate, the textbook's formula, and quadratic programs.
//!
//! Five fingers in space, first with equal springs, then with one finger 10⁶ times as stiff. Rational arithmetic gives the exact forces.

use grasp_lcp::PolygonCone;
use grasp_lcp::spatial::{Contact, Grasp, Twist, Wrench};
use nalgebra::{DVector, Matrix6, Vector3, Vector6};

use crate::exact_sticking;
use crate::report::{Panel, Report};
use support::Failure;
use support::best_time::timed;
use support::interior_point::{Oracle, interior_point_within};
use support::printed_program::{PrintedContact, PrintedProgram};
use support::quadratic_program::QuadraticProgram;
use support::reduced_program::ReducedProgram;

const LOAD: [f64; 6] = [0.5, -0.25, -2.0, 0.03125, 0.0625, -0.015_625];
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

pub fn measure(report: &mut Report) -> Result<(), Failure> {
    report.push(forces("Five fingers that stick, springs alike", 1.0)?);
    report.push(forces("Five fingers that stick, one 10⁶ times as stiff", 1e6)?);
    Ok(())
}

/// Five fingers whose normals, towards the centre, have integer length; the first is `stiffer` times as stiff as the others.
fn fingers(stiffer: f64) -> [exact_sticking::Contact; 5] {
    let finger = |point, normal, length, stiffness: f64, press: f64| exact_sticking::Contact {
        point,
        normal,
        length,
        stiffness: [1024.0 * stiffness, 768.0 * stiffness],
        command: press / (1024.0 * stiffness),
    };
    [
        finger([0.03, 0.0, 0.004], [-1, 0, 0], 1, 1.0, 8.0),
        finger([-0.02, 0.02, 0.0], [2, -2, -1], 3, 1.25, 7.0),
        finger([-0.015, -0.025, 0.01], [3, 6, -2], 7, 0.75, 6.0),
        finger([0.01, 0.028, -0.006], [-2, -6, 3], 7, 1.5, 5.0),
        finger([0.0, -0.005, -0.03], [0, 0, 1], 1, stiffer, 4.0),
    ]
}

fn forces(title: &'static str, stiffer: f64) -> Result<Panel, Failure> {
    let exact = fingers(stiffer);
    let truth = exact_sticking::forces(&exact, &LOAD).ok_or("no free motion")?;
    let truth: Vec<_> = truth.into_iter().map(Vector3::from).collect();
    // Body and finger are equally stiff, so that the series stiffness is exactly half of either.
    let grasp = Grasp::new(exact.iter().map(|c| {
        let [kn, kt] = c.stiffness.map(|k| 2.0 * k);
        Contact::new(c.point, c.normal.map(f64::from))
            .body_stiffness(kn, kt)
            .finger_stiffness(kn, kt)
            .friction(1.0)
            .command([c.command, 0.0, 0.0])
    }))?;
    let load = Wrench::from_vector(LOAD);
    let size = truth.iter().map(Vector3::norm).fold(0.0, f64::max);
    let off = |forces: &[Vector3<f64>]| {
        forces.iter().zip(&truth).map(|(f, t)| (f - t).norm()).fold(0.0, f64::max) / size
    };
    let mut panel = Panel::new("sticking", title, "error of a contact force / largest force");

    let (outcome, time) = timed(|| Ok(grasp.solve(load)?))?;
    let answer = outcome.equilibrium().ok_or("it holds")?;
    let world: Vec<_> = answer.contacts.iter().map(|c| c.force_world).collect();
    panel.add("Grasp::solve, with its answer as physics", "", off(&world), time);

    let (twist, time) = timed(|| textbook(&grasp, &load))?;
    panel.add("textbook, (G K Gᵀ)⁻¹ by Cholesky", "", off(&at(&grasp, &twist, &[])), time);

    let cone = PolygonCone::default();
    let both: Vec<_> =
        exact.iter().map(|c| Vector3::new(c.stiffness[0], c.stiffness[1], c.stiffness[1]) * 2.0).collect();
    let both: Vec<_> = both.into_iter().map(|k| PrintedContact::of(k, k)).collect();
    let printed = || PrintedProgram::of(&grasp, &both, &load, &cone);
    let reduced = || ReducedProgram::new(&grasp, &load, &cone);
    let meaning = (printed(), reduced());
    let by_printed = |x: &DVector<f64>| {
        let forces = grasp.frames().enumerate().map(|(i, frame)| frame * meaning.0.force(x, i));
        forces.collect::<Vec<_>>()
    };
    let by_reduced = |x: &DVector<f64>| {
        let twist = Twist::from_vector(x.fixed_rows::<6>(0).into_owned());
        let gaps: Vec<_> = meaning.1.gaps.iter().zip(x.iter().skip(6)).map(|(&i, &gap)| (i, gap)).collect();
        at(&grasp, &twist, &gaps)
    };
    let (x, time) = timed(|| lemke(&printed().program))?;
    panel.add("printed QP by Lemke", "", off(&by_printed(&x)), time);
    let (x, time) = timed(|| lemke(&reduced().program))?;
    panel.add("reduced QP by Lemke", "", off(&by_reduced(&x)), time);
    for tolerance in TOLERANCES {
        let (oracle, time) = timed(|| Ok(interior_point_within(&reduced().program, tolerance)))?;
        let error = if let Oracle::Minimum(x, _) = oracle { off(&by_reduced(&x)) } else { f64::NAN };
        panel.add("reduced QP by Clarabel", format!("{tolerance:.0e}"), error, time);
    }
    let held = grasp.energy().minimum(load)?;
    let binding = held.minimum().map_or(usize::MAX, |minimum| minimum.binding.len());
    if binding > 0 {
        return Err("a friction row binds: the programs would answer another question".into());
    }
    Ok(panel)
}

fn lemke(program: &QuadraticProgram) -> Result<DVector<f64>, Failure> {
    Ok(program.solve()?.ok_or("no minimum")?.x)
}

/// Forces along the coordinate axes after the object has moved by a twist and some contacts have opened.
fn at(grasp: &Grasp, twist: &Twist, gaps: &[(usize, f64)]) -> Vec<Vector3<f64>> {
    let force = |(i, (contact, frame)): (usize, (&Contact, &nalgebra::Matrix3<f64>))| {
        let moved = Vector3::from(twist.displacement_at(contact.point()));
        let mut stretch = contact.commanded() - frame.tr_mul(&moved);
        stretch[0] += gaps.iter().filter(|gap| gap.0 == i).map(|gap| gap.1).sum::<f64>();
        frame * contact.series_stiffness_of_axes().component_mul(&stretch)
    };
    grasp.contacts().iter().zip(grasp.frames()).enumerate().map(force).collect()
}

/// The twist q of the object by the textbook's formula, q = (Σ G K Gᵀ)⁻¹ (W + Σ G K a). W is the load; G, K and a are the grasp map,
/// stiffness and command of a contact.
fn textbook(grasp: &Grasp, load: &Wrench) -> Result<Twist, Failure> {
    let (mut stiffness, mut pull) = (Matrix6::zeros(), load.to_vector());
    for (contact, frame) in grasp.contacts().iter().zip(grasp.frames()) {
        let (p, k) = (contact.point(), contact.series_stiffness_of_axes());
        for axis in 0..3 {
            let n = frame.column(axis).into_owned();
            let m = p.cross(&n);
            let g = Vector6::new(n.x, n.y, n.z, m.x, m.y, m.z);
            stiffness += g * (g.transpose() * k[axis]);
            pull += g * (k[axis] * contact.commanded()[axis]);
        }
    }
    let factor = stiffness.cholesky().ok_or("not definite to working precision")?;
    Ok(Twist::from_vector(factor.solve(&pull)))
}
