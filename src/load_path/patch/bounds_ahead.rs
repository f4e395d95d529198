//! The bounds ahead of the path: which contacts reach one first on a straight piece, with lazy
//! pricing.

use super::active_set::Bound;
use super::balance::Balance;
use super::moving_contact::size;
use crate::contact::ZERO_SLACK;
use crate::numerics::Size;
use crate::object::{LazyPricing, Point};
use crate::prelude::*;

/// Times are taken longer by this part, so that rounding of the clock does not hide a contact.
const LONGER: f64 = 1e-13;
/// The path goes on turning as it has since the last time: by this part as much further before the
/// line is made anew.
const AHEAD: f64 = 0.4;
/// The next event is looked for within so many times the last steps. With less, the first look too
/// often misses it; with more, contacts are looked at for nothing.
const STRIDES: f64 = 4.0;
/// Then it is looked for within so many times that.
const FURTHER: f64 = 8.0;
/// A look goes no less far than this part of what is left, whatever the last steps were.
const SHORTEST: f64 = 1e-6;
/// A step is known to this part at least; a larger correction says that there is something else
/// wrong with it.
const ROUGHLY: f64 = 1e-6;

/// A bound that a step uses up.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundReached {
    pub(super) contact: u32,
    pub(super) bound: Bound,
    step: f64,
    uncertainty: f64,
}

/// How far it is to the end of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PieceLength {
    /// To where something reaches an edge.
    ToAnEdge(f64),
    /// Nothing reaches an edge up to there, or nothing clearly before.
    ToTheEnd,
}

/// The contacts in line for their bounds, and those that come first.
#[derive(Debug)]
pub(super) struct BoundsAhead<D: Size> {
    pricing: LazyPricing<D>,
    /// The direction of the path when all contacts were put in line.
    last_course: Option<Point<D>>,
    /// About how far it is to the next event.
    stride: f64,
    pub(super) exits: Vec<BoundReached>,
}

impl<D: Size> BoundsAhead<D> {
    pub(super) fn new() -> Self {
        Self { pricing: LazyPricing::default(), last_course: None, stride: 1.0, exits: Vec::new() }
    }

    /// Everybody is put in line for a path that sets out.
    pub(super) fn set_out<const C: usize>(&mut self, balance: &mut Balance<D, C>) {
        self.last_course = None;
        self.line_up(balance);
    }

    /// Everybody is put in line for the present direction of the path.
    fn line_up<const C: usize>(&mut self, balance: &mut Balance<D, C>) {
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

    /// Looks for what reaches an edge first, at most so far from here, and leaves it in `exits`,
    /// the tied ones only.
    pub(super) fn first_exits<const C: usize>(
        &mut self,
        balance: &mut Balance<D, C>,
        most: f64,
    ) -> PieceLength {
        self.exits.clear();
        self.pricing.looked.clear();
        // Mostly the next event is about as far as the last one was.
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
        // Symmetric grasps reach several edges at once: equal up to the rounding of both.
        self.exits.retain(|exit| exit.step - first.step <= exit.uncertainty + first.uncertainty);
        // What is reached together with the end of the leg, up to rounding, stands there when the
        // next begins.
        let at_the_end = self.exits.iter().any(|exit| (exit.step - most).abs() <= exit.uncertainty);
        if first.step >= most || (at_the_end && balance.tau + most >= 1.0) {
            PieceLength::ToTheEnd
        } else {
            PieceLength::ToAnEdge(first.step)
        }
    }

    /// Looks at everybody whose time comes within a step so long, or within the first exits if they
    /// are nearer.
    fn look_within<const C: usize>(&mut self, balance: &mut Balance<D, C>, far: f64) {
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
    pub(super) fn go_to<const C: usize>(&mut self, balance: &mut Balance<D, C>, tau: f64) {
        let step = tau - balance.tau;
        self.pricing.advance(step, &balance.course());
        self.stride = (0.5 * self.stride).max(STRIDES * step);
        balance.go_to(tau);
    }

    /// A little further or back to where the best known of the exits is: found from afar, it
    /// carries the rounding of what the state is here.
    pub(super) fn correct<const C: usize>(&self, balance: &mut Balance<D, C>, before: f64) {
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

    /// Those that were looked at wait again; all are put in line anew where the path has turned.
    pub(super) fn requeue<const C: usize>(&mut self, balance: &mut Balance<D, C>) {
        if self.pricing.has_turned() {
            self.line_up(balance);
        } else {
            self.wait_again(balance);
        }
    }

    /// Those that were looked at wait for their time from here.
    fn wait_again<const C: usize>(&mut self, balance: &mut Balance<D, C>) {
        while let Some(number) = self.pricing.looked.pop() {
            balance.contacts[number as usize].waits = true;
            let contact = balance.contact(number);
            let slack = balance.slack(contact, &self.pricing.towards);
            self.pricing.line.wait(number, contact.stamp, slack);
        }
    }

    /// The numbers of the contacts that the present step has looked at.
    pub(super) fn looked(&self) -> &[u32] {
        &self.pricing.looked
    }

    /// What a contact has waited for is of the past.
    pub(super) fn call_back<const C: usize>(&mut self, balance: &mut Balance<D, C>, contact: u32) {
        let moved = &mut balance.contacts[contact as usize];
        moved.stamp = moved.stamp.wrapping_add(1);
        if core::mem::take(&mut moved.waits) {
            self.pricing.looked.push(contact);
        }
    }
}
