//! The search for better finger placement: ascents from the given grasp and from the best of many random grasps, and the answer with the best grasp
//! found. A place is the position of a contact on its curve or surface. The commanded normal force of a contact is that which its command causes with
//! the object held in place. A design point is one choice of all places and commanded normal forces. At rest means under the base load, which acts
//! before the loads of the question grow. At first slip the first contact ceases to stick.

use super::answer::{ActiveConstraint, ActiveConstraintKind, Improved, Placed, SearchEnd};
use super::ascent::{Ascent, AscentProblem, EvaluatedDesign, LastStep};
use super::design_point::{DesignKind, DesignSpace};
use super::events::ConstraintKind;
use super::goal::ImproveGoal;
use super::loaded::LoadSet;
use super::question::Improve;
use super::tolerances::{AT_ITS_LIMIT, ROUNDED_MULTIPLIER};
use crate::ask::Grasp;
use crate::equilibrium::{Outcome, TooFar};
use crate::error::Error;
use crate::grasp::{Hold, inside, outside};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Draw, IntoList, in_order, increasing, indexed, mapped, moved};
use crate::prelude::*;
use crate::squeeze::Loads;

impl<const C: usize> Grasp<C> {
    /// Finds places and commanded normal forces of the fingers of this grasp with the largest load factor of first slip. Another goal is the largest
    /// reserve under the loads: the least margin of a contact force to the boundary of its friction cone.
    ///
    /// Friction cones are round in space. The result is the same to the last bit for any number of threads.
    ///
    /// ```
    /// use grasp_lcp::improve::{Improve, Surface};
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws, one of them 10 mm too high, lift 1 N at a time; each may press with up to 10 N.
    /// let jaw = |x: f64, y: f64, name| Contact::new([x, y], [-x, 0.0]).name(name).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
    /// let gripper = Grasp::new([jaw(-0.03, 0.0, "left"), jaw(0.03, 0.01, "right")])?;
    /// let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    /// let question = Improve::new(Wrench::force([0.0, -1.0])).along(0, edge(-0.03)).along(1, edge(0.03)).pressing_at_most(10.0);
    /// let improved = gripper.improve(&question)?;
    ///
    /// // Level with each other both slide at once: 2 μ N.
    /// assert!((improved.after.expect("sticks at rest") - 10.0).abs() < 1e-9);
    /// assert!(improved.is_locally_best());
    /// let words = improved.to_string();
    /// assert!(words.starts_with("FIRST SLIP at 10 N instead of"), "{words}");
    /// let better = improved.placed(&gripper)?;
    /// assert!(better.hold(Wrench::force([0.0, -9.9]))?.sticks() == Some(true));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Surface`] for an invalid surface, or for a contact that does not lie on its surface. [`Error::Wrench`], [`Error::Argument`],
    /// [`Error::Contact`] and [`Error::Question`] for loads, forces and contacts that this search does not accept. [`Error::NotForHands`] for a grasp
    /// by a hand.
    #[doc(alias = "grasp synthesis", alias = "fixture design", alias = "optimise", alias = "best grasp")]
    pub fn improve(&self, question: &Improve<C>) -> Result<Improved<C>, Error> {
        inside(question).answered_by(&inside(self)).map(outside)
    }
}

