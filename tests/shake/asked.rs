//! A repeated load must be a closed cycle. The limit on followed cycles is respected, and a loss at rest or a stop ahead is reported.

use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
use grasp_lcp::shake::Repeats;
use grasp_lcp::{Error, Settings};

fn block() -> Result<Grasp, Error> {
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.5);
    Grasp::new([foot(-0.1), foot(0.1)])
}

#[test]
fn a_cycle_that_ends_elsewhere_is_refused() -> Result<(), Error> {
    let legs = [Leg::load_by(Wrench::force([1.0, 0.0])), Leg::load_by(Wrench::force([-0.5, 0.0]))];
    let refused = block()?.shake(Wrench::force([0.0, -10.0]), &legs).err();
    assert_eq!(refused, Some(Error::NotClosed { what: "load", off: 0.5 }));
    Ok(())
}

#[test]
fn a_cycle_of_legs_that_go_straight_from_load_to_load_walks_as_one_there_and_back() -> Result<(), Error> {
    let base = Wrench::force([3.5, -10.0]);
    let rocked = |moment: f64| Wrench::new([3.5, -10.0], moment);
    let legs = [Leg::load_to(rocked(0.4)), Leg::load_to(rocked(-0.4)), Leg::load_to(base)];
    let Repeats::Walks { by, .. } = block()?.shake(base, &legs)?.repeats else { panic!("walks") };
    assert!((by[0].twist.translation()[0] - 1e-5).abs() < 1e-16);
    Ok(())
}

#[test]
fn as_many_cycles_are_followed_as_are_allowed() -> Result<(), Error> {
    let grasp = block()?.with(&Settings::default().with_most_cycles(1));
    let cycle = [0.4, -0.4].map(|moment| Leg::there_and_back(Wrench::new([0.0, 0.0], moment))).concat();
    let shaken = grasp.shake(Wrench::force([3.5, -10.0]), &cycle)?;
    assert!(matches!(shaken.repeats, Repeats::Undecided { doubt: None }) && shaken.followed == 1, "{shaken}");
    assert!(shaken.to_string().starts_with("UNDECIDED"), "{shaken}");
    Ok(())
}

#[test]
fn where_nothing_holds_at_rest_that_is_told() -> Result<(), Error> {
    let shaken =
        block()?.shake(Wrench::force([6.0, -10.0]), &Leg::there_and_back(Wrench::force([1.0, 0.0])))?;
    assert!(shaken.to_string().contains("even at rest"), "{shaken}");
    assert_eq!((shaken.rests(), shaken.followed), (Some(false), 0));
    Ok(())
}

#[test]
fn a_walk_towards_a_stop_ends_there() -> Result<(), Error> {
    // A stop is 1 mm away. The block reaches it after a hundred cycles of 0.01 mm, and the stop then carries the rest.
    let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(0.5);
    let stop = Contact::new([0.15, 0.0], [-1.0, 0.0]).series_stiffness(1e5, 1e5).command([-1.017_5e-3, 0.0]);
    let block = Grasp::new([foot(-0.1), foot(0.1), stop])?;
    let cycle = [0.4, -0.4].map(|moment| Leg::there_and_back(Wrench::new([0.0, 0.0], moment))).concat();
    let shaken = block.shake(Wrench::force([3.5, -10.0]), &cycle)?;
    assert_eq!(shaken.rests(), Some(true), "{shaken}");
    assert!(
        shaken.cycles > 95 && shaken.followed < 40,
        "{} cycles, {} followed",
        shaken.cycles,
        shaken.followed
    );
    let pressed = shaken.state.expect("holds").contacts[2].normal_force();
    assert!(pressed > 0.0, "{pressed}");
    Ok(())
}
