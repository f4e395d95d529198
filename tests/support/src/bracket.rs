//! One load on three friction cones: inscribed polygon ⊂ round cone ⊂ circumscribed polygon.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{Equilibrium, Outcome};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::{Error, PolygonCone, PolygonFit};

/// The answers for one load on three friction cones, and the largest distances between them.
#[derive(Debug, Clone)]
pub struct Bracket<const C: usize> {
    /// The answer on the polygon with corners on the round cone.
    pub inscribed: Outcome<C>,
    /// The answer on the round cone.
    pub round: Outcome<C>,
    /// The answer on the polygon with facets that touch the round cone.
    pub circumscribed: Outcome<C>,
    /// Largest difference of the force of a contact, N, and of the displacement of the body's core at a contact, m; `None` unless all three are
    /// equilibria.
    pub spread: Option<[f64; 2]>,
}

/// Solves for a load on the round cone and on both polygons with as many facets as the settings of the grasp.
pub fn bracket<const C: usize>(grasp: &Grasp<C>, load: Wrench<C>) -> Result<Bracket<C>, Error> {
    let settings = *grasp.settings();
    let on = |fit| {
        let polygon = PolygonCone::new(settings.cone.facets(), fit)?;
        grasp.with(&settings.with_cone(polygon).on_the_polygon()).solve(load)
    };
    let (inscribed, round, circumscribed) =
        (on(PolygonFit::Inscribed)?, grasp.solve(load)?, on(PolygonFit::Circumscribed)?);
    let all = [&inscribed, &round, &circumscribed].map(Outcome::equilibrium);
    let spread = if let [Some(a), Some(b), Some(c)] = all {
        let pairs = [apart(a, b), apart(b, c), apart(a, c)];
        Some([0, 1].map(|k| pairs.iter().map(|pair| pair[k]).fold(0.0, f64::max)))
    } else {
        None
    };
    Ok(Bracket { inscribed, round, circumscribed, spread })
}

fn apart<const C: usize>(a: &Equilibrium<C>, b: &Equilibrium<C>) -> [f64; 2] {
    let pairs = || a.contacts.iter().zip(&b.contacts);
    [
        pairs().map(|(x, y)| (x.force - y.force).norm()).fold(0.0, f64::max),
        pairs().map(|(x, y)| (x.body_core - y.body_core).norm()).fold(0.0, f64::max),
    ]
}
