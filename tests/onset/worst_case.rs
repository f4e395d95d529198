//! The least onset within bounds agrees with the minimum over all corners of small boxes, and with closed forms.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::squeeze::{Bounds, LeastOnset};
use grasp_lcp::{Error, Field, PolygonCone, Settings, planar, spatial};
use nalgebra::SVector;
use support::jaws::jaw;

fn palms() -> planar::Grasp {
    let palm = |x: f64| jaw::<2>(x, [1000.0, 800.0], 0.5).command([0.01, 0.0]);
    planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap()
}

fn weight() -> planar::Ramp {
    planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -1.0]))
}

/// Each palm presses with `1000 (0.01 - 0.5 (δ_1 + δ_2))` newtons. The weight may have a side load b, and may be larger by the factor d.
#[test]
fn two_palms_in_closed_form() {
    let bounds = planar::Bounds::none()
        .with_commands([[0.001, 0.0], [0.002, 0.0]])
        .with_base(planar::Wrench::force([0.0, 0.7]))
        .with_direction(planar::Wrench::force([0.0, 0.1]));
    let LeastOnset::At { factor, commands, ramp, .. } =
        palms().least_onset_within(weight(), &bounds).unwrap()
    else {
        panic!("slides")
    };
    assert!((factor - (8.5 - 0.7) / 1.1).abs() < 1e-13, "{factor}");
    // The grasp of the worst case slides at this factor.
    let alone = palms().with_commands(commands).unwrap().onset(&ramp).unwrap();
    assert!((alone.factor().unwrap() - factor).abs() < 1e-13, "{alone:?}");
}

/// The least onset over all corners of the box.
fn least_of_corners<const D: usize, const C: usize>(
    grasp: &Grasp<C>,
    ramp: [SVector<f64, D>; 2],
    commands: &[[f64; C]],
    loads: [SVector<f64, D>; 2],
    settings: &Settings,
) -> f64 {
    let list: Vec<(usize, f64)> = commands
        .iter()
        .flatten()
        .copied()
        .chain(loads.iter().flat_map(|load| load.iter().copied()))
        .enumerate()
        .filter(|(_, bound)| *bound > 0.0)
        .collect();
    let mut least = f64::INFINITY;
    for corner in 0..1_usize << list.len() {
        let (mut held, mut loads) = (Vec::new(), ramp);
        held.extend(grasp.contacts().iter().map(Contact::commanded));
        for (bit, (place, bound)) in list.iter().enumerate() {
            let off = if corner >> bit & 1 == 0 { *bound } else { -bound };
            match place.checked_sub(C * commands.len()) {
                None => held[place / C][place % C] += off,
                Some(k) => loads[k / D][k % D] += off,
            }
        }
        let [base, direction] = loads.map(|w| Wrench::from_components(w.as_slice()));
        let held = grasp.clone().with_commands(held).unwrap();
        let onset = held.with(settings).onset(Ramp::load(base, direction)).unwrap();
        least = least.min(onset.factor().unwrap());
    }
    least
}

fn compare<const D: usize, const C: usize>(
    grasp: &Grasp<C>,
    ramp: [SVector<f64, D>; 2],
    commands: &[[f64; C]],
    loads: [SVector<f64, D>; 2],
    settings: &Settings,
) {
    let [base, direction] = loads.map(|w| Wrench::from_components(w.as_slice()));
    let bounds = Bounds::none().with_commands(commands.to_vec()).with_base(base).with_direction(direction);
    let along = Ramp::load(
        Wrench::from_components((ramp[0]).as_slice()),
        Wrench::from_components((ramp[1]).as_slice()),
    );
    let answer = grasp.with(settings).least_onset_within(&along, &bounds).unwrap();
    let LeastOnset::At { factor, commands: held, ramp: worst, .. } = answer else { panic!("{answer:?}") };
    let known = least_of_corners(grasp, ramp, commands, loads, settings);
    assert!((factor - known).abs() < 1e-12 * known, "{factor} {known}");
    let alone = grasp.clone().with_commands(held).unwrap().with(settings).onset(&worst).unwrap();
    assert!((alone.factor().unwrap() - factor).abs() < 1e-12 * factor, "{alone:?} {factor}");
}

#[test]
fn no_corner_is_worse_in_the_plane() {
    let finger = |angle: f64, mu: f64| {
        let point = [angle.cos(), angle.sin()];
        let contact = planar::Contact::new(point, point.map(|x| -x)).series_stiffness(1000.0, 700.0);
        contact.friction(mu).command([0.01, 5e-4])
    };
    let grasp = planar::Grasp::new([finger(0.3, 0.5), finger(2.1, 0.7), finger(4.4, 0.6)]).unwrap();
    for angle in [0.4, 1.9, 3.3, 5.8_f64] {
        let ramp = [SVector::from([0.1, -0.2, 0.05]), SVector::from([angle.cos(), angle.sin(), 0.1])];
        let loads = [SVector::from([0.2, 0.0, 0.1]), SVector::from([0.05, 0.1, 0.02])];
        compare(&grasp, ramp, &[[1e-3, 2e-4], [5e-4, 0.0], [0.0, 3e-4]], loads, &Settings::default());
    }
}

