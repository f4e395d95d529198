//! The least factor on commands and vacuums with which all contacts stick, and the direction in which the least force makes a contact cease to stick.
//! The base load is constant and acts together with that force.

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::{Face, Wrench, inside, outside};
use crate::squeeze::{LeastSqueeze, Loads, WeakestDirection};

impl<const C: usize> Grasp<C> {
    /// The least factor on all finger commands and vacuums with which every contact touches and sticks under each of a set of loads. In space
    /// friction cones are round.
    ///
    /// The factors with which every contact sticks form an interval, because the margin of each sticking condition is a concave function of the
    /// factor. The search starts below this interval. As long as a condition is broken at the present factor, that condition gives a larger lower
    /// bound of the interval, which is tried next. Clearances are not multiplied.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, LeastSqueeze, Loads, Turn, Wrench};
    ///
    /// // Two palms that press with 1 N each, μ = 0.5, hold a box. Carried upright, 12 N need 12 times as much: 6 N of friction at each.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(1.0);
    /// let palms = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let needed = |loads: Loads| match palms.least_squeeze(&loads)? {
    ///     LeastSqueeze::Factor { factor, .. } => Ok::<f64, grasp_lcp::Error>(factor),
    ///     other => panic!("{other:?}"),
    /// };
    /// assert!((needed(Loads::Each(vec![Wrench::force([0.0, -12.0])]))? - 12.0).abs() < 1e-14);
    /// // Turned over it needs more, where a palm is half below: F_t = 6 cos θ, F_n = s - 6 sin θ.
    /// let turned = needed(Loads::Turn(Turn::tilting([0.0, -12.0], [0.0, 0.0])))?;
    /// assert!((turned - 180_f64.sqrt()).abs() < 1e-13);
    /// // So it does for 12 N of any direction.
    /// let any = Loads::AnyForce { base: Wrench::ZERO, size: 12.0, point: [0.0, 0.0] };
    /// assert!((needed(any)? - turned).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is out of range. [`Error::Argument`] if another number of `loads` is out of range, or if `loads` is empty.
    /// [`Error::NotForHands`] for a grasp by a hand.
    #[doc(alias = "grip force", alias = "clamp preload", alias = "gripping force")]
    pub fn least_squeeze(&self, loads: &Loads<C>) -> Result<LeastSqueeze<C>, Error> {
        self.engine.least_squeeze(&inside(loads), &self.settings).map(outside)
    }

    /// The direction in which the least force through a point (m) makes a contact cease to stick, in addition to a base load; in space on the round
    /// cone.
    ///
    /// For each facet of a friction cone the worst direction has a closed form. With the contact forces F⁰ under the base load, a force x gives
    /// contact forces `F⁰ + A x`. Here A is the influence matrix of the grasp and a the row of the facet, whose condition is `a·F >= 0`. The shortest
    /// x that breaks it lies along `-Aᵀa` and has the magnitude `a·F⁰ / |Aᵀa|`.
    ///
    /// The round cone has a facet at every angle φ, and the least force over all φ is sought. At every φ a force of magnitude s must not break the
    /// condition, i.e. `a·F⁰ - s |Aᵀa| >= 0`. The squares of both terms are trigonometric polynomials in φ. All sign changes of their difference are
    /// found. The result is therefore the least of all minima, up to rounding. The module [`squeeze`](crate::squeeze) describes the method.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, WeakestDirection, Wrench};
    ///
    /// // Two fingers that press with 10 N, μ = 0.5: along the line of the fingers 20 N open one, across 10 N make both slide. Between, a
    /// // finger carries F_n = 10 + x/2, F_t = y/2: y/2 = 5 + x/4 is nearest at x = -4, y = 8.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 1000.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let WeakestDirection::Force { size, direction, .. } = grasp.weakest_direction(Wrench::ZERO, [0.0, 0.0])? else { panic!("it slides") };
    /// assert!((size - 80_f64.sqrt()).abs() < 1e-14);
    /// assert!((direction[0].abs() - 0.2_f64.sqrt()).abs() < 1e-15 && (direction[1].abs() - 0.8_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the base load is not finite or beyond 1e50, [`Error::Argument`] if the point is not finite or beyond 1e50.
    pub fn weakest_direction(
        &self,
        base: impl Into<Wrench<C>>,
        point: impl Into<[f64; C]>,
    ) -> Result<WeakestDirection<C>, Error> {
        self.engine
            .weakest_direction(&inside(&base.into()), point.into().into_inside(), &self.settings)
            .map(outside)
    }
}
