//! Derivatives with respect to positions and normals agree with closed forms, and are absent where none exist.

use grasp_lcp::load_path::Parameter;
use grasp_lcp::{Error, planar, spatial};
use support::jaws::jaw;

const MU: f64 = 0.5;
const PRESS: f64 = 10.0;

/// A finger with equal stiffness along both axes, so that a tilted finger still presses along its normal.
fn palm(x: f64) -> planar::Contact {
    jaw::<2>(x, [800.0, 800.0], MU).pressed_with(PRESS)
}

/// The derivative of the load factor at which the first contact slides or opens, with respect to one datum.
fn first_by(grasp: &planar::Grasp, event: &planar::OnsetEvent, by: Parameter) -> f64 {
    grasp.sensitivity().onset(event).unwrap().by(by).unwrap()[0]
}

fn weight() -> planar::Ramp {
    planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -1.0]))
}

/// One finger tilts by φ towards its tangent t. The horizontal force is `H = P (1 + cos φ) / 2` with the squeeze P, and the finger slides at the
/// weight `W = 2 H tan(atan μ - φ)`.
#[test]
fn a_palm_that_tilts() {
    let closed = |phi: f64| PRESS * (1.0 + phi.cos()) * (MU.atan() - phi).tan();
    // The tangent of the left finger is t = (n_y, -n_x) = (0, -1).
    let tilted = |phi: f64| {
        let left = planar::Contact::new([-1.0, 0.0], [phi.cos(), -phi.sin()]);
        let left = left.series_stiffness(800.0, 800.0).friction(MU).pressed_with(PRESS);
        planar::Grasp::new([left, palm(1.0)]).unwrap()
    };
    for phi in [0.0, 0.1, 0.3] {
        let grasp = tilted(phi);
        let onset = grasp.onset(weight()).unwrap();
        let event = onset.event().unwrap();
        assert!((event.factor - closed(phi)).abs() < 1e-13, "{phi}: {}", event.factor);
        let by_tilt = first_by(&grasp, event, Parameter::Normal { contact: 0, axis: 1 });
        let (sin, slope) = (phi.sin(), 1.0 / (MU.atan() - phi).cos().powi(2));
        let known = -PRESS * (sin * (MU.atan() - phi).tan() + (1.0 + phi.cos()) * slope);
        assert!((by_tilt - known).abs() < 1e-11, "{phi}: {by_tilt} {known}");
    }
}

/// The weight W hangs at x = 0. The left finger at -l carries the share 1 / (1 + l), and slides at `W = μ P (1 + l)` with the squeeze P. The right
/// finger slides at `W = μ P (1 + l) / l`.
#[test]
fn a_palm_that_is_elsewhere() {
    for l in [0.7, 1.0, 1.6] {
        let left = planar::Contact::new([-l, 0.0], [1.0, 0.0]);
        let left = left.series_stiffness(800.0, 800.0).friction(MU).pressed_with(PRESS);
        let grasp = planar::Grasp::new([left, palm(1.0)]).unwrap();
        let onset = grasp.onset(weight()).unwrap();
        let margins = grasp.sensitivity().onset(onset.event().unwrap()).unwrap();
        let by_place = margins.by(Parameter::Point { contact: 0, axis: 0 }).unwrap();
        for (leaving, by_place) in margins.leavers().into_iter().zip(by_place) {
            let left_slides = leaving == grasp_lcp::load_path::DepartingPart::Contact(0);
            let by_l = if left_slides { MU * PRESS } else { -MU * PRESS / (l * l) };
            assert!((by_place + by_l).abs() < 1e-11, "{l}: {by_place}");
        }
    }
}

