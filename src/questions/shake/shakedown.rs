//! The static theorem of shakedown. It gives the greatest factor on repeated loads at which no contact slides under any of the loads, for suitable
//! constant slips of the contacts. Slips are relative tangential displacements at contacts. A drive is the spring of a joint or tendon of a hand,
//! with its force limit.
//!
//! While all contacts are closed and stick with constant slips s, contact forces under the constant base load W₀ plus λ times load W_k are
//! `F(W₀) + λ F(W_k) - P s`. F is the elastic solution for a load, and P s the forces due to slips. If the grasp comes to rest under all loads of a
//! cycle, its slips keep all contact forces inside their cones. Hence the greatest λ for which such an s exists is an upper bound: with a larger λ
//! the grasp never comes to rest. A linear program finds it. The multipliers of the linear program prove that no other slips allow a larger λ.
//!
//! If slips change no normal force, the grasp does come to rest for every λ up to this bound (Melan's theorem for friction). This does not hold if
//! friction falls as contacts slide. If slips change normal forces, the order of the loads matters, too; [`shake`](super) takes it into account.

use nalgebra::{DMatrix, Matrix, SVector};

use crate::contact::{Edges, PolygonCone, PolygonFit};
use crate::equilibrium::{ContactForces, StickingResponse, TooFar};
use crate::error::Error;
use crate::grasp::{Engine, Site, WholeContact, Wrench};
use crate::lcp::{self, quadratic_program};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{
    IntoList, Reals, any_index, chosen, indexed, largest, mapped, matrix_of, moved, total, tried, vector_of,
};
use crate::prelude::*;
use crate::search::Settings;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The greatest factor on repeated loads at which constant slips exist that keep all contacts from sliding: the answer of
/// [`Statics::shakedown`](crate::ask::Statics::shakedown).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Shakedown<const C: usize> {
    /// The greatest factor on the loads; infinite if contacts stick even under loads that cause contact forces a million times as large as those
    /// under the base load. With a larger factor the grasp never comes to rest, in any order of the loads, as long as no contact opens. Linear
    /// programming proves this, up to a relative error of 1e-9.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// Slips of the contacts with which no contact slides under the loads times `factor`, m, in contact frames; their normal components are zero.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<SVector<f64, C>>>"))]
    pub slips: Vec<SVector<f64, C>>,
    /// The contacts at their limit of friction with these slips, each with its load. If the loads grew beyond `factor`, these contacts would slide.
    pub binding: Vec<BindingContact>,
    /// Whether slips change normal forces. If not, the grasp comes to rest under loads up to `factor`, unless friction falls. If slips change normal
    /// forces, the grasp may not come to rest.
    pub slips_change_normal_forces: bool,
    /// Whether some contacts have [less friction](crate::grasp::Contact::kinetic) once they slide. Such a contact may slide past the slips with which
    /// the grasp rests.
    pub friction_falls: bool,
    /// Whether the round friction cones were replaced by polygons around them. The factor is then only an upper bound, even if slips change no normal
    /// force.
    pub around_the_round_cone: bool,
    /// Buckling under the base load or one of the loads while everything sticks, or else a slip in `slips` that is no longer
    /// [small](crate::Settings::small_motions); `None` if neither occurs.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
}

/// A contact that would slide under one of the loads if the loads grew beyond [`Shakedown::factor`].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BindingContact {
    /// The number of the load, from 0; `None` for the base load alone.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub load: Option<usize>,
    /// The contact that is at its limit of friction, or without normal force, under this load.
    pub contact: WholeContact,
    /// Whether the normal force of the contact is zero under this load: with larger loads the contact opens, or goes slack as a rope, instead of
    /// sliding.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub opens: bool,
}

impl<const C: usize> Shakedown<C> {
    /// Whether the grasp comes to rest under this multiple of the loads, in any order. `false` is proved as long as no contact opens. `None` up to
    /// `factor` if slips change normal forces, friction falls or cones are round; [`Grasp::shake`](crate::ask::Grasp::shake) then finds the answer.
    /// `None` also beyond `factor` if a contact that opens limits it.
    #[must_use]
    pub fn rests(&self, times: f64) -> Option<bool> {
        if times > self.factor {
            let is_proved = self.binding.iter().all(|part| !part.opens);
            return is_proved.then_some(false);
        }
        let decides = self.slips_change_normal_forces || self.around_the_round_cone || self.friction_falls;
        (!decides).then_some(true)
    }
}

