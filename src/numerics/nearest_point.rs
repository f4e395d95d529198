//! The closest point Σ s_k a_k of a polyhedral cone with generators a_k to a target t,
//!
//! ```text
//! min |Σ s_k a_k - t|,     s >= 0
//! ```
//!
//! by the active-set method of Lawson and Hanson ("Solving Least Squares Problems", 1974, chapter 23), with an orthogonal factorisation of the active
//! generators. The cone may have infinitely many generators, since the caller supplies the next generator.
//!
//! At the closest point the residual `r = t - Σ s_k a_k` has `a·r <= 0` for every generator a, and `t·r = |r|²`. A nonzero r separates t from
//! the cone.

use super::add_times::add_times;
use super::mapped::{chosen, lowest};
use super::tolerances::LINEARLY_DEPENDENT;
use crate::prelude::*;

/// The closest point of the cone to the target so far: the active generators, each identified by a tag, and their coefficients s.
#[derive(Debug, Clone)]
pub(crate) struct NearestPoint<Tag> {
    size: usize,
    tags: Vec<Tag>,
    coefficients: Vec<f64>,
    residual: Vec<f64>,
    /// The orthonormal factor Q of the matrix of active generators, column after column.
    q: Vec<f64>,
    /// The triangular factor R of the matrix of active generators. Column k, from 0, starts at entry k times `size`, the number of components of the
    /// target.
    r: Vec<f64>,
    /// The components of Qᵀt, one per column of Q, with the target t: the point whose closest point in the cone is sought.
    components: Vec<f64>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sums, whole) = ([0.0; 4], a.len() / 4 * 4);
    for (x, y) in a[..whole].chunks_exact(4).zip(b[..whole].chunks_exact(4)) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + crate::numerics::dot(&a[whole..], &b[whole..])
}

impl<Tag: Copy + PartialEq> NearestPoint<Tag> {
    /// Starts at the apex of the cone, without active generators.
    pub(crate) fn new(target: &[f64]) -> Self {
        let size = target.len();
        let (tags, coefficients, residual) = (Vec::new(), Vec::new(), target.to_vec());
        Self { size, tags, coefficients, residual, q: Vec::new(), r: Vec::new(), components: Vec::new() }
    }

    /// The residual: the target minus the closest point so far, `t - Σ s_k a_k`.
    pub(crate) fn residual(&self) -> &[f64] {
        &self.residual
    }

    /// Norm of the residual: the distance of the target from the closest point so far.
    pub(crate) fn distance(&self) -> f64 {
        dot(&self.residual, &self.residual).sqrt()
    }

    /// Tags and coefficients of the active generators.
    pub(crate) fn coefficients(&self) -> impl Iterator<Item = (Tag, f64)> {
        self.tags.iter().copied().zip(self.coefficients.iter().copied())
    }

    pub(crate) fn has(&self, tag: Tag) -> bool {
        self.tags.contains(&tag)
    }

    /// Removes the generators whose tag satisfies `which`. [`Self::move_to_closest`] must then find the closest point again.
    pub(crate) fn remove_tags(&mut self, which: impl Fn(Tag) -> bool) {
        for k in (0..self.tags.len()).rev() {
            if which(self.tags[k]) {
                self.remove(k);
            }
        }
    }

