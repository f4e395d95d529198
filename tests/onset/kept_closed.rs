//! A contact that is kept closed never opens. If it would have to pull and may not, the answer reports this. A guide that may pull continues to act.

use grasp_lcp::load_path::{Departure, Onset};
use grasp_lcp::planar::{Contact, Grasp, Wrench};
use grasp_lcp::spatial;
use support::jaws;
use support::samples::{assert_met, samples, seeded};

type Tested = Result<(), grasp_lcp::Error>;

/// Two jaws with equal springs press with 5 N each. A force of 10 N along x reduces the left normal force to zero.
fn jaw(x: f64, name: &str) -> Contact {
    jaws::jaw::<2>(x, [1e3, 8e2], 0.5).name(name).pressed_with(5.0)
}

#[test]
fn with_friction_it_would_have_to_pull() -> Tested {
    let grasp = Grasp::new([jaw(-0.05, "left").kept_closed(), jaw(0.05, "right").kept_closed()])?;
    let push = Wrench::force([1.0, 0.0]);
    let Onset::At(event) = grasp.onset(push)? else { panic!("ends at 10 N") };
    assert!((event.factor - 10.0).abs() < 1e-13, "{}", event.factor);
    let [left] = &event.leaving[..] else { panic!("only left") };
    assert_eq!((left.contact.text().as_str(), left.how), ("left", Departure::WouldPull));
    let verdict = grasp.hold(push * 5.0)?;
    assert_eq!(verdict.sticks(), Some(true), "{verdict}");
    let first = verdict.first_slip.as_ref().expect("further on");
    assert_eq!(first.would_pull.iter().map(|part| part.label.as_str()).collect::<Vec<_>>(), ["left"]);
    assert!(verdict.lost.as_ref().is_some_and(|lost| (lost.factor - 2.0).abs() < 1e-13), "{verdict}");
    // The same left jaw without `kept_closed` opens.
    let loose = Grasp::new([jaw(-0.05, "left"), jaw(0.05, "right")])?;
    let Onset::At(event) = loose.onset(push)? else { panic!("opens at 10 N") };
    assert_eq!(event.leaving[0].how, Departure::Opens);
    Ok(())
}

#[test]
fn on_the_round_cone_too() -> Tested {
    let jaw = |x: f64, name: &str| {
        let contact =
            spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).name(name).series_stiffness(1e3, 8e2);
        contact.friction(0.5).pressed_with(5.0).kept_closed()
    };
    let grasp = spatial::Grasp::new([jaw(-0.05, "left"), jaw(0.05, "right")])?;
    let Onset::At(event) = grasp.onset(spatial::Wrench::force([1.0, 0.0, 0.0]))? else {
        panic!("ends at 10 N")
    };
    assert!((event.factor - 10.0).abs() < 1e-13);
    assert_eq!(event.leaving[0].how, Departure::WouldPull);
    Ok(())
}

/// The spring of a frictionless guide pushes and pulls, for every load.
#[test]
fn a_guide_without_friction_pulls() -> Tested {
    let guide = jaw(-0.05, "guide").friction(0.0).kept_closed();
    let grasp = Grasp::new([guide, jaw(0.05, "right").friction(0.0).kept_closed()])?;
    let push = Wrench::force([1.0, 0.0]);
    assert!(matches!(grasp.onset(push)?, Onset::Never));
    let outcome = grasp.solve(push * 20.0)?;
    let forces: Vec<_> =
        outcome.equilibrium().expect("held").contacts.iter().map(|contact| contact.force[0]).collect();
    assert!((forces[0] + 5.0).abs() < 1e-12 && (forces[1] - 15.0).abs() < 1e-12, "{forces:?}");
    Ok(())
}

/// A guide without normal forces does not resist a force along itself. The object slides, and the answer does not say that the guide would open.
#[test]
fn a_guide_without_load_is_not_told_to_open() -> Tested {
    let guide = Contact::new([0.0, 0.0], [1.0, 0.0]).name("guide").series_stiffness(1e6, 5e5).kept_closed();
    let rock =
        Contact::new([0.03, -0.007], [-1.0, 0.0]).name("rock").series_stiffness(1e6, 5e5).friction(0.2);
    let Onset::At(event) = Grasp::new([guide, rock])?.onset(Wrench::force([0.0, -1.0]))? else {
        panic!("at once")
    };
    let names: Vec<_> = event.leaving.iter().map(|leaving| leaving.contact.text()).collect();
    assert_eq!((event.factor, names), (0.0, vec!["rock".to_owned()]));
    Ok(())
}

#[test]
fn none_of_many_opens() -> Tested {
    let mut random = seeded(42);
    let (mut told, mut pulls) = (0, 0);
    for _ in 0..samples(3000) {
        let contacts: Vec<_> = (0..4)
            .map(|i| {
                let angle = random.between(0.0, std::f64::consts::TAU);
                let point = [angle.cos() * 0.05, angle.sin() * 0.05];
                let lean = angle + random.between(-0.5, 0.5);
                let mu = if random.between(0.0, 1.0) < 0.4 { 0.0 } else { random.between(0.1, 0.9) };
                let press = if random.between(0.0, 1.0) < 0.3 { 0.0 } else { random.between(1.0, 9.0) };
                let contact = Contact::new(point, [-lean.cos(), -lean.sin()]).series_stiffness(1e3, 8e2);
                let contact = contact.friction(mu).pressed_with(press);
                if i < 2 { contact.kept_closed() } else { contact }
            })
            .collect();
        let load = Wrench::force_at(
            [random.between(-1.0, 1.0), random.between(-1.0, 1.0)],
            [random.between(-0.05, 0.05), 0.0],
        );
        let Onset::At(event) = Grasp::new(contacts)?.onset(load)? else { continue };
        for leaving in &event.leaving {
            let is_kept = leaving.contact.index < 2;
            assert!(!(is_kept && leaving.how == Departure::Opens), "{event}");
            assert!(is_kept || leaving.how != Departure::WouldPull, "{event}");
            pulls += usize::from(leaving.how == Departure::WouldPull);
        }
        told += 1;
    }
    assert_met(&[(told, 500), (pulls, 20)]);
    Ok(())
}
