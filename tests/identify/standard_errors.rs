//! Standard errors of many unknowns at once agree with the standard errors from derivatives computed here, by differences of the answers of the grasp
//! or by hand.

use grasp_lcp::identify::{Identified, Identify, Slip, Unknown};
use grasp_lcp::{planar, spatial};
use nalgebra::{DMatrix, DVector};

/// Relative standard deviation of each observed slip load.
const SCATTER: f64 = 0.03;
/// Step of differences of fourth order.
const STEP: f64 = 1e-3;

/// The standard errors of logarithms, `σ √((JᵀJ)⁻¹)`, with the derivatives J of the logarithms of all slips.
fn from_differences(slips: &dyn Fn(&[f64]) -> Vec<f64>, values: &[f64]) -> Vec<f64> {
    let logarithms = |column: usize, by: f64| {
        let mut values = values.to_vec();
        values[column] *= by.exp();
        DVector::from_iterator(slips(&values).len(), slips(&values).into_iter().map(f64::ln))
    };
    let column = |j: usize| {
        let beside = |h: f64| logarithms(j, h) - logarithms(j, -h);
        (beside(STEP) * 8.0 - beside(2.0 * STEP)) / (12.0 * STEP)
    };
    let columns: Vec<_> = (0..values.len()).map(column).collect();
    let jacobian = DMatrix::from_columns(&columns);
    let inverse = (jacobian.transpose() * jacobian).try_inverse().expect("all are fixed");
    (0..values.len()).map(|j| SCATTER * inverse[(j, j)].sqrt()).collect()
}

fn agree(found: &Identified, values: &[f64], errors: &[f64]) {
    assert_eq!(found.by_differences, 0, "exact derivatives");
    for ((estimate, value), error) in found.estimates.iter().zip(values).zip(errors) {
        assert!((estimate.value / value - 1.0).abs() < 1e-9, "{value}: {found}");
        let told = estimate.standard_error.expect("is fixed") / estimate.value;
        assert!((told / error - 1.0).abs() < 1e-9, "{told} {error}: {found}");
    }
}

/// First slips of three different planar fingers under loads with moments. The unknowns are three coefficients of friction, the squeeze and a
/// tangential stiffness.
#[test]
fn of_first_slips() -> Result<(), grasp_lcp::Error> {
    let grasp = |values: &[f64]| {
        let finger = |k: usize, angle: f64, stiffness: f64, [press, aside]: [f64; 2]| {
            let (sin, cos) = angle.sin_cos();
            let tangential = if k == 1 { 700.0 * values[4] } else { 700.0 };
            planar::Contact::new([0.03 * cos, 0.03 * sin], [-cos, 0.1 - sin])
                .series_stiffness(1000.0 * stiffness, tangential)
                .friction(values[k])
                .command([press * values[3], aside * values[3]])
        };
        planar::Grasp::new([
            finger(0, 0.1, 1.0, [0.01, 1e-4]),
            finger(1, 2.0, 1.3, [0.012, 0.0]),
            finger(2, 4.0, 0.9, [0.011, -2e-4]),
        ])
        .expect("three fingers")
    };
    let load = |k: u32| {
        let (sin, cos) = (f64::from(k) * 0.5).sin_cos();
        planar::Wrench::force_at([cos, sin], [0.004, if k.is_multiple_of(2) { -0.01 } else { 0.02 }])
    };
    let loads: Vec<_> = (0..12).map(load).collect();
    let slips = |values: &[f64]| {
        let grasp = grasp(values);
        let first = |load| grasp.onset(load).expect("a load").factor();
        loads.iter().map(|load| first(load).expect("it slides")).collect::<Vec<_>>()
    };
    let values = [0.41, 0.55, 0.5, 1.1, 1.2];
    let seen = loads.iter().zip(slips(&values));
    let seen = seen.map(|(load, at)| Slip::first(*load * at).scattering_by(SCATTER));
    let mut unknowns: Vec<_> = (0..3).map(|k| Unknown::friction().of_contacts([k])).collect();
    unknowns.extend([Unknown::squeeze(), Unknown::stiffness().of_contacts([1])]);
    let found = grasp(&[0.5, 0.5, 0.5, 1.0, 1.0])
        .identify(&Identify::new(unknowns, seen).with_outliers_beyond(f64::INFINITY))?;
    agree(&found, &values, &from_differences(&slips, &values));
    Ok(())
}

