//! All equilibria of two planar bodies, from every combination of contact states. Close cases are decided in exact rational arithmetic.

use super::elimination::Eliminated;
use super::exact_lcp::is_feasible;
use nalgebra::{DMatrix, DVector, Vector2};
use num_rational::BigRational;
use num_traits::Signed;

use super::stacks::{Stack, Touch};

/// Singular values below this fraction of the largest singular value are treated as zero.
const SINGULAR: f64 = 1e-10;
/// A condition violated by more than this fraction of its terms fails without a check in exact arithmetic.
const NEAR: f64 = 1e-6;
/// A condition met or violated by less than this fraction of its terms is too close for working precision.
const NARROW: f64 = 1e-9;

/// State of a contact. The number of `Slides` is +1 or -1, for a slip along +t or -t.
#[derive(Debug, Clone, Copy, PartialEq)]
enum State {
    Open,
    Sticks,
    Slides(f64),
}

/// An affine function of all coordinates: `row·q + constant`.
struct Linear {
    row: DVector<f64>,
    constant: f64,
}

/// Conditions of a combination of states: `balance` must be zero, `signs` must not be negative.
struct Conditions {
    balance: Vec<Linear>,
    signs: Vec<Linear>,
}

/// Generalised force of a unit force along an axis of a contact, on the coordinates of both bodies.
fn along(touch: &Touch<2>, axis: Vector2<f64>) -> DVector<f64> {
    let mut row = DVector::zeros(6);
    let p = touch.datum.point;
    let of = [axis[0], axis[1], p[0] * axis[1] - p[1] * axis[0]];
    for k in 0..3 {
        row[3 * touch.on + k] += of[k];
        if let Some(against) = touch.against {
            row[3 * against + k] -= of[k];
        }
    }
    row
}

fn conditions(stack: &Stack<3, 2>, states: &[State]) -> Conditions {
    let mut matrix = DMatrix::<f64>::zeros(6, 6);
    let mut constant = DVector::from_iterator(6, stack.loads.iter().flat_map(|load| load.iter().copied()));
    let mut signs = Vec::new();
    for (touch, state) in stack.touches.iter().zip(states) {
        let (datum, frame) = (&touch.datum, touch.datum.frame());
        let [n, t] = [0, 1].map(|a| along(touch, frame.column(a).into_owned()));
        let stretch = |axis: &DVector<f64>, a: usize| Linear {
            row: -axis * datum.stiffness[a],
            constant: datum.stiffness[a] * datum.drive()[a],
        };
        let (normal, mu) = (stretch(&n, 0), datum.friction);
        let tangential =
            if mu == 0.0 { Linear { row: DVector::zeros(6), constant: 0.0 } } else { stretch(&t, 1) };
        let mut carry = |axis: &DVector<f64>, force: &Linear| {
            matrix += axis * force.row.transpose();
            constant += axis * force.constant;
        };
        let scaled = |of: &Linear, by: f64| Linear { row: &of.row * by, constant: of.constant * by };
        let sum = |a: &Linear, b: &Linear| Linear { row: &a.row + &b.row, constant: a.constant + b.constant };
        match state {
            State::Open => signs.push(scaled(&normal, -1.0)),
            State::Sticks => {
                carry(&n, &normal);
                carry(&t, &tangential);
                signs.extend([
                    sum(&scaled(&normal, mu), &tangential),
                    sum(&scaled(&normal, mu), &scaled(&tangential, -1.0)),
                ]);
                signs.push(normal);
            }
            State::Slides(way) => {
                carry(&n, &normal);
                carry(&t, &scaled(&normal, way * mu));
                signs.push(sum(&scaled(&tangential, *way), &scaled(&normal, -mu)));
                signs.push(normal);
            }
        }
    }
    let balance = (0..6).map(|k| Linear { row: matrix.row(k).transpose(), constant: constant[k] }).collect();
    Conditions { balance, signs }
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// The solution of the balance in exact arithmetic; `None` if it is not unique.
fn exactly(conditions: &Conditions) -> Option<Vec<BigRational>> {
    let row = |of: &Linear| of.row.iter().map(|x| rational(*x)).chain([-rational(of.constant)]).collect();
    Eliminated::of(conditions.balance.iter().map(row), 6).solution()
}

/// The value of a condition, relative to the sum of the sizes of its terms.
fn value(of: &Linear, at: &DVector<f64>) -> f64 {
    let size = of.row.iter().zip(at).map(|(a, b)| (a * b).abs()).sum::<f64>() + of.constant.abs();
    (of.row.dot(at) + of.constant) / size.max(1e-12)
}

fn at_exactly(of: &Linear, at: &[BigRational]) -> BigRational {
    of.row.iter().zip(at).map(|(a, x)| rational(*a) * x).fold(rational(of.constant), |sum, x| sum + x)
}

/// Whether a combination without a unique motion holds for some motion, in exact arithmetic. Each coordinate is a difference of two nonnegative
/// unknowns.
fn has_a_point(conditions: &Conditions) -> bool {
    let all: Vec<&Linear> = conditions.balance.iter().chain(&conditions.signs).collect();
    let row = |of: &&Linear| {
        of.row.iter().map(|x| rational(*x)).chain(of.row.iter().map(|x| rational(-x))).collect()
    };
    let rows: Vec<Vec<BigRational>> = all.iter().map(row).collect();
    let constants: Vec<_> = all.iter().map(|of| rational(of.constant)).collect();
    let equal: Vec<_> = (0..all.len()).map(|i| i < conditions.balance.len()).collect();
    is_feasible(&rows, &constants, &equal)
}

/// Result of all combinations of states.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Census {
    /// Number of combinations that hold.
    Held(usize),
    /// A condition is met or missed by too little for working precision, or a combination has no unique motion in exact arithmetic.
    Narrow,
}

