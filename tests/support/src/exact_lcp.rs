//! A complementarity problem solved in exact rational arithmetic, with integers of any size.

use nalgebra::{DMatrix, DVector};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::elimination::Eliminated;

/// Matrix M and vector q as integers. Each row `(M z + q)_i` may be scaled by a power of two, which changes no solution z.
#[derive(Debug, Clone)]
pub struct Exact {
    /// M by rows.
    pub m: Vec<Vec<BigInt>>,
    /// The vector q, one number for each row.
    pub q: Vec<BigInt>,
}

/// The integers (m, e) with x = m 2ᵉ.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, mantissa) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)).cast_signed());
    let (m, e) = if exponent == 0 { (mantissa, -1074) } else { (mantissa | 1 << 52, exponent - 1075) };
    (if x < 0.0 { -m } else { m }, e)
}

impl Exact {
    /// The exact problem of these floating-point numbers.
    pub fn of(m: &DMatrix<f64>, q: &DVector<f64>) -> Self {
        let mut out = Self { m: Vec::new(), q: Vec::new() };
        for i in 0..q.len() {
            let row: Vec<(i64, i32)> = m.row(i).iter().chain([&q[i]]).map(|x| parts(*x)).collect();
            let lowest = row.iter().filter(|(m, _)| *m != 0).map(|(_, e)| *e).min().unwrap_or(0);
            let whole = |(m, e): &(i64, i32)| {
                if *m == 0 { BigInt::zero() } else { BigInt::from(*m) << (e - lowest).unsigned_abs() }
            };
            let mut row: Vec<BigInt> = row.iter().map(whole).collect();
            out.q.push(row.pop().expect("q is the last"));
            out.m.push(row);
        }
        out
    }

    fn len(&self) -> usize {
        self.q.len()
    }

    /// Whether the problem has a solution: whether { z_α ≥ 0, (Mz + q)_α = 0, (Mz + q)_ᾱ ≥ 0 } is not empty for some α.
    /// For a singular block M_αα the simplex method decides whether a solution exists.
    pub fn is_solvable(&self) -> bool {
        (0..1_u32 << self.len()).any(|alpha| {
            let indices: Vec<usize> = (0..self.len()).filter(|i| alpha >> i & 1 == 1).collect();
            match self.exact_point(&indices) {
                Some(z) => self.is_solution(&z),
                None => self.has_point(alpha, alpha),
            }
        })
    }

    /// Whether { z ≥ 0, Mz + q ≥ 0 } is not empty.
    pub fn is_feasible(&self) -> bool {
        self.has_point((1 << self.len()) - 1, 0)
    }

    /// Whether some z ≥ 0 with support in `support` has (Mz + q)_i = 0 for i in `equal` and Mz + q ≥ 0. Both arguments are bit sets.
    pub fn has_point(&self, support: u32, equal: u32) -> bool {
        let rational = |x: &BigInt| BigRational::from_integer(x.clone());
        let columns: Vec<usize> = (0..self.len()).filter(|i| support >> i & 1 == 1).collect();
        let row = |m: &Vec<BigInt>| columns.iter().map(|j| rational(&m[*j])).collect();
        let rows: Vec<Vec<BigRational>> = self.m.iter().map(row).collect();
        let q: Vec<BigRational> = self.q.iter().map(rational).collect();
        let equal: Vec<bool> = (0..self.len()).map(|i| equal >> i & 1 == 1).collect();
        is_feasible(&rows, &q, &equal)
    }

    /// The distinct solutions at regular bases.
    pub fn regular_solutions(&self) -> Vec<Vec<BigRational>> {
        let mut points = Vec::new();
        for bits in 0..1_u32 << self.len() {
            let alpha: Vec<usize> = (0..self.len()).filter(|i| bits >> i & 1 == 1).collect();
            if let Some(z) = self.exact_point(&alpha)
                && self.is_solution(&z)
            {
                points.push(z);
            }
        }
        points.sort();
        points.dedup();
        points
    }

    /// The z with (Mz + q)_α = 0 and zeros outside α, or `None` if M_αα is singular.
    pub fn exact_point(&self, alpha: &[usize]) -> Option<Vec<BigRational>> {
        let row = |i: &usize| alpha.iter().map(|j| self.m[*i][*j].clone()).chain([-&self.q[*i]]).collect();
        let basic = Eliminated::of_whole(alpha.iter().map(row).collect(), alpha.len()).solution()?;
        let mut z = vec![BigRational::zero(); self.len()];
        alpha.iter().zip(basic).for_each(|(i, basic)| z[*i] = basic);
        Some(z)
    }

    /// M z + q.
    pub fn slack(&self, z: &[BigRational]) -> Vec<BigRational> {
        let row = |(m, q): (&Vec<BigInt>, &BigInt)| {
            let w = BigRational::from_integer(q.clone());
            m.iter().zip(z).filter(|(_, z)| !z.is_zero()).fold(w, |w, (m, z)| w + z * m)
        };
        self.m.iter().zip(&self.q).map(row).collect()
    }

    /// Whether z solves the problem exactly.
    pub fn is_solution(&self, z: &[BigRational]) -> bool {
        !z.iter().any(Signed::is_negative)
            && self.slack(z).iter().zip(z).all(|(w, z)| !w.is_negative() && (z.is_zero() || w.is_zero()))
    }
}

/// Whether some x ≥ 0 has (A x + b)_i = 0 for all i with `equal[i]`, and (A x + b)_i ≥ 0 for all other i, by the simplex method.
pub fn is_feasible(a: &[Vec<BigRational>], b: &[BigRational], equal: &[bool]) -> bool {
    let count = a.first().map_or(0, Vec::len);
    let slacks: Vec<usize> = (0..b.len()).filter(|i| !equal[*i]).collect();
    let width = count + slacks.len();
    // Rows of A x − s = −b, with signs such that the right-hand side is not negative. The artificial basis is implicit.
    let mut rows: Vec<Vec<BigRational>> = (0..b.len())
        .map(|i| {
            let slack = slacks.iter().map(|s| BigRational::from_integer(BigInt::from(-i64::from(*s == i))));
            let row = a[i].iter().cloned().chain(slack).chain([-&b[i]]);
            let flip = b[i].is_positive();
            row.map(|x| if flip { -x } else { x }).collect()
        })
        .collect();
    let mut basic: Vec<Option<usize>> = vec![None; b.len()];
    loop {
        let infeasibility = |c: usize| -> BigRational {
            rows.iter().zip(&basic).filter(|(_, b)| b.is_none()).map(|(row, _)| row[c].clone()).sum()
        };
        if infeasibility(width).is_zero() {
            return true;
        }
        // Bland's rule prevents cycling: the first column that reduces infeasibility enters, the smallest basic index of blocking rows leaves.
        let Some(enter) = (0..width).find(|c| infeasibility(*c).is_positive()) else { return false };
        let leave = (0..b.len())
            .filter(|r| rows[*r][enter].is_positive())
            .min_by_key(|r| (&rows[*r][width] / &rows[*r][enter], basic[*r].map_or(usize::MAX, |b| b)))
            .unwrap();
        let scale = rows[leave][enter].clone();
        rows[leave].iter_mut().for_each(|x| *x /= &scale);
        let head = rows[leave].clone();
        for r in (0..b.len()).filter(|r| *r != leave) {
            let f = rows[r][enter].clone();
            if !f.is_zero() {
                rows[r].iter_mut().zip(&head).for_each(|(x, h)| *x -= &f * h);
            }
        }
        basic[leave] = Some(enter);
    }
}
