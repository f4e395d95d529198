//! Paths followed in steps end where paths from event to event end, within the requested error. With thousands of contacts they agree with closed
//! forms.

use std::f64::consts::TAU;

use grasp_lcp::equilibrium::ContactState;
use grasp_lcp::load_path::{LossKind, PathEnd};
use grasp_lcp::planar;
use grasp_lcp::spatial::{Contact, Grasp, Leg, Turn, Wrench};
use grasp_lcp::{Error, Settings};
use nalgebra::SVector;
use support::jaws::around;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A table with feet on uneven springs and a slightly uneven floor.
fn table(feet: usize, across: f64, numbers: &mut Random) -> Result<Grasp, Error> {
    let foot = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / feet as f64 + 0.4 * numbers.signed()).sin_cos();
        let k = 1000.0 * (1.0 + 0.3 * numbers.signed());
        let normal = [0.1 * numbers.signed(), 0.1 * numbers.signed(), 1.0];
        // If `across` is less than 0.8, the feet are softer along their second tangent.
        Contact::new([cos, sin, 0.0], normal)
            .series_stiffness_axes([k, 0.8 * k, across * k])
            .friction(0.5 + 0.2 * numbers.signed())
    };
    Grasp::new((0..feet).map(foot).collect::<Vec<_>>())
}

/// The weight of the table, a horizontal pull, and a vertical moment.
fn pulled([x, y]: [f64; 2], moment: f64) -> Wrench {
    Wrench::new([x, y, -10.0], [0.0, 0.0, moment])
}

/// Legs with shear and torsion together, a shear that turns, and unloading.
fn program(numbers: &mut Random) -> Vec<Leg> {
    let mut pull = |size: f64| {
        let shear = [0, 1].map(|_| size * numbers.signed());
        Leg::load_to(pulled(shear, size * numbers.signed()))
    };
    let around =
        Turn::new(pulled([0.0; 2], 0.0), Wrench::force([3.0, 0.0, 0.0]), Wrench::force([0.0, 3.0, 0.0]));
    vec![pull(2.5), pull(2.5), Leg::load_to(pulled([3.0, 0.0], 0.0)), Leg::turn(&around), pull(0.0)]
}

fn largest<'f>(forces: impl Iterator<Item = &'f SVector<f64, 3>>) -> f64 {
    forces.map(SVector::norm).fold(0.0, f64::max)
}

#[test]
fn they_end_where_paths_from_event_to_event_end() -> Result<(), Error> {
    for error in [1e-3, 1e-5, 1e-7] {
        let mut numbers = seeded(29);
        let (mut worst, mut steps, mut slid, mut compared) = (0.0_f64, 0, 0, 0);
        for scene in 0..samples(10) {
            let across = if scene % 2 == 1 { 0.6 } else { 0.8 };
            let table = table(3 + scene % 4, across, &mut numbers)?;
            let legs = program(&mut numbers);
            let start = pulled([0.0; 2], 0.0);
            let mut exact = table.follow(start, &legs)?;
            let events = exact.run().len();
            let mut path = table.follow_in_steps(start, &legs, error)?;
            steps += path.by_ref().count();
            let Some(PathEnd::Completed) = exact.end() else {
                assert!(!matches!(path.end(), Some(PathEnd::Completed)), "scene {scene}");
                continue;
            };
            assert!(matches!(path.end(), Some(PathEnd::Completed)), "scene {scene}");
            let state = exact.state_at(legs.len() - 1, 1.0).expect("completed");
            let differences: Vec<_> = state
                .contacts
                .iter()
                .zip(path.forces())
                .map(|(contact, force)| contact.force - force)
                .collect();
            let off = largest(differences.iter()) / largest(path.forces().iter());
            assert!(off <= path.step_error() + 1e-9, "{scene} {off:e} {:e}", path.step_error());
            assert!(path.state().expect("completed").residuals.worst() < 1e-11);
            worst = worst.max(off);
            slid += usize::from(events > 0);
            compared += 1;
        }
        println!(
            "error {error:e}: {worst:e} at worst of {compared} paths, {slid} of them with slip, in {steps} steps"
        );
        assert_met(&[(compared, 6), (slid, 5)]);
        assert!(worst <= error);
    }
    Ok(())
}

