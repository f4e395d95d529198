//! A flat pad on a cylinder and a V block have line contacts on an elastic foundation that agree with closed forms.

use std::f64::consts::{FRAC_PI_2, SQRT_2};

use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use grasp_lcp::touch::{Pad, Part, Touch, Touched};

use crate::shapes::{part, round};

/// Modulus of the foundation, N/m³.
const FOUNDATION: f64 = 1e9;
const RADIUS: f64 = 0.02;
const LENGTH: f64 = 0.03;

/// A pad of rubber without friction that closes on the side of a shaft, by an advance from its first touch.
fn closed(pad: Pad, part: &Part, advance: f64) -> Touched {
    let contact = Contact::new([-0.05, 0.0, 0.04], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
    Touch::new(pad.of_layer(FOUNDATION, 1.0), contact.command([advance, 0.0, 0.0])).on(part).expect("touches")
}

/// Forces in N of the points of the pad on a part that does not move.
fn forces(touched: &Touched) -> Vec<[f64; 3]> {
    let anchor =
        |y: f64, z: f64| Contact::new([0.0, y, z], [0.0, 0.0, 1.0]).series_stiffness(1e15, 1e15).bonded();
    let anchors = [anchor(0.0, 0.0), anchor(0.02, 0.04), anchor(-0.02, 0.04)];
    let grasp = Grasp::new([touched.contacts(), &anchors].concat()).expect("a grasp");
    let outcome = grasp.solve(Wrench::ZERO).expect("answered");
    let state = outcome.equilibrium().expect("held");
    state.contacts.iter().take(touched.contacts().len()).map(|contact| contact.force_world.into()).collect()
}

/// Sum of the forces of all points along the closing direction, N.
fn force(touched: &Touched) -> f64 {
    forces(touched).iter().map(|force| force[0]).sum()
}

/// The force agrees with the integral of the foundation's pressure. The error is smaller with 26 points across the width than with six.
#[test]
fn a_flat_pad_on_a_fine_shaft() {
    let shaft = part(&round(RADIUS, 3000, 0.08));
    let advance = 1e-4;
    let half_width = (2.0 * RADIUS * advance).sqrt();
    let expected = 4.0 / 3.0 * FOUNDATION * advance * half_width * LENGTH;
    for (strips, off) in [(3, 0.01), (10, 0.003)] {
        let pad = Pad::rectangle([0.006, LENGTH], [strips, 1]).expect("a rectangle");
        let touched = closed(pad, &shaft, advance);
        let found = force(&touched) / expected - 1.0;
        let touching = forces(&touched).iter().filter(|force| force[0] > 0.0).count();
        println!("{} points across: {found:e}", touching / 4);
        assert!(found.abs() < off, "{found}");
        // The outermost pressing point is within one spacing of the end of the contact.
        let spacing = 0.003 / strips as f64;
        let end = touched.steepest() * RADIUS - half_width;
        assert!((-spacing..=1e-5).contains(&end), "{end}");
    }
}

/// A shaft with 96 sides has a corner in front of the pad. The force is the integral of the overlap of its sides with the pad.
#[test]
fn a_flat_pad_on_a_shaft_of_96_sides() {
    let sides = 96;
    let shaft = part(&round(RADIUS, sides, 0.08));
    let advance = 1e-4;
    let turn = std::f64::consts::TAU / sides as f64;
    let mut expected = 0.0;
    for k in 0..20 {
        let corner =
            |k: i32| (RADIUS * (f64::from(k) * turn).sin(), RADIUS * (1.0 - (f64::from(k) * turn).cos()));
        let ((y0, d0), (y1, d1)) = (corner(k), corner(k + 1));
        let (left, right) = (advance - d0, advance - d1);
        let slope = (d1 - d0) / (y1 - y0);
        // The area of the overlap of this side with the pad, up to where the side leaves the pad, times cos² θ of its slope θ.
        let area = if left <= 0.0 {
            0.0
        } else if right >= 0.0 {
            0.5 * (left + right) * (y1 - y0)
        } else {
            0.5 * left * left / slope
        };
        expected += 2.0 * area / (1.0 + slope * slope);
    }
    expected *= FOUNDATION * LENGTH;
    let pad = Pad::rectangle([0.006, LENGTH], [15, 1]).expect("a rectangle");
    let found = force(&closed(pad, &shaft, advance)) / expected - 1.0;
    assert!(found.abs() < 2e-3, "{found}");
    let on_cylinder = 4.0 / 3.0 * FOUNDATION * advance * (2.0 * RADIUS * advance).sqrt() * LENGTH;
    println!("polygon to cylinder: {}", expected / on_cylinder);
}

/// A V of a right angle around a shaft of 40 mm: each flank is a flat pad, pressed in by the advance divided by √2.
#[test]
fn a_v_touches_with_two_flanks() {
    let shaft = part(&round(RADIUS, 3000, 0.08));
    let advance = SQRT_2 * 1e-4;
    let pad = Pad::v(FRAC_PI_2, [0.04, LENGTH], [60, 1]).expect("a V");
    assert!((pad.area() - SQRT_2 * 0.04 * LENGTH).abs() < 1e-15);
    let touched = closed(pad, &shaft, advance);
    let flank = 4.0 / 3.0 * FOUNDATION * 1e-4 * (2.0 * RADIUS * 1e-4).sqrt() * LENGTH;
    let found = force(&touched) / (2.0 * flank / SQRT_2) - 1.0;
    assert!(found.abs() < 0.01, "{found}");
    assert!(touched.steepest() < 0.2, "{}", touched.steepest());
    // The point with the largest force is where the flank touches the shaft first.
    let mut strongest = forces(&touched).into_iter().zip(touched.contacts()).collect::<Vec<_>>();
    strongest.sort_by(|one, other| other.0[0].total_cmp(&one.0[0]));
    let y = strongest[0].1.point()[1].abs();
    assert!((y - RADIUS / SQRT_2).abs() < 3e-4, "{y}");
}

/// A round finger with the radius of the shaft on a flat face has the same force as a flat pad on the shaft.
#[test]
fn a_round_finger_on_a_face() {
    let block =
        part(&crate::shapes::prism(&[[0.0, -0.02], [0.04, -0.02], [0.04, 0.02], [0.0, 0.02]], 0, 0.08));
    let pad = Pad::cylinder(RADIUS, [0.006, LENGTH], [15, 1]).expect("a cylinder");
    let area = pad.area();
    let touched = closed(pad, &block, 1e-4);
    let expected = 4.0 / 3.0 * FOUNDATION * 1e-4 * (2.0 * RADIUS * 1e-4).sqrt() * LENGTH;
    let found = force(&touched) / expected - 1.0;
    assert!(found.abs() < 0.005, "{found}");
    // The expected area is that of the arc over a width of 6 mm.
    assert!((area / (2.0 * RADIUS * 0.15_f64.asin() * LENGTH) - 1.0).abs() < 1e-3, "{area}");
}

/// If the squeeze is given as a force, the points press with this total force.
#[test]
fn a_pressed_pad_presses_with_its_force() {
    let shaft = part(&round(RADIUS, 96, 0.08));
    let pad = Pad::rectangle([0.006, LENGTH], [5, 1]).expect("a rectangle").of_layer(FOUNDATION, 1.0);
    let contact = Contact::new([-0.05, 0.0, 0.04], [1.0, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]);
    for clearance in [0.0, 0.001] {
        let touch = Touch::new(pad.clone(), contact.clone().clearance(clearance).pressed_with(40.0));
        let touched = touch.on(&shaft).expect("touches");
        // The force is not exactly 40 N, because the bonded anchors that hold the part have a finite stiffness and move by 1e-14 m.
        assert!((force(&touched) - 40.0).abs() < 1e-7, "{}", force(&touched));
    }
}
