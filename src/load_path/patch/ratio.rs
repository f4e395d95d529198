//! The ratio test along a straight piece, with lazy pricing: which contacts reach an edge first.

use nalgebra::SVector;

use super::PatchPath;
use super::local::{Bound, Local, size};
use super::queue::{ACROSS, Course};
use crate::contact::ZERO_SLACK;

/// Times are taken a little shorter: rounding of the values, as a part of their terms.
const MARGIN: f64 = 1e-13;
/// A clock that runs this much faster than the path is long: time for another direction.
const TURNED: f64 = 1.4;
/// The path goes on turning as it has since the last time: by this part as much further before the line is made anew.
const AHEAD: f64 = 0.4;
/// The line is not made anew before one step for this many contacts.
const AGAIN: usize = 16;
/// The next step is looked for within so many times the last ones,
const STRIDES: f64 = 4.0;
/// then within so many times that,
const FURTHER: f64 = 8.0;
/// and no nearer than this part of what is left.
const SHORTEST: f64 = 1e-6;
/// A step is known to this part at least; a larger correction says that there is something else wrong with it.
const ROUGHLY: f64 = 1e-6;

/// A condition that a step uses up.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exit {
    pub(super) contact: u32,
    pub(super) bound: Bound,
    pub(super) step: f64,
    pub(super) uncertainty: f64,
}

