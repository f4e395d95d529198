//! Converts a solution of the scaled problem ([`Problem`]) to an answer in physical quantities.

use nalgebra::{SMatrix, SVector};

use super::answer::{Equilibrium, LocalAnswer, WorkDone};
use super::cone::{AnswerFor, Cone};
use super::contact_answer::{ContactAnswer, ContactState};
use super::left_out::forces_in;
use super::too_far::{MotionData, TooFar};
use crate::contact::{LocalLaw, Mode, State, ZERO_SLACK};
use crate::forms::{OmissionReason, OmittedPairs};
use crate::grasp::{Contact, Coordinates, Engine, Hold, Stiffness, Twist, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Reals, Vector, by_axis, mapped};
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{FoundBy, SearchCounts, SearchSolution};

impl Engine {
    /// The answer in physical quantities for `found`, a solution of the equilibrium problem in the engine's scaled units.
    pub(crate) fn equilibrium(
        &self,
        problem: &Problem,
        load: &Wrench<3>,
        found: SearchSolution,
        rule: FoundBy,
        effort: &SearchCounts,
        AnswerFor { cone, small }: AnswerFor,
    ) -> Equilibrium<3> {
        let with_joints = |i: usize| {
            let joints = &found.twist - self.body_alone(i, &found.twist);
            self.sites()[i].map.tr_mul(&joints)
        };
        let any = self.linkage().is_some();
        let solved = self.contacts().iter().zip(solved_sites(problem, &found)).enumerate();
        let answer = |(i, (contact, solved)): (usize, (&Contact<3>, SolvedContact<'_>))| {
            solved.answer((contact, i), any.then(|| with_joints(i)))
        };
        let contacts: Vec<_> = solved.map(answer).list();
        let twist = self.outside_coordinates(&found.twist);
        let motions = |list: &[Vector]| mapped(list, &|v| self.motion_outside(v));
        let drive_forces = found.forces[self.len()..].to_vec();
        let stored = contacts.iter().zip(self.sites()).map(|(c, site)| site.springs.stored(&c.force));
        let mut stored_energy: f64 = stored.added();
        if let Some(linkage) = self.linkage() {
            let stored = linkage.drives.iter().zip(&drive_forces).map(|(drive, force)| drive.stored(force));
            stored_energy += stored.added();
        }
        let (joints, tendons) = self.hand_answers(problem, &found);
        let leaks = || self.leaking_cup(&|i| found.states[i].is_open()).map(|cup| TooFar::Leaks { cup });
        let standing = MotionData::found(problem, &found);
        let by_turning_forces = if self.buckles_in(&contacts, &found.states, load) {
            Some(TooFar::Buckles)
        } else if self.is_within(&small, &standing) {
            // Where motions are beyond their limits, they say more than a snap-through that follows from them.
            self.too_far_with_turned_parts(&small, &standing, load)
        } else {
            None
        };
        let too_far = if by_turning_forces == Some(TooFar::Buckles) {
            by_turning_forces
        } else if !contacts.iter().any(|contact| self.just_touches(contact))
            && self.driven_along(&found.free_motions, &forces_in(&contacts), load).is_some()
        {
            Some(TooFar::TurnsOver)
        } else {
            leaks().or_else(|| self.farthest_beyond(&small, &standing)).or(by_turning_forces)
        };
        Equilibrium {
            load: *load,
            residuals: self.residuals(problem, load, &twist, (&contacts, &found), cone),
            twist: Twist::among(self.space(), &twist),
            bodies: self.body_motions(&twist),
            body_loads: self.body_loads(),
            too_far,
            pads: self.pads(&contacts),
            open_cups: self
                .cups_open(|i| contacts[i].state == ContactState::Separated && contacts[i].gap > 0.0),
            contacts,
            joints,
            tendons,
            accuracy: None,
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
                    matches!(rule, FoundBy::EverythingSticks | FoundBy::EverythingTouchingSticks),
                ),
                combinations: effort.combinations,
            },
            cone,
            change_from_polygon: found.from_polygon,
            local: LocalAnswer {
                states: found.states,
                drive_forces,
                twist: Coordinates::of(&found.twist),
                free_motions: mapped(&found.free_motions, &Coordinates::of),
                offsets: problem.offsets.clone(),
                slips: problem.slips.clone(),
                cones: problem.cones.clone(),
            },
        }
    }

    /// Whether a contact is open with a gap within rounding of zero. It resists motions towards it, which count as free. At the load at which an object
    /// tips over, the contact that opens is such a contact.
    fn just_touches(&self, contact: &ContactAnswer<3>) -> bool {
        contact.state == ContactState::Separated && contact.gap <= NEGLIGIBLE * self.length()
    }

    pub(super) fn left_out(
        &self,
        effort: &SearchCounts,
        cone: Cone,
        everything_sticks: bool,
    ) -> Vec<OmittedPairs> {
        let facets = if effort.facets > 0 { effort.facets } else { cone.facets() };
        let mut list = Vec::new();
        for (contact, site) in self.sites().iter().enumerate() {
            let mut push = |rows, why| list.push(OmittedPairs { contact, rows, why });
            if everything_sticks && effort.rows == 0 {
                push(1 + facets, OmissionReason::EverythingSticks);
                continue;
            }
            match site.hold {
                Hold::Bonded => push(1 + facets, OmissionReason::Bonded),
                Hold::KeptClosed => push(1, OmissionReason::KeptClosed),
                Hold::Unilateral => {}
            }
            if site.hold != Hold::Bonded {
                if site.friction.is_frictionless() {
                    push(facets, OmissionReason::Frictionless);
                } else if site.friction.is_infinite() {
                    push(facets, OmissionReason::InfiniteFriction);
                }
            }
        }
        list
    }
}

