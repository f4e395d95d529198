//! From a mesh to a verdict: the run time for a mug of 10⁵ triangles, and the number of points that a line contact needs.
//!
//! `cargo run --release -p reports --bin from_mesh`

use std::error::Error;
use std::f64::consts::TAU;

use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use grasp_lcp::touch::{Pad, Part, Touch, Touched, Unit};
use support::best_time::timed;

type Failure = Box<dyn Error>;

/// Number of sides of the mug, a prism around its axis.
const SIDES: usize = 500;
/// Young's modulus, Pa, and thickness, m, of a rubber layer.
const LAYER: (f64, f64) = (2e6, 0.003);

/// Triangles of a surface of revolution about z: each line segment of the section gives a strip around the axis.
fn revolved(section: &[[f64; 2]], sides: usize) -> Vec<[[f64; 3]; 3]> {
    let point = |[r, z]: [f64; 2], i: usize| {
        let angle = TAU * (i % sides) as f64 / sides as f64;
        [r * angle.cos(), r * angle.sin(), z]
    };
    let mut triangles = Vec::new();
    for line in section.windows(2) {
        for i in 0..sides {
            let [a, b, c, d] =
                [point(line[0], i), point(line[0], i + 1), point(line[1], i + 1), point(line[1], i)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

/// A mug of 80 mm across and 90 mm high with a wall of 4 mm, in mm, as a binary STL.
#[expect(clippy::cast_possible_truncation, reason = "such a file is in single precision")]
fn mug() -> Vec<u8> {
    let up = |r: f64, from: f64, to: f64, rows: usize| {
        (0..=rows).map(move |k| [r, from + (to - from) * k as f64 / rows as f64])
    };
    let mut section = vec![[0.0, 0.0]];
    section.extend(up(40.0, 0.0, 90.0, 49));
    section.extend(up(36.0, 90.0, 5.0, 48));
    section.push([0.0, 5.0]);
    let triangles = revolved(&section, SIDES);
    let mut bytes = vec![0; 80];
    bytes.extend(u32::try_from(triangles.len()).unwrap_or(0).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        triangle.iter().flatten().for_each(|x| bytes.extend((*x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// A jaw of 20 x 30 mm that closes along x from one side at the height of 45 mm.
fn jaw(part: &Part, side: f64, name: &str) -> Result<Touched, Failure> {
    let contact = Contact::new([0.06 * side, 0.0, 0.045], [-side, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
    let pad = Pad::rectangle([0.02, 0.03], [4, 1])?.of_layer(LAYER.0, LAYER.1);
    Ok(Touch::new(pad, contact.name(name).friction(0.5).pressed_with(40.0)).on(part)?)
}

fn main() -> Result<(), Failure> {
    let stl = mug();
    let (part, read) = timed(|| Ok(Part::from_stl(&stl, Unit::Millimetre)?.of_density(2400.0)?))?;
    let (jaws, touch) = timed(|| Ok([jaw(&part, -1.0, "left")?, jaw(&part, 1.0, "right")?]))?;
    let (edges, drawn) = timed(|| Ok(part.edges(0.5).len()))?;
    let grasp = Grasp::new([jaws[0].contacts(), jaws[1].contacts()].concat())?;
    let centre = part.centre_of_mass().ok_or("closed")?;
    let weight = 9.81 * part.mass().ok_or("of clay")?;
    let (verdict, held) = timed(|| Ok(grasp.hold(Wrench::force_at([0.0, 0.0, -weight], centre))?))?;
    println!("A mug of {} triangles, {:.1} N, in two jaws of {} points", part.faces(), weight, grasp.len());
    println!("  reads and weighs it in {:.1} ms, lays both jaws on it in {:.1} ms", 1e3 * read, 1e3 * touch);
    println!("  finds its {edges} edges in {:.1} ms, and answers in {:.1} ms", 1e3 * drawn, 1e3 * held);
    println!("  {verdict}");

    println!("\nA flat pad pressed into a shaft of 20 mm radius by 0.1 mm, against 4/3 K L δ √(2Rδ)");
    println!("  points across   3000 sides   96 sides");
    let (radius, depth, length, foundation) = (0.02_f64, 1e-4, 0.03, 1e9);
    let expected = 4.0 / 3.0 * foundation * length * depth * (2.0 * radius * depth).sqrt();
    let shafts = [3000, 96].map(|sides| {
        let triangles = revolved(&[[0.0, 0.0], [radius, 0.0], [radius, 0.08], [0.0, 0.08]], sides);
        let corners: Vec<[f64; 3]> = triangles.into_iter().flatten().collect();
        let faces: Vec<_> = (0..corners.len() / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Part::new(&corners, &faces)
    });
    for strips in [2, 3, 5, 10] {
        let mut row = Vec::new();
        for shaft in &shafts {
            let contact = Contact::new([-0.05, 0.0, 0.04], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
            let touch = Touch::new(
                Pad::rectangle([0.006, length], [strips, 1])?.of_layer(foundation, 1.0),
                contact.command([depth, 0.0, 0.0]),
            );
            row.push(pressed(touch.on(shaft.as_ref().map_err(Clone::clone)?)?)?);
        }
        let off = |force: f64| 100.0 * (force / expected - 1.0);
        println!("  {:13}   {:8.2} %   {:6.2} %", row[0].1, off(row[0].0), off(row[1].0));
    }
    Ok(())
}

/// The force of the jaw along x on a fixed part, N, and the number of rows of points that press.
fn pressed(touched: Touched) -> Result<(f64, usize), Failure> {
    let anchor =
        |y: f64, z: f64| Contact::new([0.0, y, z], [0.0, 0.0, 1.0]).series_stiffness(1e15, 1e15).bonded();
    let count = touched.contacts().len();
    let anchors = vec![anchor(0.0, 0.0), anchor(0.02, 0.04), anchor(-0.02, 0.04)];
    let grasp = Grasp::new([touched.into_contacts(), anchors].concat())?;
    let outcome = grasp.solve(Wrench::ZERO)?;
    let state = outcome.equilibrium().ok_or("is held")?;
    let forces = state.contacts.iter().take(count).map(|contact| contact.force_world[0]);
    let pressing = forces.clone().filter(|force| *force > 0.0).count();
    Ok((forces.sum(), pressing / 4))
}
