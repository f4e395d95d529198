//! Affine functions of three unknowns with exact coefficients, and linear algebra on them.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

pub(crate) type Rational = BigRational;

/// A value is close to zero if it is at least this many bits shorter than its largest term: smaller by about 2^-29 = 1.9e-9.
const CLOSE_BITS: u64 = 29;

/// The function `slope·q + constant`. For `q = N/d` it is evaluated in integers as `slope·N + constant d`.
#[derive(Debug, Clone)]
pub(crate) struct Affine<T> {
    pub(crate) slope: [T; 3],
    pub(crate) constant: T,
}

impl<T> Affine<T> {
    pub(crate) fn numbers(&self) -> impl Iterator<Item = &T> {
        self.slope.iter().chain([&self.constant])
    }
}

impl<T> Affine<T>
where
    T: Clone,
    for<'a> &'a T: std::ops::Add<Output = T> + std::ops::Mul<Output = T>,
{
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            slope: std::array::from_fn(|k| &self.slope[k] + &other.slope[k]),
            constant: &self.constant + &other.constant,
        }
    }

    pub(crate) fn scaled(&self, factor: &T) -> Self {
        Self { slope: self.slope.each_ref().map(|s| s * factor), constant: &self.constant * factor }
    }
}

impl Affine<Rational> {
    pub(crate) fn times(&self, scale: &BigInt) -> Affine<BigInt> {
        Affine {
            slope: self.slope.each_ref().map(|s| times(s, scale)),
            constant: times(&self.constant, scale),
        }
    }

    /// The function times the common denominator of its coefficients.
    pub(crate) fn in_integers(&self) -> Affine<BigInt> {
        self.times(&common_denominator(self.numbers()))
    }

    pub(crate) fn at(&self, q: &[Rational; 3]) -> Rational {
        dot(&self.slope, q) + &self.constant
    }
}

impl Affine<BigInt> {
    pub(crate) fn rational(&self) -> Affine<Rational> {
        let whole = |x: &BigInt| Rational::from_integer(x.clone());
        Affine { slope: self.slope.each_ref().map(whole), constant: whole(&self.constant) }
    }

    /// The terms of the value at a point, times the denominator of the point.
    fn terms(&self, q: &Point) -> [BigInt; 4] {
        let along = |k: usize| &self.slope[k] * &q.numerators[k];
        [along(0), along(1), along(2), &self.constant * &q.denominator]
    }

    /// The value at a point, times the denominator of the point.
    pub(crate) fn at(&self, q: &Point) -> BigInt {
        self.terms(q).iter().sum()
    }

    /// Amount by which the value at a point is below zero, relative to the sum of the sizes of its terms; 0 if it is not negative.
    pub(crate) fn missed(&self, q: &Point) -> f64 {
        let terms = self.terms(q);
        let value: BigInt = terms.iter().sum();
        let size: BigInt = terms.iter().map(Signed::abs).sum();
        if value.is_negative() { quotient(-value, size) } else { 0.0 }
    }

    /// The value at a point, times the denominator of the point, and whether it is [close](CLOSE_BITS) to zero.
    pub(crate) fn value_and_closeness(&self, q: &Point) -> (BigInt, bool) {
        let terms = self.terms(q);
        let size = terms.iter().map(BigInt::bits).max().unwrap_or(0);
        let value: BigInt = terms.iter().sum();
        let close = value.bits() + CLOSE_BITS <= size;
        (value, close)
    }
}

/// A point N/d with d > 0. It is not in lowest terms: reducing fractions would cost far more than arithmetic on the larger integers.
#[derive(Debug, Clone)]
pub(crate) struct Point {
    pub(crate) numerators: [BigInt; 3],
    pub(crate) denominator: BigInt,
}

impl Point {
    pub(crate) fn of(q: [f64; 3]) -> Self {
        let q = q.map(rational);
        let denominator = common_denominator(q.iter());
        Self { numerators: q.each_ref().map(|x| times(x, &denominator)), denominator }
    }

    pub(crate) fn floats(&self) -> [f64; 3] {
        self.numerators.each_ref().map(|n| quotient(n.clone(), self.denominator.clone()))
    }

    pub(crate) fn is(&self, other: &Self) -> bool {
        let same =
            |k: usize| &self.numerators[k] * &other.denominator == &other.numerators[k] * &self.denominator;
        (0..3).all(same)
    }
}

/// The nearest floating point number to n/d.
pub(crate) fn quotient(n: BigInt, d: BigInt) -> f64 {
    float(&Rational::new_raw(n, d))
}

/// The point at which all three functions `rows` vanish, by Cramer's rule. `None` if their slopes are linearly dependent.
pub(crate) fn cramer(rows: &[Affine<BigInt>; 3]) -> Option<Point> {
    let [a, b, c] = rows.each_ref().map(|row| &row.slope);
    let cross = |u: &[BigInt; 3], v: &[BigInt; 3]| -> [BigInt; 3] {
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            &u[i] * &v[j] - &u[j] * &v[i]
        })
    };
    let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
    let det: BigInt = (0..3).map(|k| &a[k] * &bc[k]).sum();
    if det.is_zero() {
        return None;
    }
    let flip = det.is_negative();
    let numerators = std::array::from_fn(|k| {
        let n = &bc[k] * &rows[0].constant + &ca[k] * &rows[1].constant + &ab[k] * &rows[2].constant;
        if flip { n } else { -n }
    });
    Some(Point { numerators, denominator: det.abs() })
}