impl Improve<3> {
    /// Searches for better finger placement in the engine's form, whose vectors have three components in the plane, too.
    fn answered_by(&self, grasp: &Grasp<3>) -> Result<Improved<3>, Error> {
        self.check(grasp)?;
        let mut settings = *grasp.settings();
        settings.round = true;
        let grasp = grasp.with(&settings);
        let loads = self.given_loads()?;
        let loaded = LoadSet::of(grasp.engine.space().axes(), self, &loads);
        let (design_space, as_given) = DesignSpace::of(&grasp, self)?;
        let ascent_problem = AscentProblem { design_space: &design_space, loaded: &loaded, grasp: &grasp };
        // Some contacts of the given grasp may touch without force. Some starts leave these contacts idle (open until a load pushes them), others let
        // them press. Either may give the better grasp.
        let idle = ascent_problem.idle(&as_given)?;
        let given = as_given.with_idle(&idle);
        let before = ascent_problem.before(&given)?;
        // For each random start that the question asks for, 24 random design points are drawn. The best of all drawn design points become starts, in
        // addition to the given grasp.
        let kinds = if idle.contains(&true) { vec![&given, &as_given] } else { vec![&given] };
        let count = (self.starts() * 24) as u64;
        let numbers: Vec<u64> = (0..count * kinds.len() as u64).list();
        let drawn = in_order(&numbers, &|number| {
            let from = if *number < count { &given } else { &as_given };
            // The last number of the seed, 48, keeps these random numbers apart from random numbers drawn elsewhere with the same `seed`.
            let drawn = design_space.random(from, &mut Draw::new([self.seed.unwrap_or(0), *number, 48]));
            // Only the value and the design point are kept, because the forces of thousands of design points would take much storage.
            Ok::<_, Error>(ascent_problem.evaluate(drawn)?.map(|design| (design.value, design.design_point)))
        });
        let (mut values, mut places) = (Vec::new(), Vec::new());
        for design in drawn {
            if let Some((value, design_point)) = design? {
                values.push(-value);
                places.push(design_point);
            }
        }
        let mut design_points = mapped(&kinds, &|kind| (*kind).clone());
        let best = increasing(&values).into_iter().take(self.starts());
        best.map(|k| places[k].clone()).append_to(&mut design_points);
        let ascents = in_order(&design_points, &|design_point| {
            ascent_problem
                .evaluate(design_point.clone())?
                .map(|design| ascent_problem.over_edges(design))
                .transpose()
        });
        let (mut count, mut steps) = (0, 0);
        let mut best: Option<Ascent> = None;
        for ascent in ascents {
            let Some(next) = ascent? else { continue };
            count += 1;
            steps += next.steps;
            let is_better = best.as_ref().is_none_or(|best| {
                let more = next.design.value > best.design.value + NEGLIGIBLE * best.design.scale;
                let proved = next.design.value >= best.design.value
                    && next.search == SearchEnd::Optimum
                    && best.search != SearchEnd::Optimum;
                more || proved
            });
            if is_better {
                best = Some(next);
            }
        }
        let force = match &loads {
            Loads::Each(list) if list.len() == 1 => {
                list[0].measure().filter(|(_, unit)| *unit == "N").map(|(size, _)| size)
            }
            Loads::AnyForce { size, .. } => Some(*size),
            _ => None,
        };
        let mut answer = Improved {
            goal: self.goal(),
            before,
            after: None,
            too_far: None,
            at_their_limit: Vec::new(),
            force,
            contacts: Vec::new(),
            in_the_way: Vec::new(),
            search: SearchEnd::NoStart,
            residual: None,
            starts: count,
            steps,
        };
        let Some(Ascent { design, search, last, .. }) = best.filter(|best| best.design.value >= 0.0) else {
            return Ok(answer);
        };
        (answer.after, answer.search) = (Some(design.value), search);
        answer.contacts = placed(&design_space, &design);
        answer.at_their_limit = design_space.wholes.with(&|i| is_at_its_limit(&design_space, &design, i));
        if let Some(last) = last {
            answer.residual = Some(last.step.residual);
            answer.in_the_way = in_the_way(&design_space, &design, &last);
        }
        answer.too_far = self.too_far(&answer.placed_inside(&grasp)?, &loads, design.value)?;
        Ok(answer)
    }

    /// The reason why motions of this grasp are not small, or why it buckles. Examined are rest, each load of the question, and first slip, at which
    /// the load is `value` times that of the question.
    fn too_far(&self, best: &Grasp<3>, loads: &Loads<3>, value: f64) -> Result<Option<TooFar>, Error> {
        let mut whole_loads = vec![self.base()];
        if let Loads::Each(list) = loads {
            let is_first_slip = self.goal() == ImproveGoal::FirstSlip && value.is_finite();
            for factor in [Some(1.0), is_first_slip.then_some(value)].into_iter().flatten() {
                whole_loads.extend(mapped(list, &|load| self.base() + *load * factor));
            }
        }
        for load in whole_loads {
            if let Outcome::Equilibrium(state) = best.solve(load)?
                && state.too_far.is_some()
            {
                return Ok(state.too_far);
            }
        }
        Ok(None)
    }
}

impl<const C: usize> Improved<C> {
    /// The given grasp with the places, frames and commands of this answer.
    ///
    /// # Errors
    /// [`Error::Size`] if the grasp has another number of contacts than the answer.
    pub fn placed(&self, grasp: &Grasp<C>) -> Result<Grasp<C>, Error> {
        inside(self).placed_inside(&inside(grasp)).map(outside)
    }
}

