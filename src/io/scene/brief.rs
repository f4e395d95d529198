//! Short answers, of about a hundred bytes each: outcome, load factor, and the first contact that slips. The load factor is the multiple of a growing
//! load. First slip is the event at which the first contact ceases to stick; the onset is its load factor. A leg is a section of a load program. An
//! amount is a value of the quantity that `need` seeks. A parameter is a number of the grasp that `identify` estimates from observations of slip.

use serde::Serialize;

use super::compared::CompareAnswer;
use super::labels::SceneNames;
use super::question::Question;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::energy::ComparisonVerdict;
use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{WholeContact, inside};
use crate::hold::{Holding, Verdict};
use crate::identify::{FitEnding, Identified};
use crate::improve::{ActiveConstraintKind, Improved, SearchEnd};
use crate::load_path::{DriveChange, Onset, PathEnd};
use crate::need::{Amount, Needed, Quantity};
use crate::numerics::tried;
use crate::shake::{Repeats, Shakedown, Shaken};
use crate::words::Words;

/// A short answer. Unlike a full answer, it omits the behaviour beyond an onset or beyond the end of a load path.
///
/// ```
/// use grasp_lcp::planar::{Contact, Wrench};
/// use grasp_lcp::scene::{Question, Setup};
///
/// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
/// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()]).ask(Question::onset(Wrench::force([0.0, -2.0])));
/// let brief = &setup.brief_answers()?[0];
/// assert_eq!((brief.outcome, brief.factor, brief.first.as_deref(), brief.state), ("at", Some(5.0), Some("contact 0"), Some("slides")));
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Brief {
    /// The name of the question in [the format](crate::scene).
    pub question: &'static str,
    /// The name of the outcome in the format.
    pub outcome: &'static str,
    /// The load factor at first slip; for `hold` the load factor at which equilibrium is lost. For `need` the value of the sought quantity, such as a
    /// factor on the clamping forces. For `improve` the least friction margin, N, if a large margin is the goal. For `compare` and `shakedown` the
    /// multiple of the loads up to which the answer holds. For `identify` the value of the first parameter in its list.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// The load factor at which a contact first stops sticking, for `hold`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_slip: Option<f64>,
    /// The quantity that `need` seeks. `factor` is a coefficient for friction, a length in m for an arm, else a multiple of what is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantity: Option<Quantity>,
    /// The far end of the amounts that suffice, if amounts beyond it fail, in the unit of `factor` or `angle`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// The angle at first slip under a turning load, or the angle that `need` seeks, rad.
    #[serde(rename = "angle_rad", skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// The leg of the load program on which the load path ends, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leg: Option<usize>,
    /// The fraction of the leg [`Self::leg`] that was followed, from 0 to 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fraction: Option<f64>,
    /// The least friction margin `μ F_n - |F_t|` of an equilibrium, N, over the contacts with friction and a finite margin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub margin: Option<f64>,
    /// The first contact, joint or tendon that stops sticking, or the contact with the least margin: its name, or its kind and number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first: Option<String>,
    /// What the part named in [`Self::first`] does at first slip, such as "slides" or "opens"; for an equilibrium the state of this contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub state: Option<&'static str>,
    /// Whether the object turns [too far](Equilibrium::is_beyond_small_motions) for the model of small motions, or buckles. Left out if false.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub beyond_small_motions: bool,
    /// Whether a suction cup is [open all around](Equilibrium::open_cups), which means that the equilibrium does not hold. Left out if false.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub vacuum_gone: bool,
}

impl<const C: usize> Setup<C> {
    /// Short answers to all questions, in order.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question. That no equilibrium exists is an answer.
    pub fn brief_answers(&self) -> Result<Vec<Brief>, Error> {
        inside(self).answered_briefly()
    }
}

impl Setup<3> {
    /// Short answers to all questions, in order, in the plane or in space. Vectors have three components; in the plane the third is zero.
    pub(crate) fn answered_briefly(&self) -> Result<Vec<Brief>, Error> {
        let grasp = self.grasp_checked()?;
        tried(&self.questions, &|question| self.brief_answer(&grasp, question))
    }

