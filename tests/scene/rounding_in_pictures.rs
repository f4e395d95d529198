//! A force that is only rounding, compared with the other forces of an equilibrium, is not shown in pictures or tables.

use grasp_lcp::need::{Amount, Need};
use grasp_lcp::picture::{Page, View, draw_grasp};
use grasp_lcp::planar::{Contact, Grasp, Turn};
use grasp_lcp::spatial;
use support::svg::{Failure, shapes};

/// A glass on a tray that is tilted until it tips. Its upper edge carries no force any more.
#[test]
fn a_glass_about_to_tip_stands_on_one_edge() -> Result<(), Failure> {
    let edge = |x: f64, name: &str| {
        Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(5e4, 3e4).friction(0.5)
    };
    let glass = Grasp::new([edge(-0.03, "left edge"), edge(0.03, "right edge")])?;
    let need = Need::angle(Turn::tilting([0.0, -2.943], [0.0, 0.07]).up_to(1.5)).to_hold();
    let Amount::Bound { sufficient, .. } = glass.need(&need)?.amount else { panic!("it tips") };
    let (glass, state) = glass.with_amount(&need, sufficient)?.ok_or("it stands")?;
    let rounding = state.contacts.iter().map(|contact| contact.force.norm()).fold(f64::INFINITY, f64::min);
    assert!(rounding < 1e-9, "{rounding}");
    let shapes = shapes(&draw_grasp(&glass, &state, None, "A glass")?)?;
    let labels: Vec<_> =
        shapes.iter().map(|shape| shape.words.as_str()).filter(|w| w.starts_with("|F|")).collect();
    assert_eq!(labels, ["|F| = 2.943 N", "|F| = 0 N"]);
    Ok(())
}

#[test]
fn neither_arrows_nor_tables_of_a_page_show_it() -> Result<(), Failure> {
    let finger = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let at = spatial::Contact::new([0.03 * cos, 0.03 * sin, 0.0], [-cos, -sin, 0.0]);
        at.series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new([finger(180.0), finger(60.0), finger(-60.0)])?;
    let mut state =
        grasp.solve(spatial::Wrench::force([0.0, 0.0, -1.0]))?.equilibrium().ok_or("it holds")?.clone();
    let drawn = |state: &spatial::Equilibrium| -> Result<(String, usize), Failure> {
        let page = Page::new(&grasp, "Three fingers").frame("held", state);
        let svg = page.to_svg(Some(0), View::default())?;
        let arrows = shapes(&svg)?.iter().filter(|shape| shape.tag == "polygon").count();
        Ok((page.to_html()?, arrows))
    };
    let (html, arrows) = drawn(&state)?;
    let forces = |html: &str| html.matches("\"layer\":\"forces\"").count();
    assert!(!html.contains("<td>0</td><td>0</td>") && forces(&html) == 3);
    // A force 1e12 times smaller than the others.
    let last = &mut state.contacts[2];
    last.force *= 1e-12;
    last.force_world *= 1e-12;
    last.margin *= 1e-12;
    let (html, fewer) = drawn(&state)?;
    assert!(html.contains("<td>0</td><td>0</td><td>0</td>") && forces(&html) == 2);
    // The head of its arrow, its cone and the edge of the cone are not drawn.
    assert!(fewer < arrows, "{fewer} of {arrows}");
    Ok(())
}
