//! The least squeeze and the weakest direction of a force are right: dense samples of loads on both sides of each answer confirm them.

use grasp_lcp::equilibrium::{FoundBy, Outcome};
use grasp_lcp::load_path::{DepartingPart, Ramp};
use grasp_lcp::squeeze::{LeastSqueeze, Loads, WeakestDirection};
use grasp_lcp::{Error, planar, spatial};
use support::facts;
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Data of a spatial grasp of fingers around a ball, whose commands press with `press` N each.
struct Ball {
    fingers: Vec<([f64; 3], [f64; 3], f64, f64)>,
}

impl Ball {
    fn new(count: usize, numbers: &mut Random) -> Self {
        let finger = |k: usize| {
            let angle = std::f64::consts::TAU * (k as f64 + 0.2 * numbers.signed()) / count as f64;
            let point = [angle.cos(), angle.sin(), 0.3 * numbers.signed()];
            let bent: [f64; 3] = numbers.vector();
            let normal = std::array::from_fn(|a| 0.15 * bent[a] - point[a]);
            (point, normal, 1000.0 * (1.0 + numbers.uniform()), 0.4 + 0.4 * numbers.uniform())
        };
        Self { fingers: (0..count).map(finger).collect() }
    }

    fn pressed(&self, press: f64) -> Result<spatial::Grasp, Error> {
        let contact = |(point, normal, k, mu): &([f64; 3], [f64; 3], f64, f64)| {
            spatial::Contact::new(*point, *normal).series_stiffness(*k, 0.7 * k).friction(*mu).command([
                press / k,
                0.0,
                0.0,
            ])
        };
        spatial::Grasp::new(self.fingers.iter().map(contact))
    }
}

/// Whether all contacts stick under a load.
fn sticks(grasp: &spatial::Grasp, load: &spatial::Wrench) -> bool {
    match grasp.solve(load).expect("a load") {
        Outcome::Equilibrium(e) => e.rule == FoundBy::EverythingSticks,
        _ => false,
    }
}

#[test]
fn no_direction_is_weaker_than_the_weakest() -> Result<(), Error> {
    let mut numbers = seeded(21);
    let mut found = 0;
    for number in 0..samples(20) {
        let grasp = Ball::new(3 + number % 3, &mut numbers).pressed(10.0)?;
        let base = spatial::Wrench::force(numbers.vector());
        let point = numbers.vector().map(|x| 0.2 * x);
        let WeakestDirection::Force { size, direction, load, leaver, .. } =
            grasp.weakest_direction(base, point)?
        else {
            continue;
        };
        found += 1;
        let push = |direction: [f64; 3]| spatial::Wrench::force_at(direction, point);
        let onset = |direction: [f64; 3]| grasp.onset(Ramp::load(base, push(direction)));
        let there = onset(direction)?;
        let event = there.event().expect("slides");
        assert!((event.factor - size).abs() < 1e-13 * size, "{number}: {} {size}", event.factor);
        assert!(event.leaving.iter().any(|leaving| DepartingPart::Contact(leaving.contact.index) == leaver));
        assert!((load.to_vector() - event.load.to_vector()).norm() < 1e-12 * size);
        let mut least = f64::INFINITY;
        for _ in 0..2000 {
            let v = numbers.vector();
            let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            least = least.min(onset(v.map(|x| x / norm))?.factor().expect("sticks at rest"));
        }
        // Neighbouring directions are not weaker either.
        for step in [1e-2, 1e-4] {
            let near: [f64; 3] = numbers.vector();
            let v: [f64; 3] = std::array::from_fn(|a| direction[a] + step * near[a]);
            let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            least = least.min(onset(v.map(|x| x / norm))?.factor().expect("sticks at rest"));
        }
        assert!(least >= size * (1.0 - 1e-12) && least < 1.05 * size, "{number}: {least} {size}");
    }
    assert_met(&[(found, 13)]);
    Ok(())
}

#[test]
fn enough_is_enough_and_less_is_not() -> Result<(), Error> {
    let mut numbers = seeded(22);
    let mut factors = [0; 3];
    for number in 0..samples(20) {
        let ball = Ball::new(3 + number % 3, &mut numbers);
        let base = spatial::Wrench::force(numbers.vector());
        let point = numbers.vector().map(|x| 0.1 * x);
        let loads = match number % 3 {
            0 => Loads::Each(
                (0..4).map(|_| base + spatial::Wrench::force(numbers.vector().map(|x| 4.0 * x))).collect(),
            ),
            1 => Loads::AnyForce { base, size: 2.0, point },
            _ => Loads::Turn(spatial::Turn::tilting([0.0, 0.0, -3.0], point, numbers.vector())?.beside(base)),
        };
        // Each finger is commanded to press with 1 N, so the least factor of the commands is a force in newtons.
        let answer = ball.pressed(1.0)?.least_squeeze(&loads)?;
        let LeastSqueeze::Factor { factor, binding: Some((_, worst)), .. } = answer else { continue };
        factors[number % 3] += 1;
        let samples: Vec<spatial::Wrench> = match &loads {
            Loads::Each(list) => list.clone(),
            Loads::AnyForce { .. } => (0..400)
                .map(|_| {
                    let v = numbers.vector();
                    let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
                    base + spatial::Wrench::force_at(v.map(|x| 2.0 * x / norm), point)
                })
                .collect(),
            Loads::Turn(turn) => {
                (0..400).map(|k| turn.load_at(f64::from(k) / 400.0 * std::f64::consts::TAU)).collect()
            }
            other => panic!("{other:?}"),
        };
        let enough = ball.pressed(factor * (1.0 + 1e-9))?;
        assert!(samples.iter().all(|load| sticks(&enough, load)), "{number}: {factor}");
        assert!(sticks(&enough, &worst), "{number}: {factor}");
        let less = ball.pressed(factor * (1.0 - 1e-9))?;
        assert!(!sticks(&less, &worst), "{number}: {factor}");
    }
    assert!(factors.iter().all(|count| *count > samples(2)), "{factors:?}");
    Ok(())
}

