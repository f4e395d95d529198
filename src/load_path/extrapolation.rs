//! One large step along a sliding arc, extrapolated from sweeps of more and more small ones.
//!
//! The slips after n small steps of a rule have an error in powers of 1/n (return) or 1/n² (reflection, n even). Neville's scheme
//!
//! ```text
//! T_{j,0} = sweep of n_j steps,     T_{j,k} = T_{j,k-1} + (T_{j,k-1} - T_{j-1,k-1}) / ((n_j / n_{j-k})^p - 1)
//! ```
//!
//! takes one power away in each column; the difference of the last two columns is the error of the one before the last, and so an
//! estimate of the step's error from above. The numbers of steps grow evenly: of all sequences the one that costs least;
//! its coefficients amplify rounding, by about a thousand at 7 sweeps of the return rule and not at all for the other.
//!
//! Source: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, sections II.8 and II.9.

use nalgebra::SVector;

use super::arc::{Arc, Poised, Rule, Swept};
use super::energy::Energy;

/// Sweeps of a large step at most.
const MOST_SWEEPS: usize = 7;
/// So many roundings of a slip come together in a step.
const ROUNDINGS: f64 = 16.0;
/// From so many on they must gain on each other by this factor.
const PATIENCE: usize = 4;
const GAIN: f64 = 0.5;

/// A large step that reached its goal.
#[derive(Debug, Clone)]
pub(super) struct Reached<const D: usize, const C: usize> {
    pub(super) there: Poised<D, C>,
    pub(super) energy: Energy,
    /// The estimated error of forces, over the largest of them, and of slips, over the displacements.
    pub(super) error: f64,
    /// Sweeps it took: few if a longer step would have done.
    pub(super) sweeps: usize,
    /// Some contact slipped against its friction force on the way.
    pub(super) backwards: bool,
}

/// A step to a factor with an error below the tolerance, if there is one.
pub(super) fn extrapolate<const D: usize, const C: usize>(
    arc: &Arc<'_, '_, D, C>,
    rule: Rule,
    to: f64,
    tolerance: f64,
) -> Option<Reached<D, C>> {
    let (first, power) = if rule == Rule::Return { (1, 1) } else { (2, 2) };
    let stuck = arc.stuck();
    // No error is smaller than what the rounding of the displacements makes of the forces.
    let tolerance = tolerance.max(ROUNDINGS * arc.effect(&stuck, &arc.rounding()));
    let mut row: Vec<Vec<f64>> = Vec::new();
    let mut last_error = f64::INFINITY;
    for j in 0..MOST_SWEEPS {
        let count = first * (j + 1);
        let swept = arc.sweep(rule, count, to)?;
        let mut next = vec![flat(arc, &swept)];
        for k in 1..=j {
            let ratio = ((j + 1) as f64 / (j + 1 - k) as f64).powi(power) - 1.0;
            let value = next[k - 1].iter().zip(&row[k - 1]).map(|(new, old)| new + (new - old) / ratio);
            next.push(value.collect());
        }
        row = next;
        if j == 0 {
            continue;
        }
        let best = &row[j];
        let apart: Vec<f64> = best.iter().zip(&row[j - 1]).map(|(a, b)| a - b).collect();
        let error = arc.effect(&stuck, &slips(arc, &apart));
        if error <= tolerance {
            return arrive(arc, to, best, &swept).map(|(there, energy)| Reached {
                there,
                energy,
                error,
                sweeps: j + 1,
                backwards: swept.backwards,
            });
        }
        if j + 1 >= PATIENCE && error > GAIN * last_error {
            return None;
        }
        last_error = error;
    }
    None
}

/// On the cone and in balance with these slips.
fn arrive<const D: usize, const C: usize>(
    arc: &Arc<'_, '_, D, C>,
    to: f64,
    values: &[f64],
    swept: &Swept<D, C>,
) -> Option<(Poised<D, C>, Energy)> {
    let there = arc.poise(to, &slips(arc, values), &swept.twist)?;
    let [finger_work, dissipated, by_parts] = [3, 2, 1].map(|back| values[values.len() - back]);
    let moved = there.at.twist - arc.start.twist;
    let at_the_end = arc.load(to).component_mul(&moved);
    let mut energy = Energy {
        load_work: at_the_end.sum() - by_parts,
        finger_work,
        stored: 0.0,
        dissipated,
        turnover: swept.turnover + at_the_end.abs().sum(),
    };
    energy.store(arc.sites(), &arc.start.forces, &there.at.forces);
    Some((there, energy))
}

/// The slips of what slides, then the works.
fn flat<const D: usize, const C: usize>(arc: &Arc<'_, '_, D, C>, swept: &Swept<D, C>) -> Vec<f64> {
    let sliding = (0..arc.states.len()).filter(|&i| arc.slides(i));
    sliding.flat_map(|i| (1..C).map(move |a| swept.slipped[i][a])).chain(swept.works).collect()
}

fn slips<const D: usize, const C: usize>(arc: &Arc<'_, '_, D, C>, values: &[f64]) -> Vec<SVector<f64, C>> {
    let mut list = vec![SVector::zeros(); arc.states.len()];
    let sliding = (0..arc.states.len()).filter(|&i| arc.slides(i));
    for (i, own) in sliding.zip(values.chunks_exact(C - 1)) {
        for (a, value) in own.iter().enumerate() {
            list[i][a + 1] = *value;
        }
    }
    list
}
