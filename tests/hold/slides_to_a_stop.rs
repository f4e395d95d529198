//! If the object slides to a stop under the load, the verdict reports this.

use grasp_lcp::Error;
use grasp_lcp::hold::{Holding, Verdict, WayOut};
use grasp_lcp::need::Need;
use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};

/// A block of 100 N on two feet, which slides at 50 N, with a stop at the distance `gap`.
fn block(gap: f64) -> Result<Grasp, Error> {
    let foot = |name: &str, x: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e7, 1e7).friction(0.5)
    };
    let stop = Contact::new([0.1, 0.01], [-1.0, 0.0]).name("stop").series_stiffness(1e7, 1e7);
    Grasp::new([foot("left foot", -0.1), foot("right foot", 0.1), stop.clearance(gap)])
}

fn pulled(force: f64) -> Ramp {
    Ramp::load(Wrench::force([0.0, -100.0]), Wrench::force([force, 0.0]))
}

/// Checks that at 50 N of `force` the block slides by 0.1 mm minus the deflection of springs of 2 · 10⁷ N/m under 50 N.
fn slides_to_the_stop(verdict: &Verdict<2>, force: f64) {
    let caught = verdict.caught.first().expect("is caught");
    let moves = caught.moves.as_ref().expect("slides far");
    assert!(
        (force * caught.factor - 50.0).abs() < 1e-9 && (moves.distance - 9.75e-5).abs() < 1e-12,
        "{verdict}"
    );
    assert!(moves.slides && moves.contacts.len() == 1 && moves.contacts[0].label == "stop", "{verdict}");
}

#[test]
fn it_slides_to_the_stop() -> Result<(), Error> {
    let verdict = block(1e-4)?.hold(pulled(80.0))?;
    slides_to_the_stop(&verdict, 80.0);
    let first = verdict.first_slip.as_ref().expect("slides");
    assert!((80.0 * first.factor - 50.0).abs() < 1e-9, "{verdict}");
    assert_eq!(
        first.slide.iter().map(|part| part.label.as_str()).collect::<Vec<_>>(),
        ["left foot", "right foot"]
    );
    assert!(
        verdict.lost.as_ref().is_some_and(|lost| (80.0 * lost.factor - 1050.0).abs() < 1e-6),
        "{verdict}"
    );
    assert_eq!(verdict.holds(), Some(true));
    assert_eq!(verdict.sticks(), Some(false));
    let state = verdict.state.expect("it holds");
    assert!((state.contacts[2].force[0] - 30.0).abs() < 1e-9);
    assert!(verdict.lost.is_none_or(|lost| lost.factor > 1.0 && lost.nothing_near.is_none()));
    Ok(())
}

#[test]
fn a_loss_behind_the_stop_is_told_with_the_way_to_it() -> Result<(), Error> {
    // The block tips over the stop, 10 mm above the floor, at 50 N + 100 N · 0.1 m / 0.01 m.
    let verdict = block(1e-4)?.hold(pulled(2000.0))?;
    slides_to_the_stop(&verdict, 2000.0);
    let lost = verdict.lost.as_ref().expect("tips over");
    assert!((2000.0 * lost.factor - 1050.0).abs() < 1e-6, "{verdict}");
    assert!(matches!(lost.way_out, WayOut::TipsOver { .. }), "{verdict}");
    assert!(matches!(verdict.holding, Holding::Lost));
    Ok(())
}

#[test]
fn a_stop_beyond_small_motions_holds_nothing() -> Result<(), Error> {
    let verdict = block(0.02)?.hold(pulled(80.0))?;
    assert!((80.0 * verdict.held_to - 50.0).abs() < 1e-9, "{verdict}");
    assert!(matches!(&verdict.lost.as_ref().expect("slides").way_out, WayOut::SlidesOut { .. }), "{verdict}");
    let near = verdict.lost.and_then(|lost| lost.nothing_near).expect("a proof");
    assert!(near.translation < 0.02);
    Ok(())
}

/// The largest load is the load that tips the block over its stop, not the 50 N of friction.
#[test]
fn what_a_load_may_be_counts_the_stop() -> Result<(), Error> {
    let (down, pull) = (Wrench::force([0.0, -100.0]), Wrench::force([1.0, 0.0]));
    for (gap, most) in [(1e-4, 1050.0), (0.02, 50.0)] {
        let needed = block(gap)?.need(&Need::load(pull).on_top_of(down).to_hold())?;
        let bound = needed.amount.bound().expect("a bound");
        assert!((bound / most - 1.0).abs() < 1e-9, "{needed}");
    }
    Ok(())
}