fn three_in_space() -> spatial::Grasp {
    let finger = |angle: f64, mu: f64| {
        let point = [angle.cos(), angle.sin(), 0.1 * angle.sin()];
        spatial::Contact::new(point, point.map(|x| -x))
            .series_stiffness_axes([1000.0, 700.0, 500.0])
            .friction(mu)
            .command([0.01, 1e-3, -1e-3])
    };
    spatial::Grasp::new([finger(0.3, 0.5), finger(2.1, 0.7), finger(4.4, 0.8)]).unwrap()
}

#[test]
fn no_corner_is_worse_on_the_round_cone() {
    let polygon = PolygonCone::new(7, grasp_lcp::Fit::Inscribed).unwrap();
    for settings in [Settings::default(), Settings::default().on_the_polygon().with_cone(polygon)] {
        for angle in [0.4, 1.9, 3.3, 5.8_f64] {
            let ramp = [
                SVector::from([0.1, -0.2, 0.1, 0.05, 0.0, 0.0]),
                SVector::from([angle.cos(), 0.3, angle.sin(), 0.0, 0.1, 0.0]),
            ];
            let loads = [
                SVector::from([0.2, 0.0, 0.1, 0.0, 0.05, 0.0]),
                SVector::from([0.05, 0.0, 0.1, 0.0, 0.0, 0.02]),
            ];
            let commands = [[1e-3, 3e-4, 0.0], [0.0, 5e-4, 0.0], [0.0, 0.0, 0.0]];
            compare(&three_in_space(), ramp, &commands, loads, &settings);
        }
    }
}

#[test]
fn without_bounds_it_is_the_onset() {
    let ramp = spatial::Ramp::load(spatial::Wrench::ZERO, spatial::Wrench::force([0.3, 0.2, -1.0]))
        .with_commands([[1e-4, 0.0, 0.0]; 3]);
    let known = three_in_space().onset(&ramp).unwrap().factor().unwrap();
    let answer = three_in_space().least_onset_within(&ramp, &spatial::Bounds::none()).unwrap();
    assert!(matches!(answer, LeastOnset::At { factor, .. } if (factor - known).abs() < 1e-13), "{answer:?}");
}

#[test]
fn what_does_not_stick_in_some_case_is_told() {
    let open = planar::Bounds::none().with_commands([[0.011, 0.0]; 2]);
    let answer = palms().least_onset_within(weight(), &open).unwrap();
    assert!(matches!(answer, LeastOnset::NotSticking { .. }), "{answer:?}");
    // The ramp only increases the squeeze.
    let tighter = planar::Ramp::commands(planar::Wrench::ZERO, [[1e-3, 0.0]; 2]);
    let slightly = planar::Bounds::none().with_commands([[1e-3, 1e-3]; 2]);
    let answer = palms().least_onset_within(&tighter, &slightly).unwrap();
    assert!(matches!(answer, LeastOnset::Never), "{answer:?}");
    let finger = |x: f64| jaw::<3>(x, [1e3, 1e3], 0.5).pressed_with(5.0);
    let pinch = spatial::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    let down = spatial::Ramp::load(spatial::Wrench::ZERO, spatial::Wrench::force([0.0, 0.0, -1.0]));
    let twisted = spatial::Bounds::none().with_base(spatial::Wrench::new([0.0; 3], [1e-3, 0.0, 0.0]));
    let answer = pinch.least_onset_within(&down, &twisted).unwrap();
    let LeastOnset::GivesWay { motion } = answer else { panic!("{answer:?}") };
    assert!(motion.object.rotation()[0].abs() > 0.5, "{motion:?}");
}

#[test]
fn bounds_that_are_none_are_refused() {
    let ask = |bounds: planar::Bounds| palms().least_onset_within(weight(), &bounds).unwrap_err();
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = ask(planar::Bounds::none().with_base(planar::Wrench::force([0.0, bad])));
        assert!(matches!(refused, Error::Argument { what, .. } if what.ends_with("base load")), "{refused}");
    }
    let refused = ask(planar::Bounds::none().with_commands([[0.0, -1e-3], [0.0, 0.0]]));
    let Error::Argument { what, value: -1e-3, .. } = refused else { panic!("{refused}") };
    assert!(what.ends_with("command"), "{what}");
    let refused = ask(planar::Bounds::none().with_commands([[f64::NAN, 0.0], [0.0, 0.0]]));
    assert!(matches!(refused, Error::Contact { field: Field::Command, .. }), "{refused}");
    let refused = ask(planar::Bounds::none().with_commands([[0.0, 0.0]]));
    assert!(matches!(refused, Error::Size { given: 1, expected: 2, .. }), "{refused}");
}