    /// Adds a generator of length at most one, with coefficient zero. Returns false, and adds nothing, if the generator depends linearly on the
    /// active generators.
    pub(crate) fn add_generator(&mut self, tag: Tag, generator: &[f64], target: &[f64]) -> bool {
        let (m, k) = (self.size, self.tags.len());
        if k == m {
            return false;
        }
        let (from, to) = (m * k, m * (k + 1));
        self.q.extend_from_slice(generator);
        self.r.resize(to, 0.0);
        let (before, w) = self.q.split_at_mut(from);
        let column = &mut self.r[from..to];
        let mut length = 1.0;
        // The projection of the generator onto the active generators is subtracted from it. If this shortens the generator more than tenfold,
        // cancellation has cost digits, and the projection of what is left is subtracted again. Two subtractions suffice for an independent
        // generator. What is left of a dependent generator is only rounding; the third subtraction is the last.
        for _ in 0..3 {
            for (entry, q) in column.iter_mut().zip(before.chunks_exact(m)) {
                let h = dot(q, w);
                *entry += h;
                add_times(w, q, -h);
            }
            let left = dot(w, w).sqrt();
            // A column that keeps at least this fraction of its length when the projection is subtracted has lost at most one digit.
            let done = left > 0.1 * length;
            length = left;
            if done {
                break;
            }
        }
        if length <= LINEARLY_DEPENDENT {
            self.q.truncate(from);
            self.r.truncate(from);
            return false;
        }
        for x in w.iter_mut() {
            *x /= length;
        }
        column[k] = length;
        self.components.push(dot(w, target));
        self.tags.push(tag);
        self.coefficients.push(0.0);
        true
    }

    /// Moves to the closest point of the cone of the active generators, and removes generators whose coefficient becomes zero.
    pub(crate) fn move_to_closest(&mut self, target: &[f64]) {
        loop {
            let unconstrained = self.unbounded();
            let blocking = chosen(unconstrained.len(), &|k| unconstrained[*k] <= 0.0);
            let part = |k: usize| {
                let coefficient = self.coefficients[k];
                if coefficient > 0.0 { coefficient / (coefficient - unconstrained[k]) } else { 0.0 }
            };
            let Some(&first) = lowest(&blocking, &|k| part(*k)) else {
                self.coefficients = unconstrained;
                break;
            };
            let part = part(first);
            for (coefficient, to) in self.coefficients.iter_mut().zip(&unconstrained) {
                *coefficient += part * (to - *coefficient);
            }
            self.remove(first);
        }
        self.residual.copy_from_slice(target);
        for (q, h) in self.q.chunks_exact(self.size).zip(&self.components) {
            add_times(&mut self.residual, q, -h);
        }
        // The projection on the columns of Q is subtracted a second time. Even a small residual is then orthogonal to them, relative to its own
        // length.
        for q in self.q.chunks_exact(self.size) {
            let h = dot(q, &self.residual);
            add_times(&mut self.residual, q, -h);
        }
    }

    /// The least-squares coefficients of the active generators without the condition s >= 0.
    fn unbounded(&self) -> Vec<f64> {
        let mut coefficients = self.components.clone();
        for j in (0..coefficients.len()).rev() {
            let column = &self.r[self.size * j..][..=j];
            coefficients[j] /= column[j];
            let (above, at) = coefficients.split_at_mut(j);
            add_times(above, column, -at[0]);
        }
        coefficients
    }

    /// Removes column k of the factors Q and R; Givens rotations restore the triangular form of R.
    fn remove(&mut self, k: usize) {
        let (m, last) = (self.size, self.tags.len() - 1);
        self.tags.remove(k);
        self.coefficients.remove(k);
        self.r.copy_within(m * (k + 1).., m * k);
        self.r.truncate(m * last);
        for j in k..last {
            let (a, b) = (self.r[m * j + j], self.r[m * j + j + 1]);
            let h = a.hypot(b);
            let (cos, sin) = if h > 0.0 { (a / h, b / h) } else { (1.0, 0.0) };
            let turn = |x: &mut f64, y: &mut f64| (*x, *y) = (cos * *x + sin * *y, cos * *y - sin * *x);
            for column in self.r[m * j..].chunks_exact_mut(m) {
                let (x, y) = column.split_at_mut(j + 1);
                turn(&mut x[j], &mut y[0]);
            }
            self.r[m * j + j + 1] = 0.0;
            let (q, next) = self.q.split_at_mut(m * (j + 1));
            q[m * j..].iter_mut().zip(&mut next[..m]).for_each(|(x, y)| turn(x, y));
            let (components, next) = self.components.split_at_mut(j + 1);
            turn(&mut components[j], &mut next[0]);
        }
        self.q.truncate(m * last);
        self.components.truncate(last);
    }
}