pub(crate) fn site_states(problem: &Problem, found: &SearchSolution) -> Vec<ContactState<3>> {
    solved_sites(problem, found).map(|solved| solved.state().0).list()
}

fn solved_sites<'s>(
    problem: &'s Problem<'s>,
    found: &'s SearchSolution,
) -> impl Iterator<Item = SolvedContact<'s>> {
    let solved = problem.locals().zip(problem.sites).zip(&found.states).zip(&found.forces);
    let history = problem.offsets.iter().zip(&problem.slips);
    solved.zip(history).map(move |((((local, site), state), force), (offset, memory))| SolvedContact {
        local,
        frame: &site.frame,
        bonded: site.hold == Hold::Bonded,
        state,
        force: *force,
        offset: *offset,
        memory: *memory,
        moved: site.map.tr_mul(&found.twist),
    })
}

/// One contact, or one drive of a joint or tendon, in a solution, with vectors in its own contact frame.
struct SolvedContact<'s> {
    local: LocalLaw<'s>,
    frame: &'s SMatrix<f64, 3, 3>,
    bonded: bool,
    state: &'s State,
    force: SVector<f64, 3>,
    /// Offset of the contact's springs, m: commanded displacement of the finger minus clearance and minus `memory`, the slip accumulated before.
    offset: SVector<f64, 3>,
    /// Slip accumulated along a load path so far, m.
    memory: SVector<f64, 3>,
    /// Displacement of the contact point as a point of the rigid body, minus the finger's displacement due to joints, in the contact frame, m.
    moved: SVector<f64, 3>,
}

impl SolvedContact<'_> {
    /// State of the contact, and its slip, m, beyond the slip `memory` that was accumulated before. This slip is zero if the contact sticks. For an
    /// open or frictionless contact the second value is the displacement of the surfaces past each other.
    fn state(&self) -> (ContactState<3>, SVector<f64, 3>) {
        let slip = self.local.springs.slip(&(self.offset - self.moved), &self.force);
        match self.state {
            Mode::Open => (ContactState::Separated, slip),
            Mode::Sticking if self.local.is_frictionless() => (ContactState::Frictionless, slip),
            Mode::Sticking => (ContactState::Sticking, SVector::zeros()),
            sliding => {
                // Friction pulls the body in the direction in which the finger slips. While the slip is still zero, with the force on the boundary of
                // its cone, it is the direction in which slip starts.
                let outward = self.local.outward(sliding).unwrap_or(slip);
                let is_facet_slide =
                    sliding.slide().is_none() && slip.norm() > 0.0 && slip.dot(&outward) > 0.0;
                let along = if is_facet_slide { slip } else { outward };
                (ContactState::Sliding { direction: self.frame * along.normalize() }, slip)
            }
        }
    }

    /// The answer for the contact with this index, in physical quantities. `moved_with_joints` is the part of `moved` due to joints: the negative
    /// displacement of the finger by its joints. The displacement of the body is computed without this part.
    fn answer(
        &self,
        (contact, index): (&Contact<3>, usize),
        moved_with_joints: Option<SVector<f64, 3>>,
    ) -> ContactAnswer<3> {
        let (force, frame) = (self.force, self.frame);
        let (state, slip) = self.state();
        let margin = match state {
            ContactState::Sticking if self.bonded => f64::INFINITY,
            ContactState::Sticking => self.local.margin(&force),
            _ => 0.0,
        };
        let mut commanded = self.offset + self.memory;
        commanded[0] += contact.clearance;
        let mut body_core = self.moved;
        if let Some(joints) = moved_with_joints {
            commanded -= joints;
            body_core -= joints;
        }
        let (body_surface, finger_surface) = match contact.stiffness {
            Stiffness::BodyAndFinger { body, finger } => {
                let give = |k: &SVector<f64, 3>| by_axis(|a| force[a] / k[a]);
                (Some(frame * (body_core + give(&body))), Some(frame * (commanded - give(&finger))))
            }
            Stiffness::Series(_) => (None, None),
        };
        let gap = self.moved[0] - self.offset[0];
        // The computed gap of a touching contact is the rounding of two displacements, and is taken as zero.
        let is_none = gap <= ZERO_SLACK * (self.moved.norm() + self.offset.norm());
        ContactAnswer {
            contact: contact.label(index),
            state,
            force,
            force_world: frame * force,
            body_core: frame * body_core,
            body_surface,
            distinct: None,
            finger_surface,
            gap: if state == ContactState::Separated && !is_none { gap } else { 0.0 },
            slip: slip + self.memory,
            margin,
        }
    }
}
