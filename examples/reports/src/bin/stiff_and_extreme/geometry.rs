//! Lengths from nanometres to kilometres, nearly parallel normals, and many more contacts than are needed.

use grasp_lcp::equilibrium::Equilibrium;
use nalgebra::SVector;

use crate::Failure;
use crate::measure::{Question, Table};
use crate::ring::{FRICTION, LEVEL, NORMAL, SQUEEZE, TANGENTIAL, TILTED, held, power, uneven};
use support::scene::{Datum, Scene};

const UNITS: [(&str, f64); 6] =
    [("m", 1.0), ("nm", 1e-9), ("µm", 1e-6), ("mm", 1e-3), ("10 m", 10.0), ("km", 1e3)];
const COUNTS: [usize; 9] = [2, 3, 4, 5, 10, 30, 100, 300, 1000];

pub(crate) fn rows(table: &mut Table) -> Result<(), Failure> {
    for (case, slippery) in [("the same sticking scene", false), ("the same scene, one contact slides", true)]
    {
        lengths::<3, 2>(table, case, slippery)?;
        lengths::<6, 3>(table, case, slippery)?;
    }
    for (case, friction) in [("V-groove coupling without friction", 0.0), ("the same, friction 0.3", 0.3)] {
        for exponent in (0..=12).map(|k| -k) {
            // An angle of 1 rad would be 57° from the vertical, so that 0.5 rad takes its place.
            let value = if exponent == 0 { ("0.5".to_owned(), 0.5) } else { power(exponent) };
            let question = Question { family: "angle between normals", case, value, expected: None };
            table.ask(question.clone(), &cradle(question.value.1, friction))?;
            table.ask(question.clone(), &coupling(question.value.1, friction))?;
        }
    }
    for (case, load, friction) in [("sticking", 0.15, FRICTION), ("partly sliding", 0.8, 0.2)] {
        many::<3, 2>(table, case, load, friction)?;
        many::<6, 3>(table, case, load, friction)?;
    }
    Ok(())
}

/// Scenes with the same forces and other units of length.
fn lengths<const D: usize, const C: usize>(
    table: &mut Table,
    case: &'static str,
    slippery: bool,
) -> Result<(), Failure> {
    let mut in_metres: Option<Equilibrium<C>> = None;
    for (unit, metres) in UNITS {
        let mut scene = held::<D, C>(4, TILTED);
        if slippery {
            scene.contacts[1].friction = 0.02;
        }
        for datum in &mut scene.contacts {
            datum.point *= metres;
            datum.command *= metres;
            datum.stiffness /= metres;
        }
        for moment in C..D {
            scene.load[moment] *= metres;
        }
        let value = (unit.to_owned(), metres);
        let answer = table.ask(Question { family: "unit of length", case, value, expected: None }, &scene)?;
        if let (Some(first), Some(answer)) = (&in_metres, &answer) {
            let pairs = || first.contacts.iter().zip(&answer.contacts);
            let off = pairs().map(|(a, b)| (a.force - b.force).norm()).fold(0.0, f64::max);
            let size = pairs().map(|(a, _)| a.force.norm()).fold(0.0, f64::max);
            table.remark(format!("{:.0e} from the answer in metres", off / size));
        }
        in_metres = in_metres.or(answer);
    }
    Ok(())
}

fn resting<const C: usize>(point: [f64; C], normal: [f64; C], friction: f64) -> Datum<C> {
    let mut stiffness = SVector::repeat(TANGENTIAL);
    stiffness[0] = NORMAL;
    let (mut tangent, command) = (SVector::zeros(), SVector::zeros());
    tangent[0] = 1.0;
    Datum {
        point: point.into(),
        normal: normal.into(),
        tangent,
        stiffness,
        friction,
        command,
        clearance: 0.0,
    }
}

/// A body on three contacts in the plane. Two of them are tilted by an angle, so that their normal forces can carry the horizontal load.
fn cradle(angle: f64, friction: f64) -> Scene<3, 2> {
    let (sin, cos) = angle.sin_cos();
    let contacts = vec![
        resting([-1.0, 0.0], [sin, cos], friction),
        resting([1.0, 0.0], [-sin, cos], friction),
        resting([0.3, 0.1], [0.0, 1.0], friction),
    ];
    Scene { contacts, load: SVector::from([0.1 * sin, -1.0, -0.25]) }
}

/// A Maxwell coupling: three radial grooves, two contacts in each, tilted by the angle to either side.
fn coupling(angle: f64, friction: f64) -> Scene<6, 3> {
    let (sin, cos) = angle.sin_cos();
    let mut contacts = Vec::new();
    for groove in 0..3 {
        let (y, x) = (f64::from(groove) * std::f64::consts::TAU / 3.0 + 0.2).sin_cos();
        for side in [-1.0, 1.0] {
            let point = [x - 0.1 * side * y, y + 0.1 * side * x, 0.0];
            contacts.push(resting(point, [side * sin * y, -side * sin * x, cos], friction));
        }
    }
    Scene { contacts, load: SVector::from([0.05 * sin, 0.03 * sin, -1.0, 0.04, 0.03, 0.05 * sin]) }
}

/// Grasps of more and more fingers that squeeze unevenly, under a load that grows with their number.
fn many<const D: usize, const C: usize>(
    table: &mut Table,
    case: &'static str,
    load: f64,
    friction: f64,
) -> Result<(), Failure> {
    for count in COUNTS {
        let mut scene = held::<D, C>(count, LEVEL);
        for (i, datum) in scene.contacts.iter_mut().enumerate() {
            datum.command[0] = SQUEEZE * (1.0 + 0.8 * uneven(i + 11)) / NORMAL;
            datum.friction = friction;
        }
        scene.load *= load * count as f64;
        let value = (count.to_string(), count as f64);
        table.ask(Question { family: "number of contacts", case, value, expected: None }, &scene)?;
    }
    Ok(())
}
