//! One step of an ordinary differential equation `y' = f(y)` by an explicit Runge-Kutta method of order 8 with twelve stages.
//!
//! ```text
//! k_s = f(y + h Σ_j a_sj k_j),      y₁ = y + h Σ b_s k_s,      e = 4 err₅² / √(err₅² + 0.01 err₃²)
//! ```
//!
//! Here h is the length of the step, and a_sj, b_s are the coefficients of the method. Two embedded formulas, of orders 5 and 3, estimate the error
//! by err₅ and err₃. Their combination e is of order h⁸, like the error of a method of order 7. Without the factor 4, e would be smaller than the
//! error about as often as larger.
//!
//! Source: the method DOP853 of Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, second edition, section II.10.

use super::add_times::add_times;
use crate::prelude::*;

/// A weighted sum of stages, as pairs of stage index and coefficient.
type Sum = &'static [(usize, f64)];

/// The coefficients of the Runge-Kutta method, as at the top of the file.
struct Tableau {
    /// Coefficients a_sj of each stage after the first, row by row.
    ways: [Sum; 11],
    /// Weights b_s of the stages s in the result of the step.
    weights: Sum,
    /// Weights of the stages in the error estimate by the embedded formula of order 5.
    fifth: Sum,
    /// Weights of the stages in the embedded formula of order 3. Its difference from the result estimates the error.
    third: Sum,
}

#[allow(clippy::unreadable_literal)]
const TABLEAU: Tableau = Tableau {
    ways: [
        &[(0, 0.05260015195876773)],
        &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
        &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
        &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)],
        &[(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)],
        &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)],
        &[
            (0, 0.03709200011850479),
            (3, 0.17038392571223998),
            (4, 0.10726203044637328),
            (5, -0.015319437748624402),
            (6, 0.008273789163814023),
        ],
        &[
            (0, 0.6241109587160757),
            (3, -3.3608926294469414),
            (4, -0.868219346841726),
            (5, 27.59209969944671),
            (6, 20.154067550477894),
            (7, -43.48988418106996),
        ],
        &[
            (0, 0.47766253643826434),
            (3, -2.4881146199716677),
            (4, -0.590290826836843),
            (5, 21.230051448181193),
            (6, 15.279233632882423),
            (7, -33.28821096898486),
            (8, -0.020331201708508627),
        ],
        &[
            (0, -0.9371424300859873),
            (3, 5.186372428844064),
            (4, 1.0914373489967295),
            (5, -8.149787010746927),
            (6, -18.52006565999696),
            (7, 22.739487099350505),
            (8, 2.4936055526796523),
            (9, -3.0467644718982196),
        ],
        &[
            (0, 2.273310147516538),
            (3, -10.53449546673725),
            (4, -2.0008720582248625),
            (5, -17.9589318631188),
            (6, 27.94888452941996),
            (7, -2.8589982771350235),
            (8, -8.87285693353063),
            (9, 12.360567175794303),
            (10, 0.6433927460157636),
        ],
    ],
    weights: &[
        (0, 0.054293734116568765),
        (5, 4.450312892752409),
        (6, 1.8915178993145003),
        (7, -5.801203960010585),
        (8, 0.3111643669578199),
        (9, -0.1521609496625161),
        (10, 0.20136540080403034),
        (11, 0.04471061572777259),
    ],
    fifth: &[
        (0, 0.01312004499419488),
        (5, -1.2251564463762044),
        (6, -0.4957589496572502),
        (7, 1.6643771824549864),
        (8, -0.35032884874997366),
        (9, 0.3341791187130175),
        (10, 0.08192320648511571),
        (11, -0.022355307863886294),
    ],
    third: &[(0, 0.2440944881889764), (8, 0.7338466882816118), (11, 0.022058823529411766)],
};

#[derive(Debug, Clone)]
pub(crate) struct Stepped {
    /// Change of the variables over the step.
    pub(crate) change: Vec<f64>,
    /// Estimated error of the step's change, as measured by the caller's function `size`.
    pub(crate) error: f64,
}

/// One step of length `length`. The variables are changes since the start of the step, where they are zero and their rate is `first`. `rate` computes
/// f(y), or returns `None` where f is not defined; `size` measures an error of the variables. `None` if f is not defined at a stage, or the error is
/// not finite.
pub(crate) fn explicit_step(
    length: f64,
    first: &[f64],
    mut rate: impl FnMut(&[f64], &mut [f64]) -> Option<()>,
    size: impl Fn(&[f64]) -> f64,
) -> Option<Stepped> {
    let n = first.len();
    let mut stages = vec![0.0; (TABLEAU.ways.len() + 1) * n];
    stages[..n].copy_from_slice(first);
    let mut y = vec![0.0; n];
    for (s, way) in (1..).zip(TABLEAU.ways) {
        let (before, after) = stages.split_at_mut(s * n);
        add_up(before, length, way, &mut y);
        rate(&y, &mut after[..n])?;
    }
    let mut change = vec![0.0; n];
    add_up(&stages, length, TABLEAU.weights, &mut change);
    add_up(&stages, length, TABLEAU.fifth, &mut y);
    let fifth = size(&y);
    add_up(&stages, length, TABLEAU.third, &mut y);
    add_times(&mut y, &change, -1.0);
    let third = size(&y);
    let scale = fifth.hypot(0.1 * third);
    // The factor 4 makes the estimate usually exceed the true error.
    let error = if scale > 0.0 { 4.0 * fifth * (fifth / scale) } else { scale };
    error.is_finite().then_some(Stepped { change, error })
}

/// Sets `y` to the weighted sum `h Σ c_s k_s` of the stages k_s, with the step length h and the coefficients c_s of `sum`.
fn add_up(stages: &[f64], length: f64, sum: Sum, y: &mut [f64]) {
    let n = y.len();
    y.fill(0.0);
    for &(s, c) in sum {
        add_times(y, &stages[s * n..], length * c);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The true and the estimated error of one step for `y' = (-y₂, y₁)`. The exact solution turns the point (1, 0) about the origin by `angle`.
    fn turn(angle: f64) -> (f64, f64) {
        let rate = |y: &[f64], out: &mut [f64]| {
            (out[0], out[1]) = (-y[1], 1.0 + y[0]);
            Some(())
        };
        let size = |e: &[f64]| e[0].hypot(e[1]);
        let Some(there) = explicit_step(angle, &[0.0, 1.0], rate, size) else { return (f64::NAN, f64::NAN) };
        let miss = (1.0 + there.change[0] - angle.cos()).hypot(there.change[1] - angle.sin());
        (miss, there.error)
    }

    #[test]
    fn half_a_step_misses_by_a_five_hundredth() {
        let ([long, half], estimates) = ([turn(1.0).0, turn(0.5).0], [turn(1.0).1, turn(0.5).1]);
        assert!((300.0..900.0).contains(&(long / half)), "{long:e} {half:e}");
        assert!(long < estimates[0] && half < estimates[1], "{estimates:?}");
        assert!((100.0..600.0).contains(&(estimates[0] / estimates[1])), "{estimates:?}");
    }
}