impl Improved<3> {
    /// Puts the places, frames and commands of this answer into `grasp`, in the engine's form, whose vectors have three components in the plane, too.
    fn placed_inside(&self, grasp: &Grasp<3>) -> Result<Grasp<3>, Error> {
        let (given, expected) = (self.contacts.len(), grasp.len());
        if given != expected {
            return Err(Error::Size { what: "contacts of the answer", given, expected });
        }
        let mut contacts = grasp.contacts().to_vec();
        for (contact, placed) in contacts.iter_mut().zip(&self.contacts) {
            (contact.point, contact.normal) = (placed.point, placed.normal);
            (contact.tangent, contact.command) = (Some(placed.tangent), placed.command);
        }
        Ok(Grasp::new(contacts)?.with(grasp.settings()))
    }
}

/// Whether a contact uses all its friction at rest.
fn is_at_its_limit(design_space: &DesignSpace<'_>, design: &EvaluatedDesign, i: usize) -> bool {
    let (force, contact) = (design.parts[0].at_rest(i), &design_space.contacts[i]);
    let sticks = contact.friction.is_infinite() || contact.hold == Hold::Bonded;
    let most = contact.friction * force[0];
    !sticks && most > 0.0 && force[1].hypot(force[2]) >= most * (1.0 - AT_ITS_LIMIT)
}

fn placed(design_space: &DesignSpace<'_>, design: &EvaluatedDesign) -> Vec<Placed<3>> {
    let contacts = design_space.contacts(&design.design_point);
    indexed(&contacts, &|(i, contact)| Placed {
        contact: design_space.wholes.at(i).with(1),
        surface: design_space.question.surface_of(i).map(|surface| surface.name().to_owned()),
        point: contact.point,
        normal: contact.normal.normalize(),
        tangent: design.design_point.tangents[i],
        command: contact.command,
        moved: (contact.point - design_space.contacts[i].point).norm(),
        pressed_with: design.design_point.presses[i],
        normal_force: design.parts[0].at_rest(i)[0],
    })
}

fn in_the_way(
    design_space: &DesignSpace<'_>,
    design: &EvaluatedDesign,
    last: &LastStep,
) -> Vec<ActiveConstraint> {
    let LastStep { step, events, bounds, rooms } = last;
    let mut all: Vec<(usize, ActiveConstraintKind)> = Vec::new();
    let mut shares: Vec<(usize, Option<usize>, f64)> = Vec::new();
    for (event, share) in events.iter().zip(&step.events) {
        let (contact, load) = (event.condition.contact, event.condition.load);
        if *share > ROUNDED_MULTIPLIER {
            match shares.iter_mut().find(|(of, under, _)| (*of, *under) == (contact, load)) {
                Some((.., known)) => *known += share,
                None => shares.push((contact, load, *share)),
            }
        }
    }
    for (contact, load, share) in shares {
        let binds = match design_space.question.goal() {
            ImproveGoal::FirstSlip => ActiveConstraintKind::FirstSlip { load, share },
            ImproveGoal::Reserve => ActiveConstraintKind::Reserve { load, share },
        };
        all.push((contact, binds));
    }
    let force = design_space.unit_of_force();
    let gain = |multiplier: f64, unit: f64| multiplier * design.scale / unit;
    for (k, multiplier) in step.bounds.iter().enumerate().filter(|(_, y)| **y > ROUNDED_MULTIPLIER) {
        if let Some(bound) = bounds.get(k) {
            let per_newton = gain(*multiplier, force);
            let binds = match bound.kind {
                ConstraintKind::Sticks => ActiveConstraintKind::Rest { per_newton },
                ConstraintKind::Force => ActiveConstraintKind::Force { per_newton },
                ConstraintKind::Idle => ActiveConstraintKind::NotPressed { per_newton },
            };
            all.push((bound.contact, binds));
        } else if let Some(&contact) = rooms.get(k - bounds.len()) {
            let unit = design_space.variables.iter().find(|v| v.contact == contact).map_or(1.0, |v| v.unit);
            all.push((contact, ActiveConstraintKind::End { per_metre: gain(*multiplier, unit) }));
        }
    }
    for (variable, [down, up]) in design_space.variables.iter().zip(&step.ends) {
        if let DesignKind::Press { .. } = variable.what {
            if *up > ROUNDED_MULTIPLIER {
                all.push((
                    variable.contact,
                    ActiveConstraintKind::Pressed { per_newton: gain(*up, variable.unit) },
                ));
            }
            if *down > ROUNDED_MULTIPLIER {
                all.push((
                    variable.contact,
                    ActiveConstraintKind::NotPressed { per_newton: gain(*down, variable.unit) },
                ));
            }
        }
    }
    moved(all, &|(point, binds)| ActiveConstraint { contact: design_space.wholes.at(point).with(1), binds })
}
