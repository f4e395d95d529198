//! Needed amounts of many grasps, on all cores: for each grasp the least multiple of its squeeze, or the greatest multiple of its load, with which it
//! meets the demand (everything sticks, or the object is held). An amount is sufficient if the grasp meets the demand with it.
//!
//! If everything must stick, [`screening`](crate::screening) computes the load factor of first slip, the greatest multiple of the load. If only
//! squeeze and load act, the inverse of this factor is the least multiple of the squeeze. If the object must be held, the load factor at which
//! equilibrium is lost is used instead; one load path finds it. For all other grasps [`Grasp::need`] searches for the amount. At rest means before
//! the load acts. The squeeze is everything by which contacts press at rest without a load; here it consists of the commands of fingers, the
//! displacements that they would make without the object. Motions are small within the limits of rotation, slip and opening up to which the linear
//! theory is trusted.

use core::ops::Range;

use super::answer::{Amount, Quantity};
use super::question::{Demand, Need};
use super::tolerances::MOST_LOADS;
use crate::ask::{Grasp, RowOf, answers_of_rows, while_sticking};
use crate::error::Error;
use crate::grasp::{Contact, Wrench, inside};
use crate::hold::{Holding, Verdict};
use crate::load_path::Ramp;
use crate::prelude::*;
use crate::screening::WhileSticking;
use crate::search::Settings;
use crate::sweep::caught;

/// The needed amount of one of many grasps, see [`Grasp::need_batch`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ShortAmount {
    /// The least or greatest sufficient amount (the least squeeze, the greatest load).
    Bound(f64),
    /// All amounts that were tried are sufficient, so that no least or greatest one is known.
    Any,
    /// No amount that was tried is sufficient, or a proof excludes all amounts.
    None,
    /// For some amount it is undecided whether it is sufficient, so that the least or greatest sufficient amount is not known.
    Undecided,
}

impl ShortAmount {
    /// The least or greatest sufficient amount; `None` if it is not known, or if there is no sufficient amount.
    #[must_use]
    pub fn bound(self) -> Option<f64> {
        if let Self::Bound(sufficient) = self { Some(sufficient) } else { None }
    }
}

impl From<&Amount> for ShortAmount {
    fn from(amount: &Amount) -> Self {
        match amount {
            Amount::Bound { sufficient, .. } => Self::Bound(*sufficient),
            Amount::Any { .. } => Self::Any,
            Amount::None { .. } => Self::None,
            Amount::Undecided { .. } => Self::Undecided,
        }
    }
}

impl<const C: usize> Grasp<C> {
    /// The squeeze that each of many grasps needs for its own load, or the multiple of its load that it carries, on all cores. The amounts are those
    /// of [`Self::need`]; sentences, further intervals of sufficient amounts, and safe amounts are left out.
    ///
    /// The quantity is [`Quantity::Squeeze`] or [`Quantity::Load`], the demand that everything [sticks](Demand::Sticks) or that the object is
    /// [held](Demand::Held). A row is one grasp with its load. If everything must stick, a row takes a few microseconds; if the object must be held,
    /// it takes as long as one load path up to the loss. Any other row takes as long as [`Self::need`]. The amounts agree with those of
    /// [`Self::need`] up to the step error along parts of load paths on which directions of slip turn.
    ///
    /// The amounts are in the order of the rows, with the same bits for any number of threads. An error in one row does not stop the other rows.
    ///
    /// ```
    /// use grasp_lcp::Settings;
    /// use grasp_lcp::need::{Demand, Quantity};
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Jaws that press with 10 N each, μ = 0.5, under 5 N, 10 N, 15 N: they need 5 N, 10 N, 15 N each.
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let row = |row: usize, contacts: &mut Vec<Contact>| {
    ///     contacts.extend([jaw(-0.03), jaw(0.03)]);
    ///     [Wrench::ZERO, Wrench::force([0.0, -5.0 * (row + 1) as f64])]
    /// };
    /// let squeezes = Grasp::need_batch(3, &row, (Quantity::Squeeze, Demand::Held), &Settings::default());
    /// for (squeeze, closed) in squeezes.into_iter().zip([0.5, 1.0, 1.5]) {
    ///     assert!((squeeze?.bound().expect("a bound") - closed).abs() < 1e-9);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// A row has the error [`Error::Question`] if another quantity or demand is asked for. It has [`Error::Wrench`] if its load is not finite or
    /// beyond 1e50, [`Error::Contact`] or [`Error::EmptyGrasp`] if its contacts form no valid grasp.
    #[must_use]
    pub fn need_batch(
        rows: usize,
        row: &RowOf<'_, C>,
        (quantity, demand): (Quantity, Demand),
        settings: &Settings,
    ) -> Vec<Result<ShortAmount, Error>> {
        let asked = BatchNeed { quantity, demand, settings: *settings };
        answers_of_rows(rows, &|chunk| asked.amounts(chunk, row))
    }
}

/// The sought quantity, the demand and the settings, which are the same for all rows (a row is one grasp with its load).
struct BatchNeed {
    quantity: Quantity,
    demand: Demand,
    settings: Settings,
}

impl BatchNeed {
    /// Whether the answer is the greatest multiple of the load that the grasp bears or, for a squeeze, the inverse of this multiple. For a squeeze
    /// this requires that nothing but commands and the load acts, and that no contact has a clearance.
    fn is_proportional<const C: usize>(&self, contacts: &[Contact<C>], base: &Wrench<C>) -> bool {
        let held = |contact: &Contact<C>| {
            contact.clearance == 0.0 && contact.force.is_none() && contact.suction == 0.0
        };
        let is_squeezed = || contacts.iter().any(|contact| contact.commanded().amax() > 0.0);
        match self.quantity {
            Quantity::Squeeze => *base == Wrench::ZERO && contacts.iter().all(held) && is_squeezed(),
            Quantity::Load => true,
            _ => false,
        }
    }

