//! Derivatives of answers (equilibria, load factors of first slip) with respect to the data of the grasp. At first slip the first contact ceases to
//! stick. A margin of sticking is the distance of a contact force from the boundary of its friction cone, or the normal force. A motion is free if no
//! spring resists it.

use super::grasp::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::{inside, outside};
use crate::load_path::{Derivative, OnsetEvent, OnsetMargins, Parameter};

/// Questions about derivatives of a grasp's answers with respect to its data, made by [`Grasp::sensitivity`].
#[derive(Debug, Clone, Copy)]
pub struct Sensitivity<'g, const C: usize>(pub(super) &'g Grasp<C>);

impl<'g, const C: usize> Sensitivity<'g, C> {
    /// The margins of sticking that vanish at first slip. They give the derivatives of the load factor of first slip with respect to every parameter.
    ///
    /// `None` if a contact closed before first slip: the load factor then depends on how far that contact slipped before it closed. Also `None` if a
    /// contact closes at first slip and slides at once. Finally `None` for the event of a grasp with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::load_path::Parameter;
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 10 N, μ = 0.5, under a weight whose line is the middle: each carries half of it.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset(Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0])))?;
    /// let margins = grasp.sensitivity().onset(onset.event().expect("slides")).expect("both stick before");
    ///
    /// // A contact leaves at W = 2 μ N, so ∂W/∂μ = 2 N = 20 newtons.
    /// let by_friction = margins.by(Parameter::Friction { contact: 0 }).expect("a contact");
    /// assert!((by_friction[0] - 20.0).abs() < 1e-12);
    /// // The left finger comes nearer to the line of the weight by d: its share is 1 / (2 - d), the onset 2 μ N (1 - d/2).
    /// let by_place = margins.by(Parameter::Point { contact: 0, axis: 0 }).expect("a contact");
    /// assert!((by_place[0] + 5.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset(&self, event: &OnsetEvent<C>) -> Option<OnsetMargins<'g>> {
        OnsetMargins::new(&self.0.engine, &inside(event))
    }

    /// Derivative of an equilibrium of this grasp with respect to one parameter while every contact keeps its contact state. It takes one linear
    /// solve and is exact. For an equilibrium of a load path, the slips before it stay constant.
    ///
    /// `None` if an index is out of range, or the equilibrium has another number of contacts. `None` also for the position of a contact of a hand,
    /// and if changed geometry would resist a motion that is free now. `None` finally if no equilibrium with these contact states balances the
    /// change, because a load does work along a free motion.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::load_path::Parameter;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(Wrench::force([0.0, -4.0]))?;
    /// let held = outcome.equilibrium().expect("holds");
    /// let by_weight = grasp.sensitivity().of(held, Parameter::Load { component: 1 }).expect("a component");
    /// assert!((by_weight.twist.translation()[1] - 1.0 / 1600.0).abs() < 1e-15); // two springs of 800 N/m
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn of(&self, equilibrium: &Equilibrium<C>, by: Parameter) -> Option<Derivative<C>> {
        self.0.of_equilibrium(equilibrium).engine.sensitivity(&inside(equilibrium), by).map(outside)
    }
}
