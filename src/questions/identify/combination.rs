//! Combinations of parameters that the observations do not determine. A parameter is a number of the grasp that is sought, such as a coefficient of
//! friction. An observation is a load or angle at which slip was observed.

use super::tolerances::NO_COMPONENT;
use crate::numerics::{Each, IntoList, Reals, chosen, mapped};
use nalgebra::DMatrix;

use crate::prelude::*;
use crate::words::listed;

/// Parameters that may change together without changing any predicted load. To first order no predicted load changes if each parameter is multiplied
/// by a common factor raised to the power of this parameter in [`powers`](Self::powers).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FreeCombination {
    /// The names of the parameters in this combination.
    pub unknowns: Vec<String>,
    /// For each parameter the power to which the common factor is raised; the power of largest magnitude is 1 or -1.
    pub powers: Vec<f64>,
    /// A sentence about the combination: which function of its parameters the observations determine.
    pub says: String,
}

impl FreeCombination {
    /// Combinations with as few parameters as possible. The columns of `free` span the directions, in the logarithms of the parameters, along which
    /// no predicted load changes. `stays` gets a factor for each parameter. It returns whether all predicted loads stay the same if the parameters
    /// are multiplied by these factors.
    pub(super) fn among(
        mut free: DMatrix<f64>,
        (names, values): (&[String], &[f64]),
        stays: &dyn Fn(&[f64]) -> bool,
    ) -> Vec<Self> {
        let mut all = Vec::new();
        for k in 0..free.ncols() {
            // The pivot is the largest remaining entry, as in Gauss-Jordan elimination. The parameter of the pivot's row then has a component in this
            // direction alone.
            let (row, column) = free.columns_range(k..).icamax_full();
            free.swap_columns(k, k + column);
            let pivot = free[(row, k)];
            if pivot.abs() <= NO_COMPONENT {
                break;
            }
            free.column_mut(k).scale_mut(pivot.recip());
            let this = free.column(k).into_owned();
            for other in chosen(free.ncols(), &|other| *other != k) {
                let times = free[(row, other)];
                free.column_mut(other).axpy(-times, &this, 1.0);
            }
        }
        for direction in free.column_iter() {
            let largest = direction.amax();
            if largest <= NO_COMPONENT {
                continue;
            }
            let part = |(j, x): (usize, &f64)| {
                (x.abs() > NO_COMPONENT * largest).then(|| (names[j].clone(), x / largest))
            };
            let (unknowns, powers): (Vec<_>, Vec<_>) = direction.iter().enumerate().filter_map(part).unzip();
            // Two trial changes along the combination, by up to 0.3 in logarithms or as a relative change. They are large enough to show whether the
            // observations determine a product or a sum of the parameters.
            let along = direction.iter().map(|x| 0.3 * x / largest);
            let [powered, added]: [Vec<f64>; 2] =
                [along.clone().map(f64::exp).list(), along.map(|x| 1.0 + x).list()];
            let changes = direction.iter().zip(values).map(|(x, value)| x * value);
            let is_even = changes.clone().added().abs() <= NO_COMPONENT * changes.map(f64::abs).added();
            let law = if stays(&powered) {
                Law::Powers
            } else if is_even && stays(&added) {
                Law::Sum
            } else {
                Law::Nearby
            };
            let says = formula_text(&unknowns, &powers, law);
            all.push(Self { unknowns, powers, says });
        }
        all
    }
}

/// The function of several parameters whose value the observations determine, although they do not determine each of the parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Law {
    /// A product of powers of the parameters, for changes of any magnitude.
    Powers,
    /// The sum of the parameters. No predicted load changes if the relative changes of the parameters are proportional to the list of powers, which
    /// keeps this sum.
    Sum,
    /// Some other function of the parameters, known only by its first derivatives.
    Nearby,
}

fn formula_text(names: &[String], powers: &[f64], law: Law) -> String {
    if let [one] = names {
        return format!("{one} is not fixed: these slips do not depend on it");
    }
    let apart = format!("{} are not fixed apart by these slips: only", listed(names));
    // If all powers differ from 1 or -1 by less than this number, the sentence about the combination names a product or a ratio.
    let are_alike = powers.iter().all(|power| (power.abs() - 1.0).abs() < 1e-3);
    match law {
        Law::Sum => return format!("{apart} their sum"),
        Law::Powers if are_alike => {}
        _ => return format!("{apart} what they do together"),
    }
    let [more, less] = [1.0, -1.0].each(|sign| {
        let those = chosen(powers.len(), &|k| sign * powers[*k] > 0.0);
        mapped(&those, &|k| names[*k].clone())
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
