//! A start for many contacts: semismooth Newton on the return maps.
//!
//! Given the motion q of the object every contact's force is explicit: it sticks, or its force is the nearest one of the cone in the metric of its
//! springs. Equilibrium is then d piecewise linear equations,
//!
//! ```text
//! R(q) = Σ G_i F_i(a_i - G_iᵀq) + W = 0,      T dq = R,   T = Σ G_i (∂F_i/∂v) G_iᵀ
//! ```
//!
//! and where forces balance that is an equilibrium: every inequality of the law is part of the return map. A few steps do at any number of
//! contacts, but it may go round in circles, most often with few contacts, where Lemke's method does not.

use nalgebra::{SMatrix, SVector};

use crate::formulation::{Law, Problem, State, corner};
use crate::numerics::{Bordered, SUMMED_IN_TURN, both};

/// Steps: it converges in a few of them or goes round in circles.
const STEPS: usize = 16;
/// Forces out of balance by less than this part of their sizes balance.
const BALANCED: f64 = 1e-13;

/// Memory of the method.
#[derive(Debug, Clone)]
pub(super) struct Newton<const D: usize, const C: usize> {
    pub(super) twist: SVector<f64, D>,
    pub(super) forces: Vec<SVector<f64, C>>,
    pub(super) states: Vec<Code>,
    kinds: Vec<Kind>,
    /// |R| over the sizes of its terms.
    pub(super) residual: f64,
    pub(super) steps: usize,
}

impl<const D: usize, const C: usize> Default for Newton<D, C> {
    fn default() -> Self {
        Self {
            twist: SVector::zeros(),
            forces: Vec::new(),
            states: Vec::new(),
            kinds: Vec::new(),
            residual: f64::INFINITY,
            steps: 0,
        }
    }
}

/// What a contact may do, in few bytes: the passes over the contacts are as fast as their memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Kind {
    absent: bool,
    opens: bool,
    slides: bool,
}

impl Kind {
    /// `None` for laws of rates.
    fn of<const D: usize, const C: usize>(problem: &Problem<D, C>, contact: usize) -> Option<Self> {
        let absent = match problem.laws[contact] {
            Law::Absent => true,
            Law::Bonded | Law::Cone { .. } => false,
            Law::Edge(_) | Law::Turning { .. } => return None,
        };
        let slides = !problem.normals(contact).is_empty();
        Some(Self { absent, opens: problem.may_open(contact), slides })
    }
}

/// A contact state in a few bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Code {
    Open,
    Rolling,
    Facet(u16),
    /// The corner between this facet and the next.
    Corner(u16),
}

impl Code {
    pub(crate) fn of(state: State) -> Self {
        let number = |j: usize| u16::try_from(j).unwrap_or(u16::MAX);
        match state {
            State::Open => Self::Open,
            State::Rolling => Self::Rolling,
            State::Sliding { first, second: None } => Self::Facet(number(first)),
            State::Sliding { first, second: Some(_) } => Self::Corner(number(first)),
        }
    }

    pub(crate) fn state(self, facets: usize) -> State {
        match self {
            Self::Open => State::Open,
            Self::Rolling => State::Rolling,
            Self::Facet(j) => State::Sliding { first: usize::from(j), second: None },
            Self::Corner(j) => {
                State::Sliding { first: usize::from(j), second: Some((usize::from(j) + 1) % facets) }
            }
        }
    }
}

/// R, the sizes of its terms and T.
struct Tangent<const D: usize> {
    left: SVector<f64, D>,
    size: f64,
    stiffness: SMatrix<f64, D, D>,
    /// No contact that is kept closed pulls while it should carry friction.
    lawful: bool,
}

impl<const D: usize, const C: usize> Newton<D, C> {
    /// Whether it has arrived at an equilibrium from the states in which everything sticks.
    pub(super) fn run(&mut self, problem: &Problem<D, C>) -> bool {
        self.twist.fill(0.0);
        self.residual = f64::INFINITY;
        self.steps = 0;
        self.forces.clear();
        self.states.clear();
        self.kinds.clear();
        for contact in 0..problem.len() {
            let Some(kind) = Kind::of(problem, contact) else { return false };
            self.kinds.push(kind);
        }
        self.forces.resize(problem.len(), SVector::zeros());
        self.states.resize(problem.len(), Code::Rolling);
        let mut here = stick(problem, 0..problem.len());
        here.left += problem.wrench;
        for _ in 0..STEPS {
            self.steps += 1;
            let Some(step) = solve(&here.stiffness, &here.left) else { return false };
            self.twist += step;
            here = self.respond(problem);
            self.residual = here.left.norm() / here.size;
            if self.residual <= BALANCED {
                return here.lawful;
            }
            if !self.residual.is_finite() {
                return false;
            }
        }
        false
    }

