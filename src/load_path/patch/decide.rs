//! What comes next at an event, decided among the contacts that stand on an edge.
//!
//! In rates each of them answers a motion of the object by a law of its own: on an edge of the cone it slides along or leaves
//! inwards, at the apex it has its whole law again. Everything else goes on as it is. Each state of those that
//! stand on an edge gives T and with it the rate of the motion, which must be one that they answer by these states: Newton's
//! method on the rates, which starts from the guess that mostly holds and is then the whole work, one solve.
//!
//! What slides elsewhere stands on an edge, too, but as a rule slides on. It waits in a line of its own until the direction of
//! the path has changed by so much that its slip may have come to rest, and joins those that stand when it has.

use super::PatchPath;
use super::event::PatchEvent;
use super::local::Local;
use super::queue::Course;
use super::standing::Stand;
use crate::contact::ZERO_SLACK;
use crate::contact::{Mode, PolygonState, State};
use crate::load_path::event::{Change, PathEnd};
use crate::load_path::transition::change;
use nalgebra::SVector;

/// A motion that is shorter by less than this part is none that is shorter: it is the same up to rounding.
const LESS: f64 = 1e-9;
/// Newton's method takes a few steps or goes round in circles.
const STEPS: usize = 24;
/// Rounding is not believed to grow beyond this.
const MOST_ROUNDING: f64 = 1e-10;
/// Up to so many contacts the sums are made afresh for every solve,
const FEW: usize = 64;
/// with more of them after so many changes and a quarter of their number.
const REFRESH: usize = 64;

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// Decides how the path goes on from here; the changes are told.
    pub(super) fn decide(&mut self) -> Result<(), PathEnd<D, C>> {
        let mut stands = std::mem::take(&mut self.stands);
        let result = self.decide_among(&mut stands);
        if result.is_err() {
            // The path ends in the states that it has come in.
            for (k, stand) in stands.iter().enumerate() {
                self.put(stand.contact, self.before[k].0);
            }
            self.factors = self.sums.factors();
            self.settle_at(self.tau);
        }
        stands.clear();
        self.stands = stands;
        result
    }

    fn decide_among(&mut self, stands: &mut Vec<Stand>) -> Result<(), PathEnd<D, C>> {
        let sets_out = std::mem::take(&mut self.sets_out);
        self.before.clear();
        for stand in stands.iter() {
            self.arrive(stand);
        }
        let found = if sets_out {
            self.slipping.clear();
            // Nothing changes; or everything that stands on an edge sticks to begin with.
            self.newton(stands) || {
                self.put_each(stands, |_, _| Mode::Rolling);
                self.newton(stands)
            }
        } else {
            self.put_each(stands, Local::guess);
            self.newton(stands)
        };
        if !found {
            self.ask_the_ladder(stands)?;
        }
        self.part_what_drags(stands)?;
        self.check_what_lets_go(stands)?;
        self.take_over(stands);
        Ok(())
    }

    /// What touches without force, and gets none, does not drag the object along: where the contact may as well part from it, and
    /// the object moves less then, it parts. Forces are the same.
    fn part_what_drags(&mut self, stands: &mut Vec<Stand>) -> Result<(), PathEnd<D, C>> {
        let travel_rate = self.y_rate.norm();
        let drags = |stand: &Stand| {
            let local = &self.locals[stand.contact as usize];
            let force_rate = local.force(&local.stretch_rate(&self.y_rate), &self.facets).norm();
            stand.apex
                && local.gap
                && local.code != Mode::Open
                && force_rate <= ZERO_SLACK * local.rate_level(travel_rate)
        };
        let idle: Vec<u32> = stands.iter().filter(|stand| drags(stand)).map(|stand| stand.contact).collect();
        if idle.is_empty() {
            return Ok(());
        }
        let (codes, moved) = (self.codes(stands), self.twist_rate().norm());
        for contact in idle {
            self.put(contact, Mode::Open);
        }
        if self.newton(stands) && self.twist_rate().norm() < moved * (1.0 - LESS) {
            return Ok(());
        }
        // What has joined since then slides as before.
        for (k, stand) in stands.iter().enumerate() {
            self.put(stand.contact, codes.get(k).copied().unwrap_or(self.before[k].0));
        }
        if self.solve_rates() { Ok(()) } else { Err(self.undecided()) }
    }

    fn codes(&self, stands: &[Stand]) -> Vec<PolygonState> {
        stands.iter().map(|stand| self.locals[stand.contact as usize].code).collect()
    }

    /// The slip up to here becomes memory.
    pub(super) fn arrive(&mut self, stand: &Stand) {
        let local = &mut self.locals[stand.contact as usize];
        self.before.push((local.code, local.memory));
        let u = local.stretch(&self.y, self.tau);
        local.remember(&u, &self.facets);
    }

    fn put_each(&mut self, stands: &[Stand], code: impl Fn(&Local<D, C>, &Stand) -> PolygonState) {
        for stand in stands {
            let code = code(&self.locals[stand.contact as usize], stand);
            self.put(stand.contact, code);
        }
    }

    /// Puts a contact into a state.
    pub(super) fn put(&mut self, contact: u32, code: PolygonState) {
        let local = &mut self.locals[contact as usize];
        if local.code == code {
            return;
        }
        self.sums.add(local, &self.facets, -self.weight);
        local.code = code;
        self.sums.add(local, &self.facets, self.weight);
        self.age += 1;
    }

    /// Whether states of what stands here have been found that answer their own rates.
    fn newton(&mut self, stands: &mut Vec<Stand>) -> bool {
        for _ in 0..STEPS {
            if !self.solve_rates() {
                return false;
            }
            let mut tolerance = ZERO_SLACK;
            let mut changed = false;
            let travel_rate = self.y_rate.norm();
            for stand in stands.iter() {
                self.looked_at += 1;
                let local = &self.locals[stand.contact as usize];
                let du = local.stretch_rate(&self.y_rate);
                let margin = local.margin(stand, local.code, &du, &self.facets);
                let level = local.rate_level(travel_rate);
                if margin >= -tolerance * level {
                    continue;
                }
                if margin >= -MOST_ROUNDING * level {
                    tolerance = (ZERO_SLACK * self.factors.growth()).min(MOST_ROUNDING);
                    if margin >= -tolerance * level {
                        continue;
                    }
                }
                // Also where no state answers as it should: what others do may help, or nothing does.
                changed = true;
                let answer = local.answer(stand, &du, &self.facets);
                let contact = stand.contact;
                self.put(contact, answer);
            }
            if !changed && !self.others_come_to_rest(stands) {
                return true;
            }
        }
        false
    }

    /// Solves for the rate of the motion in the present states. `false` if nothing balances the load there.
    pub(super) fn solve_rates(&mut self) -> bool {
        if self.locals.len() <= FEW || self.age > REFRESH + self.locals.len() / 4 {
            self.renew();
        }
        self.factors = self.sums.factors();
        let terms = 1.0 + self.sums.rate.amax().max(self.pace);
        let Some(rate) = self.factors.solve_exactly(&self.sums.rate, terms) else { return false };
        self.y_rate = rate;
        self.rest_along_free_motions();
        self.y_rate.iter().all(|x| x.is_finite())
    }

    /// What slides elsewhere and would slip backwards joins those that stand here. Whether anything does.
    fn others_come_to_rest(&mut self, stands: &mut Vec<Stand>) -> bool {
        let course = Course::new(&self.y_rate, self.pace);
        let heading = course.direction();
        self.slipping.clock += heading.distance(&self.heading);
        self.heading = heading;
        let known = stands.len();
        self.resting.clear();
        while let Some((contact, stamp)) = self.slipping.next_within(0.0) {
            let local = &self.locals[contact as usize];
            if local.stamp != stamp || stands[..known].iter().any(|stand| stand.contact == contact) {
                continue;
            }
            self.looked_at += 1;
            let (least, slack) = self.slip_margin(contact);
            if least >= -ZERO_SLACK * self.locals[contact as usize].rate_level(self.y_rate.norm()) {
                self.resting.push((contact, stamp, slack));
                continue;
            }
            let stand = self.stand_of(contact as usize);
            self.arrive(&stand);
            stands.push(stand);
        }
        for &(contact, stamp, slack) in &self.resting {
            self.slipping.wait(contact, stamp, slack);
        }
        stands.len() > known
    }

    /// The least slip rate of a contact that slides, and by how much the direction of the path must change until it can vanish.
    fn slip_margin(&self, contact: u32) -> (f64, f64) {
        let local = &self.locals[contact as usize];
        let du = local.stretch_rate(&self.y_rate);
        let size = Course::new(&self.y_rate, self.pace).size();
        let (mut least, mut slack) = (f64::INFINITY, f64::INFINITY);
        local.for_each_slip(local.code, &self.facets, |felt| {
            let rate = felt.dot(&du);
            let steepest = local.steepest(felt, self.pace);
            least = least.min(rate / felt.amax());
            if steepest > 0.0 && size > 0.0 {
                slack = slack.min((rate / size).max(0.0) / steepest);
            }
        });
        (least, slack)
    }

    /// Infinite friction keeps its tangential force until the normal force is gone, and then loses it all at once.
    fn check_what_lets_go(&mut self, stands: &[Stand]) -> Result<(), PathEnd<D, C>> {
        for (k, stand) in stands.iter().enumerate() {
            let contact = stand.contact as usize;
            let opens = self.locals[contact].code == Mode::Open && self.before[k].0 != Mode::Open;
            if !opens || !self.grasp.sites()[contact].friction.is_infinite() {
                continue;
            }
            // It sticks up to here.
            let motion = self.unit_motion();
            self.put(stand.contact, self.before[k].0);
            if self.holds_along(contact) {
                return Err(PathEnd::Snap(self.loss(stands, motion)));
            }
            self.put(stand.contact, Mode::Open);
        }
        Ok(())
    }

    /// Tells what has changed, and puts what stands here in line again.
    fn take_over(&mut self, stands: &[Stand]) {
        let load = self.program.load_at(self.tau);
        self.told.clear();
        for (k, stand) in stands.iter().enumerate() {
            let (contact, (was, memory)) = (stand.contact, self.before[k]);
            let is = self.locals[contact as usize].code;
            if was != is {
                let before = (State::from(was), self.outward(contact as usize, was));
                let after = (State::from(is), self.slip_direction(contact as usize));
                if let Some(change) = change(before, after) {
                    self.told.push(self.event(contact, change, load));
                }
            }
            if is == Mode::Open {
                // Slip is remembered from where it closes.
                self.locals[contact as usize].memory = memory;
            }
            self.call_back(contact);
            if self.locals[contact as usize].slides() {
                let slack = self.slip_margin(contact).1;
                self.slipping.wait(contact, self.locals[contact as usize].stamp, slack);
            }
        }
        self.told.sort_unstable_by_key(|event| std::cmp::Reverse(event.contact));
    }

    fn event(&self, contact: u32, change: Change<C>, load: crate::grasp::Wrench<D>) -> PatchEvent<D, C> {
        PatchEvent { leg: self.program.leg, fraction: self.tau, load, contact: contact as usize, change }
    }

    /// The middle of the directions in which a sliding contact may slip, coordinate axes.
    fn outward(&self, contact: usize, code: PolygonState) -> Option<SVector<f64, C>> {
        let normals = &self.polygon.normals;
        let [first, second] = code.own_facets(normals.len());
        let outward = normals[first?] + second.map_or_else(SVector::zeros, |second| normals[second]);
        Some(self.grasp.sites()[contact].frame * outward.normalize())
    }

    /// The direction in which a sliding contact slips from here on, coordinate axes; where the slip rate is zero, that in
    /// which it would start.
    fn slip_direction(&self, contact: usize) -> Option<SVector<f64, C>> {
        let (local, site) = (&self.locals[contact], &self.grasp.sites()[contact]);
        let outward = self.outward(contact, local.code)?;
        let du = local.stretch_rate(&self.y_rate);
        let mut slip = du - local.force(&du, &self.facets);
        slip[0] = 0.0;
        for axis in 1..C {
            slip[axis] /= site.springs.root_along(axis);
        }
        let along = site.frame * slip;
        Some(if slip.norm() > 0.0 && along.dot(&outward) > 0.0 { along.normalize() } else { outward })
    }
}
