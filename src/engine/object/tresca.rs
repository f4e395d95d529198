//! Approximate contact states (open, sticking, sliding) of many contacts by Tresca friction: each contact has a given largest friction force, its
//! limit, independent of its normal force.
//!
//! If friction limits do not depend on normal forces, each contact force F_i is the gradient of a convex energy φ_i of the stretch. The stretch is
//! `a_i - G_iᵀq`, with the offset a_i (commanded displacement minus clearance and slip), the grasp map G_i and the twist q of the object. Forces
//! balance the load W at the twist that minimises an energy:
//!
//! ```text
//! Σ G_i F_i(a_i - G_iᵀq) + W = 0      at the q for which  Σ φ_i(a_i - G_iᵀq) - W·q  is least
//! ```
//!
//! Newton's method finds the minimum of this energy from any start. As regularisation the Newton matrix keeps a fraction of the stiffness that is
//! lost at sliding and open contacts; as a rule this fraction decreases. From the normal forces F_n at the minimum follow new friction limits μ F_n,
//! and the minimum is computed again. This is repeated in at most 30 rounds, until no contact changes its state and the limits change by at most the
//! fraction 1e-4. The contact states are a proposal: some may be wrong.
//!
//! Source: J. Haslinger, I. Hlaváček, J. Nečas, Numerical methods for unilateral problems in solid mechanics, Handbook of Numerical Analysis IV
//! (1996): friction as a fixed point of problems with given friction.

use nalgebra::{SMatrix, SVector};

use super::banded_tangent::uses_band;
use super::limited::{Limited, LimitedAnswer};
use super::problem::Problem;
use crate::contact::{Mode, State};
use crate::numerics::tolerances::SUFFICIENT_DECREASE;
use crate::numerics::{
    IntoList, PositiveBand, Vector, all_some, by_axis, dot, mapped, moved, narrow_order, paired, widest,
};
use crate::prelude::*;

/// All contacts with given friction limits, N, and the coordinates of the twist in an order in which the stiffness matrix is a narrow band.
struct GivenLimits {
    contacts: Vec<Limited>,
    limits: Vec<f64>,
    /// For each contact in turn, the coordinates that move it. An entry has the position of a coordinate in the order `numbers`, and the displacement
    /// of the contact per unit of this coordinate, in its contact frame.
    coupled: Vec<(usize, SVector<f64, 3>)>,
    /// Position of each coordinate in an order in which the stiffness matrix is a narrow band.
    numbers: Vec<usize>,
    first: Vec<usize>,
    load: Vec<f64>,
    band: PositiveBand,
}

/// The forces and states of all contacts at a twist of the object, if the friction limits are given numbers.
struct ContactResponses {
    of: Vec<LimitedAnswer>,
    /// The imbalance `Σ G_i F_i + W` of the contact forces F_i with grasp maps G_i and the load W.
    imbalance: Vec<f64>,
}

/// Proposed contact states on polygonal friction cones or in the plane. As a rule forces nearly balance in these contact states, and friction limits
/// nearly agree with the normal forces. `None` with fewer than 36 coordinates, too few for a band matrix ([`uses_band`]). Also `None` if nothing
/// resists some motion, or if a contact has infinite friction and may open.
pub(crate) fn states_by_tresca(problem: &Problem<'_>) -> Option<Vec<State>> {
    if !uses_band(problem.size()) {
        return None;
    }
    let (states, _) = GivenLimits::of(problem, true)?.iterated()?;
    let state = |state: Mode<u16>| match state {
        Mode::Open => Mode::Open,
        Mode::Facet(facet) => Mode::Facet(facet),
        Mode::Corner(corner) => Mode::Corner(corner),
        _ => Mode::Sticking,
    };
    Some(moved(states, &state))
}

/// The proposed twist of the object for round friction cones. As a rule forces nearly balance, and friction limits nearly agree with the normal
/// forces. `None` in the cases of [`states_by_tresca`] (few coordinates, unresisted motions, infinite friction), and if friction is not limited by
/// round cones.
pub(crate) fn twist_by_tresca(problem: &Problem<'_>) -> Option<Vector> {
    if !problem.round || !uses_band(problem.size()) {
        return None;
    }
    let limits = GivenLimits::of(problem, false)?;
    let numbers = limits.numbers.clone();
    let (_, q) = limits.iterated()?;
    Some(Vector::from_fn(problem.size(), |k| q[numbers[k]]))
}

