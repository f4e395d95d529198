//! Static questions: which loads can be balanced by some contact forces inside the friction cones. The base load is constant and acts before the
//! loads of a question. A budget is an upper limit of the normal force of each contact, or of the sum of all normal forces. A command is the
//! displacement that a finger would make if there were no object. The squeeze is everything by which contacts press at rest without a load. A bonded
//! contact neither opens nor slips.

use super::grasp::Grasp;
use crate::equilibrium::{Decomposition, Equilibrium};
use crate::error::Error;
use crate::grasp::{Wrench, all_inside, inside, outside};
use crate::shake::Shakedown;
use crate::statics::{Budget, Closure, LoadLimit, WrenchBall, WrenchScale};

/// Static questions about a grasp, made by [`Grasp::statics`]: all answers but that of [`shakedown`](Self::shakedown) are independent of springs and
/// commands.
#[derive(Debug, Clone, Copy)]
pub struct Statics<'g, const C: usize>(pub(super) &'g Grasp<C>);

impl<const C: usize> Statics<'_, C> {
    /// Whether contact forces inside their friction cones could balance any load; in space on the round cone.
    ///
    /// The answer does not depend on stiffness, commands and squeeze: it says whether the fingers *could* balance any load if they pressed as needed.
    ///
    /// ```
    /// use grasp_lcp::planar::{Closure, Contact, Grasp};
    ///
    /// // Two fingers opposite each other with friction; in the plane that is enough. One that is moved up lies outside the other's cone.
    /// let finger = |x: f64, y: f64| Contact::new([x, y], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5);
    /// let pinch = Grasp::new([finger(-1.0, 0.0), finger(1.0, 0.0)])?;
    /// assert!(matches!(pinch.statics().force_closure()?, Closure::Closed { .. }) && matches!(pinch.statics().form_closure()?, Closure::Open { .. }));
    /// let apart = Grasp::new([finger(-1.0, 0.0), finger(1.0, 1.5)])?;
    /// assert!(matches!(apart.statics().force_closure()?, Closure::Open { .. }));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// For several bodies the question is about all loads on all of them at once. If these cannot be balanced, the answer has motions of the bodies
    /// that nothing resists.
    ///
    /// ```
    /// use grasp_lcp::planar::{Bodies, Body, Closure, Contact};
    ///
    /// // A box on a table: up it may go. A lid that does not move keeps it there.
    /// let at = |x: f64, y: f64, down: f64, on: &str| {
    ///     Contact::new([x, y], [0.0, down]).series_stiffness(1e4, 1e4).friction(0.5).on(on)
    /// };
    /// let boxes = || Bodies::new([Body::new("lower"), Body::new("upper")])
    ///     .contacts([-0.1, 0.1].map(|x| at(x, 0.0, 1.0, "lower")))
    ///     .contacts([-0.1, 0.1].map(|x| at(x, 0.2, 1.0, "upper").against("lower")));
    /// let Closure::Open { bodies, .. } = boxes().grasp()?.statics().force_closure()? else { panic!("may go up") };
    /// assert!(bodies.iter().any(|moves| moves.body.as_ref() == "upper" && moves.twist.translation()[1] > 0.0));
    /// let shut = boxes().contacts([-0.1, 0.1].map(|x| at(x, 0.4, -1.0, "upper"))).grasp()?;
    /// assert!(matches!(shut.statics().force_closure()?, Closure::Closed { .. }));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand, [`Error::NotForJoints`] for bodies that a hand holds or a given force presses. [`Error::Vacuum`]
    /// if contacts alone do not hold the object and suction cups hold some loads.
    pub fn force_closure(&self) -> Result<Closure<C>, Error> {
        self.0.engine.force_closure(&self.0.settings).map(outside)
    }

    /// Whether the contacts hold the object without any friction, because normal forces alone could balance any load and so resist every motion to
    /// first order.
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand, [`Error::NotForJoints`] for bodies that a hand holds or a given force presses. [`Error::Vacuum`]
    /// if contacts alone do not hold the object and suction cups hold some loads.
    pub fn form_closure(&self) -> Result<Closure<C>, Error> {
        self.0.engine.form_closure().map(outside)
    }

    /// The largest factor λ for which *some* contact forces balance the load `base + λ direction`, with normal forces within a budget. This is limit
    /// analysis, in space on the round cone. Pulls of suction cups act in addition and are not part of the budget. The factor does not depend on
    /// springs and commands, unlike the answer of [`Grasp::hold`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::statics::{Budget, LoadLimit};
    ///
    /// // Two fingers that face each other carry 2 · 0.5 · 10 N, if none may press with more than 10 N.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5);
    /// let pinch = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let limit = pinch.statics().load_limit(Wrench::ZERO, &Wrench::force([0.0, -1.0]), Budget::Each(10.0))?;
    /// let LoadLimit::Factor { at_least, at_most, forces, .. } = limit else { panic!("nothing is on it yet") };
    /// assert!((at_least - 10.0).abs() < 1e-9 && (at_most - 10.0).abs() < 1e-9);
    /// assert!(forces.iter().all(|force| (force[0] - 10.0).abs() < 1e-9));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite, or beyond 1e50; [`Error::Argument`] for a direction or a budget of zero; [`Error::Unlimited`] for a
    /// contact that is bonded, pulls or never slides; [`Error::NotForHands`] for a grasp by a hand.
    pub fn load_limit(
        &self,
        base: impl Into<Wrench<C>>,
        direction: impl Into<Wrench<C>>,
        budget: Budget,
    ) -> Result<LoadLimit<C>, Error> {
        self.0
            .engine
            .load_limit(&inside(&base.into()), &inside(&direction.into()), budget, &self.0.settings)
            .map(outside)
    }

    /// The measure ε of Ferrari and Canny: the magnitude, N, up to which contact forces within a budget balance loads of every direction. Moments
    /// count as forces after division by a length ([`WrenchScale`]). By default this length is the largest distance of a contact from the centroid of
    /// the contacts, about which moments are taken. Friction cones in space are round unless the settings ask for polygons.
    ///
    /// Pulls of suction cups are not part of the budget. A load counts as balanced if contact forces within the budget, together with these pulls,
    /// balance it.
    ///
    /// ε measures which loads some contact forces *could* balance. [`Self::onset`](Grasp::onset) takes the springs and the squeeze of the grasp into
    /// account.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    /// use grasp_lcp::statics::Budget;
    ///
    /// // Two fingers that face each other, μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5);
    /// let pinch = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let all = pinch.statics().ferrari_canny(Budget::Total(1.0))?;
    /// // The edges of both cones are (1, ±0.5, ∓0.5) and (-1, ±0.5, ±0.5): a tetrahedron whose faces are 1/3 away.
    /// assert!((all.at_least - 1.0 / 3.0).abs() < 1e-9 && (all.at_most - 1.0 / 3.0).abs() < 1e-9);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Argument`] for a budget that is not positive, [`Error::Unlimited`] for a contact that is bonded, pulls or never slides,
    /// [`Error::NotForHands`] for a grasp by a hand.
    pub fn ferrari_canny(&self, budget: Budget) -> Result<WrenchBall<C>, Error> {
        self.ferrari_canny_scaled(budget, &WrenchScale::of(self.0.contacts()))
    }

    /// [`Statics::ferrari_canny`](crate::ask::Statics::ferrari_canny) with another point about which moments are taken, and another length by which
    /// they are divided. The set of wrenches is approximated from points on its boundary; [`Settings::most_steps`](crate::Settings::most_steps)
    /// limits their number.
    ///
    /// # Errors
    /// The errors of [`Statics::ferrari_canny`](crate::ask::Statics::ferrari_canny); [`Error::Argument`] for a scale whose point or length is out of
    /// range.
    pub fn ferrari_canny_scaled(
        &self,
        budget: Budget,
        scale: &WrenchScale<C>,
    ) -> Result<WrenchBall<C>, Error> {
        self.0.engine.ferrari_canny(budget, &inside(scale), &self.0.settings).map(outside)
    }

    /// The multiple of `budget` that a load needs, as a lower and an upper bound. With `Budget::Each(1.0)` it is the normal force, N, that no contact
    /// must exceed in the best balance; with `Budget::Total(1.0)` the least sum of normal forces, N. Both bounds are infinite if no contact forces
    /// balance the load. The bounds are 0 and infinity if it is not known whether any contact forces balance the load.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::statics::Budget;
    ///
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5);
    /// let pinch = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let [at_least, at_most] = pinch.statics().budget_needed(Wrench::force([0.0, -3.0]), Budget::Each(1.0))?;
    /// assert!((at_least - 3.0).abs() < 1e-9 && (at_most - 3.0).abs() < 1e-9);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50; [`Error::Argument`] for a load or a budget of zero; [`Error::Unlimited`] for a
    /// contact that is bonded, pulls or never slides; [`Error::NotForHands`] for a grasp by a hand.
    pub fn budget_needed(&self, load: impl Into<Wrench<C>>, budget: Budget) -> Result<[f64; 2], Error> {
        Ok(match self.load_limit(Wrench::ZERO, load, budget)? {
            LoadLimit::Factor { at_least, at_most, .. } => [1.0 / at_most, 1.0 / at_least],
            LoadLimit::NoBase { .. } | LoadLimit::Undecided => [0.0, f64::INFINITY],
        })
    }

    /// Splits the contact forces of an equilibrium of this grasp into equilibrating forces, which balance the load W, and interaction forces, which
    /// balance one another. The paper on which the crate is based (`paper-notes.md`) defines them in section 5.2.
    ///
    /// The equilibrating forces are the least-squares solution of `Σ G_i F_i = -W`. Thus no two frictional contacts press against each other: the
    /// difference of their equilibrating forces has no component along the line that joins them. Separated contacts carry neither force. If the
    /// equilibrium belongs to another grasp, the answer is as long as the shorter of the two lists of contacts.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::Vector2;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(Wrench::force([0.0, -4.0]))?;
    /// let split = grasp.statics().decompose(outcome.equilibrium().expect("holds"));
    /// assert!((split.equilibrating[0] - Vector2::new(0.0, 2.0)).norm() < 1e-14);
    /// assert!((split.interaction[0] - Vector2::new(10.0, 0.0)).norm() < 1e-14);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn decompose(&self, equilibrium: &Equilibrium<C>) -> Decomposition<C> {
        outside(self.0.of_equilibrium(equilibrium).engine.decompose(&inside(equilibrium)))
    }

    /// The shakedown factor of loads that are added to a base load, one at a time, in any order and again and again. It is the largest multiple of
    /// these loads under which no contact needs to slide for ever. That is, some residual slips, which stay constant, keep every contact force inside
    /// its friction cone under each load. At a larger multiple the grasp never comes to rest as long as no contact opens. [`Grasp::shake`] shows
    /// whether it comes to rest at a smaller one. In space a polygon around the round cone is used, with as many facets as
    /// [`Settings::cone`](crate::Settings::cone). `None` if no slips keep the grasp at rest under the base load, or if nothing resists a load.
    ///
    /// Of the static questions only this one depends on springs and commands: slips push contacts against each other.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // A block of 10 N on two feet, μ = 0.5, pulled by 3.5 N and rocked by ±3 N m: it rests as long as the foot that carries less, 5 N - λ 1.5 N, holds half of the pull.
    /// let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1000.0, 1000.0).friction(0.5);
    /// let block = Grasp::new([foot(-1.0), foot(1.0)])?;
    /// let rocked = [3.0, -3.0].map(|moment| Wrench::new([0.0, 0.0], moment));
    /// let found = block.statics().shakedown(Wrench::force([3.5, -10.0]), &rocked)?.expect("rests without rocking");
    /// assert!((found.factor - 1.5 / 1.5).abs() < 1e-9 && !found.slips_change_normal_forces);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite, or beyond 1e50.
    pub fn shakedown(
        &self,
        base: impl Into<Wrench<C>>,
        loads: &[Wrench<C>],
    ) -> Result<Option<Shakedown<C>>, Error> {
        self.0.engine.shakedown(&inside(&base.into()), &all_inside(loads), &self.0.settings).map(outside)
    }
}
