//! If a leg ends exactly where a contact reaches an edge of its cone, no event is reported yet. If the next leg crosses the edge, one event is
//! reported at its beginning. If the next leg turns back, none is reported. The paths are planar and computed by hand.
//!
//! One foot (k, kt, μ, pressed with N₀ = k a) stands under a body on two bonded springs, of total stiffness kb in both directions. The body does not
//! turn. A shear force P moves it by x = P/(kt + kb) while the foot sticks, up to kt x = μN. A lift Λ moves it by y = Λ/(k + kb), so that N = N₀ -
//! kΛ/(k + kb) (springs measured from rest under N₀).

use crate::story::{assert_close, assert_story, completed};
use grasp_lcp::load_path::PathEnd;
use grasp_lcp::planar::{Contact, ContactState, Grasp, Leg, LoadPath, Wrench};
use support::ends::limit_load;
use support::jaws::jaw;
use support::programs::numbers;

/// Stiffnesses, friction and command of each scene, with round and other numbers.
const SCENES: [[f64; 5]; 4] = [
    [30.0, 20.0, 10.0, 0.4, 0.2],
    [1.0 / 3.0, 0.7, 0.11, 0.3, 0.1],
    [std::f64::consts::E, std::f64::consts::PI, 1e-2, 1.7, 0.013],
    [2.3e6, 9.1e5, 4.7e7, 0.123, 3.3e-7],
];

struct Body {
    grasp: Grasp,
    k: f64,
    kt: f64,
    kb: f64,
    mu: f64,
    n: f64,
}

impl Body {
    fn new([k, kt, kb, mu, a]: [f64; 5]) -> Self {
        let foot =
            Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(k, kt).friction(mu).command([a, 0.0]);
        let spring =
            |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(kb / 2.0, kb / 2.0).bonded();
        Self { grasp: Grasp::new([foot, spring(-1.0), spring(1.0)]).unwrap(), k, kt, kb, mu, n: k * a }
    }

    /// A load. At the start it balances the force of the foot, and the springs are relaxed.
    fn load(&self, shear: f64, lift: f64) -> Wrench {
        Wrench::force([shear, lift - self.n])
    }

    fn leg(&self, shear: f64, lift: f64) -> Leg {
        Leg::load_to(self.load(shear, lift))
    }

