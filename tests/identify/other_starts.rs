//! If the given data predict no slip at the observed loads, identification tries other starting values. Weights already act at rest in such scenes.

use grasp_lcp::Settings;
use grasp_lcp::identify::{FitEnding, Identify, Slip, Unknown};
use grasp_lcp::load_path::Ramp;
use grasp_lcp::planar::{Contact, Grasp, Turn, Wrench};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Number of random scenes.
const DRAWS: usize = 15;

type Tested = Result<(), grasp_lcp::Error>;

/// Two opposed fingers with slightly tilted normals. With high friction some loads wedge the object and never pull it out.
fn askew(draw: &mut Random, friction: f64) -> Vec<Contact> {
    [-1.0, 1.0]
        .map(|side| {
            let at = [0.04 * side, draw.between(-0.01, 0.01)];
            let (sin, cos) = draw.between(-0.3, 0.3).sin_cos();
            Contact::new(at, [-side * cos, sin])
                .series_stiffness(draw.between(500.0, 2000.0), draw.between(400.0, 1600.0))
                .friction(friction)
                .command([draw.between(0.005, 0.015), 0.0])
        })
        .to_vec()
}

/// The true friction, the grasp with another friction, and loads that pull the object out with the true friction, with a scatter of 5 %.
fn seen(draw: &mut Random, guess: f64) -> Result<(f64, Grasp, Vec<Wrench>), grasp_lcp::Error> {
    let truth = 0.1 + 0.3 * draw.uniform();
    let contacts = askew(draw, truth);
    // The true friction lets go under these loads, however far the object moves before.
    let however_far = Settings::default().with_small_motions(1e50, 1e50);
    let grasp = Grasp::new(contacts.clone())?.with(&however_far);
    if !grasp.hold(Ramp::load(Wrench::ZERO, Wrench::force([1e-3, 0.0])))?.sticks().unwrap_or(false) {
        // Scenes in which the fingers slide off at rest are drawn again.
        return seen(draw, guess);
    }
    let mut loads = Vec::new();
    while loads.len() < 8 {
        let (sin, cos) = (std::f64::consts::TAU * draw.uniform()).sin_cos();
        let load = Wrench::new([10.0 * cos, 10.0 * sin], 0.2 * (draw.uniform() - 0.5));
        let Some(lost) = grasp.hold(Ramp::load(Wrench::ZERO, load))?.lost else { continue };
        loads.push(load * (lost.factor * (0.05 * draw.normal()).exp()));
    }
    let guess = Grasp::new(contacts.into_iter().map(|contact| contact.friction(guess)))?;
    let guess = guess.with(&however_far);
    Ok((truth, guess, loads))
}

/// The given friction wedges the object, so that some of the observed loads would never pull it out. The search still finds all frictions, and the 95
/// % intervals contain the true ones.
#[test]
fn slips_are_found_from_a_friction_that_holds_against_them() -> Tested {
    let mut draw = seeded(62);
    let (mut wedged, mut held) = (0, 0);
    for _ in 0..samples(DRAWS) {
        let (truth, guess, loads) = seen(&mut draw, 1.2)?;
        let mut never = false;
        for load in &loads {
            never |= guess.hold(Ramp::load(Wrench::ZERO, *load))?.lost.is_none();
        }
        wedged += usize::from(never);
        let slips = loads.into_iter().map(|load| Slip::gross(load).scattering_by(0.05));
        let told = guess.identify(&Identify::new([Unknown::friction()], slips))?;
        assert_eq!(told.ending, FitEnding::Converged, "{truth}: {told}");
        held +=
            usize::from(told.estimates[0].interval.is_some_and(|[low, high]| low <= truth && truth <= high));
    }
    // Of 15 intervals, 14.25 are expected to contain the true friction. Four standard deviations of 0.84 below this number are accepted.
    assert_met(&[(wedged, 4), (held, 11)]);
    Ok(())
}

/// A block on a table is dragged: μ is the ratio of pull to weight, also if the given friction is far too low or far too high.
#[test]
fn a_weight_lies_there_before_a_block_is_dragged() -> Tested {
    let loads = [[2.652, -6.44], [5.385, -11.34]];
    let mean = loads.map(|[pull, weight]: [f64; 2]| (pull / -weight).ln()).iter().sum::<f64>() / 2.0;
    for friction in [0.01, 0.3, 4.0] {
        let table = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(friction);
        let slips = loads.map(|load| Slip::gross(Wrench::force(load)));
        let told = Grasp::new([table])?.identify(&Identify::new([Unknown::friction()], slips))?;
        assert!((told.estimates[0].value.ln() - mean).abs() < 1e-5, "{told}");
    }
    Ok(())
}

/// Before the fit, a box of 20 N is predicted to tip when the pull is a third of its weight, whatever its friction. Observed slips at lower loads
/// determine μ = 0.25: sliding at a pull of μ · 20 N, and on a table that tilts at the angle atan μ. Slips observed at the load of tipping leave
/// friction undetermined.
#[test]
fn a_box_that_tips_with_the_friction_at_the_start() -> Tested {
    let weight = Wrench::force_at([0.0, -20.0], [0.0, 0.1]);
    let pull = |newtons: f64| Slip::gross(Wrench::force_at([newtons, 0.0], [0.0, 0.15])).on_top_of(weight);
    let tilted = Slip::gross_on_turn(Turn::tilting([0.0, -20.0], [0.0, 0.1]).up_to(0.25_f64.atan()));
    for friction in [0.3, 0.5, 4.0] {
        let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(friction);
        let grasp = Grasp::new([foot(-0.05), foot(0.05)])?;
        let found = |slips: Vec<Slip<2>>| grasp.identify(&Identify::new([Unknown::friction()], slips));
        for slips in [vec![pull(5.0); 2], vec![tilted.clone()], vec![pull(5.0), tilted.clone()]] {
            let told = found(slips)?;
            assert!(
                (told.estimates[0].value / 0.25 - 1.0).abs() < 1e-6 && told.estimates[0].is_fixed,
                "{told}"
            );
        }
    }
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.5);
    let asked = Identify::new([Unknown::friction()], [6.6, 6.8, 6.65].map(pull));
    let told = Grasp::new([foot(-0.05), foot(0.05)])?.identify(&asked)?;
    assert!(!told.estimates[0].is_fixed && told.free.len() == 1, "{told}");
    Ok(())
}

/// On two feet, with the weight off their middle: a weight that acts at rest, before the pull, gives the same friction as a weight that is part of
/// the load.
#[test]
fn it_is_the_same_as_a_base_load() -> Tested {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.2);
    let grasp = Grasp::new([foot(-0.1), foot(0.1)])?;
    let (weight, pull) = (Wrench::force_at([0.0, -10.0], [0.03, 0.0]), Wrench::force([5.1, 0.0]));
    let found = |slip: Slip<2>| grasp.identify(&Identify::new([Unknown::friction()], [slip]));
    let (apart, together) = (found(Slip::gross(pull).on_top_of(weight))?, found(Slip::gross(pull + weight))?);
    let close = |a: f64| (a - 0.51).abs() < 1e-9;
    assert!(close(apart.estimates[0].value) && close(together.estimates[0].value), "{apart} {together}");
    Ok(())
}