impl GivenLimits {
    fn of(problem: &Problem<'_>, on_polygons: bool) -> Option<Self> {
        let count = problem.size().count();
        let couplings: Vec<_> = mapped(problem.sites, &|site| site.support.ranges());
        let numbers = narrow_order(count, &couplings);
        let band = PositiveBand::zeros(count, widest(&numbers, &couplings));
        let (mut coupled, mut first) = (Vec::new(), vec![0]);
        for (site, ranges) in problem.sites.iter().zip(couplings) {
            let entry = |k: usize| (numbers[k], by_axis(|a| site.map[(k, a)]));
            for range in ranges {
                range.map(entry).append_to(&mut coupled);
            }
            first.push(coupled.len());
        }
        let contacts = problem.locals().zip(&problem.offsets);
        let contacts: Option<Vec<_>> =
            all_some(contacts.map(|(local, offset)| Limited::of(&local, offset, on_polygons)));
        let mut load = vec![0.0; count];
        problem.wrench.iter().zip(&numbers).for_each(|(w, k)| load[*k] = *w);
        Some(Self {
            limits: vec![f64::INFINITY; problem.len()],
            contacts: contacts?,
            coupled,
            numbers,
            first,
            load,
            band,
        })
    }

    fn coupled(&self, contact: usize) -> &[(usize, SVector<f64, 3>)] {
        &self.coupled[self.first[contact]..self.first[contact + 1]]
    }

    /// Forces and states of all contacts at the twist `q`. The function `answer(i, stretch)` returns the force and state of contact i.
    fn answers_by(
        &self,
        q: &[f64],
        answer: impl Fn(usize, &SVector<f64, 3>) -> LimitedAnswer,
    ) -> ContactResponses {
        let (mut of, mut imbalance) = (Vec::with_capacity(self.contacts.len()), self.load.clone());
        for (i, contact) in self.contacts.iter().enumerate() {
            let stretch = self.coupled(i).iter().fold(contact.offset, |stretch, (k, g)| stretch - g * q[*k]);
            let answer = answer(i, &stretch);
            for (k, g) in self.coupled(i) {
                imbalance[*k] += g.dot(&answer.force);
            }
            of.push(answer);
        }
        ContactResponses { of, imbalance }
    }

    fn answers(&self, q: &[f64]) -> ContactResponses {
        self.answers_by(q, |i, stretch| self.contacts[i].answer(stretch, self.limits[i]))
    }

    /// Factorises the tangent stiffness of the object, plus the fraction `kept` of the stiffness that is lost at sliding and open contacts
    /// (regularisation). `None` if this matrix is not positive definite.
    fn factor(&mut self, answers: &[LimitedAnswer], kept: f64) -> Option<()> {
        let Self { coupled, first, band, .. } = self;
        band.clear();
        for (answer, ends) in answers.iter().zip(first.windows(2)) {
            let (springs, coupled) =
                (answer.tangent + answer.lost_stiffness * kept, &coupled[ends[0]..ends[1]]);
            for (j, h) in coupled {
                let pushed = springs * h;
                for (i, g) in coupled.iter().filter(|(i, _)| i >= j) {
                    band.add(*i, *j, g.dot(&pushed));
                }
            }
        }
        band.factor()
    }

