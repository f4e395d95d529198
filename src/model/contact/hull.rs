//! Convex hull of all stretches and forces that the contact law allows if only part of the state is known: a convex cone with few generators.
//!
//! A search proves that no equilibrium exists by dividing the states of the contacts into ever smaller sets. A label describes such a set of states
//! of one contact. It fixes whether the contact is open or closed, whether it sticks or slides, and between which angles its friction points.
//!
//! The stretch v of a contact is the displacement of its finger, less clearance and earlier slip, minus the displacement of the object at the
//! contact. The contact law is positively homogeneous: with a stretch v and a force F it also allows every positive multiple of both. This remains
//! true if a label restricts the states. Let K be the diagonal matrix of the contact's stiffnesses, K_t its tangential part, and μ the coefficient of
//! friction. Let e_n be the unit normal, e_t a unit tangent along an axis, and p any unit tangent. In force units `ξ = K v`, the hull is spanned by
//! pairs of ξ and F. Each row has two pairs:
//!
//! ```text
//!                   ξ            F
//! open              -e_n         0                   ±e_t    0
//! sticks             e_n + μ p    e_n + μ p           e_n     e_n
//! slides            e_n + μ p    e_n + μ p           K_t p   0
//! ```
//!
//! The corners of a polygon around the arc of all p that the label allows replace the vectors p. The hull thus contains all stretches and forces that
//! the law allows, and slightly more. If no equilibrium exists with the hulls of all contacts, none exists with the law.

use crate::numerics::{Each, IntoList, by_axis};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI, TAU};

use nalgebra::SVector;

use super::law::{Law, LocalLaw};
use super::tangential::tangential_norm;
use super::tolerances::NARROWEST_ARC;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::prelude::*;

/// A sector of friction directions, from one angle to a larger one, rad. The angles differ by at most a full turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sector {
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// A label: the set of states to which one branch of the search restricts a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Label {
    Anything,
    Open,
    Closed,
    /// The contact sticks or slides, with its friction force in this sector.
    Friction(Sector),
    Sticking(Sector),
    Sliding(Sector),
}

/// A generator of the hull, a pair of stretch and force in energy units: `K^{-1/2}ξ`, with ξ = K v for the stretch v, and `K^{-1/2}F`. It is scaled
/// so that both together have length one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HullRay {
    pub(crate) stretch: SVector<f64, 3>,
    pub(crate) force: SVector<f64, 3>,
}

impl Label {
    /// The sector of friction directions to which the label, a restriction of the contact's states, limits the friction force.
    pub(super) fn sector(&self) -> Sector {
        match self {
            Self::Friction(sector) | Self::Sticking(sector) | Self::Sliding(sector) => *sector,
            Self::Anything | Self::Open | Self::Closed => Sector::FULL_TURN,
        }
    }

    /// Whether the two labels `halves` together allow every state that `self` allows.
    pub(crate) fn is_covered_by(&self, halves: &[Self; 2]) -> bool {
        let joined = |parts: [&Sector; 2]| {
            parts[0]
                .to
                .total_cmp(&parts[1].from)
                .is_eq()
                .then_some(Sector { from: parts[0].from, to: parts[1].to })
        };
        match (self, halves) {
            (Self::Anything, [Self::Open, Self::Closed]) => true,
            (Self::Friction(whole), [Self::Sticking(a), Self::Sliding(b)]) => whole == a && whole == b,
            (Self::Closed, [Self::Friction(a), Self::Friction(b)]) => {
                // The difference between the two angles at the ends of a full turn has a rounding error of up to 1e-14 rad.
                joined([a, b]).is_some_and(|whole| whole.width() >= TAU - 1e-14)
            }
            (Self::Friction(whole), [Self::Friction(a), Self::Friction(b)])
            | (Self::Sticking(whole), [Self::Sticking(a), Self::Sticking(b)])
            | (Self::Sliding(whole), [Self::Sliding(a), Self::Sliding(b)]) => joined([a, b]) == Some(*whole),
            _ => false,
        }
    }
}

impl Sector {
    const FULL_TURN: Self = Self { from: -PI, to: PI };

    /// The unit tangent of the sector with the largest component along a vector.
    pub(super) fn most_along(&self, a: &SVector<f64, 3>) -> SVector<f64, 3> {
        let angle = self.from + self.inside(a[2].atan2(a[1]));
        vector(0.0, on_circle(angle))
    }

    fn width(&self) -> f64 {
        self.to - self.from
    }

