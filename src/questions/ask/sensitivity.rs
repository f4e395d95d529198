//! Derivatives of answers by the data.

use super::grasp::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{inside, outside};
use crate::load_path::{Derivative, GeometryGradient, OnsetEvent, OnsetGradient, Parameter, Response};
use crate::prelude::*;
use crate::sweep::{OnsetSpread, Uncertainty};

/// Derivatives of a grasp's answers by its data, made by [`Grasp::sensitivity`].
#[derive(Debug, Clone, Copy)]
pub struct Sensitivity<'g, const C: usize>(pub(super) &'g Grasp<C>);

impl<const C: usize> Sensitivity<'_, C> {
    /// Derivatives of the onset by every parameter, one gradient for each leaving contact: `dτ = -dm / m'`. The vanishing margin is
    /// m = `μ F_n - |F_t|` (F_n where a contact opens), and m' its rate along the ramp. For a load that turns they are derivatives of the angle.
    ///
    /// Empty if a contact closed before the onset, since the onset then depends on that history, or if a contact closes there and slides at once. Also
    /// empty if the event has another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let onset = grasp.onset(&ramp)?;
    /// // A contact leaves at W = 2 μ N, so ∂W/∂μ = 2 N = 20 newtons.
    /// let gradient = &grasp.sensitivity().onset_gradients(onset.event().expect("slides"))[0];
    /// assert!((gradient.friction[0] - 20.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_gradients(&self, event: &OnsetEvent<C>) -> Vec<OnsetGradient<C>> {
        outside(self.0.engine.onset_gradients(&inside(event)))
    }

    /// Derivatives of the onset by positions and normals of the contacts, one for each leaving contact, exact to first order: one linear solve for
    /// each datum. Empty where [`Sensitivity::onset_gradients`](crate::ask::Sensitivity::onset_gradients) is.
    ///
    /// A change of a point or a normal moves or turns the contact frame, and thus changes the grasp map. With contact stiffness K, motion q and forces
    /// F:
    ///
    /// ```text
    /// dF_i = -K_i (G_iᵀdq + dG_iᵀq),      Σ (G_i dF_i + dG_i F_i) = 0,      dτ = -dm / m'
    /// ```
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 10 N, μ = 0.5, under a weight whose line is the middle: each carries half of it.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset(Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0])))?;
    ///
    /// // The left finger comes nearer to that line by d: its share is 1 / (2 - d), the onset 2 μ N (1 - d/2).
    /// let gradient = &grasp.sensitivity().onset_gradients_by_geometry(onset.event().expect("slides"))?[0];
    /// assert!((gradient.point[0][0] + 5.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a grasp by a hand, whose joints would move a contact at another place differently. Derivatives by directions of
    /// normals alone are in [`Sensitivity::of`](crate::ask::Sensitivity::of), for hands, too.
    pub fn onset_gradients_by_geometry(
        &self,
        event: &OnsetEvent<C>,
    ) -> Result<Vec<GeometryGradient<C>>, Error> {
        self.0.engine.onset_gradients_by_geometry(&inside(event)).map(outside)
    }

    /// Response of an equilibrium of this grasp to its finger commands while every contact keeps its state: one linear solve for each axis of each
    /// contact. `None` if the equilibrium has another number of contacts, or if a command has no equilibrium in these states.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Twist, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.solve(Wrench::force([0.0, -4.0]))?;
    /// let response = grasp.sensitivity().response(outcome.equilibrium().expect("holds")).expect("regular");
    /// // The left finger moves on by 1 m: the object goes half the way, its force grows by half its stiffness.
    /// assert!((response.twist[(0, 0)] - 0.5).abs() < 1e-14);
    /// assert!((response.forces[(0, 0)] - 500.0).abs() < 1e-11);
    ///
    /// // 1 mm to the right: the left finger follows, the right one, whose normal points left, gives way.
    /// let command = response.smallest_command(&Twist::new([1e-3, 0.0], 0.0)).expect("can be reached");
    /// assert!((command[0] - 1e-3).abs() < 1e-16 && (command[2] - -1e-3).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn response(&self, equilibrium: &Equilibrium<C>) -> Option<Response> {
        self.0.of_equilibrium(equilibrium).engine.response(&inside(equilibrium))
    }

    /// Response of an equilibrium to the joint commands of its hand while every contact and every drive keeps its state: as
    /// [`Sensitivity::response`](crate::ask::Sensitivity::response), with a column for each joint and then each tendon.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    /// use grasp_lcp::planar::{Twist, Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3).command(0.01)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 1e3).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?;
    /// let outcome = grasp.solve(Wrench::ZERO)?;
    /// let response = grasp.sensitivity().joint_response(outcome.equilibrium().expect("holds")).expect("regular");
    /// // 1 mm to the right: the left jaw closes by as much as the right one opens.
    /// let commands = response.smallest_command(&Twist::new([1e-3, 0.0], 0.0)).expect("can be reached");
    /// assert!((commands[0] - 1e-3).abs() < 1e-15 && (commands[1] + 1e-3).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn joint_response(&self, equilibrium: &Equilibrium<C>) -> Option<Response> {
        self.0.of_equilibrium(equilibrium).engine.joint_response(&inside(equilibrium))
    }

    /// Derivative of an equilibrium of this grasp by one parameter while every contact keeps its state: one linear solve, exact. On a load path earlier
    /// slips are held constant. `None` if an index is out of range or the equilibrium has another number of contacts. Also `None` if the change has no
    /// equilibrium in these states (a load on a free motion), for the position of a contact of a hand, and where changed geometry would resist a motion
    /// that is free now.
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

    /// Spread of the onset of a ramp, or of a load that turns, under uncertain data. `None` where
    /// [`Sensitivity::onset_gradients`](crate::ask::Sensitivity::onset_gradients) is empty.
    ///
    /// # Errors
    /// [`Error::NotForHands`] for uncertain positions of a hand's contacts.
    pub fn onset_spread(
        &self,
        event: &OnsetEvent<C>,
        uncertainty: &Uncertainty,
    ) -> Result<Option<OnsetSpread>, Error> {
        self.0.engine.onset_spread(&inside(event), uncertainty)
    }
}
