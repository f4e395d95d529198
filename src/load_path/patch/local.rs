//! One contact in energy coordinates, and what its law watches.
//!
//! With `x = K^{-1/2}F` and `K^{1/2}Gᵀ = QR`, a contact that keeps its state answers the motion y of the object by
//!
//! ```text
//! x = P u,     u = x⁰ + τ x⁰' - m - Q y
//! ```
//!
//! x⁰ + τ x⁰' is the elastic trial state on the way along a leg, m the slip so far, and P what the state lets through:
//! everything (rolling), nothing (open), what lies along a facet or in a corner of the cone (sliding). A facet is
//! `row·x = κ x_n + c·x_t >= 0` with c of length one; slip on it moves x along (0, c).

use nalgebra::{SMatrix, SVector};

use super::standing::Stand;
use crate::contact::{Mode, PolygonState};

/// A contact on its way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local<const D: usize, const C: usize> {
    /// Q, scaled so that the mean of |Q|² over the contacts is the number of motions that are resisted.
    pub(super) seen: SMatrix<f64, C, D>,
    /// x⁰ at the beginning of the leg.
    pub(super) trial: SVector<f64, C>,
    /// x⁰', from the beginning to the end of the leg.
    pub(super) rate: SVector<f64, C>,
    /// m, without a normal component.
    pub(super) memory: SVector<f64, C>,
    /// |Q|.
    pub(super) width: f64,
    /// Where its facets start in the list of facets: neighbours that are alike share theirs.
    pub(super) facets: u32,
    pub(super) facet_count: u16,
    /// Whether it may open.
    pub(super) gap: bool,
    pub(super) code: PolygonState,
    /// Entries in the queues with another number are of the past.
    pub(super) stamp: u32,
    /// Whether it waits in line for its conditions.
    pub(super) waits: bool,
}

/// A condition of a contact: a facet by its number, the normal force of what has no facet to watch, or the gap of what is
/// open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bound {
    Facet(u16),
    Apex,
}

/// Sum of the sizes of the entries.
pub(super) fn size<const C: usize>(felt: &SVector<f64, C>) -> f64 {
    felt.iter().map(|x| x.abs()).sum()
}

fn cross<const C: usize>(a: &SVector<f64, C>, b: &SVector<f64, C>) -> f64 {
    a[1] * b[2] - a[2] * b[1]
}

fn normal<const C: usize>() -> SVector<f64, C> {
    SVector::from_fn(|a, _| if a == 0 { 1.0 } else { 0.0 })
}

fn tangential<const C: usize>(row: &SVector<f64, C>) -> SVector<f64, C> {
    let mut column = *row;
    column[0] = 0.0;
    column
}

/// The facet after a facet of a cone in space.
fn after(facet: u16, count: usize) -> usize {
    (usize::from(facet) + 1) % count
}

/// x in the corner between a facet and the next for `x_n = 1`.
fn corner<const C: usize>(facets: &[SVector<f64, C>], facet: u16) -> SVector<f64, C> {
    let (a, b) = (&facets[usize::from(facet)], &facets[after(facet, facets.len())]);
    let turn = cross(a, b);
    let mut x = normal::<C>();
    x[1] = (b[0] * a[2] - a[0] * b[2]) / turn;
    x[2] = (a[0] * b[1] - b[0] * a[1]) / turn;
    x
}