    pub(super) fn brief_answer(&self, grasp: &Grasp<3>, question: &Question<3>) -> Result<Brief, Error> {
        self.check_question(question)?;
        let grasp = &self.grasp_of(grasp, question)?;
        let labels = SceneNames(grasp);
        Ok(match &*self.meant(question)? {
            Question::Hold { .. } => held_briefly(&grasp.hold_briefly(&question.ramp()?)?.0),
            Question::Need(asked) => needed_briefly(&grasp.need(asked)?),
            Question::Improve(asked) => improved_briefly(&grasp.improve(&self.with_surfaces(grasp, asked))?),
            Question::Solve { load, .. } => labels.solved_briefly("solve", &grasp.solve(load)?),
            Question::Compare { base, load } => {
                compared_briefly(&labels.compared(base, load, Words::default())?)
            }
            Question::Onset { .. } => labels.onset_briefly("onset", &grasp.onset(&question.ramp()?)?),
            Question::OnsetOfTurn(turn) => {
                let found = grasp.onset_of_turn(turn)?;
                let mut brief = labels.onset_briefly("onset_of_turn", &found.onset);
                brief.angle = brief.factor.take();
                brief
            }
            Question::Follow { start, legs, in_steps: Some(error) } => {
                let mut path = grasp.follow_in_steps(start, legs, *error)?;
                path.by_ref().for_each(drop);
                labels.path_briefly(path.end())
            }
            Question::Follow { start, legs, in_steps: None } => {
                let mut path = grasp.follow(start, legs)?;
                path.by_ref().for_each(drop);
                let beyond_small_motions = path.end_of_theory().is_some();
                Brief { beyond_small_motions, ..labels.path_briefly(path.end()) }
            }
            Question::Shake { base, .. } => shaken_briefly(&grasp.shake(base, &question.legs()?)?),
            Question::Shakedown { base, loads } => {
                shakedown_briefly(grasp.statics().shakedown(base, loads)?.as_ref())
            }
            Question::Identify(asked) => identified_briefly(&grasp.identify(asked)?),
        })
    }
}

impl Brief {
    fn new(question: &'static str, outcome: &'static str) -> Self {
        Self { question, outcome, ..Self::default() }
    }
}

impl SceneNames<'_> {
    fn solved_briefly(&self, question: &'static str, outcome: &Outcome<3>) -> Brief {
        match outcome {
            Outcome::Equilibrium(state) => self.tightest(Brief::new(question, "equilibrium"), state),
            Outcome::NoEquilibrium(_) => Brief::new(question, "no_equilibrium"),
            Outcome::Undecided(_) => Brief::new(question, "undecided"),
        }
    }

    /// Adds to a short answer the contact with the least friction margin `μ F_n - |F_t|`, N.
    fn tightest(&self, brief: Brief, state: &Equilibrium<3>) -> Brief {
        let vacuum_gone = !state.open_cups.is_empty();
        let brief = Brief { beyond_small_motions: is_far(Some(state)), vacuum_gone, ..brief };
        // The margin of a contact without friction is always zero, and says nothing about how near the contact is to slipping.
        let has_margin = |(i, contact): &(usize, &ContactAnswer<3>)| {
            contact.margin.is_finite() && self.0.contacts()[*i].friction_coefficient() > 0.0
        };
        let margins = state.contacts.iter().enumerate().filter(has_margin);
        let least = margins.min_by(|a, b| a.1.margin.total_cmp(&b.1.margin));
        let Some((site, contact)) = least else { return brief };
        let (margin, first) = (Some(contact.margin), Some(self.label(site).text()));
        Brief { margin, first, state: Some(state_text(&contact.state)), ..brief }
    }

    fn onset_briefly(&self, question: &'static str, onset: &Onset<3>) -> Brief {
        match onset {
            Onset::At(event) => {
                let contact = event
                    .leaving
                    .first()
                    .map(|leaving| (self.label(leaving.contact.index).text(), leaving.verb()));
                let part = || event.drives.first().map(|change| (change.part.text(), drive(change.what)));
                let (first, state) = contact.or_else(part).unzip();
                let beyond_small_motions = is_far(self.0.state_at_onset(event).as_ref());
                let factor = Some(event.factor);
                Brief { factor, first, state, beyond_small_motions, ..Brief::new(question, "at") }
            }
            Onset::Never => Brief::new(question, "never"),
            Onset::AlreadySliding(state) => self.tightest(Brief::new(question, "already_sliding"), state),
            Onset::NoBase(_) => Brief::new(question, "no_base"),
            Onset::GivesWay { factor, .. } => {
                Brief { factor: Some(*factor), ..Brief::new(question, "gives_way") }
            }
            Onset::Undecided(_) => Brief::new(question, "undecided"),
        }
    }

    fn path_briefly(&self, end: Option<&PathEnd<3>>) -> Brief {
        let brief = |outcome| Brief {
            leg: end.and_then(PathEnd::leg),
            fraction: end.and_then(PathEnd::fraction),
            ..Brief::new("follow", outcome)
        };
        match end {
            Some(PathEnd::Completed) => brief("completed"),
            Some(PathEnd::Lost(loss)) => {
                let first = loss.contacts.first().map(|contact| self.label(contact.index).text());
                Brief { first, ..brief("lost") }
            }
            Some(PathEnd::NoStart(_)) => brief("no_start"),
            Some(PathEnd::Undecided { .. }) | None => brief("undecided"),
        }
    }
}

