//! The bounds ahead of the path: which contacts reach one first on a straight piece, with lazy
//! pricing.

use super::active_set::Bound;
use super::balance::Balance;
use super::moving_contact::size;
use crate::contact::ZERO_SLACK;
use crate::object::{LazyPricing, Point};
use crate::prelude::*;

/// Relative extension of times, so that rounding of the clock does not hide a contact.
const LONGER: f64 = 1e-13;
/// Extrapolated turn of the path, relative to its turn since contacts were last queued: the new queue is made for that direction.
const AHEAD: f64 = 0.4;
/// Range of the first search for the next event, as a multiple of the last steps. With less, it often misses the event; with more, contacts are
/// evaluated in vain.
const STRIDES: f64 = 4.0;
/// Factor by which later searches extend the range.
const FURTHER: f64 = 8.0;
/// Least range of a later search, as a part of the rest, whatever the last steps were.
const SHORTEST: f64 = 1e-6;
/// Largest relative correction of a step; a larger one means that something else is wrong.
const ROUGHLY: f64 = 1e-6;

/// A bound that a step reaches.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundReached {
    pub(super) contact: u32,
    pub(super) bound: Bound,
    step: f64,
    uncertainty: f64,
}

/// Length of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PieceLength {
    /// Up to where a contact reaches an edge.
    ToAnEdge(f64),
    /// Up to the end: no contact reaches an edge before it, or not clearly before.
    ToTheEnd,
}

/// The queue of contacts by their bounds, and the first exits.
#[derive(Debug)]
pub(super) struct BoundsAhead {
    pricing: LazyPricing,
    /// The direction of the path when all contacts were last queued.
    last_course: Option<Point>,
    /// Approximate distance of the next event.
    stride: f64,
    pub(super) exits: Vec<BoundReached>,
}

impl BoundsAhead {
    pub(super) fn new() -> Self {
        Self { pricing: LazyPricing::default(), last_course: None, stride: 1.0, exits: Vec::new() }
    }

    /// Queues all contacts at the start of a leg.
    pub(super) fn set_out<const C: usize>(&mut self, balance: &mut Balance<C>) {
        self.last_course = None;
        self.line_up(balance);
    }

    /// Queues all contacts for the present direction of the path.
    fn line_up<const C: usize>(&mut self, balance: &mut Balance<C>) {
        let course = balance.course().direction();
        let towards = match self.last_course.replace(course.clone()) {
            Some(last) => course.plus(AHEAD, &course.plus(-1.0, &last)),
            None => course,
        };
        self.pricing.line_up(balance.contacts.len(), &towards, &|contact, e| {
            let contact = balance.contact(contact);
            (contact.stamp, balance.slack(contact, e))
        });
        balance.contacts.iter_mut().for_each(|contact| contact.waits = true);
        balance.looked_at += balance.contacts.len();
    }

    /// Finds the contacts that reach an edge first, at most `most` ahead, and leaves the tied exits in `exits`.
    pub(super) fn first_exits<const C: usize>(&mut self, balance: &mut Balance<C>, most: f64) -> PieceLength {
        self.exits.clear();
        self.pricing.looked.clear();
        // The next event is usually about as far as the last one was.
        let mut far = self.stride.min(most);
        loop {
            self.look_within(balance, far);
            if !self.exits.is_empty() || far >= most {
                break;
            }
            far = (FURTHER * far).max(SHORTEST * most).min(most);
            self.wait_again(balance);
        }
        let Some(first) = self.exits.iter().copied().min_by(|a, b| a.step.total_cmp(&b.step)) else {
            return PieceLength::ToTheEnd;
        };
        // Symmetric grasps reach several edges at once: steps equal up to the rounding of both count as tied.
        self.exits.retain(|exit| exit.step - first.step <= exit.uncertainty + first.uncertainty);
        // Edges reached together with the end of the leg, up to rounding, are in the active sets when the next leg begins.
        let at_the_end = self.exits.iter().any(|exit| (exit.step - most).abs() <= exit.uncertainty);
        if first.step >= most || (at_the_end && balance.tau + most >= 1.0) {
            PieceLength::ToTheEnd
        } else {
            PieceLength::ToAnEdge(first.step)
        }
    }