    /// The answer if the grasp bears at most this `multiple` of the load; `None` if the answer lies beyond the amounts that a search would try.
    fn amount(&self, multiple: f64) -> Option<f64> {
        let amount = if self.quantity == Quantity::Squeeze { 1.0 / multiple } else { multiple };
        (1.0 / MOST_LOADS..=MOST_LOADS).contains(&amount).then_some(amount)
    }

    /// The amounts for a range of rows, each a grasp with its load, on one thread.
    fn amounts<const C: usize>(
        &self,
        rows: Range<usize>,
        row: &RowOf<'_, C>,
    ) -> Vec<Result<ShortAmount, Error>> {
        let sticks = self.demand == Demand::Sticks;
        let sticking = while_sticking(rows.clone(), row, &self.settings, &|contacts, base| {
            sticks && self.is_proportional(contacts, base)
        });
        let bounds = self.while_they_stick(rows.start, row, &sticking);
        let mut amounts = Vec::with_capacity(rows.len());
        for (number, bound) in rows.zip(bounds) {
            amounts.push(match bound {
                Some(amount) => Ok(ShortAmount::Bound(amount)),
                None => caught(&|| self.alone(number, row)),
            });
        }
        amounts
    }

    /// The amounts with which everything sticks, of rows from `first` on. `None` for a row unless rotations with its amount are clearly small, and the
    /// grasp surely neither buckles nor snaps through: rows are screened again with their amounts.
    fn while_they_stick<const C: usize>(
        &self,
        first: usize,
        row: &RowOf<'_, C>,
        sticking: &[Option<WhileSticking>],
    ) -> Vec<Option<f64>> {
        let mut again = Vec::new();
        for (place, sticking) in sticking.iter().enumerate() {
            let multiple = sticking.as_ref().and_then(|one| one.first.factor());
            again.extend(multiple.and_then(|multiple| self.amount(multiple)).map(|amount| (place, amount)));
        }
        let multiplied = |k: usize, contacts: &mut Vec<Contact<C>>| {
            let (place, amount) = again[k];
            let [base, load] = row(first + place, contacts);
            if self.quantity == Quantity::Squeeze {
                for contact in contacts {
                    contact.squeeze(amount);
                }
                return [base, load];
            }
            [base, load * amount]
        };
        let there = while_sticking(0..again.len(), &multiplied, &self.settings, &|_, _| true);
        let limit = self.settings.small_motions.rotation;
        let mut bounds = vec![None; sticking.len()];
        for ((place, amount), there) in again.iter().zip(there) {
            bounds[*place] = there.filter(|there| there.is_small(limit)).map(|_| *amount);
        }
        bounds
    }

