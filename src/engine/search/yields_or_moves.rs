//! Tests of [`yields`], which searches for a proof about a rate problem (for derivatives of forces and motion along a load path). The proof says that
//! no contact forces agree with spring offsets and load if every contact that may slide or open does so. The tests check that, whenever a proof is
//! found, no combination of contact states is an equilibrium.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::enumerate::search;
use crate::contact::{Law, LocalLaw, tangential};
use crate::grasp::{Contact, Engine, Face, Site, Wrench};
use crate::numerics::{Draw, Vector};
use crate::prelude::*;
use crate::proofs::yields;
use crate::{PolygonCone, PolygonFit, planar, spatial};

/// Numbers of random rate problems in a test. `asked` counts all of them, `proved` those for which the proof succeeds, and `held` those with an
/// equilibrium in some combination of contact states.
#[derive(Debug, Default)]
struct Count {
    asked: usize,
    proved: usize,
    held: usize,
}

/// A random whole number of magnitude up to `most`. With whole numbers as data, loads often lie exactly on the limit of what the contacts can
/// balance.
fn whole(draw: &mut Draw, most: f64) -> f64 {
    (draw.normal() * most).round().clamp(-most, most)
}

fn one_of(draw: &mut Draw, count: usize) -> usize {
    (0..16).fold(0, |bits, _| 2 * bits + usize::from(draw.sign() > 0.0)) % count
}

fn tangent(draw: &mut Draw, tangents: usize) -> SVector<f64, 3> {
    loop {
        let h =
            SVector::<f64, 3>::from_fn(|a, _| if a > 0 && a <= tangents { whole(draw, 2.0) } else { 0.0 });
        if h.norm() > 0.0 {
            return h.normalize();
        }
    }
}

/// A random law of a contact in a rate problem (for derivatives along a load path). `slip` is the slip of the contact if the object moves along the
/// load. Most laws are a facet of the friction cone (`Law::Edge`) with its normal along `slip`.
fn law(draw: &mut Draw, normals: &[SVector<f64, 3>], slip: &SVector<f64, 3>) -> Law {
    let tangents = if normals.len() > 2 { 2 } else { 1 };
    match one_of(draw, 24) {
        0 => Law::Bonded,
        1 => Law::Absent,
        2 => Law::Cone { gap: true },
        3 => Law::Edge(vec![tangent(draw, tangents)]),
        4..7 if normals.len() > 2 => Law::Edge(vec![normals[0], normals[1]]),
        _ if slip.norm() > 0.0 => Law::Edge(vec![slip.normalize()]),
        _ => Law::Edge(vec![tangent(draw, tangents)]),
    }
}

fn ask(grasp: &Engine, along: &Wrench<3>, draw: &mut Draw, count: &mut Count) {
    let cone = PolygonCone::new(4, PolygonFit::Circumscribed).expect("four facets");
    let mut rates = grasp.on_polygons(along, &cone).expect("a load");
    rates.trial = None;
    let (motion, axes) = (rates.wrench.clone(), grasp.space().axes());
    let mut of = |local: LocalLaw<'_>, site: &Site| {
        law(draw, &local.polygon.normals, &-tangential(&site.map.tr_mul(&motion)))
    };
    rates.laws = rates.locals().zip(rates.sites).map(|(local, site)| of(local, site)).collect();
    if draw.normal() > 1.0 {
        rates.wrench += Vector::from_fn(rates.size(), |_| whole(draw, 1.0));
    }
    for offset in &mut rates.offsets {
        for a in 0..axes {
            offset[a] = if draw.normal() > 1.5 { whole(draw, 2.0) * 1e-3 } else { 0.0 };
        }
    }
    count.asked += 1;
    let held = !search(&rates, true).found.is_empty();
    count.held += usize::from(held);
    if yields(&rates).is_some() {
        count.proved += 1;
        assert!(!held, "proved not to hold, and held: {rates:?}");
    }
}

#[test]
fn in_the_plane() {
    let (mut draw, mut count) = (Draw::new([5, 25, 2]), Count::default());
    while count.asked < 4_000 {
        let number = 2 + one_of(&mut draw, 4);
        let leans = draw.normal() > 1.0;
        let contact = |_| {
            let side = draw.sign();
            let lean = if leans { whole(&mut draw, 1.0) } else { 0.0 };
            Contact::new([side, whole(&mut draw, 2.0)], [-side, lean])
                .series_stiffness(100.0 * (1.0 + whole(&mut draw, 2.0).abs()), 100.0)
                .friction(0.25 * (1.0 + whole(&mut draw, 3.0).abs()))
                .into_inside()
        };
        let contacts: Vec<_> = (0..number).map(contact).collect();
        let grasp = Engine::new(contacts).expect("valid");
        ask(&grasp, &planar::Wrench::force([0.0, draw.sign()]).into_inside(), &mut draw, &mut count);
    }
    println!("in the plane {count:?}");
    assert!(count.proved > count.asked / 20 && count.held > count.asked / 20, "{count:?}");
}

#[test]
fn in_space() {
    let (mut draw, mut count) = (Draw::new([5, 25, 3]), Count::default());
    while count.asked < 4_000 {
        let number = 3 + one_of(&mut draw, 3);
        // Contacts are placed around a circle. In most draws their heights, stiffnesses and friction are equal, so that often all of them slide
        // or open at once.
        let [leans, differ] = [0; 2].map(|_| draw.normal() > 1.0);
        let first_angle = draw.normal();
        let contact = |i: usize| {
            let (sin, cos) = (first_angle + TAU * i as f64 / number as f64).sin_cos();
            let lean = if leans { whole(&mut draw, 1.0) } else { 0.0 };
            let height = if differ { whole(&mut draw, 2.0) } else { 0.0 };
            let mut own = |most: f64| if differ { whole(&mut draw, most).abs() } else { 0.0 };
            let stiffness = [0; 3].map(|_| 100.0 * (1.0 + own(1.0)));
            Contact::new([cos, sin, height], [-cos, -sin, lean])
                .series_stiffness_axes(stiffness)
                .friction(0.25 * (1.0 + own(3.0)))
        };
        let contacts: Vec<_> = (0..number).map(contact).collect();
        let grasp = Engine::new(contacts).expect("valid");
        let turn = if draw.normal() > 1.0 { 1.0 } else { 0.0 };
        let along = spatial::Wrench::new([0.0, 0.0, draw.sign()], [0.0, 0.0, turn]);
        ask(&grasp, &along, &mut draw, &mut count);
    }
    println!("in space {count:?}");
    assert!(count.proved > count.asked / 20 && count.held > count.asked / 20, "{count:?}");
}
