//! The static theorem of shakedown: how large may repeated loads be, if some slips shall keep every contact from sliding under all of them?
//!
//! While all contacts are closed and stick with constant slips s, forces under `W₀ + λ W_k` are `F(W₀) + λ F(W_k) - P s`. F is the elastic answer,
//! and P the forces of slips. If the grasp comes to rest under all loads of a cycle, its slips keep all contact forces inside their cones. So a
//! linear program for the greatest λ with such an s gives an upper bound: beyond it the grasp never comes to rest. Its multipliers prove that no
//! slips do better.
//!
//! If slips change no normal force, the grasp does come to rest up to this λ (Melan's theorem for friction), unless friction falls as contacts slide.
//! Otherwise it depends on the order of the loads, which [`shake`](super) follows.

use nalgebra::{DMatrix, Matrix, SVector};

use crate::contact::{Edges, Fit, PolygonCone};
use crate::equilibrium::StickingResponse;
use crate::error::Error;
use crate::grasp::{Engine, WholeContact, Wrench};
use crate::lcp::{self, quadratic_program};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{IntoList, chosen, indexed, largest, mapped, matrix_of, vector_of};
use crate::prelude::*;
use crate::search::Settings;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Size of repeated loads up to which some slips could keep all contacts from sliding; see [`Statics::shakedown`](crate::ask::Statics::shakedown).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Shakedown<const C: usize> {
    /// The factor on the loads; infinite if nothing slides however large they are. With a larger factor the grasp never comes to rest, in any order
    /// of the loads, as long as no contact opens. This is a proof, by linear programming, up to 1e-9.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// Slips with which nothing slides under the loads times `factor`, m, in contact frames; their normal components are zero.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<SVector<f64, C>>>"))]
    pub slips: Vec<SVector<f64, C>>,
    /// The contacts that would slide first if the loads grew beyond `factor`, each with the load under which it slides.
    pub binding: Vec<BindingContact>,
    /// Whether slips change normal forces. If not, the grasp comes to rest under loads up to `factor`; otherwise it may not.
    pub slips_change_normal_forces: bool,
    /// Whether some contacts have [less friction](crate::grasp::Contact::kinetic) once they slide. Such a contact may slide past the slips at which
    /// it would stay at rest.
    pub friction_falls: bool,
    /// Whether friction is that of a polygon around its round cone. The factor is then only an upper bound, even if slips change no normal force.
    pub around_the_round_cone: bool,
}

/// A contact that would slide.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BindingContact {
    /// The number of the load, from 0; `None` for the load at rest.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub load: Option<usize>,
    /// The contact at its limit of friction.
    pub contact: WholeContact,
}

impl<const C: usize> Shakedown<C> {
    /// Whether the grasp comes to rest under this multiple of the loads, in any order. `false` is a proof as long as no contact opens. `None`: the
    /// order decides, which [`Grasp::shake`](crate::ask::Grasp::shake) follows.
    #[must_use]
    pub fn rests(&self, times: f64) -> Option<bool> {
        if times > self.factor {
            return Some(false);
        }
        let decides = self.slips_change_normal_forces || self.around_the_round_cone || self.friction_falls;
        (!decides).then_some(true)
    }
}

impl Engine {
    /// Implements [`Statics::shakedown`](crate::ask::Statics::shakedown).
    pub(crate) fn shakedown(
        &self,
        base: &Wrench<3>,
        loads: &[Wrench<3>],
        settings: &Settings,
    ) -> Result<Option<Shakedown<3>>, Error> {
        let at_rest = self.load_alone(base, "base load")?;
        let loads: Vec<_> =
            loads.iter().map(|load| self.inside(load, "load that repeats")).collect::<Result<_, _>>()?;
        // An upper bound for rest needs a polygon outside the round cone.
        let around = PolygonCone::new(settings.cone.facets(), Fit::Circumscribed)?;
        let cone = if settings.is_round(self.space()) { around } else { settings.cone };
        let sticking = StickingResponse::new(self, &Settings { cone, ..*settings }.on_the_polygon());
        let Ok(rest) = sticking.forces(&self.offsets(), &at_rest) else { return Ok(None) };
        let (none, nothing) = (vec![SVector::<f64, 3>::zeros(); rest.of.len()], &at_rest * 0.0);
        let mut under = Vec::new();
        for load in &loads {
            let Ok(answer) = sticking.forces(&none, load) else { return Ok(None) };
            under.push(answer.of);
        }
        let mut slips = Vec::new();
        let (mut normal, mut all) = (0.0_f64, 0.0_f64);
        for i in chosen(none.len(), &|i| sticking.law(*i).may_slide()) {
            for axis in 1..self.space().axes() {
                let mut offsets = none.clone();
                offsets[i][axis] = -1.0;
                let Ok(answer) = sticking.forces(&offsets, &nothing) else { return Ok(None) };
                normal = normal.max(largest(&answer.of, &|force| force[0].abs()));
                all = all.max(largest(&answer.of, &SVector::norm));
                slips.push(((i, axis), answer.of));
            }
        }
        let program = Program::new(&sticking.edges, &rest.of, &under, &slips.iter().map(|(_, f)| f).list());
        let Some((factor, sizes, multipliers)) = program.solved() else { return Ok(None) };
        let mut residual_slips = none;
        for (((i, axis), _), size) in slips.iter().zip(&sizes) {
            residual_slips[*i][*axis] = *size;
        }
        let most = multipliers.iter().copied().fold(0.0, f64::max);
        let mut binding = Vec::new();
        for k in 0..=under.len() {
            let binds = |i: usize| {
                let of = |((load, site), y): (&(usize, usize), &f64)| {
                    *load == k && *site == i && *y > NEGLIGIBLE * most
                };
                program.of.iter().zip(&multipliers).any(of)
            };
            let of = self.wholes().with(&binds).into_iter();
            binding.extend(of.map(|contact| BindingContact { load: k.checked_sub(1), contact }));
        }
        let slips_change_normal_forces = normal > SOLVED_ROUNDING * all;
        let around_the_round_cone = settings.is_round(self.space());
        Ok(Some(Shakedown {
            factor,
            slips: residual_slips,
            binding,
            slips_change_normal_forces,
            friction_falls: self.weaker_once_they_slide().next().is_some(),
            around_the_round_cone,
        }))
    }
}

