//! A contact without force that the load does not press is reported as touching, neither as sticking nor as sliding. So the verdict does not depend
//! on rounding.

use grasp_lcp::equilibrium::{ContactAnswer, ContactState};
use grasp_lcp::hold::Holding;
use grasp_lcp::spatial::{Contact, Grasp, Ramp, Wrench};
use grasp_lcp::{Error, planar};
use support::samples::{samples, seeded};
use support::splitmix::Random;

/// A plate under a strap lies on three pins and touches an end pin without force.
fn plate(strap: f64) -> Result<Grasp, Error> {
    let pin = |point: [f64; 3], normal: [f64; 3]| {
        Contact::new(point, normal).series_stiffness(5e7, 5e7).friction(0.2)
    };
    let up = [0.0, 0.0, 1.0];
    let strap = Contact::new([0.0, 0.0, 0.04], [0.0, 0.0, -1.0])
        .series_stiffness(2e7, 2e7)
        .friction(0.2)
        .force(strap);
    Grasp::new([
        pin([-0.08, -0.05, 0.0], up),
        pin([0.08, -0.05, 0.0], up),
        pin([0.0, 0.06, 0.0], up),
        pin([-0.1, 0.0, 0.02], [1.0, 0.0, 0.0]).name("end"),
        strap.name("strap"),
    ])
}

/// All forces, and so the load at first slip, are proportional to the force of the strap. The words do not change.
#[test]
fn an_end_pin_that_nothing_presses_on_is_told_as_touching() -> Result<(), Error> {
    let push = Wrench::force_at([0.0, 0.0, -1500.0], [0.0, 0.0, 0.04]);
    let mut per_newton: Option<f64> = None;
    for strap in (0..=220).map(|k| 1000.0 + 10.0 * f64::from(k)) {
        let verdict = plate(strap)?.hold(Ramp::load(Wrench::ZERO, push))?;
        assert!(matches!(verdict.holding, Holding::Sticks), "{strap}: {verdict}");
        let first = verdict.first_slip.as_ref().expect("slides at last");
        assert_eq!(first.slide.iter().map(ToString::to_string).collect::<Vec<_>>(), ["strap"], "{strap}");
        let factor = first.factor / strap;
        let before = *per_newton.get_or_insert(factor);
        assert!((factor / before - 1.0).abs() < 1e-12, "{strap}: {factor} {before}");
        let state = verdict.state.as_ref().expect("holds");
        assert!(state.contacts[3].state == ContactState::Separated && state.contacts[3].force.norm() == 0.0);
        assert!(state.to_string().contains("end: touches, force (0, 0, 0) N"), "{state}");
    }
    Ok(())
}

/// In the plane, a block between two jaws touches a stop without force.
#[test]
fn a_stop_below_a_block_in_a_vice_is_told_as_touching() -> Result<(), Error> {
    for press in [3.0, 7.0, 11.0, 13.0, 17.1, 23.3] {
        let jaw = |x: f64| {
            planar::Contact::new([x, 0.3], [-x, 0.0])
                .series_stiffness(1e3, 7e2)
                .friction(0.3)
                .pressed_with(press)
        };
        let stop = planar::Contact::new([0.1, -1.0], [0.0, 1.0])
            .series_stiffness(1e3, 1e3)
            .friction(0.2)
            .name("stop");
        let grasp = planar::Grasp::new([jaw(-1.0), jaw(1.0), stop])?;
        // A lifted block leaves the stop; if it is pushed down, the stop carries a part.
        let lifted =
            grasp.hold(planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, 0.1])))?;
        assert!(matches!(lifted.holding, Holding::Sticks), "{lifted}");
        let pushed =
            grasp.hold(planar::Ramp::load(planar::Wrench::ZERO, planar::Wrench::force([0.0, -0.1])))?;
        assert!(pushed.state.as_ref().expect("holds").contacts[2].normal_force() > 0.01, "{pushed}");
        let rest = grasp.solve(planar::Wrench::ZERO)?;
        let rest = rest.equilibrium().expect("holds");
        assert!(rest.contacts[2].state_text() == "touches", "{rest}");
    }
    Ok(())
}

/// Two jaws of unequal stiffness press against each other, and one or two stops touch without force. By hand the jaws alone carry their forces at rest.
#[test]
fn jaws_hold_beside_stops_that_just_touch() -> Result<(), Error> {
    let mut random = seeded(21);
    for _ in 0..samples(300) {
        let stiffness = |random: &mut Random| {
            let mut of = |all: [f64; 3]| all[random.index(0, 2)];
            [of([1e3, 2e4, 1e5]), of([1e3, 8e3, 2e4])]
        };
        let press = [3.0, 5.0, 10.0, 25.0][random.index(0, 3)];
        let mut touching = |point: [f64; 2], normal: [f64; 2]| {
            let [k, kt] = stiffness(&mut random);
            planar::Contact::new(point, normal).series_stiffness(k, kt).friction(0.5)
        };
        let mut contacts =
            [-0.05, 0.05].map(|x: f64| touching([x, 0.04], [-x, 0.0]).pressed_with(press)).to_vec();
        contacts.insert(1, touching([0.02, 0.05], [0.0, -1.0]));
        contacts.push(touching([0.0, -0.05], [0.0, 1.0]));
        let rest = planar::Grasp::new(contacts)?.solve(planar::Wrench::ZERO)?;
        let rest = rest.equilibrium().unwrap_or_else(|| panic!("{rest}"));
        let forces: Vec<f64> = rest.contacts.iter().map(ContactAnswer::normal_force).collect();
        for (force, exact) in forces.iter().zip([press, 0.0, press, 0.0]) {
            assert!((force - exact).abs() < 1e-12 * press, "{forces:?}");
        }
    }
    Ok(())
}
