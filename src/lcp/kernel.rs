//! Inner loops of a pivot, in a form that the compiler vectorises (with [`crate::numerics::wide`]). A dictionary is the condensed tableau of one
//! basis, of which only the columns a_j of nonbasic slacks are stored. A pivot with the entering column u adds g_j u to each a_j, with a coefficient
//! g_j for each column. The next entering column is the given vector y minus Σ_j c_j a_j, where y and the c_j are entries of one column of the
//! problem's matrix.

use crate::numerics::{Each, Loop};

/// The update a_j += g_j u of the stored columns, then y −= Σ_j c_j a_j with the updated a_j. Four columns are processed at a time, and each column
/// is read only once.
pub(super) struct UpdateAndCombine<'a> {
    pub(super) columns: &'a mut [f64],
    pub(super) n: usize,
    pub(super) g: &'a [f64],
    pub(super) u: &'a [f64],
    pub(super) c: &'a [f64],
    pub(super) y: &'a mut [f64],
}

impl Loop for UpdateAndCombine<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { columns, n, g, u, c, y } = self;
        let mut blocks = columns.chunks_exact_mut(4 * n.max(1));
        let mut at = 0;
        for block in &mut blocks {
            let (a, rest) = block.split_at_mut(n);
            let (b, rest) = rest.split_at_mut(n);
            let (d, e) = rest.split_at_mut(n);
            let g = [g[at], g[at + 1], g[at + 2], g[at + 3]];
            let c = [c[at], c[at + 1], c[at + 2], c[at + 3]];
            at += 4;
            match (g == [0.0; 4], c == [0.0; 4]) {
                (true, true) => {}
                (true, false) => combine4([a, b, d, e], c, y),
                (false, true) => update4(a, b, d, e, g, u),
                (false, false) => both4(a, b, d, e, g, u, c, y),
            }
        }
        for column in blocks.into_remainder().chunks_exact_mut(n.max(1)) {
            if g[at] != 0.0 {
                add(column, g[at], u);
            }
            if c[at] != 0.0 {
                add(y, -c[at], column);
            }
            at += 1;
        }
    }
}

/// The sum y −= Σ_j c_j a_j over the stored columns a_j. If `SIZES` is true, the sum of magnitudes y += Σ_j |c_j a_j| is computed instead, to which
/// the rounding error of the first sum is proportional.
pub(super) struct Combine<'a, const SIZES: bool> {
    pub(super) columns: &'a [f64],
    pub(super) n: usize,
    pub(super) c: &'a [f64],
    pub(super) y: &'a mut [f64],
}

impl<const SIZES: bool> Loop for Combine<'_, SIZES> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { columns, n, c, y } = self;
        let blocks = columns.chunks_exact(4 * n.max(1));
        let rest = blocks.remainder();
        let mut fours = c.chunks_exact(4);
        for (block, c) in blocks.zip(&mut fours) {
            let (a, tail) = block.split_at(n);
            let (b, tail) = tail.split_at(n);
            let (d, e) = tail.split_at(n);
            let c = [c[0], c[1], c[2], c[3]];
            if SIZES {
                combine4_sizes([a, b, d, e], c.each(f64::abs), y);
            } else if c != [0.0; 4] {
                combine4([a, b, d, e], c, y);
            }
        }
        for (column, c) in rest.chunks_exact(n.max(1)).zip(fours.remainder()) {
            if SIZES {
                for (y, a) in y.iter_mut().zip(column) {
                    *y += c.abs() * a.abs();
                }
            } else if *c != 0.0 {
                add(y, -c, column);
            }
        }
    }
}

/// The update a_j += g_j u of all stored columns.
pub(super) struct Update<'a> {
    pub(super) columns: &'a mut [f64],
    pub(super) n: usize,
    pub(super) g: &'a [f64],
    pub(super) u: &'a [f64],
}

impl Loop for Update<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { columns, n, g, u } = self;
        for (column, g) in columns.chunks_exact_mut(n.max(1)).zip(g) {
            if *g != 0.0 {
                add(column, *g, u);
            }
        }
    }
}

/// The update a += g u of one stored column of a dictionary.
#[inline(always)]
pub(super) fn add(a: &mut [f64], g: f64, u: &[f64]) {
    for (a, u) in a.iter_mut().zip(u) {
        *a += g * u;
    }
}

#[inline(always)]
fn combine4([a, b, d, e]: [&[f64]; 4], c: [f64; 4], y: &mut [f64]) {
    let n = y.len();
    let (a, b, d, e) = (&a[..n], &b[..n], &d[..n], &e[..n]);
    for i in 0..n {
        y[i] -= (c[0] * a[i] + c[1] * b[i]) + (c[2] * d[i] + c[3] * e[i]);
    }
}

#[inline(always)]
fn combine4_sizes([a, b, d, e]: [&[f64]; 4], c: [f64; 4], y: &mut [f64]) {
    let n = y.len();
    let (a, b, d, e) = (&a[..n], &b[..n], &d[..n], &e[..n]);
    for i in 0..n {
        y[i] += (c[0] * a[i].abs() + c[1] * b[i].abs()) + (c[2] * d[i].abs() + c[3] * e[i].abs());
    }
}

#[inline(always)]
fn update4(a: &mut [f64], b: &mut [f64], d: &mut [f64], e: &mut [f64], g: [f64; 4], u: &[f64]) {
    let n = u.len();
    let (a, b, d, e) = (&mut a[..n], &mut b[..n], &mut d[..n], &mut e[..n]);
    for i in 0..n {
        a[i] += g[0] * u[i];
        b[i] += g[1] * u[i];
        d[i] += g[2] * u[i];
        e[i] += g[3] * u[i];
    }
}

#[allow(clippy::too_many_arguments)] // separate slices allow the loop to be vectorised
#[inline(always)]
fn both4(
    a: &mut [f64],
    b: &mut [f64],
    d: &mut [f64],
    e: &mut [f64],
    g: [f64; 4],
    u: &[f64],
    c: [f64; 4],
    y: &mut [f64],
) {
    let n = u.len();
    let (a, b, d, e, y) = (&mut a[..n], &mut b[..n], &mut d[..n], &mut e[..n], &mut y[..n]);
    for i in 0..n {
        let s = a[i] + g[0] * u[i];
        let t = b[i] + g[1] * u[i];
        let v = d[i] + g[2] * u[i];
        let x = e[i] + g[3] * u[i];
        a[i] = s;
        b[i] = t;
        d[i] = v;
        e[i] = x;
        y[i] -= (c[0] * s + c[1] * t) + (c[2] * v + c[3] * x);
    }
}
