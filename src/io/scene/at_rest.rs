//! Warnings about contacts and links that press or pull with no force, or with another force than the scene states, in the equilibrium at rest. At
//! rest means without load, or under the base load of a question. A command is a prescribed displacement of a finger or joint. A pad is the surface
//! of a finger that closes on the grasped part.

use super::link::LinkSetup;
use super::question::Question;
use super::setup::Setup;
use super::suspicious_numbers::applied_loads;
use super::tolerances::OTHERWISE_PRESSED;
use super::warning::Warning;
use crate::ask::Grasp;
use crate::equilibrium::{Outcome, TooFar};
use crate::error::Error;
use crate::grasp::{Hold, Wrench};
use crate::load_path::Ramp;
use crate::need::Quantity;
use crate::numerics::summed;
use crate::words::Words;

impl Setup<3> {
    /// Whether the scene has a question in which nothing presses on any contact. Commands of fingers or joints press, and so does the constant load
    /// of a question (base load, or load at the start). A load that the question adds presses if it pushes the object onto a contact, as a weight
    /// does, or jams the object between contacts.
    ///
    /// Three kinds of question are not tested: `solve` with a load, `need` of an arm, and `identify` of forces under the base load. For a scene
    /// without questions, the result is whether no command presses; for a scene without contacts it is false.
    pub(super) fn nothing_presses(&self, grasp: &Grasp<3>) -> Result<bool, Error> {
        // If a grasp has links but no contacts, the links hold the object, and no command needs to press.
        if grasp.presses() || self.entries().next().is_none() {
            return Ok(false);
        }
        for question in &self.questions {
            let is_solved = matches!(question, Question::Solve { load, .. } if *load != Wrench::ZERO);
            let is_sought = matches!(question, Question::Identify(asked) if asked.seeks_carried());
            // A question `need` for a lever arm tries the load at several arms. A load that presses on no contact at its given arm may jam the object
            // at a longer arm.
            let is_arm = matches!(question, Question::Need(asked) if asked.quantity == Quantity::Arm);
            if is_solved || is_sought || is_arm || at_rest(question) != Wrench::ZERO {
                continue;
            }
            let grasp = self.grasp_of(grasp, question)?;
            let mut presses = false;
            for load in applied_loads(question) {
                presses = presses || self.lies_on_a_contact(&load) || jams(&grasp, load)?;
            }
            if !presses {
                return Ok(true);
            }
        }
        Ok(self.questions.is_empty())
    }

    /// Whether a load presses an object onto a contact, as a weight presses an object onto a table, even if no command presses. Also true if the
    /// scene has a link that cannot go slack, such as a hinge: this link holds the object under any load.
    fn lies_on_a_contact(&self, load: &Wrench<3>) -> bool {
        let force = &load.components()[..3];
        let size = summed(force, &|x| x * x).sqrt();
        let presses = |normal: &[f64]| {
            let (mut along, mut length) = (0.0, 0.0_f64);
            for (n, x) in normal.iter().zip(force) {
                (along, length) = (along + n * x, length.hypot(*n));
            }
            // A force presses on a contact if its component against the normal is more than 1e-6 of its magnitude.
            along < -1e-6 * size * length
        };
        let hangs = |LinkSetup { link, .. }: &LinkSetup<3>| {
            let points = link.contacts_in(self.space, link.kind().name()).unwrap_or_default();
            points.iter().any(|point| point.hold != Hold::Unilateral || presses(point.normal.as_slice()))
        };
        self.entries().any(|entry| presses(entry.contact.normal.as_slice())) || self.links.iter().any(hangs)
    }

    /// The warning that the grasp buckles at rest. `None` if it does not buckle, or if every answer already says so.
    pub(super) fn buckles_at_rest(&self, grasp: &Grasp<3>) -> Result<Option<Warning>, Error> {
        for question in &self.questions {
            let says_itself = matches!(
                question,
                Question::Hold { .. }
                    | Question::Need(_)
                    | Question::Follow { .. }
                    | Question::Shake { .. }
                    | Question::Shakedown { .. }
                    | Question::Improve(_)
            );
            let base = at_rest(question);
            if says_itself || !grasp.engine.may_buckle(&base) {
                continue;
            }
            let grasp = self.grasp_of(grasp, question)?;
            let Ok(Outcome::Equilibrium(state)) = grasp.solve(base) else { continue };
            if state.too_far == Some(TooFar::Buckles) {
                return Ok(Some(Warning::BucklesAtRest));
            }
        }
        Ok(None)
    }