fn is_far(state: Option<&Equilibrium<3>>) -> bool {
    state.is_some_and(Equilibrium::is_beyond_small_motions)
}

/// Short answer to `hold`: whether the load is held, the load factor at which equilibrium is lost, and the first contact that slides or opens.
fn held_briefly(verdict: &Verdict<3>) -> Brief {
    let outcome = match verdict.holding {
        Holding::Sticks => "sticks",
        Holding::Slides { .. } => "slides",
        Holding::TurnsOver { .. } => "turns_over",
        Holding::Loose => "loose",
        Holding::Lost => "lost",
        Holding::NoRest { .. } => "no_rest",
        Holding::LostAtRest { .. } => "lost_at_rest",
        Holding::Undecided { .. } => "undecided",
    };
    let first = verdict.first_slip.as_ref();
    let contact =
        first.and_then(|first| first.slide.iter().chain(&first.open).chain(&first.would_pull).next());
    let contact = contact.map(|part| part.label.clone());
    let factor = verdict.lost.as_ref().map(|lost| lost.factor);
    let is_lost = matches!(verdict.holding, Holding::Lost);
    let beyond_small_motions = is_lost && verdict.lost.as_ref().is_some_and(|lost| lost.too_far.is_some());
    let first_slip = first.map(|first| first.factor);
    Brief { factor, first_slip, first: contact, beyond_small_motions, ..Brief::new("hold", outcome) }
}

/// Short answer to `need`: the least or largest value of the sought quantity, such as friction or load.
fn needed_briefly(needed: &Needed) -> Brief {
    let outcome = match needed.amount {
        Amount::Bound { .. } => "bound",
        Amount::Any { .. } => "any",
        Amount::None { .. } => "none",
        Amount::Undecided { .. } => "undecided",
    };
    let amount = needed.amount.bound();
    let (factor, angle) = if needed.quantity == Quantity::Angle { (None, amount) } else { (amount, None) };
    let until = match &needed.amount {
        Amount::Bound { until: Some(end), .. } | Amount::Any { until: Some(end), .. } => Some(end.sufficient),
        _ => None,
    };
    Brief { factor, angle, until, quantity: Some(needed.quantity), ..Brief::new("need", outcome) }
}

/// Short answer to `improve`: the load factor at first slip, or the least friction margin, of the best grasp found. It also names the contact that
/// limits this value.
fn improved_briefly(improved: &Improved<3>) -> Brief {
    let outcome = match improved.search {
        SearchEnd::Optimum => "optimum",
        SearchEnd::Stalled => "stalled",
        SearchEnd::OutOfSteps => "out_of_steps",
        SearchEnd::Unbalanced => "unbalanced",
        SearchEnd::NothingSlides => "nothing_slides",
        SearchEnd::NoStart => "no_start",
    };
    let mut ways = improved.in_the_way.iter();
    let first = ways.find(|way| {
        matches!(way.binds, ActiveConstraintKind::FirstSlip { .. } | ActiveConstraintKind::Reserve { .. })
    });
    let first = first.map(|way| way.contact.label.clone());
    Brief { factor: improved.after, first, ..Brief::new("improve", outcome) }
}