impl<const D: usize, const C: usize> Local<D, C> {
    pub(super) fn facets<'f>(&self, all: &'f [SVector<f64, C>]) -> &'f [SVector<f64, C>] {
        &all[self.facets as usize..self.facets as usize + usize::from(self.facet_count)]
    }

    /// u.
    pub(super) fn stretch(&self, y: &SVector<f64, D>, tau: f64) -> SVector<f64, C> {
        self.trial + self.rate * tau - self.memory - self.seen * y
    }

    /// u' for a rate of y.
    pub(super) fn stretch_rate(&self, y_rate: &SVector<f64, D>) -> SVector<f64, C> {
        self.rate - self.seen * y_rate
    }

    /// Size of the terms that u is made of.
    pub(super) fn level(&self, stretch: &SVector<f64, C>, travel: f64) -> f64 {
        self.trial.amax() + self.rate.amax() + self.memory.amax() + stretch.amax() + self.width * travel
    }

    /// The same for u'.
    pub(super) fn rate_level(&self, travel_rate: f64) -> f64 {
        self.rate.amax() + self.width * travel_rate
    }

    /// An upper bound of the gradient of `f·u` in y and the time along the leg, in a unit of `1/pace`.
    pub(super) fn steepest(&self, felt: &SVector<f64, C>, pace: f64) -> f64 {
        felt.norm() * self.width + felt.dot(&self.rate).abs() / pace
    }

    pub(super) fn slides(&self) -> bool {
        self.code.slides()
    }

    /// P.
    pub(super) fn hold(&self, all: &[SVector<f64, C>]) -> SMatrix<f64, C, C> {
        let code = self.code;
        match code {
            Mode::Open => SMatrix::zeros(),
            Mode::Rolling => SMatrix::identity(),
            Mode::Facet(j) => {
                let row = &self.facets(all)[usize::from(j)];
                let mut hold = SMatrix::<f64, C, C>::identity() - tangential(row) * row.transpose();
                if C == 2 {
                    hold[(1, 1)] = 0.0;
                }
                hold
            }
            Mode::Corner(j) => {
                let mut hold = SMatrix::<f64, C, C>::zeros();
                hold.set_column(0, &corner(self.facets(all), j));
                hold
            }
        }
    }

    /// x for a stretch u.
    pub(super) fn force(&self, stretch: &SVector<f64, C>, all: &[SVector<f64, C>]) -> SVector<f64, C> {
        self.hold(all) * stretch
    }

    /// Takes the slip up to here into memory: u becomes x, and that of an open contact keeps its normal part, its gap.
    pub(super) fn remember(&mut self, stretch: &SVector<f64, C>, all: &[SVector<f64, C>]) {
        let x = self.force(stretch, all);
        for axis in 1..C {
            self.memory[axis] += stretch[axis] - x[axis];
        }
    }

    /// Visits the conditions `f·u >= 0` that bound the way of a contact in its state.
    pub(super) fn for_each_bound(
        &self,
        all: &[SVector<f64, C>],
        mut visit: impl FnMut(Bound, &SVector<f64, C>),
    ) {
        let code = self.code;
        match code {
            Mode::Open => visit(Bound::Apex, &-normal::<C>()),
            Mode::Rolling => {
                for (j, row) in (0..).zip(self.facets(all)) {
                    visit(Bound::Facet(j), row);
                }
                if self.facet_count == 0 && self.gap {
                    visit(Bound::Apex, &normal());
                }
            }
            // The facets beside the one on which it slides: all meet at the apex.
            Mode::Facet(j) if C == 3 => {
                let facets = self.facets(all);
                let own = &facets[usize::from(j)];
                let count = facets.len();
                for k in [after(j, count), (usize::from(j) + count - 1) % count] {
                    let felt = facets[k] - own * tangential(own).dot(&facets[k]);
                    visit(Bound::Facet(u16::try_from(k).unwrap_or(u16::MAX)), &felt);
                }
            }
            Mode::Facet(_) | Mode::Corner(_) => visit(Bound::Apex, &normal()),
        }
    }

    /// Visits the slips `f·u >= 0` of a state, at least one if it slides.
    pub(super) fn for_each_slip(
        &self,
        code: PolygonState,
        all: &[SVector<f64, C>],
        mut visit: impl FnMut(&SVector<f64, C>),
    ) {
        let facets = self.facets(all);
        match code {
            Mode::Open | Mode::Rolling => {}
            Mode::Facet(j) => visit(&-facets[usize::from(j)]),
            Mode::Corner(j) => {
                let (a, b) = (&facets[usize::from(j)], &facets[after(j, facets.len())]);
                let (turn, p) = (cross(a, b), corner(facets, j));
                let mut felt = SVector::zeros();
                (felt[0], felt[1], felt[2]) = (cross(&p, b), -b[2], b[1]);
                visit(&(felt / turn));
                (felt[0], felt[1], felt[2]) = (cross(a, &p), a[2], -a[1]);
                visit(&(felt / turn));
            }
        }
    }

    /// How far the rates u' are inside the law of rates in a state, at the condition that they break most; in the size of u'.
    /// What stands on nothing has no conditions, what stands on facets theirs, what stands at the apex all of its law.
    pub(super) fn margin(
        &self,
        stand: &Stand,
        code: PolygonState,
        stretch_rate: &SVector<f64, C>,
        all: &[SVector<f64, C>],
    ) -> f64 {
        let mut least = f64::INFINITY;
        let mut note = |felt: &SVector<f64, C>| least = least.min(felt.dot(stretch_rate) / felt.amax());
        self.for_each_slip(code, all, &mut note);
        if stand.apex && self.gap {
            note(&if code == Mode::Open { -normal::<C>() } else { normal() });
        }
        let facets = self.facets(all);
        let through = |row: &SVector<f64, C>| match code {
            Mode::Rolling => *row,
            Mode::Facet(j) => {
                let own = &facets[usize::from(j)];
                row - own * tangential(own).dot(row)
            }
            Mode::Open | Mode::Corner(_) => SVector::zeros(),
        };
        let mut note_facet = |j: u16| {
            if Mode::Facet(j) != code {
                let felt = through(&facets[usize::from(j)]);
                if felt.amax() > 0.0 {
                    note(&felt);
                }
            }
        };
        if stand.apex {
            (0..self.facet_count).for_each(&mut note_facet);
            // Without a gap row the cone itself asks for a normal force that grows.
            if self.facet_count > 0 && self.slides() && !self.gap {
                note(&normal());
            }
        } else {
            stand.facets().iter().copied().for_each(&mut note_facet);
        }
        least
    }

    /// The state in which the law of rates answers u': the first that breaks no condition, or the one that breaks them
    /// least.
    pub(super) fn answer(
        &self,
        stand: &Stand,
        stretch_rate: &SVector<f64, C>,
        all: &[SVector<f64, C>],
    ) -> PolygonState {
        let mut best = (Mode::Rolling, f64::NEG_INFINITY);
        let mut consider = |code: PolygonState| {
            if best.1 < 0.0 {
                let margin = self.margin(stand, code, stretch_rate, all);
                if margin > best.1 {
                    best = (code, margin);
                }
            }
        };
        consider(Mode::Rolling);
        if stand.apex {
            if self.gap {
                consider(Mode::Open);
            }
            (0..self.facet_count).map(Mode::Facet).for_each(&mut consider);
            if C == 3 {
                (0..self.facet_count).map(Mode::Corner).for_each(&mut consider);
            }
        } else {
            stand.facets().iter().copied().map(Mode::Facet).for_each(&mut consider);
            if let Some(corner) = self.corner_of(stand) {
                consider(corner);
            }
        }
        best.0
    }

    /// The corner between the two facets on which a contact stands.
    fn corner_of(&self, stand: &Stand) -> Option<PolygonState> {
        let [a, b] = *stand.facets() else { return None };
        let count = usize::from(self.facet_count);
        if after(a, count) == usize::from(b) {
            Some(Mode::Corner(a))
        } else {
            (after(b, count) == usize::from(a)).then_some(Mode::Corner(b))
        }
    }

    /// What mostly comes next: what has reached an edge slides along it, what has lost its force opens, what has lost its gap sticks.
    pub(super) fn guess(&self, stand: &Stand) -> PolygonState {
        if stand.apex {
            return match self.code {
                Mode::Open => Mode::Rolling,
                _ if self.gap => Mode::Open,
                code => code,
            };
        }
        match *stand.facets() {
            [] => self.code,
            [j] => Mode::Facet(j),
            _ => self.corner_of(stand).unwrap_or(self.code),
        }
    }
}
