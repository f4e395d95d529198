//! One question asked of many loads, ramps, turns or grasps.

use super::in_order::map_in_order;
use crate::equilibrium::{Outcome, Settings};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::load_path::{Onset, Ramp, Turn, TurnOnset};

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibria under many loads, each that of [`Self::solve_with`], in the order of the
    /// loads; an error in one does not stop the rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let loads = [3.0, 30.0].map(|weight| Wrench::force([0.0, -weight]));
    /// let outcomes = grasp.solve_each(&loads).into_iter().collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!([true, false], [0, 1].map(|i| outcomes[i].equilibrium().is_some()));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn solve_each(&self, loads: &[Wrench<D, C>]) -> Vec<Result<Outcome<D, C>, Error>> {
        self.solve_each_with(loads, &Settings::default())
    }

    /// [`Self::solve_each`] with other [`Settings`].
    #[must_use]
    pub fn solve_each_with(
        &self,
        loads: &[Wrench<D, C>],
        settings: &Settings,
    ) -> Vec<Result<Outcome<D, C>, Error>> {
        map_in_order(loads, |load| self.solve_with(load, settings))
    }

    /// The onsets of sliding along many ramps, each that of [`Self::onset`], in the order of the
    /// ramps; an error in one does not stop the rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let tilted = |angle: f64| Ramp::load(Wrench::ZERO, Wrench::force([angle.sin(), -angle.cos()]));
    /// let onsets = grasp.onset_each(&[tilted(0.0), tilted(0.5)]);
    /// let factors = onsets.into_iter().map(|onset| onset.map(|o| o.factor().expect("slides"))).collect::<Result<Vec<_>, _>>()?;
    /// // The contact that the pull relieves slides first: W cos φ / 2 = μ (10 - W sin φ / 2).
    /// assert!((factors[1] - 10.0 / (0.5_f64.cos() + 0.5 * 0.5_f64.sin())).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_each(&self, ramps: &[Ramp<D, C>]) -> Vec<Result<Onset<D, C>, Error>> {
        self.onset_each_with(ramps, &Settings::default())
    }

    /// [`Self::onset_each`] with other [`Settings`].
    #[must_use]
    pub fn onset_each_with(
        &self,
        ramps: &[Ramp<D, C>],
        settings: &Settings,
    ) -> Vec<Result<Onset<D, C>, Error>> {
        map_in_order(ramps, |ramp| self.onset_with(ramp, settings))
    }

    /// The onsets of sliding while each of many loads turns, each that of [`Self::onset_of_turn`], in the order of the turns; an
    /// error in one does not stop the rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Turn};
    ///
    /// // Two palms that press with 10 N each, μ = 0.5, and boxes that start on their sides.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let turns = [9.0, 12.0].map(|weight| Turn::force_at([weight, 0.0], [0.0, 0.0]));
    /// for (onset, weight) in grasp.onset_of_turn_each(&turns).into_iter().zip([9.0, 12.0_f64]) {
    ///     // w/2 sin θ + w/4 cos θ = 5 where a palm slides.
    ///     let angle = onset?.onset.factor().expect("slides");
    ///     assert!((weight * (0.5 * angle.sin() + 0.25 * angle.cos()) - 5.0).abs() < 1e-13);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_of_turn_each(&self, turns: &[Turn<D, C>]) -> Vec<Result<TurnOnset<D, C>, Error>> {
        self.onset_of_turn_each_with(turns, &Settings::default())
    }

    /// [`Self::onset_of_turn_each`] with other [`Settings`].
    #[must_use]
    pub fn onset_of_turn_each_with(
        &self,
        turns: &[Turn<D, C>],
        settings: &Settings,
    ) -> Vec<Result<TurnOnset<D, C>, Error>> {
        map_in_order(turns, |turn| self.onset_of_turn_with(turn, settings))
    }
}

/// The onsets of sliding of many grasps along one ramp, each that of [`Grasp::onset`], in the order
/// of the grasps; an error in one does not stop the rest.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
/// use grasp_lcp::sweep::onset_of_each;
///
/// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N: they slide at 2 μ N.
/// let frictions = [0.2, 0.4, 0.8];
/// let pinch = |mu: f64| {
///     let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0]);
///     Grasp::new([finger(-1.0), finger(1.0)])
/// };
/// let grasps = frictions.into_iter().map(pinch).collect::<Result<Vec<_>, _>>()?;
/// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
/// for (onset, mu) in onset_of_each(&grasps, &weight).into_iter().zip(frictions) {
///     assert!((onset?.factor().expect("slides") - 2.0 * mu * 10.0).abs() < 1e-13);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[must_use]
pub fn onset_of_each<const D: usize, const C: usize>(
    grasps: &[Grasp<D, C>],
    ramp: &Ramp<D, C>,
) -> Vec<Result<Onset<D, C>, Error>> {
    onset_of_each_with(grasps, ramp, &Settings::default())
}

/// [`onset_of_each`] with other [`Settings`].
#[must_use]
pub fn onset_of_each_with<const D: usize, const C: usize>(
    grasps: &[Grasp<D, C>],
    ramp: &Ramp<D, C>,
    settings: &Settings,
) -> Vec<Result<Onset<D, C>, Error>> {
    map_in_order(grasps, |grasp| grasp.onset_with(ramp, settings))
}
