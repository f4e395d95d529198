//! Lemke's path through lists of contact states.
//!
//! The pivots are those of Lemke's method on the kinematic form with the covering vector of ones on its rows. In the complementarity problem
//! `w = q + M z + d z₀`, z₀ is the covering variable. Between two pivots one pair (w, z) has both variables zero, and one of the two enters. The
//! basic variable that reaches zero first leaves, and its partner enters next, until z₀ leaves.
//!
//! **Ties.** They are broken as if q were q + ε p, with ε → 0+ and a fixed generic vector p. Among variables that reach zero together, the one with
//! the least ratio of its change by p to its rate leaves first. One more solve with the same factors gives these changes; the data are not changed.
//! If z₀ is among the tied variables, z₀ leaves.

use super::basis::{COVER, PERTURBED, StateBasis, TRIAL};
use super::contact_form::ContactForm;
use super::tolerances::TIE;
use super::variables::{Candidate, Entering, PivotStep, Vanishing};
use crate::contact::{LocalLaw, Mode, State};
use crate::lcp::tolerances::DOUBTFUL_PIVOT;
use crate::numerics::tolerances::FEW_ROUNDINGS;
use crate::numerics::{Bordered, Each, Vector};
use crate::object::{Facet, LazyPricing, Point, Sums, are_stale};
use crate::prelude::*;

/// The way in which a path of Lemke's method ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PivotEnd {
    /// The covering variable z₀ has left the basis, which is now complementary: it gives every contact a state.
    Complementary,
    /// The entering variable grows without bound. On this form a ray proves nothing.
    Ray,
    PivotLimit,
    /// The basis became singular.
    Breakdown,
}

/// A path of Lemke's method. Its memory is reused for the next problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct StatePath {
    pub(crate) form: ContactForm,
    pub(super) basis: StateBasis,
    pub(super) sums: Sums<3>,
    pub(crate) pivots: usize,
    /// Number of times that a contact was evaluated, over all pivots.
    evaluations: usize,
    /// The largest value of `evaluations`, if there is a limit: above it the path ends.
    pub(crate) most_evaluations: Option<usize>,
    /// Pivots since the sums over contacts were last computed anew; each pivot adds rounding to them.
    pub(super) age: usize,
    /// Factors of the bordered system of the present pivot.
    factors: Bordered,
    pricing: LazyPricing,
    candidates: Vec<Candidate>,
}

impl StatePath {
    /// A limit on pivots, above what any known problem of this size needs.
    pub(crate) fn pivot_limit(&self) -> usize {
        10_000 + 100 * self.form.pairs
    }

    /// Follows the path of the covering vector number `attempt` (0: all ones) from the elastic trial state, and returns its end.
    pub(crate) fn run_from_trial(&mut self, attempt: usize, limit: usize) -> PivotEnd {
        self.basis.unjump(self.form.len());
        self.form.scatter(attempt);
        self.sums.stick(self.form.size);
        self.age = 0;
        let Some((first, z0)) = self.most_violated() else { return PivotEnd::Complementary };
        if self.pivots >= limit {
            return PivotEnd::PivotLimit;
        }
        self.pivots += 1;
        self.run(first, &Point { y: Vector::zeros(), s: z0 }, limit)
    }

    /// The pair that is violated most at the trial state, relative to its entry of the covering vector. It comes with the value of the covering
    /// variable z₀ that makes the slack of this pair zero. `None` if no pair is violated.
    fn most_violated(&self) -> Option<(Entering, f64)> {
        let form = &self.form;
        let mut least = 0.0_f64;
        for local in &form.locals {
            for (pair, Facet { row, unit }) in form.pairs_of(local).iter().enumerate() {
                let value = row.dot(&local.trial);
                if value < 0.0 {
                    least = least.min(value / form.cover(local, pair, *unit));
                }
            }
        }
        if least >= 0.0 {
            return None;
        }
        let (mut first, mut least_tie) = (None, f64::INFINITY);
        for (contact, local) in (0..).zip(&form.locals) {
            for (pair, Facet { row, unit }) in form.pairs_of(local).iter().enumerate() {
                let (value, d) = (row.dot(&local.trial), form.cover(local, pair, *unit));
                if value < 0.0 && value - least * d <= TIE * value.abs() {
                    let tie = local.perturbation(pair, *unit) / d;
                    if tie < least_tie {
                        (first, least_tie) = (Some(Entering { contact, pair, jump: true }), tie);
                    }
                }
            }
        }
        first.map(|entering| (entering, -least))
    }

    /// The contact state that belongs to the present basis, for a contact with this law.
    pub(super) fn state(&self, contact: usize, law: &LocalLaw<'_>) -> State {
        let (active, gap) = (&self.basis.active[contact], self.form.locals[contact].contact.gap);
        if law.is_absent() || (gap && active.has(0)) {
            return Mode::Open;
        }
        let mut facets = [0; 3];
        facets.iter_mut().zip(active.facets(gap)).for_each(|(slot, facet)| *slot = facet);
        let facets = &mut facets[..active.len()];
        facets.sort_unstable();
        law.slipping_state(facets)
    }

