//! No name in a picture covers another or leaves the sheet, and a soft fingertip has one name.

use std::f64::consts::TAU;

use grasp_lcp::picture::{Page, PlanarPicture, View, draw_grasp};
use grasp_lcp::{planar, spatial};
use support::jaws::around;
use support::svg::{Failure, outside, overlap, plaques, shapes};

use crate::LONG;

fn planar_ring(count: usize, name: &str) -> Result<planar::Grasp, grasp_lcp::Error> {
    let support = |k: usize| {
        let at = around::<2>(k, count, 0.05, [2000.0, 1500.0], 0.5);
        at.name(format!("{name} {k}.")).pressed_with(5.0)
    };
    planar::Grasp::new((0..count).map(support).collect::<Vec<_>>())
}

/// A grasp whose contacts all lie close to one of two points, which leaves no room for their names next to them.
fn heap(count: usize) -> Result<planar::Grasp, grasp_lcp::Error> {
    let at = |k: usize| {
        let x = if k.is_multiple_of(2) { -0.05 } else { 0.05 };
        let at = planar::Contact::new([x, 1e-5 * k as f64], [-x, 0.0]).name(format!("number {k}."));
        at.series_stiffness(2000.0, 1500.0).friction(0.5).pressed_with(5.0)
    };
    planar::Grasp::new((0..count).map(at).collect::<Vec<_>>())
}

fn check(svg: &str, what: &str) -> Result<(), Failure> {
    assert!(overlap(&plaques(svg)?).is_none(), "{what}: {:?}", overlap(&plaques(svg)?));
    assert!(outside(svg)?.is_none(), "{what}: {:?}", outside(svg)?);
    Ok(())
}

#[test]
fn planar_names_keep_apart() -> Result<(), Failure> {
    let load = planar::Wrench::force([1.0, -3.0]);
    for (what, grasp, count) in [
        ("a ring of 12", planar_ring(12, "support")?, 12),
        ("a ring of 24", planar_ring(24, "support")?, 24),
        ("long names", planar_ring(8, LONG)?, 8),
        ("a heap", heap(12)?, 12),
        ("a heap of 30", heap(30)?, 30),
    ] {
        let state = grasp.solve(load)?.equilibrium().cloned().ok_or("it holds")?;
        let svg = draw_grasp(&grasp, &state, None, what)?;
        check(&svg, what)?;
        let start = if what == "long names" {
            "a finger whose"
        } else if what.contains("ring") {
            "support"
        } else {
            "number"
        };
        let names = shapes(&svg)?.iter().filter(|shape| shape.words.starts_with(start)).count();
        assert_eq!(names, count, "{what}");
    }
    Ok(())
}

#[test]
fn what_has_no_name_is_counted() -> Result<(), Failure> {
    let grasp = planar_ring(60, "support")?;
    let state = grasp.solve(planar::Wrench::ZERO)?.equilibrium().cloned().ok_or("it holds")?;
    let svg = draw_grasp(&grasp, &state, None, "Very many")?;
    check(&svg, "very many")?;
    assert!(shapes(&svg)?.iter().any(|shape| shape.words.starts_with("60 names")));
    Ok(())
}

#[test]
fn spatial_names_keep_apart() -> Result<(), Failure> {
    for count in [12_u32, 24] {
        let support = |k: u32| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(count)).sin_cos();
            let at =
                spatial::Contact::new([0.05 * cos, 0.05 * sin, 0.02 * f64::from(k % 3)], [-cos, -sin, 0.0]);
            at.name(format!("{LONG} {k}")).series_stiffness(2000.0, 1500.0).friction(0.5).pressed_with(5.0)
        };
        let grasp = spatial::Grasp::new((0..count).map(support).collect::<Vec<_>>())?;
        let outcome = grasp.solve(spatial::Wrench::force([1.0, 0.0, -3.0]))?;
        let page = Page::new(&grasp, LONG.repeat(3)).outcome("held", &outcome).says(LONG.repeat(5));
        for view in [View::default(), View::FRONT, View::ABOVE] {
            let svg = page.to_svg(Some(0), view)?;
            check(&svg, &format!("{count} from {view:?}"))?;
            assert!(
                shapes(&svg)?.iter().filter(|shape| shape.words.starts_with("a finger whose")).count() >= 8
            );
        }
    }
    Ok(())
}

#[test]
fn a_pad_of_twelve_points_has_one_name() -> Result<(), Failure> {
    let jaw = |name: &str, x: f64| {
        let at = planar::Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(2000.0, 1500.0);
        at.friction(0.5).pressed_with(8.0)
    };
    let pad = planar::SoftFingertip::pad(0.03, 12, planar::Pressure::Uniform)?;
    let grasp = planar::Grasp::new(
        [pad.contacts(&jaw("left pad", -0.04))?, pad.contacts(&jaw("right pad", 0.04))?].concat(),
    )?;
    let state = grasp.solve(planar::Wrench::force([0.0, -4.0]))?.equilibrium().cloned().ok_or("it holds")?;
    let svg = draw_grasp(&grasp, &state, None, "Pads")?;
    check(&svg, "pads")?;
    let names: Vec<_> =
        shapes(&svg)?.into_iter().map(|shape| shape.words).filter(|words| words.contains("pad")).collect();
    assert_eq!(names, ["left pad", "right pad"]);
    Ok(())
}

#[test]
fn a_long_title_and_long_sentences_are_all_written() -> Result<(), Failure> {
    let grasp = planar_ring(3, "support")?;
    let (title, says) = (LONG.repeat(3), format!("{} {}", LONG.repeat(4), "x".repeat(300)));
    let svg = PlanarPicture::new(&grasp, &title).says(&says).to_svg()?;
    check(&svg, "long words")?;
    let written: String =
        shapes(&svg)?.into_iter().map(|shape| shape.words).filter(|words| words.len() > 40).collect();
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).count();
    assert!(letters(&written) >= letters(&title) + letters(&says) - 80);
    Ok(())
}