const AT: [[f64; 2]; 4] = [[0.1, 0.08], [-0.1, 0.11], [-0.09, -0.1], [0.12, -0.1]];

/// Gross slips of four feet, statically indeterminate, under pushes at a height above the plane of the feet. The unknowns are the load of each foot
/// and two coefficients of friction. The sum of the loads is known for each of two pairs of feet.
fn of_pushes(height: f64) -> Result<(), grasp_lcp::Error> {
    let grasp = |values: &[f64]| {
        let foot = |k: usize| {
            spatial::Contact::new([AT[k][0], AT[k][1], 0.0], [0.0, 0.0, 1.0])
                .series_stiffness(1e5, 7e4)
                .friction(values[4 + k / 2])
                .pressed_with(values[k])
        };
        spatial::Grasp::new([0, 1, 2, 3].map(foot)).expect("four feet")
    };
    let pushes = [
        [1.0, 0.2, 0.03],
        [-0.4, 1.0, -0.08],
        [0.1, -1.0, 0.2],
        [0.3, 0.3, 0.0],
        [-1.0, -0.1, 0.1],
        [0.2, -0.4, -0.09],
        [-0.5, 0.6, 0.05],
        [0.8, -0.7, 0.04],
    ];
    let pushes =
        pushes.map(|[x, y, turn]| spatial::Wrench::new([x, y, 0.0], [-y * height, x * height, turn]));
    let slips = |values: &[f64]| {
        let weight =
            (0..4).map(|k| spatial::Wrench::force_at([0.0, 0.0, -values[k]], [AT[k][0], AT[k][1], 0.0]));
        let weight = weight.fold(spatial::Wrench::ZERO, |sum, part| sum + part);
        let grasp = grasp(values);
        let lost = |push: &spatial::Wrench| {
            let verdict = grasp.hold(spatial::Ramp::load(weight, *push * 100.0)).expect("a load");
            verdict.lost.expect("slips").factor * 100.0
        };
        let weighed = [values[0] + values[1], values[2] + values[3]];
        pushes.iter().map(lost).chain(weighed).collect::<Vec<_>>()
    };
    let values = [2.1, 3.4, 1.9, 4.2, 0.45, 0.35];
    let seen = pushes.iter().zip(slips(&values));
    let seen = seen.map(|(push, at)| Slip::gross(*push * at).scattering_by(SCATTER));
    let mut unknowns: Vec<_> = (0..4).map(|k| Unknown::carried().of_contacts([k])).collect();
    unknowns.extend([Unknown::friction().of_contacts([0, 1]), Unknown::friction().of_contacts([2, 3])]);
    let asked = Identify::new(unknowns, seen).with_outliers_beyond(f64::INFINITY);
    let asked =
        asked.knowing([0, 1], values[0] + values[1], SCATTER).knowing([2, 3], values[2] + values[3], SCATTER);
    let found = grasp(&[3.0, 3.0, 3.0, 3.0, 0.4, 0.4]).identify(&asked)?;
    agree(&found, &values, &from_differences(&slips, &values));
    Ok(())
}

#[test]
fn of_gross_slips() -> Result<(), grasp_lcp::Error> {
    of_pushes(0.0)
}

/// A push above the surface loads some feet more and others less, depending on their springs.
#[test]
fn of_gross_slips_that_tilt() -> Result<(), grasp_lcp::Error> {
    of_pushes(0.1)
}

/// A block on an incline slides from the angle θ = atan μ on: `d ln θ / d ln μ = μ / ((1 + μ²) θ)`.
#[test]
fn of_an_angle() -> Result<(), grasp_lcp::Error> {
    let mu = 0.4_f64;
    let foot = |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.3);
    let block = planar::Grasp::new([foot(-0.1), foot(0.1)])?;
    let turn = planar::Turn::tilting([0.0, -5.0], [0.0, 0.03]).up_to(mu.atan());
    let slip = Slip::gross_on_turn(turn).scattering_by(SCATTER);
    let asked = Identify::new([Unknown::friction()], [slip]).with_outliers_beyond(f64::INFINITY);
    let found = block.identify(&asked)?;
    agree(&found, &[mu], &[SCATTER * (1.0 + mu * mu) * mu.atan() / mu]);
    Ok(())
}