/// The common zeros of three affine functions, after elimination of dependent ones.
pub(crate) struct Consistent {
    /// Independent functions with the same common zeros as the given ones.
    pub(crate) rows: Vec<Affine<BigInt>>,
    /// A point at which all functions vanish.
    pub(crate) point: [Rational; 3],
    /// A basis of the directions along which all functions stay zero.
    pub(crate) directions: Vec<[Rational; 3]>,
}

/// The three functions have no common zero.
pub(crate) struct Contradiction {
    /// Whether the contradiction is smaller than 1e-9 of the terms of the functions, so that rounding could hide it.
    pub(crate) narrow: bool,
}

pub(crate) fn eliminate(rows: &[Affine<BigInt>; 3]) -> Result<Consistent, Contradiction> {
    let sized = |row: &Affine<BigInt>| (row.rational(), row.constant.abs().to_f64().unwrap_or(f64::INFINITY));
    let mut left: Vec<(Affine<Rational>, f64)> = rows.iter().map(sized).collect();
    let mut reduced: Vec<Affine<Rational>> = Vec::new();
    let mut pivots = Vec::new();
    for column in 0..3 {
        let Some(at) = left.iter().position(|(row, _)| !row.slope[column].is_zero()) else { continue };
        let (row, size) = left.swap_remove(at);
        let size = size / float(&row.slope[column]).abs();
        let row = row.scaled(&row.slope[column].recip());
        for (other, other_size) in &mut left {
            *other_size += size * float(&other.slope[column]).abs();
        }
        for other in left.iter_mut().map(|(other, _)| other).chain(&mut reduced) {
            *other = other.plus(&row.scaled(&-other.slope[column].clone()));
        }
        reduced.push(row);
        pivots.push(column);
    }
    if left.iter().any(|(row, _)| !row.constant.is_zero()) {
        let narrow = left.iter().all(|(row, size)| float(&row.constant).abs() <= 1e-9 * size);
        return Err(Contradiction { narrow });
    }
    let mut point: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
    for (row, &column) in reduced.iter().zip(&pivots) {
        point[column] = -&row.constant;
    }
    let free = (0..3).filter(|column| !pivots.contains(column));
    let directions = free.map(|column| {
        let mut direction: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
        direction[column] = Rational::one();
        for (row, &pivot) in reduced.iter().zip(&pivots) {
            direction[pivot] = -&row.slope[column];
        }
        direction
    });
    let directions = directions.collect();
    let rows = reduced.iter().map(Affine::in_integers).collect();
    Ok(Consistent { rows, point, directions })
}

/// Whether some x satisfies `along·x + constant >= 0` for every pair (along, constant) of `conditions`, by Fourier-Motzkin elimination.
pub(crate) fn feasible(mut conditions: Vec<(Vec<Rational>, Rational)>, unknowns: usize) -> bool {
    for _ in 0..unknowns {
        let (mut below, mut above, mut rest) = (Vec::new(), Vec::new(), Vec::new());
        for (mut along, constant) in conditions {
            let factor = along.pop().unwrap();
            if factor.is_zero() {
                rest.push((along, constant));
                continue;
            }
            let size = factor.abs();
            let along = along.into_iter().map(|x| x / &size).collect();
            let bound: (Vec<Rational>, Rational) = (along, constant / size);
            if factor.is_positive() { below.push(bound) } else { above.push(bound) }
        }
        for (a, c) in &below {
            for (b, d) in &above {
                rest.push((a.iter().zip(b).map(|(x, y)| x + y).collect(), c + d));
            }
        }
        conditions = rest;
    }
    conditions.iter().all(|(_, constant)| !constant.is_negative())
}

/// The point nearest to `q` at which the independent rows vanish. Distances add squares of metres and radians.
pub(crate) fn project(rows: &[Affine<BigInt>], q: Point) -> Point {
    let dot = |a: &[BigInt; 3], b: &[BigInt; 3]| -> BigInt { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    // Gram-Schmidt, row by row: a step along the part of a row that is orthogonal to all earlier rows keeps those at zero. Each part is
    // multiplied by the denominator instead of divided, so that it stays an integer.
    let mut directions: Vec<[BigInt; 3]> = Vec::new();
    let mut q = q;
    for row in rows {
        let mut direction = row.slope.clone();
        for known in &directions {
            let (part, whole) = (dot(&direction, known), dot(known, known));
            direction = std::array::from_fn(|k| &direction[k] * &whole - &known[k] * &part);
        }
        // `way` is positive: the square of the direction over the factor by which the direction was multiplied.
        let (value, way) = (row.at(&q), dot(&row.slope, &direction));
        q = Point {
            numerators: std::array::from_fn(|k| &q.numerators[k] * &way - &direction[k] * &value),
            denominator: q.denominator * way,
        };
        directions.push(direction);
    }
    q
}

pub(crate) fn dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn rational(x: f64) -> Rational {
    Rational::from_float(x).expect("a finite number")
}

pub(crate) fn float(x: &Rational) -> f64 {
    x.to_f64().unwrap()
}

pub(crate) fn times(x: &Rational, scale: &BigInt) -> BigInt {
    (x * scale).to_integer()
}

/// The least common multiple of the denominators.
pub(crate) fn common_denominator<'a>(numbers: impl Iterator<Item = &'a Rational>) -> BigInt {
    numbers.fold(BigInt::one(), |all, x| {
        let more = Rational::new(x.denom().clone(), all.clone());
        all * more.numer()
    })
}
