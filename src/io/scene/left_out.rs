//! Stiffnesses that a scene does not give: their defaults, and trials with other values that show whether answers depend on them. A setup is a grasp
//! with its questions. A link (a hinge, spring or cable, for example) joins two bodies, or a body and the ground. The load factor is the multiple of
//! a question's load. First slip is the event at which the first contact ceases to stick. A motion counts as small as long as it stays within the
//! limits up to which the linear theory is trusted.

use super::fingertip::Fingertip;
use super::link::LinkSetup;
use super::question::Question;
use super::setup::Setup;
use super::tolerances::{SAME_ANSWER, STIFFNESS_RANGE};
use super::warning::Warning;
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, Outcome, TooFar};
use crate::error::{Error, LARGEST};
use crate::grasp::Link;
use crate::load_path::Ramp;
use crate::need::Amount;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, largest, mapped};

/// Stiffness in all directions, N/m, of a contact for which the scene gives none. If an answer depends on this value, a warning says so, see
/// [`Setup::stiffness_left_out`].
pub(super) const DEFAULT_STIFFNESS: f64 = 1e4;

impl Setup<3> {
    /// Warnings about contacts and links without a stiffness, if an answer depends on this stiffness. To test this, each question is answered with
    /// several trial stiffnesses between a tenth and ten times the default. They are different for each contact, link and direction. Motions always
    /// depend on the stiffness of contacts; the warning therefore lists every question `solve`.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question.
    pub fn stiffness_left_out(&self) -> Result<Vec<Warning>, Error> {
        Ok(self.springs_left_out()?.into_iter().chain(self.stiffness_of_links_left_out()?).list())
    }

    /// A warning about contacts without a stiffness, if an answer depends on the stiffness of these contacts.
    fn springs_left_out(&self) -> Result<Option<Warning>, Error> {
        let (mut contacts, mut names) = (Vec::new(), Vec::new());
        for (i, entry) in self.entries().enumerate() {
            if entry.no_stiffness {
                contacts.push(i);
                names.push(entry.contact.label_text(i));
            }
        }
        if contacts.is_empty() || self.questions.is_empty() {
            return Ok(None);
        }
        let is_motion = |question: &Question<3>| matches!(question, Question::Solve { .. });
        let questions = self.questions_that_depend(
            &[self.with_springs(1), self.with_springs(2)],
            &without_limits,
            &is_motion,
            SAME_ANSWER,
        )?;
        let depends = !questions.is_empty();
        let stiffness = DEFAULT_STIFFNESS;
        Ok(depends.then_some(Warning::StiffnessLeftOut { contacts, names, stiffness, questions }))
    }

    /// A warning about links without a stiffness, if trial stiffnesses change an answer by more than a thousandth.
    fn stiffness_of_links_left_out(&self) -> Result<Option<Warning>, Error> {
        let first = self.entries().count();
        let (mut contacts, mut names) = (Vec::new(), Vec::new());
        for (number, LinkSetup { link, .. }) in self.links.iter().enumerate() {
            if link.stiffness.is_none() {
                contacts.push(first + number);
                names.push(link.called(number));
            }
        }
        if contacts.is_empty() || self.questions.is_empty() {
            return Ok(None);
        }
        let questions =
            // Links are usually much stiffer than the contacts. Answers therefore depend only slightly on the stiffness of links, and changes of up
            // to a thousandth do not count.
            self.questions_that_depend(&[self.with_links(1), self.with_links(2)], &without_limits, &|_| false, 1e-3)?;
        let (depends, stiffness) = (!questions.is_empty(), Link::<3>::STIFF);
        Ok(depends.then_some(Warning::StiffnessLeftOut { contacts, names, stiffness, questions }))
    }

    /// Indices of the questions whose answers depend on the stiffness: in one of the trials, a number of the answer changes by more than the fraction
    /// `same_within`. Questions for which `is_known` is true are listed in any case. `compared` alters every grasp before its answer is compared, for
    /// example by removing the limits of small motions. A question is also listed if this alteration changes the answer of the given grasp. The
    /// limits of small motions then matter, and motions depend on stiffness.
    pub(super) fn questions_that_depend(
        &self,
        trials: &[Self],
        compared: &dyn Fn(&Grasp<3>) -> Grasp<3>,
        is_known: &dyn Fn(&Question<3>) -> bool,
        same_within: f64,
    ) -> Result<Vec<usize>, Error> {
        let given = self.grasp_checked()?;
        let mut questions = Vec::new();
        for (number, question) in self.questions.iter().enumerate() {
            let figures = self.figures(&compared(&given), question)?;
            let mut depends =
                is_known(question) || !same(&figures, &self.figures(&given, question)?, same_within);
            for other in trials {
                let others = other.figures(&compared(&other.grasp_checked()?), question)?;
                depends |= !same(&figures, &others, same_within);
            }
            if depends {
                questions.push(number);
            }
        }
        Ok(questions)
    }

    /// This setup, in which links without a given stiffness have the stiffnesses of the trial with the number `trial`.
    fn with_links(&self, trial: usize) -> Self {
        let mut setup = self.clone();
        for (number, LinkSetup { link, .. }) in setup.links.iter_mut().enumerate() {
            if link.stiffness.is_none() {
                link.stiffness =
                    Some(Link::<3>::STIFF * STIFFNESS_RANGE.powf(2.0 * part(trial + 2 * number) - 1.0));
            }
        }
        setup
    }

