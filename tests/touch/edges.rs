//! The edges of a mesh that a picture shows are right.

use crate::shapes::{bracket, part, round};

#[test]
fn a_bracket_has_those_of_its_profile() {
    // The profile has six corners. The bracket has the edges of two such polygons and the lines between them, but no diagonals.
    let edges = part(&bracket()).edges(0.5);
    assert_eq!(edges.len(), 18);
    for [a, b] in edges {
        let along = (0..3).filter(|axis| a[*axis] != b[*axis]).count();
        assert_eq!(along, 1, "{a:?} {b:?}");
    }
}

#[test]
fn a_shaft_has_the_circles_at_its_ends() {
    let edges = part(&round(0.02, 96, 0.08)).edges(0.5);
    assert_eq!(edges.len(), 2 * 96);
    assert!(edges.iter().all(|[a, b]| a[2] == b[2]));
}

#[test]
fn an_open_surface_has_its_rim() {
    let (corners, mut faces) = bracket();
    faces.truncate(2);
    // The two remaining triangles form one flat side, which has four edges.
    assert_eq!(part(&(corners, faces)).edges(0.5).len(), 4);
}
