//! The same part in three file formats gives the same mesh.

use std::fmt::Write;

use grasp_lcp::Error;
use grasp_lcp::touch::{Part, Unit};

use crate::shapes::{Mesh, bracket};

#[expect(clippy::cast_possible_truncation, reason = "single precision")]
fn binary_stl((corners, faces): &Mesh) -> Vec<u8> {
    let mut bytes = b"solid, yet binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(u32::try_from(faces.len()).expect("few").to_le_bytes());
    for face in faces {
        bytes.extend([0; 12]);
        for x in face.iter().flat_map(|corner| corners[*corner]) {
            bytes.extend((x as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn text_stl((corners, faces): &Mesh) -> String {
    let mut text = "solid bracket\n".to_owned();
    for face in faces {
        text += "facet normal 0 0 0\n outer loop\n";
        for [x, y, z] in face.map(|corner| corners[corner]) {
            writeln!(text, "  vertex {x} {y:e} {z}").expect("a text");
        }
        text += " endloop\nendfacet\n";
    }
    text + "endsolid\n"
}

/// The prism as an OBJ with its ends as polygons, one of them in reverse order.
fn obj((corners, _): &Mesh) -> String {
    let mut text = "# a comment\no bracket\n".to_owned();
    for [x, y, z] in corners {
        writeln!(text, "v {x} {y} {z}").expect("a text");
    }
    for i in 1..=6 {
        let j = i % 6 + 1;
        writeln!(text, "f {i}//1 {j}/2/3 {} {}/4", j + 6, i + 6).expect("a text");
    }
    text + "f 4 3 2 1 6 5\nf -3 -2 -1 -6 -5 -4\n"
}

#[test]
fn all_forms_are_the_same_part() {
    let mesh = bracket();
    let metres: Vec<[f64; 3]> = mesh.0.iter().map(|corner| corner.map(|x| x / 1000.0)).collect();
    let expected = Part::new(&metres, &mesh.1).expect("a mesh");
    assert_eq!(Part::from_stl(&binary_stl(&mesh), Unit::Millimetre).expect("an STL"), expected);
    assert_eq!(Part::from_stl(text_stl(&mesh).as_bytes(), Unit::Millimetre).expect("an STL"), expected);
    let of_obj = Part::from_obj(&obj(&mesh), Unit::Millimetre).expect("an OBJ");
    assert_eq!((of_obj.faces(), of_obj.bounds()), (expected.faces(), expected.bounds()));
    assert!((of_obj.volume().expect("closed") / 16_920e-9 - 1.0).abs() < 1e-14);
}

#[test]
fn what_is_no_mesh_is_refused() {
    let said = |found: Result<Part, Error>| match found.expect_err("no mesh") {
        Error::Mesh { fault } => fault,
        other => panic!("{other}"),
    };
    let stl = binary_stl(&bracket());
    let shorter = &stl[1..];
    assert!(said(Part::from_stl(shorter, Unit::Metre)).starts_with("is no STL"));
    let cut = text_stl(&bracket()).replacen("vertex 0", "vertex zero", 1);
    assert!(said(Part::from_stl(cut.as_bytes(), Unit::Metre)).starts_with("line "));
    assert!(said(Part::from_obj("v 0 0 0\nf 1 2 3\n", Unit::Metre)).starts_with("face 0: corner 1"));
    assert!(said(Part::from_obj("f a b c", Unit::Metre)).starts_with("line 1: "));
    assert!(said(Part::from_obj("", Unit::Metre)).starts_with("has no faces"));
    assert!(said(Part::from_obj("v 0 0 nan\nf 1 1 1", Unit::Metre)).contains("must be finite"));
    assert!(said(Part::read("no.stl", Unit::Metre)).starts_with("no.stl: "));
    assert!(
        said(Part::read(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"), Unit::Metre))
            .ends_with(".stl or .obj")
    );
}
