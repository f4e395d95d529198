//! From a solution of the local problem to the answer as physics.

use nalgebra::SVector;

use super::answer::{Cone, ContactAnswer, ContactState, Equilibrium, LocalAnswer, WorkDone};
use crate::contact::Mode;
use crate::forms::{LeftOut, Why};
use crate::grasp::{Grasp, Hold, Stiffness, Twist, Wrench};
use crate::object::Problem;
use crate::search::{Effort, Found, Rung};

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Writes a solution of the local problem out as physics.
    pub(crate) fn equilibrium(
        &self,
        problem: &Problem<D, C>,
        load: &Wrench<D>,
        found: &Found<D, C>,
        rule: Rung,
        effort: &Effort,
        cone: Cone,
    ) -> Equilibrium<D, C> {
        let contacts: Vec<_> = (0..self.len()).map(|i| self.contact_answer(problem, found, i)).collect();
        let twist = self.outside(&found.twist);
        let motions =
            |list: &[SVector<f64, D>]| list.iter().map(|v| self.outside(v)).collect::<Vec<Twist<D>>>();
        let stored_energy =
            contacts.iter().zip(self.sites()).map(|(c, site)| site.springs.stored(&c.force)).sum();
        Equilibrium {
            load: *load,
            residuals: self.residuals(problem, load, &twist, &contacts, cone, found.sizes),
            twist,
            contacts,
            rule,
            stored_energy,
            free_motions: motions(&found.free_motions),
            neutral_motions: motions(&found.neutral_motions),
            work: WorkDone {
                pivots: effort.pivots,
                rows_made: effort.rows,
                rows_left_out: self.left_out(
                    effort,
                    cone,
                    matches!(rule, Rung::EverythingRolls | Rung::EverythingTouchingRolls),
                ),
                combinations: effort.combinations,
            },
            cone,
            change_from_polygon: found.from_polygon,
            local: LocalAnswer {
                states: found.states.clone(),
                twist: found.twist,
                drives: problem.drives.clone(),
                slips: problem.slips.clone(),
            },
        }
    }

    pub(crate) fn contact_answer(
        &self,
        problem: &Problem<D, C>,
        found: &Found<D, C>,
        i: usize,
    ) -> ContactAnswer<C> {
        let (site, contact, local) = (&self.sites()[i], &self.contacts()[i], problem.local(i));
        let force = found.forces[i];
        let moved = site.map.tr_mul(&found.twist);
        let stretch = problem.drives[i] - moved;
        let mut slip = site.springs.slip(&stretch, &force);
        let state = match &found.states[i] {
            Mode::Open => ContactState::Separated,
            Mode::Rolling if local.is_frictionless() => ContactState::Frictionless,
            Mode::Rolling => {
                slip.fill(0.0);
                ContactState::Rolling
            }
            sliding => {
                // Friction pulls the body the way the finger slips; where the slip is still zero (the very edge), the
                // direction is the one in which it would start.
                let outward = local.outward(sliding).unwrap_or(slip);
                let told = sliding.slide().is_none() && slip.norm() > 0.0 && slip.dot(&outward) > 0.0;
                let along = if told { slip } else { outward };
                ContactState::Sliding { direction: site.frame * along.normalize() }
            }
        };
        let margin = match state {
            ContactState::Rolling if site.hold == Hold::Bonded => f64::INFINITY,
            ContactState::Rolling => local.margin(&force),
            _ => 0.0,
        };
        slip += problem.slips[i];
        let mut commanded = problem.drives[i] + problem.slips[i];
        commanded[0] += contact.clearance;
        let (body_surface, finger_surface) = match contact.stiffness {
            Stiffness::BodyAndFinger { body, finger } => {
                let give = |k: &SVector<f64, C>| SVector::<f64, C>::from_fn(|a, _| force[a] / k[a]);
                (Some(site.frame * (moved + give(&body))), Some(site.frame * (commanded - give(&finger))))
            }
            Stiffness::Series(_) => (None, None),
        };
        ContactAnswer {
            state,
            force,
            force_world: site.frame * force,
            body_core: site.frame * moved,
            body_surface,
            finger_surface,
            gap: if state == ContactState::Separated { (-stretch[0]).max(0.0) } else { 0.0 },
            slip,
            margin,
        }
    }

    pub(super) fn left_out(&self, effort: &Effort, cone: Cone, everything_rolls: bool) -> Vec<LeftOut> {
        let facets = if effort.facets > 0 { effort.facets } else { cone.facets() };
        let mut list = Vec::new();
        for (contact, site) in self.sites().iter().enumerate() {
            let mut push = |rows, why| list.push(LeftOut { contact, rows, why });
            if everything_rolls && effort.rows == 0 {
                push(1 + facets, Why::EverythingRolls);
                continue;
            }
            match site.hold {
                Hold::Bonded => push(1 + facets, Why::Bonded),
                Hold::KeptClosed => push(1, Why::KeptClosed),
                Hold::Unilateral => {}
            }
            if site.hold != Hold::Bonded {
                if site.friction.is_frictionless() {
                    push(facets, Why::Frictionless);
                } else if site.friction.is_infinite() {
                    push(facets, Why::InfiniteFriction);
                }
            }
        }
        list
    }
}
