//! The answer to [`Identify`](super::Identify) as a sentence: the parameters and their errors. A parameter is a number of the grasp that is sought,
//! such as a coefficient of friction. An observation is a load or angle at which slip was observed.

use core::fmt;

use super::answer::{Estimate, FitEnding, Identified};
use super::assignments::is_alike;
use super::unknown::UnknownKind;
use crate::numerics::{Each, IntoList, chosen, mapped, picked};
use crate::prelude::*;
use crate::words::{Words, listed};

impl fmt::Display for Identified {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let slips = if self.slips == 1 { "1 slip".to_owned() } else { format!("{} slips", self.slips) };
        if let FitEnding::NotPredicted { slip, says } = &self.ending {
            return write!(f, "NOT FOUND from {slips}: slip {slip} is not predicted, {says}");
        }
        let open: Vec<usize> = chosen(self.estimates.len(), &|j| self.depends_on_assignment(*j));
        let clauses: Vec<_> = (0..self.estimates.len())
            .filter(|j| !open.contains(j))
            .map(|j| self.estimates[j].text(words))
            .chain((!open.is_empty()).then(|| self.alternatives_text(&open, words)))
            .list();
        write!(f, "{} from {slips}", clauses.join(", "))?;
        if let Some(groups) = self.groups {
            write!(f, " in {groups} groups")?;
        }
        if let Some(scatter) = self.scatter {
            write!(f, ", which scatter by {} %", Words::with_digits(2).number(100.0 * scatter))?;
        }
        // The sentence mentions residuals only if their root mean square exceeds the given scatter by more than this factor.
        if let Some(misfit) = self.misfit.filter(|misfit| *misfit > 1.5) {
            write!(
                f,
                ", which are {} times as far off as their scatter says",
                Words::with_digits(2).number(misfit)
            )?;
        }
        for combination in &self.free {
            write!(f, ". {}", capital(&combination.says))?;
        }
        let is_wide = |estimate: &&Estimate| {
            !estimate.is_fixed
                && !open.iter().any(|j| self.estimates[*j].name == estimate.name)
                && !self.free.iter().any(|free| free.unknowns.contains(&estimate.name))
        };
        let wide: Vec<_> = self.estimates.iter().filter(is_wide).map(|estimate| estimate.name.clone()).list();
        if !wide.is_empty() && !self.assignments.is_empty() {
            write!(f, ". On which of {} the slips depend is not fixed", listed(&wide))?;
        } else if !wide.is_empty() {
            write!(f, ". {} not fixed: the slips scatter too much", capital(&are(&wide)))?;
        }
        let without_error = |estimate: &&Estimate| estimate.is_fixed && estimate.interval.is_none();
        let unsure: Vec<_> =
            self.estimates.iter().filter(without_error).map(|estimate| estimate.name.clone()).list();
        if self.groups.is_some() && self.degrees_of_freedom > 0 && !unsure.is_empty() {
            let those = listed(&unsure);
            write!(f, ". How sure {those} is is not known: one group of slips alone tells it")?;
        } else if self.degrees_of_freedom > 0 && !unsure.is_empty() {
            write!(
                f,
                ". How sure that is is not known: the slips agree to all digits, which tells nothing of their scatter"
            )?;
        } else if !unsure.is_empty() {
            write!(
                f,
                ". How sure that is is not known: there are as many unknowns as slips, and their scatter is not given"
            )?;
        }
        match self.weights.iter().filter(|weight| **weight < 0.5).count() {
            0 => {}
            1 => write!(f, ". 1 slip lies far off and counts less")?,
            far => write!(f, ". {far} slips lie far off and count less")?,
        }
        match self.ending {
            FitEnding::NotConverged { iterations } => {
                write!(f, ". NOT CONVERGED in {iterations} steps: these numbers may still change")
            }
            _ => Ok(()),
        }
    }
}

impl Identified {
    /// Whether the estimate of this parameter depends on the assignment. An assignment says which contact slips first in each observation, and thus
    /// on which parameters its predicted load depends. Several assignments may fit equally well.
    fn depends_on_assignment(&self, unknown: usize) -> bool {
        self.assignments.iter().any(|each| !is_alike(&self.assignments[0][unknown], &each[unknown]))
    }

    /// The clause about the parameters `open`, on which equally good assignments disagree: "one of the two is 0.423 ± 0.004, which one is not fixed:
    /// friction of left or friction of right". If the estimated values differ, each alternative is named with its value.
    fn alternatives_text(&self, open: &[usize], words: Words) -> String {
        let names: Vec<_> = mapped(open, &|j| self.estimates[*j].name.clone());
        let fixed: Vec<Vec<&Estimate>> = mapped(&self.assignments, &|each| {
            picked(open, &|j| Some(&each[*j]).filter(|estimate| estimate.is_fixed))
        });
        let the_one = fixed.first().and_then(|those| those.first());
        if let Some(one) = the_one
            && fixed.iter().all(|those| matches!(those[..], [this] if is_alike(one, this)))
        {
            let count = match open.len() {
                2 => "two".to_owned(),
                3 => "three".to_owned(),
                many => many.to_string(),
            };
            let value = one.value_text(words);
            return format!("one of the {count} is {value}, which one is not fixed: {},", names.join(" or "));
        }
        let each = fixed.iter().filter(|those| !those.is_empty()).map(|those| {
            let clauses: Vec<_> = those.iter().map(|estimate| estimate.text(words)).list();
            clauses.join(" and ")
        });
        format!("either {}, which is not fixed,", each.list().join(", or "))
    }
}

/// The names as the subject of a sentence, with the verb: "a is", "a and b are".
fn are(names: &[String]) -> String {
    format!("{} {}", listed(names), if names.len() == 1 { "is" } else { "are" })
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_string().to_uppercase() + letters.as_str())
}

impl Estimate {
    fn text(&self, words: Words) -> String {
        if self.is_fixed || self.interval.is_some() {
            format!("{} {}", self.name, self.value_text(words))
        } else {
            format!("{} not fixed", self.name)
        }
    }

    /// The value with its unit and, if known, its standard error and interval.
    fn value_text(&self, words: Words) -> String {
        let (unit, behind) = match self.kind {
            UnknownKind::Friction => ("", ""),
            UnknownKind::Carried => (" N", ""),
            UnknownKind::Squeeze => ("", " times the squeeze given"),
            UnknownKind::Stiffness => ("", " times the tangential stiffness given"),
        };
        let (Some(error), Some([low, high])) = (self.standard_error, self.interval) else {
            return format!("{}{unit}{behind}", words.number(self.value));
        };
        let [value, error, low, high] = [self.value, error, low, high].each(|x| to_error(x, error, words));
        format!("{value}{unit} ± {error}{unit}{behind} (95 %: {low}{unit} to {high}{unit})")
    }
}

/// A number rounded to the second digit of its error, but to no more digits than `words` allows.
fn to_error(x: f64, error: f64, words: Words) -> String {
    let decimals = 1.0 - error.log10().floor();
    // The error may ask for more digits than `words` allows, for more than twelve decimals, or for rounding to tens. Then the number gets the digits
    // that `words` allows.
    let most = words.digits() as f64 - 1.0 - x.abs().log10().floor();
    if !(0.0..=12.0).contains(&decimals) || decimals > most {
        return words.number(x);
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 12")]
    let decimals = decimals as usize;
    format!("{x:.decimals$}")
}