    /// Follows a leg that ends on an edge, and checks that it has no event.
    fn up_to_the_edge(&self, shear: f64, lift: f64) -> LoadPath<'_> {
        let mut path = self.grasp.follow(self.load(0.0, 0.0), &[self.leg(shear, lift)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        path
    }

    /// The shear at which the foot slides under N₀.
    fn slides_at(&self) -> f64 {
        self.mu * self.n * (self.kt + self.kb) / self.kt
    }

    /// The lift at which the normal force is zero.
    fn opens_at(&self) -> f64 {
        self.n * (self.k + self.kb) / self.k
    }
}

fn scenes() -> impl Iterator<Item = Body> {
    SCENES.into_iter().map(Body::new)
}

#[test]
fn sliding_at_the_end_of_a_leg() {
    for body in scenes() {
        let edge = body.slides_at();
        let slides = |leg| (leg, 0.0, vec![(0, "slides")]);
        // The next leg has the same event, whether it is part of the program from the start or added later.
        let legs = [edge, 1.5 * edge].map(|p| body.leg(p, 0.0));
        let mut path = body.grasp.follow(body.load(0.0, 0.0), &legs).unwrap();
        assert_story(&path.run(), &[slides(1)]);
        let mut path = body.up_to_the_edge(edge, 0.0);
        let stands = path.state().unwrap();
        assert_eq!(stands.contacts[0].state, ContactState::Sticking);
        assert!(stands.contacts[0].margin.abs() < 1e-12 * body.n);
        path.continue_with(&[body.leg(1.5 * edge, 0.0)]).unwrap();
        assert_story(&path.run(), &[slides(1)]);
        // At the end the springs carry the shear force minus μN, as they do without the cut of the leg.
        let end = path.state().unwrap();
        assert_close!(
            end.twist.translation()[0] * body.kb / body.n,
            (1.5 * edge - body.mu * body.n) / body.n
        );
        // While the foot slides, a new leg causes no event, nor does a leg without a change of load.
        path.continue_with(&[
            body.leg(1.7 * edge, 0.0),
            Leg::load_by(Wrench::ZERO),
            body.leg(1.8 * edge, 0.0),
        ])
        .unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        // If the load returns from the edge, no slip is reported. A leg without change at the edge has no event either; on a further leg with more
        // load the foot slides.
        let mut path = body.up_to_the_edge(edge, 0.0);
        path.continue_with(&[Leg::load_by(Wrench::ZERO)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        path.continue_with(&[body.leg(0.0, 0.0)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        assert!(path.state().unwrap().contacts[0].slip.norm() == 0.0);
        let rest = [body.leg(edge, 0.0), Leg::load_by(Wrench::ZERO), body.leg(1.1 * edge, 0.0)];
        let mut path = body.grasp.follow(body.load(0.0, 0.0), &rest).unwrap();
        assert_story(&path.run(), &[slides(2)]);
        // If the tangential force T grows no faster than μN, the foot stays on the edge without slip.
        let press = 0.1 * body.opens_at();
        let more = body.mu * body.k * press / (body.k + body.kb) * (body.kt + body.kb) / body.kt;
        for (pull, expected) in [(0.99, vec![]), (1.01, vec![slides(1)])] {
            let mut path = body.up_to_the_edge(edge, 0.0);
            path.continue_with(&[body.leg(edge + pull * more, -press)]).unwrap();
            assert_story(&path.run(), &expected);
        }
    }
}

#[test]
fn opening_at_the_end_of_a_leg() {
    for body in scenes() {
        let edge = body.opens_at();
        let mut path = body.up_to_the_edge(0.0, edge);
        assert!(path.state().unwrap().contacts[0].force.norm() < 1e-12 * body.n);
        path.continue_with(&[body.leg(0.0, 2.0 * edge)]).unwrap();
        assert_story(&path.run(), &[(1, 0.0, vec![(0, "opens")])]);
        // Until the foot opens, the body rises by a. From then on only the bonded springs resist, so that the gap is the further load over their
        // stiffness.
        let gap = |lift: f64| (lift - edge) / body.kb;
        let open = path.state().unwrap();
        assert_close!(open.contacts[0].gap / gap(2.0 * edge), 1.0);
        // The body is lowered to the point where the foot would close, and raised again. This causes no event.
        path.continue_with(&[body.leg(0.0, edge), body.leg(0.0, 1.5 * edge)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        assert_close!(path.state().unwrap().contacts[0].gap / gap(1.5 * edge), 1.0);
        // The body is lowered to the point where the foot would close, without an event, and then further.
        path.continue_with(&[body.leg(0.0, edge)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        path.continue_with(&[body.leg(0.0, 0.0)]).unwrap();
        assert_story(&path.run(), &[(5, 0.0, vec![(0, "closes")])]);
        assert_close!(path.state().unwrap().contacts[0].force[0] / body.n, 1.0);
        // If the load returns from the point where the foot would open, no opening is reported.
        let mut path = body.up_to_the_edge(0.0, edge);
        path.continue_with(&[body.leg(0.0, 0.0)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        assert_close!(path.state().unwrap().contacts[0].force[0] / body.n, 1.0);
    }
}

/// The open foot is moved along and closes at the end of a leg. It sticks where it touches, with F_t = 0.
#[test]
fn closing_at_the_end_of_a_leg_elsewhere() {
    for body in scenes() {
        let edge = body.opens_at();
        let shear = 3.0 * body.slides_at();
        let legs = [(0.0, 2.0 * edge), (shear, 2.0 * edge), (shear, edge)].map(|(p, l)| body.leg(p, l));
        let mut path = body.grasp.follow(body.load(0.0, 0.0), &legs).unwrap();
        assert_story(&path.run(), &[(0, 0.5, vec![(0, "opens")])]);
        assert!(completed(path.end()));
        path.continue_with(&[body.leg(shear, 0.0)]).unwrap();
        assert_story(&path.run(), &[(3, 0.0, vec![(0, "closes")])]);
        let end = path.state().unwrap();
        assert_close!(end.contacts[0].force[0] / body.n, 1.0);
        assert!(end.contacts[0].force[1].abs() < 1e-12 * body.n, "{}", end.contacts[0].force);
        assert_close!(end.twist.translation()[0] * body.kb / shear, 1.0);
    }
}

/// Two fingers pinch a body (N = k a each) under a load of exactly 2μN. They hold this load, also over a leg without change, and a smaller load. With
/// more load the path is lost at the start of that leg.
#[test]
fn a_limit_load_at_the_end_of_a_leg() {
    for [k, kt, _, mu, a] in SCENES {
        let finger = |x: f64| jaw::<2>(x, [k, kt], mu).command([a, 0.0]);
        let grasp = Grasp::new([finger(1.0), finger(-1.0)]).unwrap();
        let edge = 2.0 * mu * k * a;
        let leg = |w: f64| Leg::load_to(Wrench::force([0.0, -w]));
        let mut path = grasp.follow(Wrench::ZERO, &[leg(edge)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()));
        assert_close!(path.state().unwrap().twist.translation()[1] * 2.0 * kt / edge, -1.0);
        path.continue_with(&[Leg::load_by(Wrench::ZERO), leg(0.5 * edge), leg(edge)]).unwrap();
        assert!(path.run().is_empty() && completed(path.end()), "{:?}", path.end());
        path.continue_with(&[leg(1.1 * edge)]).unwrap();
        assert!(path.run().is_empty());
        let loss = limit_load(&path);
        assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (4, &[0, 1][..]));
        assert!(loss.fraction < 1e-12, "{}", loss.fraction);
        assert!(loss.motion.as_ref().expect("a motion").object.translation()[1] < -0.99);
        // A further leg does not continue a lost path.
        path.continue_with(&[leg(0.0)]).unwrap();
        assert!(path.run().is_empty() && path.end().and_then(PathEnd::loss).is_some());
    }
}
