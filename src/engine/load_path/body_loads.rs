//! Loads on single bodies that change along the legs (sections) of a load program, in addition to the program's load.

use alloc::borrow::Cow;
use alloc::sync::Arc;

use super::leg::{Leg, LegGoal, LegLoad};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Each, Vector, paired};
use crate::prelude::*;

/// The name of a body, and the load on this body: its value at the end of a leg (`To`), or its change along the leg (`By`).
pub(super) type BodyGoal<const C: usize> = (Arc<str>, LegGoal<Wrench<C>>);

impl<const C: usize> Leg<C> {
    /// A leg of a load program along which the load on one of several bodies changes by `change`, N and N m about the origin. This load is added to
    /// the load of the leg and the permanent load of the body. Such loads are zero when a program starts, and loads that a leg does not mention stay
    /// constant.
    ///
    /// ```
    /// use grasp_lcp::planar::{Bodies, Body, Contact, Leg, Wrench};
    ///
    /// // A box of 10 N on a box of 20 N on a table, μ = 0.3 between them and 0.5 below.
    /// let face = |y: f64, mu: f64| [-0.2, 0.2].map(|x| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu));
    /// let boxes = Bodies::new([
    ///     Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
    ///     Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
    /// ])
    /// .contacts(face(0.0, 0.5).map(|contact| contact.on("lower")))
    /// .contacts(face(0.2, 0.3).map(|contact| contact.on("upper").against("lower")))
    /// .grasp()?;
    /// // The upper one is pulled back by 2.9 N, then the lower one forth: by 17.9 N before the table lets go.
    /// let pull = |newtons: f64, y: f64| Wrench::force_at([newtons, 0.0], [0.0, y]);
    /// let legs = [Leg::body_load_to("upper", pull(-2.9, 0.21)), Leg::load_to(pull(20.0, 0.01))];
    /// let mut path = boxes.follow(Wrench::ZERO, &legs)?;
    /// path.run();
    /// let lost = path.end().and_then(|end| end.loss()).expect("slides on the table");
    /// assert!(lost.leg == 1 && (lost.load.resultant()[0] - 17.9).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn body_load_by(body: impl Into<String>, change: Wrench<C>) -> Self {
        Self::STAY.and_body_load_by(body, change)
    }

    /// A leg at whose end the load on one of several bodies is `load`, N and N m about the origin. This load is added to the load of the leg and the
    /// permanent load of the body.
    pub fn body_load_to(body: impl Into<String>, load: Wrench<C>) -> Self {
        Self::STAY.and_body_load_to(body, load)
    }

    /// This leg with one more change: along it the load on a body changes by `change`, N and N m about the origin. This load is added to the load of
    /// the leg and the permanent load of the body.
    pub fn and_body_load_by(self, body: impl Into<String>, change: Wrench<C>) -> Self {
        self.and_body(body.into(), LegGoal::By(change))
    }

    /// This leg with one more change: at its end the load on a body is `load`, N and N m about the origin. This load is added to the load of the leg
    /// and the permanent load of the body.
    pub fn and_body_load_to(self, body: impl Into<String>, load: Wrench<C>) -> Self {
        self.and_body(body.into(), LegGoal::To(load))
    }

    fn and_body(mut self, body: String, goal: LegGoal<Wrench<C>>) -> Self {
        self.bodies.push((body.into(), goal));
        self
    }

    /// Returns an error if this leg has a load on a body that does not exist, two loads on one body, or a load out of range. Also returns an error
    /// for a body load while the load of the leg turns.
    pub(super) fn check_bodies(&self, grasp: &Engine) -> Result<(), Error> {
        for (k, (name, goal)) in self.bodies.iter().enumerate() {
            let refuse = |fault: &str| Err(Error::Body { name: name.to_string(), fault: fault.to_owned() });
            grasp.body_called(name)?;
            if let LegGoal::By(load) | LegGoal::To(load) = goal {
                load.check_in(grasp.space(), "load of a body along a leg")?;
            }
            if self.bodies[..k].iter().any(|(other, _)| other == name) {
                return refuse("is loaded twice by a leg, must be once");
            }
            if matches!(self.load, LegLoad::Turn(_)) {
                return refuse("has a load that changes while the load of the leg turns, must stay");
            }
        }
        Ok(())
    }
}

/// The loads of all bodies, without their permanent loads, at the beginning and at the end of the present leg. `None` until a leg of the program
/// changes a body load.
#[derive(Debug, Clone, Default)]
pub(super) struct BodyLoads(Option<Arc<[Vec<Wrench<3>>; 2]>>);

impl BodyLoads {
    /// Continues to the next leg, which begins with the body loads at the end of the last leg. Each entry of `goals` changes the load of one body
    /// along the new leg; `names` are the names of all bodies.
    pub(super) fn append(&mut self, names: &[Arc<str>], goals: &[BodyGoal<3>]) {
        if goals.is_empty() && self.0.is_none() {
            return;
        }
        let from = self.0.as_ref().map_or_else(|| vec![Wrench::ZERO; names.len()], |loads| loads[1].clone());
        let mut to = from.clone();
        for (name, goal) in goals {
            let Some(body) = names.iter().position(|other| other == name) else { continue };
            match goal {
                LegGoal::Stay => {}
                LegGoal::By(change) => to[body] = to[body] + *change,
                LegGoal::To(load) => to[body] = *load,
            }
        }
        self.0 = Some(Arc::new([from, to]));
    }

    /// The generalised forces of all body loads on the coordinates of the grasp, at the beginning and at the end of the leg. `None` until a leg
    /// changes a body load.
    pub(super) fn inside(&self, grasp: &Engine) -> Option<[Vector; 2]> {
        let (loads, bodies) = self.0.as_ref().zip(grasp.bodies())?;
        Some([0, 1].each(|end| grasp.combine_wrenches(bodies, &loads[end])))
    }

    /// The loads on all bodies, without their permanent loads: at the beginning of the present leg if `end` is 0, at its end if `end` is 1.
    /// Empty until a leg changes a body load.
    pub(super) fn at_end(&self, end: usize) -> &[Wrench<3>] {
        self.0.as_ref().map_or(&[], |loads| &loads[end])
    }

    /// The grasp with its bodies under the loads that they have at a fraction of the present leg. If no leg has changed a body load, `grasp` is
    /// returned unchanged.
    pub(super) fn apply<'g>(&self, grasp: &'g Engine, fraction: f64) -> Cow<'g, Engine> {
        let Some(loads) = &self.0 else { return Cow::Borrowed(grasp) };
        let at = |(from, to): (&Wrench<3>, &Wrench<3>)| *from + (*to - *from) * fraction;
        let now = paired(&loads[0], &loads[1], &at);
        Cow::Owned(grasp.under_body_loads(now))
    }
}