    /// Iterates friction limits and twist until they agree, in at most 30 rounds. Returns the last contact states and twist; `None` if a stiffness
    /// matrix is not positive definite.
    fn iterated(mut self) -> Option<(Vec<Mode<u16>>, Vec<f64>)> {
        let stuck = |contact: &Limited, stretch: &SVector<f64, 3>| {
            let tangent = SMatrix::from_diagonal(&contact.stiffness);
            LimitedAnswer {
                force: tangent * stretch,
                tangent,
                lost_stiffness: SMatrix::zeros(),
                state: Mode::Sticking,
            }
        };
        let mut q = vec![0.0; self.load.len()];
        let mut answers = self.answers_by(&q, |i, stretch| stuck(&self.contacts[i], stretch));
        let size = norm(&answers.imbalance);
        self.factor(&answers.of, 1.0)?;
        q.clone_from(&answers.imbalance);
        self.band.solve(&mut q);
        answers = self.answers_by(&q, |i, stretch| stuck(&self.contacts[i], stretch));
        self.limits = self.limits_of(&answers.of);
        // The Newton matrix keeps a fraction of the stiffness that is lost at sliding and open contacts (regularisation). The fraction is half at
        // first, and at least 1e-4 at the start of later rounds. In the first round Newton's method ends at a hundredth of the initial imbalance.
        let (mut kept, mut enough) = (0.5, 1e-2 * size);
        let mut states: Vec<Mode<u16>> = Vec::new();
        // In each round the friction limits follow from the normal forces of earlier rounds.
        for round in 0..30 {
            answers = self.least_energy(&mut q, (&mut kept, enough))?;
            let next = self.limits_of(&answers.of);
            let change: Vec<f64> = paired(&next, &self.limits, &|(next, last)| next - last);
            let change = norm(&change) / norm(&next).max(f64::MIN_POSITIVE);
            let last = core::mem::replace(&mut states, mapped(&answers.of, &|answer| answer.state));
            // The rounds end when friction limits change by at most the fraction 1e-4 and no contact changes its state.
            if last == states && change <= 1e-4 {
                break;
            }
            // The first six rounds take the new friction limits; later rounds take the mean with the previous limits, which stops oscillation.
            let mean = |(next, last): (&f64, &f64)| if round < 6 { *next } else { 0.5 * (next + last) };
            self.limits = paired(&next, &self.limits, &mean);
            kept = kept.max(1e-4);
            // In the next round Newton's method ends at a smaller imbalance. It is a tenth of the last relative change of the friction limits, times
            // the initial imbalance, but at least 1e-9 of the initial imbalance.
            enough = enough.min(0.1 * change * size).max(1e-9 * size);
        }
        Some((states, q))
    }

    fn limits_of(&self, answers: &[LimitedAnswer]) -> Vec<f64> {
        self.contacts.iter().zip(answers).map(|(contact, answer)| contact.limit(answer.force[0])).list()
    }

    /// Newton's method from the twist `q` to the least energy with the given friction limits. It ends when the imbalance of forces is at most
    /// `enough`, or after ten steps. `None` if the stiffness matrix is not positive definite.
    fn least_energy(
        &mut self,
        q: &mut Vec<f64>,
        (kept, enough): (&mut f64, f64),
    ) -> Option<ContactResponses> {
        let mut present = self.answers(q);
        // Upper limit of the number of Newton steps for the same friction limits.
        for _ in 0..10 {
            if norm(&present.imbalance) <= enough {
                break;
            }
            self.factor(&present.of, *kept)?;
            let mut step = present.imbalance.clone();
            self.band.solve(&mut step);
            let falls = dot(&present.imbalance, &step);
            let mut part = 1.0;
            for shorter in 0.. {
                let next: Vec<f64> = paired(q, &step, &|(q, step)| q + step * part);
                present = self.answers(&next);
                let rises = -dot(&present.imbalance, &step);
                // Line search: the step is shortened, at most eight times, while the energy Σ φ_i - W·q still rises at the end of the step. A rate of
                // rise up to the fraction `SUFFICIENT_DECREASE` of the initial rate of descent is accepted.
                if rises <= SUFFICIENT_DECREASE * falls || shorter == 8 {
                    *q = next;
                    break;
                }
                part *= (falls / (falls + rises)).clamp(0.1, 0.9);
            }
            if part > 0.5 {
                // After a step of more than half its full length the Newton matrix keeps 0.3 times as much of the lost stiffness, but at least the
                // fraction 1e-6. After a step of less than a fifth it keeps four times as much, so that the next step is safer.
                *kept = (*kept * 0.3).max(1e-6);
            } else if part < 0.2 {
                *kept = (*kept * 4.0).min(1.0);
            }
        }
        Some(present)
    }
}

fn norm(list: &[f64]) -> f64 {
    dot(list, list).sqrt()
}