impl Engine {
    pub(crate) fn shakedown(
        &self,
        base: &Wrench<3>,
        given: &[Wrench<3>],
        settings: &Settings,
    ) -> Result<Option<Shakedown<3>>, Error> {
        let at_rest = self.load_alone(base, "base load")?;
        let loads: Vec<_> = tried(given, &|load| self.inside(load, "load that repeats"))?;
        // The polygonal cones must contain the round cones: only then is the greatest factor an upper bound.
        let around = PolygonCone::new(settings.cone.facets(), PolygonFit::Circumscribed)?;
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
                let forces = without_rounding(&answer);
                normal = normal.max(largest(&forces, &|force| force[0].abs()));
                all = all.max(largest(&forces, &SVector::norm));
                slips.push(((i, axis), forces));
            }
        }
        let program = Program::new(&sticking.edges, &rest.of, &under, &slips.iter().map(|(_, f)| f).list());
        let Some((factor, sizes, multipliers)) = program.solved() else { return Ok(None) };
        let mut residual_slips = none;
        for (((i, axis), _), size) in slips.iter().zip(&sizes) {
            residual_slips[*i][*axis] = *size;
        }
        let most = multipliers.iter().copied().most();
        let (mut binding, most_force) = (Vec::new(), largest(&rest.of, &SVector::norm));
        for k in 0..=under.len() {
            let binds = |i: usize| {
                let of = |((load, site), y): (&(usize, usize), &f64)| {
                    *load == k && *site == i && *y > NEGLIGIBLE * most
                };
                program.of.iter().zip(&multipliers).any(of)
            };
            let normal_force = |i: usize| {
                let of_load = k.checked_sub(1).map_or(0.0, |load| factor * under[load][i][0]);
                rest.of[i][0] + of_load + total(slips.len(), &|slip| sizes[slip] * slips[slip].1[i][0])
            };
            for opens in [false, true] {
                let is_at_zero = |i: usize| normal_force(i) <= NEGLIGIBLE * most_force;
                let of = self.wholes().with(&|i| binds(i) && is_at_zero(i) == opens);
                binding.extend(moved(of, &|contact| BindingContact {
                    load: k.checked_sub(1),
                    contact,
                    opens,
                }));
            }
        }
        let slips_change_normal_forces = normal > SOLVED_ROUNDING * all;
        let around_the_round_cone = settings.is_round(self.space());
        let limit = settings.small_motions.slip * self.size_of_grasp();
        let far = (0..self.len()).find(|i| residual_slips[*i].norm() > limit);
        // Stability is asked under the base load and under each load, while everything sticks.
        let free = sticking.linear_problem.free_motions();
        let unstable = |of_load: Option<(&Vec<SVector<f64, 3>>, &Wrench<3>)>| {
            let load = of_load.map_or(*base, |(_, load)| *base + *load);
            let force = |(i, site): (usize, &Site)| {
                site.frame * (rest.of[i] + of_load.map_or_else(SVector::zeros, |(under, _)| under[i]))
            };
            let forces = indexed(self.sites(), &force);
            if self.may_buckle(&load) && self.buckles(&forces, &|_| false, &load) {
                return Some(TooFar::Buckles);
            }
            self.driven_along(free, &forces, &load).map(|_| TooFar::TurnsOver)
        };
        let under_loads = || under.iter().zip(given).find_map(|pair| unstable(Some(pair)));
        let too_far = unstable(None)
            .or_else(under_loads)
            .or_else(|| far.map(|i| TooFar::Slips { contact: self.wholes().at(i).with(1), limit }));
        Ok(Some(Shakedown {
            factor,
            slips: residual_slips,
            binding,
            slips_change_normal_forces,
            friction_falls: self.weaker_once_they_slide().next().is_some(),
            around_the_round_cone,
            too_far,
        }))
    }
}

/// The forces `forces`, with zero in place of each force that is only rounding. In some grasps, such as two opposite contacts, slips cause no contact
/// forces. If rounding errors were kept, the linear program would scale them up until they balance loads.
fn without_rounding(forces: &ContactForces) -> Vec<SVector<f64, 3>> {
    let size = forces.sizes.iter().copied().most();
    mapped(&forces.of, &|force| if force.norm() > SOLVED_ROUNDING * size { *force } else { SVector::zeros() })
}

/// The linear program for the greatest factor λ >= 0 on the loads with slips s such that `b + λ a + S s >= 0`. Each row is one facet of a contact's
/// cone under one load. It has the margin b under the base load, the change a of the margin due to that load, and the changes S due to unit slips.
/// Here b, a and S are scaled to be near one.
struct Program {
    /// For each row of the program the number of its load, and the index of its contact or drive. Number 0 is the base load alone; other loads are
    /// counted from 1.
    of: Vec<(usize, usize)>,
    b: Vec<f64>,
    a: Vec<f64>,
    s: DMatrix<f64>,
    /// The value of λ, and the value of each slip, m, that correspond to 1 in the scaled program.
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
            // All cones are polygons here, so that every sticking condition `a·F >= 0` is a linear row of the program.
            for (i, edges) in edges.iter().enumerate() {
                let Edges::Rows(facets) = edges else { continue };
                for row in facets {
                    of.push((k, i));
                    b.push(row.dot(&rest[i]) / force);
                    a.push(if k == 0 { 0.0 } else { row.dot(&under[k - 1][i]) * unit / force });
                    for (forces, unit) in slips.iter().zip(&units) {
                        rows.push(row.dot(&forces[i]) * unit / force);
                    }
                }
            }
        }
        let s = DMatrix::from_row_slice(b.len(), slips.len(), &rows);
        Self { of, b, a, s, units: (unit, units) }
    }

    /// The greatest factor λ, the slips, m, and the multipliers of the rows. `None` if no slips keep all contacts from sliding under the base load,
    /// or because of rounding.
    fn solved(&self) -> Option<(f64, Vec<f64>, Vec<f64>)> {
        let (rows, slips) = self.s.shape();
        // λ is bounded so that the program has a solution. A scaled λ at this bound is reported as infinite.
        let farthest = 1e6;
        // The unknowns are at least 0: λ, and each slip as the difference of two unknowns. The last row of the matrix bounds λ.
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
        let kept = |r: usize| self.b[r] + self.a[r] * z[0] + total(slips, &|k| self.s[(r, k)] * size(k));
        let scale = 1.0 + z.amax();
        if any_index(rows, &|r| kept(r) < -NEGLIGIBLE * scale) {
            return None;
        }
        let factor = if z[0] >= farthest * (1.0 - NEGLIGIBLE) { f64::INFINITY } else { z[0] * self.units.0 };
        let sizes = indexed(&self.units.1, &|(k, unit)| size(k) * unit);
        Some((factor, sizes, multipliers.iter().take(rows).copied().list()))
    }
}
