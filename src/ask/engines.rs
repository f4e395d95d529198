//! Makes engines: for the plane and for space, for contacts, hands and several bodies.

use alloc::sync::Arc;
use core::any::Any;

use super::questions::Questions;
use crate::error::Error;
use crate::grasp::{Bodies, Contact, Engine, Finger, Hand};
use crate::prelude::*;

type Made<const C: usize> = Result<Arc<dyn Questions<C>>, Error>;

/// The engine of a grasp without joints; contacts that are held by a force get slides.
pub(super) fn of_contacts<const C: usize>(contacts: Vec<Contact<C>>) -> Made<C> {
    if contacts.iter().any(|contact| contact.force.is_some()) {
        return of_hand(Hand::new(contacts.into_iter().map(Finger::fixed)));
    }
    in_the_plane_or_in_space(contacts, planar, spatial)
}

/// The engine of a grasp by a hand.
pub(super) fn of_hand<const C: usize>(hand: Hand<C>) -> Made<C> {
    in_the_plane_or_in_space(hand, planar_hand, spatial_hand)
}

/// The engine of several bodies.
pub(super) fn of_bodies<const C: usize>(bodies: Bodies<C>) -> Made<C> {
    in_the_plane_or_in_space(bodies, planar_bodies, spatial_bodies)
}

// None of the six functions has a parameter. If one had, every program with an optimised build would compile it again, with the engine behind it.

fn planar(contacts: Vec<Contact<2>>) -> Made<2> {
    Ok(Arc::new(Engine::<2>::new(contacts)?))
}

fn spatial(contacts: Vec<Contact<3>>) -> Made<3> {
    Ok(Arc::new(Engine::<3>::new(contacts)?))
}

fn planar_hand(hand: Hand<2>) -> Made<2> {
    Ok(Arc::new(hand.engine(None)?))
}

fn spatial_hand(hand: Hand<3>) -> Made<3> {
    Ok(Arc::new(hand.engine(None)?))
}

fn planar_bodies(bodies: Bodies<2>) -> Made<2> {
    let (hand, bodies) = bodies.checked()?;
    Ok(Arc::new(hand.engine(Some(bodies))?))
}

fn spatial_bodies(bodies: Bodies<3>) -> Made<3> {
    let (hand, bodies) = bodies.checked()?;
    Ok(Arc::new(hand.engine(Some(bodies))?))
}

/// Calls the function for the plane or the one for space, for callers that know the number of axes only as a parameter of a type. So engines are
/// compiled here alone, and not again in every function with that parameter.
fn in_the_plane_or_in_space<T: Any, R: Any, T2: Any, R2: Any, T3: Any, R3: Any>(
    given: T,
    planar: fn(T2) -> R2,
    spatial: fn(T3) -> R3,
) -> R {
    let mut given = Some(given);
    let given = &mut given as &mut dyn Any;
    let mut made: Option<R> = None;
    if let Some(given) = given.downcast_mut::<Option<T2>>().and_then(Option::take) {
        if let Some(made) = (&mut made as &mut dyn Any).downcast_mut::<Option<R2>>() {
            *made = Some(planar(given));
        }
    } else if let Some(given) = given.downcast_mut::<Option<T3>>().and_then(Option::take)
        && let Some(made) = (&mut made as &mut dyn Any).downcast_mut::<Option<R3>>()
    {
        *made = Some(spatial(given));
    }
    made.expect("a contact has two axes in the plane and three in space")
}
