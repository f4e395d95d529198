//! Numbers `m 2^e` with integers m and e of any size: every f64 is such a number, and sums, differences and products of them are exact.

use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

/// A number `mantissa 2^exponent`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    /// 0.
    pub fn zero() -> Self {
        Self { mantissa: BigInt::ZERO, exponent: 0 }
    }

    /// The exact value of a finite x.
    pub fn new(x: f64) -> Self {
        assert!(x.is_finite(), "a finite number");
        let bits = x.to_bits();
        let (biased, fraction) = (((bits >> 52) & 0x7ff).cast_signed(), bits & ((1 << 52) - 1));
        let (mantissa, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
        let mantissa = BigInt::from(mantissa);
        let mantissa = if x.is_sign_negative() { -mantissa } else { mantissa };
        Self { mantissa, exponent }.reduced()
    }

    /// The nearest f64, or a neighbour of it; zero below the smallest f64.
    pub fn float(&self) -> f64 {
        let short = self.rounded(60);
        let mantissa = short.mantissa.to_f64().expect("60 bits");
        // The power of two is applied in two factors, because 2^e alone may overflow although the product does not.
        let half = short.exponent / 2;
        let power = |e: i64| 2_f64.powi(i32::try_from(e.clamp(-1100, 1100)).expect("clamped"));
        mantissa * power(half) * power(short.exponent - half)
    }

    /// The number rounded down to a mantissa of `bits` bits.
    pub fn rounded(&self, bits: u64) -> Self {
        let excess = self.mantissa.bits().saturating_sub(bits);
        // A shift of a BigInt rounds downwards, by less than one unit of the last bit.
        Self { mantissa: &self.mantissa >> excess, exponent: self.exponent + excess.cast_signed() }
    }

    /// The quotient `self / other` to about `bits` bits.
    pub fn over(&self, other: &Self, bits: u64) -> Self {
        let shift = (bits + other.mantissa.bits()).saturating_sub(self.mantissa.bits());
        let mantissa = (&self.mantissa << shift) / &other.mantissa;
        Self { mantissa, exponent: self.exponent - other.exponent - shift.cast_signed() }.reduced()
    }

    /// Whether the number is 0.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Whether the number is below 0.
    pub fn is_negative(&self) -> bool {
        self.mantissa.is_negative()
    }

    /// The absolute value.
    pub fn abs(&self) -> Self {
        Self { mantissa: self.mantissa.abs(), exponent: self.exponent }
    }

    /// The same number with a mantissa without trailing zero bits.
    fn reduced(self) -> Self {
        let Some(zeros) = self.mantissa.trailing_zeros() else { return Self::zero() };
        Self { mantissa: self.mantissa >> zeros, exponent: self.exponent + zeros.cast_signed() }
    }

    /// `self 2^-exponent`, an integer if `exponent` is at most the exponent of the number.
    fn integer(&self, exponent: i64) -> BigInt {
        &self.mantissa << (self.exponent - exponent)
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: Self) -> Dyadic {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        Dyadic { mantissa: self.integer(exponent) + other.integer(exponent), exponent }.reduced()
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Self) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        if self.is_zero() || other.is_zero() {
            return Dyadic::zero();
        }
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

/// The solution of `A x = b`, exact up to the final division by the determinant, which keeps `bits` bits. `None` if A is singular.
///
/// Elimination is Bareiss's: each step divides by the previous pivot without a remainder, so that all integers are minors of A and no larger.
pub fn solve(a: &[Vec<Dyadic>], b: &[Dyadic], bits: u64) -> Option<Vec<Dyadic>> {
    let n = b.len();
    // Rows as integers, each scaled by its own power of two.
    let mut rows: Vec<Vec<BigInt>> = a
        .iter()
        .zip(b)
        .map(|(row, b)| {
            let least = row.iter().chain([b]).filter(|x| !x.is_zero()).map(|x| x.exponent).min().unwrap_or(0);
            row.iter().chain([b]).map(|x| if x.is_zero() { BigInt::ZERO } else { x.integer(least) }).collect()
        })
        .collect();
    let mut before = BigInt::from(1);
    for k in 0..n {
        let pivot = (k..n).filter(|&i| !rows[i][k].is_zero()).min_by_key(|&i| rows[i][k].bits())?;
        rows.swap(k, pivot);
        let (done, rest) = rows.split_at_mut(k + 1);
        let top = &done[k];
        for row in rest {
            for j in k + 1..=n {
                row[j] = (&row[j] * &top[k] - &row[k] * &top[j]) / &before;
            }
            row[k] = BigInt::ZERO;
        }
        before.clone_from(&rows[k][k]);
    }
    // x = N / d with d the determinant: back substitution in integers.
    let d = &rows[n - 1][n - 1];
    let mut numerators = vec![BigInt::ZERO; n];
    for i in (0..n).rev() {
        let known: BigInt = (i + 1..n).map(|j| &rows[i][j] * &numerators[j]).sum();
        numerators[i] = (&rows[i][n] * d - known) / &rows[i][i];
    }
    let whole = |m: &BigInt| Dyadic { mantissa: m.clone(), exponent: 0 };
    Some(
        numerators
            .iter()
            .map(|x| if x.is_zero() { Dyadic::zero() } else { whole(x).over(&whole(d), bits) })
            .collect(),
    )
}
