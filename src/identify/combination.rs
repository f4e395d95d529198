//! Combinations of unknowns that slips do not fix.

use nalgebra::DMatrix;

use crate::prelude::*;
use crate::words::listed;

/// Powers that differ from one by less are told as a plain product or ratio.
const ALIKE: f64 = 1e-3;

/// A part of a direction below this is none.
const NONE: f64 = 1e-4;

/// So much of a free combination is tried: far enough to tell a product from a sum.
const TRIED: f64 = 0.3;

/// Unknowns that may change together without any slip being predicted elsewhere: to first order, all of them times a number to these powers.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FreeCombination {
    /// The unknowns, by their names.
    pub unknowns: Vec<String>,
    /// The power of each; the largest is 1.
    pub powers: Vec<f64>,
    /// What that means, in a sentence.
    pub says: String,
}

impl FreeCombination {
    /// From directions of logarithms that span all that is not fixed, as columns: as few unknowns in each as there can be. `stays` says whether all
    /// slips are predicted where they are here if each unknown is so many times as large.
    pub(super) fn among(
        mut free: DMatrix<f64>,
        (names, values): (&[String], &[f64]),
        stays: &dyn Fn(&[f64]) -> bool,
    ) -> Vec<Self> {
        let mut all = Vec::new();
        for k in 0..free.ncols() {
            // The largest entry that is left: its unknown is in this direction alone from now on.
            let (row, column) = free.columns_range(k..).icamax_full();
            free.swap_columns(k, k + column);
            let pivot = free[(row, k)];
            if pivot.abs() <= NONE {
                break;
            }
            free.column_mut(k).scale_mut(pivot.recip());
            let this = free.column(k).into_owned();
            for other in (0..free.ncols()).filter(|other| *other != k) {
                let times = free[(row, other)];
                free.column_mut(other).axpy(-times, &this, 1.0);
            }
        }
        for direction in free.column_iter() {
            let largest = direction.amax();
            if largest <= NONE {
                continue;
            }
            let part =
                |(j, x): (usize, &f64)| (x.abs() > NONE * largest).then(|| (names[j].clone(), x / largest));
            let (unknowns, powers): (Vec<_>, Vec<_>) = direction.iter().enumerate().filter_map(part).unzip();
            let along = direction.iter().map(|x| TRIED * x / largest);
            let [powered, added]: [Vec<f64>; 2] =
                [along.clone().map(f64::exp).collect(), along.map(|x| 1.0 + x).collect()];
            let changes = direction.iter().zip(values).map(|(x, value)| x * value);
            let is_even = changes.clone().sum::<f64>().abs() <= NONE * changes.map(f64::abs).sum::<f64>();
            let law = if stays(&powered) {
                Law::Powers
            } else if is_even && stays(&added) {
                Law::Sum
            } else {
                Law::Nearby
            };
            let says = said(&unknowns, &powers, law);
            all.push(Self { unknowns, powers, says });
        }
        all
    }
}

/// What of a combination is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Law {
    /// Products and ratios, however far it is gone along.
    Powers,
    /// The sum.
    Sum,
    /// Something that looks like either close by.
    Nearby,
}

fn said(names: &[String], powers: &[f64], law: Law) -> String {
    if let [one] = names {
        return format!("{one} is not fixed: these slips do not depend on it");
    }
    let apart = format!("{} are not fixed apart by these slips: only", listed(names));
    let are_alike = powers.iter().all(|power| (power.abs() - 1.0).abs() < ALIKE);
    match law {
        Law::Sum => return format!("{apart} their sum"),
        Law::Powers if are_alike => {}
        _ => return format!("{apart} what they do together"),
    }
    let [more, less] = [1.0, -1.0].map(|sign| {
        let those = names.iter().zip(powers).filter(|(_, power)| sign * **power > 0.0);
        those.map(|(name, _)| name.clone()).collect::<Vec<_>>()
    });
    match (&more[..], &less[..]) {
        ([_], [_]) => format!("{apart} their product"),
        (_, []) | ([], _) => format!("{apart} their ratio{}", if names.len() > 2 { "s" } else { "" }),
        _ => {
            let (one, others) = if more.len() <= less.len() { (more, less) } else { (less, more) };
            format!(
                "{} may be greater by any factor where {} are smaller by it",
                listed(&one),
                listed(&others)
            )
        }
    }
}