    /// Warnings about contacts and links whose force at rest differs from the force that the scene states. The scene does not say for which
    /// equilibrium it states the forces. Therefore the equilibria without load and under the base load of each question are examined. The equilibrium
    /// with the fewest warnings is taken as the intended one, and its warnings are returned.
    pub(super) fn otherwise_at_rest(&self, grasp: &Grasp<3>) -> Result<Vec<Warning>, Error> {
        let is_pretensioned =
            |entry: &LinkSetup<3>| entry.link.tension.is_none() && entry.link.pretension != 0.0;
        if self.entries().all(|entry| entry.contact.press.is_none())
            && !self.links.iter().any(is_pretensioned)
        {
            return Ok(Vec::new());
        }
        let mut bases = vec![Wrench::ZERO];
        for question in &self.questions {
            let base = at_rest(question);
            if !bases.contains(&base) {
                bases.push(base);
            }
        }
        let mut fewest: Option<Vec<Warning>> = None;
        for base in &bases {
            let warnings = self.otherwise_under(grasp, base)?;
            if fewest.as_ref().is_none_or(|fewest| warnings.len() < fewest.len()) {
                fewest = Some(warnings);
            }
        }
        Ok(fewest.unwrap_or_default())
    }

    fn otherwise_under(&self, grasp: &Grasp<3>, base: &Wrench<3>) -> Result<Vec<Warning>, Error> {
        let Ok(Outcome::Equilibrium(state)) = grasp.solve(base) else { return Ok(Vec::new()) };
        // If a contact no longer touches the object, or a link is slack, rounding errors leave a force of about 1e-77 N, which is reported as zero.
        let told = |force: f64, nominal: f64| Words::default().beside(force, nominal.abs());
        let mut warnings = Vec::new();
        let (mut pressed, wholes) = (0, grasp.engine.wholes());
        for (contact, entry) in self.entries().enumerate() {
            let Some(nominal) = entry.contact.press else { continue };
            pressed += 1;
            // The force of a contact is its component along the contact's normal. For a pad it is the component along the pad's closing direction,
            // since normals differ from point to point on a curved part.
            let along = entry.contact.frame(contact)?.column(0).into_owned();
            let force = summed(&state.contacts[wholes[contact].range.clone()], &|point| {
                point.force_world.dot(&along)
            });
            if (force - nominal).abs() > OTHERWISE_PRESSED * nominal {
                let (name, force) = (entry.contact.label_text(contact), told(force, nominal));
                warnings.push(Warning::PressesOtherwise { contact, name, stated: nominal, force });
            }
        }
        if pressed > 0 && warnings.len() == pressed {
            // If no contact presses with the force that the scene states, the reason may be that all contacts are on the same side of the object. One
            // warning about this reason then replaces the warnings about single contacts.
            warnings = self.same_side().map_or(warnings, |why| vec![why]);
        }
        let contacts = self.entries().count();
        for (number, LinkSetup { link, .. }) in self.links.iter().enumerate() {
            let nominal = link.pretension;
            if nominal == 0.0 || link.tension.is_some() {
                continue;
            }
            let force = state.contacts[wholes[contacts + number].range.start].normal_force();
            if (force - nominal).abs() > OTHERWISE_PRESSED * nominal.abs() {
                let (name, force) = (link.called(number), told(force, nominal));
                warnings.push(Warning::PullsOtherwise { link: number, name, stated: nominal, force });
            }
        }
        Ok(warnings)
    }
}

/// Whether a load that grows from zero jams the object. For this test every friction coefficient between 0 and 3 is raised to 3. The load jams the
/// object if the grasp then holds some fraction of it.
fn jams(grasp: &Grasp<3>, load: Wrench<3>) -> Result<bool, Error> {
    if load == Wrench::ZERO {
        return Ok(false);
    }
    // With a friction coefficient of 3 or more, a load that wedges the object between contacts jams it and is held.
    let rough = grasp.not_installed_with_friction(&|_, mu| if mu > 0.0 { mu.max(3.0) } else { mu })?;
    let verdict = rough.hold(Ramp::load(Wrench::ZERO, load))?;
    Ok(verdict.lost.map_or(verdict.held_to > 0.0, |lost| lost.factor > 0.0))
}

/// The load of a question at rest: the base load or the load at the start, to which the question adds other loads. Zero for `solve`.
fn at_rest(question: &Question<3>) -> Wrench<3> {
    match question {
        Question::Hold { base, .. }
        | Question::Compare { base, .. }
        | Question::Onset { base, .. }
        | Question::Shake { base, .. }
        | Question::Shakedown { base, .. } => *base,
        Question::Need(asked) => {
            let turned = asked.turn.map_or(Wrench::ZERO, |turn| turn.load_at(0.0));
            asked.base() + turned
        }
        Question::Improve(asked) => asked.base(),
        Question::Solve { .. } => Wrench::ZERO,
        Question::OnsetOfTurn(turn) => turn.load_at(0.0),
        Question::Follow { start, .. } => *start,
        Question::Identify(asked) => asked.at_rest(),
    }
}