/// Tries every combination of states.
pub fn census(stack: &Stack<3, 2>) -> Census {
    let choices: Vec<Vec<State>> = stack
        .touches
        .iter()
        .map(|touch| {
            let slides = [State::Slides(1.0), State::Slides(-1.0)];
            let slides = if touch.datum.friction == 0.0 { &[][..] } else { &slides[..] };
            [State::Open, State::Sticks].into_iter().chain(slides.iter().copied()).collect()
        })
        .collect();
    let (mut at, mut held) = (vec![0; choices.len()], 0);
    loop {
        let states: Vec<State> = choices.iter().zip(&at).map(|(list, k)| list[*k]).collect();
        let conditions = conditions(stack, &states);
        let matrix =
            DMatrix::from_rows(&conditions.balance.iter().map(|of| of.row.transpose()).collect::<Vec<_>>());
        let constant = DVector::from_iterator(6, conditions.balance.iter().map(|of| -of.constant));
        let parts = matrix.clone().svd(true, true);
        let (largest, least) = (parts.singular_values.max(), parts.singular_values.min());
        let at_best = parts.solve(&constant, SINGULAR * largest).unwrap();
        let missed =
            (matrix * &at_best - &constant).norm() / (constant.norm() + largest * at_best.norm()).max(1e-12);
        if least > SINGULAR * largest {
            let worst = conditions.signs.iter().map(|of| value(of, &at_best)).fold(f64::INFINITY, f64::min);
            if worst.abs() < NARROW {
                return Census::Narrow;
            }
            if worst > -NEAR {
                let Some(exact) = exactly(&conditions) else { return Census::Narrow };
                held += usize::from(conditions.signs.iter().all(|of| !at_exactly(of, &exact).is_negative()));
            }
        } else if missed < NEAR {
            held += usize::from(has_a_point(&conditions));
        }
        let Some(next) = (0..at.len()).find(|&i| at[i] + 1 < choices[i].len()) else { break };
        at[next] += 1;
        at[..next].fill(0);
    }
    Census::Held(held)
}
