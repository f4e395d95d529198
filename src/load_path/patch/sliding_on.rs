//! Sliding contacts, which usually slide on. Each waits until the direction of the path has changed enough for its slip to come to rest.

use super::balance::Balance;
use super::moving_contact::MovingContact;
use crate::contact::ZERO_SLACK;
use crate::numerics::WaitingLine;
use crate::object::Point;
use crate::prelude::*;

/// The queue of sliding contacts, on the clock of the direction of the path.
#[derive(Debug, Default)]
pub(super) struct SlidingOn {
    line: WaitingLine,
    direction: Point,
    /// Evaluated contacts that slip on, with their stamps and the times for which they wait.
    resting: Vec<(u32, u32, f64)>,
}

impl SlidingOn {
    pub(super) fn clear(&mut self) {
        self.line.clear();
    }

    /// Queues a sliding contact.
    pub(super) fn wait<const C: usize>(&mut self, balance: &Balance<C>, number: u32) {
        let contact = balance.contact(number);
        self.line.wait(number, contact.stamp, balance.slip_margin(contact).1);
    }

    /// Removes from the queue and returns the contacts whose slip would go backwards, except those that `stands` names.
    pub(super) fn come_to_rest<const C: usize>(
        &mut self,
        balance: &mut Balance<C>,
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
            let contact: &MovingContact<C> = balance.contact(number);
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