/// Rotating all fingers together is equivalent to rotating the weight in the opposite direction. The derivatives with respect to both must agree.
#[test]
fn a_grasp_that_turns_as_a_whole() {
    let at = |angle: f64, mu: f64| {
        planar::Contact::new([angle.cos(), angle.sin()], [-angle.cos(), -angle.sin()])
            .series_stiffness(900.0, 500.0)
            .friction(mu)
            .command([0.01, 0.001])
    };
    let grasp = planar::Grasp::new([at(0.2, 0.5), at(2.2, 0.7), at(4.4, 0.6)]).unwrap();
    let onset = grasp.onset(weight()).unwrap();
    let event = onset.event().unwrap();
    let by = |parameter| first_by(&grasp, event, parameter);
    // For a positive rotation a point p moves by (-y, x), and the normal tilts away from t.
    let turned: f64 = (0..3)
        .map(|contact| {
            let p = grasp.contacts()[contact].point();
            let along = [0, 1].map(|axis| by(Parameter::Point { contact, axis }));
            along[1] * p[0] - along[0] * p[1] - by(Parameter::Normal { contact, axis: 1 })
        })
        .sum();
    // The weight (0, -1) rotated back changes by (-1, 0) per rad.
    let by_load = -by(Parameter::Load { component: 0 }) * event.factor;
    assert!(by_load.abs() > 0.1 && (turned - by_load).abs() < 1e-11, "{turned} {by_load}");
}

/// The command of a finger keeps its direction in space while the normal tilts. The derivative is that for a command that tilts too, plus a term from
/// the change of the command's components.
#[test]
fn commands_along_the_coordinate_axes() {
    let grasp = |phi: f64| {
        let left = planar::Contact::new([-1.0, 0.2], [phi.cos(), -phi.sin()]).command_world([0.011, 0.002]);
        planar::Grasp::new([left.series_stiffness(800.0, 500.0).friction(0.45), palm(1.0)]).unwrap()
    };
    let factor = |phi: f64| grasp(phi).onset(weight()).unwrap().factor().unwrap();
    let onset = grasp(0.0).onset(weight()).unwrap();
    let event = onset.event().unwrap();
    let by = |parameter| first_by(&grasp(0.0), event, parameter);
    let by_command = [0, 1].map(|axis| by(Parameter::Command { contact: 0, axis }));
    let in_the_frame = by(Parameter::Normal { contact: 0, axis: 1 });
    let a = grasp(0.0).contacts()[0].commanded();
    let known = in_the_frame + by_command[0] * a[1] - by_command[1] * a[0];
    let difference = (factor(1e-6) - factor(-1e-6)) / 2e-6;
    assert!((known - in_the_frame).abs() > 1e-2 && (difference - known).abs() < 1e-6, "{difference} {known}");
}

fn pinch(y: f64, z: f64) -> spatial::Grasp {
    let finger = |x: f64, [y, z]: [f64; 2]| {
        spatial::Contact::new([x, y, z], [-x, 0.0, 0.0])
            .series_stiffness(1000.0, 700.0)
            .friction(MU)
            .pressed_with(PRESS)
    };
    spatial::Grasp::new([finger(-1.0, [y, z]), finger(1.0, [0.0, 0.0])]).unwrap()
}

/// The object turns freely about the line of two point fingers. Derivatives exist only for moves of a finger that keep the load on this line.
#[test]
fn a_pinch_whose_line_leaves_the_load() {
    let ramp = spatial::Ramp::load(spatial::Wrench::ZERO, spatial::Wrench::force([0.0, 0.0, -1.0]));
    let factor = |z: f64| pinch(0.0, z).onset(&ramp).unwrap().factor().unwrap();
    let onset = pinch(0.0, 0.0).onset(&ramp).unwrap();
    let grasp = pinch(0.0, 0.0);
    let margins = grasp.sensitivity().onset(onset.event().unwrap()).unwrap();
    let by = |axis| margins.by(Parameter::Point { contact: 0, axis });
    let up = (factor(1e-7) - factor(0.0)) / 1e-7;
    let least = by(2).unwrap().into_iter().fold(f64::INFINITY, f64::min);
    assert!((up - least).abs() < 1e-5, "{up} {least}");
    // If a finger moves sideways, the weight turns the object about the line.
    assert_eq!(by(1), None);
}

