//! Compares an answer with the exact one, and collects the comparisons in a table.

use std::fmt::Write as _;

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium, Outcome};

use crate::Failure;
use crate::ring::SQUEEZE;
use crate::textbook;
use support::scene::Scene;
use support::truth::Truth;

/// Largest number of unknown directions of sliding in space for which exact equations can be solved in reasonable time.
const MOST_TURNING: usize = 12;
/// A contact state is wrong if its condition is violated by more than this fraction of its terms, even if it is marked as an edge.
const CLEARLY: f64 = 1e-12;

/// The question of a row of the table.
#[derive(Debug, Clone)]
pub(crate) struct Question {
    pub(crate) family: &'static str,
    pub(crate) case: &'static str,
    /// The extreme number, as text and as a number.
    pub(crate) value: (String, f64),
    /// The expected result, where a closed form gives it.
    pub(crate) expected: Option<Expected>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Expected {
    AllStick,
    /// All contact forces are zero, up to rounding errors of the squeeze.
    NoForce,
    NoEquilibrium,
}

/// One row of the table: a question, and the check of its answer.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) question: Question,
    pub(crate) place: &'static str,
    pub(crate) outcome: String,
    pub(crate) slides: bool,
    /// Errors of the equilibrium; `None` without an equilibrium.
    pub(crate) answer: Option<Answer>,
    /// Whether the contact states are right; `None` if states or outcome cannot be checked.
    pub(crate) states: Option<States>,
    pub(crate) remark: String,
}

/// Errors of an equilibrium, relative to the largest force, with their estimate and the condition number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer {
    /// Largest error of a force; `None` if the exact equations have no answer.
    pub(crate) error: Option<f64>,
    /// Largest error of a force component, relative to that component.
    pub(crate) component: Option<f64>,
    pub(crate) estimate: f64,
    pub(crate) condition: f64,
    /// Largest error of a force by the textbook's normal equations, if everything sticks.
    pub(crate) textbook: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum States {
    Right,
    /// The states are right, but this number of contacts is marked as indistinguishable from another state.
    Edge(usize),
    Wrong,
}

#[derive(Debug, Default)]
pub(crate) struct Table {
    pub(crate) rows: Vec<Row>,
}

impl Table {
    /// Computes the equilibrium of a scene and adds a row.
    pub(crate) fn ask<const D: usize, const C: usize>(
        &mut self,
        question: Question,
        scene: &Scene<D, C>,
    ) -> Result<Option<Equilibrium<C>>, Failure> {
        let grasp = Grasp::new(scene.contacts.iter().map(support::scene::Datum::contact))?;
        self.ask_of(question, scene, &grasp)
    }

    /// [`Self::ask`] for a grasp that was not made from the scene's series stiffnesses.
    pub(crate) fn ask_of<const D: usize, const C: usize>(
        &mut self,
        question: Question,
        scene: &Scene<D, C>,
        grasp: &Grasp<C>,
    ) -> Result<Option<Equilibrium<C>>, Failure> {
        let outcome = grasp.solve(scene.wrench())?;
        let mut row = Row {
            outcome: describe(&outcome),
            place: if C == 2 { "plane" } else { "space" },
            slides: false,
            answer: None,
            states: None,
            remark: String::new(),
            question,
        };
        let expected = row.question.expected.map(|expected| expected.is(&outcome));
        if let Some(answer) = outcome.equilibrium() {
            let turning = if C == 2 { 0 } else { count(answer, slides) };
            row.slides = count(answer, slides) > 0;
            let truth = (turning <= MOST_TURNING).then(|| Truth::of(scene, grasp, answer)).flatten();
            if truth.is_none() {
                let free = match (turning > MOST_TURNING, answer.free_motions.is_empty()) {
                    (true, _) => ": too many slide",
                    (_, false) => ": a motion is free",
                    _ => "",
                };
                row.remark = format!("no exact answer{free}");
            }
            let accuracy = grasp.accuracy(answer).ok_or("an equilibrium has an accuracy")?;
            let largest = truth.as_ref().map_or_else(|| scene.sizes(answer).force, |truth| truth.largest);
            let errors = truth.as_ref().map(|truth| truth.errors(grasp, answer));
            let all_stick = count(answer, |s| matches!(s, ContactState::Sticking)) == answer.contacts.len();
            row.answer = Some(Answer {
                error: errors.map(|e| e.force),
                component: errors.map(|e| e.component),
                estimate: accuracy.force / largest,
                condition: accuracy.condition,
                textbook: truth
                    .as_ref()
                    .filter(|_| all_stick)
                    .and_then(|truth| textbook::error(scene, grasp, truth)),
            });
            let distinct = grasp.distinct(answer).ok_or("its own answer")?;
            row.states = truth.map(|truth| States::of(&distinct, &truth));
        }
        match expected {
            Some(false) => row.states = Some(States::Wrong),
            Some(true) if row.states.is_none() => row.states = Some(States::Right),
            _ => {}
        }
        self.rows.push(row);
        Ok(match outcome {
            Outcome::Equilibrium(answer) => Some(*answer),
            _ => None,
        })
    }

