//! Shared by tests: parts whose values are known by hand.

use std::f64::consts::TAU;

use grasp_lcp::spatial::Contact;
use grasp_lcp::touch::{Pad, Part, Touch, Touched};

pub(crate) type Mesh = (Vec<[f64; 3]>, Vec<[usize; 3]>);

/// A prism along z. Its counterclockwise profile is triangulated from the corner `hub`, from which all others must be visible.
pub(crate) fn prism(profile: &[[f64; 2]], hub: usize, depth: f64) -> Mesh {
    let n = profile.len();
    let corners = [0.0, depth].iter().flat_map(|z| profile.iter().map(move |[x, y]| [*x, *y, *z])).collect();
    let mut faces = Vec::new();
    for i in 0..n {
        let j = (i + 1) % n;
        faces.extend([[i, j, n + j], [i, n + j, n + i]]);
        if i != hub && j != hub {
            faces.extend([[hub, j, i], [n + hub, n + i, n + j]]);
        }
    }
    (corners, faces)
}

/// An L-shaped bracket of 60 x 40 mm, 6 mm thick and 30 mm deep, in mm.
pub(crate) fn bracket() -> Mesh {
    let profile = [[0.0, 0.0], [60.0, 0.0], [60.0, 6.0], [6.0, 6.0], [6.0, 40.0], [0.0, 40.0]];
    prism(&profile, 3, 30.0)
}

/// A prism with a regular polygon as profile, first corner on x.
pub(crate) fn round(radius: f64, sides: usize, length: f64) -> Mesh {
    let corner = |i: usize| {
        let angle = TAU * i as f64 / sides as f64;
        [radius * angle.cos(), radius * angle.sin()]
    };
    prism(&(0..sides).map(corner).collect::<Vec<_>>(), 0, length)
}

pub(crate) fn part((corners, faces): &Mesh) -> Part {
    Part::new(corners, faces).expect("a mesh")
}

/// The bracket in m.
pub(crate) fn bracket_in_metres() -> Part {
    let (corners, faces) = bracket();
    part(&(corners.iter().map(|corner| corner.map(|x| x / 1000.0)).collect(), faces))
}

/// A rubber pad of 20 mm along y and 30 mm along z with friction 0.5, which closes along x and presses with 40 N.
pub(crate) fn jaw(name: &str, at: [f64; 3], closing: f64, strips: [usize; 2], part: &Part) -> Touched {
    let pad = Pad::rectangle([0.02, 0.03], strips).expect("a rectangle").of_layer(2e6, 0.003);
    let contact = Contact::new(at, [closing, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]).name(name);
    Touch::new(pad, contact.friction(0.5).pressed_with(40.0)).on(part).expect("touches")
}
