//! A page with a view of the mug in the hand that can be rotated: outlines of shapes from parry, with predicted forces and motions.

use grasp_lcp::picture::Page;
use grasp_lcp::spatial::{Equilibrium, Grasp};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::shape::{Compound, Shape, TypedShape};

use crate::Failure;
use crate::hand::fingertips;

/// Number of corners with which a circle is drawn.
const CORNERS: u32 = 24;

/// Writes the page into `output/` and prints its path.
pub fn save(grasp: &Grasp, answers: &[(&str, &Equilibrium)], mug: &Compound) -> Result<(), Failure> {
    let mut page = Page::new(grasp, "A mug between the fingertips that a collision library found");
    for (pose, shape) in mug.shapes() {
        page = edges(&**shape, pose).into_iter().fold(page, Page::outline);
    }
    for tip in fingertips() {
        page = edges(&*tip.shape, &tip.pose).into_iter().fold(page, Page::fixture);
    }
    page = answers.iter().fold(page, |page, (label, state)| page.frame(*label, state));
    std::fs::create_dir_all("output")?;
    std::fs::write("output/collision_contacts.html", page.to_html()?)?;
    println!("\nwrote output/collision_contacts.html");
    Ok(())
}

/// The edges of a shape, each as a line between two corners.
fn edges(shape: &dyn Shape, pose: &Pose) -> Vec<[[f64; 3]; 2]> {
    let (corners, edges): (Vec<Vector>, _) = match shape.as_typed_shape() {
        TypedShape::Ball(ball) => ball.to_outline(CORNERS),
        TypedShape::Capsule(capsule) => capsule.to_outline(CORNERS),
        TypedShape::Cylinder(cylinder) => cylinder.to_outline(CORNERS),
        _ => return Vec::new(),
    };
    edges.into_iter().map(|edge| edge.map(|i| (pose * corners[i as usize]).to_array())).collect()
}
