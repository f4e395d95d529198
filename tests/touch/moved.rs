//! If part and pad are moved together, the contacts move with them.

use grasp_lcp::nalgebra::{Isometry3, Point3, Vector3};
use grasp_lcp::spatial::Contact;
use grasp_lcp::touch::{Pad, Part, Touch};

use crate::shapes::{Mesh, part, round};

fn moved((corners, faces): &Mesh, pose: &Isometry3<f64>) -> Part {
    let corners: Vec<[f64; 3]> =
        corners.iter().map(|corner| (pose * Point3::from(*corner)).coords.into()).collect();
    Part::new(&corners, faces).expect("a mesh")
}

#[test]
fn contacts_move_with_part_and_pad() {
    let mesh = round(0.02, 60, 0.08);
    let contact = Contact::new([-0.05, 0.003, 0.04], [1.0, 0.1, 0.05]).tangent([0.1, 1.0, 0.0]).name("jaw");
    let contact = contact.series_stiffness(3e5, 1e5).friction(0.4).pressed_with(30.0);
    let pad = Pad::rectangle([0.02, 0.03], [4, 2]).expect("a rectangle");
    let here = Touch::new(pad.clone(), contact.clone()).on(&part(&mesh)).expect("touches");
    let pose = Isometry3::new(Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.4, -1.1, 0.7));
    let there = Touch::new(pad, contact.transformed(&pose)).on(&moved(&mesh, &pose)).expect("touches");
    assert_eq!(here.contacts().len(), there.contacts().len());
    for (one, other) in here.contacts().iter().zip(there.contacts()) {
        let one = one.clone().transformed(&pose);
        assert!((one.point() - other.point()).norm() < 1e-14, "{} {}", one.point(), other.point());
        assert!(
            (one.commanded() - other.commanded()).norm() < 1e-14,
            "{} {}",
            one.commanded(),
            other.commanded()
        );
        assert_eq!(one.label_text(0), other.label_text(0));
    }
    assert!((here.steepest() - there.steepest()).abs() < 1e-12);
}
