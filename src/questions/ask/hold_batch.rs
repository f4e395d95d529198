//! Verdicts on many grasps (whether and how each grasp holds its load), on all cores. A row of the batch is one grasp with its base load and its
//! growing load.
//!
//! In most rows every contact sticks up to the whole load. [`screening`](crate::screening) shows this: a fast computation, for many grasps, of the
//! load factor of first slip, at which the first contact ceases to stick. The rotation of the object also has to stay within the limit of small
//! motions, up to which the linear theory is trusted. For all other rows a load path is computed.

use core::ops::Range;

use super::grasp::Grasp;
use super::rows::{RowOf, answers_of_rows, while_sticking};
use crate::error::Error;
use crate::hold::ShortVerdict;
use crate::load_path::Ramp;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;
use crate::search::Settings;
use crate::sweep::caught;

impl<const C: usize> Grasp<C> {
    /// The verdicts on many loads, each on a grasp of its own, on all cores. A row is one grasp with its base load and growing load; `row` returns
    /// the row with a given index, from 0. The verdicts equal the verdicts of [`Self::hold`], without sentences, lists of contacts and equilibria.
    ///
    /// If [`Settings::most_load`] is at most 1, loads are followed no farther than the whole load, and screening is used. A row of two to 64 contact
    /// points that all stick then takes a few microseconds; [`screening`](crate::screening) says which contacts it supports. Its load factor of first
    /// slip equals that of [`Self::hold`] up to rounding. A row in which contacts slide one after another, and none opens or sticks again, takes some
    /// ten times as long. Its load factors have the error [`Settings::step_error`] of a path followed in steps. Any other row takes as long as
    /// [`Self::hold`]. So does a row whose forces are so large for its stiffness that buckling is not excluded.
    ///
    /// The verdicts are in the order of the rows, and the same to the last bit for any number of threads. An error in one row does not stop the other
    /// rows.
    ///
    /// ```
    /// use grasp_lcp::Settings;
    /// use grasp_lcp::hold::{VerdictKind, LossVerb};
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Jaws that press with 10 N each, μ = 0.5, under 4 N, 8 N, 12 N, …
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let row = |row: usize, contacts: &mut Vec<Contact>| {
    ///     contacts.extend([jaw(-0.03), jaw(0.03)]);
    ///     [Wrench::ZERO, Wrench::force([0.0, -4.0 * (row + 1) as f64])]
    /// };
    /// let verdicts = Grasp::hold_batch(5, &row, &Settings::default().with_most_load(1.0));
    /// let verdicts: Vec<_> = verdicts.into_iter().collect::<Result<_, _>>()?;
    /// assert_eq!(verdicts[1].how, VerdictKind::Sticks);
    /// assert!((verdicts[1].first_slip.expect("10 N of 8 N") - 1.25).abs() < 1e-12);
    /// assert_eq!((verdicts[2].holds(), verdicts[2].motion), (Some(false), Some(LossVerb::SlipsOut)));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn hold_batch(
        rows: usize,
        row: &RowOf<'_, C>,
        settings: &Settings,
    ) -> Vec<Result<ShortVerdict, Error>> {
        answers_of_rows(rows, &|chunk| held(chunk, row, settings))
    }
}

/// The verdicts on a range of rows, in the order of the rows, on one thread.
fn held<const C: usize>(
    rows: Range<usize>,
    row: &RowOf<'_, C>,
    settings: &Settings,
) -> Vec<Result<ShortVerdict, Error>> {
    let ends_there = settings.most_load > 0.0 && settings.most_load <= 1.0;
    let sticking = while_sticking(rows.clone(), row, settings, &|_, _| ends_there);
    let limit = settings.small_motions.rotation;
    let mut verdicts = Vec::with_capacity(rows.len());
    for (number, sticking) in rows.zip(sticking) {
        // The result of screening is used only if first slip is clearly beyond the whole load, and the motion clearly small. Otherwise rounding could
        // change the verdict.
        let clear =
            sticking.filter(|sticks| sticks.first.holds_up_to(1.0 + NEGLIGIBLE) && sticks.is_small(limit));
        verdicts.push(match clear {
            Some(sticking) => Ok(ShortVerdict::sticks(sticking.first.factor())),
            None => caught(&|| {
                let mut contacts = Vec::new();
                let [base, load] = row(number, &mut contacts);
                let grasp = Grasp::new(contacts)?.with(settings);
                Ok(ShortVerdict::from(&grasp.hold_briefly(&Ramp::load(base, load))?.0))
            }),
        });
    }
    verdicts
}
