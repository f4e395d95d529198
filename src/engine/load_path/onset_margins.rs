//! The margins m (`μ F_n - |F_t|`, N) that vanish at an onset, and the derivatives of the onset. The onset is the load factor τ at which the first
//! contact stops sticking. If a change of the data (stiffness, friction and others) changes a margin by dm, τ changes by `dτ = -dm / m'`. Here m' is
//! the rate of the margin along the ramp. Along a ramp the load is a base load plus τ times a given load, and commands change in proportion to τ. A
//! drive, the spring of a joint or tendon of a hand with its force limit, is treated like a contact.

use nalgebra::SVector;

use super::onset::{OnsetEvent, StickingState};
use crate::contact::involves_friction;
use crate::equilibrium::{Parameter, StickingResponse};
use crate::grasp::{Engine, HandPart, Wrench, inside};
use crate::numerics::{any_index, mapped};
use crate::object::ForcesAndTwist;
use crate::prelude::*;

/// A contact or a drive of a hand that stops sticking at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DepartingPart {
    /// A contact, by its index, from 0.
    Contact(usize),
    /// The drive of a joint or tendon of a hand.
    Drive(HandPart),
}

/// The margins that vanish at an onset, and the derivatives of the onset's load factor τ with respect to the data of grasp and load. The margin of a
/// contact is m = `μ F_n - |F_t|`, N (F_n if the contact opens), and m' is its rate along the ramp. If a datum changes, the margin at constant τ
/// changes by dm, and τ by `dτ = -dm / m'`. For a load that turns, τ is the angle of the onset.
///
/// A change of a point or a normal moves or turns the contact frame, and thus changes the grasp map. Let contact i have the stiffness K_i, the grasp
/// map G_i and the force F_i, and let q be the motion of the object:
///
/// ```text
/// dF_i = -K_i (G_iᵀdq + dG_iᵀq),      Σ (G_i dF_i + dG_i F_i) = 0
/// ```
///
/// Commands, clearances and stiffnesses then keep their components along the axes of the contact frames, as do changes of commands along a ramp. A
/// command a that keeps its components along the **coordinate** axes has other components in a contact frame that tilts by φ towards the tangent t.
/// Its component along the normal n changes by φ `a·t`, its component along t by -φ `a·n`.
pub struct OnsetMargins<'g> {
    response: StickingResponse<'g>,
    state: ForcesAndTwist,
    margins: Vec<Margin>,
}

/// The margin of a contact or drive that stops sticking, as a linear function `row·F` of its force F. It is `μ F_n - h·F_t` with the normal h of a
/// facet of the polygonal cone; on the round cone h is along F_t. It is F_n alone if friction is absent or unlimited.
struct Margin {
    leaver: DepartingPart,
    site: usize,
    row: SVector<f64, 3>,
    /// The rate of the margin along the ramp, N per unit of the load factor.
    rate: f64,
}

impl<'g> OnsetMargins<'g> {
    /// The margins at the onset `event`. `None` if a contact with friction closed before the onset, or closes at the onset and slides. `None` also if
    /// the grasp and `event` have different numbers of contacts.
    pub(crate) fn new(grasp: &'g Engine, event: &OnsetEvent<3>) -> Option<Self> {
        let StickingState { found, slips, offset_rates, wrench_rate, leaving, .. } = &event.local;
        let found = found.found();
        let response = StickingResponse::of(grasp, grasp.problem_at_onset(event)?, &found.states);
        let has_slipped = |i: usize| {
            found.states[i].is_sticking() && !response.law(i).is_frictionless() && slips[i].norm() != 0.0
        };
        // If a contact slides as soon as it touches, no margin vanishes at the onset. Instead a gap closes, and the formulas of this file do not give
        // the derivative of that load factor.
        let opens = |site: &usize| found.states[*site].is_open();
        if any_index(grasp.len(), &has_slipped) || leaving.iter().any(opens) {
            return None;
        }
        let rates = response.state(offset_rates, &wrench_rate.to())?;
        let mut margins = Vec::with_capacity(leaving.len());
        for &site in leaving {
            let Some(leaver) = grasp.leaver(site) else { continue };
            let Some((row, _)) = response.edges[site].worst(&found.forces[site]) else { continue };
            margins.push(Margin { leaver, site, row, rate: row.dot(&rates.forces[site]) });
        }
        let state = ForcesAndTwist { forces: found.forces, twist: found.twist };
        Some(Self { response, state, margins })
    }

    /// The contacts and drives that stop sticking at the onset, in the order of the derivatives of [`Self::by`]. Each has a load factor at which its
    /// margin vanishes; the onset is the least of these load factors. Thus, if the data change, the one-sided derivative of the onset is the least
    /// derivative of these load factors.
    #[must_use]
    pub fn leavers(&self) -> Vec<DepartingPart> {
        mapped(&self.margins, &|margin| margin.leaver)
    }

    /// The derivative of the onset's load factor with respect to one datum (such as a friction coefficient), for each contact or drive of
    /// [`Self::leavers`]. Its unit is the inverse of the datum's unit. `None` if [`Sensitivity::of`](crate::ask::Sensitivity::of) has no derivative
    /// of the forces, for example because a load does work along a motion that no spring resists.
    #[must_use]
    pub fn by(&self, parameter: Parameter) -> Option<Vec<f64>> {
        let change = self.response.derivative(&self.state, parameter)?;
        let direct = |margin: &Margin| match parameter {
            Parameter::Friction { contact } if contact == margin.site && involves_friction(&margin.row) => {
                self.state.forces[contact][0]
            }
            _ => 0.0,
        };
        Some(mapped(&self.margins, &|margin| margin.factor_change(&change.forces, direct(margin))))
    }

    /// If x times `load` is added to the base load: the derivative of the onset's load factor with respect to x, at x = 0. There is one derivative
    /// for each contact or drive of [`Self::leavers`]. If `load` is the load of the onset, this is the derivative with respect to a factor of the
    /// whole load, at the value 1. `None` if nothing resists `load` in the contact states at the onset.
    #[must_use]
    pub fn by_load<const C: usize>(&self, load: &Wrench<C>) -> Option<Vec<f64>> {
        let change = self.response.by_load(&inside(load)).ok()?;
        Some(mapped(&self.margins, &|margin| margin.factor_change(&change.of, 0.0)))
    }
}

impl Margin {
    /// The change of the load factor at which this margin vanishes. Contact forces change by `forces`, N. The margin changes by `direct`, N, in
    /// addition, for example because a friction coefficient changes.
    fn factor_change(&self, forces: &[SVector<f64, 3>], direct: f64) -> f64 {
        -(self.row.dot(&forces[self.site]) + direct) / self.rate
    }
}
