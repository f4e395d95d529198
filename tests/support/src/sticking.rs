//! Contact forces of a grasp while all contacts stick, from its springs alone, by the singular value decomposition.
//!
//! These forces minimise the stored energy among all forces that balance the load. With `x = K^{-1/2} F`, `A = K^{1/2} Gᵀ` and
//! `α = K^{1/2} a`,
//!
//! ```text
//! min ½|x - α|²  subject to  Aᵀx = -W          A = U Σ Vᵀ:   x = α - U (Uᵀα + Σ⁻¹ Vᵀ W)
//! ```
//!
//! The decomposition is Jacobi's, by rotations of columns, because it is accurate for rows of very different size. That of nalgebra 0.35 failed
//! for one 6 x 6 grasp matrix among these scenes: the product of its factors had an error of 7e-3.

use nalgebra::{SMatrix, SVector};

use super::scene::{Scene, wrench};

/// Singular values below this part of the largest belong to free motions.
const FREE: f64 = 1e-11;

/// Rotates the columns of A until they are orthogonal: `A V = U Σ`. Returns the rows of U Σ, and V.
fn jacobi<const D: usize>(mut rows: Vec<SVector<f64, D>>) -> (Vec<SVector<f64, D>>, SMatrix<f64, D, D>) {
    let mut v = SMatrix::<f64, D, D>::identity();
    for _ in 0..60 {
        let mut turned = false;
        for p in 0..D {
            for q in p + 1..D {
                let product = |a: usize, b: usize| rows.iter().map(|row| row[a] * row[b]).sum::<f64>();
                let (pp, qq, pq) = (product(p, p), product(q, q), product(p, q));
                if pq.abs() <= 1e-16 * (pp * qq).sqrt() {
                    continue;
                }
                turned = true;
                let cot = (qq - pp) / (2.0 * pq);
                let tan = cot.signum() / (cot.abs() + cot.hypot(1.0));
                let cos = 1.0 / tan.hypot(1.0);
                let turn = |x: &mut f64, y: &mut f64| {
                    (*x, *y) = (cos * (*x - tan * *y), cos * (tan * *x + *y));
                };
                for row in &mut rows {
                    let (mut x, mut y) = (row[p], row[q]);
                    turn(&mut x, &mut y);
                    (row[p], row[q]) = (x, y);
                }
                for row in 0..D {
                    let (mut x, mut y) = (v[(row, p)], v[(row, q)]);
                    turn(&mut x, &mut y);
                    (v[(row, p)], v[(row, q)]) = (x, y);
                }
            }
        }
        if !turned {
            break;
        }
    }
    (rows, v)
}

/// The contact forces with all contacts sticking, each in its contact frame. `None` if the load works on a free motion.
pub fn forces<const D: usize, const C: usize>(scene: &Scene<D, C>) -> Option<Vec<SVector<f64, C>>> {
    let axes: Vec<(usize, usize)> = scene
        .contacts
        .iter()
        .enumerate()
        .flat_map(|(i, datum)| (0..datum.axes()).map(move |a| (i, a)))
        .collect();
    let roots: Vec<f64> = axes.iter().map(|&(i, a)| scene.contacts[i].stiffness[a].sqrt()).collect();
    let row = |(&(i, a), root): (&(usize, usize), &f64)| {
        let datum = &scene.contacts[i];
        wrench::<D, C>(&datum.point, &datum.frame().column(a).into_owned()) * *root
    };
    let (columns, v) = jacobi(axes.iter().zip(&roots).map(row).collect());
    let alpha: Vec<f64> =
        axes.iter().zip(&roots).map(|(&(i, a), root)| root * scene.contacts[i].drive()[a]).collect();
    let sigmas: [f64; D] =
        std::array::from_fn(|k| columns.iter().map(|row| row[k] * row[k]).sum::<f64>().sqrt());
    let largest = sigmas.into_iter().fold(0.0, f64::max);
    let mut x = alpha;
    // Two projections: with large commands on stiff springs the first projection leaves a residual of rounding.
    for _ in 0..2 {
        for (k, &sigma) in sigmas.iter().enumerate() {
            let along = v.column(k).dot(&scene.load);
            if sigma > FREE * largest {
                let u: Vec<f64> = columns.iter().map(|row| row[k] / sigma).collect();
                let change = u.iter().zip(&x).map(|(u, x)| u * x).sum::<f64>() + along / sigma;
                x.iter_mut().zip(&u).for_each(|(x, u)| *x -= u * change);
            } else if along.abs() > 1e-9 * scene.load.norm() {
                return None;
            }
        }
    }
    let mut forces = vec![SVector::zeros(); scene.contacts.len()];
    for ((&(i, a), root), x) in axes.iter().zip(&roots).zip(&x) {
        forces[i][a] = root * x;
    }
    Some(forces)
}