    /// This setup, in which contacts without a given stiffness have the stiffnesses of the trial with the number `trial`.
    fn with_springs(&self, trial: usize) -> Self {
        let mut setup = self.clone();
        let mut entries: Vec<&mut Fingertip<3>> = setup.contacts.iter_mut().list();
        for finger in &mut setup.fingers {
            entries.extend(&mut finger.contacts);
        }
        for (index, entry) in entries.into_iter().enumerate() {
            if entry.no_stiffness {
                let mut springs = [DEFAULT_STIFFNESS; 3];
                let axes = self.space.axes();
                for (axis, spring) in springs.iter_mut().enumerate().take(axes) {
                    *spring *= STIFFNESS_RANGE.powf(2.0 * part(trial + 2 * (axes * index + axis)) - 1.0);
                }
                entry.contact = entry.contact.clone().series_stiffness_axes(springs);
            }
        }
        setup
    }

    /// The numbers of an answer that are compared between trials, such as the load factor at first slip. Infinity stands for a number that the answer
    /// does not have.
    fn figures(&self, grasp: &Grasp<3>, question: &Question<3>) -> Result<Vec<f64>, Error> {
        let known = |answer: Option<bool>| answer.map_or(2.0, f64::from);
        let (whole, grasp) = (grasp, &self.grasp_of(grasp, question)?);
        match &*self.meant(question)? {
            Question::Hold { base, load, .. } => {
                let verdict = grasp.hold(Ramp::load(*base, *load))?;
                let (first, lost) = (verdict.first_slip.as_ref(), verdict.lost.as_ref());
                // If the grasp does not hold the whole load, the load factor at first slip is not part of the answer.
                let first = first.filter(|_| verdict.holds() == Some(true));
                let first = first.map_or(f64::INFINITY, |first| first.factor);
                // A grasp that buckles with all trial stiffnesses may not buckle with stiffer springs. The load factor is then set to NaN, which
                // differs from every number, so that the question counts as dependent on stiffness.
                let buckles = lost.is_some_and(|lost| lost.too_far == Some(TooFar::Buckles));
                let lost = lost.map_or(f64::INFINITY, |lost| if buckles { f64::NAN } else { lost.factor });
                Ok(vec![known(verdict.holds()), known(verdict.sticks()), first, lost])
            }
            Question::Need(asked) => {
                let amount = grasp.need(asked)?.amount;
                let until = match &amount {
                    Amount::Bound { until, .. } | Amount::Any { until, .. } => until.as_ref(),
                    _ => None,
                };
                let until = until.map_or(f64::INFINITY, |end| end.sufficient);
                Ok(vec![amount.bound().unwrap_or(f64::INFINITY), until])
            }
            Question::Improve(asked) => {
                Ok(vec![grasp.improve(&self.with_surfaces(grasp, asked))?.after.unwrap_or(f64::INFINITY)])
            }
            Question::Solve { load, .. } => Ok(match grasp.solve(load)? {
                Outcome::Equilibrium(state) => mapped(&state.contacts, &ContactAnswer::normal_force),
                _ => Vec::new(),
            }),
            Question::Identify(asked) => {
                let found = grasp.identify(asked)?;
                Ok(mapped(&found.estimates, &|estimate| estimate.value))
            }
            Question::Onset { .. }
            | Question::Compare { .. }
            | Question::OnsetOfTurn(_)
            | Question::Follow { .. }
            | Question::Shake { .. }
            | Question::Shakedown { .. } => {
                let brief = self.brief_answer(whole, question)?;
                let place = [brief.factor, brief.angle, brief.fraction, brief.leg.map(|leg| leg as f64)];
                Ok(mapped(&place, &|number| number.unwrap_or(f64::INFINITY)))
            }
        }
    }
}

impl<const C: usize> Fingertip<C> {
    /// This contact with the default stiffness, marked as a contact for which no stiffness was given.
    pub(super) fn without_stiffness(mut self) -> Self {
        self.contact = self.contact.series_stiffness_axes([DEFAULT_STIFFNESS; C]);
        self.no_stiffness = true;
        self
    }
}

/// A copy of `grasp` without limits on rotation and slip; all motions then count as small.
fn without_limits(grasp: &Grasp<3>) -> Grasp<3> {
    grasp.with(&grasp.settings().with_small_motions(LARGEST, LARGEST))
}

/// Entry `number` of a sequence in [0, 1), from which trial stiffnesses follow: the fractional parts of multiples of the golden ratio. They fill this
/// interval evenly, without repeating.
fn part(number: usize) -> f64 {
    (0.618_033_988_749_895 * number as f64).fract()
}

fn same(one: &[f64], other: &[f64], within: f64) -> bool {
    let rounding = SOLVED_ROUNDING * largest(one, &|x| if x.is_finite() { x.abs() } else { 0.0 });
    let close = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= rounding.max(within * a.abs().max(b.abs()));
    one.len() == other.len() && one.iter().zip(other).all(close)
}