/// A disc of springs under Hertz's pressure, 10 N in total, and the radius and normal force of each spring.
fn disc(count: usize) -> Result<(Grasp, Vec<[f64; 2]>), Error> {
    let area = |i: usize| (i as f64 + 0.5) / count as f64;
    let whole: f64 = (0..count).map(|i| (1.0 - area(i)).sqrt()).sum();
    let rings: Vec<_> = (0..count).map(|i| [area(i).sqrt(), 10.0 * (1.0 - area(i)).sqrt() / whole]).collect();
    let spring = |(i, [r, press]): (usize, &[f64; 2])| {
        let (sin, cos) = (2.399_963_229_728_653 * i as f64).sin_cos();
        Contact::new([r * cos, r * sin, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(1000.0 / count as f64, 800.0 / count as f64)
            .friction(0.5)
            .pressed_with(*press)
    };
    Ok((Grasp::new(rings.iter().enumerate().map(spring).collect::<Vec<_>>())?, rings))
}

#[test]
fn errors_are_as_large_as_estimated() -> Result<(), Error> {
    // Four legs: shear, additional torsion, reversal beyond the start, and unloading. Three patches: an even one, an uneven one, and one whose
    // springs are softer along one tangent.
    let legs = [([3.0, 0.0], 0.0), ([3.0, 0.0], 1.5), ([-2.0, 0.5], -1.0), ([0.0; 2], 0.0)]
        .map(|(shear, moment)| Leg::load_to(pulled(shear, moment)));
    let (mut numbers, mut times) = (seeded(17), Vec::new());
    for (uneven, across) in [(0.0, 0.8), (0.4, 0.8), (0.4, 0.5)] {
        let spring = |i: usize| {
            let (area, (sin, cos)) = ((i as f64 + 0.5) / 60.0, (2.399_963_229_728_653 * i as f64).sin_cos());
            let k = 1000.0 * (1.0 + uneven * numbers.signed());
            Contact::new([area.sqrt() * cos, area.sqrt() * sin, 0.0], [0.0, 0.0, 1.0])
                .tangent([1.0, 0.0, 0.0])
                .series_stiffness_axes([k, 0.8 * k, across * k])
                .friction(0.5 * (1.0 + uneven * numbers.signed()))
                .pressed_with(0.25 * (1.0 - area).sqrt())
        };
        let patch = Grasp::new((0..60).map(spring).collect::<Vec<_>>())?;
        let start = pulled([0.0; 2], 0.0);
        let tiny = Settings::default().with_step_error(1e-12);
        let asked = patch.with(&tiny);
        let mut exact = asked.follow(start, &[])?;
        let mut forces = Vec::new();
        for leg in &legs {
            exact.continue_with(std::slice::from_ref(leg))?;
            exact.by_ref().for_each(drop);
            assert!(matches!(exact.end(), Some(PathEnd::Completed)), "{:?}", exact.end());
            forces.push(exact.forces());
        }
        let mut made = Vec::new();
        for error in [1e-3, 1e-4, 1e-5, 1e-6] {
            let mut path = patch.follow_in_steps(start, &[], error)?;
            let (mut steps, mut off) = (0, 0.0_f64);
            for (leg, exact) in legs.iter().zip(&forces) {
                path.continue_with(std::slice::from_ref(leg))?;
                steps += path.by_ref().count();
                let apart = path.forces().iter().zip(exact).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
                off = off.max(apart / largest(exact.iter()));
            }
            let estimated = path.step_error();
            println!(
                "{uneven} {across}, {error:e}: {steps} steps, {off:.1e} off, {estimated:.1e} estimated, {:.1} times",
                estimated / off
            );
            // The errors at the ends of four legs may be small by chance, so the estimate may be up to 30 times as large.
            assert!(off <= estimated && estimated < 30.0 * off && off < error);
            made.push(steps);
            times.push(estimated / off);
        }
        // For a hundredth of the error, steps of second order must be ten times as many, or fewer where old errors decay.
        assert!(made[3] < 12 * made[1] && made[2] < 12 * made[0], "{made:?}");
    }
    times.sort_by(f64::total_cmp);
    assert!(times[times.len() / 2] < 6.0, "{times:?}");
    Ok(())
}

#[test]
fn torsion_slides_ring_by_ring() -> Result<(), Error> {
    // During loading M(θ) = Σ r min(k r θ, μ F_n), and unloading follows Masing's rule.
    let (grasp, rings) = disc(400)?;
    let moment =
        |turn: f64| -> f64 { rings.iter().map(|[r, press]| r * (2.0 * r * turn).min(0.5 * press)).sum() };
    let legs = [2.0, -0.5].map(|moment| Leg::load_to(pulled([0.0; 2], moment)));
    let mut path = grasp.follow_in_steps(pulled([0.0; 2], 0.0), &legs, 1e-6)?;
    let (mut there, mut compared) = (0.0, 0);
    while let Some(step) = path.next() {
        let turn = path.state().expect("on the way").twist.rotation()[2];
        let exact = if step.leg == 0 { moment(turn) } else { 2.0 - 2.0 * moment(0.5 * (there - turn)) };
        let told = step.load.moment()[2];
        // The tolerance: a millionth of the largest force for each of 400 springs, at arms of up to 1 m.
        assert!((told - exact).abs() < 400.0 * 1e-6 * largest(path.forces().iter()), "{told} {turn} {exact}");
        if step.leg == 0 {
            there = turn;
        }
        compared += 1;
    }
    println!("{compared} steps");
    assert!(matches!(path.end(), Some(PathEnd::Completed)) && compared > 20);
    Ok(())
}

#[test]
fn a_ring_that_slides_at_once_holds_to_its_limit() -> Result<(), Error> {
    // Springs around a jar press with 1 N each, μ = 0.5. All n springs slide at once, at the force n/2 newtons.
    for count in [64, 1024] {
        let spring = |i: usize| around::<3>(i, count, 1.0, [1e3, 8e2], 0.5).pressed_with(1.0);
        let ring = Grasp::new((0..count).map(spring))?;
        let limit = 0.5 * count as f64;
        let legs = [Leg::load_to(Wrench::force([0.0, 0.0, -1.25 * limit]))];
        let mut path = ring.follow_in_steps(Wrench::ZERO, &legs, 1e-6)?;
        let steps = path.by_ref().count();
        let held = path.end().and_then(PathEnd::fraction).unwrap();
        println!("{count} {steps} {held}");
        let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{:?}", path.end()) };
        assert!(loss.kind == LossKind::Corner && loss.contacts.len() == count);
        let motion = loss.motion.as_ref().expect("it leaves").object.translation();
        assert!(motion[2] < 0.0, "{motion:?}");
        assert!((held - 0.8).abs() < 2e-12);
        assert!((path.state().expect("there").load.resultant()[2] + limit).abs() < 1e-11 * limit);
    }
    Ok(())
}

#[test]
fn they_are_lost_where_paths_from_event_to_event_are() -> Result<(), Error> {
    let mut numbers = seeded(0x5_0000_001f);
    let (mut alike, mut otherwise, mut held, mut undecided, mut worst) = (0, 0, 0, 0, 0.0_f64);
    for scene in 0..samples(15) {
        let table = table(3 + scene % 4, 0.8, &mut numbers)?;
        let [x, y, moment] = [0; 3].map(|_| 12.0 * numbers.signed());
        let (start, legs) = (pulled([0.0; 2], 0.0), [Leg::load_to(pulled([x, y], moment))]);
        let mut exact = table.follow(start, &legs)?;
        let _ = exact.run();
        let mut path = table.follow_in_steps(start, &legs, 1e-6)?;
        path.by_ref().for_each(drop);
        match [exact.end(), path.end()].map(|end| end.unwrap()) {
            [PathEnd::Completed, PathEnd::Completed] => held += 1,
            [PathEnd::Lost(exact), PathEnd::Lost(loss)] => {
                worst = worst.max((exact.fraction - loss.fraction).abs());
                if exact.kind == loss.kind {
                    alike += 1;
                } else {
                    // A corner lies close to a maximum of the load. One method may find the corner before it, and the other the maximum.
                    assert!(
                        ![exact.kind, loss.kind].contains(&LossKind::Asymptote),
                        "{scene}: {exact:?} {loss:?}"
                    );
                    otherwise += 1;
                }
            }
            [_, PathEnd::Undecided { .. }] => undecided += 1,
            // The path from event to event has infinitely many events before its limit load, and remains undecided.
            [PathEnd::Undecided { fraction, .. }, PathEnd::Lost(loss)] => {
                worst = worst.max((fraction - loss.fraction).abs());
                undecided += 1;
            }
            ends => panic!("{scene}: {ends:?}"),
        }
    }
    println!(
        "{alike} lost alike, {otherwise} otherwise, {held} held, {undecided} undecided; limits differ by {worst:.1e} of the leg"
    );
    assert_met(&[(alike, 13)]);
    assert!(otherwise == 0 && worst < 1e-8);
    Ok(())
}

#[test]
fn a_patch_slides_on_without_bound_at_its_limit() -> Result<(), Error> {
    let (grasp, _) = disc(300)?;
    for (shear, torsion) in [([0.0, 0.0], 6.0), ([4.5, 0.0], 1.5), ([0.6, 0.9], 3.0)] {
        let legs = [Leg::load_to(pulled(shear, torsion))];
        let mut path = grasp.follow_in_steps(pulled([0.0; 2], 0.0), &legs, 1e-4)?;
        let steps = path.by_ref().count();
        let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{:?}", path.end()) };
        println!("{steps} steps, {}", path.end().expect("lost"));
        assert!(loss.kind == LossKind::Asymptote && loss.contacts.len() == grasp.len());
        // The object moves in the direction of the pull, and every force is at its limit.
        let motion = loss.motion.as_ref().expect("it leaves");
        let [v, w] = [motion.object.translation(), motion.object.rotation()];
        assert!(v[0] * shear[0] + v[1] * shear[1] + w[2] * torsion > 0.0);
        let friction = |f: &SVector<f64, 3>| f[1].hypot(f[2]) / (0.5 * f[0]);
        assert!(path.forces().iter().all(|f| (friction(f) - 1.0).abs() < 1e-9));
    }
    Ok(())
}

#[test]
fn steps_are_bounded_and_can_be_looked_at_one_by_one() -> Result<(), Error> {
    let (grasp, _) = disc(50)?;
    let legs = [Leg::load_to(pulled([2.0, 0.0], 1.0))];
    let start = pulled([0.0; 2], 0.0);
    let few = Settings::default().with_most_steps(5);
    let asked = grasp.with(&few);
    let mut path = asked.follow_in_steps(start, &legs, 1e-8)?;
    let steps: Vec<_> = path.by_ref().collect();
    assert!(
        steps.len() <= 5
            && matches!(path.end(), Some(PathEnd::Undecided { fraction, .. }) if *fraction < 1.0)
    );
    assert_eq!(path.end().and_then(PathEnd::fraction), Some(steps.last().map_or(0.0, |step| step.fraction)));
    let mut path = grasp.follow_in_steps(start, &legs, 1e-4)?;
    let mut before = 0.0;
    while let Some(step) = path.next() {
        let state = path.state().expect("on the way");
        assert!(step.fraction > before && step.leg == 0);
        assert_eq!(
            (step.load, step.sliding),
            (
                state.load,
                state.contacts.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count()
            )
        );
        before = step.fraction;
    }
    assert_eq!(before, 1.0);
    Ok(())
}

#[test]
fn in_the_plane_they_end_where_every_event_was_found() -> Result<(), Error> {
    let mut numbers = seeded(5);
    let (mut worst, mut slid, mut completed) = (0.0_f64, 0, 0);
    for _ in 0..samples(20) {
        let foot = |i: i32| {
            let k = 1000.0 * (1.0 + 0.3 * numbers.signed());
            planar::Contact::new([f64::from(i), 0.0], [0.1 * numbers.signed(), 1.0])
                .series_stiffness(k, 0.8 * k)
                .friction(0.5 + 0.2 * numbers.signed())
        };
        let table = planar::Grasp::new((0..4).map(foot).collect::<Vec<_>>())?;
        let pulled = |x: f64| planar::Wrench::new([x, -10.0], -15.0);
        let legs = [3.0, -2.0, 3.5, 0.0].map(|x| planar::Leg::load_to(pulled(x)));
        let mut exact = table.follow(pulled(0.0), &legs)?;
        slid += exact.by_ref().map(|event| event.changes.len()).sum::<usize>();
        let mut path = table.follow_in_steps(pulled(0.0), &legs, 1e-6)?;
        path.by_ref().for_each(drop);
        let ends = [exact.end(), path.end()].map(|end| matches!(end, Some(PathEnd::Completed)));
        assert_eq!(ends[0], ends[1]);
        if ends[0] {
            let pairs = exact.forces().into_iter().zip(path.forces());
            worst = pairs.map(|(a, b)| (a - b).norm()).fold(worst, f64::max);
            assert!(path.state().expect("completed").residuals.worst() < 1e-12);
            completed += 1;
        }
    }
    println!("{worst:e} N at worst of forces of some 3 N, {completed} paths, {slid} changes");
    assert_met(&[(slid, 15), (completed, 10)]);
    assert!(worst < 1e-10);
    Ok(())
}

#[test]
fn bad_input_is_named() -> Result<(), Error> {
    let (grasp, _) = disc(5)?;
    for error in [0.0, -1.0, 2.0, f64::NAN] {
        let refused = grasp.follow_in_steps(Wrench::ZERO, &[], error).unwrap_err();
        let Error::Argument { what, value, .. } = refused else { panic!("{refused}") };
        assert!(what.starts_with("error") && value.to_bits() == error.to_bits(), "{what} {value}");
    }
    let none = grasp.follow_in_steps(Wrench::force([0.0, 0.0, 1e3]), &[], 1e-3)?;
    assert!(
        matches!(none.end(), Some(PathEnd::NoStart(_))) && none.state().is_none() && none.forces().is_empty()
    );
    Ok(())
}