/// A motion that is free in this geometry is resisted in all neighbouring geometries. Its first derivative does not exist.
#[test]
fn a_motion_that_another_geometry_holds() {
    let at = |x: f64, n: f64| {
        spatial::Contact::new([x, 0.0, 0.0], [0.0, 0.0, n]).series_stiffness(1000.0, 700.0).friction(MU)
    };
    // Three points on a line press along z, so that the object may turn about the line. If the third point is moved along z, the points resist this
    // rotation.
    let fingers = [at(-1.0, 1.0), at(1.0, 1.0), at(0.0, -1.0)].map(|c| c.pressed_with(PRESS));
    let grasp = spatial::Grasp::new(fingers).unwrap();
    let outcome = grasp.solve(spatial::Wrench::force([0.1, 0.0, 0.0])).unwrap();
    let held = outcome.equilibrium().expect("holds");
    assert!(!held.free_motions.is_empty());
    assert!(grasp.sensitivity().of(held, Parameter::Point { contact: 2, axis: 2 }).is_none());
    assert!(grasp.sensitivity().of(held, Parameter::Point { contact: 2, axis: 0 }).is_some());
}

#[test]
fn what_there_is_not_has_no_derivative() {
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap();
    let outcome = grasp.solve(planar::Wrench::ZERO).unwrap();
    let held = outcome.equilibrium().unwrap();
    for by in [
        Parameter::Point { contact: 2, axis: 0 },
        Parameter::Point { contact: 0, axis: 2 },
        Parameter::Normal { contact: 0, axis: 0 },
        Parameter::Normal { contact: 0, axis: 2 },
        Parameter::Normal { contact: 2, axis: 1 },
    ] {
        assert!(grasp.sensitivity().of(held, by).is_none(), "{by:?}");
    }
}

/// A load that is twice as large slides at half the factor. With a base load and changing commands, differences give the derivative.
#[test]
fn the_whole_load_times_a_number() {
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap();
    let onset = grasp.onset(weight()).unwrap();
    let event = onset.event().unwrap();
    let by_load = |event: &planar::OnsetEvent| {
        let margins = grasp.sensitivity().onset(event).unwrap();
        margins.by_load(&event.load).unwrap()[0]
    };
    assert!((by_load(event) + event.factor).abs() < 1e-12);
    let load = planar::Wrench::new([0.3, -1.0], 0.2);
    let ramp = |times: f64| {
        planar::Ramp::load(load * times, planar::Wrench::force([0.2, -1.0]) * times)
            .with_commands([[1e-3, 0.0], [0.0, 1e-4]])
    };
    let factor = |times: f64| grasp.onset(ramp(times)).unwrap().factor().unwrap();
    let onset = grasp.onset(ramp(1.0)).unwrap();
    let known = by_load(onset.event().unwrap());
    let difference = (factor(1.0 + 1e-6) - factor(1.0 - 1e-6)) / 2e-6;
    assert!((difference - known).abs() < 1e-7, "{difference} {known}");
}

#[test]
fn the_points_of_a_hand_have_no_derivatives() -> Result<(), Error> {
    use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    use grasp_lcp::planar::{Ramp, Wrench};
    let jaw = |x: f64| Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3)]).contact(palm(x));
    let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?;
    let onset = grasp.onset(Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0])))?;
    let margins = grasp.sensitivity().onset(onset.event().expect("slides")).expect("sticks before");
    assert_eq!(margins.by(Parameter::Point { contact: 0, axis: 0 }), None);
    Ok(())
}

/// A finger below moves sideways faster than the object moves down. It slides as soon as it touches, so at the first slip there is no friction margin
/// to differentiate.
#[test]
fn a_contact_that_slides_as_it_closes_has_no_margin() {
    let below = planar::Contact::new([0.0, -1.0], [0.0, 1.0])
        .series_stiffness(500.0, 400.0)
        .friction(0.3)
        .clearance(2e-3);
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0), below]).unwrap();
    let ramp = weight().with_commands([[0.0, 0.0], [0.0, 0.0], [0.0, 0.01]]);
    let onset = grasp.onset(&ramp).unwrap();
    let event = onset.event().unwrap();
    assert!(event.leaving[0].contact.index == 2 && (event.factor - 3.2).abs() < 1e-12, "{event:?}");
    assert!(grasp.sensitivity().onset(event).is_none());
}