    /// The least number of equal parts into which the sector must be divided for each part to be at most `most` wide, rad; never more than 16.
    fn pieces(&self, most: f64) -> u8 {
        (1..16).find(|k| self.width() <= most * f64::from(*k)).unwrap_or(16)
    }

    fn at(&self, middle: f64) -> [Self; 2] {
        [Self { to: middle, ..*self }, Self { from: middle, ..*self }]
    }

    /// Vertices of a polygon that encloses the arc of the unit circle over this sector: the ends of the arc, and intersections of tangents between
    /// them.
    fn around(&self) -> Vec<[f64; 2]> {
        // The arc is divided into equal parts of at most π/8. The tangents at the ends of each part give one vertex.
        let pieces = self.pieces(FRAC_PI_8);
        let half = 0.5 * self.width() / f64::from(pieces);
        let reach = 1.0 / half.cos();
        let corner = |k: u8| on_circle(self.from + f64::from(2 * k + 1) * half).each(|x| x * reach);
        let ends = [self.from, self.to].each(on_circle);
        let mut all = (0..pieces).map(corner).list();
        all.extend(ends);
        all
    }

    /// Directions whose nonnegative combinations include every direction of the sector.
    fn spanned(&self) -> impl Iterator<Item = [f64; 2]> {
        // Neighbouring directions differ by at most 0.6 π. If they differed by a half turn or more, their nonnegative combinations would not include
        // the directions between.
        let pieces = self.pieces(0.6 * PI);
        let step = self.width() / f64::from(pieces);
        let from = self.from;
        (0..=pieces).map(move |k| on_circle(from + step * f64::from(k)))
    }

    /// The angle, rad, from the start of the sector to a direction; for a direction outside the sector, the angle to the nearer end of the sector.
    fn inside(&self, angle: f64) -> f64 {
        let (along, width) = ((angle - self.from).rem_euclid(TAU), self.width());
        if along <= width {
            along
        } else if along - width < TAU - along {
            width
        } else {
            0.0
        }
    }
}

