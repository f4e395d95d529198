//! The equilibrium in the contact states that the library returned, solved again in exact arithmetic.
//!
//! The data are equal to the data of the library: every number of the scene, and the contact frames with their rounding
//! ([`Grasp::frames`](grasp_lcp::ask::Grasp::frames)). With the stretch `v = a - Gᵀq` of a contact, where a is its command less its clearance,
//!
//! ```text
//! open                       F = 0
//! sticking                   F = K v
//! frictionless               F = (k_n v_n, 0)
//! sliding along d            F_n = k_n v_n,  F_t = μ F_n d,  K_t (v_t - σ d) = F_t,  d·d = 1
//! balance                    Σ G F + W = 0
//! ```
//!
//! In the plane d = ±1, and all equations are linear in the twist q. In space the direction d and the slip σ of each sliding contact are
//! further unknowns, and the equations are polynomial. Newton's method starts at the library's answer and uses exact residuals, until its
//! steps are below 1e-40 of the unknowns.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium};
use nalgebra::SVector;

use super::dyadic::{Dyadic, solve};
use super::scene::Scene;
use super::truth_equations::{Exactly, Known, dot, equations, norm, unit_wrench};

/// Bits kept of each quotient.
const BITS: u64 = 320;
/// Newton's method ends when its step is below this part of the unknowns.
const SETTLED: f64 = 1e-40;
const STEPS: usize = 12;
/// A value below this fraction of its terms is treated as zero, because it is only the rounding of a division.
const ZERO: f64 = 1e-60;
/// Scale of forces where no contact carries one, relative to the force of the softest spring under the largest displacement.
const NO_FORCE: f64 = 1e-20;
/// For components below this fraction of the largest force no relative error is computed.
const SMALL: f64 = 1e-14;

/// Exact forces and displacements of the contacts in these states.
pub struct Truth<const C: usize> {
    /// Contact forces in the contact frames, N.
    pub forces: Vec<[Dyadic; C]>,
    /// Displacement of the body at the contacts, in the contact frames.
    moved: Vec<[Dyadic; C]>,
    /// Largest force, load included, N; at least 1e-20 of the force of the softest spring under the largest displacement.
    pub largest: f64,
    /// Largest displacement or command, m.
    pub travel: f64,
    /// Conditions of all contacts.
    pub conditions: Vec<Condition>,
}

/// A condition `value >= 0` of the state of a contact.
#[derive(Debug, Clone, Copy)]
pub struct Condition {
    /// Index of the contact.
    pub contact: usize,
    /// Kind of the condition.
    pub kind: Kind,
    /// Value relative to the size of its terms. It is exactly zero, or has the exact sign.
    pub part: f64,
}

/// A condition that a contact must satisfy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// An open contact does not overlap.
    Gap,
    /// A closed contact presses.
    Push,
    /// Friction stays within its limit.
    Margin,
    /// Friction opposes the slip.
    Slip,
}

/// Errors of an answer.
#[derive(Debug, Clone, Copy, Default)]
pub struct Errors {
    /// Largest error of a contact force, relative to the largest force, load included.
    pub force: f64,
    /// Largest error of a force component, relative to that component.
    pub component: f64,
    /// Largest error of the displacement of the body at a contact, relative to the largest displacement or command.
    pub motion: f64,
    /// Largest error of a contact force, N.
    pub newtons: f64,
    /// Largest error of a displacement, m.
    pub metres: f64,
}

impl<const C: usize> Truth<C> {
    /// The exact equilibrium in the states of the answer. `None` if the states do not determine the twist, or Newton's method does not converge.
    pub fn of<const D: usize>(
        scene: &Scene<D, C>,
        grasp: &Grasp<C>,
        answer: &Equilibrium<C>,
    ) -> Option<Self> {
        let mut unknowns = D;
        let contacts: Vec<Known<C>> = (0..scene.contacts.len())
            .map(|i| {
                let (datum, frame) = (&scene.contacts[i], grasp.frames().nth(i).expect("one a contact"));
                let exact =
                    |v: &SVector<f64, C>| -> [Dyadic; C] { std::array::from_fn(|a| Dyadic::new(v[a])) };
                let point = exact(&datum.point);
                let axes =
                    std::array::from_fn(|a| unit_wrench(&point, &exact(&frame.column(a).into_owned())));
                let mut drive = exact(&datum.command);
                drive[0] = &drive[0] - &Dyadic::new(datum.clearance);
                let state = match answer.contacts[i].state {
                    ContactState::Separated => Exactly::Open,
                    ContactState::Sticking => Exactly::Springs(C),
                    ContactState::Frictionless => Exactly::Springs(1),
                    ContactState::Sliding { direction } if C == 2 => {
                        Exactly::Along(Dyadic::new(direction.dot(&frame.column(1)).signum()))
                    }
                    ContactState::Sliding { .. } => {
                        unknowns += 3;
                        Exactly::Turning(unknowns - 3)
                    }
                };
                let mu = datum.friction.is_finite().then(|| Dyadic::new(datum.friction));
                Known { axes, k: exact(&datum.stiffness), mu, drive, state }
            })
            .collect();
        let load: Vec<Dyadic> = scene.load.iter().map(|&x| Dyadic::new(x)).collect();
        let mut z = vec![Dyadic::zero(); unknowns];
        for (k, q) in answer.twist.components().iter().enumerate() {
            z[k] = Dyadic::new(*q);
        }
        for (i, contact) in contacts.iter().enumerate() {
            if let (Exactly::Turning(at), ContactState::Sliding { direction }) =
                (&contact.state, answer.contacts[i].state)
            {
                let d = grasp.frames().nth(i).expect("one a contact").tr_mul(&direction);
                for a in 1..C {
                    z[at + a - 1] = Dyadic::new(d[a]);
                }
                z[at + 2] = Dyadic::new(answer.contacts[i].slip.norm());
            }
        }
        let linear = unknowns == D;
        for _ in 0..STEPS {
            let (matrix, value) = equations::<D, C>(&contacts, &load, &z, !linear);
            let step = solve(&matrix, &value, BITS)?;
            let mut settled = true;
            let longest = z[..D].iter().map(|q| q.float().abs()).fold(0.0, f64::max);
            for (k, (z, step)) in z.iter_mut().zip(&step).enumerate() {
                // Unknowns after the twist come in triples d₁, d₂, σ. Directions have size one; slips are at most about as long as the twist.
                let size = if k < D || (k - D) % 3 == 2 { longest } else { 1.0 };
                settled &= step.float().abs() <= SETTLED * size;
                *z = (&*z - step).rounded(BITS);
            }
            if linear || settled {
                return Some(Self::at(&contacts, &load[..C], &z));
            }
        }
        None
    }

