//! Answers do not depend on the order of bodies, on which of them is the object, on which side of a contact is named first, or on the place of the
//! origin.

use grasp_lcp::equilibrium::{Equilibrium, Outcome};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::planar::{Bodies, Body, Contact, Grasp};
use nalgebra::{SVector, Vector2, Vector3};
use proptest::prelude::*;

use support::samples::config;
use support::stacks::{Stack, Touch, grasp, name, stack};

fn state<const C: usize>(outcome: Outcome<C>) -> Option<Equilibrium<C>> {
    if let Outcome::Equilibrium(state) = outcome { Some(*state) } else { None }
}

fn close<const C: usize>(a: &SVector<f64, C>, b: &SVector<f64, C>, size: f64) -> bool {
    (a - b).norm() <= 1e-11 * size
}

/// Checks that both have the same forces at each contact and the same motion of each body.
fn agree<const C: usize>(a: &Equilibrium<C>, b: &Equilibrium<C>) -> Result<(), TestCaseError> {
    let size = a.contacts.iter().fold(0.0_f64, |most, told| most.max(told.force.norm()));
    for (a, b) in a.contacts.iter().zip(&b.contacts) {
        prop_assert!(close(&a.force_world, &b.force_world, size), "{a} or {b}");
    }
    Ok(())
}

/// The stack with the two sides of every contact exchanged: opposite normal, and both bodies swapped.
fn from_the_other_side(stack: &Stack<3, 2>) -> Stack<3, 2> {
    let turned = |touch: &Touch<2>| match touch.against {
        None => touch.clone(),
        Some(against) => {
            let mut datum = touch.datum;
            datum.normal = -datum.normal;
            Touch { datum, on: against, against: Some(touch.on) }
        }
    };
    Stack { touches: stack.touches.iter().map(turned).collect(), loads: stack.loads.clone() }
}

proptest! {
    #![proptest_config(config(20))]

    /// A load on the object gives the same answer as the same load among the loads of the bodies, whichever body is the object.
    #[test]
    fn which_body_is_the_object(stack in stack::<3, 2>(3), push in -1.0..1.0f64) {
        let load = Wrench::<2>::from_components(&[push, 0.0, 0.0]);
        let asked = state(stack.grasp(1).solve(load).expect("well posed"));
        let mut with_load = stack.clone();
        with_load.loads[1][0] += push;
        for body in 0..3 {
            let told = state(with_load.grasp(body).solve(Wrench::ZERO).expect("well posed"));
            prop_assert_eq!(asked.is_some(), told.is_some());
            if let (Some(asked), Some(told)) = (&asked, &told) {
                agree(asked, told)?;
                for (a, b) in asked.bodies.iter().zip(&told.bodies) {
                    prop_assert_eq!(&a.body, &b.body);
                    let (a, b) = (a.twist.to_vector(), b.twist.to_vector());
                    // With a free motion of sliding bodies, several equilibria may have the same forces.
                    prop_assert!(!asked.free_motions.is_empty() || (a - b).norm() <= 1e-10 * (1e-6 + a.norm()));
                }
            }
        }
    }

    #[test]
    fn which_side_is_named_first(stack in stack::<3, 2>(3)) {
        let told = state(stack.grasp(0).solve(Wrench::ZERO).expect("well posed"));
        let turned = state(from_the_other_side(&stack).grasp(0).solve(Wrench::ZERO).expect("well posed"));
        prop_assert_eq!(told.is_some(), turned.is_some());
        if let (Some(told), Some(turned)) = (told, turned) {
            let size = told.contacts.iter().fold(0.0_f64, |most, told| most.max(told.force.norm()));
            for ((a, b), touch) in told.contacts.iter().zip(&turned.contacts).zip(&stack.touches) {
                let sign = if touch.against.is_some() { -1.0 } else { 1.0 };
                prop_assert!(close(&a.force_world, &(b.force_world * sign), size), "{a} or {b}");
            }
        }
    }

    /// A system of a single body has the answers of an ordinary grasp.
    #[test]
    fn one_body(stack in stack::<3, 2>(1), push in -2.0..2.0f64) {
        let contacts = stack.touches.iter().map(|touch| touch.datum.contact());
        let own = stack.loads[0];
        let load = Wrench::<2>::from_components((own + Vector3::new(push, 0.0, 0.0)).as_slice());
        let alone = Grasp::new(contacts).expect("well posed").solve(load).expect("well posed");
        let among = stack.grasp(0).solve(Wrench::<2>::force([push, 0.0])).expect("well posed");
        let (alone, among) = (state(alone), state(among));
        prop_assert_eq!(alone.is_some(), among.is_some());
        if let (Some(alone), Some(among)) = (alone, among) {
            agree(&alone, &among)?;
        }
    }
}

/// Far from the origin only the last digits change, because the points themselves are rounded.
#[test]
fn far_away() {
    let pile = |at: Vector2<f64>| {
        let face = |y: f64, on: usize, against: Option<usize>| {
            [-0.5, 0.5].map(|x| {
                let contact = Contact::new(at + Vector2::new(x, y), [0.0, 1.0]).series_stiffness(1e4, 8e3);
                let contact = contact.friction(0.5).on(name(on));
                against.map_or(contact.clone(), |body| contact.against(name(body)))
            })
        };
        let body = |k: usize| {
            let weight =
                grasp_lcp::planar::Wrench::force_at([0.0, -10.0], at + Vector2::new(0.0, k as f64 + 0.5));
            Body::new(name(k)).load(weight)
        };
        let bodies =
            Bodies::new([body(0), body(1)]).contacts(face(0.0, 0, None)).contacts(face(1.0, 1, Some(0)));
        let push = grasp_lcp::planar::Wrench::force_at([4.0, 0.0], at + Vector2::new(0.0, 1.2));
        grasp(bodies.loaded(name(1))).hold(push).expect("well posed").lost.expect("slides or tips").factor
    };
    let (near, far) = (pile(Vector2::zeros()), pile(Vector2::new(1e6, -3e6)));
    assert!((near - 1.25).abs() < 1e-12, "{near}");
    assert!((far - near).abs() < 1e-8, "{far} and {near}");
}
