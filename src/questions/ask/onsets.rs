//! The load factor or the angle of first slip, at which the first contact ceases to stick. On a ramp the load, the commands of fingers (displacements
//! that they would make if there were no object), or both change in proportion to a load factor.

use super::grasp::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{inside, outside};
use crate::load_path::{Beyond, Onset, OnsetEvent, Ramp, Turn, TurnOnset};

impl<const C: usize> Grasp<C> {
    /// The load factor at which the first contact ceases to stick as a load grows from zero, or along a [`Ramp`]. The answer names the contacts that
    /// cease to stick, and whether they slide or open. The load factor is exact up to rounding, in the plane and in space on the round cone. It is
    /// computed without steps or bisection. In the plane there is a linear equation for each facet of a friction cone, on the round cone a quadratic
    /// equation for each contact.
    ///
    /// From the event in the answer, [`Self::state_at_onset`] computes the equilibrium at first slip, and [`Self::beyond`] the behaviour just beyond
    /// it.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Both contacts slide when half the load is μ N = 5 N.
    /// let onset = grasp.onset(Wrench::force([0.0, -1.0]))?;
    /// let event = onset.event().expect("friction is finite");
    /// assert!((event.factor - 10.0).abs() < 1e-14);
    /// assert_eq!(event.leaving.len(), 2);
    ///
    /// // The fingers let go under 4 N: F_t = 2 N needs F_n = 4 N, which is left after 6 mm.
    /// let release = Ramp::commands(Wrench::force([0.0, -4.0]), [[-1.0, 0.0]; 2]);
    /// let factor = grasp.onset(&release)?.factor().expect("sticks at first");
    /// assert!((factor - 0.006).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if
    /// there are more or fewer command changes than contacts.
    #[doc(alias = "first slip", alias = "slip margin", alias = "incipient slip")]
    pub fn onset(&self, ramp: impl Into<Ramp<C>>) -> Result<Onset<C>, Error> {
        self.engine.onset(&inside(&ramp.into()), &self.settings).map(outside)
    }

    /// The equilibrium at first slip. All contacts stick, and the forces of the contacts that cease to stick at this load are on the boundaries of
    /// their friction cones. `None` if `event` belongs to a grasp with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let onset = grasp.onset(Wrench::force([0.0, -1.0]))?;
    ///
    /// let state = grasp.state_at_onset(onset.event().expect("slides")).expect("its own event");
    /// assert!((state.contacts[0].friction_used() - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn state_at_onset(&self, event: &OnsetEvent<C>) -> Option<Equilibrium<C>> {
        self.engine.state_at_onset(&inside(event), &self.settings).map(outside)
    }

    /// The behaviour of the grasp just beyond first slip ([`Beyond`]). `None` if `event` belongs to a grasp with another number of contacts.
    #[doc(alias = "gross slip")]
    #[must_use]
    pub fn beyond(&self, event: &OnsetEvent<C>) -> Option<Beyond<C>> {
        self.engine.beyond(&inside(event), &self.settings).map(outside)
    }

    /// The angle at which the first contact ceases to stick while the load turns. It is exact up to rounding, in the plane and in space on the round
    /// cone. No steps are needed: the sticking condition of each contact is a trigonometric polynomial of the angle. Its roots are isolated between
    /// its extrema, so that none is missed.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Onset, Turn};
    ///
    /// // A box of 2 N between two palms that press with 10 N each, μ = 0.5, tilted: its weight comes to lie on one of them.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let palms = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let light = palms.onset_of_turn(Turn::tilting([0.0, -2.0], [0.0, 0.0]))?;
    /// assert!(matches!(light.onset, Onset::Never));
    ///
    /// // 12 N would slide at once on its side: the palm above carries F_n = 10 - 6 sin θ and F_t = 6 cos θ. μ F_n = F_t where
    /// // 6 cos θ + 3 sin θ = 5; upright it needs 6 N of 5 N.
    /// let heavy = palms.onset_of_turn(Turn::tilting([0.0, -12.0], [0.0, 0.0]))?;
    /// assert!(matches!(heavy.onset, Onset::AlreadySliding(_) | Onset::NoBase(_)));
    /// let from_its_side = Turn::tilting([12.0, 0.0], [0.0, 0.0]).reversed();
    /// let onset = palms.onset_of_turn(&from_its_side)?.onset;
    /// // 6 sin θ + 3 cos θ = 5 there.
    /// let closed = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    /// assert!((onset.factor().expect("slides") - closed).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite, or beyond 1e50. [`Error::Argument`] unless the angle is more than zero, and at
    /// most 1e6.
    pub fn onset_of_turn(&self, turn: impl Into<Turn<C>>) -> Result<TurnOnset<C>, Error> {
        self.engine.onset_of_turn(&inside(&turn.into()), &self.settings).map(outside)
    }
}
