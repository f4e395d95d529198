//! As surfaces stiffen, forces between elastic bodies converge to the forces between rigid bodies, if the latter are unique. The rigid problem (W, q,
//! μ) is built here from the data of the scene.
//!
//! Three bodies on springs touch each other and the ground. With K the stiffness of the springs and G the contact forces' wrenches, `W = Gᵀ K⁻¹ G`
//! and `q = Gᵀ K⁻¹ f`. Elastic surfaces add their compliances to the diagonal of W. Three contact points for nine coordinates keep W regular, and
//! weak friction keeps the solution unique.

use grasp_lcp::friction::PlanarContacts;
use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
use nalgebra::{DMatrix, DVector, Vector2, Vector3};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// Stiffness of each supporting spring of a body, N/m.
const SPRING: f64 = 1e3;
/// Ratio of tangential to normal stiffness of surfaces.
const SOFTER_ALONG: f64 = 0.7;
const BODIES: usize = 3;

/// The data of a scene.
struct Hanging {
    /// For each body three springs, each between two points, and a load: force, and moment about the origin.
    springs: [[(Vector2<f64>, Vector2<f64>); 3]; BODIES],
    loads: [Vector3<f64>; BODIES],
    contacts: Vec<Touch>,
    friction: f64,
}

/// The wrench about the origin of a unit force along a direction.
fn wrench(point: &Vector2<f64>, along: &Vector2<f64>) -> Vector3<f64> {
    Vector3::new(along.x, along.y, point.perp(along))
}

/// Point, unit normal, the body into which it points, and the body on the other side.
type Touch = (Vector2<f64>, Vector2<f64>, usize, Option<usize>);

impl Hanging {
    fn new(random: &mut Random) -> Self {
        let mut within = |most: f64| most * (random.signed());
        let mut springs = [[(Vector2::zeros(), Vector2::zeros()); 3]; BODIES];
        for (b, own) in springs.iter_mut().enumerate() {
            for (k, spring) in own.iter_mut().enumerate() {
                let way = Vector2::new(0.3, 0.0) + Vector2::new(within(0.1), within(0.1));
                let turned = [way, Vector2::new(-way.y, way.x), Vector2::new(way.x, -way.y) * 1.3][k];
                // The two outer springs resist rotation.
                let beside = [0.0, -0.15, 0.15][k];
                let from = Vector2::new(b as f64 * 0.2 + beside + within(0.05), within(0.1));
                *spring = (from, from + turned);
            }
        }
        let loads = std::array::from_fn(|_| Vector3::new(within(20.0), within(20.0), within(2.0)));
        // The first body rests on the ground, the second on the first, the third on the second.
        let contacts = (0..BODIES).map(|on| {
            let normal = Vector2::new(within(0.5), 1.0).normalize();
            let point = Vector2::new(on as f64 * 0.2 + within(0.1), within(0.1));
            (point, normal, on, on.checked_sub(1))
        });
        let contacts = contacts.collect();
        Self { springs, loads, contacts, friction: 0.05 + within(0.05).abs() }
    }

    /// The problem (W, q, μ) for a stiffness of the surfaces, infinite for rigid surfaces.
    fn delassus(&self, surface: f64) -> PlanarContacts {
        let (bodies, forces) = (3 * BODIES, 2 * self.contacts.len());
        let (mut k, mut f) = (DMatrix::zeros(bodies, bodies), DVector::zeros(bodies));
        for (b, (springs, load)) in self.springs.iter().zip(&self.loads).enumerate() {
            for (from, to) in springs {
                let line = wrench(from, &(to - from).normalize());
                let mut own = k.view_mut((3 * b, 3 * b), (3, 3));
                own += line * line.transpose() * SPRING;
            }
            f.rows_mut(3 * b, 3).copy_from(load);
        }
        let mut g = DMatrix::zeros(bodies, forces);
        let mut compliance = DVector::zeros(forces);
        for (i, (point, normal, on, against)) in self.contacts.iter().enumerate() {
            let tangent = Vector2::new(normal.y, -normal.x);
            for (axis, along) in [normal, &tangent].into_iter().enumerate() {
                let wrench = wrench(point, along);
                g.view_mut((3 * on, 2 * i + axis), (3, 1)).copy_from(&wrench);
                if let Some(against) = against {
                    g.view_mut((3 * against, 2 * i + axis), (3, 1)).copy_from(&-wrench);
                }
                compliance[2 * i + axis] = [1.0, 1.0 / SOFTER_ALONG][axis] / surface;
            }
        }
        let softness = k.try_inverse().unwrap();
        let w = g.transpose() * &softness * &g + DMatrix::from_diagonal(&compliance);
        let q = g.transpose() * softness * f;
        PlanarContacts::new(w, q, vec![self.friction; self.contacts.len()]).expect("well posed")
    }