    pub(super) fn states(&self, problem: &Problem<D, C>) -> Vec<State> {
        let state = |(contact, code): (usize, &Code)| {
            if problem.laws[contact] == Law::Absent {
                return State::Open;
            }
            code.state(problem.normals(contact).len())
        };
        self.states.iter().enumerate().map(state).collect()
    }

    /// Forces and states at the present twist.
    fn respond(&mut self, problem: &Problem<D, C>) -> Tangent<D> {
        let mut t = respond(problem, &self.twist, 0, &self.kinds, &mut self.states, &mut self.forces);
        t.left += problem.wrench;
        t.size += problem.wrench.norm() + f64::MIN_POSITIVE;
        t
    }
}

/// R without the load and T where everything sticks and the object has not moved.
fn stick<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contacts: std::ops::Range<usize>,
) -> Tangent<D> {
    if contacts.len() > SUMMED_IN_TURN {
        let middle = contacts.start.midpoint(contacts.end);
        let (a, b) = both(
            contacts.len(),
            || stick(problem, contacts.start..middle),
            || stick(problem, middle..contacts.end),
        );
        return a.plus(&b);
    }
    let mut t = Tangent::<D>::zero();
    for contact in contacts {
        if problem.laws[contact] == Law::Absent {
            continue;
        }
        let site = &problem.sites[contact];
        for axis in 0..site.axes {
            let g = site.map.column(axis);
            t.stiffness.ger(site.k[axis], &g, &g, 1.0);
            t.left += g * (site.k[axis] * problem.drives[contact][axis]);
        }
    }
    t
}

/// Forces and states of the contacts from number `first` on at a twist, R without the load and T. Sums are made of halves, so that their
/// rounding grows with the logarithm of their length, and are the same for any number of threads.
fn respond<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    twist: &SVector<f64, D>,
    first: usize,
    kinds: &[Kind],
    states: &mut [Code],
    forces: &mut [SVector<f64, C>],
) -> Tangent<D> {
    if states.len() > SUMMED_IN_TURN {
        let (count, middle) = (states.len(), states.len() / 2);
        let (kinds, more_kinds) = kinds.split_at(middle);
        let (states, more_states) = states.split_at_mut(middle);
        let (forces, more_forces) = forces.split_at_mut(middle);
        let (a, b) = both(
            count,
            || respond(problem, twist, first, kinds, states, forces),
            || respond(problem, twist, first + middle, more_kinds, more_states, more_forces),
        );
        return a.plus(&b);
    }
    let mut t = Tangent::<D>::zero();
    for (contact, (kind, (state, answer))) in (first..).zip(kinds.iter().zip(states.iter_mut().zip(forces))) {
        let site = &problem.sites[contact];
        if kind.absent {
            continue;
        }
        let stretch = problem.drives[contact] - site.map.tr_mul(twist);
        let mut force = site.k.component_mul(&stretch);
        let code = if force[0] <= 0.0 && kind.opens {
            Code::Open
        } else if !kind.slides {
            Code::Rolling
        } else if C == 2 {
            let limit = problem.mu(contact) * force[0];
            if force[1].abs() <= limit { Code::Rolling } else { Code::Facet(u16::from(force[1] < 0.0)) }
        } else {
            nearest(&site.k, &problem.polygon(contact).normals, &force, problem.mu(contact) * force[0])
        };
        t.lawful &= force[0] >= 0.0 || !kind.slides || code == Code::Open;
        let g = site.map.column(0);
        match code {
            Code::Open => force.fill(0.0),
            Code::Rolling => {
                for axis in 0..site.axes {
                    let g = site.map.column(axis);
                    t.stiffness.ger(site.k[axis], &g, &g, 1.0);
                }
            }
            Code::Facet(j) => {
                // F_t = r p + κ d (d·v) with the springs across the slip.
                let (h, mu) = (&problem.polygon(contact).normals[usize::from(j)], problem.mu(contact));
                let softened = site.k.component_mul(h);
                let along = h.dot(&softened);
                let excess = (h.dot(&force) - mu * force[0]) / along;
                force -= softened * excess;
                let mut pushed = softened * (mu / along);
                pushed[0] = 1.0;
                t.stiffness.ger(site.k[0], &(site.map * pushed), &g, 1.0);
                if C == 3 {
                    let mut across = SVector::<f64, C>::zeros();
                    (across[1], across[2]) = (-h[2], h[1]);
                    let held = site.k[1] * (site.k[2] / along);
                    let g = site.map * across;
                    t.stiffness.ger(held, &g, &g, 1.0);
                }
            }
            Code::Corner(j) => {
                let mut pushed =
                    corner_after(&problem.polygon(contact).normals, usize::from(j)) * problem.mu(contact);
                pushed[0] = 1.0;
                force = pushed * force[0];
                t.stiffness.ger(site.k[0], &(site.map * pushed), &g, 1.0);
            }
        }
        t.left += site.map * force;
        t.size += force.norm();
        *state = code;
        *answer = force;
    }
    t
}