    /// Computes the sums over all contacts anew, which removes the rounding of updates.
    pub(super) fn refresh(&mut self) {
        self.sums = self.basis.sums(&self.form);
        self.age = 0;
        self.evaluations += self.form.len();
    }

    /// Follows the path from a point where both variables of the complementary pair `entering` are zero.
    pub(super) fn run(&mut self, mut entering: Entering, at: &Point, limit: usize) -> PivotEnd {
        self.candidates.clear();
        self.candidates.reserve(self.form.pairs);
        if self.is_lazy() {
            let Some(first) = self.step(&entering) else { return PivotEnd::Breakdown };
            self.line_up(entering.contact, at, &first.along);
        }
        loop {
            if self.pivots >= limit || self.most_evaluations.is_some_and(|most| self.evaluations > most) {
                return PivotEnd::PivotLimit;
            }
            if are_stale(self.age, self.form.len()) {
                self.refresh();
            }
            let Some(step) = self.step(&entering) else {
                if self.age == 0 {
                    return PivotEnd::Breakdown;
                }
                self.refresh();
                continue;
            };
            let leaving = self.blocking(&step, &entering);
            // A pivot element below this fraction of the largest change in the step may be rounding: the sums are computed anew before it is used.
            let doubtful = match &leaving {
                Leaving::NoVariable => true,
                Leaving::Covering => step.along.s.abs() < DOUBTFUL_PIVOT * step.largest,
                Leaving::Variable(candidate) => {
                    candidate.vanishing.rate.abs() < DOUBTFUL_PIVOT * step.largest
                }
            };
            if doubtful && self.age > 0 {
                self.refresh();
                continue;
            }
            let leaving = match leaving {
                Leaving::NoVariable => return PivotEnd::Ray,
                Leaving::Covering => {
                    self.pivots += 1;
                    if entering.jump && self.exchange(&entering, None).is_none() {
                        return PivotEnd::Breakdown;
                    }
                    return PivotEnd::Complementary;
                }
                Leaving::Variable(candidate) => candidate,
            };
            self.pivots += 1;
            self.age += 1;
            if self.exchange(&entering, Some(&leaving)).is_none() {
                return PivotEnd::Breakdown;
            }
            let length = leaving.vanishing.ratio();
            let at = step.here.plus(length, &step.along);
            let left = entering.contact;
            entering = Entering { contact: leaving.contact, pair: leaving.pair, jump: !leaving.jump };
            if self.is_lazy() {
                self.pricing.advance(length, &step.along);
                if self.pricing.has_turned() {
                    self.line_up(entering.contact, &at, &step.along);
                } else {
                    self.requeue(left, entering.contact, &at);
                }
            }
        }
    }

    fn is_lazy(&self) -> bool {
        // With fewer contacts, evaluating all of them in every step costs less than a queue.
        self.form.len() >= 24
    }

    /// Queues all contacts except `out`, the contact of the pair outside the basis: every step evaluates it.
    fn line_up(&mut self, out: u32, at: &Point, along: &Point) {
        self.evaluations += self.form.len();
        let Self { form, basis, pricing, .. } = self;
        pricing.line_up(form.len(), along, &|contact, e| {
            (0, if contact == out { f64::INFINITY } else { form.slack(basis, contact, at, e) })
        });
    }

    /// Puts the contacts that the step has evaluated back into the queue, except `out`, the contact of the pair now outside the basis: every step
    /// evaluates it.
    fn requeue(&mut self, left: u32, out: u32, at: &Point) {
        let Self { form, basis, pricing, .. } = self;
        pricing.looked.push(left);
        while let Some(contact) = pricing.looked.pop() {
            if contact != out {
                let slack = form.slack(basis, contact, at, &pricing.towards);
                pricing.line.wait(contact, 0, slack);
            }
        }
    }

    /// The vertex at which both variables of the entering pair are zero, and the direction in which the
    /// entering one grows by one.
    fn step(&mut self, entering: &Entering) -> Option<PivotStep> {
        let contact = entering.contact as usize;
        let (local, reaction) = (&self.form.locals[contact], self.basis.reaction(contact));
        let Facet { row, unit } = self.form.pairs_of(local)[entering.pair];
        let (felt, corner) = reaction.feels(&row, self.form.cover(local, entering.pair, unit));
        let gradient = -local.contact.seen.tr_mul(&felt);
        self.factors.assign(&self.sums.stiffness, &self.sums.sides[COVER], &gradient, corner)?;
        let mut pushed = Vector::zeros();
        let mut last = 1.0;
        if entering.jump {
            let column = self.form.column(local, entering.pair);
            pushed = local.contact.seen.tr_mul(&(reaction.hold * column * self.form.coordinates.weight));
            last = -felt.dot(&column);
        }
        let sides = [(&self.sums.sides[TRIAL], -felt.dot(&local.trial)), (&pushed, last)];
        let [here, along] = self.factors.solve_each(sides).each(|(y, s)| Point { y, s });
        let largest = along.s.abs().max(along.y.amax() * self.form.widest).max(1.0);
        Some(PivotStep { here, along, largest })
    }

