//! How many times its weight do two fingers hold, and which forces do they carry?
//!
//! `cargo run --profile quick -p grasp-lcp --example box_in_two_fingers`

use grasp_lcp::planar::{Contact, Grasp, Wrench};

fn main() -> Result<(), grasp_lcp::Error> {
    // A box of half a kilogram, 8 cm wide, between fingers of 2 kN/m that press with 8 N each.
    let finger = |side: f64| {
        Contact::new([0.04 * side, 0.0], [-side, 0.0])
            .body_stiffness(5e4, 3e4)
            .finger_stiffness(2e3, 1.5e3)
            .friction(0.5)
            .pressed_with(8.0)
    };
    let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    let weight = Wrench::force([0.0, -0.5 * 9.81]);

    let onset = grasp.onset(weight)?;
    println!("slides {onset}");
    println!("under its weight: {}", grasp.solve(weight)?);
    println!("under twice its weight: {}", grasp.solve(weight * 2.0)?);
    Ok(())
}