/// How far it is to the end of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Piece {
    /// To where something reaches an edge.
    ToAnEdge(f64),
    /// Nothing reaches an edge up to there, or nothing clearly before.
    ToTheEnd,
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// How u changes along the direction in which the clock runs.
    fn change_ahead(&self, local: &Local<D, C>) -> SVector<f64, C> {
        local.rate * (self.reference.time / self.pace) - local.seen * self.reference.y
    }

    /// The time in which no condition of a contact can be used up, on the clock of the path.
    pub(super) fn slack(&self, local: &Local<D, C>) -> f64 {
        let u = local.stretch(&self.y, self.tau);
        let margin = MARGIN * local.level(&u, self.y.norm());
        let change = self.change_ahead(local);
        let mut least = f64::INFINITY;
        local.for_each_bound(&self.facets, |_, felt| {
            let fastest = (-felt.dot(&change)).max(ACROSS * local.steepest(felt, self.pace));
            if fastest > 0.0 {
                least = least.min((felt.dot(&u) - margin * size(felt)).max(0.0) / fastest);
            }
        });
        least
    }

    /// Everybody is put in line for the present direction of the path.
    pub(super) fn line_up(&mut self) {
        let heading = Course::new(&self.y_rate, self.pace).direction();
        self.reference = match self.last_heading.replace(heading) {
            Some(last) => heading.beyond(&last, AHEAD).direction(),
            None => heading,
        };
        let mut ahead = std::mem::take(&mut self.ahead);
        ahead.line_up(self.locals.len(), &|i| (self.locals[i].stamp, self.slack(&self.locals[i])));
        self.ahead = ahead;
        self.locals.iter_mut().for_each(|local| local.waits = true);
        (self.gone, self.steps) = (0.0, 0);
        self.looked_at += self.locals.len();
    }

    /// Looks for what reaches an edge first, at most so far from here, and leaves it in `exits`, the tied ones only.
    pub(super) fn first_exits(&mut self, most: f64) -> Piece {
        self.exits.clear();
        self.looked.clear();
        // Mostly the next event is about as far as the last one was.
        let mut far = self.stride.min(most);
        loop {
            self.look_within(far);
            if !self.exits.is_empty() || far >= most {
                break;
            }
            far = (FURTHER * far).max(SHORTEST * most).min(most);
            self.wait_again();
        }
        let first = self.exits.iter().map(|exit| exit.step).fold(f64::INFINITY, f64::min);
        let Some(known) = self.exits.iter().find(|exit| exit.step == first).map(|exit| exit.uncertainty)
        else {
            return Piece::ToTheEnd;
        };
        // Symmetric grasps reach several edges at once: equal up to the rounding of both.
        self.exits.retain(|exit| exit.step - first <= exit.uncertainty + known);
        // What is reached together with the end of the leg, up to rounding, stands there when the next one begins.
        let at_the_end = self.exits.iter().any(|exit| (exit.step - most).abs() <= exit.uncertainty);
        if first >= most || (at_the_end && self.tau + most >= 1.0) {
            Piece::ToTheEnd
        } else {
            Piece::ToAnEdge(first)
        }
    }

    /// Looks at everybody whose time comes within a step so long, or within the first exits if they are nearer.
    fn look_within(&mut self, far: f64) {
        let speed = Course::new(&self.y_rate, self.pace).speed_along(&self.reference);
        let (travel, travel_rate) = (self.y.norm(), self.y_rate.norm());
        let (pace, mut longest) = (self.pace, far);
        while let Some((contact, stamp)) = self.ahead.next_within(longest * speed * (1.0 + MARGIN)) {
            let local = &self.locals[contact as usize];
            if local.stamp != stamp {
                continue;
            }
            self.looked_at += 1;
            let (u, du) = (local.stretch(&self.y, self.tau), local.stretch_rate(&self.y_rate));
            let (level, rate_level) = (local.level(&u, travel), local.rate_level(travel_rate));
            let (change, margin) = (self.change_ahead(local), MARGIN * level);
            let mut slack = f64::INFINITY;
            let exits = &mut self.exits;
            local.for_each_bound(&self.facets, |bound, felt| {
                let (size, value, rate) = (size(felt), felt.dot(&u), felt.dot(&du));
                let noise = ZERO_SLACK * size;
                let fastest = (-felt.dot(&change)).max(ACROSS * local.steepest(felt, pace));
                if fastest > 0.0 {
                    slack = slack.min((value - margin * size).max(0.0) / fastest);
                }
                if rate < -noise * rate_level {
                    let step = value.max(0.0) / -rate;
                    let uncertainty = noise * (level + step * rate_level) / -rate;
                    if step - uncertainty <= longest {
                        longest = longest.min(step + uncertainty);
                        exits.push(Exit { contact, bound, step, uncertainty });
                    }
                }
            });
            if slack > longest * speed * (1.0 + MARGIN) {
                self.ahead.wait(contact, stamp, slack);
            } else {
                self.locals[contact as usize].waits = false;
                self.looked.push(contact);
            }
        }
    }

    /// Goes along the present piece up to a fraction of the leg.
    pub(super) fn go_to(&mut self, tau: f64) {
        let step = tau - self.tau;
        let course = Course::new(&self.y_rate, self.pace);
        self.ahead.clock += step * course.speed_along(&self.reference);
        self.gone += step * course.size();
        self.steps += 1;
        self.stride = (0.5 * self.stride).max(STRIDES * step);
        self.y += self.y_rate * step;
        self.settle_at(tau);
    }

    /// Removes what rounding leaves of balance at a fraction of the leg.
    pub(super) fn settle_at(&mut self, tau: f64) {
        self.tau = tau;
        let left = self.sums.side(tau) - self.sums.stiffness * self.y;
        self.y += self.factors.solve(&left);
    }

    /// A little further or back to where the best known of the exits is: found from afar, it carries the rounding of what the state is here.
    pub(super) fn correct(&mut self, before: f64) {
        let best = self.exits.iter().min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty));
        let Some(exit) = best.copied() else { return };
        let local = &self.locals[exit.contact as usize];
        let (u, du) = (local.stretch(&self.y, self.tau), local.stretch_rate(&self.y_rate));
        let mut more = 0.0;
        local.for_each_bound(&self.facets, |bound, felt| {
            if bound == exit.bound {
                more = felt.dot(&u) / -felt.dot(&du);
            }
        });
        let tau = (self.tau + more).max(before);
        if more.abs() <= ROUGHLY * self.tau && tau < 1.0 && tau != self.tau {
            self.y += self.y_rate * (tau - self.tau);
            self.settle_at(tau);
        }
    }

    /// Those that were looked at wait again; all are put in line anew where the path has turned.
    pub(super) fn requeue(&mut self) {
        if self.ahead.clock > TURNED * self.gone && self.steps * AGAIN > self.locals.len() {
            self.line_up();
        } else {
            self.wait_again();
        }
    }

    /// Those that were looked at wait for their time from here.
    fn wait_again(&mut self) {
        let mut looked = std::mem::take(&mut self.looked);
        for &contact in &looked {
            let local = &mut self.locals[contact as usize];
            local.waits = true;
            let stamp = local.stamp;
            let slack = self.slack(&self.locals[contact as usize]);
            self.ahead.wait(contact, stamp, slack);
        }
        looked.clear();
        self.looked = looked;
    }

    /// What a contact has waited for is of the past.
    pub(super) fn call_back(&mut self, contact: u32) {
        let local = &mut self.locals[contact as usize];
        local.stamp = local.stamp.wrapping_add(1);
        if std::mem::take(&mut local.waits) {
            self.looked.push(contact);
        }
    }
}
