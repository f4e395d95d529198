//! What facets do to an answer: the polygon inside the round cone, the cone itself, the polygon around it.

use super::answer::{Equilibrium, Outcome};
use crate::contact::{Fit, PolygonCone};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::search::Settings;

/// One load on three friction cones: inscribed polygon ⊂ round cone ⊂ circumscribed polygon.
///
/// What follows from the inclusion:
///
/// * What rolls on a smaller cone rolls on a larger one with the same forces. If everything that touches rolls on the inscribed
///   polygon, the three answers are one.
/// * The onset of sliding is bracketed, from a base that the inscribed polygon answers by
///   [`Rung::EverythingRolls`](super::Rung::EverythingRolls) or
///   [`Rung::EverythingTouchingRolls`](super::Rung::EverythingTouchingRolls): until the first contact slides or opens, forces do not
///   depend on the cone. The factors of [`Grasp::onset_with`] on the two polygons then have that of [`Grasp::onset`] between
///   them. From other bases they need not: there the inscribed polygon may have come to rest on fewer contacts.
/// * A load that [a motion separates](super::Proof::SeparatingMotion) from everything the circumscribed polygon can do is too much
///   for the round cone as well, with any stiffness.
///
/// Once contacts slide there is no such order: a force on a larger cone may be smaller, and the direction of slip on a polygon
/// jumps from normal to normal. The spread is then the measured effect of the facets, **not a bound** of the round answer's
/// distance to either, nor must that answer lie between them. Where several equilibria exist the three may be different ones.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Bracket<const D: usize, const C: usize> {
    /// The answer on the polygon with corners on the round cone.
    pub inscribed: Outcome<D, C>,
    /// The answer on the round cone.
    pub round: Outcome<D, C>,
    /// The answer on the polygon with facets that touch the round cone.
    pub circumscribed: Outcome<D, C>,
    /// How far they lie apart; `None` unless all three are equilibria.
    pub spread: Option<Spread>,
}

/// The largest distance between any two of three answers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Spread {
    /// Largest difference of the force of a contact, N.
    pub force: f64,
    /// Largest difference of the displacement of the body's core at a contact, m.
    pub displacement: f64,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibrium under a load on the round cone, and on the inscribed and the circumscribed polygon with as many facets as
    /// `settings.cone` has; its fit and `settings.round` are not looked at. In the plane the three are one.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    ///
    /// // Three fingers under a plate of 12 N, μ = 0.5: they hold 6 N sideways on the round cone.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(100.0, 100.0).friction(0.5).command([0.04, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(-1.0, -1.0), finger(1.0, -1.0), finger(0.0, 2.0)])?;
    ///
    /// // Below 6 cos(π/8) N everything rolls on every polygon of 8 facets, and the three answers are one.
    /// let bracket = grasp.bracket(&Wrench::force([5.5, 0.0, -12.0]))?;
    /// assert!(bracket.spread.expect("three equilibria").force < 1e-14);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn bracket(&self, load: &Wrench<D, C>) -> Result<Bracket<D, C>, Error> {
        self.bracket_with(load, &Settings::default())
    }

    /// [`Self::bracket`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::bracket`].
    pub fn bracket_with(&self, load: &Wrench<D, C>, settings: &Settings) -> Result<Bracket<D, C>, Error> {
        let on = |fit: Fit| {
            let polygon = PolygonCone::new(settings.cone.facets(), fit)?;
            self.solve_with(load, &(*settings).with_cone(polygon).on_the_polygon())
        };
        let (inscribed, circumscribed) = (on(Fit::Inscribed)?, on(Fit::Circumscribed)?);
        let round = self.solve_with(load, &Settings { round: true, ..*settings })?;
        let all = [&inscribed, &round, &circumscribed].map(Outcome::equilibrium);
        let spread = if let [Some(a), Some(b), Some(c)] = all {
            Some([(a, b), (b, c), (a, c)].map(|(x, y)| Spread::between(x, y)).into_iter().fold(
                Spread { force: 0.0, displacement: 0.0 },
                |most, s| Spread {
                    force: most.force.max(s.force),
                    displacement: most.displacement.max(s.displacement),
                },
            ))
        } else {
            None
        };
        Ok(Bracket { inscribed, round, circumscribed, spread })
    }
}

impl Spread {
    fn between<const D: usize, const C: usize>(a: &Equilibrium<D, C>, b: &Equilibrium<D, C>) -> Self {
        let pairs = || a.contacts.iter().zip(&b.contacts);
        Self {
            force: pairs().map(|(x, y)| (x.force - y.force).norm()).fold(0.0, f64::max),
            displacement: pairs().map(|(x, y)| (x.body_core - y.body_core).norm()).fold(0.0, f64::max),
        }
    }
}
