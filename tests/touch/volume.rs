//! Volume, mass and centre of polyhedra agree with hand calculations.

use grasp_lcp::Error;
use grasp_lcp::touch::Part;

use crate::shapes::{bracket, bracket_in_metres, part, round};

#[test]
fn a_bracket_is_two_plates() {
    let part = bracket_in_metres().of_density(7850.0).expect("closed");
    // The bracket consists of plates of 60 x 6 mm and 6 x 34 mm, 30 mm deep.
    let (first, second) = (360.0, 204.0);
    let middle = |one: f64, other: f64| (first * one + second * other) / (first + second) * 1e-3;
    let expected = [middle(30.0, 3.0), middle(3.0, 23.0), 0.015];
    assert!((part.volume().expect("closed") / 16_920e-9 - 1.0).abs() < 1e-14);
    assert!((part.mass().expect("dense") / 0.132_822 - 1.0).abs() < 1e-12);
    let centre = part.centre_of_mass().expect("closed");
    assert!(centre.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-16), "{centre:?}");
}

#[test]
fn a_polygon_prism_has_its_area_times_its_length() {
    let (n, r, l): (usize, f64, f64) = (96, 0.02, 0.08);
    let area = 0.5 * n as f64 * r * r * (std::f64::consts::TAU / n as f64).sin();
    let shaft = part(&round(r, n, l));
    assert!((shaft.volume().expect("closed") / (area * l) - 1.0).abs() < 1e-13);
    let centre = shaft.centre_of_mass().expect("closed");
    assert!(centre[0].abs() < 1e-16 && centre[1].abs() < 1e-16 && (centre[2] - 0.04).abs() < 1e-16);
}

/// The volume is accurate far from the origin, and also for a surface with reversed faces.
#[test]
fn place_and_order_of_corners_do_not_matter() {
    let (corners, faces) = bracket();
    let far: Vec<_> = corners.iter().map(|[x, y, z]| [x + 1e5, y - 1e5, z + 1e5]).collect();
    let inside_out: Vec<_> = faces.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    for (corners, faces, size) in [(&far, &faces, 1e-12), (&corners, &inside_out, 1e-15)] {
        let part = Part::new(corners, faces).expect("a mesh");
        assert!((part.volume().expect("closed") / 16_920.0 - 1.0).abs() < size);
    }
}

#[test]
fn an_open_surface_has_no_volume() {
    let (corners, mut faces) = bracket();
    faces.pop();
    let part = Part::new(&corners, &faces).expect("a mesh");
    assert_eq!((part.volume(), part.centre_of_mass()), (None, None));
    assert!(matches!(part.of_density(7850.0), Err(Error::Mesh { .. })));
}