    /// The amount for one row, a grasp with its load.
    fn alone<const C: usize>(&self, number: usize, row: &RowOf<'_, C>) -> Result<ShortAmount, Error> {
        let mut contacts = Vec::new();
        let [base, load] = row(number, &mut contacts);
        let is_path = self.demand == Demand::Held && self.is_proportional(&contacts, &base);
        let grasp = Grasp::new(contacts)?.with(&self.settings);
        if is_path && let Some(amount) = self.along_the_path(&grasp, base, load)? {
            return Ok(ShortAmount::Bound(amount));
        }
        let need = match self.quantity {
            Quantity::Squeeze => Need::squeeze(load),
            Quantity::Load => Need::load(load),
            _ => return Err(refused("quantity", "is another, must be squeeze or load")),
        };
        let need = match self.demand {
            Demand::Sticks => need.to_stick(),
            Demand::Held => need.to_hold(),
            _ => return Err(refused("demand", "is of loads that repeat, must be sticks or held")),
        };
        let need = if base == Wrench::ZERO { need } else { need.on_top_of(base) };
        Ok(ShortAmount::from(&grasp.need(&need.with_scan(0))?.amount))
    }

    /// The amount with which the object is held, computed from the loss at the end of the path of its load.
    fn along_the_path<const C: usize>(
        &self,
        grasp: &Grasp<C>,
        base: Wrench<C>,
        load: Wrench<C>,
    ) -> Result<Option<f64>, Error> {
        let ramp = Ramp::load(base, load);
        if self.quantity == Quantity::Load {
            let lost = lost_at(&grasp.hold_briefly(&ramp)?.0);
            return Ok(lost.and_then(|(multiple, _)| self.amount(multiple)));
        }
        // Motions may be too large at the given squeeze, but small at the sought squeeze. Therefore the path to the loss is followed with
        // wider limits of motions.
        let (mut lenient, small) = (self.settings, &self.settings.small_motions);
        let wider = ANY_MOTION.min(MOST_LIMIT / small.rotation.max(small.slip));
        lenient.small_motions.rotation *= wider;
        lenient.small_motions.slip *= wider;
        let (verdict, farthest) = grasp.with(&lenient).hold_briefly(&ramp)?;
        let lost = lost_at(&verdict).filter(|(_, is_too_far)| !is_too_far);
        let Some(amount) = lost.and_then(|(multiple, _)| self.amount(multiple)) else { return Ok(None) };
        // Motions are proportional to the squeeze, so that `farthest`, their largest ratio to a limit, gives this ratio for the sought squeeze, too.
        // Forces grow with the squeeze, but stiffness does not, so that a larger squeeze may buckle the grasp.
        let may_buckle = |factor: f64| grasp.engine.may_buckle(&inside(&ramp.load_at(factor)));
        let is_larger = amount > 1.0 && (may_buckle(0.0) || may_buckle(1.0));
        if farthest * wider * amount <= SURELY_SMALL && !is_larger {
            return Ok(Some(amount));
        }
        let enough = grasp.squeezed(amount * (1.0 + BEYOND_STEPS))?.with(&self.settings.with_most_load(1.0));
        Ok((enough.hold_briefly(&ramp)?.0.holds() == Some(true)).then_some(amount))
    }
}

/// The limits of small motions are multiplied by this factor, so that motions which are small at the sought squeeze do not end the load path.
///
/// A load path stores 1 less the ratio of a motion to its limit. If the factor is much larger, these ratios are lost in rounding, and objects that
/// leave are followed to distances at which rounding decides. A row then takes seven times as long. With a smaller factor more rows need the slower
/// search of [`Grasp::need`].
const ANY_MOTION: f64 = 1e6;
/// Motions up to this part of their limits stay within them, although forces that turn with the parts enlarge them. If larger, squeezes seem sufficient
/// with which parts turn too far; if smaller, more squeezes are tried.
const SURELY_SMALL: f64 = 0.1;
/// The largest limit of small motions that settings may have, for the rotation in rad and for the slip as a fraction of the grasp. The squares of
/// larger limits might overflow.
const MOST_LIMIT: f64 = 1e50;
/// The squeeze that is tried exceeds the computed squeeze by this fraction. The fraction is larger than the step error of load paths on which
/// directions of slip turn (1e-9 by default), but too small to matter for motions.
const BEYOND_STEPS: f64 = 1e-7;

/// The multiple of the load at the loss. The second value is true if the object is lost only because motions are no longer small, a cup leaks or the
/// grasp buckles. `None` if the object is not held at rest, or no loss was found.
fn lost_at<const C: usize>(verdict: &Verdict<C>) -> Option<(f64, bool)> {
    let starts = matches!(verdict.holding, Holding::Sticks | Holding::Slides { .. } | Holding::Lost);
    let lost = verdict.lost.as_ref().filter(|lost| starts && lost.factor > 0.0)?;
    Some((lost.factor, lost.too_far.is_some()))
}

fn refused(field: &'static str, fault: &'static str) -> Error {
    Error::Question { question: "need", field, fault }
}