    /// Forces, displacements and conditions at a solution.
    fn at(contacts: &[Known<C>], load: &[Dyadic], z: &[Dyadic]) -> Self {
        let mut truth = Self {
            forces: contacts.iter().map(|contact| contact.force(z)).collect(),
            moved: contacts.iter().map(|c| std::array::from_fn(|a| dot(&c.axes[a], z))).collect(),
            largest: norm(load),
            travel: f64::MIN_POSITIVE,
            conditions: Vec::new(),
        };
        let mut softest = f64::INFINITY;
        for (i, contact) in contacts.iter().enumerate() {
            truth.largest = truth.largest.max(norm(&truth.forces[i]));
            truth.travel = truth.travel.max(norm(&truth.moved[i])).max(norm(&contact.drive));
            softest = contact.k.iter().map(Dyadic::float).fold(softest, f64::min);
        }
        truth.largest = truth.largest.max(NO_FORCE * softest * truth.travel).max(f64::MIN_POSITIVE);
        let largest = truth.largest;
        for (index, contact) in contacts.iter().enumerate() {
            let (force, moved) = (&truth.forces[index], &truth.moved[index]);
            let v: [Dyadic; C] = contact.stretch(z);
            let span = (0..C).map(|a| contact.drive[a].float().abs() + moved[a].float().abs()).sum::<f64>();
            let give = (0..C).map(|a| (force[a].float() / contact.k[a].float()).abs()).sum::<f64>();
            let stiffest = contact.k.iter().map(Dyadic::float).fold(0.0, f64::max);
            let size = norm(force) + largest.min(stiffest * span);
            let mut check = |kind, value: &Dyadic, size: f64| {
                let part = value.float() / size;
                let part = if value.is_zero() || part.abs() < ZERO { 0.0 } else { part };
                truth.conditions.push(Condition { contact: index, kind, part });
            };
            if let Exactly::Open = contact.state {
                check(Kind::Gap, &-&v[0], span);
                continue;
            }
            check(Kind::Push, &force[0], size);
            match (&contact.state, &contact.mu) {
                (Exactly::Springs(axes), Some(mu)) if *axes == C => {
                    // μ N - |F_t| from the difference of squares, so that the sign is exact.
                    let limit = mu * &force[0];
                    let used = force[1..].iter().fold(Dyadic::zero(), |sum, f| &sum + &(f * f));
                    let sum = limit.float().abs() + norm(&force[1..]);
                    if sum > 0.0 {
                        let squares = &(&limit * &limit.abs()) - &used;
                        check(
                            Kind::Margin,
                            &squares.over(&Dyadic::new(sum), BITS),
                            size * (1.0 + mu.float()),
                        );
                    } else {
                        check(Kind::Margin, &Dyadic::zero(), 1.0);
                    }
                }
                (Exactly::Along(d), _) => {
                    let slip = &(d * &v[1]) - &(d * &force[1]).over(&contact.k[1], BITS);
                    check(Kind::Slip, &slip, span + give);
                }
                (Exactly::Turning(at), _) => check(Kind::Slip, &z[at + 2], span + give),
                _ => {}
            }
        }
        truth
    }

    /// Errors of an answer against the exact equilibrium.
    pub fn errors(&self, grasp: &Grasp<C>, answer: &Equilibrium<C>) -> Errors {
        let mut errors = Errors::default();
        for (i, c) in answer.contacts.iter().enumerate() {
            let off: [Dyadic; C] = std::array::from_fn(|a| &Dyadic::new(c.force[a]) - &self.forces[i][a]);
            errors.newtons = errors.newtons.max(norm(&off));
            for (off, exact) in off.iter().zip(&self.forces[i]) {
                let off = off.float().abs();
                if exact.float().abs() > SMALL * self.largest {
                    errors.component = errors.component.max(off / exact.float().abs());
                }
            }
            let frame = grasp.frames().nth(i).expect("one a contact");
            let moved = frame.tr_mul(&c.body_core);
            let off: [Dyadic; C] = std::array::from_fn(|a| &Dyadic::new(moved[a]) - &self.moved[i][a]);
            errors.metres = errors.metres.max(norm(&off));
        }
        (errors.force, errors.motion) = (errors.newtons / self.largest, errors.metres / self.travel);
        errors
    }
}