    /// Contact forces from the problem (W, q, μ).
    fn posed(&self, surface: f64) -> DVector<f64> {
        self.delassus(surface).solve().solution().unwrap().r.clone()
    }

    /// Contact forces from a grasp of several bodies; the load of the last body is the load of the question.
    fn of_bodies(&self, surface: f64) -> DVector<f64> {
        let name = |body: usize| format!("body {body}");
        let load = |body: usize| {
            let load = &self.loads[body];
            Wrench::new([load.x, load.y], load.z)
        };
        let bodies = Bodies::new((0..BODIES).map(|b| {
            let always = if b + 1 < BODIES { load(b) } else { Wrench::ZERO };
            Body::new(name(b)).load(always)
        }));
        let contacts = self.contacts.iter().map(|(point, normal, on, against)| {
            let contact = Contact::new(*point, *normal)
                .series_stiffness(surface, SOFTER_ALONG * surface)
                .friction(self.friction)
                .on(name(*on));
            against.map_or(contact.clone(), |against| contact.against(name(against)))
        });
        let springs = self.springs.iter().enumerate().flat_map(|(b, springs)| {
            springs.map(|(from, to)| Link::spring(from, to, SPRING).to_ground(format!("body {b}")))
        });
        let grasp =
            bodies.contacts(contacts).links(springs).loaded(name(BODIES - 1)).grasp().expect("well posed");
        let outcome = grasp.solve(load(BODIES - 1)).expect("well posed");
        let state = outcome.equilibrium().unwrap();
        let forces = state.contacts[..self.contacts.len()]
            .iter()
            .flat_map(|contact| [contact.force[0], contact.force[1]]);
        DVector::from_iterator(2 * self.contacts.len(), forces)
    }
}

#[test]
fn forces_go_to_those_between_rigid_bodies() {
    let mut random = seeded(44);
    let (mut pressed, mut sliding, mut converged) = (0, 0, 0);
    for scene in 0..samples(75) {
        let hanging = Hanging::new(&mut random);
        let rigid = hanging.posed(f64::INFINITY);
        let size = rigid.amax();
        if size < 0.1 {
            continue;
        }
        pressed += 1;
        sliding += (0..BODIES)
            .filter(|i| {
                rigid[2 * i] > 0.0
                    && (rigid[2 * i + 1].abs() - hanging.friction * rigid[2 * i]).abs() < 1e-9 * size
            })
            .count();
        // At any stiffness both agree to the last digits.
        let off = |surface: f64| {
            let elastic = hanging.of_bodies(surface);
            let same = (&elastic - hanging.posed(surface)).amax();
            assert!(same < 1e-9 * size, "{scene}: {same:e} {size}");
            (elastic - &rigid).amax() / size
        };
        let [soft, stiff, stiffest] = [1e6, 1e8, 1e10].map(off);
        assert!(stiffest < 1e-6, "{scene} {stiffest:e}");
        if stiff > 1e-9 {
            converged += 1;
            assert!(stiff < 0.02 * soft && stiffest < 0.02 * stiff, "{soft:e} {stiff:e} {stiffest:e}");
        }
    }
    println!("{pressed} scenes press, {sliding} contacts slide, {converged} differ from the limit");
    assert_met(&[(pressed, 50), (sliding, 25), (converged, 37)]);
}
