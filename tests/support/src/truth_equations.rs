//! The law of a contact in a known state and the balance of all contacts, in exact arithmetic, with their derivatives.

use super::dyadic::Dyadic;

/// Bits kept of the matrix of Newton's method. They only affect the speed of convergence, because residuals are exact.
const DIRECTING: u64 = 100;

/// Exact data of a contact, with its state.
pub(crate) struct Known<const C: usize> {
    /// Wrench about the origin of a unit force along each axis.
    pub(crate) axes: [Vec<Dyadic>; C],
    pub(crate) k: [Dyadic; C],
    pub(crate) mu: Option<Dyadic>,
    pub(crate) drive: [Dyadic; C],
    pub(crate) state: Exactly<C>,
}

pub(crate) enum Exactly<const C: usize> {
    Open,
    Springs(usize),
    /// Sliding in the plane, along ±t.
    Along(Dyadic),
    /// Sliding in space: index of its unknowns d₁, d₂, σ.
    Turning(usize),
}

impl<const C: usize> Known<C> {
    pub(crate) fn stretch(&self, z: &[Dyadic]) -> [Dyadic; C] {
        std::array::from_fn(|a| &self.drive[a] - &dot(&self.axes[a], z))
    }

    pub(crate) fn force(&self, z: &[Dyadic]) -> [Dyadic; C] {
        let v = self.stretch(z);
        let mut force: [Dyadic; C] = std::array::from_fn(|_| Dyadic::zero());
        match &self.state {
            Exactly::Open => {}
            Exactly::Springs(axes) => {
                for a in 0..*axes {
                    force[a] = &self.k[a] * &v[a];
                }
            }
            Exactly::Along(d) => {
                force[0] = &self.k[0] * &v[0];
                force[1] = &(self.friction() * d) * &force[0];
            }
            Exactly::Turning(at) => {
                force[0] = &self.k[0] * &v[0];
                let limit = self.friction() * &force[0];
                for a in 1..C {
                    force[a] = &limit * &z[at + a - 1];
                }
            }
        }
        force
    }

    fn friction(&self) -> &Dyadic {
        self.mu.as_ref().unwrap()
    }
}

/// The matrix of derivatives and the residuals of all equations at z. The matrix is rounded if `rounded`.
pub(crate) fn equations<const D: usize, const C: usize>(
    contacts: &[Known<C>],
    load: &[Dyadic],
    z: &[Dyadic],
    rounded: bool,
) -> (Vec<Vec<Dyadic>>, Vec<Dyadic>) {
    let n = z.len();
    let mut value = vec![Dyadic::zero(); n];
    let mut matrix = vec![vec![Dyadic::zero(); n]; n];
    value[..D].clone_from_slice(load);
    // Adds a force s along an axis with wrench g to the balance, where `slope` is the derivative of s by z.
    let mut push = |g: &[Dyadic], s: &Dyadic, slope: &[(usize, Dyadic)], matrix: &mut Vec<Vec<Dyadic>>| {
        for i in 0..D {
            value[i] = &value[i] + &(&g[i] * s);
            for (j, slope) in slope {
                matrix[i][*j] = &matrix[i][*j] + &(&g[i] * slope);
            }
        }
    };
    let by_twist = |g: &[Dyadic], factor: &Dyadic| -> Vec<(usize, Dyadic)> {
        g.iter().enumerate().map(|(j, g)| (j, &-factor * g)).collect()
    };
    let mut own = Vec::new();
    for contact in contacts {
        let (v, force) = (contact.stretch(z), contact.force(z));
        match &contact.state {
            Exactly::Open => {}
            Exactly::Springs(axes) => {
                for a in 0..*axes {
                    push(
                        &contact.axes[a],
                        &force[a],
                        &by_twist(&contact.axes[a], &contact.k[a]),
                        &mut matrix,
                    );
                }
            }
            Exactly::Along(d) => {
                push(&contact.axes[0], &force[0], &by_twist(&contact.axes[0], &contact.k[0]), &mut matrix);
                let drag = &(contact.friction() * d) * &contact.k[0];
                push(&contact.axes[1], &force[1], &by_twist(&contact.axes[0], &drag), &mut matrix);
            }
            Exactly::Turning(at) => {
                push(&contact.axes[0], &force[0], &by_twist(&contact.axes[0], &contact.k[0]), &mut matrix);
                let limit = contact.friction() * &force[0];
                let mut length = -&Dyadic::new(1.0);
                for a in 1..C {
                    let (d, sigma) = (&z[at + a - 1], &z[at + 2]);
                    length = &length + &(d * d);
                    matrix[*at][at + a - 1] = &Dyadic::new(2.0) * d;
                    let drag = &(contact.friction() * d) * &contact.k[0];
                    let mut slope = by_twist(&contact.axes[0], &drag);
                    slope.push((at + a - 1, limit.clone()));
                    push(&contact.axes[a], &force[a], &slope, &mut matrix);
                    // The friction force is that of the springs, stretched by v less the slip σ d: μ N d + k σ d - k v = 0
                    let row = at + a;
                    let k = &contact.k[a];
                    own.push((row, &(&force[a] + &(&(k * sigma) * d)) - &(k * &v[a])));
                    for (j, slope) in slope {
                        matrix[row][j] = slope;
                    }
                    for j in 0..D {
                        matrix[row][j] = &matrix[row][j] + &(k * &contact.axes[a][j]);
                    }
                    matrix[row][at + a - 1] = &matrix[row][at + a - 1] + &(k * sigma);
                    matrix[row][at + 2] = k * d;
                }
                own.push((*at, length));
            }
        }
    }
    for (row, x) in own {
        value[row] = x;
    }
    if rounded {
        for row in &mut matrix {
            for entry in row {
                *entry = entry.rounded(DIRECTING);
            }
        }
    }
    (matrix, value)
}

/// Force and moment about the origin of a unit force along `axis` at `point`.
pub(crate) fn unit_wrench<const C: usize>(point: &[Dyadic; C], axis: &[Dyadic; C]) -> Vec<Dyadic> {
    let moment = |a: usize, b: usize| &(&point[a] * &axis[b]) - &(&point[b] * &axis[a]);
    let mut wrench = axis.to_vec();
    if C == 2 {
        wrench.push(moment(0, 1));
    } else {
        wrench.extend([moment(1, 2), moment(2, 0), moment(0, 1)]);
    }
    wrench
}

/// The scalar product over the length of `a`; further entries of `b` are ignored.
pub(crate) fn dot(a: &[Dyadic], b: &[Dyadic]) -> Dyadic {
    a.iter().zip(b).fold(Dyadic::zero(), |sum, (a, b)| &sum + &(a * b))
}

pub(crate) fn norm(v: &[Dyadic]) -> f64 {
    v.iter().fold(0.0, |h: f64, x| h.hypot(x.float()))
}
