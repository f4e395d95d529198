//! States of many contacts, about, by friction whose limits are given.
//!
//! Where the limits r_i of friction do not depend on normal forces all forces come from a convex energy,
//!
//! ```text
//! Σ G_i F_i(a_i - G_iᵀq) + W = 0      where  Σ φ_i(a_i - G_iᵀq) - W·q  is least
//! ```
//!
//! and Newton's method finds it from anywhere: each step keeps a part of the springs that give way, less and less of it as steps get on. Limits that
//! belong to the normal forces there come next, until no contact changes its state. Nothing is concluded from what this ends with: some may be wrong.
//!
//! Source: J. Haslinger, I. Hlaváček, J. Nečas, Numerical methods for unilateral problems in solid mechanics, Handbook of Numerical Analysis IV (1996):
//! friction as a fixed point of problems with given friction.

use super::band_piece::are_many;
use super::problem::Problem;
use crate::contact::{Coulomb, Law, LocalLaw, Mode, State};
use crate::numerics::{PositiveBand, Size, narrow_order, widest};

/// How often limits are given, and how often at first the next ones are taken as they come: later the means do not go to and fro.
const ROUNDS: usize = 30;
const AS_THEY_COME: usize = 6;
/// Steps for each limits.
const STEPS: usize = 10;
/// Limits that change by less than this part, without a contact that changes its state, are the last.
const NEARLY: f64 = 1e-4;
/// The part of springs that give way which a step keeps: at first, before each round at least, and at the very least.
const KEPT: [f64; 3] = [0.5, 1e-4, 1e-6];
/// What is out of balance of the load at first when a round ends, and at the very last; and what of the change of limits.
const OUT_OF_BALANCE: [f64; 2] = [1e-2, 1e-9];
const OF_THE_CHANGE: f64 = 0.1;
/// How often a step is shortened, and what is left then of how fast the energy falls along it.
const SHORTENED: usize = 8;
const LEVEL: f64 = 0.1;

/// A contact of the plane whose friction has a limit that is given.
struct Limited {
    stiffness: [f64; 2],
    drive: [f64; 2],
    opens: bool,
    /// The facets on which friction is at its limit backwards and forwards.
    facets: [Option<u16>; 2],
    cone: Coulomb,
    /// Whether the limit is a rate: that may fall.
    is_rate: bool,
}

/// What it does at a stretch.
struct Answer {
    force: [f64; 2],
    /// Along which axes its springs hold.
    holds: [bool; 2],
    state: Mode<u16>,
}

impl Limited {
    /// `None` if it keeps its tangential force until it opens.
    fn of<const C: usize>(local: &LocalLaw<'_, C>, drive: &[f64; 2]) -> Option<Self> {
        if local.is_absent() {
            let (opens, facets) = (false, [None; 2]);
            let cone = local.cone();
            return Some(Self { stiffness: [0.0; 2], drive: *drive, opens, facets, cone, is_rate: false });
        }
        let facet =
            |sign: f64| (0_u16..).zip(local.facets()).find(|(_, h)| sign * h[1] > 0.0).map(|(j, _)| j);
        let (diagonal, facets) = (local.springs.diagonal(), [facet(-1.0), facet(1.0)]);
        let keeps = local.may_open() && diagonal[1] > 0.0 && facets == [None; 2];
        let is_rate = matches!(local.law, Law::Edge(_));
        let stiffness = [diagonal[0], diagonal[1]];
        let opens = local.may_open();
        (!keeps).then(|| Self { stiffness, drive: *drive, opens, facets, cone: local.cone(), is_rate })
    }

    fn answer(&self, stretch: [f64; 2], limit: f64) -> Answer {
        let is_open = self.opens && stretch[0] <= 0.0;
        let (normal, friction) = (self.stiffness[0] * stretch[0], self.stiffness[1] * stretch[1]);
        let [backwards, forwards] = self.facets;
        let (friction, facet) = match (backwards, forwards) {
            (_, Some(facet)) if friction > limit => (limit, Some(facet)),
            (Some(facet), _) if friction < -limit => (-limit, Some(facet)),
            _ => (friction, None),
        };
        let state = if is_open { Mode::Open } else { facet.map_or(Mode::Sticking, Mode::Facet) };
        let force = [if is_open { 0.0 } else { normal }, friction];
        Answer {
            force,
            holds: [!is_open, facet.is_none()],
            state: if self.stiffness == [0.0; 2] { Mode::Open } else { state },
        }
    }