/// The linear program: the greatest λ >= 0 with `b + λ a + S s >= 0`. Row by row b has the forces at rest, a those of one load, and S those of unit
/// slips. All are scaled to numbers near one.
struct Program {
    /// For each row, the number of its load (0 for the load at rest) and the index of its contact or drive.
    of: Vec<(usize, usize)>,
    b: Vec<f64>,
    a: Vec<f64>,
    s: DMatrix<f64>,
    /// The values of λ and of each slip that count as 1 in the scaled program.
    units: (f64, Vec<f64>),
}

impl Program {
    fn new(
        edges: &[Edges],
        rest: &[SVector<f64, 3>],
        under: &[Vec<SVector<f64, 3>>],
        slips: &[&Vec<SVector<f64, 3>>],
    ) -> Self {
        let size = |forces: &[SVector<f64, 3>]| largest(forces, &Matrix::norm);
        let or_one = |x: f64| if x > 0.0 { x } else { 1.0 };
        let force = or_one(size(rest));
        let unit = force / or_one(largest(under, &|forces| size(forces)));
        let units: Vec<f64> = mapped(slips, &|forces| force / or_one(size(forces)));
        let (mut of, mut b, mut a, mut rows) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for k in 0..=under.len() {
            // All cones are polygons here, so that every condition is a linear row.
            for (i, edges) in edges.iter().enumerate() {
                let Edges::Rows(facets) = edges else { continue };
                for row in facets {
                    of.push((k, i));
                    b.push(row.dot(&rest[i]) / force);
                    a.push(if k == 0 { 0.0 } else { row.dot(&under[k - 1][i]) * unit / force });
                    rows.extend(
                        slips.iter().zip(&units).map(|(forces, unit)| row.dot(&forces[i]) * unit / force),
                    );
                }
            }
        }
        let s = DMatrix::from_row_slice(b.len(), slips.len(), &rows);
        Self { of, b, a, s, units: (unit, units) }
    }

    /// The factor, the slips and the multipliers of the rows; `None` if no slips hold the load at rest, or because of rounding.
    fn solved(&self) -> Option<(f64, Vec<f64>, Vec<f64>)> {
        let (rows, slips) = self.s.shape();
        // λ is bounded so that the program has a solution. Loads held up to this multiple count as held at any size.
        let farthest = 1e6;
        // The unknowns are at least 0: λ, and each slip as the difference of two of them. The last row bounds λ.
        let columns = 1 + 2 * slips;
        let entry = |r: usize, k: usize| match k {
            0 if r == rows => -1.0,
            _ if r == rows => 0.0,
            0 => self.a[r],
            k if k <= slips => self.s[(r, k - 1)],
            k => -self.s[(r, k - 1 - slips)],
        };
        let matrix = matrix_of(rows + 1, columns, &entry);
        let right = vector_of(rows + 1, &|r| if r < rows { self.b[r] } else { farthest });
        let cost = vector_of(columns, &|k| if k == 0 { -1.0 } else { 0.0 });
        let [z, multipliers] = quadratic_program(None, &cost, &matrix, &right, &lcp::Settings::default())?;
        let size = |k: usize| z[1 + k] - z[1 + slips + k];
        let kept = |r: usize| {
            self.b[r] + self.a[r] * z[0] + (0..slips).map(|k| self.s[(r, k)] * size(k)).sum::<f64>()
        };
        let scale = 1.0 + z.amax();
        if (0..rows).any(|r| kept(r) < -NEGLIGIBLE * scale) {
            return None;
        }
        let factor = if z[0] >= farthest * (1.0 - NEGLIGIBLE) { f64::INFINITY } else { z[0] * self.units.0 };
        let sizes = indexed(&self.units.1, &|(k, unit)| size(k) * unit);
        Some((factor, sizes, multipliers.iter().take(rows).copied().list()))
    }
}
