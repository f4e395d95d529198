//! Effect of facets on an answer: the polygon inside the round cone, the cone itself, the polygon around it.

use super::answer::{Equilibrium, Outcome};
use crate::contact::{Fit, PolygonCone};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::Each;
use crate::search::Settings;

/// One load on three friction cones: inscribed polygon ⊂ round cone ⊂ circumscribed polygon.
///
/// Consequences of the inclusion:
///
/// * A contact that sticks on a smaller cone sticks on a larger one with the same forces. If everything that touches sticks on the inscribed
///   polygon, the three answers are equal.
/// * The onset of sliding is bracketed, if the inscribed polygon answers the base by [`FoundBy::EverythingSticks`](super::FoundBy::EverythingSticks)
///   or [`FoundBy::EverythingTouchingSticks`](super::FoundBy::EverythingTouchingSticks): until the first contact slides or opens, forces do not
///   depend on the cone. The factor of [`Grasp::onset`](crate::ask::Grasp::onset) on the round cone then lies between those on the two polygons. From
///   other bases it need not: the inscribed polygon may then rest on fewer contacts.
/// * A load that [a motion separates](super::Proof::SeparatingMotion) from all forces of the circumscribed polygon is too large
///   for the round cone as well, with any stiffness.
///
/// Once contacts slide there is no such order: a force on a larger cone may be smaller, and the direction of slip on a polygon jumps from normal to
/// normal. The spread is then the measured effect of the facets, **not a bound** on the distance of the round answer to either. That answer need
/// not lie between them. If several equilibria exist, the three may be different ones.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Bracket<const C: usize> {
    /// The answer on the polygon with corners on the round cone.
    pub inscribed: Outcome<C>,
    /// The answer on the round cone.
    pub round: Outcome<C>,
    /// The answer on the polygon with facets that touch the round cone.
    pub circumscribed: Outcome<C>,
    /// Largest distances between the three answers; `None` unless all three are equilibria.
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

impl Engine {
    /// [`Grasp::bracket`](crate::ask::Grasp::bracket).
    pub(crate) fn bracket(&self, load: &Wrench<3>, settings: &Settings) -> Result<Bracket<3>, Error> {
        let on = |fit: Fit| {
            let polygon = PolygonCone::new(settings.cone.facets(), fit)?;
            self.solve(load, &(*settings).with_cone(polygon).on_the_polygon())
        };
        let (inscribed, circumscribed) = (on(Fit::Inscribed)?, on(Fit::Circumscribed)?);
        let round = self.solve(load, &Settings { round: true, ..*settings })?;
        let all = [&inscribed, &round, &circumscribed].each(Outcome::equilibrium);
        let spread = if let [Some(a), Some(b), Some(c)] = all {
            Some([(a, b), (b, c), (a, c)].each(|(x, y)| Spread::between(x, y)).into_iter().fold(
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
    fn between(a: &Equilibrium<3>, b: &Equilibrium<3>) -> Self {
        let pairs = || a.contacts.iter().zip(&b.contacts);
        Self {
            force: pairs().map(|(x, y)| (x.force - y.force).norm()).fold(0.0, f64::max),
            displacement: pairs().map(|(x, y)| (x.body_core - y.body_core).norm()).fold(0.0, f64::max),
        }
    }
}