    /// Evaluates all contacts whose time comes within a step of length `far`, or within the first exits if they are nearer.
    fn look_within<const C: usize>(&mut self, balance: &mut Balance<C>, far: f64) {
        let speed = self.pricing.speed(&balance.course());
        let (travel, mut longest) = (balance.y.norm(), far);
        let within = |longest: f64| longest * speed * (1.0 + LONGER);
        while let Some((number, stamp)) = self.pricing.line.next_within(within(longest)) {
            if balance.contact(number).stamp != stamp {
                continue;
            }
            balance.looked_at += 1;
            let contact = balance.contact(number);
            let slack = balance.slack(contact, &self.pricing.towards);
            if self.pricing.puts_off(within(longest), number, stamp, slack) {
                continue;
            }
            let (u, du) = (balance.stretch(contact), balance.stretch_rate(contact));
            let (level, rate_level) = (contact.level(&u, travel), balance.rate_level(contact));
            let exits = &mut self.exits;
            contact.for_each_bound(balance.facets(contact), |bound, felt| {
                let (noise, rate) = (ZERO_SLACK * size(felt), felt.dot(&du));
                if rate < -noise * rate_level {
                    let step = felt.dot(&u).max(0.0) / -rate;
                    let uncertainty = noise * (level + step * rate_level) / -rate;
                    if step - uncertainty <= longest {
                        longest = longest.min(step + uncertainty);
                        exits.push(BoundReached { contact: number, bound, step, uncertainty });
                    }
                }
            });
            balance.contacts[number as usize].waits = false;
        }
    }

    /// Goes along the present piece up to a fraction of the leg.
    pub(super) fn go_to<const C: usize>(&mut self, balance: &mut Balance<C>, tau: f64) {
        let step = tau - balance.tau;
        self.pricing.advance(step, &balance.course());
        self.stride = (0.5 * self.stride).max(STRIDES * step);
        balance.go_to(tau);
    }

    /// Moves slightly to the best known of the exits: found from afar, it carries the rounding of the present state.
    pub(super) fn correct<const C: usize>(&self, balance: &mut Balance<C>, before: f64) {
        let best = self.exits.iter().min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty));
        let Some(exit) = best else { return };
        let contact = balance.contact(exit.contact);
        let (u, du) = (balance.stretch(contact), balance.stretch_rate(contact));
        let mut more = 0.0;
        contact.for_each_bound(balance.facets(contact), |bound, felt| {
            if bound == exit.bound {
                more = felt.dot(&u) / -felt.dot(&du);
            }
        });
        let tau = (balance.tau + more).max(before);
        if more.abs() <= ROUGHLY * balance.tau && tau < 1.0 && tau != balance.tau {
            balance.go_to(tau);
        }
    }

    /// Queues the evaluated contacts again, or all contacts where the path has turned.
    pub(super) fn requeue<const C: usize>(&mut self, balance: &mut Balance<C>) {
        if self.pricing.has_turned() {
            self.line_up(balance);
        } else {
            self.wait_again(balance);
        }
    }

    /// Queues the evaluated contacts again, with their time from here.
    fn wait_again<const C: usize>(&mut self, balance: &mut Balance<C>) {
        while let Some(number) = self.pricing.looked.pop() {
            balance.contacts[number as usize].waits = true;
            let contact = balance.contact(number);
            let slack = balance.slack(contact, &self.pricing.towards);
            self.pricing.line.wait(number, contact.stamp, slack);
        }
    }

    /// The numbers of the contacts evaluated in the present step.
    pub(super) fn looked(&self) -> &[u32] {
        &self.pricing.looked
    }

    /// Invalidates the queue entries of a contact.
    pub(super) fn call_back<const C: usize>(&mut self, balance: &mut Balance<C>, contact: u32) {
        let moved = &mut balance.contacts[contact as usize];
        moved.stamp = moved.stamp.wrapping_add(1);
        if core::mem::take(&mut moved.waits) {
            self.pricing.looked.push(contact);
        }
    }
}
