//! Events of a soft fingertip agree with the states of its points shortly before and after.

use grasp_lcp::equilibrium::{ContactState, Equilibrium};
use grasp_lcp::load_path::{Leg, PadChange};
use grasp_lcp::planar::{Grasp, Pressure, SoftFingertip, Wrench};
use support::jaws::jaw;
use support::samples::{samples, seeded};

/// States are compared at this distance before and after an event, as a fraction of the leg. Only events without others so near are used.
const BESIDE: f64 = 1e-7;

/// Number of points in a range of contacts that touch, and that slide.
fn count(state: &Equilibrium<2>, range: std::ops::Range<usize>) -> (usize, usize) {
    let points = &state.contacts[range];
    let closed = points.iter().filter(|c| c.state != ContactState::Separated).count();
    (closed, points.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count())
}

#[test]
fn the_first_and_the_last_points_are_told() -> Result<(), grasp_lcp::Error> {
    let mut random = seeded(11);
    let mut seen = std::collections::BTreeMap::new();
    for _ in 0..samples(200) {
        let pad = SoftFingertip::pad(0.02, 2, Pressure::Uniform)?;
        let jaw =
            |x: f64, press: f64, name: &str| jaw::<2>(x, [2e3, 1e3], 0.4).name(name).pressed_with(press);
        let press = random.between(5.0, 15.0);
        let jaws = [pad.contacts(&jaw(-0.03, press, "left"))?, pad.contacts(&jaw(0.03, press, "right"))?];
        let grasp = Grasp::new(jaws.concat())?;
        let mut load = || {
            Wrench::new([random.between(-1.0, 1.0), random.between(-4.0, 4.0)], random.between(-0.12, 0.12))
        };
        let legs = [Leg::load_to(load()), Leg::load_to(load())];
        let mut path = grasp.follow(Wrench::ZERO, &legs)?;
        let events = path.run();
        for (i, event) in events.iter().enumerate() {
            let at =
                |k: usize| events.get(k).filter(|other| other.leg == event.leg).map(|other| other.fraction);
            let apart = |other: Option<f64>| other.is_none_or(|f| (f - event.fraction).abs() > 3.0 * BESIDE);
            let inside = event.fraction > BESIDE && event.fraction < 1.0 - BESIDE;
            if !(inside && apart(at(i + 1)) && apart(i.checked_sub(1).and_then(at))) {
                continue;
            }
            let [before, after] = [-BESIDE, BESIDE].map(|d| path.state_at(event.leg, event.fraction + d));
            let (Some(before), Some(after)) = (before, after) else { continue };
            for pad in &event.state.pads {
                let ((c0, s0), (c1, s1)) = (count(&before, pad.range()), count(&after, pad.range()));
                let told: Vec<_> =
                    event.whole_changes().into_iter().filter(|told| told.contact == pad.contact).collect();
                let tells = |what: PadChange<2>| told.iter().any(|told| told.what == what);
                let context = format!("{c0} {s0} {c1} {s1} {told:?}");
                assert_eq!(
                    tells(PadChange::SlidesEverywhere),
                    c1 > 0 && s1 == c1 && !(s0 == c0 && c0 > 0),
                    "{context}"
                );
                assert_eq!(tells(PadChange::BeginsToSlide), s0 == 0 && s1 > 0 && s1 < c1, "{context}");
                assert_eq!(tells(PadChange::SticksAgain), s0 > 0 && s1 == 0 && c1 > 0, "{context}");
                assert_eq!(tells(PadChange::Opens), c0 > 0 && c1 == 0, "{context}");
                assert_eq!(
                    tells(PadChange::BeginsToOpen),
                    c0 == pad.points && c1 < c0 && c1 > 0,
                    "{context}"
                );
                for told in told {
                    *seen.entry((told.contact.text(), format!("{:?}", told.what))).or_insert(0) += 1;
                }
            }
        }
    }
    for (name, what) in [
        ("left", "BeginsToSlide"),
        ("left", "SlidesEverywhere"),
        ("right", "SticksAgain"),
        ("right", "BeginsToOpen"),
    ] {
        let times = seen.get(&(name.to_owned(), what.to_owned()));
        assert!(times.is_some_and(|times| *times > samples(3)), "{name} {what}");
    }
    Ok(())
}