    /// The variable that reaches zero first as the entering one grows.
    fn blocking(&mut self, step: &PivotStep, entering: &Entering) -> Leaving {
        let lazy = self.is_lazy();
        let Self { form, basis, pricing, candidates, .. } = self;
        candidates.clear();
        let covering = Vanishing { value: step.here.s, rate: step.along.s, level: step.here.size() };
        let z0_shrinks = covering.rate < -FEW_ROUNDINGS * step.largest;
        let mut length = if z0_shrinks { covering.longest() } else { f64::INFINITY };
        let mut evaluations = 0;
        let mut evaluate = |contact: u32, length: &mut f64| {
            evaluations += 1;
            form.decreasing(basis, contact, step, entering, |candidate| {
                if candidate.vanishing.ratio() <= *length {
                    *length = length.min(candidate.vanishing.longest());
                    candidates.push(candidate);
                }
            });
        };
        evaluate(entering.contact, &mut length);
        if lazy {
            // Contacts evaluated before in this step are no longer in the queue; there are some if the step is repeated on recomputed sums.
            for k in 0..pricing.looked.len() {
                evaluate(pricing.looked[k], &mut length);
            }
            let speed = pricing.speed(&step.along);
            let within = |length: f64| length * speed * (1.0 + TIE);
            while let Some((contact, stamp)) = pricing.line.next_within(within(length)) {
                let slack = form.slack(basis, contact, &step.here, &pricing.towards);
                if !pricing.puts_off(within(length), contact, stamp, slack) {
                    evaluate(contact, &mut length);
                }
            }
        } else {
            for (contact, _) in (0..).zip(&form.locals).filter(|(contact, _)| *contact != entering.contact) {
                evaluate(contact, &mut length);
            }
        }
        self.evaluations += evaluations + candidates.len();
        if length == f64::INFINITY {
            return Leaving::NoVariable;
        }
        if z0_shrinks && covering.ratio() <= length {
            return Leaving::Covering;
        }
        candidates.retain(|candidate| candidate.vanishing.ratio() <= length);
        match candidates.as_slice() {
            [] => Leaving::NoVariable,
            [only] => Leaving::Variable(*only),
            _ => self.break_tie(entering),
        }
    }

    /// The tied variable that leaves: the first of the tied variables to reach zero if the constant vector of the complementarity problem were
    /// perturbed.
    fn break_tie(&self, entering: &Entering) -> Leaving {
        let form = &self.form;
        let local = &form.locals[entering.contact as usize];
        let pushed = &self.basis.reaction(entering.contact as usize).tie.of_x;
        let Facet { row, unit } = form.pairs_of(local)[entering.pair];
        let last = row.dot(pushed) - local.perturbation(entering.pair, unit);
        let (y, z0) = self.factors.solve(&-&self.sums.sides[PERTURBED], last);
        let ratio = |candidate: &Candidate| {
            let local = &form.locals[candidate.contact as usize];
            let active = &self.basis.active[candidate.contact as usize];
            let reaction = self.basis.reaction(candidate.contact as usize);
            let stretch = -(&local.contact.seen * &y);
            let change = if let Some(a) = active.position(candidate.pair) {
                let own = reaction.multipliers[a].dot(&stretch);
                -(own + reaction.cover.of_pairs[a] * z0 + reaction.tie.of_pairs[a])
            } else {
                let x = reaction.hold * stretch - reaction.cover.of_x * z0 - reaction.tie.of_x;
                let Facet { row, unit } = form.pairs_of(local)[candidate.pair];
                let d = form.cover(local, candidate.pair, unit);
                row.dot(&x) + d * z0 + local.perturbation(candidate.pair, unit)
            };
            change / -candidate.vanishing.rate
        };
        let first = self.candidates.iter().map(|c| (c, ratio(c))).min_by(|a, b| a.1.total_cmp(&b.1));
        first.map_or(Leaving::NoVariable, |(candidate, _)| Leaving::Variable(*candidate))
    }

    /// Makes the entering variable basic and the leaving one zero. `None` if active pairs become linearly dependent, which is only possible by
    /// rounding.
    fn exchange(&mut self, entering: &Entering, leaving: Option<&Candidate>) -> Option<()> {
        let enters = entering.jump.then_some(entering.contact as usize);
        let leaves = leaving.filter(|l| l.jump).map(|l| l.contact as usize);
        let also = leaves.filter(|contact| enters != Some(*contact));
        for contact in enters.into_iter().chain(also) {
            self.form.accumulate(&mut self.sums, contact, self.basis.jumped(contact), -1.0);
            let mut active = self.basis.active[contact];
            if let (true, Some(leaving)) = (leaves == Some(contact), leaving) {
                active = active.without(leaving.pair);
            }
            if enters == Some(contact) {
                active = active.with(entering.pair)?;
            }
            self.basis.set(&self.form, contact, active)?;
            self.form.accumulate(&mut self.sums, contact, self.basis.jumped(contact), 1.0);
        }
        Some(())
    }
}

enum Leaving {
    NoVariable,
    Covering,
    Variable(Candidate),
}
