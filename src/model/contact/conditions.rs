//! The inequalities that a state of a contact must satisfy. Each has a rounding scale: the magnitude of its terms, to which its rounding error is
//! proportional. Let u_c be the displacement of the contact point and n the normal. The offset a is the commanded displacement minus clearance and
//! earlier slip. F_n and F_t are normal and tangential force, μ is the coefficient of friction. A polygonal friction cone has facets `h·F_t <= μ F_n`
//! with the normals h; two facets meet at a corner. A contact slides on one facet, or at a corner on two ("its facets"):
//!
//! ```text
//! open      gap = n·u_c - a_n                 >= 0
//! sticking  F_n, μ F_n - h·F_t (every facet)  >= 0
//! sliding   F_n, slip along the normals of its facets, the other facets' μ F_n - h·F_t >= 0
//! ```
//!
//! All conditions are linear in stretch and force, so the same function also evaluates their rates from the rates of stretch and force.

use nalgebra::SVector;

use super::law::LocalLaw;
use super::state::{Mode, State};
use super::tangential::cross;
use super::tolerances::SMALLEST;

/// Stretch and force of a contact, from which its conditions are evaluated. If the rates of the conditions are sought, `stretch` and `force` hold
/// rates instead.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpringState<'s> {
    /// Stretch of the contact's springs, `a - G_iᵀq`, with the contact's offset a and the object's motion q, m.
    pub(crate) stretch: SVector<f64, 3>,
    /// Contact force, N.
    pub(crate) force: &'s SVector<f64, 3>,
    /// Magnitude of the displacements whose difference is the stretch, m. The rounding error of the stretch is proportional to it.
    pub(crate) span: f64,
    /// Magnitude of the largest contact force of the grasp, N.
    pub(crate) largest: f64,
}

impl LocalLaw<'_> {
    /// Rounding scale of the contact's force, N: the magnitude of the force plus the smaller of two estimates. The first estimate is the largest
    /// force of the grasp (`largest`); it is the smaller one for stiff contacts, whose stretches are differences of large displacements. The second
    /// is the stiffness times the magnitude of the displacements (`span`, m); it is the smaller one for soft contacts.
    #[inline(always)]
    pub(crate) fn force_size(&self, force: &SVector<f64, 3>, span: f64, largest: f64) -> f64 {
        SMALLEST + force.norm() + largest.min(self.springs.stiffest() * span)
    }

    /// Calls `visit(value, size)` for every condition `value >= 0` of a state. The rounding error of the value is of the order of its rounding scale
    /// `size` times the machine precision.
    pub(crate) fn for_each_condition(
        &self,
        state: &State,
        at: &SpringState<'_>,
        visit: &mut dyn FnMut(f64, f64),
    ) {
        let f = at.force;
        let force_size = self.force_size(f, at.span, at.largest);
        if !matches!(state, Mode::Open) {
            self.for_each_margin(state, f, force_size, visit);
            if self.may_open() {
                visit(f[0], force_size);
            }
        }
        let give = self.springs.deflection(f);
        let motion_size = SMALLEST + at.span + give.lp_norm(1);
        match state {
            Mode::Open if self.may_open() => visit(-at.stretch[0], motion_size),
            Mode::Open | Mode::Sticking => {}
            _ => {
                for along in self.slips_along(state, &self.springs.slip(&at.stretch, f)) {
                    let Some([value, weight]) = along else { continue };
                    visit(value, motion_size * weight);
                }
            }
        }
    }

    /// Slip components, m, that must not be negative in a sliding state. Each is paired with its rounding error as a multiple of the rounding error
    /// of the slip. On the round cone or on a facet there is one component, along the slip direction or the facet normal. At a corner there are two
    /// components, along both normals. An open or sticking state has no such components.
    pub(super) fn slips_along(&self, state: &State, slip: &SVector<f64, 3>) -> [Option<[f64; 2]>; 2] {
        let facets = self.facets();
        match state {
            Mode::Open | Mode::Sticking => [None; 2],
            Mode::Round(slide) => [Some([slip.dot(&slide.direction), 1.0]), None],
            Mode::Facet(j) => {
                let h = &facets[usize::from(*j)];
                [Some([slip.dot(h) / h.norm(), 1.0]), None]
            }
            Mode::Corner(j) => {
                // The slip is σ₁ h₁ + σ₂ h₂, with the normals h₁ and h₂ of the two facets that meet at the corner. Each σ is a quotient of cross
                // products with the normal of the other facet.
                let (h1, h2) = (facets[usize::from(*j)], facets[(usize::from(*j) + 1) % facets.len()]);
                let turn = cross(&h1, &h2);
                [
                    Some([cross(slip, &h2) / turn, h2.norm() / turn.abs()]),
                    Some([cross(&h1, slip) / turn, h1.norm() / turn.abs()]),
                ]
            }
        }
    }

    /// Calls `visit(margin, size)` for every facet of the cone on which the contact does not slide. For the facet normal h the friction margin
    /// `margin` is `μ F_n - h·F_t`, N; its rounding error is proportional to `size`. A sticking contact with a round cone has a single margin.
    fn for_each_margin(
        &self,
        state: &State,
        f: &SVector<f64, 3>,
        force_size: f64,
        visit: &mut dyn FnMut(f64, f64),
    ) {
        let cone = self.cone();
        match state {
            Mode::Round(_) => {}
            Mode::Sticking
                if self.on_round_cone
                    && self.has_a_whole_cone()
                    && !cone.is_infinite()
                    && !self.is_frictionless() =>
            {
                visit(cone.round_margin(f), force_size * cone.round_weight());
            }
            _ => {
                let facets = self.facets();
                let own = state.own_facets(facets.len());
                for (j, h) in facets.iter().enumerate() {
                    if !own.contains(&Some(j)) {
                        visit(cone.facet_margin(f, h), force_size * cone.facet_weight(h));
                    }
                }
            }
        }
    }
}
