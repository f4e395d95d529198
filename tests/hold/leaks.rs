//! A suction cup leaks as soon as its lip opens at one point. In every question a load is therefore held only until the first point of the lip opens.
//!
//! A cup with the vacuum V on a ring of radius R is pulled by F at the arm a. The point on the side of the load opens where `(V - F) R / 2 = F a`.

use grasp_lcp::equilibrium::TooFar;
use grasp_lcp::hold::LossVerb;
use grasp_lcp::need::Need;
use grasp_lcp::spatial::{Contact, Grasp, Leg, SuctionCup, Wrench};
use grasp_lcp::{Error, Settings};

const RADIUS: f64 = 0.03;
const VACUUM: f64 = 170.0;
const ARM: f64 = 0.05;
const OPENS: f64 = VACUUM * RADIUS / (RADIUS + 2.0 * ARM);

fn cup() -> Result<Vec<Contact>, Error> {
    let lip = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).name("cup").series_stiffness(1e6, 5e5).friction(0.6);
    SuctionCup::of_force(RADIUS, 12, VACUUM)?.contacts(&lip)
}

fn pull(force: f64) -> Wrench {
    Wrench::force_at([0.0, 0.0, -force], [ARM, 0.0, 0.0])
}

#[test]
fn a_load_is_held_up_to_the_first_open_point() -> Result<(), Error> {
    let grasp = Grasp::new(cup()?)?;
    for part in [0.99, 1.01, 1.5] {
        let (verdict, leaks) = (grasp.hold(pull(part * OPENS))?, part > 1.0);
        assert_eq!(verdict.holds(), Some(!leaks), "{verdict}");
        assert!((verdict.held_to * part - 1.0).abs() < 1e-9, "{verdict}");
        let lost = verdict.lost.as_ref().expect("air flows in");
        assert!(matches!(&lost.too_far, Some(TooFar::Leaks { cup }) if cup.points >= 1), "{verdict}");
        assert_eq!(verdict.to_string().starts_with("LEAKS at 39.2307 N of "), leaks, "{verdict}");
        assert_eq!(
            verdict.to_string().contains(" until cup leaks, as cup (1 of 12 points) opens"),
            !leaks,
            "{verdict}"
        );
        let row = |_: usize, contacts: &mut Vec<Contact>| {
            contacts.extend(cup().expect("a lip"));
            [Wrench::ZERO, pull(part * OPENS)]
        };
        let brief = Grasp::hold_batch(1, &row, &Settings::default()).remove(0)?;
        assert_eq!((brief.holds(), brief.motion == Some(LossVerb::Leaks)), (Some(!leaks), true));
    }
    Ok(())
}

/// A load path continues beyond the opening of the lip, and reports from which load on the vacuum does not last.
#[test]
fn a_path_and_an_equilibrium_say_so() -> Result<(), Error> {
    let grasp = Grasp::new(cup()?)?;
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(pull(1.25 * OPENS))])?;
    path.run();
    let end = path.end_of_small_motions().expect("air flows in");
    assert!((end.fraction - 0.8).abs() < 1e-9 && path.place() == (0, 1.0), "{end:?}");
    for (part, leaks) in [(0.99, false), (1.01, true)] {
        let outcome = grasp.solve(pull(part * OPENS))?;
        let state = outcome.equilibrium().expect("with the vacuum kept");
        assert_eq!(matches!(state.too_far, Some(TooFar::Leaks { .. })), leaks);
    }
    Ok(())
}

#[test]
fn the_load_and_the_vacuum_it_needs() -> Result<(), Error> {
    let grasp = Grasp::new(cup()?)?;
    let most = grasp.need(&Need::load(pull(1.0)))?;
    assert!((most.amount.bound().expect("a bound") / OPENS - 1.0).abs() < 1e-6, "{most}");
    let least = grasp.need(&Need::squeeze(pull(0.5 * OPENS)))?;
    assert!((least.amount.bound().expect("a bound") / 0.5 - 1.0).abs() < 1e-6, "{least}");
    Ok(())
}
