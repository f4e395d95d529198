//! Arbitrary floating-point numbers (non-finite, subnormal, huge) never cause a panic or a wrong answer.
//!
//! A returned equilibrium must have finite numbers and satisfy its conditions, however extreme the question. A grasp that cannot be computed is
//! refused or undecided.

use std::cell::Cell;

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Onset, Ramp};
use nalgebra::SVector;
use proptest::prelude::*;
use support::random::for_all;
use support::samples::assert_met;

const CASES: usize = 500;

/// Moderate numbers, and sometimes any bit pattern of 64 bits.
fn number() -> impl Strategy<Value = f64> {
    let power = |decades: f64| {
        (-decades..decades, any::<bool>())
            .prop_map(|(e, minus)| if minus { -(10_f64.powf(e)) } else { 10_f64.powf(e) })
    };
    let special = vec![0.0, -0.0, f64::MAX, f64::MIN_POSITIVE, 5e-324, f64::INFINITY, f64::NAN];
    prop_oneof![
        150 => -3.0..3.0_f64,
        20 => (-3..4_i32).prop_map(f64::from),
        4 => power(60.0),
        1 => power(300.0),
        1 => prop::num::f64::ANY,
        1 => prop::sample::select(special),
    ]
}

fn positive() -> impl Strategy<Value = f64> {
    number().prop_map(f64::abs)
}

fn any_contact<const C: usize>() -> impl Strategy<Value = Contact<C>> {
    let vector = || prop::collection::vec(number(), C).prop_map(SVector::<f64, C>::from_vec);
    let stiffness = || prop::collection::vec(positive(), C).prop_map(SVector::<f64, C>::from_vec);
    (
        vector(),
        vector(),
        prop::option::weighted(0.2, vector()),
        stiffness(),
        positive(),
        vector(),
        positive(),
        0..8_u8,
    )
        .prop_map(|(point, normal, tangent, k, mu, command, clearance, kind)| {
            let mut contact = Contact::new(point, normal).friction(mu).command(command);
            contact = match kind % 3 {
                0 => contact.series_stiffness_axes(k),
                1 => contact.body_stiffness_axes(k),
                _ => contact.body_stiffness_axes(k).finger_stiffness_axes(k * 3.0),
            };
            if let Some(tangent) = tangent {
                contact = contact.tangent(tangent);
            }
            match kind {
                0..4 => contact,
                4 => contact.kept_closed(),
                5 => contact.bonded(),
                _ => contact.clearance(clearance),
            }
        })
}

/// Asks all questions. Errors are accepted, panics and wrong equilibria are not. Returns the number of equilibria.
fn ask<const D: usize, const C: usize>(
    contacts: Vec<Contact<C>>,
    loads: [SVector<f64, D>; 2],
    change: Vec<SVector<f64, C>>,
) -> Result<usize, TestCaseError> {
    let Ok(grasp) = Grasp::<C>::new(contacts) else { return Ok(0) };
    let [load, direction] = loads.map(|w| Wrench::from_components(w.as_slice()));
    let settings = Settings::default().with_most_states(2000);
    let mut answers = Vec::new();
    if let Ok(outcome) = grasp.with(&settings).solve(load) {
        answers.extend(outcome.equilibrium().cloned());
    }
    answers.extend(grasp.with(&settings).equilibria(load).unwrap_or_default());
    let ramp = Ramp::load(load, direction).with_commands(change);
    for onset in [grasp.with(&settings).onset(&ramp), grasp.with(&settings.on_the_polygon()).onset(&ramp)] {
        match onset {
            Ok(Onset::At(event)) => {
                prop_assert!(event.factor.is_finite() && event.factor >= 0.0, "onset at {}", event.factor);
                answers.push(grasp.state_at_onset(&event).expect("its own event"));
            }
            Ok(Onset::AlreadySliding(equilibrium)) => answers.push(*equilibrium),
            _ => {}
        }
    }
    for e in &answers {
        let parts = grasp.statics().decompose(e);
        let numbers = e.twist.components().iter().chain([&e.stored_energy]);
        let per_contact = e
            .contacts
            .iter()
            .flat_map(|c| c.force.iter().chain(&c.force_world).chain(&c.slip).chain([&c.gap]));
        let shares = parts.equilibrating.iter().chain(&parts.interaction).flat_map(|f| f.iter());
        prop_assert!(numbers.chain(per_contact).chain(shares).all(|x| x.is_finite()), "not finite: {e:?}");
        prop_assert!(e.residuals.worst() <= 1e-10, "residuals {:?}", e.residuals);
    }
    Ok(answers.len())
}

/// Asks about random grasps, and checks that enough of them have an equilibrium.
fn ask_many<const D: usize, const C: usize>() {
    let vector = || prop::collection::vec(number(), C).prop_map(SVector::<f64, C>::from_vec);
    let numbers = || prop::collection::vec(number(), D).prop_map(SVector::<f64, D>::from_vec);
    // Without a load an equilibrium usually exists.
    let load = || prop_oneof![Just(SVector::<f64, D>::zeros()), numbers()];
    let contacts = prop::collection::vec((any_contact::<C>(), vector()), 1..5);
    let (answered, answers) = (Cell::new(0), Cell::new(0));
    for_all(file!(), CASES, &(contacts, [load(), load()]), |(contacts, loads)| {
        let (contacts, change): (Vec<_>, Vec<_>) = contacts.into_iter().unzip();
        let count = ask::<D, C>(contacts, loads, change)?;
        answered.set(answered.get() + usize::from(count > 0));
        answers.set(answers.get() + count);
        Ok(())
    });
    println!("{} grasps answered, {} equilibria", answered.get(), answers.get());
    assert_met(&[(answered.get(), CASES / 8)]);
}

#[test]
fn no_planar_numbers_make_it_panic() {
    ask_many::<3, 2>();
}

#[test]
fn no_spatial_numbers_make_it_panic() {
    ask_many::<6, 3>();
}
