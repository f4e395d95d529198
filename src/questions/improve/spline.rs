//! A cubic spline through points with a continuous second derivative, so that its normals and curvatures have no jumps.

use crate::numerics::{IntoList, Reals, by_axis, lowest, numbered};
use nalgebra::{DMatrix, SVector};

use crate::prelude::*;

/// A cubic spline: its points, their parameters `at` (the distance along the polygon through them, m), and its second derivatives `bends` at the
/// points.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spline {
    points: Vec<SVector<f64, 3>>,
    at: Vec<f64>,
    bends: Vec<SVector<f64, 3>>,
    closed: bool,
}

impl Spline {
    /// The spline through these points in order; a closed spline returns to the first point. With fewer than three points it is open.
    pub(super) fn through(mut points: Vec<SVector<f64, 3>>, closed: bool) -> Self {
        let closed = closed && points.len() > 2;
        if let (true, Some(first)) = (closed, points.first().copied()) {
            points.push(first);
        }
        let mut at = vec![0.0];
        at.extend(points.windows(2).scan(0.0, |sum, ends| {
            *sum += (ends[1] - ends[0]).norm();
            Some(*sum)
        }));
        let mut spline = Self { bends: vec![SVector::zeros(); points.len()], points, at, closed };
        spline.bend();
        spline
    }

    /// Computes the second derivatives at the points, such that first derivatives are continuous. The second derivatives are zero at the ends of an
    /// open spline.
    fn bend(&mut self) {
        let n = self.points.len();
        if n < 3 {
            return;
        }
        let step = |k: usize| self.at[k + 1] - self.at[k];
        let slope = |k: usize| (self.points[k + 1] - self.points[k]) / step(k);
        let mut rows = DMatrix::<f64>::zeros(n, n);
        let mut known = DMatrix::<f64>::zeros(n, 3);
        for k in 1..n - 1 {
            (rows[(k, k - 1)], rows[(k, k)], rows[(k, k + 1)]) =
                (step(k - 1), 2.0 * (step(k - 1) + step(k)), step(k));
            known.set_row(k, &((slope(k) - slope(k - 1)) * 6.0).transpose());
        }
        (rows[(0, 0)], rows[(n - 1, n - 1)]) = (1.0, 1.0);
        if self.closed {
            let last = n - 2;
            rows[(0, n - 1)] = -1.0;
            (rows[(n - 1, 0)], rows[(n - 1, 1)]) = (2.0 * (step(last) + step(0)), step(0));
            (rows[(n - 1, last)], rows[(n - 1, n - 1)]) = (step(last), 0.0);
            known.set_row(n - 1, &((slope(0) - slope(last)) * 6.0).transpose());
        }
        if let Some(bends) = rows.lu().solve(&known) {
            self.bends = bends.row_iter().map(|row| by_axis(|axis| row[axis])).list();
        }
    }

    pub(super) fn points(&self) -> &[SVector<f64, 3>] {
        &self.points
    }

    /// The points that the user gave, without the second copy of the first point of a closed spline.
    #[cfg(feature = "serde")]
    pub(crate) fn interpolated_points(&self) -> &[SVector<f64, 3>] {
        &self.points[..self.points.len() - usize::from(self.closed)]
    }

    /// The least distance between consecutive points, m; zero for fewer than two points.
    pub(super) fn least_distance(&self) -> f64 {
        let least = self.at.windows(2).map(|ends| ends[1] - ends[0]).least();
        if self.points.len() < 2 { 0.0 } else { least }
    }

    /// The parameter of the last point, m: the length of the polygon through the points.
    pub(super) fn end(&self) -> f64 {
        self.at.last().copied().unwrap_or(0.0)
    }

    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    /// The parameter `t` moved into the range of the spline: wrapped around if the spline is closed, clamped to its ends if it is open.
    pub(super) fn within(&self, t: f64) -> f64 {
        if self.closed { t.rem_euclid(self.end()) } else { t.clamp(0.0, self.end()) }
    }

    /// The point, m, and its first and second derivatives with respect to the parameter, at the parameter `t`.
    pub(super) fn at(&self, t: f64) -> [SVector<f64, 3>; 3] {
        let k = self.at.partition_point(|at| *at <= t).clamp(1, self.at.len() - 1) - 1;
        let (h, left, right) = (self.at[k + 1] - self.at[k], t - self.at[k], self.at[k + 1] - t);
        let ([p, q], [a, b]) = ([self.points[k], self.points[k + 1]], [self.bends[k], self.bends[k + 1]]);
        let ends = [p / h - a * (h / 6.0), q / h - b * (h / 6.0)];
        let point = (a * right.powi(3) + b * left.powi(3)) / (6.0 * h) + ends[0] * right + ends[1] * left;
        let first = (b * left.powi(2) - a * right.powi(2)) / (2.0 * h) + ends[1] - ends[0];
        [point, first, (a * right + b * left) / h]
    }

    /// The parameter of the point of the spline that is nearest to `point`. In rare cases it is a local minimum of the distance instead.
    pub(super) fn nearest(&self, point: &SVector<f64, 3>) -> f64 {
        // Newton's method on the distance starts from the nearest sample; there are 32 samples between each two consecutive points.
        let pieces = (self.at.len() - 1) * 32;
        let t = |k: usize| self.end() * k as f64 / pieces as f64;
        let square_distance = |t: f64| (self.at(t)[0] - point).norm_squared();
        let samples = numbered(pieces + 1, &t);
        let begin = lowest(&samples, &|t| square_distance(*t)).copied().unwrap_or(0.0);
        let mut best = begin;
        for _ in 0..30 {
            let [at, first, second] = self.at(best);
            let away = at - point;
            let curve = first.norm_squared() + away.dot(&second);
            let next = self.within(best - away.dot(&first) / curve);
            if square_distance(next) >= square_distance(best) || next.is_nan() {
                break;
            }
            best = next;
        }
        best
    }
}