    /// Adds a remark to the last row.
    pub(crate) fn remark(&mut self, remark: String) {
        if let Some(row) = self.rows.last_mut() {
            row.remark = remark;
        }
    }

    pub(crate) fn print(&self) {
        let mut heading = (String::new(), "");
        for row in &self.rows {
            let Question { family, case, value, .. } = &row.question;
            if (heading.0.as_str(), heading.1) != (*family, *case) {
                println!("\n{family}: {case}");
                println!(
                    "  {:>9} {:5}  {:>10} {:>10} {:>9}  {:8} outcome",
                    "value", "place", "true error", "estimate", "condition", "states"
                );
                heading = ((*family).to_owned(), case);
            }
            let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:.1e}"));
            let [error, estimate, condition] = [
                row.answer.and_then(|a| a.error),
                row.answer.map(|a| a.estimate),
                row.answer.map(|a| a.condition),
            ]
            .map(number);
            let remark = if row.remark.is_empty() { String::new() } else { format!(" ({})", row.remark) };
            println!(
                "  {:>9} {:5}  {error:>10} {estimate:>10} {condition:>9}  {:8} {}{remark}",
                value.0,
                row.place,
                row.states_in_words(),
                row.outcome
            );
        }
    }

    pub(crate) fn save(&self) -> Result<(), Failure> {
        let mut csv = "family,case,value,place,true_error,component_error,estimate,condition,textbook_error,\
                       states,outcome,remark\n"
            .to_owned();
        for row in &self.rows {
            let Question { family, case, value, .. } = &row.question;
            let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:e}"));
            let a = row.answer;
            let numbers = [
                a.and_then(|a| a.error),
                a.and_then(|a| a.component),
                a.map(|a| a.estimate),
                a.map(|a| a.condition),
                a.and_then(|a| a.textbook),
            ]
            .map(number);
            writeln!(
                csv,
                "\"{family}\",\"{case}\",{:e},{},{},{},\"{}\",\"{}\"",
                value.1,
                row.place,
                numbers.join(","),
                row.states_in_words(),
                row.outcome,
                row.remark
            )?;
        }
        println!();
        support::save("stiff_and_extreme.csv", &csv)?;
        Ok(())
    }
}

impl Row {
    fn states_in_words(&self) -> String {
        match self.states {
            Some(States::Right) => "right".to_owned(),
            Some(States::Edge(count)) => format!("edge {count}"),
            Some(States::Wrong) => "WRONG".to_owned(),
            None => String::new(),
        }
    }
}

impl States {
    fn of<const C: usize>(distinct: &[bool], truth: &Truth<C>) -> Self {
        let fails =
            truth.conditions.iter().any(|c| c.part <= 0.0 && distinct[c.contact] || c.part < -CLEARLY);
        match distinct.iter().filter(|distinct| !**distinct).count() {
            _ if fails => Self::Wrong,
            0 => Self::Right,
            count => Self::Edge(count),
        }
    }
}

impl Expected {
    fn is<const C: usize>(self, outcome: &Outcome<C>) -> bool {
        let every = |what: fn(&grasp_lcp::equilibrium::ContactAnswer<C>) -> bool| {
            outcome.equilibrium().is_some_and(|answer| answer.contacts.iter().all(what))
        };
        match self {
            Self::AllStick => every(|c| matches!(c.state, ContactState::Sticking)),
            Self::NoForce => every(|c| c.force.amax() <= f64::EPSILON * SQUEEZE),
            Self::NoEquilibrium => matches!(outcome, Outcome::NoEquilibrium(_)),
        }
    }
}

fn slides<const C: usize>(state: ContactState<C>) -> bool {
    matches!(state, ContactState::Sliding { .. })
}

fn count<const C: usize>(answer: &Equilibrium<C>, what: impl Fn(ContactState<C>) -> bool) -> usize {
    answer.contacts.iter().filter(|c| what(c.state)).count()
}

fn describe<const C: usize>(outcome: &Outcome<C>) -> String {
    let answer = match outcome {
        Outcome::Equilibrium(answer) => answer,
        Outcome::NoEquilibrium(_) => return "no equilibrium".to_owned(),
        Outcome::Undecided(undecided) => return format!("undecided: {:?}", undecided.doubt),
        _ => return "of an unknown kind".to_owned(),
    };
    let counts = [
        ("stick", count(answer, |s| matches!(s, ContactState::Sticking))),
        ("slide", count(answer, slides)),
        ("frictionless", count(answer, |s| matches!(s, ContactState::Frictionless))),
        ("open", count(answer, |s| matches!(s, ContactState::Separated))),
    ];
    let parts: Vec<_> = counts.iter().filter(|c| c.1 > 0).map(|(what, n)| format!("{n} {what}")).collect();
    parts.join(", ")
}