    /// The limit that belongs to a normal force.
    fn limit(&self, normal: f64) -> f64 {
        let limit = self.cone.limit(normal);
        if self.is_rate { limit } else { limit.max(0.0) }
    }
}

/// All contacts, in a narrow order of coordinates.
struct GivenLimits {
    contacts: Vec<Limited>,
    limits: Vec<f64>,
    /// The coordinates that each feels, with its map there.
    felt: Vec<(usize, [f64; 2])>,
    first: Vec<usize>,
    load: Vec<f64>,
    band: PositiveBand,
}

/// What all answer to a motion.
struct Answers {
    of: Vec<Answer>,
    /// What is out of balance.
    left: Vec<f64>,
}

/// States in which forces are nearly balanced, and friction nearly at the limits that belong to them; `None` in space, with few coordinates, where something is
/// free to move, or friction is infinite.
pub(crate) fn states_by_given_limits<D: Size, const C: usize>(
    problem: &Problem<'_, D, C>,
) -> Option<Vec<State<C>>> {
    if C != 2 || problem.round || !are_many(problem.size()) {
        return None;
    }
    let states = GivenLimits::of(problem)?.settled()?;
    let state = |state: Mode<u16>| match state {
        Mode::Open => Mode::Open,
        Mode::Facet(facet) => Mode::Facet(facet),
        _ => Mode::Sticking,
    };
    Some(states.into_iter().map(state).collect())
}

impl GivenLimits {
    fn of<D: Size, const C: usize>(problem: &Problem<'_, D, C>) -> Option<Self> {
        let count = problem.size().count();
        let couplings: Vec<_> = problem.sites.iter().map(|site| site.support.ranges::<C>()).collect();
        let numbers = narrow_order(count, &couplings);
        let band = PositiveBand::zeros(count, widest(&numbers, &couplings));
        let (mut felt, mut first) = (Vec::new(), vec![0]);
        for (site, ranges) in problem.sites.iter().zip(couplings) {
            let entry = |k: usize| (numbers[k], [site.map[(k, 0)], site.map[(k, 1)]]);
            felt.extend(ranges.into_iter().flatten().map(entry));
            first.push(felt.len());
        }
        let contacts = problem.locals().zip(&problem.drives);
        let contacts: Option<Vec<_>> =
            contacts.map(|(local, drive)| Limited::of(&local, &[drive[0], drive[1]])).collect();
        let mut load = vec![0.0; count];
        problem.wrench.iter().zip(&numbers).for_each(|(w, k)| load[*k] = *w);
        Some(Self {
            limits: vec![f64::INFINITY; problem.len()],
            contacts: contacts?,
            felt,
            first,
            load,
            band,
        })
    }

    fn felt(&self, contact: usize) -> &[(usize, [f64; 2])] {
        &self.felt[self.first[contact]..self.first[contact + 1]]
    }

    /// What contacts answer to a motion, by another law of each.
    fn answers_by(&self, q: &[f64], answer: impl Fn(usize, [f64; 2]) -> Answer) -> Answers {
        let (mut of, mut left) = (Vec::with_capacity(self.contacts.len()), self.load.clone());
        for (i, contact) in self.contacts.iter().enumerate() {
            let mut stretch = contact.drive;
            for (k, g) in self.felt(i) {
                (0..2).for_each(|a| stretch[a] -= g[a] * q[*k]);
            }
            let answer = answer(i, stretch);
            for (k, g) in self.felt(i) {
                left[*k] += g[0] * answer.force[0] + g[1] * answer.force[1];
            }
            of.push(answer);
        }
        Answers { of, left }
    }

    fn answers(&self, q: &[f64]) -> Answers {
        self.answers_by(q, |i, stretch| self.contacts[i].answer(stretch, self.limits[i]))
    }

