//! A suction cup whose lip is open all around holds nothing, for every kind of question. The scene has three cups in a row, whose forces follow from
//! statics.
//!
//! The weight W hangs at distance b from the middle. With the vacuum force V, the cups carry V − W (1/3 + x b/2a²) at x = −a, 0, a. The nearest cup
//! opens at W = V / (1/3 + b/2a).

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::hold::{Holding, WayOut};
use grasp_lcp::load_path::{Beyond, LossKind, PathEnd};
use grasp_lcp::planar::{Contact, Grasp, Leg, Onset, Turn, Wrench};

const VACUUM: f64 = 60.0;
const SPACING: f64 = 0.1;
const OUT: f64 = 0.12;
/// The weight at which the nearest cup opens, V / (1/3 + b/2a).
const OPENS: f64 = VACUUM / (1.0 / 3.0 + OUT / (2.0 * SPACING));

type Tested = Result<(), grasp_lcp::Error>;

fn beam() -> Result<Grasp, grasp_lcp::Error> {
    let cup = |x: f64, name: &str| {
        Contact::new([x, 0.0], [0.0, -1.0])
            .name(name)
            .series_stiffness(5e3, 5e3)
            .friction(0.5)
            .suction(VACUUM)
    };
    Grasp::new([cup(-SPACING, "far"), cup(0.0, "middle"), cup(SPACING, "near")])
}

fn hanging(weight: f64) -> Wrench {
    Wrench::force_at([0.0, -weight], [OUT, 0.0])
}

#[test]
fn a_path_ends_where_the_lip_is_open_all_around() -> Tested {
    let beam = beam()?;
    let mut path = beam.follow(Wrench::ZERO, &[Leg::load_to(hanging(2.0 * OPENS))])?;
    let events = path.run();
    assert!(events.last().is_some_and(|event| (event.fraction - 0.5).abs() < 1e-12), "{events:?}");
    let loss = path.end().and_then(PathEnd::loss).expect("it lets go");
    assert_eq!((loss.kind, loss.contacts.len(), loss.contacts[0].index), (LossKind::LetsGo, 1, 2));
    assert!((loss.fraction - 0.5).abs() < 1e-12 && path.place() == (0, loss.fraction));
    let beyond = path.beyond().expect("lost");
    assert!(matches!(&beyond, Beyond::WithoutVacuum { cups } if cups[0].label == "near"), "{beyond:?}");

    // In the last equilibrium the cup is still closed, and the path cannot continue from there.
    assert!(path.state().is_some_and(|state| state.open_cups.is_empty()));
    path.continue_with(&[Leg::load_to(Wrench::ZERO)])?;
    assert!(path.next().is_none() && path.end().is_some());
    Ok(())
}

#[test]
fn a_path_does_not_begin_there() -> Tested {
    let beam = beam()?;
    let path = beam.follow(hanging(1.01 * OPENS), &[Leg::load_to(Wrench::ZERO)])?;
    let loss = path.end().and_then(PathEnd::loss).unwrap();
    assert_eq!((loss.kind, path.place()), (LossKind::LetsGo, (0, 0.0)));
    Ok(())
}

#[test]
fn an_equilibrium_there_says_that_it_is_none() -> Tested {
    let beam = beam()?;
    for (weight, open) in [(0.99 * OPENS, false), (1.01 * OPENS, true)] {
        let outcome = beam.solve(hanging(weight))?;
        let Outcome::Equilibrium(state) = &outcome else { panic!("{outcome}") };
        let names: Vec<_> = state.open_cups.iter().map(|cup| cup.label.as_str()).collect();
        assert_eq!(names, if open { vec!["near"] } else { Vec::new() });
        assert_eq!(outcome.to_string().contains("does not hold"), open, "{outcome}");
    }
    Ok(())
}

#[test]
fn an_onset_says_what_lies_beyond() -> Tested {
    let beam = beam()?;
    let onset = beam.onset(hanging(1.0))?;
    let Onset::At(event) = onset else { panic!("it opens") };
    assert!((event.factor - OPENS).abs() < 1e-11);
    let beyond = beam.beyond(&event);
    assert!(matches!(beyond, Some(Beyond::WithoutVacuum { .. })), "{beyond:?}");
    Ok(())
}

/// The load is sin θ times 1.02 times the weight that opens the cup, so that the cup opens at sin θ = 1/1.02.
#[test]
fn a_load_that_turns_opens_it_too() -> Tested {
    let beam = beam()?;
    let turn = Turn::new(Wrench::ZERO, Wrench::ZERO, hanging(1.02 * OPENS));
    let mut path = beam.follow(Wrench::ZERO, &[Leg::turn(&turn.up_to(1.5))])?;
    path.run();
    let loss = path.end().and_then(PathEnd::loss).expect("it lets go");
    assert_eq!(loss.kind, LossKind::LetsGo);
    assert!((loss.fraction * 1.5 - (1.0_f64 / 1.02).asin()).abs() < 1e-12, "{}", loss.fraction);
    Ok(())
}

#[test]
fn a_verdict_that_begins_there_lets_go_at_nothing() -> Tested {
    let verdict =
        beam()?.hold(grasp_lcp::planar::Ramp::load(hanging(1.01 * OPENS), Wrench::force([0.0, 1.0])))?;
    assert!(matches!(verdict.holding, Holding::Lost), "{verdict}");
    let lost = verdict.lost.unwrap();
    assert!(
        lost.factor == 0.0 && matches!(lost.way_out, WayOut::LetsGo { .. }) && lost.nothing_near.is_none()
    );
    Ok(())
}