#[test]
fn what_no_squeeze_helps_is_told() -> Result<(), Error> {
    // Two palms below: pressing harder only lifts the box, so without weight it holds no sideways load.
    let palm = |x: f64| {
        planar::Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1000.0, 800.0)
            .friction(0.5)
            .pressed_with(1.0)
    };
    let tray = planar::Grasp::new([palm(-1.0), palm(1.0)])?;
    let aside = planar::Wrench::force([3.0, -4.0]);
    assert!(matches!(tray.least_squeeze(&Loads::Each(vec![aside]))?, LeastSqueeze::NoFactor { .. }));
    // This load presses the box so much onto the palms that it needs no squeeze.
    let little = planar::Wrench::force([1.0, -4.0]);
    assert_eq!(tray.least_squeeze(&Loads::Each(vec![little]))?, factor_of_none());
    // Two fingers do not resist a rotation about their line.
    let finger = |x: f64| jaw::<3>(x, [1e3, 1e3], 0.5).pressed_with(1.0);
    let pinch = spatial::Grasp::new([finger(-1.0), finger(1.0)])?;
    let off = Loads::AnyForce { base: spatial::Wrench::ZERO, size: 1.0, point: [0.0, 0.1, 0.0] };
    assert!(matches!(pinch.least_squeeze(&off)?, LeastSqueeze::GivesWay { .. }));
    assert!(matches!(
        pinch.weakest_direction(spatial::Wrench::ZERO, [0.0, 0.1, 0.0])?,
        WeakestDirection::GivesWay { .. }
    ));
    // Forces through the line of the fingers and perpendicular to it are limited by μ F_n at each finger. Oblique forces have a lower limit, as in
    // the plane.
    let WeakestDirection::Force { size, .. } = pinch.weakest_direction(spatial::Wrench::ZERO, [0.0; 3])?
    else {
        panic!("slides")
    };
    assert!((size - 0.8_f64.sqrt()).abs() < 1e-15, "{size}");
    // Under this base load contacts already slide.
    let heavy = spatial::Wrench::force([0.0, 0.0, -1.5]);
    assert!(matches!(pinch.weakest_direction(heavy, [0.0; 3])?, WeakestDirection::NotSticking));
    Ok(())
}

fn factor_of_none() -> LeastSqueeze<2> {
    let free = planar::Grasp::new([planar::Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(1.0, 1.0)
        .kept_closed()]);
    free.and_then(|grasp| grasp.least_squeeze(&Loads::Each(vec![planar::Wrench::ZERO]))).expect("no squeeze")
}

#[test]
fn what_is_no_set_of_loads_is_refused() {
    let palm = |x: f64| jaw::<2>(x, [1000.0, 800.0], 0.5).pressed_with(1.0);
    let palms = planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap();
    let refused = |loads: Loads<2>| palms.least_squeeze(&loads).unwrap_err();
    let any = |size: f64, point: [f64; 2]| Loads::AnyForce { base: planar::Wrench::ZERO, size, point };
    let turn = planar::Turn::tilting([0.0, -1.0], [0.0, 0.0]).up_to(0.0);
    let endless = palms.weakest_direction(planar::Wrench::ZERO, [0.0, f64::INFINITY]).unwrap_err();
    for (error, datum, value) in [
        (refused(Loads::Each(Vec::new())), "number of loads", "0"),
        (refused(any(-1.0, [0.0; 2])), "size of", "-1"),
        (refused(any(1.0, [0.0, f64::NAN])), "point of", "NaN"),
        (refused(Loads::Turn(turn)), "angle of", "0"),
        (endless, "point of", "inf"),
    ] {
        let [_, what, given] = facts(&error);
        assert!(what.starts_with(datum) && given == value, "{error}");
    }
}

#[test]
fn a_squeeze_that_presses_nothing_helps_nothing() {
    // Fingers that all support from below only lift the object. Their remaining forces are rounding.
    let mut numbers = seeded(23);
    for _ in 0..samples(300) {
        let finger = |numbers: &mut Random| {
            let [x, y, _] = numbers.vector();
            let k = 1000.0 * 10_f64.powf(numbers.signed());
            spatial::Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
                .series_stiffness(k, 0.7 * k)
                .friction(0.5)
                .command([1e-3, 0.0, 0.0])
        };
        let grasp = spatial::Grasp::new([0; 3].map(|_| finger(&mut numbers))).unwrap();
        let aside = spatial::Wrench::force([3.0, 1.0, -1.0]);
        let told = grasp.least_squeeze(&Loads::Each(vec![aside])).unwrap();
        assert!(matches!(told, LeastSqueeze::NoFactor { .. }), "{told:?}");
    }
}