    /// Factors of T with this part of springs that do not hold.
    fn factor(&mut self, answers: &[Answer], kept: f64) -> Option<()> {
        let Self { contacts, felt, first, band, .. } = self;
        band.clear();
        for ((contact, answer), ends) in contacts.iter().zip(answers).zip(first.windows(2)) {
            let k = |a: usize| contact.stiffness[a] * if answer.holds[a] { 1.0 } else { kept };
            let (normal, tangential, felt) = (k(0), k(1), &felt[ends[0]..ends[1]]);
            for (j, h) in felt {
                let pushed = [normal * h[0], tangential * h[1]];
                for (i, g) in felt.iter().filter(|(i, _)| i >= j) {
                    band.add(*i, *j, g[0] * pushed[0] + g[1] * pushed[1]);
                }
            }
        }
        band.factor()
    }

    /// The states in the end.
    fn settled(mut self) -> Option<Vec<Mode<u16>>> {
        let stuck = |contact: &Limited, stretch: [f64; 2]| {
            let force = [contact.stiffness[0] * stretch[0], contact.stiffness[1] * stretch[1]];
            Answer { force, holds: [true; 2], state: Mode::Sticking }
        };
        let mut q = vec![0.0; self.load.len()];
        let mut answers = self.answers_by(&q, |i, stretch| stuck(&self.contacts[i], stretch));
        let size = norm(&answers.left);
        self.factor(&answers.of, 1.0)?;
        q.clone_from(&answers.left);
        self.band.solve(&mut q);
        answers = self.answers_by(&q, |i, stretch| stuck(&self.contacts[i], stretch));
        self.limits = self.limits_of(&answers.of);
        let (mut kept, mut enough) = (KEPT[0], OUT_OF_BALANCE[0] * size);
        let mut states: Vec<Mode<u16>> = Vec::new();
        for round in 0..ROUNDS {
            answers = self.least_energy(&mut q, (&mut kept, enough))?;
            let next = self.limits_of(&answers.of);
            let change: Vec<f64> = next.iter().zip(&self.limits).map(|(next, last)| next - last).collect();
            let change = norm(&change) / norm(&next).max(f64::MIN_POSITIVE);
            let last = std::mem::replace(&mut states, answers.of.iter().map(|answer| answer.state).collect());
            if last == states && change <= NEARLY {
                break;
            }
            let mean =
                |(next, last): (&f64, &f64)| if round < AS_THEY_COME { *next } else { 0.5 * (next + last) };
            self.limits = next.iter().zip(&self.limits).map(mean).collect();
            kept = kept.max(KEPT[1]);
            enough = enough.min(OF_THE_CHANGE * change * size).max(OUT_OF_BALANCE[1] * size);
        }
        Some(states)
    }

    fn limits_of(&self, answers: &[Answer]) -> Vec<f64> {
        self.contacts.iter().zip(answers).map(|(contact, answer)| contact.limit(answer.force[0])).collect()
    }

    /// Newton's method from a motion to that of the least energy with the limits that are given.
    fn least_energy(&mut self, q: &mut Vec<f64>, (kept, enough): (&mut f64, f64)) -> Option<Answers> {
        let mut here = self.answers(q);
        for _ in 0..STEPS {
            if norm(&here.left) <= enough {
                break;
            }
            self.factor(&here.of, *kept)?;
            let mut step = here.left.clone();
            self.band.solve(&mut step);
            let falls = dot(&here.left, &step);
            let mut part = 1.0;
            for shorter in 0.. {
                let next: Vec<f64> = q.iter().zip(&step).map(|(q, step)| q + step * part).collect();
                here = self.answers(&next);
                let rises = -dot(&here.left, &step);
                if rises <= LEVEL * falls || shorter == SHORTENED {
                    *q = next;
                    break;
                }
                part *= (falls / (falls + rises)).clamp(0.1, 0.9);
            }
            if part > 0.5 {
                *kept = (*kept * 0.3).max(KEPT[2]);
            } else if part < 0.2 {
                *kept = (*kept * 4.0).min(1.0);
            }
        }
        Some(here)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(list: &[f64]) -> f64 {
    dot(list, list).sqrt()
}