/// Short answer to `shake`: whether slip ceases, alternates or accumulates as the loads repeat, and the name of a contact that slides. If suction
/// cups leak, the answer says so instead, and names one of these cups.
fn shaken_briefly(shaken: &Shaken<3>) -> Brief {
    let first = |contacts: &[WholeContact]| contacts.first().map(|part| part.label.clone());
    let (outcome, slides, on) = match &shaken.repeats {
        _ if !shaken.leaks.is_empty() => ("leaks", first(&shaken.leaks), None),
        Repeats::Rests { slid, .. } => ("rests", first(slid), None),
        Repeats::DiesOut { slid } => ("dies_out", first(slid), None),
        Repeats::Alternates { slides, .. } => ("alternates", first(slides), None),
        Repeats::Walks { slides, .. } => ("walks", first(slides), None),
        Repeats::Lost { leg, lost, .. } => ("lost", first(&lost.slide), Some(*leg)),
        Repeats::NoRest { .. } => ("no_rest", None, None),
        Repeats::Undecided { .. } => ("undecided", None, None),
    };
    let beyond_small_motions = is_far(shaken.state.as_deref());
    Brief { leg: on, first: slides, beyond_small_motions, ..Brief::new("shake", outcome) }
}

/// Short answer to `shakedown`: whether slip ceases in any order of the loads, the shakedown factor, and a contact that slides if the loads exceed
/// this factor.
fn shakedown_briefly(found: Option<&Shakedown<3>>) -> Brief {
    let Some(found) = found else { return Brief::new("shakedown", "undecided") };
    let outcome = match found.rests(1.0) {
        Some(true) => "rests",
        Some(false) => "never_rests",
        None => "may_rest",
    };
    let first = found.binding.first().map(|binding| binding.contact.label.clone());
    let beyond_small_motions = found.too_far.is_some();
    Brief { factor: Some(found.factor), first, beyond_small_motions, ..Brief::new("shakedown", outcome) }
}

/// Short answer to `compare`: whether the equilibrium is the minimum of energy, and the multiple of the load up to which this holds.
fn compared_briefly(answer: &CompareAnswer<3>) -> Brief {
    let outcome = match answer.comparison.verdict {
        ComparisonVerdict::Agree => "agree",
        ComparisonVerdict::TwoEquilibria => "two_equilibria",
        ComparisonVerdict::OutOfEquilibrium { .. } => "out_of_equilibrium",
        ComparisonVerdict::NoEquilibrium { .. } => "no_equilibrium",
        ComparisonVerdict::Unknown { .. } => "unknown",
        ComparisonVerdict::NoMinimum => "no_minimum",
        ComparisonVerdict::Unsolved => "unsolved",
    };
    Brief { factor: answer.agrees_up_to, ..Brief::new("compare", outcome) }
}

/// Short answer to `identify`: how the search ended, and the value of the first parameter, if the observations determine it.
fn identified_briefly(found: &Identified) -> Brief {
    let first = found.estimates.first().filter(|estimate| estimate.is_fixed);
    Brief { factor: first.map(|estimate| estimate.value), ..Brief::new("identify", ended(&found.ending)) }
}

fn state_text(state: &ContactState<3>) -> &'static str {
    match state {
        ContactState::Separated => "separated",
        ContactState::Sticking => "sticking",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "frictionless",
    }
}

fn drive(change: DriveChange) -> &'static str {
    match change {
        DriveChange::Yields => "yields",
        DriveChange::Holds => "holds",
        DriveChange::Slackens => "slackens",
        DriveChange::Tightens => "tightens",
    }
}

/// The word by which an answer states how the search of `identify` ended, such as "converged".
fn ended(ending: &FitEnding) -> &'static str {
    match ending {
        FitEnding::Converged => "converged",
        FitEnding::NotConverged { .. } => "not_converged",
        FitEnding::NotPredicted { .. } => "not_predicted",
    }
}
