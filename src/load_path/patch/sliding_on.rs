//! Contacts that slide, and as a rule slide on. Each waits until the direction of the path has
//! changed by so much that its slip may have come to rest.

use super::balance::Balance;
use super::moving_contact::MovingContact;
use crate::contact::ZERO_SLACK;
use crate::numerics::{Size, WaitingLine};
use crate::object::Point;
use crate::prelude::*;

/// The contacts that slide on, on the clock of the direction of the path.
#[derive(Debug, Default)]
pub(super) struct SlidingOn<D: Size> {
    line: WaitingLine,
    direction: Point<D>,
    /// Contacts that were looked at and slip on, with their stamps and the time for which they
    /// wait.
    resting: Vec<(u32, u32, f64)>,
}

impl<D: Size> SlidingOn<D> {
    pub(super) fn clear(&mut self) {
        self.line.clear();
    }

    /// A contact slides, and waits.
    pub(super) fn wait<const C: usize>(&mut self, balance: &Balance<D, C>, number: u32) {
        let contact = balance.contact(number);
        self.line.wait(number, contact.stamp, balance.slip_margin(contact).1);
    }

    /// The contacts whose slip would go backwards, but for those that `stands` names. They leave
    /// the line.
    pub(super) fn come_to_rest<const C: usize>(
        &mut self,
        balance: &mut Balance<D, C>,
        stands: impl Fn(u32) -> bool,
    ) -> Vec<u32> {
        let direction = balance.course().direction();
        self.line.clock += direction.plus(-1.0, &self.direction).size();
        self.direction = direction;
        self.resting.clear();
        let mut at_rest = Vec::new();
        while let Some((number, stamp)) = self.line.next_within(0.0) {
            if balance.contact(number).stamp != stamp || stands(number) {
                continue;
            }
            balance.looked_at += 1;
            let contact: &MovingContact<D, C> = balance.contact(number);
            let (least, slack) = balance.slip_margin(contact);
            if least >= -ZERO_SLACK * balance.rate_level(contact) {
                self.resting.push((number, stamp, slack));
            } else {
                at_rest.push(number);
            }
        }
        for &(number, stamp, slack) in &self.resting {
            self.line.wait(number, stamp, slack);
        }
        at_rest
    }
}