fn on_circle(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

fn vector(normal: f64, tangential: [f64; 2]) -> SVector<f64, 3> {
    by_axis(|a| if a == 0 { normal } else { tangential[a - 1] })
}

const AXES: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

impl LocalLaw<'_> {
    /// The label with which the search over labels begins, before any label is divided.
    pub(crate) fn first_label(&self) -> Label {
        match self.law {
            Law::Absent => Label::Open,
            Law::Cone { gap: true } => Label::Anything,
            _ => Label::Closed,
        }
    }

    /// Generators of the convex hull of all stretches and forces that the contact law allows under a label, i.e. a restriction of the contact's
    /// states.
    pub(crate) fn hull(&self, label: &Label) -> Vec<HullRay> {
        let root = self.springs.root();
        let rubs = self.springs.resists_tangentially();
        let mut rays = Vec::new();
        let mut push = |stretch: SVector<f64, 3>, force: SVector<f64, 3>| {
            let energy =
                |x: &SVector<f64, 3>| by_axis::<3>(|a| if root[a] > 0.0 { x[a] / root[a] } else { 0.0 });
            let (stretch, force) = (energy(&stretch), energy(&force));
            let size = stretch.norm().hypot(force.norm());
            rays.push(HullRay { stretch: stretch / size, force: force / size });
        };
        let (normal, none) = (vector(1.0, [0.0; 2]), SVector::zeros());
        let slips_anyhow = |push: &mut dyn FnMut(SVector<f64, 3>, SVector<f64, 3>)| {
            if rubs {
                for t in AXES {
                    push(vector(0.0, t), none);
                }
            }
        };
        if matches!(label, Label::Anything | Label::Open) {
            push(-normal, none);
            if self.is_absent() {
                push(normal, none);
            }
            slips_anyhow(&mut push);
        }
        if *label == Label::Open {
            return rays;
        }
        if !self.may_slide() {
            push(normal, normal);
            if self.may_pull() {
                push(-normal, -normal);
            }
            if rubs {
                AXES.into_iter().map(|t| vector(0.0, t)).for_each(|t| push(t, t));
            }
            return rays;
        }
        let on_cone = |t: [f64; 2]| self.friction.generator(&vector(0.0, t));
        match label {
            // The label allows slip in any direction, so the tangential stretch is independent of the friction force.
            Label::Anything | Label::Closed => {
                for t in
                    Sector::FULL_TURN.around().into_iter().filter(|t| t[0].hypot(t[1]) > 1.0 + NARROWEST_ARC)
                {
                    push(normal, on_cone(t));
                }
                if *label == Label::Closed {
                    slips_anyhow(&mut push);
                }
            }
            Label::Friction(sector) | Label::Sticking(sector) | Label::Sliding(sector) => {
                for t in sector.around() {
                    push(on_cone(t), on_cone(t));
                }
                if !matches!(label, Label::Sliding(_)) {
                    push(normal, normal);
                }
                if !matches!(label, Label::Sticking(_)) {
                    for t in sector.spanned() {
                        push(self.springs.force(&vector(0.0, t)), none);
                    }
                }
            }
            Label::Open => {}
        }
        rays
    }

    /// Two narrower labels (restrictions of the contact's states) that together allow the same states as `label`. `stretch` and `force` lie in the
    /// hull of `label`, but may violate the contact law, which requires friction along the slip. The division should exclude this pair from both new
    /// hulls.
    ///
    /// A label without a sector is divided into open and closed, or into two sectors of friction directions. A sector of a sticking contact is
    /// halved. Any other sector is cut between the directions of the friction force and of the slip, or halved if it is wide. If the magnitude of the
    /// friction force violates the law more than its direction, the label is divided into sticking and sliding. `None` if the label cannot be
    /// divided.
    pub(crate) fn divide(
        &self,
        label: &Label,
        stretch: &SVector<f64, 3>,
        force: &SVector<f64, 3>,
    ) -> Option<[Label; 2]> {
        let pushed = self.springs.force(stretch);
        let slip = self.springs.slip(stretch, force);
        let (traction, friction) = (tangential_norm(&pushed), tangential_norm(force));
        let angle = |x: &SVector<f64, 3>| x[2].atan2(x[1]);
        // A friction force below the fraction `SOLVED_ROUNDING` of the normal force and of `traction` counts as a rounding error and has no
        // direction. A slip counts as a rounding error if its product with the stiffness is below this fraction of the friction force and of
        // `traction`. `traction` is the tangential force that the springs would have if the contact stuck, N.
        let towards = if friction > SOLVED_ROUNDING * (force[0].abs() + traction) {
            angle(force)
        } else {
            angle(&pushed)
        };
        let slips = tangential_norm(&self.springs.force(&slip)) > SOLVED_ROUNDING * (friction + traction);
        let slides_towards = if slips { angle(&slip) } else { towards };
        match *label {
            Label::Anything => Some([Label::Open, Label::Closed]),
            Label::Open => None,
            Label::Closed if !self.may_slide() => None,
            Label::Closed => {
                let apart = (slides_towards - towards + PI).rem_euclid(TAU) - PI;
                // If the directions of friction and slip differ by less than 0.1 rad, the first cut is made at right angles to these directions.
                let from = towards + if apart.abs() < 0.1 { FRAC_PI_2 } else { 0.5 * apart };
                Some(Sector { from, to: from + TAU }.at(from + PI).each(Label::Friction))
            }
            Label::Sticking(sector) => {
                let middle = 0.5 * (sector.from + sector.to);
                (sector.width() > NARROWEST_ARC).then(|| sector.at(middle).each(Label::Sticking))
            }
            Label::Friction(sector) | Label::Sliding(sector) => {
                let [a, b] = [towards, slides_towards].each(|angle| sector.inside(angle));
                let limit = self.friction.limit(force[0]).min(traction);
                let turned = friction * (a - b).abs().min(1.0);
                let width = sector.width();
                // Sectors wider than this angle are halved, because the convex hull of more than a half turn contains friction in every direction.
                // Narrower sectors are cut between the directions of friction and slip.
                let wide = 1.1 * PI;
                if matches!(label, Label::Friction(_)) && (limit - friction).abs() > turned && width < wide {
                    return Some([Label::Sticking(sector), Label::Sliding(sector)]);
                }
                let part = if width > wide { 0.5 } else { 0.5 * (a + b) / width };
                // A cut leaves at least this fraction of the sector on either side, so that sectors become small after a limited number of cuts.
                let least_part = 0.15;
                let middle = sector.from + width * part.clamp(least_part, 1.0 - least_part);
                let label =
                    if matches!(label, Label::Friction(_)) { Label::Friction } else { Label::Sliding };
                (width > NARROWEST_ARC).then(|| sector.at(middle).each(label))
            }
        }
    }
}