impl<const D: usize> Tangent<D> {
    fn zero() -> Self {
        Self { left: SVector::zeros(), size: 0.0, stiffness: SMatrix::zeros(), lawful: true }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            left: self.left + other.left,
            size: self.size + other.size,
            stiffness: self.stiffness + other.stiffness,
            lawful: self.lawful && other.lawful,
        }
    }
}

/// Where on the polygon `h·F_t <= r` the force nearest to a trial force lies, in the metric of the springs.
fn nearest<const C: usize>(
    k: &SVector<f64, C>,
    normals: &[SVector<f64, C>],
    trial: &SVector<f64, C>,
    r: f64,
) -> Code {
    let count = normals.len();
    let (mut facet, mut most) = (0, f64::NEG_INFINITY);
    for (j, h) in normals.iter().enumerate() {
        let reached = h.dot(trial);
        if reached > most {
            (facet, most) = (j, reached);
        }
    }
    if most <= r {
        return Code::Rolling;
    }
    let code = |j: usize| u16::try_from(j).unwrap_or(u16::MAX);
    // From facet to facet towards the side on which the force lies outside: with springs alike the first is the last.
    for _ in 0..count {
        let h = &normals[facet];
        let softened = k.component_mul(h);
        let on_it = trial - softened * ((h.dot(trial) - r) / h.dot(&softened));
        let (next, before) = ((facet + 1) % count, (facet + count - 1) % count);
        let (after_next, before_it) = (normals[next].dot(&on_it) > r, normals[before].dot(&on_it) > r);
        let at = if after_next {
            facet
        } else if before_it {
            before
        } else {
            return Code::Facet(code(facet));
        };
        // At the corner both slips must go outwards.
        let (h1, h2) = (&normals[at], &normals[(at + 1) % count]);
        let rest = trial - corner_after(normals, at) * r;
        let slip = SVector::<f64, C>::from_fn(|a, _| if a == 0 { 0.0 } else { rest[a] / k[a] });
        let turn = h1[1] * h2[2] - h1[2] * h2[1];
        let first = (slip[1] * h2[2] - slip[2] * h2[1]) / turn;
        let second = (h1[1] * slip[2] - h1[2] * slip[1]) / turn;
        if first >= 0.0 && second >= 0.0 {
            return Code::Corner(code(at));
        }
        facet = if after_next { next } else { before };
    }
    Code::Facet(code(facet))
}

/// The corner between a facet and the next.
fn corner_after<const C: usize>(normals: &[SVector<f64, C>], facet: usize) -> SVector<f64, C> {
    corner(&normals[facet], &normals[(facet + 1) % normals.len()])
}

/// T dq = R with the units of the twist taken out; `None` if T is singular.
fn solve<const D: usize>(stiffness: &SMatrix<f64, D, D>, left: &SVector<f64, D>) -> Option<SVector<f64, D>> {
    let unit = SVector::<f64, D>::from_fn(|i, _| {
        let size = stiffness.row(i).amax();
        if size > 0.0 { 1.0 / size.sqrt() } else { 1.0 }
    });
    let scaled = SMatrix::<f64, D, D>::from_fn(|i, j| stiffness[(i, j)] * unit[i] * unit[j]);
    let zero = SVector::zeros();
    let factors = Bordered::new(&scaled, &zero, &zero, 1.0)?;
    Some(factors.solve(&left.component_mul(&unit), 0.0).0.component_mul(&unit))
}
