//! Contact forces while everything sticks, in rational arithmetic: the reference for errors of floating point.
//!
//! Nothing is shared with the library. With one stiffness along all tangents the springs of a contact are `K = k_t I + (k_n - k_t) n nᵀ` in
//! coordinate axes, whatever the tangents. A normal with integer components and an integer length makes K rational. Let a be the command
//! along the normal n, G_i the grasp map, q the twist of the object and W the load.
//!
//! ```text
//! F_i = k_n a n - K_i G_iᵀ q,     Σ G_i F_i + W = 0,     (Σ G_i K_i G_iᵀ) q = W + Σ G_i k_n a n
//! ```

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

type Rational = BigRational;

/// A contact in space whose data are exact.
pub(crate) struct Contact {
    pub(crate) point: [f64; 3],
    /// Normal into the object, of integer length.
    pub(crate) normal: [i32; 3],
    pub(crate) length: i32,
    /// Series stiffness, normal and tangential, N/m.
    pub(crate) stiffness: [f64; 2],
    /// Commanded displacement along the normal, m.
    pub(crate) command: f64,
}

fn exact(x: f64) -> Rational {
    Rational::from_float(x).expect("a finite number")
}

/// The wrench of a unit force along a coordinate axis at a point. It is also the row of G_iᵀ that gives the displacement of the point along
/// this axis.
fn wrench(point: &[Rational; 3], axis: usize) -> [Rational; 6] {
    let unit = |k: usize| Rational::from_integer(i32::from(k == axis).into());
    std::array::from_fn(|row| {
        if row < 3 {
            return unit(row);
        }
        let (i, j) = ((row + 1) % 3, (row + 2) % 3);
        &point[i] * unit(j) - &point[j] * unit(i)
    })
}

/// Contact forces along the coordinate axes, N, rounded to the nearest number; `None` if some motion is free.
pub(crate) fn forces(contacts: &[Contact], load: &[f64; 6]) -> Option<Vec<[f64; 3]>> {
    let mut rows: Vec<Vec<Rational>> = (0..6)
        .map(|row| (0..7).map(|k| if k == 6 { exact(load[row]) } else { Rational::zero() }).collect())
        .collect();
    let mut springs = Vec::new();
    for contact in contacts {
        let point = contact.point.map(exact);
        let n = contact.normal.map(|c| Rational::new(c.into(), contact.length.into()));
        let [kn, kt] = contact.stiffness.map(exact);
        let pressed: [_; 3] = std::array::from_fn(|a| &kn * exact(contact.command) * &n[a]);
        let stiffness = |a: usize, b: usize| {
            let along = (&kn - &kt) * &n[a] * &n[b];
            if a == b { along + &kt } else { along }
        };
        let maps = [0, 1, 2].map(|axis| wrench(&point, axis));
        // The product K Gᵀ of the contact's stiffness and its transposed grasp map, with one row for each coordinate axis.
        let pulls: [[Rational; 6]; 3] = std::array::from_fn(|a| {
            std::array::from_fn(|k| (0..3).map(|b| stiffness(a, b) * &maps[b][k]).sum())
        });
        for (row, equation) in rows.iter_mut().enumerate() {
            for a in 0..3 {
                for k in 0..6 {
                    equation[k] += &maps[a][row] * &pulls[a][k];
                }
                equation[6] += &maps[a][row] * &pressed[a];
            }
        }
        springs.push((pressed, pulls));
    }
    let twist = solve(rows)?;
    let force = |(pressed, pulls): &([Rational; 3], [[Rational; 6]; 3])| {
        [0, 1, 2].map(|a| {
            let moved: Rational = (0..6).map(|k| &pulls[a][k] * &twist[k]).sum();
            (&pressed[a] - moved).to_f64().unwrap_or(f64::NAN)
        })
    };
    Some(springs.iter().map(force).collect())
}

/// Solves linear equations by Gaussian elimination; the last column of `rows` is the right-hand side. `None` for a singular matrix.
fn solve(mut rows: Vec<Vec<Rational>>) -> Option<Vec<Rational>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).find(|&i| !rows[i][k].is_zero())?;
        rows.swap(k, pivot);
        let head = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i == k || row[k].is_zero() {
                continue;
            }
            let factor = &row[k] / &head[k];
            for (x, h) in row.iter_mut().zip(&head).skip(k) {
                *x -= &factor * h;
            }
        }
    }
    Some(rows.iter().enumerate().map(|(k, row)| &row[n] / &row[k]).collect())
}
