//! Grasps under loads, with contacts that stick, slide, have no friction, are glued, lie in a plane or far away.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Hold, Wrench};
use grasp_lcp::{planar, spatial};

pub type Failure = Box<dyn std::error::Error>;

/// A grasp under a load, and the hold of its contacts.
pub struct Scene<const C: usize> {
    pub name: &'static str,
    pub grasp: Grasp<C>,
    pub load: Wrench<C>,
    pub holds: Vec<Hold>,
}

impl<const C: usize> Scene<C> {
    pub fn new(
        name: &'static str,
        contacts: impl IntoIterator<Item = Contact<C>>,
        load: Wrench<C>,
    ) -> Result<Self, grasp_lcp::Error> {
        let grasp = Grasp::new(contacts)?;
        let holds = vec![Hold::Unilateral; grasp.len()];
        Ok(Self { name, grasp, load, holds })
    }
}

/// Fingers around a ball of radius 1 that press with about 10 N, in a plane or in space.
fn around(count: u8, i: u8) -> ([f64; 3], [f64; 3]) {
    let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(count)).sin_cos();
    let height = 0.3 * f64::from(i % 3) - 0.2;
    ([cos, sin, height], [-cos, -sin, -height])
}

fn finger(count: u8, i: u8) -> spatial::Contact {
    let (point, normal) = around(count, i);
    spatial::Contact::new(point, normal)
        .tangent([0.0, 0.0, 1.0])
        .series_stiffness(1000.0, 800.0)
        .friction(0.5)
        .command([0.01 + 0.001 * f64::from(i), 0.0, 0.0])
}

/// Five fingers and a load that they hold without sliding.
pub fn sticks() -> Result<Scene<3>, grasp_lcp::Error> {
    let load = spatial::Wrench::new([1.0, 0.5, -3.0], [0.2, 0.1, 0.3]);
    Scene::new("everything sticks", (0..5).map(|i| finger(5, i)), load)
}

/// Five fingers under a load that makes some of the fingers slide.
pub fn slides() -> Result<Scene<3>, grasp_lcp::Error> {
    let load = spatial::Wrench::new([4.0, 2.0, -23.0], [0.2, 0.1, 0.3]);
    Scene::new("some slide", (0..5).map(|i| finger(5, i)), load)
}

/// A cube between twelve frictionless pins, two on each side; it loses contact with some of them.
pub fn smooth() -> Result<Scene<3>, grasp_lcp::Error> {
    let pin = |k: u8| {
        let (side, axis) = (if k < 6 { -1.0 } else { 1.0 }, usize::from(k / 2 % 3));
        let across = if k.is_multiple_of(2) { 0.5 } else { -0.5 };
        let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
        (point[axis], normal[axis]) = (side, -side);
        point[(axis + 1) % 3] = across;
        spatial::Contact::new(point, normal)
            .series_stiffness(1000.0, 800.0)
            .friction(0.0)
            .command([0.002, 0.0, 0.0])
    };
    let load = spatial::Wrench::new([5.0, -9.0, 2.0], [0.5, 0.2, -0.4]);
    Scene::new("frictionless", (0..12).map(pin), load)
}

/// Two fingers with friction, two without friction, one with infinite friction, and one that is glued to the
/// object.
pub fn mixed() -> Result<Scene<3>, grasp_lcp::Error> {
    let contacts = (0..6).map(|i| match i {
        2 | 3 => finger(6, i).friction(0.0),
        4 => finger(6, i).friction(f64::INFINITY),
        5 => finger(6, i).bonded(),
        _ => finger(6, i),
    });
    let load = spatial::Wrench::new([2.0, 1.0, -20.0], [0.2, 0.1, 0.3]);
    let mut scene = Scene::new("mixed: friction, smooth, infinite, bonded", contacts, load)?;
    scene.holds[5] = Hold::Bonded;
    Ok(scene)
}

const FLAT_LOAD: ([f64; 2], f64) = ([2.0, -6.0], 14.0);

fn flat(count: u8, i: u8) -> planar::Contact {
    let ([x, y, _], [u, v, _]) = around(count, i);
    planar::Contact::new([x, y], [u, v])
        .series_stiffness(1000.0, 800.0)
        .friction(0.5)
        .command([0.01 + 0.001 * f64::from(i), 0.0])
}

/// Three fingers in the plane, one of which slides.
pub fn in_the_plane() -> Result<Scene<2>, grasp_lcp::Error> {
    let (force, moment) = FLAT_LOAD;
    Scene::new("three fingers in the plane", (0..3).map(|i| flat(3, i)), planar::Wrench::new(force, moment))
}

/// Three fingers of a spatial grasp that all lie in the plane z = 0; their friction polygons have corners in
/// this plane.
pub fn in_a_spatial_guise() -> Result<Scene<3>, grasp_lcp::Error> {
    let contacts = (0..3).map(|i| {
        let ([x, y, _], [u, v, _]) = around(3, i);
        spatial::Contact::new([x, y, 0.0], [u, v, 0.0])
            .tangent([v, -u, 0.0])
            .series_stiffness(1000.0, 800.0)
            .friction(0.5)
            .command([0.01 + 0.001 * f64::from(i), 0.0, 0.0])
    });
    let ([x, y], moment) = FLAT_LOAD;
    Scene::new("the same three in space", contacts, spatial::Wrench::new([x, y, 0.0], [0.0, 0.0, moment]))
}

/// Three fingers that hold, and twenty that are too far away to touch.
pub fn far(name: &'static str, part: f64) -> Result<Scene<2>, grasp_lcp::Error> {
    let (force, moment) = FLAT_LOAD;
    let away = (0..20).map(|i| flat(20, i).command([-0.2, 0.0]));
    let load = planar::Wrench::new(force, moment) * part;
    Scene::new(name, (0..3).map(|i| flat(3, i)).chain(away), load)
}

/// A pad along x, pressed most in the middle, under the fraction `part` of a shear load. At `part` 1 two thirds
/// of its springs slide.
pub fn pad(name: &'static str, springs: usize, part: f64) -> Result<Scene<2>, grasp_lcp::Error> {
    let (grasp, load) = support::patches::planar_patch(springs)?;
    let load = load.to_vector();
    let load = planar::Wrench::new([part * load[0], load[1]], load[2]);
    let holds = vec![Hold::Unilateral; springs];
    Ok(Scene { name, grasp, load, holds })
}
